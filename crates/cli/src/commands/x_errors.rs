//! `boundfit fit` with errors in x.

use boundfit_estimation::fit;
use boundfit_questions::XErrorFit;
use boundfit_report::{x_error_csv, x_error_document, x_error_json, x_error_proof, x_error_wkt};

use super::proof_file;
use crate::CommandResult;
use crate::arguments::{FitArguments, ReportFormat};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::memory;
use crate::output::Guard;
use crate::progress::while_working;

/// Reads the data, finds the lines that agree with all readings, and writes the report.
pub(crate) fn run(arguments: &FitArguments, format: ReportFormat, guard: &mut Guard) -> CommandResult {
    check_usage(arguments, format)?;
    let data = arguments.data.open().holding(memory::OF_AN_X_ERROR);
    let origin = data.origin();
    let problem = data.x_error_problem(&arguments.x_errors, false)?;
    if !format.has_input() {
        input::say_table(arguments.data.file_name(), problem.problem().measurements.table());
    }
    let (plain, answer): (_, XErrorFit) =
        while_working("fitting", || (fit(problem.problem()), problem.fit()));
    let style = arguments.data.table.limits.limited(arguments.output.style());
    let document = || x_error_document(&problem, &answer, &plain, &origin, &style);
    let report = match format {
        ReportFormat::Json => x_error_json(&problem, &answer, &plain, &origin, &style),
        ReportFormat::Latex => document().to_latex(),
        ReportFormat::Markdown => document().to_markdown(),
        ReportFormat::Csv => x_error_csv(&answer, &plain),
        ReportFormat::Wkt => x_error_wkt(&answer, &style).map_err(Failure::data)?,
        _ => document().to_text(),
    };
    let proof = match &arguments.proof {
        Some(file) => {
            let text = x_error_proof(&problem, &answer, origin.reading)
                .ok_or_else(|| proof_file::no_text(arguments.data.file_name()))?;
            Some((text, file.as_str()))
        }
        None => None,
    };
    proof_file::write(report.as_bytes(), arguments.output.file.output.as_deref(), proof, guard)?;
    Ok(if answer.is_empty() { Exit::Empty } else { Exit::Answer })
}

/// Refuses what is not there with errors in x.
fn check_usage(arguments: &FitArguments, format: ReportFormat) -> Result<(), Failure> {
    let options = [
        (arguments.by.is_some(), "'--by' fits many sets"),
        (arguments.sweep.is_some(), "'--sweep' moves the bounds of y alone"),
        (arguments.window.is_some() || arguments.window_x.is_some(), "'--window' fits many sets"),
        (arguments.confidence.is_some(), "'--confidence' is about the band of a single set"),
        (arguments.brief, "'--brief' is about a single set"),
        (arguments.inverse, "'--inverse' is about a single set"),
        (
            arguments.vertices,
            "'--vertices' is about a single set, and '--format json' has the vertices of all",
        ),
        (
            matches!(format, ReportFormat::M | ReportFormat::Ine | ReportFormat::Ext),
            "'--format m', 'ine' and 'ext' are about a single set, and '--format json' has the vertices of all",
        ),
    ];
    match options.into_iter().find(|(is_asked, _)| *is_asked) {
        Some((_, why)) => Err(Failure::Usage(format!(
            "{why}: with errors in x ('--x-eps') there may be two, one for each sign of theta1"
        ))),
        None => Ok(()),
    }
}
