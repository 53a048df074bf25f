//! Records by the `csv` crate, with the lines on which they start.

use std::io::{self, Read};

use boundfit_formats::{InputError, InputErrorKind};
use csv::{ByteRecord, ReaderBuilder};

use super::BYTE_ORDER_MARK;
use super::cells::wrong;
use super::text::{Failing, line_ends};

/// Records that are not blank, with the lines on which they start.
pub(super) struct Records<'a> {
    pub(super) text: &'a [u8],
    reader: csv::Reader<io::Chain<&'a [u8], Failing>>,
    limit: usize,
    /// The place up to which line ends are counted.
    counted: usize,
    pub(super) line: u64,
    /// The line of the last record, if the text ends within its quotes.
    pub(super) open_quotes: Option<u64>,
    /// The cells of the last record, from 0, with text behind their closing quote.
    pub(super) torn: Vec<usize>,
    pub(super) delimiter: u8,
    /// True if reading fails at the end of the text.
    pub(super) fails: bool,
}

impl<'a> Records<'a> {
    pub(super) fn new(text: &'a [u8], fails: bool, delimiter: u8, limit: usize) -> Self {
        let failing = Failing(fails.then(String::new));
        let mut builder = ReaderBuilder::new();
        let reader = builder.has_headers(false).flexible(true).delimiter(delimiter);
        Records {
            text,
            reader: reader.from_reader(text.chain(failing)),
            limit,
            counted: 0,
            line: 1,
            open_quotes: None,
            torn: Vec::new(),
            delimiter,
            fails,
        }
    }

    pub(super) fn next(&mut self, record: &mut ByteRecord) -> Result<bool, Option<InputError>> {
        loop {
            let from = self.reader.position().byte() as usize;
            let is_line_end = |byte: &&u8| matches!(byte, b'\r' | b'\n');
            // The library passes over a byte order mark.
            let from = if from == 0 && self.text.starts_with(BYTE_ORDER_MARK) { 3 } else { from };
            let start = from + self.text[from..].iter().take_while(is_line_end).count();
            self.line += line_ends(self.text, self.counted, start);
            self.counted = start;
            let read = self.reader.read_byte_record(record);
            let end = if read.is_ok() { self.reader.position().byte() as usize } else { self.text.len() };
            if end.saturating_sub(start) > self.limit {
                return Err(Some(wrong(Some(self.line), InputErrorKind::RowTooLong { limit: self.limit })));
            }
            let more = read.map_err(|_| None)?;
            // Behind the last record it is still that of the last record.
            if more {
                let is_open =
                    end == self.text.len() && ends_within_quotes(&self.text[start..], self.delimiter);
                self.open_quotes = is_open.then_some(self.line);
                self.torn = torn_cells(&self.text[start..end], self.delimiter);
            }
            let is_blank = record.len() == 1 && record[0].trim_ascii().is_empty();
            if !(more && is_blank) {
                return Ok(more);
            }
        }
    }
}

/// The cells of a record, from 0, with text behind their closing quote.
fn torn_cells(record: &[u8], delimiter: u8) -> Vec<usize> {
    let (mut torn, mut rest) = (Vec::new(), record);
    for cell in 0.. {
        let mut quoted = 0;
        if rest.first() == Some(&b'"') {
            quoted = 1;
            loop {
                let Some(length) = rest[quoted..].iter().position(|&byte| byte == b'"') else { return torn };
                quoted += length + 1;
                if rest.get(quoted) != Some(&b'"') {
                    break;
                }
                quoted += 1;
            }
        }
        let behind = &rest[quoted..];
        let is_end = |&byte: &u8| byte == delimiter || matches!(byte, b'\r' | b'\n');
        let length = behind.iter().position(is_end).unwrap_or(behind.len());
        if quoted > 0 && behind[..length].iter().any(|byte| !matches!(byte, b' ' | b'\t')) {
            torn.push(cell);
        }
        match behind.get(length) {
            Some(&byte) if byte == delimiter => rest = &behind[length + 1..],
            _ => break,
        }
    }
    torn
}

/// Returns whether a record stops before its quotes do.
fn ends_within_quotes(record: &[u8], delimiter: u8) -> bool {
    let (mut is_inside, mut is_start) = (false, true);
    let mut bytes = record.iter().peekable();
    while let Some(&byte) = bytes.next() {
        if is_inside {
            is_inside = byte != b'"' || bytes.next_if(|&&next| next == b'"').is_some();
            is_start = false;
        } else {
            (is_inside, is_start) = (is_start && byte == b'"', byte == delimiter);
        }
    }
    is_inside
}
