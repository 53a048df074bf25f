//! The columns as rows, in batches.

use std::io::Read;
use std::ops::Range;

use boundfit_exact::{Column, Reading, WorkMeter};

use super::columns::MatColumns;
use super::search::MatColumn;
use crate::cells::CellReader;
use crate::columns::{ColumnPlace, ColumnSelector, refuse_same};
use crate::error::{InputError, InputErrorKind};
use crate::memory::{BadNumber, Cells, Part};
use crate::scan::check_rows;
use crate::scan::{Consumer, ScanOptions, Scanned};
use crate::selection::RowCondition;
use crate::wanted::{Placed, WantedColumns};

/// Refuses a variable, or a column of one, that is asked for twice.
fn refuse_twice(file: &str, selectors: &[ColumnSelector]) -> Result<(), InputError> {
    let place = |selector: &ColumnSelector| {
        let first = selectors.iter().position(|other| other.text() == selector.text());
        ColumnPlace { position: first.unwrap_or_default(), name: None }
    };
    let places: Vec<ColumnPlace> = selectors.iter().map(place).collect();
    refuse_same(file, places.iter().zip(selectors)).map_err(|mut error| {
        // Variables have no numbers.
        error.place.column = None;
        error
    })
}

/// Reads columns of a MATLAB file as [`scan`](crate::scan) says. Every number is the one that is stored, whichever way text is to be read. With [`ScanOptions::keep_text`], the rows are written as CSV of the columns
/// asked for, which reads back the same under the binary64 reading.
///
/// Exact. Cost: one pass; memory for the variables that are asked for.
///
/// # Errors
/// The first thing wrong, with the variable, or the row and column.
pub(crate) fn scan_mat(
    name: &str,
    file: Box<dyn Read>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    consumer: &mut Consumer,
) -> Result<Scanned, InputError> {
    let fail = |problem: InputErrorKind| InputError::of_file(name, problem);
    let conditions = &options.table.conditions;
    let looked_at = conditions.iter().map(RowCondition::column);
    let selectors: Vec<&ColumnSelector> =
        columns.iter().chain(&options.key).chain(&options.identity).chain(looked_at).collect();
    let progress = options.progress.as_deref();
    refuse_twice(name, columns)?;
    let found = MatColumns::read(file, &selectors, &options.table.sizes, options.hash, progress);
    // The columns are given back behind the last batch.
    let MatColumns { columns: found, rows, sha256, bytes, memory: _memory } = found.map_err(fail)?;
    check_rows(name, rows, options)?;
    let mut found = found.into_iter();
    let wanted = WantedColumns {
        file: name,
        options,
        selectors: columns,
        places: found.by_ref().take(columns.len()).collect(),
        key: options.key.as_ref().and_then(|_| found.next()),
        identity: options.identity.as_ref().and_then(|_| found.next()),
        conditions: found.zip(conditions).collect(),
        meter: WorkMeter::default(),
    };
    let table = Variables { keep_text: options.keep_text };
    let scanned = Part { table: &table, wanted: &wanted, before: 0, lines: &[] }.scan(rows, consumer)?;
    Ok(Scanned { bytes, sha256, ..scanned })
}

/// The numbers of variables, from one of them on.
struct Variables {
    /// `true` if rows are written as text, which must read back as the same doubles.
    keep_text: bool,
}

impl Placed for MatColumn {
    fn place(&self) -> &ColumnPlace {
        &self.place
    }
}

impl Cells<MatColumn> for Variables {
    fn has_missing(&self, _: &MatColumn) -> bool {
        true
    }

    fn is_missing(&self, column: &MatColumn, index: usize) -> bool {
        column.numbers.is_missing(column.start + index)
    }

    fn text(&self, column: &MatColumn, index: usize, _: Reading) -> String {
        column.numbers.text(column.start + index)
    }

    fn column(
        &self,
        column: &MatColumn,
        range: Range<usize>,
        reader: CellReader,
    ) -> Result<Column, BadNumber> {
        let range = column.start + range.start..column.start + range.end;
        let bad = |index: usize| {
            let (text, problem) = (column.numbers.text(index), InputErrorKind::NotBinary64);
            BadNumber { index, text, problem }
        };
        let beyond = self.keep_text.then(|| column.numbers.first_beyond_doubles(range.clone())).flatten();
        let read = beyond.map_or_else(|| column.numbers.column(range, reader), |index| Err(bad(index)));
        read.map_err(|bad| BadNumber { index: bad.index - column.start, ..bad })
    }
}
