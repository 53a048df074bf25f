//! `boundfit fit --window`: the last readings, again and again as the window moves on.

use boundfit_ask::{Ask, Window};

use super::FitArguments;
use crate::exit::{CommandResult, Failure};
use crate::options::ReportFormat;
use crate::output::Guard;

/// Reads the data, then moves on and writes what is ready.
pub(super) fn run(
    arguments: &FitArguments,
    window: &Window,
    format: ReportFormat,
    guard: &mut Guard,
) -> CommandResult {
    let form = format.into();
    if !Window::FORMS.contains(&form) {
        return Err(Failure::Usage("'--window' and '--window-x' write text, json or csv".to_owned()));
    }
    arguments.job(form).run(window, guard)
}
