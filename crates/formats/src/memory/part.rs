//! Rows of columns in memory, in batches.

use std::borrow::Cow;
use std::ops::Range;

use boundfit_exact::{Column, Reading};

use super::numbers::BadNumber;
use crate::cells::CellReader;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::{InputError, InputErrorKind, Place};
use crate::lacking::Lacking;
use crate::scan::{Batch, Consumer, Pieces, RowKeys, Scanned, csv_line, readable_rows};
use crate::selection::{RowNumbers, between, in_batches};
use crate::threads;
use crate::wanted::{Placed, WantedColumns};

/// The cells of columns, by the index of their row from 0.
pub(crate) trait Cells<C>: Sync {
    /// Returns true if a cell of a column may have no number.
    fn has_missing(&self, column: &C) -> bool;

    /// Returns true if this cell has no number.
    fn is_missing(&self, column: &C, index: usize) -> bool;

    /// A cell as a CSV would show it.
    fn text(&self, column: &C, index: usize, reading: Reading) -> String;

    /// A cell as the key of its row.
    fn key(&self, column: &C, index: usize, reading: Reading) -> Cow<'_, str> {
        self.text(column, index, reading).into()
    }

    /// Returns whether two cells are equal, if that is known sooner than their texts.
    fn has_equal(&self, _column: &C, _one: usize, _other: usize) -> bool {
        false
    }

    /// Reads the values that a column takes from the cells in a range.
    fn column(&self, column: &C, range: Range<usize>, reader: CellReader) -> Result<Column, BadNumber>;
}

/// Some rows of a table, whose columns are in memory as far as they are wanted.
pub(crate) struct Part<'a, T, C = ColumnPlace> {
    pub(crate) table: &'a T,
    pub(crate) wanted: &'a WantedColumns<'a, C>,
    /// The number of rows of the table before this part.
    pub(crate) before: usize,
    /// The lines on which the rows begin, in a table that has lines.
    pub(crate) lines: &'a [u64],
}

impl<T: Cells<C>, C: Placed + Sync> Part<'_, T, C> {
    /// Hands out so many rows, which are all that there are.
    ///
    /// # Errors
    /// The first cell that is no number, with its place.
    pub(crate) fn scan(&self, rows: usize, consumer: &mut Consumer) -> Result<Scanned, InputError> {
        let mut lacking = Lacking::default();
        let [satisfying, found] = self.with_values(rows, &mut lacking)?;
        let used = found.iter().map(ExactSizeIterator::len).sum();
        let ((), rows_missing) = lacking.settle(Ok(()), used, self.wanted.options)?;
        self.hand_out_rows(&satisfying, &found, rows, consumer)?;
        Ok(self.wanted.scanned(rows, rows_missing))
    }

    /// Hands out so many rows, which are all that there are here; gives how many of them are wanted and lack nothing.
    ///
    /// # Errors
    /// The first cell that is no number, with its place.
    pub(crate) fn hand_out(
        &self,
        rows: usize,
        lacking: &mut Lacking,
        consumer: &mut Consumer,
    ) -> Result<usize, InputError> {
        let [satisfying, found] = self.with_values(rows, lacking)?;
        self.hand_out_rows(&satisfying, &found, rows, consumer)?;
        Ok(found.iter().map(ExactSizeIterator::len).sum())
    }

    /// Hands out the rows that were found, and those others of so many that are to be kept.
    fn hand_out_rows(
        &self,
        satisfying: &[Range<usize>],
        found: &[Range<usize>],
        rows: usize,
        consumer: &mut Consumer,
    ) -> Result<(), InputError> {
        let options = self.wanted.options;
        for group in in_batches(found).chunks(threads::count()) {
            let worker = consumer.worker;
            let made = |rows: Vec<Range<usize>>| self.batch(&rows).map(|batch| worker.work(batch));
            for made in threads::map(group.to_vec(), made) {
                consumer.take(made?);
            }
            if options.progress.as_deref().is_some_and(|progress| progress.is_cancelled()) {
                return Err(InputError::of_file(self.wanted.file, InputErrorKind::Interrupted));
            }
        }
        if let Some(key) = self.wanted.key.as_ref().filter(|_| satisfying != found) {
            let end = self.before + rows + 1;
            let is_satisfying = |row: &usize| satisfying.iter().any(|range| range.contains(row));
            let left_out = between(found, self.before + 1, end).into_iter().flatten().filter(is_satisfying);
            let text = |row| self.table.key(key, self.index(row), options.table.reading).into();
            let mut keys_missing: Vec<String> = left_out.map(text).collect();
            keys_missing.dedup();
            consumer.consume(Batch { keys_missing, ..self.batch(&[])? });
        }
        if options.table.keep_others && options.table.selects_rows() {
            let unwanted = between(satisfying, self.before + 1, self.before + rows + 1).into_iter();
            let others = unwanted.flat_map(|rows| readable_rows(rows, &|rows| self.batch(&[rows]))).collect();
            consumer.consume(Batch { others, ..self.batch(&[])? });
        }
        Ok(())
    }

    /// Returns the place here of a row of the table, counted from 1.
    fn index(&self, row: usize) -> usize {
        row - 1 - self.before
    }

    fn text(&self, column: &C, row: usize) -> String {
        self.table.text(column, self.index(row), self.wanted.options.table.reading)
    }

    /// Returns the asked rows whose numbers, as far as they have some, satisfy the conditions, and the ones
    /// among them that lack no number.
    fn with_values(&self, rows: usize, lacking: &mut Lacking) -> Result<[Vec<Range<usize>>; 2], InputError> {
        let rows = self.wanted.options.table.rows.among(self.before + 1, self.before + rows + 1);
        let needed: Vec<&C> = self.wanted.needed().filter(|column| self.table.has_missing(column)).collect();
        if needed.is_empty() && self.wanted.conditions.is_empty() {
            return Ok([rows.clone(), rows]);
        }
        let is_missing = |column: &C, row: usize| self.table.is_missing(column, self.index(row));
        let [mut satisfying, mut wanted] = [RowNumbers::default(), RowNumbers::default()];
        for range in rows {
            let numbers = self.wanted.conditions.iter().map(|(place, condition)| {
                self.numbers(place, &range, &condition.column().clone().optional())
            });
            let numbers: Vec<Column> = numbers.collect::<Result<_, _>>()?;
            for row in range.clone() {
                let satisfies =
                    self.wanted.conditions.iter().zip(&numbers).all(|((place, condition), numbers)| {
                        is_missing(place, row) || condition.holds(&numbers.get(row - range.start))
                    });
                if !satisfies {
                    continue;
                }
                satisfying.push(row);
                match needed.iter().find(|place| is_missing(place, row)) {
                    None => wanted.push(row),
                    Some(column) => lacking.notice(|| {
                        let (index, text) = (self.index(row), self.text(column, row));
                        self.error(column, BadNumber { index, text, problem: InputErrorKind::Null })
                    }),
                }
            }
        }
        Ok([satisfying, wanted].map(|rows| rows.ranges().map(|[first, last]| first..last + 1).collect()))
    }

    /// Reads the values that a column takes from the rows of a range, counted from 1.
    fn numbers(
        &self,
        column: &C,
        rows: &Range<usize>,
        selector: &ColumnSelector,
    ) -> Result<Column, InputError> {
        let reader = CellReader { selector, options: &self.wanted.options.table, meter: &self.wanted.meter };
        let range = self.index(rows.start)..self.index(rows.end);
        self.table.column(column, range, reader).map_err(|bad| self.error(column, bad))
    }

    /// The rows of these ranges, counted from 1.
    fn batch(&self, ranges: &[Range<usize>]) -> Result<Batch, InputError> {
        let mut columns = Vec::new();
        for (place, selector) in self.wanted.places.iter().zip(self.wanted.selectors) {
            let mut parts = ranges.iter().map(|range| self.numbers(place, range, selector));
            let mut numbers = parts.next().transpose()?.unwrap_or_default();
            for part in parts {
                let part = part?;
                numbers.append(&part, 0..part.len());
            }
            columns.push(numbers);
        }
        let rows = || ranges.iter().cloned().flatten();
        let keys = self.wanted.key.as_ref().map(|key| {
            let mut keys = RowKeys::default();
            let reading = self.wanted.options.table.reading;
            let mut before = None;
            for index in rows().map(|row| self.index(row)) {
                let known = before.filter(|(before, _)| self.table.has_equal(key, *before, index));
                let text = match known {
                    Some((_, text)) => keys.push_known(text),
                    None => keys.push(&self.table.key(key, index, reading)),
                };
                before = Some((index, text));
            }
            keys
        });
        let lines = self.wanted.options.keep_text.then(|| {
            let mut lines = Pieces::<Vec<u8>>::default();
            let columns = self.wanted.written();
            let line = |row| csv_line(columns.iter().map(|column| self.text(column, row)));
            rows().for_each(|row| lines.push(&line(row)));
            lines
        });
        Ok(Batch {
            rows: ranges.iter().cloned().collect(),
            columns,
            keys,
            keys_missing: Vec::new(),
            lines,
            fractions: Vec::new(),
            cells: Vec::new(),
            others: Vec::new(),
        })
    }

    fn error(&self, column: &C, bad: BadNumber) -> InputError {
        let ColumnPlace { position, name } = column.place().clone();
        let line = self.lines.get(bad.index).copied();
        // Several records may stand on one line.
        let neighbours = [bad.index.checked_sub(1), bad.index.checked_add(1)];
        let is_shared = neighbours.into_iter().flatten().any(|other| self.lines.get(other).copied() == line);
        let place = Place {
            line,
            row: Some(self.before + bad.index + 1).filter(|_| line.is_none() || is_shared),
            column: Some((position, name)),
            text: Some(bad.text.into()),
            ..Place::default()
        };
        InputError::new(self.wanted.file, place, bad.problem)
    }
}
