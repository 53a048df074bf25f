//! Text in any encoding as a stream of UTF-8.
//!
//! Up to the first byte that is not ASCII, UTF-8 and Windows-1252 are the same text. That byte and those behind it decide: where they
//! are a character of UTF-8, the text is UTF-8, and else it is Windows-1252. So one pass over any stream is enough.

use std::io::{self, Read};

use sha2::{Digest, Sha256};

use crate::dialect::Encoding;
use crate::hash::hexadecimal;

/// The number of bytes decoded at a time.
const BUFFER: usize = 1 << 16;

/// The number of bytes that tell an encoding before anything is decoded.
const START: usize = 128;

/// The longest character of UTF-8.
const LONGEST_CHARACTER: usize = 4;

/// The characters of the bytes 0x80 to 0x9f in Windows-1252; the five that it leaves open are the control
/// characters of their number.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// The bytes of a file as they are, counted and hashed.
struct RawBytes {
    bytes: Box<dyn Read>,
    hash: Option<Sha256>,
    total: u64,
}

impl Read for RawBytes {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.bytes.read(buffer)?;
        self.total += count as u64;
        if let Some(hash) = &mut self.hash {
            hash.update(buffer.get(..count).unwrap_or_default());
        }
        Ok(count)
    }
}

/// The known facts about the bytes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Coding {
    /// ASCII so far.
    Open,
    Known(Encoding),
}

/// Shows a text as UTF-8. Bytes that are no character become U+FFFD. In a text that is otherwise UTF-8 they
/// stay as they are.
pub(crate) struct TextReader {
    raw: RawBytes,
    coding: Coding,
    /// Bytes that were read but neither decoded nor handed out.
    held: Vec<u8>,
    /// The error of reading behind the bytes.
    failure: Option<io::Error>,
    /// Text that was decoded but not handed out.
    text: Vec<u8>,
    handed_out: usize,
}

impl TextReader {
    /// A reader that shows the bytes as they are, until [`Self::begin`] is called.
    pub(crate) fn new(bytes: Box<dyn Read>, hash: bool) -> Self {
        TextReader {
            raw: RawBytes { bytes, hash: hash.then(Sha256::new), total: 0 },
            coding: Coding::Known(Encoding::Utf8),
            held: Vec::new(),
            failure: None,
            text: Vec::new(),
            handed_out: 0,
        }
    }

    /// Decodes from the first byte on: by the encoding that is asked for, or the one that the bytes tell.
    pub(crate) fn begin(&mut self, asked: Option<Encoding>) {
        // No more is read than what tells: somebody may be typing the text.
        while self.held.len() < 2 && self.failure.is_none() {
            let before = self.held.len();
            self.held.resize(before + START, 0);
            let read = self.raw.read(self.held.get_mut(before..).unwrap_or_default());
            self.held.truncate(before + read.as_ref().map_or(0, |count| *count));
            match read {
                Ok(0) => break,
                Ok(_) => {}
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => self.failure = Some(error),
            }
        }
        self.coding = match asked.or_else(|| utf16_of(&self.held)) {
            Some(encoding) => Coding::Known(encoding),
            None => Coding::Open,
        };
    }

    /// The first bytes as they are, once [`Self::begin`] was called and nothing has been read since.
    pub(crate) fn held(&self) -> &[u8] {
        &self.held
    }

    /// Returns the encoding of the bytes, as far as they were read.
    pub(crate) fn encoding(&self) -> Encoding {
        match self.coding {
            Coding::Open => Encoding::Utf8,
            Coding::Known(encoding) => encoding,
        }
    }

    /// Returns the number of bytes that were read.
    pub(crate) fn total(&self) -> u64 {
        self.raw.total
    }

    /// SHA-256 of all bytes read, in hexadecimal.
    pub(crate) fn sha256(&self) -> Option<String> {
        self.raw.hash.as_ref().map(hexadecimal)
    }

    /// Reads bytes as they are: those held, then others.
    fn read_raw(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if !self.held.is_empty() {
            let count = self.held.as_slice().read(buffer)?;
            self.held.drain(..count);
            return Ok(count);
        }
        match self.failure.take() {
            Some(failure) => Err(failure),
            None => self.raw.read(buffer),
        }
    }

    /// Reads ASCII, up to the character that tells the encoding.
    fn read_open(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut count = self.read_raw(buffer)?;
        loop {
            let bytes = buffer.get(..count).unwrap_or_default();
            if bytes.is_ascii() {
                return Ok(count);
            }
            let ascii = bytes.iter().take_while(|byte| byte.is_ascii()).count();
            let rest = bytes.get(ascii..).unwrap_or_default();
            let first = match std::str::from_utf8(rest.get(..LONGEST_CHARACTER).unwrap_or(rest)) {
                Err(error) if error.valid_up_to() == 0 => error.error_len(),
                _ => {
                    self.coding = Coding::Known(Encoding::Utf8);
                    return Ok(count);
                }
            };
            // A character may go on behind what was read, which goes on at the end of the ASCII before it.
            if first.is_none() && ascii > 0 {
                self.held = rest.to_vec();
                return Ok(ascii);
            }
            let more = match buffer.get_mut(count..) {
                Some(room) if first.is_none() && !room.is_empty() => self.raw_or_failure(room)?,
                _ => 0,
            };
            if more == 0 {
                self.coding = Coding::Known(Encoding::Windows1252);
                self.held.splice(..0, buffer.get(ascii..count).unwrap_or_default().iter().copied());
                return if ascii > 0 { Ok(ascii) } else { self.read(buffer) };
            }
            count += more;
        }
    }

    /// Reads behind the start of a character; a failure waits until the start has been handed out.
    fn raw_or_failure(&mut self, room: &mut [u8]) -> io::Result<usize> {
        match self.read_raw(room) {
            Err(error) if error.kind() != io::ErrorKind::Interrupted => {
                self.failure = Some(error);
                Ok(0)
            }
            read => read,
        }
    }

    /// Decodes what comes next; `false` at the end.
    fn decode(&mut self, encoding: Encoding) -> io::Result<bool> {
        let mut bytes = std::mem::take(&mut self.held);
        let mut is_at_end = false;
        // The pending bytes may be the start of a character.
        if bytes.len() < LONGEST_CHARACTER {
            let before = bytes.len();
            bytes.resize(before + BUFFER, 0);
            let read = self.raw_or_failure(bytes.get_mut(before..).unwrap_or_default());
            bytes.truncate(before + read.as_ref().map_or(0, |count| *count));
            if let Err(error) = read {
                self.held = bytes;
                return Err(error);
            }
            is_at_end = bytes.len() == before;
            if bytes.is_empty() {
                return self.failure.take().map_or(Ok(false), Err);
            }
        }
        (self.text, self.held) = decoded(&bytes, encoding, is_at_end);
        self.handed_out = 0;
        Ok(true)
    }
}

impl Read for TextReader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self.coding {
            Coding::Known(Encoding::Utf8) => self.read_raw(buffer),
            Coding::Open => self.read_open(buffer),
            Coding::Known(encoding) => {
                while self.handed_out == self.text.len() {
                    if !self.decode(encoding)? {
                        return Ok(0);
                    }
                }
                let count = self.text.get(self.handed_out..).unwrap_or_default().read(buffer)?;
                self.handed_out += count;
                Ok(count)
            }
        }
    }
}

/// The order of the bytes of UTF-16: by its byte order mark, or since every other byte of ASCII in it is zero, as none of a text is.
fn utf16_of(start: &[u8]) -> Option<Encoding> {
    match start {
        [0xff, 0xfe, ..] => return Some(Encoding::Utf16Le),
        [0xfe, 0xff, ..] => return Some(Encoding::Utf16Be),
        _ => {}
    }
    let pairs = start.as_chunks::<2>().0;
    let zeros = |at: usize| pairs.iter().filter(|pair| pair.get(at) == Some(&0)).count();
    let is_text = |byte: u8| byte.is_ascii_graphic() || byte.is_ascii_whitespace();
    match (pairs.first()?, zeros(0), zeros(1)) {
        (&[first, 0], 0, zeros) if is_text(first) && 2 * zeros > pairs.len() => Some(Encoding::Utf16Le),
        (&[0, first], zeros, 0) if is_text(first) && 2 * zeros > pairs.len() => Some(Encoding::Utf16Be),
        _ => None,
    }
}

/// Returns bytes as UTF-8, and the bytes at their end that begin a character.
fn decoded(bytes: &[u8], encoding: Encoding, is_at_end: bool) -> (Vec<u8>, Vec<u8>) {
    let by_byte = |character: &dyn Fn(u8) -> char| -> (Vec<u8>, Vec<u8>) {
        (bytes.iter().map(|&byte| character(byte)).collect::<String>().into_bytes(), Vec::new())
    };
    match encoding {
        Encoding::Utf8 => (bytes.to_vec(), Vec::new()),
        Encoding::Utf16Le => utf16(bytes, u16::from_le_bytes, u16::to_le_bytes, is_at_end),
        Encoding::Utf16Be => utf16(bytes, u16::from_be_bytes, u16::to_be_bytes, is_at_end),
        Encoding::Windows1252 => by_byte(&|byte| {
            let index = byte.wrapping_sub(0x80);
            WINDOWS_1252.get(usize::from(index)).copied().unwrap_or(char::from(byte))
        }),
        Encoding::Iso8859Part1 => by_byte(&char::from),
        Encoding::Iso8859Part15 => by_byte(&|byte| match byte {
            0xa4 => '€',
            0xa6 => 'Š',
            0xa8 => 'š',
            0xb4 => 'Ž',
            0xb8 => 'ž',
            0xbc => 'Œ',
            0xbd => 'œ',
            0xbe => 'Ÿ',
            other => char::from(other),
        }),
    }
}

/// UTF-16 in one order of bytes.
fn utf16(
    bytes: &[u8],
    unit: fn([u8; 2]) -> u16,
    bytes_of: fn(u16) -> [u8; 2],
    is_at_end: bool,
) -> (Vec<u8>, Vec<u8>) {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let mut units: Vec<u16> = pairs.iter().map(|&pair| unit(pair)).collect();
    let mut kept = rest.to_vec();
    if is_at_end {
        units.extend((!std::mem::take(&mut kept).is_empty()).then_some(0xfffd));
    } else if let Some(high) = units.pop_if(|last| (0xd800..0xdc00).contains(last)) {
        kept.splice(0..0, bytes_of(high));
    }
    let characters = char::decode_utf16(units).map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER));
    (characters.collect::<String>().into_bytes(), kept)
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

    /// Decodes bytes that come in pieces of this size, and returns the text and its encoding.
    fn read(bytes: &[u8], size: usize, asked: Option<Encoding>) -> (String, Encoding) {
        let mut reader = TextReader::new(Box::new(Slow(Cursor::new(bytes.to_vec()), size)), false);
        reader.begin(asked);
        let mut text = Vec::new();
        reader.read_to_end(&mut text).unwrap();
        assert_eq!(reader.total(), bytes.len() as u64);
        (String::from_utf8_lossy(&text).into_owned(), reader.encoding())
    }

    const SIZES: [usize; 6] = [1, 2, 3, 7, 1000, 100_000];

    #[test]
    fn both_orders_of_utf16_are_read_in_pieces_of_any_size() {
        let text = "x;µ\r\n1;\u{1f642}\u{2212}2\n";
        for encoding in [Encoding::Utf16Le, Encoding::Utf16Be] {
            let bytes = |unit: u16| match encoding {
                Encoding::Utf16Le => unit.to_le_bytes(),
                _ => unit.to_be_bytes(),
            };
            let bytes: Vec<u8> = text.encode_utf16().flat_map(bytes).collect();
            for size in SIZES {
                // Without a mark, since every other byte is zero.
                assert_eq!(read(&bytes, size, None), (text.to_owned(), encoding), "{size}");
                assert_eq!(read(&bytes, size, Some(encoding)), (text.to_owned(), encoding), "{size}");
            }
        }
    }

    #[test]
    fn what_is_no_character_is_replaced() {
        let broken = [b'1', 0, 0x00, 0xd8, b'2', 0, 0x01, 0xdc, b'3'];
        for size in SIZES {
            assert_eq!(read(&broken, size, Some(Encoding::Utf16Le)).0, "1\u{fffd}2\u{fffd}\u{fffd}");
        }
    }

    #[test]
    fn the_first_character_that_is_not_ascii_tells_the_encoding() {
        let deep = "1,2\n".repeat(50_000);
        for before in ["", "x", "x,y\n1,2\n", &deep] {
            for (bytes, behind, encoding) in [
                (&b""[..], "", Encoding::Utf8),
                (b"\xc3\xa4,1", "ä,1", Encoding::Utf8),
                (b"\xe2\x82\xac", "€", Encoding::Utf8),
                (b"\xf0\x9f\x99\x82", "\u{1f642}", Encoding::Utf8),
                // Later on bytes that are none stay as they are.
                (b"\xc3\xa4\xb0", "ä\u{fffd}", Encoding::Utf8),
                (b"\xb0C,1", "°C,1", Encoding::Windows1252),
                (b"\xe4\xf6\x80\x81", "äö€\u{81}", Encoding::Windows1252),
                (b"\xc3", "Ã", Encoding::Windows1252),
                (b"\xe2\x82", "â‚", Encoding::Windows1252),
                (b"\xe2\x82,\xb0", "â‚,°", Encoding::Windows1252),
                (b"\xb5 \xc3\xa4", "µ Ã¤", Encoding::Windows1252),
            ] {
                let content = [before.as_bytes(), bytes].concat();
                for size in SIZES {
                    assert_eq!(read(&content, size, None), (format!("{before}{behind}"), encoding), "{size}");
                }
            }
        }
    }

    #[test]
    fn an_encoding_that_is_asked_for_is_taken() {
        for (encoding, text) in [
            (Encoding::Windows1252, "Ã¤€¤"),
            (Encoding::Iso8859Part1, "Ã¤\u{80}¤"),
            (Encoding::Iso8859Part15, "Ã€\u{80}€"),
        ] {
            assert_eq!(read(b"\xc3\xa4\x80\xa4", 3, Some(encoding)), (text.to_owned(), encoding));
        }
        let utf8 = read(b"\xb0,\xc3\xa4", 3, Some(Encoding::Utf8));
        assert_eq!(utf8, ("\u{fffd},ä".to_owned(), Encoding::Utf8));
    }

    #[test]
    fn a_failure_comes_behind_what_was_read_before_it() {
        struct Failing;
        impl Read for Failing {
            fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
                Err(io::Error::other("gone"))
            }
        }
        for start in [&b"x"[..], b"x,\xe4", b"x,\xb0", b"x\0,\0"] {
            let bytes = Slow(Cursor::new(start.to_vec()), 1).chain(Failing);
            let mut reader = TextReader::new(Box::new(bytes), false);
            reader.begin(None);
            let mut text = Vec::new();
            assert_eq!(reader.read_to_end(&mut text).unwrap_err().to_string(), "gone");
            assert!(text.starts_with(b"x"), "{start:?}");
        }
    }
}
