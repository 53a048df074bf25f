//! `boundfit linearity`.

use boundfit_ask::Calibrated;
use boundfit_figures::{PictureFormat, PlotOptions, draw_linearity};
use boundfit_questions::Linearity;

use super::asked::Job;
use super::pictures;
use crate::CommandResult;
use crate::arguments::{LinearityArguments, refuse_without_picture};
use crate::exit::Failure;
use crate::output;
use crate::progress::while_working;

/// Reads the calibration and writes its linearity, and its picture if one is asked for.
pub(crate) fn run(arguments: &LinearityArguments) -> CommandResult {
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
