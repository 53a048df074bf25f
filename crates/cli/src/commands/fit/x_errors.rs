//! `boundfit fit` with errors in x.

use boundfit_ask::{Ask, FitXErrors, Form};

use super::FitArguments;
use crate::exit::{CommandResult, Failure};
use crate::options::ReportFormat;
use crate::output::Guard;

/// Reads the data, finds the lines that agree with all readings, and writes the report.
pub(super) fn run(arguments: &FitArguments, format: ReportFormat, guard: &mut Guard) -> CommandResult {
    let form = check_usage(arguments, format)?;
    arguments.job(form).run(&FitXErrors {}, guard)
}

/// The form of the answer; refuses what is not there with errors in x.
fn check_usage(arguments: &FitArguments, format: ReportFormat) -> Result<Form, Failure> {
    let options = [
        (arguments.by.is_some(), "'--by' fits many sets"),
        (arguments.sweep.is_some(), "'--sweep' moves the bounds of y alone"),
        (arguments.window().is_some(), "'--window' fits many sets"),
        (arguments.confidence.is_some(), "'--confidence' is about the band of a single set"),
        (arguments.brief, "'--brief' is about a single set"),
        (arguments.full, "'--full' is about a single set"),
        (arguments.inverse, "'--inverse' is about a single set"),
        (
            arguments.vertices,
            "'--vertices' is about a single set, and '--format json' has the vertices of all",
        ),
    ];
    let asked = options.into_iter().find(|(is_asked, _)| *is_asked).map(|(_, why)| why);
    let no_form =
        "'--format m', 'ine' and 'ext' are about a single set, and '--format json' has the vertices of all";
    let form = format.into();
    match (asked, FitXErrors::FORMS.contains(&form)) {
        (None, true) => Ok(form),
        (why, _) => Err(Failure::Usage(format!(
            "{}: with errors in x ('--x-eps') there may be two, one for each sign of theta1",
            why.unwrap_or(no_form)
        ))),
    }
}
