//! Tables of numbers, and how they are to be read.

use boundfit_exact::{Limits, Rational, Reading};

use crate::columns::{ColumnPlace, ColumnSelector, Header, decode};
use crate::error::{InputError, InputErrorKind};
use crate::limits::SizeLimits;
use crate::roles::instead_of_number;

/// Data rows from `first` to `last`, counted from 1, both included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RowRange {
    first: usize,
    last: usize,
}

impl RowRange {
    /// The range, or `None` unless `1 ≤ first ≤ last`.
    pub fn new(first: usize, last: usize) -> Option<Self> {
        (1 <= first && first <= last).then_some(RowRange { first, last })
    }

    /// Those of the rows from `start` to before `end` that are in the range.
    pub(crate) fn among(&self, start: usize, end: usize) -> std::ops::Range<usize> {
        start.max(self.first)..end.min(self.last.saturating_add(1))
    }

    /// Those of the rows from `start` to before `end` that are not in the range: before it and behind it.
    pub(crate) fn not_among(&self, start: usize, end: usize) -> [std::ops::Range<usize>; 2] {
        [start..end.min(self.first), start.max(self.last.saturating_add(1))..end]
    }

    /// The first row.
    pub fn first(&self) -> usize {
        self.first
    }

    /// The last row.
    pub fn last(&self) -> usize {
        self.last
    }

    /// Whether a row is in the range.
    pub fn contains(&self, row: usize) -> bool {
        (self.first..=self.last).contains(&row)
    }
}

/// Where in delimited text the numbers asked for stand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextLayout {
    /// What separates cells.
    pub delimiter: u8,
    /// Whether the first record names the columns.
    pub has_header: bool,
    /// The numbers of the columns asked for, from 1, in the order asked.
    pub columns: Vec<usize>,
    /// The first and the last row wanted, from 1.
    pub rows: [usize; 2],
}

impl TextLayout {
    /// The layout of a table with so many data rows, at least one.
    pub(crate) fn new(
        delimiter: u8,
        has_header: bool,
        places: &[ColumnPlace],
        wanted: Option<RowRange>,
        rows_total: usize,
    ) -> Self {
        let columns = places.iter().map(|place| place.position).collect();
        let rows = wanted.map_or([1, rows_total], |RowRange { first, last }| [first, last]);
        TextLayout { delimiter, has_header, columns, rows }
    }
}

/// How a table is to be read.
#[derive(Debug, Clone, Default)]
pub struct TableOptions {
    /// Whether there is a header.
    pub header: Header,
    /// What separates cells; found out from the first line when `None`.
    pub delimiter: Option<u8>,
    /// The rows wanted; all when `None`.
    pub rows: Option<RowRange>,
    /// Whether rows that are not wanted are kept too, where their cells are numbers.
    pub keep_others: bool,
    /// How numbers are read.
    pub reading: Reading,
    /// What one number may ask for.
    pub limits: Limits,
    /// What the file as a whole may ask for.
    pub sizes: SizeLimits,
}

/// One data row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableRow {
    /// Number of the row among the data rows, from 1.
    pub row: usize,
    /// The numbers of the columns asked for, in the order asked.
    pub numbers: Vec<Rational>,
}

/// The columns asked for, as numbers.
#[derive(Debug, Clone)]
pub struct Table {
    /// The names of the columns asked for; `col1` and so on where there is none.
    pub names: Vec<String>,
    /// The rows wanted.
    pub rows: Vec<TableRow>,
    /// With `keep_others`, the rows that are not wanted but hold numbers.
    pub others: Vec<TableRow>,
    /// How many data rows the file has.
    pub rows_total: usize,
    /// Where the numbers stand; `None` unless the table is delimited text.
    pub layout: Option<TextLayout>,
    /// SHA-256 of the file's bytes, in hexadecimal.
    pub sha256: String,
}

/// The number in a cell of a column.
pub(crate) fn read_number(
    cell: &[u8],
    column: &ColumnSelector,
    options: &TableOptions,
) -> Result<Rational, InputErrorKind> {
    if let Some((mantissa, exponent)) = instead_of_number(cell, column)? {
        return Ok(Rational::scientific(mantissa, exponent));
    }
    let number = options.reading.read(decode(cell)?, &options.limits)?;
    if column.is_non_negative() && number.is_negative() {
        return Err(InputErrorKind::NegativeErrorBound);
    }
    Ok(number)
}

/// Refuses a table whose first record, on this line, has too many cells.
pub(crate) fn check_columns(
    file: &str,
    cells: usize,
    line: u64,
    sizes: &SizeLimits,
) -> Result<(), InputError> {
    if cells <= sizes.columns {
        return Ok(());
    }
    Err(InputError::of_line(file, line, InputErrorKind::TooManyColumns { limit: sizes.columns }))
}

/// Refuses a row that has not as many cells as the first one.
pub(crate) fn check_width(file: &str, line: u64, found: usize, expected: usize) -> Result<(), InputError> {
    if found == expected {
        return Ok(());
    }
    Err(InputError::of_line(file, line, InputErrorKind::RaggedRow { found, expected }))
}

/// Refuses a table without rows, or without all the rows that are wanted.
pub(crate) fn check_rows(file: &str, total: usize, wanted: Option<RowRange>) -> Result<(), InputError> {
    let problem = match wanted {
        _ if total == 0 => InputErrorKind::NoRows,
        Some(RowRange { first, last }) if last > total => {
            InputErrorKind::RowsBeyondEnd { first, last, total }
        }
        _ => return Ok(()),
    };
    Err(InputError::of_file(file, problem))
}
