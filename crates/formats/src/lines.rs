//! Which line of a stream a byte is on.

use std::collections::VecDeque;
use std::io::{self, Read};

/// A reader that remembers where lines end, as far back as it has not been asked about.
///
/// The CSV library counts a line end only when it reads on, and skips blank lines before it says where a record starts;
/// messages need the line of the record itself.
pub(crate) struct LineCounter<R> {
    inner: R,
    offset: u64,
    /// Offsets of carriage returns and line feeds from `asked` on.
    ends: VecDeque<(u64, u8)>,
    /// The line of the byte last asked about, from 1.
    line: u64,
    after_carriage_return: Option<u64>,
}

impl<R> LineCounter<R> {
    /// A counter for bytes that start on this line.
    pub(crate) fn new(inner: R, line: u64) -> Self {
        LineCounter { inner, offset: 0, ends: VecDeque::new(), line, after_carriage_return: None }
    }

    pub(crate) fn get_ref(&self) -> &R {
        &self.inner
    }

    pub(crate) fn get_mut(&mut self) -> &mut R {
        &mut self.inner
    }

    /// The line of the first byte at or after `start` that does not end a line. Asked in ascending order.
    pub(crate) fn line_at(&mut self, start: u64) -> u64 {
        let mut start = start;
        while let Some(&(offset, byte)) = self.ends.front().filter(|(offset, _)| *offset <= start) {
            self.ends.pop_front();
            if offset == start {
                start += 1;
            }
            // A line feed right after a carriage return belongs to the same line end.
            let second_half = byte == b'\n' && self.after_carriage_return == Some(offset);
            self.line += u64::from(!second_half);
            self.after_carriage_return = (byte == b'\r').then_some(offset + 1);
        }
        self.line
    }
}

impl<R: Read> Read for LineCounter<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        for (position, &byte) in (self.offset..).zip(&buffer[..count]) {
            if matches!(byte, b'\r' | b'\n') {
                self.ends.push_back((position, byte));
            }
        }
        self.offset += count as u64;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_end_counts_once() {
        let text = b"a\nb\r\nc\rd\n\n\ne";
        let mut counter = LineCounter::new(&text[..], 1);
        io::copy(&mut counter, &mut io::sink()).unwrap();
        let line_of = |counter: &mut LineCounter<_>, start| counter.line_at(start);
        assert_eq!(line_of(&mut counter, 0), 1);
        assert_eq!(line_of(&mut counter, 2), 2);
        // As the library says it: between the two halves of a line end, and before blank lines.
        assert_eq!(line_of(&mut counter, 4), 3);
        assert_eq!(line_of(&mut counter, 7), 4);
        assert_eq!(line_of(&mut counter, 9), 7);
    }
}
