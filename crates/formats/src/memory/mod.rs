//! Columns in memory, handed out as those of a file are.

mod numbers;
mod part;
mod texts;

use std::borrow::Cow;
use std::ops::Range;

use boundfit_exact::{Column, Foreign, Rational, Reading};

use crate::cells::CellReader;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::{InputError, InputErrorKind};
use crate::scan::check_rows;
use crate::scan::{Consumer, ScanOptions, Scanned, csv_line};
use crate::wanted::WantedColumns;

pub(crate) use numbers::BadNumber;
pub(crate) use part::{Cells, Part};
pub(crate) use texts::TextCells;

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

    /// Returns the table as CSV with a header, UTF-8 with a line feed behind each line. Read under the
    /// reading that it is written for, it gives the same numbers in the same rows. A missing value is NaN, or
    /// an empty cell where the table has a text. Numbers of [`MemoryNumbers::Exact`] are fractions, of which
    /// the binary64 reading would take the nearest doubles.
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

    fn cells(&self, place: &ColumnPlace) -> Option<&MemoryNumbers> {
        self.columns.get(place.position - 1)
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
pub(crate) fn scan_memory(
    name: &str,
    table: &MemoryTable,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    consumer: &mut Consumer,
) -> Result<Scanned, InputError> {
    let wanted = WantedColumns::new(name, &table.names, columns, options)?;
    let rows = table.rows();
    table.check_lengths(name)?;
    check_rows(name, rows, options)?;
    let scanned = Part { table, wanted: &wanted, before: 0, lines: &[] }.scan(rows, consumer)?;
    Ok(Scanned { header: table.names.clone(), ..scanned })
}

impl Cells<ColumnPlace> for MemoryTable {
    fn has_missing(&self, place: &ColumnPlace) -> bool {
        self.cells(place).is_some_and(MemoryNumbers::has_missing)
    }

    fn is_missing(&self, place: &ColumnPlace, index: usize) -> bool {
        self.cells(place).is_some_and(|cells| cells.is_missing(index))
    }

    fn text(&self, place: &ColumnPlace, index: usize, reading: Reading) -> String {
        self.cells(place).map(|cells| cells.text(index, reading)).unwrap_or_default()
    }

    fn key(&self, place: &ColumnPlace, index: usize, reading: Reading) -> Cow<'_, str> {
        match self.cells(place) {
            Some(MemoryNumbers::Texts(texts)) => TextCells(texts).key(index).into(),
            _ => self.text(place, index, reading).into(),
        }
    }

    fn has_equal(&self, place: &ColumnPlace, one: usize, other: usize) -> bool {
        matches!(self.cells(place), Some(MemoryNumbers::Integers(own)) if own.get(one) == own.get(other))
    }

    fn column(
        &self,
        place: &ColumnPlace,
        range: Range<usize>,
        reader: CellReader,
    ) -> Result<Column, BadNumber> {
        self.cells(place).map_or_else(|| Ok(Column::default()), |cells| cells.column(range, reader))
    }
}
