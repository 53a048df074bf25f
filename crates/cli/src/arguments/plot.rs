//! The arguments of `boundfit plot`.

use clap::builder::NonEmptyStringValueParser;
use clap::{Args, ValueEnum, value_parser};

use super::{DataArguments, LabelArguments};

const EXAMPLES: &str = "\
Examples:
  The feasible parameter set of a line, as SVG and as PNG:
    boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --figure fps -o fps.svg
    boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --figure fps -o fps.png
  All figures into a folder, with units on the axes:
    boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --x-unit V --y-unit m \\
      --figure all --format png -o figures

Exit status:
  0  the figure is drawn
  1  bad data, or a file that cannot be read or written
  2  bad usage
  3  the feasible parameter set is empty; the figure shows the readings that contradict each other";

/// Draw the readings, the intervals and the feasible parameter set as SVG or PNG
///
/// Figures of the data plane: data (readings with error bars and the least-squares line), eui and pui (the band of
/// lines with parameters at the corners of the EUI or PUI box), corridor (the band that all feasible lines really
/// cover, inside the one of the PUI box). Figures of the parameter plane: fps (the feasible parameter set with its
/// boxes and estimates), directions (the hull of the optimisers of linear programs and the polygon of their supporting
/// half-planes, beside the set).
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct PlotArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// What to draw
    #[arg(long, value_enum, default_value_t = FigureName::Fps)]
    pub(crate) figure: FigureName,
    #[command(flatten)]
    pub(crate) labels: LabelArguments,
    /// Draw the response y along the horizontal axis and x along the vertical one
    #[arg(long)]
    pub(crate) flip: bool,
    /// How many directions the figure 'directions' has
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = value_parser!(u16).range(3..=1000))]
    pub(crate) directions: u16,
    /// SVG or PNG; told by the name of the output file when left out, else SVG
    #[arg(long, value_enum)]
    pub(crate) format: Option<PictureFormat>,
    /// Write to this .svg or .png file, or for all figures into this folder, instead of standard output; each file
    /// whole or not at all
    #[arg(short, long, value_name = "FILE|DIR", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) output: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FigureName {
    /// Readings with error bars and the least-squares line
    Data,
    /// Band of the lines at the corners of the EUI box
    Eui,
    /// Band of the lines at the corners of the PUI box
    Pui,
    /// The feasible parameter set
    Fps,
    /// Band of all feasible lines, inside that of the PUI box
    Corridor,
    /// Inner and outer approximation from linear programs
    Directions,
    /// Each of them
    All,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PictureFormat {
    Svg,
    Png,
}
