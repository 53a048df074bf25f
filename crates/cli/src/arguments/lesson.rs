//! The arguments of `boundfit lesson`.

use boundfit_exact::Limit;
use boundfit_lesson::Language;
use clap::Args;

use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::values::named;
use super::{DataArguments, FileArguments, LabelArguments, limits};

pub(super) const NOTES: Notes = Notes {
    examples: &[(
        "A page about a line, for every browser",
        "boundfit lesson transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 -o lesson.html",
    )],
    statuses: &[
        (0, "the page is written"),
        BAD_DATA,
        BAD_USAGE,
        (
            3,
            "the feasible parameter set is empty; the page shows why, and from which error bound on there is one",
        ),
    ],
};

/// Write a web page that explains the feasible parameters of these readings
///
/// The page is one file without outside parts, for every browser. It shows the readings and the parameter plane side by
/// side, clipping step by step, a slider for the error bound, the role of each reading, and questions with answers. All
/// numbers are exact.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("limit", |limit| limits::with(&[Limit::Readings])(limit).hide_short_help(false)))]
pub(crate) struct LessonArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    #[command(flatten)]
    pub(crate) labels: LabelArguments,
    /// First language of the page; the reader can change it
    #[arg(long, default_value = Language::English.code(),
          value_parser = named(Language::ALL.map(|language| (language.code(), language))))]
    pub(crate) language: Language,
    #[command(flatten)]
    pub(crate) file: FileArguments,
}
