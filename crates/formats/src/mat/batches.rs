//! The columns as rows, in batches.

use std::io::Read;
use std::ops::Range;

use super::columns::{MatColumn, MatColumns};
use super::numbers::BadNumber;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::{InputError, InputErrorKind, Place};
use crate::scan::{Batch, Pieces, ScanOptions, Scanned, readable_rows};
use crate::table::check_rows;
use crate::threads;

/// The most rows that are handed out at a time: two columns of them take 1 MB.
const BATCH_ROWS: usize = 1 << 16;

/// Reads columns of a MATLAB file as [`scan`](crate::scan) says. Every number is the one that is stored, whichever way text is to be read. With [`ScanOptions::keep_text`], the rows are written as CSV of the columns
/// asked for, which reads back the same under the binary64 reading.
///
/// Exact. Cost: one pass; memory for the variables that are asked for.
///
/// # Errors
/// The first thing wrong, with the variable, or the row and column.
pub(crate) fn scan_mat<T: Send>(
    name: &str,
    file: Box<dyn Read>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    work: impl Fn(Batch) -> T + Sync,
    mut take: impl FnMut(T),
) -> Result<Scanned, InputError> {
    let fail = |problem: InputErrorKind| InputError::of_file(name, problem);
    let selectors: Vec<&ColumnSelector> = columns.iter().chain(&options.key).collect();
    let progress = options.progress.as_deref();
    let found = MatColumns::read(file, &selectors, &options.table.sizes, options.hash, progress);
    let MatColumns { columns: found, rows, sha256, bytes } = found.map_err(fail)?;
    check_rows(name, rows, options.table.rows)?;
    let (numbers, key) = found.split_at_checked(columns.len()).unwrap_or_default();
    let rows_of = Rows { file: name, selectors: columns, columns: numbers, key: key.first(), options };
    let wanted = options.table.rows.map_or(1..rows + 1, |wanted| wanted.among(1, rows + 1));
    let starts: Vec<usize> = wanted.clone().step_by(BATCH_ROWS).collect();
    for group in starts.chunks(threads::count()) {
        let batch = |start: usize| rows_of.batch(start..wanted.end.min(start + BATCH_ROWS)).map(&work);
        let done: Vec<Result<T, InputError>> = threads::map(group.to_vec(), batch);
        for result in done {
            take(result?);
        }
        if progress.is_some_and(|progress| progress.is_cancelled()) {
            return Err(fail(InputErrorKind::Interrupted));
        }
    }
    if let Some(wanted) = options.table.rows.filter(|_| options.table.keep_others) {
        let unwanted = wanted.not_among(1, rows + 1).into_iter();
        let others = unwanted.flat_map(|rows| readable_rows(rows, &|rows| rows_of.batch(rows))).collect();
        take(work(Batch { others, ..rows_of.batch(1..1)? }));
    }
    let names: Vec<String> = numbers.iter().map(|column| column.place.title()).collect();
    Ok(Scanned {
        layout: None,
        header_line: options.keep_text.then(|| csv_line(&names)),
        names,
        key_name: key.first().map(|column| column.place.title()),
        delimiter: b',',
        rows_total: rows,
        bytes,
        sha256,
    })
}

/// Rows of columns of one length.
struct Rows<'a> {
    file: &'a str,
    selectors: &'a [ColumnSelector],
    columns: &'a [MatColumn],
    key: Option<&'a MatColumn>,
    options: &'a ScanOptions,
}

impl Rows<'_> {
    /// The rows with these numbers, counted from 1.
    fn batch(&self, rows: Range<usize>) -> Result<Batch, InputError> {
        let mut columns = Vec::new();
        for (column, selector) in self.columns.iter().zip(self.selectors) {
            let range = indices(column, &rows);
            if self.options.keep_text
                && let Some(index) = column.numbers.first_beyond_doubles(range.clone())
            {
                let text = column.numbers.text(index);
                return Err(
                    self.error(column, BadNumber { index, text, problem: InputErrorKind::NotBinary64 })
                );
            }
            let numbers = column.numbers.column(range, selector.role());
            columns.push(numbers.map_err(|bad| self.error(column, bad))?);
        }
        let text = |column: &MatColumn, row: usize| column.numbers.text(column.start + row - 1);
        let keys = self.key.map(|key| {
            let mut keys = Pieces::<String>::default();
            rows.clone().for_each(|row| keys.push(&text(key, row)));
            keys
        });
        let lines = self.options.keep_text.then(|| {
            let mut lines = Pieces::<Vec<u8>>::default();
            for row in rows.clone() {
                let cells: Vec<String> = self.columns.iter().map(|column| text(column, row)).collect();
                lines.push(&csv_line(&cells));
            }
            lines
        });
        Ok(Batch { first_row: rows.start, columns, keys, lines, rows: rows.len(), others: Vec::new() })
    }

    fn error(&self, column: &MatColumn, bad: BadNumber) -> InputError {
        let ColumnPlace { position, name } = column.place.clone();
        let place = Place {
            row: Some(bad.index + 1 - column.start),
            column: Some((position, name)),
            text: Some(bad.text),
            ..Place::default()
        };
        InputError::new(self.file, place, bad.problem)
    }
}

/// Where the numbers of rows, counted from 1, stand in a column's variable.
fn indices(column: &MatColumn, rows: &Range<usize>) -> Range<usize> {
    column.start + rows.start - 1..column.start + rows.end - 1
}

/// Cells, none of them empty, as a line of CSV, without its end.
fn csv_line(cells: &[String]) -> Vec<u8> {
    let quoted = |cell: &String| match cell.contains([',', '"', '\r', '\n']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell.clone(),
    };
    cells.iter().map(quoted).collect::<Vec<_>>().join(",").into_bytes()
}
