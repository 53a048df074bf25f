//! The arguments of `boundfit playground`.

use boundfit_lesson::Language;
use clap::Args;

use super::FileArguments;
use super::notes::{BAD_USAGE, Notes};
use super::values::named;

pub(super) const NOTES: Notes = Notes {
    examples: &[("A page for people who have no boundfit", "boundfit playground -o boundfit.html")],
    statuses: &[(0, "the page is written"), BAD_USAGE],
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
    pub(crate) language: Language,
    #[command(flatten)]
    pub(crate) file: FileArguments,
}
