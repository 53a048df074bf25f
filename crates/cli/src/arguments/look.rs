//! How a figure looks: its size, axes and colours.

use boundfit_exact::{Foreign, Limits, Rational, Reading};
use clap::{Args, value_parser};

use super::values::number_problem;

/// The heading of these options.
const LOOK: &str = "Look";

/// Options of a figure that a paper or a report has wishes about.
#[derive(Debug, Args)]
pub(crate) struct LookArguments {
    /// How wide the picture is, as 85mm, 8.5cm, 3.3in, 240pt or 600px; all that is on it grows or shrinks with it, but for
    /// letters of --font-size [default: 800px]
    #[arg(long, help_heading = LOOK, value_name = "WIDTH", value_parser = parse_size)]
    pub(crate) size: Option<u32>,
    /// How large letters are, as 8pt: panels get the room that these leave [default: 9pt, or in proportion to --size]
    #[arg(long, help_heading = LOOK, value_name = "SIZE", value_parser = parse_font_size)]
    pub(crate) font_size: Option<u32>,
    /// Dots per inch of a PNG
    #[arg(long, help_heading = LOOK, value_name = "N", default_value_t = 192, value_parser = value_parser!(u16).range(30..=1200))]
    pub(crate) dpi: u16,
    /// The ends of the axis of x, in figures of the parameter plane of theta1
    #[arg(long, help_heading = LOOK, value_name = "LOWER..UPPER", value_parser = parse_range, allow_hyphen_values = true)]
    pub(crate) x_range: Option<[Rational; 2]>,
    /// The ends of the axis of y, in figures of the parameter plane of theta2
    #[arg(long, help_heading = LOOK, value_name = "LOWER..UPPER", value_parser = parse_range, allow_hyphen_values = true)]
    pub(crate) y_range: Option<[Rational; 2]>,
    /// The name of the axis of x, or of theta1; it may be empty
    #[arg(long, help_heading = LOOK, value_name = "TEXT")]
    pub(crate) x_label: Option<Foreign>,
    /// The name of the axis of y, or of theta2; it may be empty
    #[arg(long, help_heading = LOOK, value_name = "TEXT")]
    pub(crate) y_label: Option<Foreign>,
    /// Draw in greys
    #[arg(long, help_heading = LOOK)]
    pub(crate) greyscale: bool,
    /// Keep the texts of an SVG as texts in the font Inter, to be edited and searched, instead of outlines
    #[arg(long, help_heading = LOOK)]
    pub(crate) real_text: bool,
}

/// Units of length in micrometres.
const UNITS: [(&str, f64); 5] =
    [("mm", 1e3), ("cm", 1e4), ("in", 25_400.0), ("pt", 25_400.0 / 72.0), ("px", 25_400.0 / 96.0)];
/// The narrowest and the widest picture in micrometres.
const WIDTHS: [f64; 2] = [1e4, 2e6];
/// The smallest and the largest letters in micrometres, 1 and 200 points.
const FONT_SIZES: [f64; 2] = [25_400.0 / 72.0, 200.0 * 25_400.0 / 72.0];

/// A width in micrometres.
fn parse_size(text: &str) -> Result<u32, String> {
    let expected = "expected a width from 10mm to 2000mm, as 85mm, 8.5cm, 3.3in, 240pt or 600px";
    parse_length(text, WIDTHS).ok_or_else(|| expected.to_owned())
}

/// The size of letters in micrometres.
fn parse_font_size(text: &str) -> Result<u32, String> {
    let expected = "expected a size from 1pt to 200pt, as 8pt or 3mm";
    parse_length(text, FONT_SIZES).ok_or_else(|| expected.to_owned())
}

/// A length in micrometres between these.
fn parse_length(text: &str, [least, most]: [f64; 2]) -> Option<u32> {
    let found = UNITS.iter().find_map(|(unit, micrometres)| Some((text.strip_suffix(unit)?, micrometres)));
    let (number, micrometres) = found?;
    let is_plain = number.starts_with(|c: char| c.is_ascii_digit())
        && number.chars().all(|c| c.is_ascii_digit() || c == '.');
    let length = number.parse::<f64>().ok().filter(|_| is_plain).map(|number| number * micrometres)?;
    (least..=most).contains(&length).then_some(length.round() as u32)
}

/// Two ends of an axis, the lower one first.
fn parse_range(text: &str) -> Result<[Rational; 2], String> {
    const EXPECTED: &str = "expected LOWER..UPPER, two numbers as in -1.5..2";
    let (lower, upper) = text.split_once("..").ok_or(EXPECTED)?;
    let number = |text: &str| {
        Reading::Decimal.read(text, &Limits::default()).map_err(|error| number_problem(&error, EXPECTED))
    };
    let ends = [number(lower)?, number(upper)?];
    if ends[0] >= ends[1] {
        return Err("the lower end is not below the upper one".to_owned());
    }
    Ok(ends)
}
