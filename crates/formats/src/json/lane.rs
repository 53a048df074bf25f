//! Objects with the same keys in the same order as the object before, which are most: read from the bytes at hand, a key by one
//! comparison. All others are read token by token, with the same cells.

use super::records::Records;

/// The keys of an object in their order.
#[derive(Default)]
pub(super) struct Shape {
    /// Each key, and its column unless there is none.
    keys: Vec<(String, Option<usize>)>,
}

/// An object that was read: how many bytes it takes, the line ends among them, and the bytes of its keys and values.
pub(super) struct Passed {
    pub(super) bytes: usize,
    pub(super) lines: u64,
    pub(super) held: usize,
}

impl Shape {
    /// The shape of an object with these keys; none where it has a key twice, or a key that may be written in several ways.
    pub(super) fn new(keys: Vec<(String, Option<usize>)>) -> Option<Self> {
        let is_plain = |(at, (key, _)): (usize, &(String, Option<usize>))| {
            !key.contains(['"', '\\', '\n']) && keys.iter().take(at).all(|(other, _)| other != key)
        };
        /// Comparing each key with all others is quick as long as there are few.
        const MOST_KEYS: usize = 64;
        (keys.len() <= MOST_KEYS && keys.iter().enumerate().all(is_plain)).then_some(Shape { keys })
    }

    /// Adds the cells of an object of this shape, which begins with these bytes. Returns `None`, and may have added cells, where the
    /// bytes end before it or anything is unusual about it.
    pub(super) fn read(&self, bytes: &[u8], records: &mut Records) -> Option<Passed> {
        let mut lane = Lane { bytes, at: 0, lines: 0 };
        let mut held = 0;
        let mut before = b'{';
        for (key, column) in &self.keys {
            lane.take(before)?;
            lane.take(b'"')?;
            lane.pass(key.as_bytes())?;
            lane.pass(b"\"")?;
            lane.take(b':')?;
            let (text, bytes) = lane.value()?;
            held += key.len() + bytes;
            if let Some(column) = column {
                records.push(*column, text);
            }
            before = b',';
        }
        if self.keys.is_empty() {
            lane.take(b'{')?;
        }
        lane.take(b'}')?;
        Some(Passed { bytes: lane.at, lines: lane.lines, held })
    }
}

/// Bytes on their way.
struct Lane<'b> {
    bytes: &'b [u8],
    at: usize,
    /// The line ends passed over.
    lines: u64,
}

impl<'b> Lane<'b> {
    fn rest(&self) -> &'b [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// The next byte that is no white space, which stays.
    fn next(&mut self) -> Option<u8> {
        loop {
            match *self.bytes.get(self.at)? {
                byte if byte.is_ascii_whitespace() => {
                    self.lines += u64::from(byte == b'\n');
                    self.at += 1;
                }
                byte => return Some(byte),
            }
        }
    }

    /// Passes over this byte, which must come next behind white space.
    fn take(&mut self, wanted: u8) -> Option<()> {
        (self.next()? == wanted).then(|| self.at += 1)
    }

    /// Passes over these bytes, which must come next.
    fn pass(&mut self, wanted: &[u8]) -> Option<()> {
        self.rest().starts_with(wanted).then(|| self.at += wanted.len())
    }

    /// A text without escapes or line ends, a number, or a word: the cell, in UTF-8, and how many bytes it takes.
    fn value(&mut self) -> Option<(&'b [u8], usize)> {
        if self.next()? == b'"' {
            self.at += 1;
            let rest = self.rest();
            let mut end = rest.iter().position(|&byte| is_end_of_text(byte) || !byte.is_ascii())?;
            if !rest.get(end)?.is_ascii() {
                end = rest.iter().position(|&byte| is_end_of_text(byte))?;
                std::str::from_utf8(rest.get(..end)?).ok()?;
            }
            self.at += end;
            self.pass(b"\"")?;
            return Some((rest.get(..end)?, end));
        }
        let rest = self.rest();
        let end = rest.iter().position(|&byte| !is_of_word(byte)).filter(|&end| end > 0)?;
        self.at += end;
        let word = rest.get(..end)?;
        Some((if word == b"null" { b"" } else { word }, end))
    }
}

/// Returns whether a byte ends a text or what is read of one by comparing bytes.
fn is_end_of_text(byte: u8) -> bool {
    matches!(byte, b'"' | b'\\' | b'\n')
}

/// Returns whether a byte may be one of a number or a word such as `null`.
#[inline]
pub(super) fn is_of_word(byte: u8) -> bool {
    /// A bit for each byte.
    const BITS: [u64; 2] = {
        let mut bits = 0_u128;
        let mut byte = 0_u8;
        while byte < 128 {
            if byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'+' | b'.') {
                bits |= 1 << byte;
            }
            byte += 1;
        }
        [bits as u64, (bits >> 64) as u64]
    };
    let [low, high] = BITS;
    let bits = if byte < 64 { low } else { high };
    byte.is_ascii() && bits >> (byte & 63) & 1 == 1
}
