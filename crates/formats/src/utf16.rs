//! UTF-16 as a stream of UTF-8.

use std::io::{self, Read};

use crate::dialect::Encoding;

/// How many bytes are read at a time.
const BUFFER: usize = 1 << 16;

/// The encoding whose byte order mark a text starts with, if that is UTF-16.
pub(crate) fn utf16_of(start: &[u8]) -> Option<Encoding> {
    match start {
        // Four of them start an Arrow stream.
        [0xff, 0xfe, ..] => Some(Encoding::Utf16Le),
        [0xfe, 0xff, ..] => Some(Encoding::Utf16Be),
        _ => None,
    }
}

/// Shows UTF-16 as UTF-8. What is no character becomes U+FFFD, as everywhere.
pub(crate) struct Utf16Reader<R> {
    inner: R,
    encoding: Encoding,
    /// Bytes that were read but not decoded: less than two characters' worth.
    raw: Vec<u8>,
    /// What was decoded but not handed out.
    text: Vec<u8>,
    handed_out: usize,
    is_at_end: bool,
}

impl<R: Read> Utf16Reader<R> {
    /// A reader of bytes that go on after these, which may start with a byte order mark.
    pub(crate) fn new(start: &[u8], inner: R, encoding: Encoding) -> Self {
        let raw = start.to_vec();
        Utf16Reader { inner, encoding, raw, text: Vec::new(), handed_out: 0, is_at_end: false }
    }

    /// What is read from.
    pub(crate) fn inner(&self) -> &R {
        &self.inner
    }

    /// Decodes what there is, but for the start of a character that the next bytes may complete.
    fn decode(&mut self) {
        let is_little = self.encoding == Encoding::Utf16Le;
        let unit =
            |pair: &[u8; 2]| if is_little { u16::from_le_bytes(*pair) } else { u16::from_be_bytes(*pair) };
        let (pairs, rest) = self.raw.as_chunks::<2>();
        let mut units: Vec<u16> = pairs.iter().map(unit).collect();
        let mut kept = rest.to_vec();
        if self.is_at_end {
            units.extend((!std::mem::take(&mut kept).is_empty()).then_some(0xfffd));
        } else if let Some(high) = units.pop_if(|last| (0xd800..0xdc00).contains(last)) {
            let bytes = if is_little { high.to_le_bytes() } else { high.to_be_bytes() };
            kept.splice(0..0, bytes);
        }
        let characters = char::decode_utf16(units).map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER));
        (self.text, self.handed_out) = (characters.collect::<String>().into_bytes(), 0);
        self.raw = kept;
    }
}

impl<R: Read> Read for Utf16Reader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while self.handed_out == self.text.len() && !(self.is_at_end && self.raw.is_empty()) {
            if !self.is_at_end {
                let before = self.raw.len();
                self.raw.resize(before + BUFFER, 0);
                let read = self.inner.read(self.raw.get_mut(before..).unwrap_or_default());
                self.raw.truncate(before + read.as_ref().map_or(0, |count| *count));
                self.is_at_end = read? == 0;
            }
            self.decode();
        }
        let count = self.text.get(self.handed_out..).unwrap_or_default().read(buffer)?;
        self.handed_out += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    /// Hands out so many bytes at a time.
    struct Slow(Cursor<Vec<u8>>, usize);

    impl Read for Slow {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let most = buffer.len().min(self.1);
            self.0.read(&mut buffer[..most])
        }
    }

    #[test]
    fn both_orders_are_read_in_pieces_of_any_size() {
        let text = "x;µ\r\n1;\u{1f642}\u{2212}2\n";
        for encoding in [Encoding::Utf16Le, Encoding::Utf16Be] {
            let bytes = |unit: u16| match encoding {
                Encoding::Utf16Le => unit.to_le_bytes(),
                _ => unit.to_be_bytes(),
            };
            let bytes: Vec<u8> = text.encode_utf16().flat_map(bytes).collect();
            for (start, size) in [(0, 1), (1, 1), (2, 3), (3, 2), (5, 1000)] {
                let inner = Slow(Cursor::new(bytes[start..].to_vec()), size);
                let mut read = String::new();
                Utf16Reader::new(&bytes[..start], inner, encoding).read_to_string(&mut read).unwrap();
                assert_eq!(read, text);
            }
        }
    }

    #[test]
    fn what_is_no_character_is_replaced() {
        let broken = [b'1', 0, 0x00, 0xd8, b'2', 0, 0x01, 0xdc, b'3'];
        let mut read = String::new();
        Utf16Reader::new(&[], &broken[..], Encoding::Utf16Le).read_to_string(&mut read).unwrap();
        assert_eq!(read, "1\u{fffd}2\u{fffd}\u{fffd}");
    }
}
