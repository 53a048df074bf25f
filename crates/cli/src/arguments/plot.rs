//! The arguments of `boundfit plot`.

use boundfit_ask::Factors;
use boundfit_figures::{Figure, PictureFormat};
use clap::builder::{NonEmptyStringValueParser, PossibleValue};
use clap::{ArgAction, Args, value_parser};

use super::look::LookArguments;
use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::values::{column_text, explained, named};
use super::{DataArguments, LabelArguments, ReplaceArguments, XErrorArguments};
use crate::exit::Failure;

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "The feasible parameter set of a line, as SVG and as PNG",
            "boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --figure fps -o fps.svg\n\
             boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --figure fps -o fps.png",
        ),
        (
            "All figures into a folder, with units on the axes",
            "boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --x-unit V --y-unit m \\\n\
             \x20 --figure all --format png -o figures",
        ),
        (
            "For a column of a paper: a PDF of its width, with letters of its size and without a title",
            "boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 \\\n\
             \x20 --size 85mm --font-size 8pt --title '' -o fps.pdf",
        ),
        (
            "Two sensors in one picture, and one sensor under three error bounds",
            "boundfit plot north.csv south.csv --x t --y U --eps 0.5 -o both.svg\n\
             boundfit plot north.csv --x t --y U --eps 0.5 --eps 1 --eps 2 -o nested.svg",
        ),
        (
            "A panel for each sensor",
            "boundfit plot fleet.csv --x V --y level --eps 0.1 --by sensor --figure data -o cells.svg",
        ),
        (
            "Into a LaTeX document, in its own letters",
            "boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 -o fps.tikz",
        ),
        (
            "Errors in x as well: readings as boxes, with the steepest and the shallowest line",
            "boundfit plot current.csv --x U --y I --eps 2 --x-eps 0.2 --figure data -o boxes.svg",
        ),
    ],
    statuses: &[
        (0, "the figure is drawn"),
        BAD_DATA,
        BAD_USAGE,
        (
            3,
            "the feasible parameter set is empty, of several that of at least one; the figure shows the readings that contradict each other",
        ),
    ],
};

/// Draw the readings, the intervals and the feasible parameter set as SVG, PNG, PDF or TikZ
///
/// Figures of the data plane: data (readings with error bars and the least-squares line), eui and pui (the band of
/// lines with parameters at the corners of the EUI or PUI box), corridor (the band of all feasible lines, inside that
/// of the PUI box). Figures of the parameter plane: fps (the feasible parameter set with its boxes and estimates),
/// directions (the hull of the optimal points of linear programs and the polygon of their supporting half-planes,
/// beside the set), outliers (the sets that remain without the fewest outliers). status shows each reading against the
/// set of the others, its residual across and its leverage up. next shows the distance of the feasible lines over x, and
/// where one more reading certainly makes the set smaller. With errors in x (--x-eps) only two figures exist: data
/// with boxes and the steepest and the shallowest line, and fps with one set for each sign of the slope.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
#[command(mut_arg("eps", |eps| eps.action(ArgAction::Append)))]
pub(crate) struct PlotArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// Further tables, drawn in the same panel as sets (figure fps) or as readings and lines (figure data). One table
    /// with several --eps is drawn likewise; six fits at most
    #[arg(value_name = "DATA")]
    more: Vec<String>,
    /// Draw, as the figure fps or data, one panel per group of rows with the same text in this column, all with the
    /// same axes; at most 24 groups, in order of first occurrence
    #[arg(long, value_name = "COL", value_parser = column_text, conflicts_with_all = ["sweep", "x_eps", "x_eps_column"])]
    pub(crate) by: Option<String>,
    #[command(flatten)]
    pub(crate) x_errors: XErrorArguments,
    /// The figure to draw
    #[arg(long, default_value = Figure::Fps.name(), value_parser = explained(Figures::named()))]
    pub(crate) figure: Figures,
    /// Draw, as the figure fps or corridor, the sets or corridors of some factors of all error bounds from FROM to TO,
    /// one inside another
    #[arg(long, value_name = "FROM..TO", conflicts_with_all = ["x_eps", "x_eps_column"])]
    pub(super) sweep: Option<String>,
    #[command(flatten)]
    pub(crate) labels: LabelArguments,
    /// Draw the response y along the horizontal axis and x along the vertical one
    #[arg(long)]
    pub(crate) flip: bool,
    /// Number of directions of the figure 'directions' [default: 16]
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(3..=1000))]
    pub(crate) directions: Option<u16>,
    /// Spread the directions of the figure 'directions' evenly after scaling the box of both intervals to a square, and
    /// not in the plane of theta1 and theta2
    #[arg(long)]
    pub(crate) scaled: bool,
    /// SVG, PNG, PDF, tikz (source for \\input in LaTeX) or tex (a document of its own with that picture). Default: the
    /// ending of the output file's name, else SVG
    #[arg(long, value_parser = named(PictureFormat::ALL.map(|format| (format.name(), format))))]
    pub(crate) format: Option<PictureFormat>,
    #[command(flatten)]
    pub(crate) look: LookArguments,
    /// Write to this .svg, .png, .pdf, .tikz or .tex file, or all figures into this folder, instead of standard output;
    /// each file whole or not at all
    #[arg(short, long, value_name = "FILE|DIR", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) output: Option<String>,
    #[command(flatten)]
    pub(crate) replace: ReplaceArguments,
}

impl PlotArguments {
    /// All tables.
    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        [self.data.path()].into_iter().chain(self.more.iter().map(String::as_str))
    }

    /// The factors of `--sweep`, if they are asked for.
    pub(crate) fn factors(&self) -> Result<Option<Factors>, Failure> {
        let limits = self.data.table.limits.number();
        let factors = self.sweep.as_deref().map(|text| Factors::parse(text, &limits));
        factors.transpose().map_err(Failure::misused)
    }
}

/// The value of `--figure` that asks for each figure of a fit.
const ALL: &str = "all";

/// The figures that are drawn.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Figures {
    One(Figure),
    All,
}

impl Figures {
    fn named() -> impl Iterator<Item = (PossibleValue, Figures)> {
        let one =
            |figure: Figure| (PossibleValue::new(figure.name()).help(figure.title()), Figures::One(figure));
        let all = (
            PossibleValue::new(ALL).help("Each of the figures of a fit, without status, range and next"),
            Figures::All,
        );
        Figure::ALL.into_iter().map(one).chain([all])
    }
}
