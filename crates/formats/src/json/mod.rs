//! Records in JSON as tables: an array of objects, objects one after the other (NDJSON), or an array of arrays.
//!
//! The keys name the columns, and the values are cells as in a text. A number is exactly the text written, so
//! 0.1 is 1/10. A missing value is `null` or a key that a record lacks; a text is a cell. Records are read
//! some at a time, whatever the size of the file. The first part of the file tells which columns there are.

mod lane;
mod records;
mod rows;
mod tokens;

use std::borrow::Cow;
use std::io::Read;
use std::ops::Range;

use boundfit_exact::{Column, Foreign, Notation, Reading};

use crate::cells::CellReader;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::decoding::TextReader;
use crate::dialect::{Dialect, Encoding, Missing};
use crate::error::{InputError, InputErrorKind};
use crate::lacking::Lacking;
use crate::memory::{BadNumber, Cells, Part, TextCells};
use crate::notes::{HeaderNote, SheetLooks, Skipped, TableNotes};
use crate::relations::refuse_beside;
use crate::scan::check_rows;
use crate::scan::{Consumer, ScanOptions, Scanned};
use crate::times::or_time;
use crate::wanted::WantedColumns;

use records::Records;
use rows::JsonRows;
use tokens::NESTED;

/// Returns whether a text that starts like this is JSON: an object with a key, or an array of objects or arrays.
pub(crate) fn is_json(start: &[u8]) -> bool {
    let start = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(start);
    // The other byte of each character belongs to UTF-16.
    let mut bytes = start.iter().filter(|byte| !byte.is_ascii_whitespace() && !matches!(byte, 0 | 0xfe..));
    match (bytes.next(), bytes.next()) {
        (Some(b'{'), Some(b'"')) => true,
        (Some(b'['), Some(b'{')) => matches!(bytes.next(), None | Some(b'"' | b'}')),
        (Some(b'['), Some(b'[')) => bytes.next().is_none_or(|byte| b"\"-0123456789n]".contains(byte)),
        _ => false,
    }
}

/// Reads records as [`scan`](crate::scan) says. With [`ScanOptions::keep_text`], the rows are written as CSV of the columns asked for,
/// which reads back as the same numbers.
///
/// Exact. Cost: one pass; memory for a part of the file.
///
/// # Errors
/// The first thing wrong, with its line and key.
pub(crate) fn scan_json(
    name: &str,
    bytes: Box<dyn Read>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    consumer: &mut Consumer,
) -> Result<Scanned, InputError> {
    let mut text = TextReader::new(bytes, options.hash);
    text.begin(options.table.dialect.encoding);
    let mut reader = JsonRows::new(name, text, options.table.header, &options.table.sizes);
    let mut part = reader.part(options.chunk_bytes);
    let names = reader.close_names();
    // Part of a record does not tell which columns there are.
    if part.0.lines().is_empty()
        && let Some(failure) = part.1.take()
    {
        return Err(failure);
    }
    if names.is_empty() {
        return Err(InputError::of_file(name, InputErrorKind::Empty));
    }
    if let Some(asked) =
        options.table.header.asked().filter(|_| reader.has_keys() && !options.table.is_beside)
    {
        return Err(InputError::of_file(name, InputErrorKind::OnlyOfText { asked, fits_sheets: true }));
    }
    let wanted =
        WantedColumns::new(name, &names, columns, options).map_err(|error| other_shape(error, &part.0))?;
    let (mut rows, mut used, mut passed) = (0, 0, 0);
    let mut lacking = Lacking::default();
    let read = loop {
        let (records, failure) = part;
        let is_at_end = records.lines().is_empty();
        let handed_out = hand_out(&records, &names, &wanted, rows, &mut lacking, consumer);
        match handed_out {
            Ok(counts) => (rows, used) = (rows + counts.0, used + counts.1),
            Err(error) => break Err(error),
        }
        if let Some(progress) = &options.progress {
            progress.advanced(reader.tokens.input().total() - passed);
            passed = reader.tokens.input().total();
            if progress.is_cancelled() {
                break Err(InputError::of_file(name, InputErrorKind::Interrupted));
            }
        }
        match failure {
            Some(failure) => break Err(failure),
            None if is_at_end => break Ok(rows),
            None => part = reader.part(options.chunk_bytes),
        }
    };
    let (rows_total, rows_missing) = lacking.settle(read, used, options)?;
    check_rows(name, rows_total, options)?;
    let text = reader.tokens.input();
    let mut table = notes(text.encoding(), options.table.missing);
    table.header.is_open = reader.may_be_names;
    let (bytes, sha256) = (text.total(), text.sha256());
    let scanned = wanted.scanned(rows_total, rows_missing);
    Ok(Scanned { header: names, bytes, sha256, table: Some(table), ..scanned })
}

/// Returns notes on records in this encoding.
fn notes(encoding: Encoding, missing: Missing) -> TableNotes {
    TableNotes {
        sheet: None,
        header: HeaderNote::default(),
        dialect: Dialect {
            delimiter: b',',
            notation: Notation::default(),
            comment: None,
            skip_lines: 0,
            records_before: 0,
            has_row_names: false,
            encoding,
            missing,
        },
        is_sheet: false,
        looks: SheetLooks::default(),
        is_records: true,
        block: None,
        is_comma_open: false,
        skipped: Skipped::default(),
    }
}

/// The texts of the columns that are wanted, by their positions from 0.
struct Texts<'a>(Vec<Option<Vec<&'a str>>>);

impl Texts<'_> {
    fn cells(&self, place: &ColumnPlace) -> TextCells<'_, &str> {
        TextCells(self.0.get(place.position - 1).and_then(Option::as_deref).unwrap_or_default())
    }
}

impl Cells<ColumnPlace> for Texts<'_> {
    fn has_missing(&self, place: &ColumnPlace) -> bool {
        self.cells(place).has_missing()
    }

    fn is_missing(&self, place: &ColumnPlace, index: usize) -> bool {
        self.cells(place).is_missing(index)
    }

    fn text(&self, place: &ColumnPlace, index: usize, _: Reading) -> String {
        self.cells(place).text(index).to_owned()
    }

    fn key(&self, place: &ColumnPlace, index: usize, _: Reading) -> Cow<'_, str> {
        self.cells(place).key(index).into()
    }

    fn column(
        &self,
        place: &ColumnPlace,
        range: Range<usize>,
        reader: CellReader,
    ) -> Result<Column, BadNumber> {
        let cells = self.cells(place);
        cells.column(range.clone(), reader).map_err(|(index, problem)| {
            let index = range.start + index;
            BadNumber { index, text: cells.text(index).to_owned(), problem }
        })
    }
}

/// Hands out records that come after so many others; gives how many there are, and how many of them are used.
fn hand_out(
    records: &Records,
    names: &[Foreign],
    wanted: &WantedColumns,
    before: usize,
    lacking: &mut Lacking,
    consumer: &mut Consumer,
) -> Result<(usize, usize), InputError> {
    let lines = records.lines();
    let mut columns: Vec<Option<Vec<&str>>> = vec![None; names.len()];
    for position in wanted.all().map(|place| place.position) {
        if let Some(column) = columns.get_mut(position - 1) {
            *column = Some(vec![""; lines.len()]);
        }
    }
    let mut seen: Vec<Option<usize>> = vec![None; names.len()];
    for ((row, &line), cells) in lines.iter().enumerate().zip(records.iter()) {
        for (column, text) in cells {
            if wanted.options.table.are_half_planes {
                let place = ColumnPlace {
                    position: column + 1,
                    name: names.get(column).filter(|name| !name.is_empty()).cloned(),
                };
                let is_asked = wanted.places.iter().any(|asked| asked.position == place.position);
                refuse_beside(wanted.file, &place, line, text.as_bytes(), is_asked)?;
            }
            let Some(cell) =
                columns.get_mut(column).and_then(Option::as_mut).and_then(|cells| cells.get_mut(row))
            else {
                continue;
            };
            *cell = text;
            if let Some(seen) = seen.get_mut(column)
                && seen.replace(row) == Some(row)
            {
                let wanted_name = names.get(column).cloned().unwrap_or_default();
                let problem = InputErrorKind::AmbiguousColumn { wanted: wanted_name };
                return Err(InputError::of_line(wanted.file, line, problem));
            }
        }
    }
    let part = Part { table: &Texts(columns), wanted, before, lines };
    let used = part.hand_out(lines.len(), lacking, consumer).map_err(about_nested)?;
    Ok((lines.len(), used))
}

/// The error, that says rather that the columns are not those of records, where one of their values is an object or an array.
fn other_shape(mut error: InputError, records: &Records) -> InputError {
    let mut cells = records.iter().take(1).flatten();
    if matches!(error.kind, InputErrorKind::UnknownColumn { .. })
        && cells.any(|(_, text)| NESTED.contains(&text))
    {
        error.place.line = records.lines().first().copied();
        error.kind = InputErrorKind::NestedJson;
    }
    error
}

/// The error, that says rather that an object, an array or a time stands where a number belongs.
fn about_nested(error: InputError) -> InputError {
    let Some(text) = error.place.text.as_ref().map(Foreign::raw) else { return error };
    let kind = match error.kind {
        InputErrorKind::NotANumber(_) if NESTED.contains(&text) => InputErrorKind::NestedJson,
        kind => or_time(kind, text.as_bytes()),
    };
    InputError { kind, ..error }
}
