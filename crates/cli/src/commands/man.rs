//! `boundfit man`.

use std::io;

use clap::{Args, Command, CommandFactory};
use clap_mangen::Man;
use clap_mangen::roff::{Roff, bold, roman};

use super::{Arguments, named};
use crate::exit::{CommandResult, Exit, Failure};
use crate::options::{FileArguments, Notes};
use crate::output;

pub(super) const NOTES: Notes = Notes {
    examples: &[("The page of 'fit' as a file", "boundfit man fit > boundfit-fit.1")],
    statuses: &[],
};

/// Print the manual page (roff) of the program or of one of its commands
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct ManArguments {
    /// A command. Default: the program itself
    topic: Option<String>,
    #[command(flatten)]
    file: FileArguments,
}

/// Prints the manual page of the program or of one of its commands.
pub(super) fn run(ManArguments { topic, file }: &ManArguments) -> CommandResult {
    let mut program = Arguments::command();
    program.build();
    let command = match topic.as_deref() {
        None => program,
        Some(topic) => {
            let names: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
            let expected = format!("expected one of {}", names.join(", "));
            let Some(command) = program.find_subcommand(topic) else {
                return Err(Failure::value("[TOPIC]", topic, expected));
            };
            command.clone()
        }
    };
    let page = page(command).map_err(Failure::data)?;
    output::write(&page, file.output.as_deref(), &file.replace.guard([]))?;
    Ok(Exit::Answer)
}

/// The page of a command. Synopsis and examples are our own: the library leaves out the values of options, and sets examples
/// as running text, so that they cannot be copied.
fn page(command: Command) -> io::Result<Vec<u8>> {
    let name = command.get_name().to_owned();
    let has_options = command.get_arguments().next().is_some();
    let has_commands = command.has_subcommands();
    let synopsis = synopsis(command.clone());
    let source = format!("boundfit {}", env!("CARGO_PKG_VERSION"));
    // For an option that the short help omits, the library would print the name alone.
    let command = command.mut_args(|argument| argument.hide_short_help(false));
    let manual = Man::new(command).source(source).manual("boundfit");
    let mut page = Vec::new();
    manual.render_title(&mut page)?;
    // Names of files and options are no words that may be divided.
    Roff::new().control("nh", []).to_writer(&mut page)?;
    manual.render_name_section(&mut page)?;
    synopsis.to_writer(&mut page)?;
    manual.render_description_section(&mut page)?;
    if has_options {
        manual.render_options_section(&mut page)?;
    }
    if has_commands {
        manual.render_subcommands_section(&mut page)?;
    }
    if let Some(command) = named(&name) {
        endings(command.notes).to_writer(&mut page)?;
    }
    Ok(page)
}

/// The line of usage, as the help shows it.
fn synopsis(mut command: Command) -> Roff {
    let usage = command.render_usage().to_string();
    let name = command.get_bin_name().unwrap_or_default();
    let rest = usage.trim_start_matches("Usage: ").trim_start_matches(name);
    let mut roff = Roff::new();
    roff.control("SH", ["SYNOPSIS"]).text([bold(name), roman(rest)]);
    roff
}

/// Examples, each line of a command as it stands, and exit statuses.
fn endings(notes: &Notes) -> Roff {
    let mut roff = Roff::new();
    roff.control("SH", ["EXAMPLES"]);
    for (what, command) in notes.examples {
        roff.control("PP", []).text([roman(format!("{what}:"))]);
        roff.control("PP", []).control("RS", ["4"]).control("nf", []);
        for line in command.lines() {
            roff.text([roman(line)]);
        }
        roff.control("fi", []).control("RE", []);
    }
    if !notes.statuses.is_empty() {
        roff.control("SH", ["EXIT STATUS"]);
    }
    for (status, meaning) in notes.statuses {
        roff.control("TP", []).text([bold(status.to_string())]).text([roman(*meaning)]);
    }
    roff
}
