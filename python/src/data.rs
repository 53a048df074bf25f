//! The source of readings, to be read as often as they are asked about.

use std::sync::Arc;

use boundfit::Reading;
use boundfit::engine::exact::Foreign;
use boundfit::files::{Header, InputError, MemoryNumbers, MemoryTable, ScanOptions, Source};
use boundfit::report::Origin;

/// The name in messages of tables that are no file.
pub(crate) const IN_MEMORY: &str = "columns in memory";

/// The source of readings.
#[derive(Clone)]
pub(crate) enum Data {
    Columns(Arc<MemoryTable>),
    /// Text with a name for messages: the same columns as CSV, or reductions.
    Text(&'static str, Arc<[u8]>),
    File(String),
}

impl Data {
    /// Another look at them.
    pub(crate) fn source(&self) -> Result<Source, InputError> {
        match self {
            Data::Columns(table) => Ok(Source::of_table("readings", Arc::clone(table))),
            Data::Text(name, text) => Ok(Source::of_bytes(*name, Arc::clone(text))),
            Data::File(path) => Source::open(path),
        }
    }

    /// Returns whether they are fitted in less time than a thread is worth.
    pub(crate) fn is_small(&self) -> bool {
        const FEW_TEXTS: usize = 2_000;
        const FEW_NUMBERS: usize = 20_000;
        let is_short = |numbers: &MemoryNumbers| match numbers {
            MemoryNumbers::Exact(_) | MemoryNumbers::Texts(_) => numbers.len() <= FEW_TEXTS,
            _ => numbers.len() <= FEW_NUMBERS,
        };
        match self {
            Data::Columns(table) => table.columns().all(|(_, numbers)| is_short(numbers)),
            Data::Text(..) | Data::File(_) => false,
        }
    }

    /// The file, if they are one.
    pub(crate) fn path(&self) -> Option<&str> {
        match self {
            Data::File(path) => Some(path),
            Data::Columns(_) | Data::Text(..) => None,
        }
    }

    /// Returns true for a file that stores doubles.
    pub(crate) fn is_stored(&self) -> Result<bool, InputError> {
        Ok(self.path().is_some() && self.source()?.is_stored())
    }

    /// Columns in memory as the text that proofs are about, and how that is read; files as they are.
    pub(crate) fn written(&self, options: &ScanOptions, reading: Reading) -> (Self, ScanOptions) {
        let Data::Columns(table) = self else { return (self.clone(), options.clone()) };
        let mut options = ScanOptions { hash: true, list_rows: true, ..options.clone() };
        options.table.header = Header::Present;
        options.table.dialect.delimiter = Some(b',');
        (Data::Text("readings.csv", table.to_csv(reading).into()), options)
    }

    /// Returns the source of the readings, for programs.
    pub(crate) fn origin(&self, reading: Reading, is_stored: bool) -> Origin<'_> {
        Origin { file: self.path().map(Foreign::of), reading, is_stored }
    }

    /// Returns the source of the readings, for people: readings without a file do not come from standard input
    /// either.
    pub(crate) fn shown_origin(&self, reading: Reading, is_stored: bool) -> Origin<'_> {
        let file = Some(Foreign::of(self.path().unwrap_or(IN_MEMORY)));
        Origin { file, ..self.origin(reading, is_stored) }
    }
}
