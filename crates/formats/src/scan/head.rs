//! The first record of a table: whether it is a header, and where the columns are.

use std::io::Read;

use csv::ByteRecord;
use memchr::{memchr, memchr_iter};

use crate::columns::ColumnSelector;
use crate::error::{InputError, InputErrorKind};
use crate::records::Records;
use crate::start::without_mark;

use super::batch::ScanOptions;
use super::chunks::ChunkReader;
use super::layout::Layout;
use super::library::lines_in;
use super::tape::Tape;
use super::wave::Position;

/// What is known before the first record is read.
pub(super) struct Start<'a> {
    pub(super) file: &'a str,
    pub(super) delimiter: u8,
    pub(super) columns: &'a [ColumnSelector],
    pub(super) options: &'a ScanOptions,
}

/// What the first record tells.
pub(super) struct Head<'a> {
    pub(super) layout: Layout<'a>,
    pub(super) header_line: Option<Vec<u8>>,
}

impl<'a> Start<'a> {
    /// Records of an input that starts on this line.
    pub(super) fn records<R: Read>(&self, input: R, line: u64) -> Records<Tape<R>> {
        let longest = self.options.table.sizes.line;
        Records::new(Tape::new(input, self.options.keep_text), self.delimiter, line, longest)
    }

    /// Reads the first record, which is the first row if it is not a header.
    pub(super) fn head<R: Read>(
        &self,
        records: &mut Records<Tape<R>>,
    ) -> Result<(Head<'a>, ByteRecord), InputError> {
        let mut record = ByteRecord::new();
        if !records.next(self.file, &mut record)? {
            return Err(InputError::of_file(self.file, InputErrorKind::Empty));
        }
        Ok((self.head_of(&record, records)?, record))
    }

    /// What the first record tells, which was the last one read.
    fn head_of<R: Read>(
        &self,
        record: &ByteRecord,
        records: &mut Records<Tape<R>>,
    ) -> Result<Head<'a>, InputError> {
        let line = records.line();
        let layout = Layout::new(self.file, record, line, self.delimiter, self.columns, self.options)?;
        let header_line = if layout.has_header { records.text() } else { None };
        Ok(Head { layout, header_line })
    }

    /// Reads the first record from what the reader has at hand, and has it pass over a header; `None` when the record is
    /// not a line that ends with a line feed, so that the rows after it cannot be told by line feeds.
    pub(super) fn plain_head(
        &self,
        reader: &mut ChunkReader,
    ) -> Result<Option<(Head<'a>, Position)>, InputError> {
        let Some(lines) = self.first_lines(reader.rest()) else { return Ok(None) };
        // Behind the line comes more, which the record takes in only if the line ends within quotes.
        let mut records = self.records(lines.chain(b"0".as_slice()), 1);
        let mut record = ByteRecord::new();
        let found = records.next(self.file, &mut record)?;
        let end = records.range().end as usize;
        if !found || end > lines.len() {
            return Ok(None);
        }
        let head = self.head_of(&record, &mut records)?;
        let mut position = Position { rows: 0, lines: 1, line_feeds: 1 };
        if head.layout.has_header {
            // The library takes the first half of a line end only.
            let is_half = lines.get(..end).is_some_and(|record| record.ends_with(b"\r"));
            let end = end + usize::from(is_half);
            let record = lines.get(..end).unwrap_or_default();
            position.lines += lines_in(record);
            position.line_feeds += memchr_iter(b'\n', record).count() as u64;
            reader.skip(end);
        }
        Ok(Some((head, position)))
    }

    /// Everything up to the end of the first line that is not blank, when only line feeds end lines.
    fn first_lines<'b>(&self, start: &'b [u8]) -> Option<&'b [u8]> {
        // The library passes over another byte order mark.
        if matches!(self.delimiter, b'\r' | b'\n' | b'"') || without_mark(start).len() < start.len() {
            return None;
        }
        let blank = start.len() - start.trim_ascii_start().len();
        let end = blank + memchr(b'\n', start.get(blank..)?)? + 1;
        let lines = start.get(..end)?;
        let is_plain = memchr_iter(b'\r', lines).all(|position| lines.get(position + 1) == Some(&b'\n'));
        is_plain.then_some(lines)
    }
}
