//! The first records of a table: which of them name columns and units, and where the columns are.

use boundfit_exact::Foreign;
use memchr::memchr_iter;

use crate::chunks::ChunkReader;
use crate::columns::{ColumnSelector, Header, decode};
use crate::dialect::CommentMark;
use crate::error::{InputError, InputErrorKind};
use crate::heading::{AskedColumns, CellLook, Heading};
use crate::notes::HeaderNote;
use crate::records::{Records, Syntax};
use crate::selection::RowCondition;
use crate::table::check_columns;

use super::batch::ScanOptions;
use super::layout::{Layout, Shape};
use super::preamble::{Preamble, USUAL_MARKS};
use super::values::{Mark, Numbers};

/// A position in the table: how far the rows have been read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Position {
    /// The number of rows.
    pub(super) rows: usize,
    /// The line reached, from 1.
    pub(super) lines: u64,
    /// The line reached when line feeds alone are counted.
    pub(super) line_feeds: u64,
}

/// The information in the first record.
pub(super) struct FirstRecord<'a> {
    pub(super) layout: Layout<'a>,
    /// The header as it stands in the file, where text is kept.
    pub(super) header_line: Option<Vec<u8>>,
    /// The position where the rows start.
    pub(super) position: Position,
}

/// The most blank lines or comments up to which the second record is looked for before the others: all of
/// them would have to be held.
const MOST_BLANK_LINES: u64 = 4096;

/// The most rows, and bytes of them, that are looked at to see if numbers stand below the first record.
const MOST_ROWS_BELOW: usize = 16;
const MOST_BYTES_BELOW: usize = 1 << 16;

/// A record at the start of a table.
struct Found {
    cells: Vec<Vec<u8>>,
    text: Option<Vec<u8>>,
    line: u64,
    /// `true` if the file ends within its quotes.
    is_within_quotes: bool,
}

/// A place in what a reader has not handed out.
#[derive(Clone, Copy)]
struct Cursor {
    at: usize,
    lines: u64,
}

impl<'a> FirstRecord<'a> {
    /// Reads what comes before the first data row, and has the reader pass over it. Where a block was found, the reader is on these
    /// lines, and the lines that are none of the table are behind it.
    pub(super) fn read(
        file: &'a str,
        columns: &'a [ColumnSelector],
        options: &'a ScanOptions,
        reader: &mut ChunkReader,
        start: Option<[u64; 2]>,
    ) -> Result<Self, InputError> {
        let names = wanted_names(columns, options);
        let preamble = Preamble::read(reader, &options.table.dialect, &names, start);
        let start = Start { file, options, syntax: preamble.syntax };
        let mut cursor = Cursor { at: 0, lines: preamble.lines };
        let mut behind = cursor;
        let Some(first) = start.record(reader, &mut behind, u64::MAX)? else {
            return Err(match reader.failure() {
                Some(problem) => {
                    let line = preamble.line_feeds + line_feeds(reader.pending());
                    InputError::of_line(file, line, problem)
                }
                // A sheet without cells has an error of its own.
                None => InputError::of_file(
                    file,
                    match options.table.dialect.skip_lines {
                        lines @ 1.. if reader.total() > 0 => InputErrorKind::NothingBehind(lines),
                        _ => InputErrorKind::Empty,
                    },
                ),
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
            None => {
                let looks = start.looks(&first, columns, reader, behind);
                start.heading(&first, columns, &looks).map_err(explained)?
            }
        };
        let has_header = heading.names.is_some() && !is_commented;
        let mut records_before = usize::from(has_header);
        if has_header {
            cursor = behind;
        }
        let before_units = (cursor, records_before);
        let mut units = None;
        if options.table.dialect.units_row && !is_commented {
            units = start.peek(reader, &mut cursor).map(|found| (found.cells, found.line));
            records_before += usize::from(units.is_some());
        }
        let is_marked = has_header && preamble.is_marked && heading.take_mark();
        let mut shape = Shape::of_first(&first.cells);
        let mut has_row_names = false;
        if has_header {
            let row = start.peek(reader, &mut cursor.clone());
            let is_named = |row: &Found| {
                row.cells.len() == first.cells.len() + 1
                    && row.cells.last().is_some_and(|last| !last.trim_ascii().is_empty())
            };
            if row.is_some_and(|row| is_named(&row)) {
                heading = heading.after_row_names();
                shape = shape.with_row_names();
                has_row_names = true;
            }
        }
        let header_line =
            if is_commented { preamble.comment.clone() } else { first.text.clone().filter(|_| has_header) };
        let layout = Layout::new(file, &heading, shape, &preamble, columns, options);
        let layout = layout.map_err(|error| explained(no_delimiter(error, &preamble, &first.cells)))?;
        if let Some((cells, line)) = &units
            && let Err(problem) = layout.check_units(cells)
        {
            // The row of units was said for the first table.
            if !options.table.is_beside {
                return Err(InputError::of_line(file, *line, problem));
            }
            ((cursor, records_before), units) = (before_units, None);
        }
        let mut position = Position { rows: 0, lines: cursor.lines, line_feeds: preamble.line_feeds };
        position.line_feeds += line_feeds(reader.pending().get(..cursor.at).unwrap_or_default());
        reader.skip(cursor.at);
        let (units, units_line) = units.unzip();
        let mut layout = layout.with(reader.encoding(), records_before, units.as_deref());
        layout.names_in = HeaderNote {
            line: if is_commented { Some(preamble.comment_line) } else { has_header.then_some(first.line) },
            is_comment: is_commented,
            is_open: heading.is_open,
            has_row_names,
            units: units_line,
            ..HeaderNote::default()
        };
        layout.is_header_marked = is_marked;
        layout.skipped.lines = preamble.unasked;
        layout.title = preamble.title();
        layout.first_line = first.line;
        Ok(FirstRecord { layout, header_line: header_line.filter(|_| options.keep_text), position })
    }
}

/// The names that are asked for, where only they can tell which line is the header: more than one of them.
fn wanted_names<'a>(columns: &'a [ColumnSelector], options: &ScanOptions) -> Vec<&'a str> {
    let is_telling = options.table.header != Header::Absent && columns.iter().all(ColumnSelector::is_name);
    let mut names: Vec<&str> = Vec::new();
    for column in columns.iter().filter(|_| is_telling) {
        if !names.contains(&column.text().raw()) {
            names.push(column.text().raw());
        }
    }
    if names.len() < 2 { Vec::new() } else { names }
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

/// The reader of the first records.
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
        let sizes = &self.options.table.sizes;
        let mut records = Records::new(self.file, self.syntax, cursor.lines, sizes, self.options.keep_text);
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

    /// Returns what each cell of the first record looks like. It looks at the first two cells below that are
    /// not missing, since the first may be a unit. Where the question tells whether the record is a header,
    /// nothing is looked at.
    fn looks(
        &self,
        first: &Found,
        columns: &[ColumnSelector],
        reader: &mut ChunkReader,
        behind: Cursor,
    ) -> Vec<CellLook> {
        let table = &self.options.table;
        let others = others(self.options);
        let asked = AskedColumns { columns, others: &others, missing_as: &table.missing_as };
        let cells: Vec<&[u8]> = first.cells.iter().map(Vec::as_slice).collect();
        if table.header != Header::Auto || asked.tell(&cells) {
            return Vec::new();
        }
        let numbers = Numbers::new(table, self.syntax.delimiter);
        // The number of cells of each column that told something, and a flag that is set if one of them is a
        // number.
        let mut below = vec![(0, false); cells.len()];
        let mut cursor = behind;
        let mut shift = None;
        for _ in 0..MOST_ROWS_BELOW {
            let Some(row) = self.peek(reader, &mut cursor) else { break };
            let start = row.cells.first().and_then(|cell| cell.first());
            let may_be_comment = table.dialect.comment == CommentMark::Auto;
            if may_be_comment && start.is_some_and(|start| USUAL_MARKS.contains(start)) {
                continue;
            }
            // The names of rows have none.
            let shift = *shift.get_or_insert(usize::from(row.cells.len() == cells.len() + 1));
            for ((told, is_number), cell) in below.iter_mut().zip(row.cells.iter().skip(shift)) {
                if *told < 2 && !numbers.is_missing(cell) {
                    *told += 1;
                    *is_number |= numbers.is_number(cell, Mark::Open);
                }
            }
            if below.iter().all(|(told, _)| *told == 2) || cursor.at > behind.at + MOST_BYTES_BELOW {
                break;
            }
        }
        let look = |((_, is_above_number), cell)| {
            let may_be_read = numbers.is_missing(cell) || numbers.is_number(cell, Mark::Open);
            CellLook { is_above_number, may_be_read }
        };
        below.into_iter().zip(cells).map(look).collect()
    }

    /// The names in the comment right before the first record, if that is a row: it has as many cells, and a number. Numbers are no
    /// names, and neither is a label before its text: `# run 1` and `# source: me` above two columns are remarks.
    fn commented(&self, preamble: &Preamble, first: &Found) -> Option<Vec<String>> {
        if self.options.table.header == Header::Absent {
            return None;
        }
        let cells = preamble.commented_cells().filter(|cells| cells.len() == first.cells.len())?;
        let numbers = Numbers::new(&self.options.table, self.syntax.delimiter);
        let is_number = |cell: &Vec<u8>| numbers.is_number(cell, Mark::Open);
        if !first.cells.iter().any(is_number) {
            return None;
        }
        let labels = cells.iter().filter(|cell| cell.ends_with(b":")).count();
        if cells.iter().any(is_number) || (1..cells.len()).contains(&labels) {
            return None;
        }
        let name = |cell: &Vec<u8>| decode(cell).ok().map(|name| name.trim().to_owned());
        cells.iter().map(name).collect()
    }

    /// The information in the first record, whose cells look like this.
    fn heading(
        &self,
        first: &Found,
        columns: &[ColumnSelector],
        looks: &[CellLook],
    ) -> Result<Heading, InputError> {
        let cells: Vec<&[u8]> = first.cells.iter().map(Vec::as_slice).collect();
        let others = others(self.options);
        let missing_as = &self.options.table.missing_as;
        let asked = AskedColumns { columns, others: &others, missing_as };
        Heading::new(self.file, &cells, first.line, self.options.table.header, asked, looks)
    }
}

/// The columns from which something else than numbers is wanted.
fn others(options: &ScanOptions) -> Vec<&ColumnSelector> {
    options.key.iter().chain(options.table.conditions.iter().map(RowCondition::column)).collect()
}

fn line_feeds(bytes: &[u8]) -> u64 {
    memchr_iter(b'\n', bytes).count() as u64
}
