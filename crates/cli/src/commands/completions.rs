//! `boundfit completions`.

use clap::{Args, CommandFactory};
use clap_complete::{Shell, generate};

use super::Arguments;
use crate::exit::{CommandResult, Exit, Failure};
use crate::options::{FileArguments, Notes};
use crate::output;

pub(super) const NOTES: Notes = Notes {
    examples: &[("For every user of bash", "boundfit completions bash > /etc/bash_completion.d/boundfit")],
    statuses: &[],
};

/// Print a completion script for a shell
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct CompletionsArguments {
    /// The shell
    shell: Shell,
    #[command(flatten)]
    file: FileArguments,
}

/// Prints a completion script.
pub(super) fn run(CompletionsArguments { shell, file }: &CompletionsArguments) -> CommandResult {
    let mut script = Vec::new();
    generate(*shell, &mut Arguments::command(), "boundfit", &mut script);
    output::write(
        &String::from_utf8(script).map_err(Failure::data)?,
        file.output.as_deref(),
        &file.replace.guard([]),
    )?;
    Ok(Exit::Answer)
}
