//! The columns that selectors mean.

use std::collections::BTreeSet;

use boundfit_exact::{DecimalMark, Foreign, is_missing};
use boundfit_formats::{ColumnSelector, Header, InputError, InputErrorKind};
use csv::{ByteRecord, ReaderBuilder};

use super::Reader;
use super::cells::{not_utf8, wrong, wrong_cell};
use super::records::Records;
use super::text::{detect, line_ends};

impl Reader<'_> {
    /// A text whose lines before the first one with all the names that are asked for are empty, if these are several and do not stand
    /// in its first line.
    pub(super) fn without_preamble(&self, mut text: Vec<u8>) -> Vec<u8> {
        let texts: BTreeSet<&str> = self.columns.iter().map(|column| column.text().raw()).collect();
        let by_name = self.columns.iter().all(|column| column.number().is_none());
        if self.options.header == Header::Absent || !by_name || texts.len() < 2 {
            return text;
        }
        let is_line_end = |byte: &u8| matches!(byte, b'\r' | b'\n');
        let start = text.iter().position(|byte| !is_line_end(byte)).unwrap_or(text.len());
        let mut at = start;
        for number in 0..1000 {
            let end = at + text[at..].iter().position(is_line_end).unwrap_or(text.len() - at);
            if end == text.len() && at == end {
                return text;
            }
            if self.has_all(&texts, &text[at..end]) {
                let ends = if number > 0 { line_ends(&text, start, at) as usize } else { 0 };
                let empty = std::iter::repeat_n(b'\n', ends);
                let behind = if number > 0 { at } else { start };
                text.splice(start..behind, empty);
                return text;
            }
            at = (end + if text[end..].starts_with(b"\r\n") { 2 } else { 1 }).min(text.len());
            if at > start + (1 << 16) {
                return text;
            }
        }
        text
    }

    /// Returns whether a line has a cell for each of these names.
    fn has_all(&self, names: &BTreeSet<&str>, line: &[u8]) -> bool {
        let delimiter = self.options.dialect.delimiter.or_else(|| detect(line)).unwrap_or(b' ');
        let mut reader = ReaderBuilder::new();
        // The library passes over a byte order mark at the very start.
        let line = [b"\n", line].concat();
        let reader = reader.has_headers(false).flexible(true).delimiter(delimiter).from_reader(&line[..]);
        let record = reader.into_byte_records().next().and_then(Result::ok).unwrap_or_default();
        let cells: Vec<String> =
            record.iter().map(|cell| String::from_utf8_lossy(cell).trim().to_owned()).collect();
        names.iter().all(|name| {
            let bare = unmarked(name);
            cells.iter().any(|cell| cell == name)
                || !bare.is_empty()
                    && cells
                        .iter()
                        .any(|cell| [&**cell, before_unit(cell), before_unit(unmarked(cell))].contains(&bare))
        })
    }

    /// The names in the first record, if it is a header.
    pub(super) fn header(
        &self,
        record: &ByteRecord,
        line: u64,
        below: &[bool],
    ) -> Result<Option<Vec<String>>, InputError> {
        let is_header = match self.options.header {
            Header::Present => true,
            Header::Absent => false,
            Header::Auto => {
                let conditions = self.options.conditions.iter().map(|condition| condition.column().number());
                let numbers = self.columns.iter().map(ColumnSelector::number);
                let cells = numbers.clone().flatten().filter_map(|number| record.get(number.checked_sub(1)?));
                let cells: Vec<&[u8]> = cells.collect();
                numbers.clone().chain(conditions).any(|number| number.is_none())
                    || (!cells.is_empty() && cells.into_iter().all(is_name))
                    || self.has_numbers_as_names(record)
                    || record.iter().zip(below).any(|(cell, &has_numbers)| {
                        has_numbers && (is_name(cell) || cell.trim_ascii().is_empty())
                    })
            }
        };
        if !is_header {
            return Ok(None);
        }
        let name = |(index, cell): (usize, &[u8])| {
            let text = std::str::from_utf8(cell)
                .map_err(|error| wrong_cell(line, index + 1, None, cell, not_utf8(cell, &error)))?;
            Ok(text.trim().to_owned())
        };
        record.iter().enumerate().map(name).collect::<Result<_, _>>().map(Some)
    }

    /// Returns, for each column, whether one of its first two cells below the first record that are not missing is a
    /// number.
    pub(super) fn below(&self, records: &Records, width: usize) -> Vec<bool> {
        let mut ahead = Records::new(records.text, records.fails, records.delimiter, self.options.sizes.line);
        let mut record = ByteRecord::new();
        let mut columns = vec![Vec::new(); width];
        let mut shift = None;
        let _ = ahead.next(&mut record);
        for _ in 0..16 {
            if !matches!(ahead.next(&mut record), Ok(true)) || record.len() > self.options.sizes.columns {
                break;
            }
            let shift = *shift.get_or_insert(usize::from(record.len() == width + 1));
            for (told, cell) in columns.iter_mut().zip(record.iter().skip(shift)) {
                let text = std::str::from_utf8(cell);
                if !text.is_ok_and(is_missing) {
                    let is_number = |mark| text.is_ok_and(|text| self.number(text, mark).is_ok());
                    told.push(DecimalMark::ALL.into_iter().any(is_number));
                }
            }
        }
        columns.into_iter().map(|told| told.into_iter().take(2).any(|is_number| is_number)).collect()
    }

    fn asked(&self) -> impl Iterator<Item = &ColumnSelector> {
        self.columns.iter().chain(self.options.conditions.iter().map(|condition| condition.column()))
    }

    /// Returns whether a number is asked for that no column has, but one of these cells.
    fn has_numbers_as_names(&self, record: &ByteRecord) -> bool {
        self.asked().any(|column| {
            column.number().is_some_and(|number| number == 0 || number > record.len())
                && record.iter().any(|cell| says(cell, column))
        })
    }

    /// Returns whether moreover all numbers that are asked for are among them.
    pub(super) fn prefers_names(&self, record: &ByteRecord) -> bool {
        let mut numbers = self.asked().filter(|column| column.number().is_some());
        self.has_numbers_as_names(record)
            && numbers.all(|column| record.iter().any(|cell| says(cell, column)))
    }

    /// Refuses two numbers of one column, unless one is a bound on errors.
    pub(super) fn refuse_same(
        &self,
        places: &[usize],
        names: &[String],
        line: u64,
    ) -> Result<(), InputError> {
        let is_number = |&column: &usize| !self.columns[column].is_non_negative();
        for second in (0..places.len()).filter(is_number) {
            let place = places[second];
            if let Some(first) = (0..second).filter(is_number).find(|&first| places[first] == place) {
                let texts = [first, second].map(|index| self.columns[index].text().to_owned());
                let [first, second] = texts;
                let mut error = wrong(Some(line), InputErrorKind::SameColumn { first, second });
                error.place.column = Some((place, names.get(place - 1).map(Foreign::from)));
                return Err(error);
            }
        }
        Ok(())
    }
}

/// Returns whether a cell says what is asked for.
fn says(cell: &[u8], column: &ColumnSelector) -> bool {
    std::str::from_utf8(cell).is_ok_and(|cell| cell.trim() == column.text().raw())
}

/// Returns whether a cell may be a name. A comment mark before a blank is none of it.
fn is_name(cell: &[u8]) -> bool {
    let text = String::from_utf8_lossy(cell).trim().to_lowercase();
    let name = match text.split_once(' ') {
        Some(("#" | "%", _)) => unmarked(&text),
        _ => &text,
    };
    name.starts_with(|first: char| first.is_alphabetic() || first == '_')
        && !is_missing(name)
        && !["inf", "infinity"].contains(&name)
}

/// A name without comment marks, and the blanks behind them, in front of it.
fn unmarked(name: &str) -> &str {
    let start = name.find(|character| !matches!(character, '#' | '%')).unwrap_or(name.len());
    name[start..].trim_start()
}

/// A name without a unit in brackets at its end, or in parentheses behind a blank; a number in them is no unit.
fn before_unit(name: &str) -> &str {
    let open = match name.trim_end().chars().next_back() {
        Some(')') => '(',
        Some(']') => '[',
        _ => return name,
    };
    let Some(start) = name.rfind(open) else { return name };
    let (before, unit) = (&name[..start], name[start + 1..].trim_end());
    let unit = unit[..unit.len() - 1].trim();
    let is_apart = open == '[' || before.chars().next_back().is_some_and(char::is_whitespace);
    let is_number = unit.chars().all(|character| character.is_ascii_digit());
    if is_apart && !is_number && !before.trim().is_empty() { before.trim() } else { name }
}

/// The number of the column that is meant, from 1.
pub(super) fn find(
    column: &ColumnSelector,
    names: &[String],
    [has_header, prefers_names]: [bool; 2],
    width: usize,
    line: u64,
) -> Result<usize, InputError> {
    let wanted = column.text().to_owned();
    let named = |is_meant: &dyn Fn(&str) -> bool| -> Vec<usize> {
        (1..=names.len()).filter(|&place| is_meant(&names[place - 1])).collect()
    };
    let mut places = named(&|name| wanted == name);
    let bare = unmarked(wanted.raw());
    if places.is_empty() && !bare.is_empty() {
        places =
            named(&|name| name == bare || before_unit(name) == bare || before_unit(unmarked(name)) == bare);
    }
    match (places.as_slice(), column.number()) {
        ([place], Some(number)) if number != *place && (1..=width).contains(&number) && !prefers_names => {
            Err(wrong(Some(line), InputErrorKind::NameOrNumber { wanted, named: *place, fits_header: true }))
        }
        ([place], _) => Ok(*place),
        ([], Some(number)) if (1..=width).contains(&number) => Ok(number),
        ([], _) => {
            let available = if has_header { names.iter().map(Foreign::from).collect() } else { Vec::new() };
            let kind = InputErrorKind::UnknownColumn { wanted, available, numbers: Some(width) };
            Err(wrong(Some(line), kind))
        }
        _ => Err(wrong(Some(line), InputErrorKind::AmbiguousColumn { wanted })),
    }
}
