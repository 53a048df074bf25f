//! `boundfit linearity`.

mod proof;

use boundfit_exact::{Foreign, Reading, Work};
use boundfit_figures::{PictureFormat, PlotOptions, draw_linearity};
use boundfit_formats::Source;
use boundfit_questions::{Calibration, Linearity, LinearityOptions};
use boundfit_report::{Origin, linearity_csv, linearity_document, linearity_json};

use super::pictures;
use crate::CommandResult;
use crate::arguments::{LinearityArguments, TableFormat, refuse_without_picture};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::memory;
use crate::output;
use crate::progress::while_working;
use crate::work::{refuse_long, times};

/// Reads the calibration and writes its linearity, and its picture if one is asked for.
pub(crate) fn run(arguments: &LinearityArguments) -> CommandResult {
    let format = arguments.output.format()?;
    let output = arguments.output.file.output.as_deref();
    let mut guard = arguments.output.file.replace.guard([arguments.data.as_str()]);
    guard.check(output)?;
    let figure = figure(arguments)?;
    check_look(arguments, figure.map(|(_, format)| format))?;
    guard.check(figure.map(|(file, _)| file))?;
    proof::check_usage(arguments)?;
    guard.check(arguments.proof.as_deref())?;
    let options = LinearityOptions { full_scale: arguments.full_scale()?, through: arguments.through()? };
    let source = input::open(&arguments.data).map_err(Failure::refused);
    let is_stored = source.as_ref().is_ok_and(Source::is_stored);
    let reading = if is_stored { Reading::Binary64 } else { arguments.table.reading() };
    let origin =
        Origin { file: (arguments.data != "-").then_some(Foreign::of(&arguments.data)), reading, is_stored };
    let source = source?;
    let mut scan_options = arguments.table.scan_options(&source, Some(&arguments.rows))?;
    scan_options.table.row_cost = memory::OF_A_CALIBRATION;
    let calibration = Calibration::read(source, &arguments.columns(), &scan_options);
    let Calibration { readings, input } = calibration.map_err(Failure::refused)?;
    let mut work = Work::default();
    let given = [options.full_scale.as_ref(), Some(&options.through[0]), Some(&options.through[1])];
    for reading in &readings {
        work.add(reading.row, [&reading.x, &reading.y].into_iter().chain(given.into_iter().flatten()));
    }
    let name = Foreign::of(input::named(&arguments.data));
    refuse_long(name, &work, times::LINEARITY, &arguments.table.limits)?;
    let found = while_working("fitting", || Linearity::new(&readings, &options));
    let linearity = found.ok_or_else(|| Failure::data(format_args!("{name}: there are no readings")))?;
    if format == TableFormat::Csv {
        input::say_table(name, input.table.as_ref());
    }
    let style = arguments.output.style();
    let document = || linearity_document(&linearity, &options, &input, &origin, &style);
    let report = match format {
        TableFormat::Text => document().to_text(),
        TableFormat::Latex => document().to_latex(),
        TableFormat::Markdown => document().to_markdown(),
        TableFormat::Csv => linearity_csv(&linearity),
        TableFormat::Json => linearity_json(&linearity, &options, &input, &origin, &style),
    };
    let picture = match figure {
        Some((file, format)) => {
            let options = PlotOptions {
                x_unit: arguments.labels.x_unit.clone().or_else(|| input.units[0].clone()),
                y_unit: arguments.labels.y_unit.clone().or_else(|| input.units[1].clone()),
                ..arguments.look.options(arguments.labels.title.clone())
            };
            let picture = while_working("drawing", || draw_linearity(&linearity, &input.x, &options));
            let picture = picture.map_err(Failure::data)?;
            let bytes = picture.encoded_as(format, &arguments.look.encoding()).map_err(Failure::data)?;
            Some((bytes, file))
        }
        None => None,
    };
    let picture = picture.as_ref().map(|(bytes, file)| (bytes.as_slice(), Some(*file)));
    let proof = match &arguments.proof {
        Some(file) => Some((proof::written(arguments, &linearity, reading)?, file)),
        None => None,
    };
    let proof = proof.as_ref().map(|(text, file)| (text.as_bytes(), Some(file.as_str())));
    let parts: Vec<_> = proof.into_iter().chain(picture).chain([(report.as_bytes(), output)]).collect();
    output::write_together(&parts, &mut guard)?;
    Ok(Exit::Answer)
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

/// Where the picture goes and how it is encoded, if one is asked for.
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
