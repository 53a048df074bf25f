//! `boundfit playground`.

use boundfit_lesson::playground;

use crate::CommandResult;
use crate::arguments::{PlaygroundArguments, told_by_name};
use crate::exit::{Exit, Failure};
use crate::output;

/// Writes the page.
pub(crate) fn run(arguments: &PlaygroundArguments) -> CommandResult {
    let output = arguments.file.output.as_deref();
    let guard = arguments.file.replace.guard([]);
    guard.check(output)?;
    told_by_name(output, &[("html", ()), ("htm", ())], None)?;
    output::write(playground(arguments.language).map_err(Failure::data)?, output, &guard)?;
    Ok(Exit::Answer)
}
