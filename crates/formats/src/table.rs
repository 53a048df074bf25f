//! Numeric columns of a delimited text table.

use std::io::{self, Cursor, Read};

use boundfit_exact::{Limits, Rational, Reading};
use csv::{ByteRecord, ReaderBuilder};

use crate::error::{InputError, Place, Problem};
use crate::lines::LineCounter;
use crate::source::{Source, WatchedReader};

/// How a column is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnSelector {
    text: String,
    /// Where the column is when there is no header, from 1.
    position: Option<usize>,
    non_negative: bool,
}

impl ColumnSelector {
    /// A header name, or a number from 1.
    pub fn name_or_number(text: &str) -> Self {
        let mut selector =
            ColumnSelector { text: text.trim().to_owned(), position: None, non_negative: false };
        if selector.is_number() {
            selector.position = Some(selector.text.parse().unwrap_or(usize::MAX));
        }
        selector
    }

    /// A header name, or a position from 1 in a table without a header.
    pub fn name_at(name: &str, position: usize) -> Self {
        ColumnSelector { text: name.to_owned(), position: Some(position), non_negative: false }
    }

    /// The same column, in which every number must be at least 0.
    pub fn non_negative(self) -> Self {
        ColumnSelector { non_negative: true, ..self }
    }

    fn is_number(&self) -> bool {
        !self.text.is_empty() && self.text.bytes().all(|byte| byte.is_ascii_digit())
    }
}

/// Whether the first row names the columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Header {
    /// It does when a column is asked for by name, or when the cells asked for look like names.
    #[default]
    Auto,
    /// It does.
    Present,
    /// It does not.
    Absent,
}

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

    fn contains(&self, row: usize) -> bool {
        (self.first..=self.last).contains(&row)
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
}

/// One data row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableRow {
    /// Number of the row among the data rows, from 1.
    pub row: usize,
    /// Line of the file on which it starts, from 1.
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
    /// SHA-256 of the file's bytes, in hexadecimal.
    pub sha256: String,
}

/// Reads the columns asked for from comma-, semicolon- or tab-separated text, with or without a header, quotes, a byte
/// order mark, CRLF or blank lines. Blank lines are not rows. Only cells of wanted rows and columns need be numbers.
///
/// Exact as `options.reading` says. Cost: one pass; memory for the wanted cells.
///
/// # Errors
/// The first thing wrong, with its place.
pub fn read_table(
    source: Source,
    columns: &[ColumnSelector],
    options: &TableOptions,
) -> Result<Table, InputError> {
    let (file, mut bytes) = source.watched();
    let start = first_line(&mut bytes).map_err(|error| {
        let place = Place { line: Some(bytes.line()), ..Place::default() };
        Source::error(&file, place, bytes.problem(error))
    })?;
    if start.starts_with(&[0xff, 0xfe]) || start.starts_with(&[0xfe, 0xff]) {
        return Err(Source::error(&file, Place::default(), Problem::Utf16));
    }
    let delimiter = options.delimiter.unwrap_or_else(|| detect_delimiter(&start));
    let input = LineCounter::new(Cursor::new(start).chain(bytes));
    let reader =
        ReaderBuilder::new().has_headers(false).flexible(true).delimiter(delimiter).from_reader(input);
    TableReader { file, columns, options, reader, line: 1 }.read()
}

struct TableReader<'a> {
    file: String,
    columns: &'a [ColumnSelector],
    options: &'a TableOptions,
    reader: csv::Reader<LineCounter<io::Chain<Cursor<Vec<u8>>, WatchedReader>>>,
    /// The line on which the current record starts.
    line: u64,
}

impl TableReader<'_> {
    fn read(mut self) -> Result<Table, InputError> {
        let mut record = ByteRecord::new();
        if !self.next(&mut record)? {
            return Err(self.error(Place::default(), Problem::Empty));
        }
        let width = record.len();
        let names = self.header_names(&record)?;
        let has_header = names.is_some();
        let positions = self.resolve(names.as_deref(), width, self.line)?;
        let name_of = |position: &usize| {
            let given =
                names.as_ref().map(|names| names[position - 1].clone()).filter(|name| !name.is_empty());
            given.unwrap_or_else(|| format!("col{position}"))
        };
        let mut table = Table {
            names: positions.iter().map(name_of).collect(),
            rows: Vec::new(),
            others: Vec::new(),
            rows_total: 0,
            sha256: String::new(),
        };
        let places: Vec<(usize, Option<String>)> = positions
            .iter()
            .map(|&position| (position, names.as_ref().map(|names| names[position - 1].clone())))
            .collect();
        let mut more = !has_header || self.next(&mut record)?;
        while more {
            if record.len() != width {
                let place = Place { line: Some(self.line), ..Place::default() };
                return Err(self.error(place, Problem::RaggedRow { found: record.len(), expected: width }));
            }
            table.rows_total += 1;
            if self.options.rows.is_none_or(|rows| rows.contains(table.rows_total)) {
                let numbers = self.numbers(&record, &places)?;
                table.rows.push(TableRow { row: table.rows_total, line: self.line, numbers });
            } else if self.options.keep_others
                && let Ok(numbers) = self.numbers(&record, &places)
            {
                table.others.push(TableRow { row: table.rows_total, line: self.line, numbers });
            }
            more = self.next(&mut record)?;
        }
        if table.rows_total == 0 {
            return Err(self.error(Place::default(), Problem::NoRows));
        }
        if let Some(RowRange { first, last }) = self.options.rows
            && last > table.rows_total
        {
            let problem = Problem::RowsBeyondEnd { first, last, total: table.rows_total };
            return Err(self.error(Place::default(), problem));
        }
        table.sha256 = self.reader.get_ref().get_ref().get_ref().1.sha256();
        Ok(table)
    }

    /// Reads the next record that is not blank.
    fn next(&mut self, record: &mut ByteRecord) -> Result<bool, InputError> {
        loop {
            match self.reader.read_byte_record(record) {
                Ok(true) if record.len() == 1 && record[0].trim_ascii().is_empty() => {}
                Ok(more) => {
                    let start = record.position().map_or(0, csv::Position::byte);
                    self.line = self.reader.get_mut().line_at(start);
                    return Ok(more);
                }
                Err(error) => {
                    let bytes = &self.reader.get_ref().get_ref().get_ref().1;
                    let place = Place { line: Some(bytes.line()), ..Place::default() };
                    let problem = bytes.problem(io::Error::from(error));
                    return Err(self.error(place, problem));
                }
            }
        }
    }

    /// The numbers of a record in the columns asked for.
    fn numbers(
        &self,
        record: &ByteRecord,
        places: &[(usize, Option<String>)],
    ) -> Result<Vec<Rational>, InputError> {
        let mut numbers = Vec::with_capacity(places.len());
        for (place, column) in places.iter().zip(self.columns) {
            let cell = &record[place.0 - 1];
            let fail = |problem| {
                let text = String::from_utf8_lossy(cell).into_owned();
                self.error(
                    Place { line: Some(self.line), column: Some(place.clone()), text: Some(text) },
                    problem,
                )
            };
            let text = decode(cell).map_err(fail)?;
            let number = self.options.reading.read(text, &self.options.limits);
            let number = number.map_err(|error| fail(error.into()))?;
            if column.non_negative && number.is_negative() {
                return Err(fail(Problem::NegativeErrorBound));
            }
            numbers.push(number);
        }
        Ok(numbers)
    }

    /// The names in the first record, when it is a header.
    fn header_names(&self, record: &ByteRecord) -> Result<Option<Vec<String>>, InputError> {
        let is_header = match self.options.header {
            Header::Present => true,
            Header::Absent => false,
            Header::Auto => {
                let by_name = self.columns.iter().any(|column| column.position.is_none());
                let cells: Vec<&[u8]> = self
                    .columns
                    .iter()
                    .filter_map(|column| record.get(column.position?.checked_sub(1)?))
                    .collect();
                by_name || (!cells.is_empty() && cells.iter().all(|cell| looks_like_name(cell)))
            }
        };
        if !is_header {
            return Ok(None);
        }
        let names = record.iter().enumerate().map(|(index, cell)| {
            decode(cell).map(|name| name.trim().to_owned()).map_err(|problem| {
                let text = String::from_utf8_lossy(cell).into_owned();
                let column = Some((index + 1, None));
                self.error(Place { line: Some(self.line), column, text: Some(text) }, problem)
            })
        });
        names.collect::<Result<_, _>>().map(Some)
    }

    /// The positions, from 1, of the columns asked for.
    fn resolve(&self, names: Option<&[String]>, width: usize, line: u64) -> Result<Vec<usize>, InputError> {
        let find = |column: &ColumnSelector| {
            let fail = |problem| self.error(Place { line: Some(line), ..Place::default() }, problem);
            let mut matches =
                names.unwrap_or_default().iter().enumerate().filter(|(_, name)| **name == column.text);
            match (matches.next(), matches.next()) {
                (Some(_), Some(_)) => Err(fail(Problem::AmbiguousColumn { wanted: column.text.clone() })),
                (Some((index, _)), None) => Ok(index + 1),
                (None, _) => column
                    .position
                    .filter(|position| (1..=width).contains(position))
                    .filter(|_| names.is_none() || column.is_number())
                    .ok_or_else(|| {
                        let numbered = column.position.is_none() || column.is_number();
                        fail(Problem::UnknownColumn {
                            wanted: column.text.clone(),
                            available: names.unwrap_or_default().to_vec(),
                            numbers: numbered.then_some(width),
                        })
                    }),
            }
        };
        self.columns.iter().map(find).collect()
    }

    fn error(&self, place: Place, problem: Problem) -> InputError {
        Source::error(&self.file, place, problem)
    }
}

fn decode(cell: &[u8]) -> Result<&str, Problem> {
    std::str::from_utf8(cell)
        .map_err(|error| Problem::NotUtf8 { position: error.valid_up_to(), unit: "cell" })
}

/// Whether a cell of the first row is a name rather than a number, a failed number or a missing one.
fn looks_like_name(cell: &[u8]) -> bool {
    let text = String::from_utf8_lossy(cell);
    let text = text.trim();
    let missing = ["nan", "inf", "infinity", "na", "n/a", "null", "none"];
    text.starts_with(|first: char| first.is_alphabetic() || first == '_')
        && !missing.contains(&text.to_lowercase().as_str())
}

/// Everything up to the end of the first line that is not blank, without a byte order mark.
fn first_line(bytes: &mut impl Read) -> io::Result<Vec<u8>> {
    let mut start = Vec::new();
    let mut buffer = [0; 4096];
    let mut text_began = false;
    loop {
        let count = match bytes.read(&mut buffer) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            result => result?,
        };
        start.extend_from_slice(&buffer[..count]);
        let fresh = if text_began { &buffer[..count] } else { buffer[..count].trim_ascii_start() };
        text_began |= !fresh.is_empty();
        if count == 0 || fresh.contains(&b'\n') {
            let mark = if start.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
            return Ok(start.split_off(mark));
        }
    }
}

/// The separator of the first line that is not blank: a semicolon or tab if there is one outside quotes, else a comma.
fn detect_delimiter(start: &[u8]) -> u8 {
    let line = start.trim_ascii_start().split(|&byte| byte == b'\n').next().unwrap_or_default();
    let mut quoted = false;
    let mut seen = [false; 2];
    for &byte in line {
        match byte {
            b'"' => quoted = !quoted,
            b';' if !quoted => seen[0] = true,
            b'\t' if !quoted => seen[1] = true,
            _ => {}
        }
    }
    match seen {
        [true, _] => b';',
        [_, true] => b'\t',
        _ => b',',
    }
}
