//! The arguments of `boundfit linearity`.

use boundfit_ask::{Given, Linearity, Through};
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::look::LookArguments;
use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::values::column_text;
use super::{LabelArguments, OutputArguments, RowArguments, TableArguments, TableFormat};

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

/// State how far a sensor is from a straight line, as laws and data sheets do: independent, terminal, zero-based and
/// least-squares linearity
///
/// Independent linearity is the largest deviation of the characteristic (the average of upscale and downscale readings)
/// from the best straight line; three readings prove it. Terminal linearity uses the line through both ends of the
/// range, zero-based linearity the best line through a given point, and least-squares linearity the least-squares line.
/// Each value is given in units of y and in percent of full scale, for the average, for upscale and for downscale
/// readings. Hysteresis is the largest difference between both directions at one x, repeatability the largest spread of
/// readings at one x in one direction.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct LinearityArguments {
    /// A table of readings, or - for standard input
    pub(crate) data: String,
    /// Column of the applied x, by header name or number from 1
    #[arg(long, value_name = "COL", required = true)]
    pub(super) x: String,
    /// Column of the sensor's output. Without --direction each reading is used as it is and none are averaged
    #[arg(long, value_name = "COL", required_unless_present = "up", conflicts_with_all = ["up", "down"])]
    pub(super) y: Option<String>,
    /// Column of the sensor's output for rising x; a cell may be empty if only the other direction was read
    #[arg(long, value_name = "COL", value_parser = column_text, requires = "down")]
    pub(crate) up: Option<String>,
    /// Column of the sensor's output for falling x
    #[arg(long, value_name = "COL", value_parser = column_text, requires = "up")]
    pub(crate) down: Option<String>,
    /// Column with the direction: rising (up, upscale, rising, increasing, +, 1) or falling (down, downscale, falling,
    /// decreasing, -, -1, 0) x. The first of two other words means up
    #[arg(long, value_name = "COL", value_parser = column_text, requires = "y", conflicts_with_all = ["up", "down"])]
    pub(crate) direction: Option<String>,
    /// Full scale for percents. Default: the span of y (of the average)
    #[arg(long, value_name = "NUM", allow_hyphen_values = true)]
    pub(crate) full_scale: Option<String>,
    /// The point of zero-based linearity. Default: 0,0
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pub(crate) through: Option<String>,
    #[command(flatten)]
    pub(crate) rows: RowArguments,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    /// Write a proof of the independent linearity to this file, for readings of which each row is a point; 'boundfit
    /// verify' checks it
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    /// Draw the deviations in percent of full scale, as data sheets do, to this file (.svg, .png, .pdf, .tikz or .tex)
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
    /// The question.
    pub(crate) fn question(&self) -> Linearity {
        Linearity {
            up: self.up.clone(),
            down: self.down.clone(),
            direction: self.direction.clone(),
            full_scale: self.full_scale.clone().map(Given::Read),
            through: self.through.clone().map(Through::Text),
            keeps_every: self.figure.is_some(),
        }
    }
}
