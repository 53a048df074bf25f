//! Numeric columns of a delimited text table.

use std::io::{self, Cursor, Read};

use boundfit_exact::{Limits, Rational, Reading};
use csv::ByteRecord;

use crate::binary::{BinaryFormat, refuse_binary};
use crate::columns::{ColumnPlace, ColumnSelector, Header, Heading, decode};
use crate::error::{InputError, InputErrorKind, Place};
use crate::limits::SizeLimits;
use crate::mat::read_mat_table;
use crate::records::Records;
use crate::source::{Source, WatchedReader};
use crate::start::{detect_delimiter, first_line, refuse_other, without_mark};

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

    pub(crate) fn contains(&self, row: usize) -> bool {
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
    /// Line of the file on which it starts, from 1; 0 in a file without lines.
    pub line: u64,
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

/// Reads the columns asked for from comma-, semicolon- or tab-separated text, with or without a header, quotes, a byte
/// order mark, CRLF or blank lines. Blank lines are not rows. Only cells of wanted rows and columns need be numbers.
/// Of a MATLAB file, the vectors and columns of matrices are read; there, numbers are those that are stored.
///
/// Exact as `options.reading` says. Cost: one pass; memory for the wanted cells.
///
/// ```
/// use boundfit_exact::Rational;
/// use boundfit_formats::{ColumnSelector, Source, TableOptions, read_table};
///
/// let columns = ["U", "I"].map(ColumnSelector::name_or_number);
/// let text = Source::new("resistor.csv", "I;U\n0.1;1/3\n0.2;0.7\n".as_bytes());
/// let table = read_table(text, &columns, &TableOptions::default())?;
/// assert_eq!(table.rows[0].numbers, [Rational::ratio(1, 3), Rational::ratio(1, 10)]);
///
/// let text = Source::new("resistor.csv", "I;U\n0.1;o.3\n".as_bytes());
/// let error = read_table(text, &columns, &TableOptions::default()).unwrap_err();
/// assert!(error.to_string().starts_with("resistor.csv: line 2, column 2 (U): \"o.3\": not a number"));
/// # Ok::<(), boundfit_formats::InputError>(())
/// ```
///
/// # Errors
/// The first thing wrong, with its place.
pub fn read_table(
    source: Source,
    columns: &[ColumnSelector],
    options: &TableOptions,
) -> Result<Table, InputError> {
    let source = match source.into_binary(BinaryFormat::is_matlab) {
        Ok((name, table)) => return read_mat_table(&name, table, columns, options),
        Err(text) => text,
    };
    let (file, mut bytes) = source.watched(&options.sizes);
    let start = first_line(&mut bytes).map_err(|error| Source::stopped(&file, error))?;
    refuse_binary(&file, &start)?;
    refuse_other(&start).map_err(|problem| InputError::of_file(&file, problem))?;
    let start = without_mark(&start).to_vec();
    let delimiter = options.delimiter.unwrap_or_else(|| detect_delimiter(&start));
    let records = Records::new(Cursor::new(start).chain(bytes), delimiter, 1, options.sizes.line);
    TableReader { file, columns, options, delimiter, records }.read()
}

struct TableReader<'a> {
    file: String,
    columns: &'a [ColumnSelector],
    options: &'a TableOptions,
    delimiter: u8,
    records: Records<io::Chain<Cursor<Vec<u8>>, WatchedReader>>,
}

impl TableReader<'_> {
    fn read(mut self) -> Result<Table, InputError> {
        let mut record = ByteRecord::new();
        if !self.records.next(&self.file, &mut record)? {
            return Err(InputError::of_file(&self.file, InputErrorKind::Empty));
        }
        let line = self.records.line();
        check_columns(&self.file, &record, line, &self.options.sizes)?;
        let heading = Heading::new(&self.file, &record, line, self.options.header, self.columns, None)?;
        let places = self.columns.iter().map(|column| heading.find(&self.file, column));
        let places = places.collect::<Result<Vec<_>, _>>()?;
        let mut table = Table {
            names: places.iter().map(ColumnPlace::title).collect(),
            rows: Vec::new(),
            others: Vec::new(),
            rows_total: 0,
            layout: None,
            sha256: String::new(),
        };
        let mut more = heading.names.is_none() || self.records.next(&self.file, &mut record)?;
        while more {
            let line = self.records.line();
            check_width(&self.file, line, record.len(), heading.width)?;
            table.rows_total += 1;
            let wanted = self.options.rows.is_none_or(|rows| rows.contains(table.rows_total));
            if wanted || self.options.keep_others {
                match self.numbers(&record, &places) {
                    Ok(numbers) => {
                        let row = TableRow { row: table.rows_total, line, numbers };
                        if wanted { table.rows.push(row) } else { table.others.push(row) }
                    }
                    Err(error) if wanted => return Err(error),
                    Err(_) => {}
                }
            }
            more = self.records.next(&self.file, &mut record)?;
        }
        check_rows(&self.file, table.rows_total, self.options.rows)?;
        let has_header = heading.names.is_some();
        let layout =
            TextLayout::new(self.delimiter, has_header, &places, self.options.rows, table.rows_total);
        table.layout = Some(layout);
        table.sha256 = self.records.input().get_ref().1.sha256();
        Ok(table)
    }

    /// The numbers of a record in the columns asked for.
    fn numbers(&self, record: &ByteRecord, places: &[ColumnPlace]) -> Result<Vec<Rational>, InputError> {
        let read = |(place, column): (&ColumnPlace, &ColumnSelector)| {
            let cell = &record[place.position - 1];
            read_number(cell, column, self.options)
                .map_err(|problem| place.error(&self.file, self.records.line(), cell, problem))
        };
        places.iter().zip(self.columns).map(read).collect()
    }
}

/// The number in a cell of a column.
pub(crate) fn read_number(
    cell: &[u8],
    column: &ColumnSelector,
    options: &TableOptions,
) -> Result<Rational, InputErrorKind> {
    let number = options.reading.read(decode(cell)?, &options.limits)?;
    if column.is_non_negative() && number.is_negative() {
        return Err(InputErrorKind::NegativeErrorBound);
    }
    Ok(number)
}

/// Refuses a table whose first record, on this line, has too many cells.
pub(crate) fn check_columns(
    file: &str,
    first: &ByteRecord,
    line: u64,
    sizes: &SizeLimits,
) -> Result<(), InputError> {
    if first.len() <= sizes.columns {
        return Ok(());
    }
    let place = Place { line: Some(line), ..Place::default() };
    Err(InputError::new(file, place, InputErrorKind::TooManyColumns { limit: sizes.columns }))
}

/// Refuses a row that has not as many cells as the first one.
pub(crate) fn check_width(file: &str, line: u64, found: usize, expected: usize) -> Result<(), InputError> {
    if found == expected {
        return Ok(());
    }
    let place = Place { line: Some(line), ..Place::default() };
    Err(InputError::new(file, place, InputErrorKind::RaggedRow { found, expected }))
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
