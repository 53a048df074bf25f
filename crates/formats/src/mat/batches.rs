//! The columns as rows, in batches.

use std::io::Read;
use std::ops::Range;

use boundfit_exact::{Column, Foreign, WorkMeter};

use super::columns::MatColumns;
use super::search::MatColumn;
use crate::cells::CellReader;
use crate::columns::{ColumnPlace, ColumnSelector, refuse_same};
use crate::error::{InputError, InputErrorKind, Place};
use crate::lacking::Lacking;
use crate::memory::BadNumber;
use crate::scan::check_rows;
use crate::scan::{Batch, Pieces, ScanOptions, Scanned, csv_line, each_once, readable_rows};
use crate::selection::{RowCondition, RowNumbers, between, in_batches};
use crate::threads;

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
pub(crate) fn scan_mat<T: Send>(
    name: &str,
    file: Box<dyn Read>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    work: impl Fn(Batch) -> T + Sync,
    mut take: impl FnMut(T),
) -> Result<Scanned, InputError> {
    let fail = |problem: InputErrorKind| InputError::of_file(name, problem);
    let conditions = &options.table.conditions;
    let looked_at = conditions.iter().map(RowCondition::column);
    let selectors: Vec<&ColumnSelector> =
        columns.iter().chain(&options.key).chain(&options.identity).chain(looked_at).collect();
    let progress = options.progress.as_deref();
    refuse_twice(name, columns)?;
    let found = MatColumns::read(file, &selectors, &options.table.sizes, options.hash, progress);
    // What is asked for is given back behind the last batch.
    let MatColumns { columns: found, rows, sha256, bytes, memory: _memory } = found.map_err(fail)?;
    check_rows(name, rows, options)?;
    let (numbers, others) = found.split_at_checked(columns.len()).unwrap_or_default();
    let (key, looked_at) = others.split_at_checked(options.key.iter().len()).unwrap_or_default();
    let (identity, looked_at) = looked_at.split_at_checked(options.identity.iter().len()).unwrap_or_default();
    let (key, meter) = (key.first(), WorkMeter::default());
    let rows_of = Rows { file: name, selectors: columns, columns: numbers, key, identity, options, meter };
    let asked = options.table.rows.among(1, rows + 1);
    let mut lacking = Lacking::default();
    let [satisfying, wanted] = rows_of.with_values(conditions, looked_at, &asked, &mut lacking)?;
    let used = wanted.iter().map(ExactSizeIterator::len).sum();
    let ((), rows_missing) = lacking.settle(Ok(()), used, options)?;
    for group in in_batches(&wanted).chunks(threads::count()) {
        let batch = |rows: Vec<Range<usize>>| rows_of.batch(&rows).map(&work);
        let done: Vec<Result<T, InputError>> = threads::map(group.to_vec(), batch);
        for result in done {
            take(result?);
        }
        if progress.is_some_and(|progress| progress.is_cancelled()) {
            return Err(fail(InputErrorKind::Interrupted));
        }
    }
    if options.table.keep_others && options.table.selects_rows() {
        let unwanted = between(&satisfying, 1, rows + 1).into_iter();
        let others = unwanted.flat_map(|rows| readable_rows(rows, &|rows| rows_of.batch(&[rows]))).collect();
        take(work(Batch { others, ..rows_of.batch(&[])? }));
    }
    let names: Vec<Foreign> = numbers.iter().map(|column| column.place.title()).collect();
    Ok(Scanned {
        layout: None,
        table: None,
        header_line: options
            .keep_text
            .then(|| csv_line(rows_of.written().iter().map(|column| column.place.title().raw().to_owned()))),
        names,
        header: Vec::new(),
        fractions: Vec::new(),
        key_name: key.map(|column| column.place.title()),
        units: vec![None; columns.len()],
        rows_total: rows,
        ranges: Vec::new(),
        rows_missing,
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
    /// One, or none.
    identity: &'a [MatColumn],
    options: &'a ScanOptions,
    /// The work on the numbers that were read as text.
    meter: WorkMeter,
}

impl Rows<'_> {
    /// The columns that rows have as text, each once.
    fn written(&self) -> Vec<&MatColumn> {
        let columns = || self.columns.iter().chain(self.identity);
        let titles: Vec<Foreign> = columns().map(|column| column.place.title()).collect();
        each_once(columns(), &titles).collect()
    }

    /// Of rows in these ranges, those whose numbers in some columns satisfy the conditions on them, as far as they are there, and
    /// those of them that lack no number.
    fn with_values(
        &self,
        conditions: &[RowCondition],
        looked_at: &[MatColumn],
        rows: &[Range<usize>],
        lacking: &mut Lacking,
    ) -> Result<[Vec<Range<usize>>; 2], InputError> {
        let needed =
            self.columns.iter().zip(self.selectors).filter(|(_, selector)| selector.role().is_needed());
        let needed: Vec<&MatColumn> = looked_at.iter().chain(needed.map(|(column, _)| column)).collect();
        let is_missing = |column: &MatColumn, row: usize| column.numbers.is_missing(column.start + row - 1);
        let [mut satisfying, mut wanted] = [RowNumbers::default(), RowNumbers::default()];
        for range in rows {
            let numbers = conditions.iter().zip(looked_at).map(|(condition, column)| {
                self.numbers(column, range, &condition.column().clone().optional())
            });
            let numbers: Vec<Column> = numbers.collect::<Result<_, _>>()?;
            for row in range.clone() {
                let mut pairs = conditions.iter().zip(looked_at.iter().zip(&numbers));
                let satisfies = pairs.all(|(condition, (column, numbers))| {
                    is_missing(column, row) || condition.holds(&numbers.get(row - range.start))
                });
                if !satisfies {
                    continue;
                }
                satisfying.push(row);
                match needed.iter().find(|column| is_missing(column, row)) {
                    Some(column) => {
                        let index = column.start + row - 1;
                        let problem = InputErrorKind::Null;
                        let bad = BadNumber { index, text: column.numbers.text(index), problem };
                        lacking.notice(|| self.error(column, bad));
                    }
                    None => wanted.push(row),
                }
            }
        }
        Ok([satisfying, wanted].map(|rows| rows.ranges().map(|[first, last]| first..last + 1).collect()))
    }

    /// The numbers of a column in the rows of a range, counted from 1.
    fn numbers(
        &self,
        column: &MatColumn,
        rows: &Range<usize>,
        selector: &ColumnSelector,
    ) -> Result<Column, InputError> {
        let range = column.start + rows.start - 1..column.start + rows.end - 1;
        if self.options.keep_text
            && let Some(index) = column.numbers.first_beyond_doubles(range.clone())
        {
            let text = column.numbers.text(index);
            return Err(self.error(column, BadNumber { index, text, problem: InputErrorKind::NotBinary64 }));
        }
        let reader = CellReader { selector, options: &self.options.table, meter: &self.meter };
        column.numbers.column(range, reader).map_err(|bad| self.error(column, bad))
    }

    /// The rows of these ranges, counted from 1.
    fn batch(&self, ranges: &[Range<usize>]) -> Result<Batch, InputError> {
        let mut columns = Vec::new();
        for (column, selector) in self.columns.iter().zip(self.selectors) {
            let mut parts = ranges.iter().map(|range| self.numbers(column, range, selector));
            let mut numbers = parts.next().transpose()?.unwrap_or_default();
            for part in parts {
                let part = part?;
                numbers.append(&part, 0..part.len());
            }
            columns.push(numbers);
        }
        let rows = || ranges.iter().cloned().flatten();
        let text = |column: &MatColumn, row: usize| column.numbers.text(column.start + row - 1);
        let keys = self.key.map(|key| {
            let mut keys = Pieces::<String>::default();
            rows().for_each(|row| keys.push(&text(key, row)));
            keys
        });
        let lines = self.options.keep_text.then(|| {
            let mut lines = Pieces::<Vec<u8>>::default();
            let columns = self.written();
            for row in rows() {
                lines.push(&csv_line(columns.iter().map(|column| text(column, row))));
            }
            lines
        });
        Ok(Batch {
            rows: ranges.iter().cloned().collect(),
            columns,
            keys,
            lines,
            fractions: Vec::new(),
            cells: Vec::new(),
            others: Vec::new(),
        })
    }

    fn error(&self, column: &MatColumn, bad: BadNumber) -> InputError {
        let ColumnPlace { position, name } = column.place.clone();
        let place = Place {
            row: Some(bad.index + 1 - column.start),
            column: Some((position, name)),
            text: Some(bad.text.into()),
            ..Place::default()
        };
        InputError::new(self.file, place, bad.problem)
    }
}
