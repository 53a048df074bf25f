//! The text of records that the CSV library has taken apart.

use std::io::{self, Read};
use std::ops::Range;

use crate::records::Records;
use crate::source::over_full;

/// A reader that remembers what passes until it is asked for, if it is to.
pub(super) struct Tape<R> {
    inner: R,
    keep: bool,
    kept: Vec<u8>,
    /// Offset of the first byte kept.
    offset: u64,
}

impl<R> Tape<R> {
    pub(super) fn new(inner: R, keep: bool) -> Self {
        Tape { inner, keep, kept: Vec::new(), offset: 0 }
    }

    /// The bytes in a range without line ends around them; forgets them and what was before them.
    fn cut(&mut self, range: Range<u64>) -> Vec<u8> {
        self.kept.drain(..(range.start - self.offset) as usize);
        let bytes: Vec<u8> = self.kept.drain(..(range.end - range.start) as usize).collect();
        self.offset = range.end;
        let is_end = |byte: &u8| matches!(byte, b'\r' | b'\n');
        let blank = bytes.iter().take_while(|byte| is_end(byte)).count();
        let text = bytes.get(blank..).unwrap_or_default();
        text.strip_suffix(b"\n").or(text.strip_suffix(b"\r")).unwrap_or(text).to_vec()
    }
}

impl<R: Read> Records<Tape<R>> {
    /// The last record as it stands in the file, without its line end, when the tape keeps it; each one once.
    pub(super) fn text(&mut self) -> Option<Vec<u8>> {
        let range = self.range();
        let tape = self.input_mut();
        tape.keep.then(|| tape.cut(range))
    }
}

impl<R: Read> Read for Tape<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        if self.keep {
            self.kept.extend_from_slice(buffer.get(..count).ok_or_else(over_full)?);
        }
        Ok(count)
    }
}
