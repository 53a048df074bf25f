//! Reading the data (section 2) as they stream by, without the program's own reader: rows of cells, how many they are, and
//! the hash of all bytes.

use std::io::{self, BufRead, BufReader, Chain, Cursor, Read};
use std::ops::Range;

use boundfit_exact::{PlainPrefix, plain_decimal, plain_prefix};
use memchr::{memchr, memchr3};
use sha2::{Digest, Sha256};

use crate::failure::{Failure, Refusal};

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// The rows of delimited text that are not blank. One of them is in memory at a time, and of that the cells that are asked
/// for.
pub(crate) struct Rows<R> {
    input: BufReader<Chain<Cursor<Vec<u8>>, Hashed<R>>>,
    row: Row,
    /// True if a line feed that comes next belongs to the carriage return before it.
    after_return: bool,
    /// The number of rows there were that are not blank.
    count: u64,
    /// The number of rows up to the last one with a cell that is not empty.
    filled: u64,
}

/// The look of rows, and their largest size.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shape {
    pub(crate) delimiter: u8,
    /// The number of cells of a row that are kept.
    pub(crate) kept: usize,
    /// Bytes of a row without its line end.
    pub(crate) longest: usize,
    /// Cells of a row.
    pub(crate) columns: usize,
}

impl<R: Read> Rows<R> {
    pub(crate) fn new(data: R, shape: Shape) -> Result<Self, Failure> {
        let mut data = Hashed { data, hash: Sha256::new() };
        let mut start = Vec::new();
        let most = 2 * BYTE_ORDER_MARK.len() as u64;
        data.by_ref().take(most).read_to_end(&mut start).map_err(Failure::Unreadable)?;
        // One of the file, and one more that a program which does not know it may have put before it.
        for _ in 0..2 {
            if start.starts_with(BYTE_ORDER_MARK) {
                start.drain(..BYTE_ORDER_MARK.len());
            }
        }
        let input = BufReader::with_capacity(1 << 16, Cursor::new(start).chain(data));
        Ok(Rows { input, row: Row::new(shape), after_return: false, count: 0, filled: 0 })
    }

    /// Goes on to the next row that is not blank; `false` at the end.
    pub(crate) fn next(&mut self) -> Result<bool, Failure> {
        while self.take_row()? {
            if !self.row.is_blank() {
                self.count += 1;
                if self.row.is_filled {
                    self.filled = self.count;
                }
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Goes on to the first row as [`Rows::next`] does, and keeps all of its cells.
    pub(crate) fn header(&mut self) -> Result<bool, Failure> {
        let kept = std::mem::replace(&mut self.row.shape.kept, self.row.shape.columns);
        let found = self.next();
        self.row.shape.kept = kept;
        found
    }

    /// The number of rows there were so far.
    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    /// The cells of the row, as far as they are kept.
    pub(crate) fn cells(&self) -> Cells<'_> {
        Cells { text: &self.row.text, ends: &self.row.ends }
    }

    /// The SHA-256 of all bytes, the rest of which is read, and the number of rows. Rows of empty cells at the end do not count.
    pub(crate) fn finish(mut self) -> Result<(String, u64), Failure> {
        while self.next()? {}
        let hash = self.input.into_inner().into_inner().1.hash.finalize();
        Ok((hexadecimal(&hash), self.filled))
    }

    /// The next row, blank or not; `false` at the end.
    fn take_row(&mut self) -> Result<bool, Failure> {
        self.row.begin();
        let mut length = 0;
        loop {
            let buffer = self.input.fill_buf().map_err(Failure::Unreadable)?;
            if buffer.is_empty() {
                if length > 0 {
                    self.row.end_cell()?;
                    self.row.end();
                }
                return Ok(length > 0);
            }
            if self.after_return && buffer.first() == Some(&b'\n') {
                self.input.consume(1);
                self.after_return = false;
                continue;
            }
            let (taken, line_end) = self.row.take(buffer)?;
            self.input.consume(taken + usize::from(line_end.is_some()));
            self.after_return = line_end == Some(b'\r');
            length += taken;
            if length > self.row.shape.longest {
                let limit = self.row.shape.longest;
                return Err(Failure::Refused(Refusal::RowTooLong { row: self.count + 1, limit }));
            }
            if line_end.is_some() {
                self.row.end();
                return Ok(true);
            }
        }
    }
}

/// The row that is being read.
struct Row {
    shape: Shape,
    state: State,
    /// The text of the cells that are kept, a line feed behind each of them, and where each of them ends.
    text: Vec<u8>,
    ends: Vec<usize>,
    /// The number of cells that have ended.
    cells: usize,
    /// True if a cell has a byte that is not white space.
    is_filled: bool,
}

/// The place of the next byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    CellStart,
    Plain,
    Quoted,
    /// The place behind a quote within quotes, which ends them unless it is doubled.
    AfterQuote,
}

impl Row {
    fn new(shape: Shape) -> Self {
        Row { shape, state: State::CellStart, text: Vec::new(), ends: Vec::new(), cells: 0, is_filled: false }
    }

    fn begin(&mut self) {
        self.text.clear();
        self.ends.clear();
        (self.state, self.cells, self.is_filled) = (State::CellStart, 0, false);
    }

    /// Adds what may be looked at behind the last cell.
    fn end(&mut self) {
        self.text.extend_from_slice(&[b'\n'; LOOK_AHEAD]);
    }

    /// Returns whether it is one cell of white space. The first cell is always kept.
    fn is_blank(&self) -> bool {
        self.cells == 1 && self.text.trim_ascii().is_empty()
    }

    /// Takes bytes off the front of a piece of the data, up to the end of the row if there is one. Returns the number
    /// of bytes before the end, and the byte that ends the row.
    fn take(&mut self, piece: &[u8]) -> Result<(usize, Option<u8>), Failure> {
        let mut at = 0;
        while let Some(&byte) = piece.get(at) {
            match self.state {
                State::CellStart | State::AfterQuote if byte == b'"' => {
                    // Behind a quote within quotes it is the second half of a doubled one.
                    self.keep(if self.state == State::AfterQuote { b"\"" } else { b"" });
                    self.state = State::Quoted;
                    at += 1;
                }
                State::Quoted => {
                    let own = up_to(piece.get(at..), |rest| memchr(b'"', rest));
                    self.keep(own);
                    at += own.len();
                    if at < piece.len() {
                        self.state = State::AfterQuote;
                        at += 1;
                    }
                }
                State::CellStart | State::AfterQuote | State::Plain => {
                    self.state = State::Plain;
                    let delimiter = self.shape.delimiter;
                    let own = up_to(piece.get(at..), |rest| memchr3(delimiter, b'\n', b'\r', rest));
                    self.keep(own);
                    at += own.len();
                    let Some(&end) = piece.get(at) else { break };
                    self.end_cell()?;
                    if end != delimiter {
                        return Ok((at, Some(end)));
                    }
                    self.state = State::CellStart;
                    at += 1;
                }
            }
        }
        Ok((piece.len(), None))
    }

    /// Appends bytes to the cell, if it is kept.
    fn keep(&mut self, bytes: &[u8]) {
        self.is_filled = self.is_filled || !bytes.trim_ascii_start().is_empty();
        if self.cells < self.shape.kept.max(1) {
            self.text.extend_from_slice(bytes);
        }
    }

    fn end_cell(&mut self) -> Result<(), Failure> {
        if self.cells < self.shape.kept {
            self.ends.push(self.text.len());
            self.text.push(b'\n');
        }
        self.cells += 1;
        if self.cells > self.shape.columns {
            return Err(Failure::Refused(Refusal::TooManyColumns(self.shape.columns)));
        }
        Ok(())
    }
}

/// The bytes before the first one that ends them.
fn up_to(bytes: Option<&[u8]>, end: impl Fn(&[u8]) -> Option<usize>) -> &[u8] {
    let bytes = bytes.unwrap_or_default();
    bytes.get(..end(bytes).unwrap_or(bytes.len())).unwrap_or_default()
}

/// The number of bytes that a short number is read from, in one go, without a look at where its cell ends.
const LOOK_AHEAD: usize = 32;

/// The first cells of a row.
#[derive(Clone, Copy)]
pub(crate) struct Cells<'a> {
    text: &'a [u8],
    ends: &'a [usize],
}

impl<'a> Cells<'a> {
    /// The cell of a column, from 1.
    pub(crate) fn get(self, column: usize) -> Option<&'a [u8]> {
        self.text.get(self.range(column)?)
    }

    fn range(self, column: usize) -> Option<Range<usize>> {
        let index = column.checked_sub(1)?;
        let start =
            index.checked_sub(1).map_or(Some(0), |before| self.ends.get(before).map(|end| end + 1))?;
        Some(start..*self.ends.get(index)?)
    }

    /// The cell of a column, from 1, as [`plain_decimal`] reads it.
    pub(crate) fn decimal(self, column: usize) -> Option<(i64, i32)> {
        let cell = self.range(column)?;
        match plain_prefix(self.text.get(cell.start..)?) {
            Some(PlainPrefix { mantissa, fraction_digits, length }) if length == cell.len() => {
                Some(if mantissa == 0 { (0, 0) } else { (mantissa, -fraction_digits) })
            }
            _ => plain_decimal(self.text.get(cell)?),
        }
    }
}

pub(crate) fn hexadecimal(hash: &[u8]) -> String {
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Hashes what is read.
struct Hashed<R> {
    data: R,
    hash: Sha256,
}

impl<R: Read> Read for Hashed<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.data.read(buffer)?;
        self.hash.update(buffer.get(..count).unwrap_or_default());
        Ok(count)
    }
}
