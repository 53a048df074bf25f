//! The arguments of `boundfit polygon`.

use boundfit_exact::Limit;
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::look::PictureArguments;
use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::{OutputArguments, ReportFormat, TableArguments, limits};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        ("Half-planes in an H-representation of cdd or lrs", "boundfit polygon square.ine"),
        (
            "To a V-representation, whose rows are points and rays; the report on it; and back",
            "boundfit polygon square.ine --format ext -o corners.ext\n\
             boundfit polygon corners.ext\n\
             boundfit polygon corners.ext --format ine",
        ),
        (
            "A table with columns a1,a2,b, each row meaning a1*theta1 + a2*theta2 <= b",
            "printf 'a1,a2,b\\n-1,0,0\\n0,-1,0\\n2,3,6\\n' | boundfit polygon -",
        ),
    ],
    statuses: &[
        (0, "an answer was found"),
        BAD_DATA,
        BAD_USAGE,
        (3, "the region is empty; the proof is printed"),
    ],
};

/// Intersect half-planes: vertices, rays, bounds, area, and redundant half-planes
///
/// A V-representation of cdd or lrs also gives a set: rows '1 x y' are points, '0 x y' rays, or lines if a linearity
/// line lists them. The report then lists its half-planes (facets); the rows active at a vertex are the points equal to
/// it, and redundant rows are unnecessary generators. 'W x y' with W > 0 is the point (x/W, y/W). Rays without a point
/// start at the origin, and a set without any row is empty, as in cdd. Options for other output (maximize, verbose,
/// ...) are ignored; options for another set (nonnegative, project, hull in an H-representation, ...) are refused.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("limit", limits::with(&[Limit::Fraction])))]
pub(crate) struct PolygonArguments {
    /// FILE.ine or FILE.ext (H- or V-representation of cdd and lrs) or FILE.csv (columns a1,a2,b), or - for standard input
    pub(crate) file: String,
    /// Also draw the set: FILE.svg, .png, .pdf, .tikz or .tex
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) plot: Option<String>,
    /// Also write a theorem that the kernel of Coq checks to this file, which ends in .v: the half-planes describe just the
    /// convex hull of the vertices, together with rays
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    pub(crate) proof_library: bool,
    #[command(flatten)]
    pub(crate) picture: PictureArguments,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments<ReportFormat>,
}
