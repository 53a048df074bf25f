//! `boundfit polygon`.

use boundfit_ask::{Ask, Form, Polygon, Readings, Refusal};
use boundfit_exact::{Foreign, Limit};
use boundfit_figures::{PictureFormat, draw_region};
use boundfit_geometry::Polyhedron;
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::asked::Job;
use super::set_files::SetFiles;
use crate::exit::{CommandResult, Failure};
use crate::options::{
    BAD_DATA, BAD_USAGE, Notes, OutputArguments, PictureArguments, ReportFormat, TableArguments, Words,
    limits,
};

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
    file: String,
    /// Also draw the set, or the half-planes that contradict each other: FILE.svg, .png, .pdf, .tikz or .tex
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    plot: Option<String>,
    /// Also write a theorem that the kernel of Coq checks to this file, which ends in .v: the half-planes describe just the
    /// convex hull of the vertices, together with rays
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    proof_library: bool,
    #[command(flatten)]
    picture: PictureArguments,
    #[command(flatten)]
    table: TableArguments,
    #[command(flatten)]
    output: OutputArguments<ReportFormat>,
}

/// Reads the half-planes, or finds those of generators, intersects them and writes the report.
pub(super) fn run(arguments: &PolygonArguments) -> CommandResult {
    let PolygonArguments { file, table, output: own, picture: look, .. } = arguments;
    let (output, proof) = (own.file.output.as_deref(), arguments.proof.as_deref());
    let plot = arguments.plot.as_deref();
    let files = SetFiles { plot, proof, proof_library: arguments.proof_library, picture: look };
    let (encoding, theory) = files.checked(output, "a set of half-planes")?;
    let form = Form::from(own.format()?);
    let mut guard = own.file.replace.guard([file.as_str()]);
    guard.check(output)?;
    files.check(&guard)?;
    let style = table.limits.limited(own.style());
    let vain = |misuse| Failure::misused(Refusal::Misuse(misuse));
    Polygon {}.refuse_vain_style(form, &style).map_err(vain)?;
    let readings = Readings { table: table.words(), ..Readings::default() };
    let data = Words { path: file, readings, limits: &table.limits };
    let name = data.file_name();
    let job = Job { data, form, style, output, proof, theory };
    job.run_with(&Polygon {}, &mut guard, |half_planes, polyhedron, _| {
        if theory.is_some() && half_planes.generators.is_some() {
            let instead = "write its half-planes with '--format ine', and prove that file";
            return Err(Failure::Usage(format!(
                "'--proof' is about half-planes, and {name} has generators: {instead}"
            )));
        }
        let encoded = |(format, file)| Ok((picture(polyhedron, name, (format, look))?, file));
        encoding.zip(plot).map(encoded).transpose()
    })
}

/// The set, encoded.
fn picture(
    polyhedron: &Polyhedron,
    file: Foreign<&str>,
    (format, asked): (PictureFormat, &PictureArguments),
) -> Result<Vec<u8>, Failure> {
    let names = ["θ₁".into(), "θ₂".into()];
    let title = Foreign::from(format!("Set of {}", file.raw()));
    let picture = draw_region(polyhedron, &names, &title, &asked.options()).map_err(Failure::data)?;
    picture.encoded_as(format, &asked.encoding()).map_err(Failure::data)
}
