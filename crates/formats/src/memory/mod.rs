//! Columns in memory, handed out as those of a file are.

mod numbers;

use std::ops::Range;

use boundfit_exact::{Column, Foreign, Rational, Reading};

use crate::cells::CellReader;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::{InputError, InputErrorKind, Place};
use crate::lacking::Lacking;
use crate::scan::check_rows;
use crate::scan::{Batch, Pieces, ScanOptions, Scanned, csv_line, readable_rows};
use crate::selection::{RowNumbers, between, in_batches};
use crate::threads;
use crate::wanted::WantedColumns;

pub(crate) use numbers::BadNumber;

/// A table whose columns are in memory. [`Source::of_table`](crate::Source::of_table) makes an input of it, which
/// [`scan`](crate::scan) hands out as it does a file's: what reads files reads it, and refuses the same things.
///
/// ```
/// use boundfit_exact::Rational;
/// use boundfit_formats::{ColumnSelector, MemoryNumbers, MemoryTable, Source, TableOptions, read_table};
///
/// let mut table = MemoryTable::default();
/// table.push("I", MemoryNumbers::Doubles(vec![0.1, 0.2]));
/// table.push("U", MemoryNumbers::Texts(vec!["1/3".into(), "0.7".into()]));
/// let columns = ["U", "I"].map(ColumnSelector::name_or_number);
/// let read = read_table(Source::of_table("resistor", table), &columns, &TableOptions::default())?;
/// assert_eq!(read.rows[0].numbers, [Rational::ratio(1, 3), Rational::ratio(1, 10)]);
/// # Ok::<(), boundfit_formats::InputError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct MemoryTable {
    names: Vec<Foreign>,
    columns: Vec<MemoryNumbers>,
}

/// The cells of a column in memory.
#[derive(Debug, Clone, PartialEq)]
pub enum MemoryNumbers {
    /// Doubles. Each stands, under [`Reading::Decimal`](boundfit_exact::Reading::Decimal), for the shortest decimal that is read
    /// as it, which is what a CSV of them shows (0.1 is 1/10); under [`Reading::Binary64`](boundfit_exact::Reading::Binary64) for
    /// itself. A NaN is a number that is missing.
    Doubles(Vec<f64>),
    /// Floats of 32 bits, like doubles.
    Floats(Vec<f32>),
    /// Integers; under the binary64 reading the doubles that are nearest to them.
    Integers(Vec<i64>),
    /// Exact numbers, whatever the reading is.
    Exact(Vec<Rational>),
    /// Texts of numbers, as they stand in the cells of a CSV with decimal points, or of keys. An empty text, or a word for
    /// that such as `NA`, is a number that is missing.
    Texts(Vec<String>),
}

impl MemoryTable {
    /// Adds a column at the right. The columns must be equally long by the time they are read.
    pub fn push(&mut self, name: impl Into<Foreign>, numbers: MemoryNumbers) {
        self.names.push(name.into());
        self.columns.push(numbers);
    }

    /// The columns with their names.
    pub fn columns(&self) -> impl Iterator<Item = (&Foreign, &MemoryNumbers)> {
        self.names.iter().zip(&self.columns)
    }

    /// The table as CSV with a header, UTF-8 with a line feed behind each line: under the reading that it is written for it reads
    /// back as the same numbers, in the same rows. What is missing is NaN, or an empty cell where the table has a text. Numbers of
    /// [`MemoryNumbers::Exact`] are fractions, of which the binary64 reading would take the nearest doubles.
    ///
    /// ```
    /// use boundfit_exact::Reading;
    /// use boundfit_formats::{MemoryNumbers, MemoryTable};
    ///
    /// let mut table = MemoryTable::default();
    /// table.push("#, x", MemoryNumbers::Floats(vec![0.1]));
    /// assert_eq!(table.to_csv(Reading::Decimal), b"\"#, x\"\n0.1\n");
    /// assert_eq!(table.to_csv(Reading::Binary64), b"\"#, x\"\n0.10000000149011612\n");
    /// ```
    pub fn to_csv(&self, reading: Reading) -> Vec<u8> {
        let mut text = csv_line(self.names.iter().map(|name| name.raw().to_owned()));
        text.push(b'\n');
        for row in 0..self.rows() {
            text.extend(csv_line(self.columns.iter().map(|column| column.text(row, reading))));
            text.push(b'\n');
        }
        text
    }

    fn rows(&self) -> usize {
        self.columns.first().map_or(0, MemoryNumbers::len)
    }

    /// Refuses columns that are not equally long.
    fn check_lengths(&self, file: &str) -> Result<(), InputError> {
        let described = |index: usize| {
            let name = self.names.get(index).cloned().unwrap_or_default();
            (name, self.columns.get(index).map_or(0, MemoryNumbers::len) as u64)
        };
        let rows = self.rows();
        match self.columns.iter().position(|column| column.len() != rows) {
            Some(other) => {
                let (first, other) = (described(0), described(other));
                Err(InputError::of_file(file, InputErrorKind::DifferentLengths { first, other }))
            }
            None => Ok(()),
        }
    }
}

/// Reads columns in memory as [`scan`](crate::scan) says. With [`ScanOptions::keep_text`], the rows are written as CSV of the
/// columns asked for, which reads back as the same numbers. There are no bytes to hash.
///
/// Exact. Cost: one pass.
///
/// # Errors
/// The first thing wrong, with the row and column; columns that are not equally long.
pub(crate) fn scan_memory<T: Send>(
    name: &str,
    table: &MemoryTable,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    work: impl Fn(Batch) -> T + Sync,
    mut take: impl FnMut(T),
) -> Result<Scanned, InputError> {
    let wanted = WantedColumns::new(name, &table.names, columns, options)?;
    let rows = table.rows();
    table.check_lengths(name)?;
    check_rows(name, rows, options)?;
    let part = Part { table, wanted: &wanted, before: 0, lines: &[] };
    let mut lacking = Lacking::default();
    let [satisfying, found] = part.with_values(rows, &mut lacking)?;
    let used = found.iter().map(ExactSizeIterator::len).sum();
    let ((), rows_missing) = lacking.settle(Ok(()), used, options)?;
    part.hand_out_rows(&satisfying, &found, rows, &work, &mut take)?;
    Ok(Scanned { header: table.names.clone(), ..wanted.scanned(rows, rows_missing) })
}

/// Some rows of a table, whose columns are in memory as far as they are wanted.
pub(crate) struct Part<'a> {
    pub(crate) table: &'a MemoryTable,
    pub(crate) wanted: &'a WantedColumns<'a>,
    /// How many rows of the table come before.
    pub(crate) before: usize,
    /// The lines on which the rows begin, in a table that has lines.
    pub(crate) lines: &'a [u64],
}

impl Part<'_> {
    /// Hands out so many rows, which are all that there are here; gives how many of them are wanted and lack nothing.
    ///
    /// # Errors
    /// The first cell that is no number, with its place.
    pub(crate) fn hand_out<T: Send>(
        &self,
        rows: usize,
        lacking: &mut Lacking,
        work: &(impl Fn(Batch) -> T + Sync),
        take: &mut impl FnMut(T),
    ) -> Result<usize, InputError> {
        let [satisfying, found] = self.with_values(rows, lacking)?;
        self.hand_out_rows(&satisfying, &found, rows, work, take)?;
        Ok(found.iter().map(ExactSizeIterator::len).sum())
    }

    /// Hands out the rows that were found, and those others of so many that are to be kept.
    fn hand_out_rows<T: Send>(
        &self,
        satisfying: &[Range<usize>],
        found: &[Range<usize>],
        rows: usize,
        work: &(impl Fn(Batch) -> T + Sync),
        take: &mut impl FnMut(T),
    ) -> Result<(), InputError> {
        let options = self.wanted.options;
        for group in in_batches(found).chunks(threads::count()) {
            let batch = |rows: Vec<Range<usize>>| self.batch(&rows).map(work);
            let done: Vec<Result<T, InputError>> = threads::map(group.to_vec(), batch);
            for result in done {
                take(result?);
            }
            if options.progress.as_deref().is_some_and(|progress| progress.is_cancelled()) {
                return Err(InputError::of_file(self.wanted.file, InputErrorKind::Interrupted));
            }
        }
        if options.table.keep_others && options.table.selects_rows() {
            let unwanted = between(satisfying, self.before + 1, self.before + rows + 1).into_iter();
            let others = unwanted.flat_map(|rows| readable_rows(rows, &|rows| self.batch(&[rows]))).collect();
            take(work(Batch { others, ..self.batch(&[])? }));
        }
        Ok(())
    }

    /// Where a row of the table, counted from 1, stands here.
    fn index(&self, row: usize) -> usize {
        row - 1 - self.before
    }

    fn cells(&self, place: &ColumnPlace) -> Option<&MemoryNumbers> {
        self.table.columns.get(place.position - 1)
    }

    /// Of so many rows, those that are asked for and whose numbers satisfy the conditions as far as they are there, and those of them that lack
    /// no number.
    fn with_values(&self, rows: usize, lacking: &mut Lacking) -> Result<[Vec<Range<usize>>; 2], InputError> {
        let rows = self.wanted.options.table.rows.among(self.before + 1, self.before + rows + 1);
        let has_missing = |place: &&ColumnPlace| self.cells(place).is_some_and(MemoryNumbers::has_missing);
        let needed: Vec<&ColumnPlace> = self.wanted.needed().filter(has_missing).collect();
        if needed.is_empty() && self.wanted.conditions.is_empty() {
            return Ok([rows.clone(), rows]);
        }
        let is_missing = |place: &ColumnPlace, row: usize| {
            self.cells(place).is_some_and(|cells| cells.is_missing(self.index(row)))
        };
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
                    Some(place) => lacking.notice(|| {
                        let text = self
                            .cells(place)
                            .map(|cells| cells.text(self.index(row), self.wanted.options.table.reading))
                            .unwrap_or_default();
                        self.error(
                            place,
                            BadNumber { index: self.index(row), text, problem: InputErrorKind::Null },
                        )
                    }),
                }
            }
        }
        Ok([satisfying, wanted].map(|rows| rows.ranges().map(|[first, last]| first..last + 1).collect()))
    }

    /// What a column takes from the rows of a range, counted from 1.
    fn numbers(
        &self,
        place: &ColumnPlace,
        rows: &Range<usize>,
        selector: &ColumnSelector,
    ) -> Result<Column, InputError> {
        let Some(cells) = self.cells(place) else { return Ok(Column::default()) };
        let reader = CellReader { selector, options: &self.wanted.options.table, meter: &self.wanted.meter };
        cells
            .column(self.index(rows.start)..self.index(rows.end), reader)
            .map_err(|bad| self.error(place, bad))
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
        let text = |place: &ColumnPlace, row: usize| {
            self.cells(place)
                .map(|cells| cells.text(self.index(row), self.wanted.options.table.reading))
                .unwrap_or_default()
        };
        let keys = self.wanted.key.as_ref().map(|key| {
            let mut keys = Pieces::<String>::default();
            match self.cells(key) {
                Some(MemoryNumbers::Texts(texts)) => {
                    for row in rows() {
                        keys.push(texts.get(self.index(row)).map_or("", |text| trimmed(text)));
                    }
                }
                _ => rows().for_each(|row| keys.push(&text(key, row))),
            }
            keys
        });
        let lines = self.wanted.options.keep_text.then(|| {
            let mut lines = Pieces::<Vec<u8>>::default();
            let places = self.wanted.written();
            rows().for_each(|row| lines.push(&csv_line(places.iter().map(|place| text(place, row)))));
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

    fn error(&self, place: &ColumnPlace, bad: BadNumber) -> InputError {
        let ColumnPlace { position, name } = place.clone();
        let line = self.lines.get(bad.index).copied();
        let place = Place {
            line,
            row: Some(self.before + bad.index + 1).filter(|_| line.is_none()),
            column: Some((position, name)),
            text: Some(bad.text.into()),
            ..Place::default()
        };
        InputError::new(self.wanted.file, place, bad.problem)
    }
}

/// A key without the spaces and tabs around it.
fn trimmed(key: &str) -> &str {
    key.trim_matches([' ', '\t'])
}
