//! The arguments of `boundfit linearity`.

use boundfit_exact::{Rational, Reading};
use boundfit_formats::ColumnSelector;
use boundfit_questions::{CalibrationColumns, CalibrationResponse};
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::look::LookArguments;
use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::values::{number_problem, parse_column};
use super::{LabelArguments, OutputArguments, RowArguments, TableArguments, TableFormat};
use crate::exit::Failure;

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "A sensor read upscale and downscale, in two columns, with its picture",
            "boundfit linearity lvdt.csv --x x_mm --up up_mV --down down_mV --figure lvdt.svg",
        ),
        (
            "Readings below each other, with a column that says up or down; percent of a stated full scale",
            "boundfit linearity cycles.csv --x mm --y mV --direction dir --full-scale 4",
        ),
        ("Readings of which no direction is known", "boundfit linearity transducer.csv --x Vz --y z"),
    ],
    statuses: &[(0, "an answer was found"), BAD_DATA, BAD_USAGE],
};

/// How far a sensor is from a straight line, as laws and data sheets state it: independent, terminal, zero-based and
/// least-squares linearity
///
/// Independent linearity is the largest deviation of the actual characteristic, the average of upscale and downscale
/// readings, from the straight line that makes it as small as can be; three readings prove it. Terminal linearity is
/// measured from the line through both ends of the range, zero-based linearity from the best line through a given point,
/// least-squares linearity from the least-squares line. Each is given in units of y and in percent of full scale, for the
/// average, and for upscale and downscale readings alone; with hysteresis, the largest difference of both at one x, and
/// repeatability, the largest spread of readings at one x in one direction.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct LinearityArguments {
    /// A table of readings, or - for standard input
    pub(crate) data: String,
    /// Column of what was applied, by header name or number from 1
    #[arg(long, value_name = "COL", value_parser = parse_column, required = true)]
    pub(crate) x: ColumnSelector,
    /// Column of what the sensor gave. Without --direction every reading is taken as it is, none averaged
    #[arg(long, value_name = "COL", value_parser = parse_column, required_unless_present = "up",
          conflicts_with_all = ["up", "down"])]
    pub(crate) y: Option<ColumnSelector>,
    /// Column of what the sensor gave while x was rising; the cell may be empty where only the other one was read
    #[arg(long, value_name = "COL", value_parser = parse_column, requires = "down")]
    pub(crate) up: Option<ColumnSelector>,
    /// Column of what the sensor gave while x was falling
    #[arg(long, value_name = "COL", value_parser = parse_column, requires = "up")]
    pub(crate) down: Option<ColumnSelector>,
    /// Column that says whether x was rising (up, upscale, rising, increasing, +, 1) or falling (down, downscale, falling,
    /// decreasing, -, -1, 0); of two other words the first is up
    #[arg(long, value_name = "COL", value_parser = parse_column, requires = "y", conflicts_with_all = ["up", "down"])]
    pub(crate) direction: Option<ColumnSelector>,
    /// What percents are of; the span of y (of the average) when left out
    #[arg(long, value_name = "NUM", allow_hyphen_values = true)]
    pub(crate) full_scale: Option<String>,
    /// The point that the line of zero-based linearity goes through; 0,0 when left out
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pub(crate) through: Option<String>,
    #[command(flatten)]
    pub(crate) rows: RowArguments,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    /// Write the proof of the independent linearity to this file, of readings of which each row is a point; 'boundfit verify'
    /// checks it
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    /// Draw the deviations in percent of full scale into this file, whose name ends in .svg, .png, .pdf, .tikz or .tex, as data sheets do
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) figure: Option<String>,
    #[command(flatten)]
    pub(crate) labels: LabelArguments,
    #[command(flatten)]
    pub(crate) look: LookArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments<TableFormat>,
}

impl LinearityArguments {
    /// The columns of the calibration.
    pub(crate) fn columns(&self) -> CalibrationColumns {
        let response = match (&self.y, &self.up, &self.down, &self.direction) {
            (None, Some(up), Some(down), _) => {
                CalibrationResponse::Two { up: up.clone(), down: down.clone() }
            }
            // The command line asks for one or the other.
            (y, _, _, None) => CalibrationResponse::One(y.clone().unwrap_or_else(|| self.x.clone())),
            (y, _, _, Some(direction)) => CalibrationResponse::Directed {
                y: y.clone().unwrap_or_else(|| self.x.clone()),
                direction: direction.clone(),
            },
        };
        CalibrationColumns { x: self.x.clone(), response }
    }

    /// What percents are of, if it is given.
    pub(crate) fn full_scale(&self) -> Result<Option<Rational>, Failure> {
        const EXPECTED: &str = "expected a number above 0, such as 4 or 153/40";
        let number = |text: &String| {
            let refuse = |problem: String| Failure::value("--full-scale <NUM>", text, problem);
            let number = self.number(text).map_err(|error| refuse(number_problem(&error, EXPECTED)))?;
            if number.is_positive() { Ok(number) } else { Err(refuse(EXPECTED.to_owned())) }
        };
        self.full_scale.as_ref().map(number).transpose()
    }

    /// The point of zero-based linearity.
    pub(crate) fn through(&self) -> Result<[Rational; 2], Failure> {
        const EXPECTED: &str = "expected two numbers X,Y such as 0,0 or 2.5,-1/3";
        let Some(text) = &self.through else { return Ok(<[Rational; 2]>::default()) };
        let refuse = |problem: String| Failure::value("--through <X,Y>", text, problem);
        let (x, y) = text.split_once(',').ok_or_else(|| refuse(EXPECTED.to_owned()))?;
        let number =
            |text: &str| self.number(text.trim()).map_err(|error| refuse(number_problem(&error, EXPECTED)));
        Ok([number(x)?, number(y)?])
    }

    /// A number of an option, exactly as it is written.
    fn number(&self, text: &str) -> Result<Rational, boundfit_exact::ParseNumberError> {
        Reading::Decimal.read(text, &self.table.limits.number())
    }
}
