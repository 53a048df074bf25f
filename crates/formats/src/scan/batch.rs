//! The output of a scan: consecutive rows, in columns.

use std::sync::Arc;

use boundfit_exact::{Column, Foreign};

use super::keys::RowKeys;
use super::pieces::Pieces;
use crate::columns::ColumnSelector;
use crate::error::{InputError, InputErrorKind};
use crate::fractions::Fractions;
use crate::notes::TableNotes;
use crate::selection::RowNumbers;
use crate::table::{TableOptions, TableRow, TextLayout};

/// Wanted data rows, in columns; at least one row, unless others are kept or keys of rows that are left out.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// The numbers of these data rows in the file.
    pub rows: RowNumbers,
    /// The columns asked for, in the order asked, all of the same length.
    pub columns: Vec<Column>,
    /// The cells of [`ScanOptions::key`], without the spaces and tabs around them.
    pub keys: Option<RowKeys>,
    /// The cells of [`ScanOptions::key`] in rows that are left out since they lack a number, one of equal neighbours.
    pub keys_missing: Vec<String>,
    /// Each row as it stands in the file, without its line end; only with [`ScanOptions::keep_text`].
    pub lines: Option<Pieces<Vec<u8>>>,
    /// [`TableRow::cells`] of each row, only with [`TableOptions::keep_cells`] and for text.
    pub cells: Vec<Vec<String>>,
    /// The number of fractions among the cells of each column asked for; nothing is counted where numbers are
    /// stored.
    pub fractions: Vec<Fractions>,
    /// The rows that are not wanted but hold numbers, only with [`TableOptions::keep_others`]; then there may
    /// be no other rows.
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

/// The options of a scan.
#[derive(Clone)]
pub struct ScanOptions {
    /// The options of the table.
    pub table: TableOptions,
    /// A column of text.
    pub key: Option<ColumnSelector>,
    /// `true` if the text of the rows is handed out too.
    pub keep_text: bool,
    /// A column that tells rows apart. A column whose cells stand at the end of each written row. This matters only
    /// with `keep_text` and for rows that do not come from text: they are written with the columns asked for only.
    /// Rows of text have all their cells.
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
    /// The approximate number of bytes of a batch, at least 1.
    pub chunk_bytes: usize,
    /// A listener that is told how far the scan is, and may stop it.
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

/// Sizes from 128 KiB to 1 MiB take the same time; twice as much no longer fits a level-2 cache beside its
/// numbers.
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
    /// The number of fractions among the cells of each column asked for; empty where numbers are stored.
    pub fractions: Vec<Fractions>,
    /// The names of all columns, asked for or not; none without a header.
    pub header: Vec<Foreign>,
    /// The name of the key column.
    pub key_name: Option<Foreign>,
    /// The header as it stands in the file, without its line end; only with [`ScanOptions::keep_text`].
    pub header_line: Option<Vec<u8>>,
    /// The units of the columns asked for, where the table states them.
    pub units: Vec<Option<Foreign>>,
    /// The place of the numbers; `None` unless the table is delimited text.
    pub layout: Option<TextLayout>,
    /// The detected format of the table; `None` unless it is text or a sheet.
    pub table: Option<TableNotes>,
    /// The first and last of the wanted rows that follow each other without a gap, with
    /// [`ScanOptions::list_rows`].
    pub ranges: Vec<[usize; 2]>,
    /// The number of data rows of the file.
    pub rows_total: usize,
    /// The number of wanted rows that were left out since they lack a number.
    pub rows_missing: usize,
    /// The number of bytes of the file.
    pub bytes: u64,
    /// SHA-256 of the file's bytes, in hexadecimal; only with [`ScanOptions::hash`].
    pub sha256: Option<String>,
}
