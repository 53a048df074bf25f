//! `boundfit man`.

use clap::CommandFactory;
use clap_mangen::Man;

use crate::CommandResult;
use crate::arguments::{Arguments, FileArguments};
use crate::exit::{Exit, Failure};
use crate::output;

/// Prints the manual page of the program or of one of its commands.
pub(crate) fn run(topic: Option<&str>, file: &FileArguments) -> CommandResult {
    let mut program = Arguments::command();
    program.build();
    let command = match topic {
        None => program,
        Some(topic) => {
            let names: Vec<&str> = program.get_subcommands().map(clap::Command::get_name).collect();
            let expected = format!("expected one of {}", names.join(", "));
            let Some(command) = program.find_subcommand(topic) else {
                return Err(Failure::value("[TOPIC]", topic, expected));
            };
            command.clone()
        }
    };
    let mut page = Vec::new();
    Man::new(command).render(&mut page).map_err(Failure::data)?;
    output::write(&String::from_utf8(page).map_err(Failure::data)?, file.output.as_deref())?;
    Ok(Exit::Answer)
}
