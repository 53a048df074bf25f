//! `boundfit linearity`.

use boundfit_ask::{Calibrated, Given, Linearity as Question, Readings, Regressors, Through};
use boundfit_figures::{PictureFormat, PlotOptions, draw_linearity};
use boundfit_questions::Linearity;
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::asked::Job;
use super::pictures;
use crate::exit::{CommandResult, Failure};
use crate::options::{
    BAD_DATA, BAD_USAGE, LabelArguments, LookArguments, Notes, OutputArguments, RowArguments, TableArguments,
    TableFormat, Words, column_text, refuse_without_picture,
};
use crate::output;
use crate::progress::while_working;

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
        ("Readings without a known direction", "boundfit linearity transducer.csv --x Vz --y z"),
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
    data: String,
    /// Column of the applied x, by header name or number from 1
    #[arg(long, value_name = "COL", required = true)]
    x: String,
    /// Column of the sensor's output. Without --direction each reading is used as it is and none are averaged
    #[arg(long, value_name = "COL", required_unless_present = "up")]
    y: Option<String>,
    /// Column of the sensor's output for rising x; a cell may be empty if only the other direction was read
    #[arg(long, value_name = "COL", value_parser = column_text)]
    up: Option<String>,
    /// Column of the sensor's output for falling x
    #[arg(long, value_name = "COL", value_parser = column_text)]
    down: Option<String>,
    /// Column with the direction: rising (up, upscale, rising, increasing, +, 1) or falling (down, downscale, falling,
    /// decreasing, -, -1, 0) x. The first of two other words means up
    #[arg(long, value_name = "COL", value_parser = column_text)]
    direction: Option<String>,
    /// Full scale for percents. Default: the span of y (of the average)
    #[arg(long, value_name = "NUM", allow_hyphen_values = true)]
    full_scale: Option<String>,
    /// The point of zero-based linearity. Default: 0,0
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    through: Option<String>,
    #[command(flatten)]
    rows: RowArguments,
    #[command(flatten)]
    table: TableArguments,
    /// Write a proof of the independent linearity to this file, for readings of which each row is a point; 'boundfit
    /// verify' checks it
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    proof: Option<String>,
    /// Draw the deviations in percent of full scale, as data sheets do, to this file (.svg, .png, .pdf, .tikz or .tex)
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    figure: Option<String>,
    #[command(flatten)]
    labels: LabelArguments,
    #[command(flatten)]
    look: LookArguments,
    #[command(flatten)]
    output: OutputArguments<TableFormat>,
}

impl LinearityArguments {
    /// The readings.
    fn words(&self) -> Words<'_> {
        let readings = Readings {
            x: Some(Regressors::One(self.x.clone())),
            y: self.y.clone(),
            rows: self.rows.words(),
            table: self.table.words(),
            ..Readings::default()
        };
        Words { path: &self.data, readings, limits: &self.table.limits }
    }

    /// The question.
    fn question(&self) -> Question {
        Question {
            up: self.up.clone(),
            down: self.down.clone(),
            direction: self.direction.clone(),
            full_scale: self.full_scale.clone().map(Given::Read),
            through: self.through.clone().map(Through::Text),
            keeps_every: self.figure.is_some(),
        }
    }
}

/// Reads the calibration and writes its linearity, and its picture if one is asked for.
pub(super) fn run(arguments: &LinearityArguments) -> CommandResult {
    check_proof(arguments)?;
    let job = Job::of(arguments.words(), &arguments.output, arguments.proof.as_deref())?;
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    let figure = figure(arguments)?;
    check_look(arguments, figure.map(|(_, format)| format))?;
    guard.check(figure.map(|(file, _)| file))?;
    job.run_with(&arguments.question(), &mut guard, |problem, linearity, _| {
        let picture = |(file, format)| Ok((picture(arguments, problem, linearity, format)?, file));
        figure.map(picture).transpose()
    })
}

/// The picture, encoded.
fn picture(
    arguments: &LinearityArguments,
    problem: &Calibrated,
    linearity: &Linearity,
    format: PictureFormat,
) -> Result<Vec<u8>, Failure> {
    let input = problem.input();
    let options = PlotOptions {
        x_unit: arguments.labels.x_unit.clone().or_else(|| input.units[0].clone()),
        y_unit: arguments.labels.y_unit.clone().or_else(|| input.units[1].clone()),
        ..arguments.look.options(arguments.labels.title.clone())
    };
    let picture = while_working("drawing", || draw_linearity(linearity, &input.x, &options));
    picture.map_err(Failure::data)?.encoded_as(format, &arguments.look.encoding()).map_err(Failure::data)
}

/// Refuses a proof that cannot be about rows, or has no file of its own.
fn check_proof(arguments: &LinearityArguments) -> Result<(), Failure> {
    let Some(proof) = arguments.proof.as_deref() else { return Ok(()) };
    let refuse = |problem: &str| Err(Failure::Usage(problem.to_owned()));
    if arguments.direction.is_some() {
        return refuse(
            "'--proof' is about rows of which each is a point, and with '--direction' several are averaged",
        );
    }
    let others =
        [arguments.output.file.output.as_deref().unwrap_or("-"), arguments.figure.as_deref().unwrap_or("-")];
    match others.iter().any(|other| *other == proof || (*other != "-" && output::is_one_file(other, proof))) {
        true => refuse("'--proof' needs a file of its own"),
        false => Ok(()),
    }
}

/// Refuses options about a picture that is not drawn, or that its format does not have.
fn check_look(arguments: &LinearityArguments, format: Option<PictureFormat>) -> Result<(), Failure> {
    let labels = &arguments.labels;
    let given = [("--title", &labels.title), ("--x-unit", &labels.x_unit), ("--y-unit", &labels.y_unit)];
    let asked = given.into_iter().find(|(_, text)| text.is_some()).map(|(option, _)| option);
    refuse_without_picture(asked, "--figure", format.is_some())?;
    arguments.look.check("--figure", format.is_some())?;
    format.map_or(Ok(()), |format| arguments.look.check_format(format))
}

/// Returns the file and the encoding of the picture, if one is asked for.
fn figure(arguments: &LinearityArguments) -> Result<Option<(&str, PictureFormat)>, Failure> {
    let Some(file) = arguments.figure.as_deref() else { return Ok(None) };
    let refuse = |problem: &str| Err(Failure::value("--figure <FILE>", file, problem));
    let Some(format) = pictures::told_by_name(file) else {
        return refuse(&format!("{})", PictureFormat::EXPECTED));
    };
    match arguments.output.file.output.as_deref() {
        Some(output) if output != "-" && output::is_one_file(output, file) => {
            refuse("'--output' names the same file")
        }
        _ => Ok(Some((file, format))),
    }
}
