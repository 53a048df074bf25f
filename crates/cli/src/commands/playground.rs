//! `boundfit playground`.

use boundfit_lesson::{Language, playground};
use clap::Args;

use crate::exit::{CommandResult, Exit, Failure};
use crate::options::{BAD_USAGE, FileArguments, Notes, named, told_by_name};
use crate::output;

pub(super) const NOTES: Notes = Notes {
    examples: &[("A page for people who have no boundfit", "boundfit playground -o boundfit.html")],
    statuses: &[(0, "the page is written"), (1, "the page cannot be written"), BAD_USAGE],
};

/// Write a web page on which readings are typed or pasted, for people who have only a browser
///
/// The page is one file without outside parts, with the exact engine inside: the page of `boundfit lesson` without
/// readings. It needs no network and no installation, and sends nothing. It also intersects half-planes step by step.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct PlaygroundArguments {
    /// First language of the page; the reader can change it
    #[arg(long, default_value = Language::English.code(),
          value_parser = named(Language::ALL.map(|language| (language.code(), language))))]
    language: Language,
    #[command(flatten)]
    file: FileArguments,
}

/// Writes the page.
pub(super) fn run(arguments: &PlaygroundArguments) -> CommandResult {
    let output = arguments.file.output.as_deref();
    let guard = arguments.file.replace.guard([]);
    guard.check(output)?;
    told_by_name(output, &[("html", ()), ("htm", ())], None)?;
    output::refuse_terminal("page", output)?;
    output::write(playground(arguments.language).map_err(Failure::data)?, output, &guard)?;
    Ok(Exit::Answer)
}
