//! Which line of a stream a record is on, and how long it is.

use std::collections::VecDeque;
use std::io::{self, Read};

use crate::error::InputErrorKind;
use crate::source::{Stopped, over_full};

/// A reader between the CSV library and its input that knows on which line the current record starts.
///
/// The library counts a line end only when it reads on, and skips blank lines before it says where a record starts;
/// messages need the line of the record itself. The library reads on only when it has used up what it read before, so
/// that nothing need be remembered but the line ends of the last piece, however long a record and however many blank
/// lines before it.
pub(crate) struct LineCounter<R> {
    inner: R,
    offset: u64,
    /// Offsets of carriage returns and line feeds in the last piece, as far as they are not counted.
    ends: VecDeque<(u64, u8)>,
    /// The line of what comes after the line ends that are counted, from 1.
    line: u64,
    after_carriage_return: Option<u64>,
    /// The current record: its line, and its first byte as far as it is known.
    record_line: u64,
    record_start: u64,
    is_started: bool,
    longest_record: u64,
}

impl<R> LineCounter<R> {
    /// A counter for bytes that start on this line, with records of at most so many bytes.
    pub(crate) fn new(inner: R, line: u64, longest_record: usize) -> Self {
        LineCounter {
            inner,
            offset: 0,
            ends: VecDeque::new(),
            line,
            after_carriage_return: None,
            record_line: line,
            record_start: 0,
            is_started: false,
            longest_record: longest_record as u64,
        }
    }

    pub(crate) fn get_ref(&self) -> &R {
        &self.inner
    }

    pub(crate) fn get_mut(&mut self) -> &mut R {
        &mut self.inner
    }

    /// From here on comes the next record, perhaps after blank lines.
    pub(crate) fn begin(&mut self, position: u64) {
        self.record_start = position;
        while let Some(&(offset, byte)) = self.ends.front().filter(|(end, _)| *end <= self.record_start) {
            self.ends.pop_front();
            if offset == self.record_start {
                self.record_start += 1;
            }
            self.count(offset, byte);
        }
        self.record_line = self.line;
        self.is_started = self.record_start < self.offset;
    }

    /// The line on which the current record starts.
    pub(crate) fn record_line(&self) -> u64 {
        self.record_line
    }

    /// What is wrong with a current record that reaches up to this byte.
    pub(crate) fn too_long(&self, end: u64) -> Option<InputErrorKind> {
        let is_too_long = end.saturating_sub(self.record_start) > self.longest_record;
        is_too_long.then_some(InputErrorKind::RowTooLong { limit: self.longest_record as usize })
    }

    fn count(&mut self, offset: u64, byte: u8) {
        // A line feed right after a carriage return belongs to the same line end.
        let second_half = byte == b'\n' && self.after_carriage_return == Some(offset);
        self.line += u64::from(!second_half);
        self.after_carriage_return = (byte == b'\r').then_some(offset + 1);
    }
}

impl<R: Read> Read for LineCounter<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if let Some(problem) = self.too_long(self.offset).filter(|_| self.is_started) {
            return Err(io::Error::other(Stopped { line: self.record_line, problem }));
        }
        let count = self.inner.read(buffer)?;
        while let Some((offset, byte)) = self.ends.pop_front() {
            self.count(offset, byte);
        }
        for (position, &byte) in (self.offset..).zip(buffer.get(..count).ok_or_else(over_full)?) {
            let is_end = matches!(byte, b'\r' | b'\n');
            match (is_end, self.is_started) {
                (true, true) => self.ends.push_back((position, byte)),
                (true, false) => {
                    self.count(position, byte);
                    self.record_start = position + 1;
                    self.record_line = self.line;
                }
                (false, started) => self.is_started = started || position >= self.record_start,
            }
        }
        self.offset += count as u64;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &[u8] = b"a\nb\r\nc\rd\n\n\ne";

    #[test]
    fn every_kind_of_line_end_counts_once() {
        let mut counter = LineCounter::new(TEXT, 1, 100);
        assert_eq!(counter.read(&mut [0; 64]).unwrap(), TEXT.len());
        // As the library says it: between the two halves of a line end, and before blank lines.
        for (position, line) in [(0, 1), (2, 2), (4, 3), (7, 4), (9, 7)] {
            counter.begin(position);
            assert_eq!(counter.record_line(), line, "from byte {position} on");
        }
    }

    #[test]
    fn a_record_has_its_line_however_small_the_pieces_are_that_are_read() {
        // Where records end for the library, and the lines on which they start.
        let records = [(0, 2, 1), (2, 4, 2), (4, 7, 3), (7, 9, 4), (9, 12, 7)];
        for size in 1..=TEXT.len() {
            let mut counter = LineCounter::new(TEXT, 1, 100);
            let mut read = 0;
            for (start, end, line) in records {
                counter.begin(start);
                // The library reads on only when it has used up everything.
                while read < end {
                    read += counter.read(&mut vec![0; size]).unwrap() as u64;
                }
                assert_eq!(counter.record_line(), line, "in pieces of {size} bytes");
            }
        }
    }

    #[test]
    fn blank_lines_are_not_remembered_and_an_endless_record_stops() {
        let mut counter =
            LineCounter::new(io::repeat(b'\n').take(1 << 20).chain(io::repeat(b'x')), 1, 1 << 17);
        counter.begin(0);
        let mut buffer = vec![0; 1 << 16];
        for _ in 0..16 {
            counter.read_exact(&mut buffer).unwrap();
            assert!(counter.ends.is_empty());
        }
        let stopped = io::copy(&mut counter, &mut io::sink()).unwrap_err().downcast::<Stopped>().unwrap();
        assert_eq!(stopped.line, 1 + (1 << 20));
        assert!(matches!(stopped.problem, InputErrorKind::RowTooLong { limit: 131_072 }));
    }
}
