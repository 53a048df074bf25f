//! The output of a scan: consecutive rows, in columns.

use std::sync::Arc;

use boundfit_exact::{Column, Foreign};

use crate::columns::ColumnSelector;
use crate::error::{InputError, InputErrorKind};
use crate::fractions::Fractions;
use crate::notes::TableNotes;
use crate::selection::RowNumbers;
use crate::table::{TableOptions, TableRow, TextLayout};

/// One piece of text per row, in one buffer.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Pieces<B> {
    buffer: B,
    ends: Vec<usize>,
}

impl<B> Pieces<B> {
    /// How many pieces there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    #[allow(
        clippy::indexing_slicing,
        reason = "documented to panic where it is asked; ends are pushed in ascending order and within the buffer"
    )]
    fn range(&self, index: usize) -> std::ops::Range<usize> {
        let start = index.checked_sub(1).map_or(0, |before| self.ends[before]);
        start..self.ends[index]
    }
}

impl Pieces<String> {
    /// A piece.
    ///
    /// # Panics
    /// When there are not that many.
    pub fn get(&self, index: usize) -> &str {
        &self.buffer[self.range(index)]
    }

    pub(crate) fn push(&mut self, piece: &str) {
        self.buffer.push_str(piece);
        self.ends.push(self.buffer.len());
    }
}

impl Pieces<Vec<u8>> {
    /// A piece.
    ///
    /// # Panics
    /// When there are not that many.
    #[allow(clippy::indexing_slicing, reason = "the range is one of the buffer, by range()")]
    pub fn get(&self, index: usize) -> &[u8] {
        &self.buffer[self.range(index)]
    }

    pub(crate) fn push(&mut self, piece: &[u8]) {
        self.buffer.extend_from_slice(piece);
        self.ends.push(self.buffer.len());
    }
}

/// Wanted data rows, in columns; at least one row, unless others are kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// Which data rows of the file these are.
    pub rows: RowNumbers,
    /// The columns asked for, in the order asked, all of the same length.
    pub columns: Vec<Column>,
    /// The cells of [`ScanOptions::key`], without the spaces and tabs around them.
    pub keys: Option<Pieces<String>>,
    /// With [`ScanOptions::keep_text`], each row as it stands in the file, without its line end.
    pub lines: Option<Pieces<Vec<u8>>>,
    /// With [`TableOptions::keep_cells`], [`TableRow::cells`] of each row; nothing of tables that are no text.
    pub cells: Vec<Vec<String>>,
    /// How many cells of each column asked for are fractions; none are counted where numbers are stored.
    pub fractions: Vec<Fractions>,
    /// With [`TableOptions::keep_others`], rows that are not wanted but hold numbers; then there may be no other rows.
    pub others: Vec<TableRow>,
}

impl Batch {
    /// The wanted rows one by one.
    pub fn table_rows(&self) -> impl Iterator<Item = TableRow> {
        let rows = self.rows.ranges().flat_map(|[first, last]| first..=last);
        rows.enumerate().map(|(index, row)| TableRow {
            row,
            numbers: self.columns.iter().map(|column| column.get(index)).collect(),
            cells: self.cells.get(index).cloned().unwrap_or_default(),
        })
    }
}

/// How a scan is to go.
#[derive(Clone)]
pub struct ScanOptions {
    /// How the table is to be read.
    pub table: TableOptions,
    /// A column of text.
    pub key: Option<ColumnSelector>,
    /// `true` if the text of the rows is handed out too.
    pub keep_text: bool,
    /// A column that tells rows apart. With `keep_text`, rows that are not text to begin with, of which else only the columns asked
    /// for are written, are written with its cells at the end; rows of text have all their cells anyway.
    pub identity: Option<ColumnSelector>,
    /// `true` if a table without rows, or without any that are wanted, is nothing but that. It is refused otherwise.
    pub allow_nothing: bool,
    /// `true` if the bytes are hashed.
    pub hash: bool,
    /// `true` if it is told which rows were wanted: that may be as many ranges as half of the rows.
    pub list_rows: bool,
    /// `true` if rows are handed out that have a number in none of the columns that may lack one. They are refused otherwise, with
    /// their place.
    pub unbounded_rows: bool,
    /// `true` if a column may be asked for twice. It is refused otherwise; of a reduction, what it does not answer is said first.
    pub same_columns: bool,
    /// About how many bytes a batch stands for, at least 1.
    pub chunk_bytes: usize,
    /// Who is told how far it is, and may stop it.
    pub progress: Option<Arc<dyn Progress>>,
}

/// Refuses a table without rows, unless it may be one, or without all the rows that were named.
pub(crate) fn check_rows(file: &str, total: usize, options: &ScanOptions) -> Result<(), InputError> {
    let wanted = &options.table.rows;
    if total == 0 && !options.allow_nothing {
        return Err(InputError::of_file(file, InputErrorKind::NoRows));
    }
    match wanted.beyond(total) {
        Some(rows) => Err(InputError::of_file(file, InputErrorKind::RowsBeyondEnd { rows, total })),
        None => Ok(()),
    }
}

/// From 128 KiB to 1 MiB the time is the same; twice as much no longer fits a level-2 cache beside its numbers.
const CHUNK_BYTES: usize = 1 << 18;

impl Default for ScanOptions {
    fn default() -> Self {
        ScanOptions {
            table: TableOptions::default(),
            key: None,
            keep_text: false,
            identity: None,
            allow_nothing: false,
            hash: true,
            list_rows: true,
            unbounded_rows: false,
            same_columns: false,
            chunk_bytes: CHUNK_BYTES,
            progress: None,
        }
    }
}

/// Follows a scan.
pub trait Progress: Send + Sync {
    /// Counts more finished bytes.
    fn advanced(&self, bytes: u64);

    /// Returns whether the scan is to stop, with [`InputErrorKind::Interrupted`](crate::InputErrorKind::Interrupted).
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// The known facts about a table after its scan.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Scanned {
    /// The names of the columns asked for; `col1` and so on where there is none.
    pub names: Vec<Foreign>,
    /// How many cells of each column asked for are fractions; empty where numbers are stored.
    pub fractions: Vec<Fractions>,
    /// The names of all columns, asked for or not; none without a header.
    pub header: Vec<Foreign>,
    /// The name of the key column.
    pub key_name: Option<Foreign>,
    /// With [`ScanOptions::keep_text`], the header as it stands in the file, without its line end.
    pub header_line: Option<Vec<u8>>,
    /// The units of the columns asked for, where the table states them.
    pub units: Vec<Option<Foreign>>,
    /// Where the numbers stand; `None` unless the table is delimited text.
    pub layout: Option<TextLayout>,
    /// The detected format of the table; `None` unless it is text or a sheet.
    pub table: Option<TableNotes>,
    /// With [`ScanOptions::list_rows`], first and last of the wanted rows that follow each other without a gap.
    pub ranges: Vec<[usize; 2]>,
    /// How many data rows the file has.
    pub rows_total: usize,
    /// How many wanted rows were left out since they lack a number.
    pub rows_missing: usize,
    /// How many bytes the file has.
    pub bytes: u64,
    /// With [`ScanOptions::hash`], SHA-256 of the file's bytes, in hexadecimal.
    pub sha256: Option<String>,
}
