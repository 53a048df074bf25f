//! `boundfit fit --by`: every group of rows on its own.

use boundfit_ask::{Ask, Fleet};

use super::FitArguments;
use crate::exit::{CommandResult, Failure};
use crate::options::ReportFormat;
use crate::output::Guard;

/// Reads the data, then fits group after group and writes what is ready.
pub(super) fn run(
    arguments: &FitArguments,
    by: &str,
    format: ReportFormat,
    guard: &mut Guard,
) -> CommandResult {
    let form = format.into();
    if !Fleet::FORMS.contains(&form) {
        return Err(Failure::Usage("'--by' writes text, json or csv".to_owned()));
    }
    arguments.job(form).run(&Fleet { by: by.to_owned() }, guard)
}
