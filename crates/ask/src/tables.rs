//! Further tables that a question names.

use boundfit_exact::{Foreign, Reading};
use boundfit_formats::{Again, RowSet, ScanOptions, Source, TableNotes, TableOptions};

use crate::refusal::Refusal;

/// The place of further tables that a question names: readings to be judged, values for predictions.
pub trait Tables: Send + Sync {
    /// Opens one, all rows of it, and says how it is read.
    ///
    /// # Errors
    /// When there is none of this name.
    fn open(&self, name: &str) -> Result<(Source, ScanOptions), Refusal>;

    /// The file that a table is, for reports; nothing of standard input.
    fn file<'a>(&'a self, name: &'a str) -> Option<Foreign<&'a str>> {
        (name != "-").then(|| Foreign::of(name))
    }

    /// Takes note of what one was taken for, after it was read, and of how many rows were left out since they lack a number.
    fn was_read(&self, _name: &str, _table: Option<&TableNotes>, _rows_missing: usize) {}
}

/// Files, by their paths, read as this says but for the rows that it chooses.
pub struct Files(pub ScanOptions);

impl Files {
    /// Returns how a file is read: as doubles where it stores doubles.
    pub fn options(&self, source: &Source) -> ScanOptions {
        let reading = if source.is_stored() { Reading::Binary64 } else { self.0.table.reading };
        of_all_rows(&self.0, reading)
    }
}

impl Tables for Files {
    fn open(&self, name: &str) -> Result<(Source, ScanOptions), Refusal> {
        let source = Source::open(name)?;
        let options = self.options(&source);
        Ok((source, options))
    }
}

/// Tables in memory by their names, each with how its numbers are read, beside files.
pub struct Held {
    /// The tables.
    pub tables: Vec<(String, Again, Reading)>,
    /// The name of the tables in reports, if any.
    pub shown: Option<&'static str>,
    /// The options for reading all tables, except for their numbers.
    pub files: Files,
}

impl Tables for Held {
    fn open(&self, name: &str) -> Result<(Source, ScanOptions), Refusal> {
        match self.tables.iter().find(|(own, ..)| own == name) {
            Some((_, again, reading)) => Ok((again.open()?, of_all_rows(&self.files.0, *reading))),
            None => self.files.open(name),
        }
    }

    fn file<'a>(&'a self, name: &'a str) -> Option<Foreign<&'a str>> {
        match self.tables.iter().any(|(own, ..)| own == name) {
            true => self.shown.map(Foreign::of),
            false => self.files.file(name),
        }
    }
}

/// Returns the options for reading a further table: as the first one, but all of it.
fn of_all_rows(options: &ScanOptions, reading: Reading) -> ScanOptions {
    let table = TableOptions {
        rows: RowSet::default(),
        conditions: Vec::new(),
        reading,
        is_beside: true,
        ..options.table.clone()
    };
    ScanOptions { table, hash: false, list_rows: false, progress: None, ..options.clone() }
}
