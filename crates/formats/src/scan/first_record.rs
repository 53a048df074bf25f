//! The first records of a table: which of them name columns and units, and where the columns are.

use boundfit_exact::Foreign;
use memchr::memchr_iter;

use crate::chunks::ChunkReader;
use crate::columns::{ColumnSelector, Header, Heading, decode};
use crate::error::{InputError, InputErrorKind};
use crate::records::{Records, Syntax};
use crate::selection::RowCondition;
use crate::table::check_columns;

use super::batch::ScanOptions;
use super::layout::{Layout, Shape};
use super::preamble::Preamble;
use super::values::{Mark, Numbers};

/// How far the rows have been read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Position {
    /// How many rows.
    pub(super) rows: usize,
    /// The line reached, from 1.
    pub(super) lines: u64,
    /// The line reached when line feeds alone are counted.
    pub(super) line_feeds: u64,
}

/// What the first records tell.
pub(super) struct FirstRecord<'a> {
    pub(super) layout: Layout<'a>,
    /// The header as it stands in the file, where text is kept.
    pub(super) header_line: Option<Vec<u8>>,
    /// Where the rows start.
    pub(super) position: Position,
}

/// After so many lines that are blank or comments, the second record is not looked for before the others are: they would all
/// have to be held.
const MOST_BLANK_LINES: u64 = 4096;

/// A record at the start of a table.
struct Found {
    cells: Vec<Vec<u8>>,
    text: Option<Vec<u8>>,
    line: u64,
    /// Whether the file ends within its quotes.
    is_within_quotes: bool,
}

/// A place in what a reader has not handed out.
#[derive(Clone, Copy)]
struct Cursor {
    at: usize,
    lines: u64,
}

impl<'a> FirstRecord<'a> {
    /// Reads what comes before the first data row, and has the reader pass over it.
    pub(super) fn read(
        file: &'a str,
        columns: &'a [ColumnSelector],
        options: &'a ScanOptions,
        reader: &mut ChunkReader,
    ) -> Result<Self, InputError> {
        let preamble = Preamble::read(reader, &options.table.dialect);
        let start = Start { file, options, syntax: preamble.syntax };
        let mut cursor = Cursor { at: 0, lines: preamble.lines };
        let mut behind = cursor;
        let Some(first) = start.record(reader, &mut behind, u64::MAX)? else {
            return Err(match reader.failure() {
                Some(problem) => {
                    let line = preamble.line_feeds + line_feeds(reader.pending());
                    InputError::of_line(file, line, problem)
                }
                None => InputError::of_file(file, InputErrorKind::Empty),
            });
        };
        // Whatever is wrong with it is so because it has swallowed the rows behind it.
        let explained = |error: InputError| match first.is_within_quotes {
            true => InputError::of_line(file, first.line, InputErrorKind::OpenQuote),
            false => error,
        };
        let commented = start.commented(&preamble, &first);
        let is_commented = commented.is_some();
        let mut heading = match commented {
            Some(names) => Heading::of_comment(names.into_iter().map(Foreign::from).collect(), first.line),
            None => start.heading(&first, columns).map_err(explained)?,
        };
        let has_header = heading.names.is_some() && !is_commented;
        let mut records_before = 0;
        let mut units = None;
        if has_header || options.table.dialect.units_row && !is_commented {
            (cursor, records_before) = (behind, 1);
            units = Some(&first).filter(|_| !has_header).map(|first| first.cells.clone());
        }
        if has_header && options.table.dialect.units_row {
            units = start.peek(reader, &mut cursor).map(|found| found.cells);
            records_before += usize::from(units.is_some());
        }
        let mut shape = Shape::of_first(&first.cells);
        if has_header {
            let row = start.peek(reader, &mut cursor.clone());
            let is_named = |row: &Found| {
                row.cells.len() == first.cells.len() + 1
                    && row.cells.last().is_some_and(|last| !last.trim_ascii().is_empty())
            };
            if row.is_some_and(|row| is_named(&row)) {
                heading = heading.after_row_names();
                shape = shape.with_row_names();
            }
        }
        let mut position = Position { rows: 0, lines: cursor.lines, line_feeds: preamble.line_feeds };
        position.line_feeds += line_feeds(reader.pending().get(..cursor.at).unwrap_or_default());
        reader.skip(cursor.at);
        let header_line =
            if is_commented { preamble.comment.clone() } else { first.text.clone().filter(|_| has_header) };
        let layout = Layout::new(file, &heading, shape, &preamble, columns, options);
        let layout = layout.map_err(|error| explained(no_delimiter(error, &preamble, &first.cells)))?;
        let layout = layout.with(reader.encoding(), records_before, units.as_deref());
        Ok(FirstRecord { layout, header_line: header_line.filter(|_| options.keep_text), position })
    }
}

/// The error, that says rather that there is no delimiter, if that is why a column is not there.
fn no_delimiter(error: InputError, preamble: &Preamble, cells: &[Vec<u8>]) -> InputError {
    match (error.kind, cells) {
        (InputErrorKind::UnknownColumn { wanted, .. }, [only]) if !preamble.has_delimiter => {
            let line = String::from_utf8_lossy(only).into_owned().into();
            InputError { kind: InputErrorKind::NoDelimiter { wanted, line }, ..error }
        }
        (kind, _) => InputError { kind, ..error },
    }
}

/// How the first records are read.
struct Start<'a> {
    file: &'a str,
    options: &'a ScanOptions,
    syntax: Syntax,
}

impl Start<'_> {
    /// The record at a place, which moves behind it; none at the end, where the bytes stop, and behind more blank lines and
    /// comments than that.
    fn record(
        &self,
        reader: &mut ChunkReader,
        cursor: &mut Cursor,
        most_lines: u64,
    ) -> Result<Option<Found>, InputError> {
        let longest = self.options.table.sizes.line;
        let mut records = Records::new(self.file, self.syntax, cursor.lines, longest, self.options.keep_text);
        let mut end = cursor.at;
        loop {
            let mut rest = reader.pending().get(end..).unwrap_or_default();
            let is_found = records.next(&mut rest)?;
            end = reader.pending().len() - rest.len();
            if is_found {
                break;
            }
            if !records.is_open() && records.line() - cursor.lines > most_lines {
                return Ok(None);
            }
            if reader.read_on() > 0 {
                continue;
            }
            if reader.has_failed() || !records.finish() {
                return Ok(None);
            }
            break;
        }
        let line = records.record_line();
        if line - cursor.lines > most_lines {
            return Ok(None);
        }
        // Cells are not copied where there are too many.
        check_columns(self.file, records.record().len(), line, &self.options.table.sizes).map_err(
            |error| {
                if records.is_within_quotes() {
                    InputError::of_line(self.file, line, InputErrorKind::OpenQuote)
                } else {
                    error
                }
            },
        )?;
        // A record ends with the first half of its line end.
        if reader.pending().get(..end).is_some_and(|record| record.ends_with(b"\r")) {
            if reader.pending().len() == end {
                reader.read_on();
            }
            end += usize::from(reader.pending().get(end) == Some(&b'\n'));
        }
        *cursor = Cursor { at: end, lines: records.line() };
        Ok(Some(Found {
            cells: records.record().cells().map(<[u8]>::to_vec).collect(),
            text: records.text().map(<[u8]>::to_vec),
            line: records.record_line(),
            is_within_quotes: records.is_within_quotes(),
        }))
    }

    /// The record at a place, if it can be read; what is wrong with it is said when its turn comes.
    fn peek(&self, reader: &mut ChunkReader, cursor: &mut Cursor) -> Option<Found> {
        self.record(reader, cursor, MOST_BLANK_LINES).unwrap_or_default()
    }

    /// The names in the comment right before the first record, if that is a row: it has as many cells, and a number.
    fn commented(&self, preamble: &Preamble, first: &Found) -> Option<Vec<String>> {
        if self.options.table.header == Header::Absent {
            return None;
        }
        let cells = preamble.commented_cells().filter(|cells| cells.len() == first.cells.len())?;
        let numbers = Numbers::new(&self.options.table);
        let is_number = |cell: &Vec<u8>| numbers.is_number(cell, Mark::Open);
        if !first.cells.iter().any(is_number) {
            return None;
        }
        let name = |cell: &Vec<u8>| decode(cell).ok().map(|name| name.trim().to_owned());
        cells.iter().map(name).collect()
    }

    /// What the first record says.
    fn heading(&self, first: &Found, columns: &[ColumnSelector]) -> Result<Heading, InputError> {
        let cells: Vec<&[u8]> = first.cells.iter().map(Vec::as_slice).collect();
        let table = &self.options.table;
        let conditions = table.conditions.iter().map(RowCondition::column);
        let others: Vec<&ColumnSelector> = self.options.key.iter().chain(conditions).collect();
        Heading::new(self.file, &cells, first.line, table.header, columns, &others)
    }
}

fn line_feeds(bytes: &[u8]) -> u64 {
    memchr_iter(b'\n', bytes).count() as u64
}
