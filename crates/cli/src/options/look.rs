//! The look of a figure: its size, axes and colours.

use boundfit_ask::ValueProblem;
use boundfit_exact::{Foreign, Limits, Rational, Reading};
use boundfit_figures::{Encoding, PictureFormat, PlotOptions};
use clap::Args;

use crate::exit::Failure;

use super::values::whole;

/// The heading of these options.
const LOOK: &str = "Look";

/// Options of a figure that a paper or a report has wishes about.
#[derive(Debug, Args)]
pub(crate) struct LookArguments {
    /// Width of the picture, as 85mm, 8.5cm, 3.3in, 240pt or 600px. Everything scales with it, except letters of
    /// --font-size [default: 800px]
    #[arg(long, help_heading = LOOK, value_name = "WIDTH", value_parser = parse_size)]
    size: Option<u32>,
    /// Size of letters, as 8pt; panels use the remaining space [default: 9pt, or in proportion to --size]
    #[arg(long, help_heading = LOOK, value_name = "SIZE", value_parser = parse_font_size)]
    font_size: Option<u32>,
    /// Dots per inch of a PNG [default: 192]
    #[arg(long, help_heading = LOOK, value_name = "N", value_parser = whole::<u16>(30, 1200))]
    dpi: Option<u16>,
    /// Ends of the x axis; in figures of the parameter plane, of theta1
    #[arg(long, help_heading = LOOK, value_name = "LOWER..UPPER", value_parser = parse_range, allow_hyphen_values = true)]
    pub(crate) x_range: Option<[Rational; 2]>,
    /// Ends of the y axis; in figures of the parameter plane, of theta2
    #[arg(long, help_heading = LOOK, value_name = "LOWER..UPPER", value_parser = parse_range, allow_hyphen_values = true)]
    pub(crate) y_range: Option<[Rational; 2]>,
    /// Name of the x axis, or of theta1; may be empty
    #[arg(long, help_heading = LOOK, value_name = "TEXT")]
    x_label: Option<Foreign>,
    /// Name of the y axis, or of theta2; may be empty
    #[arg(long, help_heading = LOOK, value_name = "TEXT")]
    y_label: Option<Foreign>,
    /// Draw in greys
    #[arg(long, help_heading = LOOK)]
    greyscale: bool,
    /// Keep the texts of an SVG as editable text in the font Inter instead of outlines
    #[arg(long, help_heading = LOOK)]
    real_text: bool,
}

/// Options of a picture that a command draws beside its answer.
#[derive(Debug, Args)]
pub(crate) struct PictureArguments {
    /// Title of the picture. Default: a plain one
    #[arg(long, help_heading = LOOK, value_name = "TEXT")]
    title: Option<Foreign>,
    #[command(flatten)]
    look: LookArguments,
}

impl PictureArguments {
    /// Refuses options about a picture that is not drawn, or that has no room; `option` draws it.
    pub(crate) fn check(&self, option: &str, is_drawn: bool) -> Result<(), Failure> {
        refuse_without_picture(self.title.as_ref().map(|_| "--title"), option, is_drawn)?;
        self.look.check(option, is_drawn)
    }

    /// Refuses what a picture of this format does not have.
    pub(crate) fn check_format(&self, format: PictureFormat) -> Result<(), Failure> {
        self.look.check_format(format)
    }

    /// Returns the options for drawing.
    pub(crate) fn options(&self) -> PlotOptions {
        self.look.options(self.title.clone())
    }

    /// Returns the encoding of the drawing.
    pub(crate) fn encoding(&self) -> Encoding {
        self.look.encoding()
    }
}

impl LookArguments {
    /// Refuses options about a picture that is not drawn, or that has no room for its letters; `option` draws it.
    pub(crate) fn check(&self, option: &str, is_drawn: bool) -> Result<(), Failure> {
        refuse_without_picture(self.asked(), option, is_drawn)?;
        match self.options(None).have_letters_room() {
            true => Ok(()),
            // Words and numbers around panels need some room.
            false => Err(Failure::Usage(
                "with '--font-size' a picture has to be 27 to 266 times as wide as its letters are large: change it, or '--size'"
                    .to_owned(),
            )),
        }
    }

    /// Refuses what a picture of this format does not have.
    pub(crate) fn check_format(&self, format: PictureFormat) -> Result<(), Failure> {
        let is = |other: PictureFormat| format == other;
        let asked = [
            ("--dpi", "the pixels of a PNG", self.dpi.is_some() && !is(PictureFormat::Png)),
            ("--real-text", "the texts of an SVG", self.real_text && !is(PictureFormat::Svg)),
        ];
        match asked.iter().find(|(.., is_refused)| *is_refused) {
            Some((option, about, _)) => {
                let words = format.words();
                Err(Failure::Usage(format!("'{option}' is about {about}, and the picture is {words}")))
            }
            None => Ok(()),
        }
    }

    /// The first of these options that is given.
    fn asked(&self) -> Option<&'static str> {
        let given = [
            ("--size", self.size.is_some()),
            ("--font-size", self.font_size.is_some()),
            ("--dpi", self.dpi.is_some()),
            ("--x-range", self.x_range.is_some()),
            ("--y-range", self.y_range.is_some()),
            ("--x-label", self.x_label.is_some()),
            ("--y-label", self.y_label.is_some()),
            ("--greyscale", self.greyscale),
            ("--real-text", self.real_text),
        ];
        given.into_iter().find(|(_, is_given)| *is_given).map(|(option, _)| option)
    }

    /// Returns the options for drawing, under this title.
    pub(crate) fn options(&self, title: Option<Foreign>) -> PlotOptions {
        PlotOptions {
            title,
            x_label: self.x_label.clone(),
            y_label: self.y_label.clone(),
            x_range: self.x_range.clone(),
            y_range: self.y_range.clone(),
            width: self.size,
            letters: self.font_size,
            greyscale: self.greyscale,
            ..PlotOptions::default()
        }
    }

    /// Returns the encoding of the drawing.
    pub(crate) fn encoding(&self) -> Encoding {
        let plain = Encoding::default();
        Encoding { real_text: self.real_text, dpi: self.dpi.unwrap_or(plain.dpi) }
    }
}

/// Refuses an option about a picture that is not drawn; `option` draws it.
pub(crate) fn refuse_without_picture(
    asked: Option<&str>,
    option: &str,
    is_drawn: bool,
) -> Result<(), Failure> {
    match asked.filter(|_| !is_drawn) {
        Some(asked) => Err(Failure::Usage(format!(
            "'{asked}' is about the picture: say where it goes with '{option} <FILE>'"
        ))),
        None => Ok(()),
    }
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
    let (lower, upper) = boundfit_ask::ends(text).ok_or(EXPECTED)?;
    let number = |text: &str| {
        let number = Reading::Decimal.read(text, &Limits::default());
        number.map_err(|error| ValueProblem::Number { error, expected: EXPECTED }.words())
    };
    let ends = [number(lower)?, number(upper)?];
    if ends[0] >= ends[1] {
        return Err("the lower end is not below the upper one".to_owned());
    }
    Ok(ends)
}
