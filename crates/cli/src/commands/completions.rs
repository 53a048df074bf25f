//! `boundfit completions`.

use clap::CommandFactory;
use clap_complete::{Shell, generate};

use crate::CommandResult;
use crate::arguments::{Arguments, FileArguments};
use crate::exit::{Exit, Failure};
use crate::output;

/// Prints a completion script.
pub(crate) fn run(shell: Shell, file: &FileArguments) -> CommandResult {
    let mut script = Vec::new();
    generate(shell, &mut Arguments::command(), "boundfit", &mut script);
    output::write(
        &String::from_utf8(script).map_err(Failure::data)?,
        file.output.as_deref(),
        &file.replace.guard([]),
    )?;
    Ok(Exit::Answer)
}
