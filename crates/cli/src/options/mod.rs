//! Options that several commands share, and the words in which every surface has them.

mod endings;
pub(crate) mod limits;
mod look;
mod notes;
mod proof;
mod reading;
mod rows;
mod shared;
mod tolerance;
mod values;
mod x_errors;

pub(crate) use endings::{
    Format, NamedFormat, ReportFormat, TableFormat, ending, formats, forms, told_by_name,
};
pub(crate) use limits::LimitArguments;
pub(crate) use look::{LookArguments, PictureArguments, refuse_without_picture};
pub(crate) use notes::{BAD_DATA, BAD_USAGE, Notes};
pub(crate) use proof::ProofArguments;
pub(crate) use reading::{Words, given};
pub(crate) use rows::RowArguments;
pub(crate) use shared::{
    DataArguments, EpsilonArguments, FileArguments, LabelArguments, LineArguments, OutputArguments,
    ReplaceArguments, TableArguments, ThreadArguments,
};
pub(crate) use tolerance::{Switch, ToleranceArguments};
pub(crate) use values::{column_text, explained, named, parse_regressors, whole, words_or_auto};
pub(crate) use x_errors::XErrorArguments;
