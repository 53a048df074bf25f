//! Records of delimited text, out of pieces of bytes of any size.
//!
//! `csv_core` knows the rules of quotes, delimiters and line ends; a line without quotes needs none but the delimiter. This module
//! keeps lines, lengths and buffers, since messages name the line on which a record starts, and no record may grow without bound.

use csv_core::{ReadRecordResult, Reader, ReaderBuilder};
use memchr::{memchr_iter, memchr2, memchr2_iter, memchr3};

use crate::blanks::{BlankReader, Cells};
use crate::blocks::Gap;
use crate::dialect::BLANKS;
use crate::error::{InputError, InputErrorKind};
use crate::limits::SizeLimits;
use crate::quotes::TornCells;

/// The words that spreadsheets write into cells without a value.
const SHEET_ERRORS: [&[u8]; 7] = [b"#N/A", b"#DIV/0!", b"#NUM!", b"#VALUE!", b"#REF!", b"#NAME?", b"#NULL!"];

/// The reader of records.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Syntax {
    /// The separator of cells; [`BLANKS`] for runs of blanks and tabs.
    pub(crate) delimiter: u8,
    /// The bytes that begin a line to pass over, where a record could start.
    pub(crate) comment: Option<[u8; 2]>,
}

impl Syntax {
    /// Returns whether a line that starts with these bytes is a comment.
    pub(crate) fn is_comment(&self, line: &[u8]) -> bool {
        let Some((marks, first)) = self.comment.zip(line.first()) else { return false };
        // Two marks are those that were not asked for: they must not hide a row that begins with an error of a spreadsheet.
        let is_found_out = marks[0] != marks[1];
        marks.contains(first) && !(is_found_out && SHEET_ERRORS.iter().any(|error| line.starts_with(error)))
    }
}

/// The rules that separate records.
enum Core {
    Delimited(Delimited),
    Blanks(BlankReader),
}

/// The rules of a delimiter and of quotes.
struct Delimited {
    delimiter: u8,
    /// The reader of the library. It is made for the first record with quotes: its table of states costs as much as reading some
    /// hundred rows.
    reader: Option<Box<Reader>>,
}

impl Delimited {
    fn reader(&mut self) -> &mut Reader {
        self.reader.get_or_insert_with(|| {
            let mut reader = ReaderBuilder::new().delimiter(self.delimiter).build();
            // The library passes over a byte order mark in front of the first bytes that it sees. Not every piece is the
            // start of a file, where the mark has been passed over already; so let it see a line end first.
            reader.read_record(b"\n", &mut [0], &mut [0]);
            Box::new(reader)
        })
    }

    /// The first line of a piece, if it ends there and has no quotes: at the start of a record it is the record.
    fn plain_line<'a>(&self, piece: &'a [u8]) -> Option<&'a [u8]> {
        let line = piece.get(..memchr3(b'"', b'\r', b'\n', piece)?)?;
        let ends_there = piece.get(line.len()) != Some(&b'"');
        (ends_there && !matches!(self.delimiter, b'"' | b'\r' | b'\n')).then_some(line)
    }
}

/// The cells of a record, without their quotes.
#[derive(Debug, Default)]
pub(crate) struct Record {
    /// The cells one behind the other, and room for more of them.
    bytes: Vec<u8>,
    bytes_used: usize,
    /// The ends of the cells, with room for more.
    ends: Vec<usize>,
    cells: usize,
    /// The most cells to keep: each takes memory, and may be nothing but a comma.
    most_cells: usize,
    torn: TornCells,
}

impl Record {
    /// Returns the number of cells.
    pub(crate) fn len(&self) -> usize {
        self.cells
    }

    /// A cell, counted from 0; nothing where there is none.
    pub(crate) fn cell(&self, index: usize) -> &[u8] {
        let ends = self.ends.get(..self.cells).unwrap_or_default();
        let start = index.checked_sub(1).and_then(|before| ends.get(before)).copied().unwrap_or(0);
        ends.get(index).and_then(|&end| self.bytes.get(start..end)).unwrap_or_default()
    }

    /// Returns whether text stands behind the closing quote of a cell, counted from 0.
    pub(crate) fn is_torn(&self, index: usize) -> bool {
        self.torn.has(index)
    }

    /// The cells in order.
    pub(crate) fn cells(&self) -> impl Iterator<Item = &[u8]> {
        (0..self.cells).map(|index| self.cell(index))
    }

    fn is_blank(&self) -> bool {
        self.cells == 0 || (self.cells == 1 && self.cell(0).trim_ascii().is_empty())
    }

    /// Returns whether there is nothing but white space in any cell.
    pub(crate) fn is_empty(&self) -> bool {
        self.cells().all(|cell| cell.trim_ascii().is_empty())
    }

    fn clear(&mut self) {
        (self.bytes_used, self.cells) = (0, 0);
        self.torn.clear();
    }

    /// Takes the cells of a line without quotes.
    fn split(&mut self, line: &[u8], delimiter: u8) {
        let mut start = 0;
        for end in memchr_iter(delimiter, line).chain([line.len()]) {
            self.extend(line.get(start..end).unwrap_or_default());
            self.end_cell();
            start = end + 1;
        }
    }

    /// Goes on with this record; gives how many bytes that took, and whether it is complete.
    fn go_on(&mut self, core: &mut Core, input: &[u8]) -> (usize, bool) {
        let (delimiter, (taken, is_complete)) = match core {
            Core::Blanks(core) => (BLANKS, core.read(input, self)),
            Core::Delimited(_) if self.is_too_wide() => return (input.len(), false),
            Core::Delimited(core) => {
                let (result, taken) = self.read(core.reader(), input);
                (core.delimiter, (taken, result == ReadRecordResult::Record))
            }
        };
        self.torn.pass(input.get(..taken).unwrap_or_default(), delimiter);
        (taken, is_complete)
    }

    /// Returns whether there are more cells than are kept.
    fn is_too_wide(&self) -> bool {
        self.cells > self.most_cells
    }

    /// Ends this record, since nothing follows; gives whether it is within quotes, which nothing closes.
    fn finish(&mut self, core: &mut Core) -> bool {
        match core {
            Core::Blanks(core) => {
                let is_within_quotes = core.is_within_quotes();
                core.finish(self);
                is_within_quotes
            }
            Core::Delimited(core) => {
                let core = core.reader();
                // A line end ends a record, but within quotes it is a byte of the cell.
                let mut taken = 0;
                while taken == 0 {
                    let (result, count) = self.read(core, b"\r");
                    if result == ReadRecordResult::Record {
                        return false;
                    }
                    taken = count;
                }
                // To the library, no bytes are the end of all bytes.
                while self.read(core, b"").0 == ReadRecordResult::OutputEndsFull {}
                let last = self.cells.checked_sub(1).and_then(|last| self.ends.get_mut(last));
                last.into_iter().for_each(|end| *end -= 1);
                true
            }
        }
    }

    /// Has the library go on with this record; gives its verdict and how many bytes it took.
    fn read(&mut self, core: &mut Reader, input: &[u8]) -> (ReadRecordResult, usize) {
        let bytes = self.bytes.get_mut(self.bytes_used..).unwrap_or_default();
        let ends = self.ends.get_mut(self.cells..).unwrap_or_default();
        let (result, taken, written, ended) = core.read_record(input, bytes, ends);
        self.bytes_used += written;
        self.cells += ended;
        match result {
            ReadRecordResult::OutputFull => self.bytes.resize(grown(self.bytes.len()), 0),
            ReadRecordResult::OutputEndsFull => self.ends.resize(grown(self.ends.len()), 0),
            _ => {}
        }
        (result, taken)
    }
}

impl Cells for Record {
    fn extend(&mut self, bytes: &[u8]) {
        let end = self.bytes_used + bytes.len();
        if end > self.bytes.len() {
            self.bytes.resize(grown(end), 0);
        }
        if let Some(room) = self.bytes.get_mut(self.bytes_used..end) {
            room.copy_from_slice(bytes);
        }
        self.bytes_used = end;
    }

    fn end_cell(&mut self) {
        if self.cells == self.ends.len() && !self.is_too_wide() {
            self.ends.resize(grown(self.ends.len()), 0);
        }
        if let Some(end) = self.ends.get_mut(self.cells) {
            *end = self.bytes_used;
        }
        self.cells += 1;
    }
}

/// The next size of a buffer that is full.
fn grown(size: usize) -> usize {
    size.saturating_mul(2).max(64)
}

/// Takes the records that are not blank out of bytes that come piece after piece.
pub(crate) struct Records<'a> {
    file: &'a str,
    syntax: Syntax,
    core: Core,
    record: Record,
    /// `true` if the record goes on in the next piece.
    is_open: bool,
    /// `true` if the last record is within quotes that nothing closes.
    is_within_quotes: bool,
    /// `true` if a comment goes on in the next piece.
    is_in_comment: bool,
    /// The line of the next byte, from 1.
    line: u64,
    /// `true` if the last byte was a carriage return: a line feed right after it belongs to the same line end.
    is_after_return: bool,
    /// The line on which the record starts, and how many bytes of it there are up to the first byte of its line end.
    record_line: u64,
    record_bytes: usize,
    longest_record: usize,
    /// The number of cells of a row; 0 where that is not known.
    width: usize,
    /// The text between the last record and the one before, and behind the last one.
    gap: Gap,
    behind: Gap,
    /// The line behind the last record that is not blank.
    end_line: u64,
    /// The bytes of the record, where they are kept.
    text: Option<Vec<u8>>,
}

impl<'a> Records<'a> {
    /// Records with at most so many bytes and cells, from this line of a file on. Their text is kept only if that is asked for.
    pub(crate) fn new(file: &'a str, syntax: Syntax, line: u64, sizes: &SizeLimits, keep_text: bool) -> Self {
        let core = if syntax.delimiter == BLANKS {
            Core::Blanks(BlankReader::default())
        } else {
            Core::Delimited(Delimited { delimiter: syntax.delimiter, reader: None })
        };
        Records {
            file,
            syntax,
            core,
            record: Record { most_cells: sizes.columns, ..Record::default() },
            is_open: false,
            is_within_quotes: false,
            is_in_comment: false,
            line,
            is_after_return: false,
            record_line: line,
            record_bytes: 0,
            longest_record: sizes.line,
            width: 0,
            gap: Gap::default(),
            behind: Gap::default(),
            end_line: line,
            text: keep_text.then(Vec::new),
        }
    }

    /// Takes bytes off the front of a piece until a record that is not blank ends; `false` when the piece is used up
    /// before. The bytes of the next piece are those that follow.
    ///
    /// # Errors
    /// When the record is too long or too wide.
    pub(crate) fn next(&mut self, piece: &mut &[u8]) -> Result<bool, InputError> {
        loop {
            if !self.is_open {
                self.pass_comments(piece);
                if piece.is_empty() {
                    return Ok(false);
                }
                self.begin();
            }
            let is_complete = self.go_on(piece);
            self.is_open = !is_complete;
            if self.record_bytes > self.longest_record {
                let too_long = InputErrorKind::RowTooLong { limit: self.longest_record };
                return Err(InputError::of_line(self.file, self.record_line, too_long));
            }
            // Before quotes that are never closed swallow all that follows, they make one cell.
            if self.record.is_too_wide() {
                let too_wide = InputErrorKind::TooManyColumns { limit: self.record.most_cells };
                return Err(InputError::of_line(self.file, self.record_line, too_wide));
            }
            if !is_complete {
                return Ok(false);
            }
            if !self.record.is_blank() {
                self.end_gap();
                return Ok(true);
            }
            if self.has_blank_cell() {
                self.pass_blank_cell();
            }
        }
    }

    /// Returns whether the record is one blank cell in quotes: it is passed over as a blank line is, but it parts no blocks.
    fn has_blank_cell(&self) -> bool {
        // Bytes beyond the cell and its line end are quotes.
        self.record.cells == 1 && self.record_bytes > self.record.bytes_used + 1
    }

    /// Counts blank lines anew behind a blank cell, unless those before it part blocks already.
    fn pass_blank_cell(&mut self) {
        self.end_gap();
        if !self.gap.is_break() {
            self.gap.blank_lines = 0;
        }
    }

    /// Ends the record that the last piece left open, since nothing follows; `false` when there is none that is not blank.
    pub(crate) fn finish(&mut self) -> bool {
        let was_open = std::mem::take(&mut self.is_open);
        self.is_within_quotes = was_open && self.record.finish(&mut self.core);
        let is_record = was_open && !self.record.is_blank();
        if is_record {
            self.end_gap();
        }
        is_record
    }

    /// These records of rows with so many cells.
    pub(crate) fn of_width(self, width: usize) -> Self {
        Records { width, ..self }
    }

    /// The text between the last record and the one before it, or the start.
    pub(crate) fn take_gap(&mut self) -> Gap {
        std::mem::take(&mut self.gap)
    }

    /// The text behind the last record.
    pub(crate) fn gap_behind(&self) -> Gap {
        let mut gap = self.behind.clone();
        gap.blank_lines = (self.line - self.end_line).saturating_sub(gap.comments);
        gap
    }

    /// Ends what stands before a record that is not blank.
    fn end_gap(&mut self) {
        let mut gap = std::mem::take(&mut self.behind);
        gap.blank_lines = (self.record_line - self.end_line).saturating_sub(gap.comments);
        self.gap.add(gap);
        self.end_line = self.line;
    }

    /// Returns whether the last record is within quotes that nothing closes.
    pub(crate) fn is_within_quotes(&self) -> bool {
        self.is_within_quotes
    }

    /// The last record.
    pub(crate) fn record(&self) -> &Record {
        &self.record
    }

    /// The line on which the last record starts, from 1.
    pub(crate) fn record_line(&self) -> u64 {
        self.record_line
    }

    /// The last record as it stands in the file, without its line end, where that is kept.
    pub(crate) fn text(&self) -> Option<&[u8]> {
        let text = self.text.as_deref()?;
        Some(text.strip_suffix(b"\n").or(text.strip_suffix(b"\r")).unwrap_or(text))
    }

    /// The line reached, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// Returns whether a record goes on in the next piece.
    pub(crate) fn is_open(&self) -> bool {
        self.is_open
    }

    fn begin(&mut self) {
        self.is_open = true;
        self.record.clear();
        (self.record_line, self.record_bytes) = (self.line, 0);
        self.text.iter_mut().for_each(Vec::clear);
    }

    /// Goes on with a record, and takes its bytes off the front of a piece; gives whether it is complete.
    fn go_on(&mut self, piece: &mut &[u8]) -> bool {
        let mut left = *piece;
        let mut is_complete = false;
        if self.record_bytes == 0
            && let Core::Delimited(core) = &self.core
            && let Some(line) = core.plain_line(left)
        {
            self.record.split(line, core.delimiter);
            left = left.get(line.len() + 1..).unwrap_or_default();
            is_complete = true;
        }
        while !is_complete && !left.is_empty() {
            let taken;
            (taken, is_complete) = self.record.go_on(&mut self.core, left);
            left = left.get(taken..).unwrap_or_default();
        }
        let (bytes, _) = piece.split_at_checked(piece.len() - left.len()).unwrap_or_default();
        self.count_lines(bytes);
        self.record_bytes += bytes.len();
        self.text.iter_mut().for_each(|text| text.extend_from_slice(bytes));
        *piece = left;
        is_complete
    }

    /// Takes line ends and comments off the front of a piece.
    fn pass_comments(&mut self, piece: &mut &[u8]) {
        loop {
            if self.is_in_comment {
                let end = memchr2(b'\r', b'\n', piece);
                self.is_in_comment = end.is_none();
                let (comment, rest) = piece.split_at_checked(end.unwrap_or(piece.len())).unwrap_or_default();
                self.count_lines(comment);
                *piece = rest;
            }
            self.pass_line_ends(piece);
            // A piece ends with a line, so that enough of a line is there to tell.
            if !self.syntax.is_comment(piece) {
                return;
            }
            let end = memchr2(b'\r', b'\n', piece).unwrap_or(piece.len());
            let comment = piece.get(..end).unwrap_or_default();
            self.behind.add_comment(comment, self.syntax.delimiter, self.width);
            self.is_in_comment = true;
        }
    }

    /// Takes line ends off the front of a piece.
    fn pass_line_ends(&mut self, piece: &mut &[u8]) {
        let is_line_end = |byte: &u8| matches!(byte, b'\r' | b'\n');
        let length = piece.iter().take_while(|byte| is_line_end(byte)).count();
        let (line_ends, rest) = piece.split_at_checked(length).unwrap_or_default();
        self.count_lines(line_ends);
        *piece = rest;
    }

    fn count_lines(&mut self, bytes: &[u8]) {
        for position in memchr2_iter(b'\r', b'\n', bytes) {
            let is_after_return = match position.checked_sub(1) {
                Some(before) => bytes.get(before) == Some(&b'\r'),
                None => self.is_after_return,
            };
            let is_second_half = is_after_return && bytes.get(position) == Some(&b'\n');
            self.line += u64::from(!is_second_half);
        }
        if let Some(&last) = bytes.last() {
            self.is_after_return = last == b'\r';
        }
    }
}

#[cfg(test)]
mod tests;
