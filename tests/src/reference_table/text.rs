//! The bytes of a table before records are made of them.

use std::borrow::Cow;
use std::{io, iter};

use super::BYTE_ORDER_MARK;

/// The characters of the bytes 0x80 to 0x9f in Windows-1252.
const WINDOWS_1252: &str = "€\u{81}‚ƒ„…†‡ˆ‰Š‹Œ\u{8d}Ž\u{8f}\u{90}‘’“”•–—˜™š›œ\u{9d}žŸ";

/// Returns whether bytes may be those of a binary table, which is refused in words of its own.
pub fn may_be_binary(bytes: &[u8]) -> bool {
    let starts: [&[u8]; 14] = [
        b"PAR1",
        b"ARROW1",
        b"\xff\xff\xff\xff",
        b"\x89HDF",
        b"MATLAB",
        b"PK\x03\x04",
        b"%PDF-",
        b"\x89PNG\r\n\x1a\n",
        b"\xff\xd8\xff",
        b"$FL",
        b"<stata_dta>",
        b"RDX",
        b"{\\rtf",
        b"Octave-1-",
    ];
    let in_utf8 = &*in_utf8(bytes);
    let is_binary = |bytes: &[u8]| {
        let start = &bytes[..bytes.len().min(128)];
        let is_control = |byte: &u8| *byte < b' ' && !byte.is_ascii_whitespace();
        starts.iter().any(|format| bytes.starts_with(format)) || start.iter().any(is_control)
    };
    // JSON, documents of other programs, and what has comments before what tells.
    let first = in_utf8.strip_prefix(BYTE_ORDER_MARK).unwrap_or(in_utf8).trim_ascii_start().first();
    is_binary(bytes) || is_binary(in_utf8) || first.is_some_and(|first| b"{[<!@%#tT\\".contains(first))
}

/// Returns whether bytes may be those of another text with a table: JSON, Octave's.
pub fn may_be_records(bytes: &[u8]) -> bool {
    let start = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes).trim_ascii_start();
    // In UTF-16 other bytes stand before and between.
    let mut shown = start.iter().filter(|byte| !byte.is_ascii_whitespace() && !matches!(byte, 0 | 0xfe..));
    shown.next().is_some_and(|first| b"{[".contains(first))
        || start.starts_with(b"# ")
        || start.starts_with(b"% ")
}

/// The bytes of UTF-16 and of Windows-1252 as UTF-8, and other bytes as they are.
pub fn in_utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    let start = &bytes[..bytes.len().min(128)];
    let zeros = |at: usize| start.chunks_exact(2).filter(|pair| pair[at] == 0).count();
    let is_utf16 = |at: usize| {
        let first =
            start.get(1 - at).is_some_and(|&first| first.is_ascii_graphic() || first.is_ascii_whitespace());
        start.len() > 1 && first && start[at] == 0 && zeros(1 - at) == 0 && 2 * zeros(at) > start.len() / 2
    };
    let unit: fn([u8; 2]) -> u16 = match bytes {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        _ if is_utf16(1) => u16::from_le_bytes,
        _ if is_utf16(0) => u16::from_be_bytes,
        _ => {
            // The first character that is not ASCII tells.
            let is_other = |error: std::str::Utf8Error| bytes[..error.valid_up_to()].is_ascii();
            return match std::str::from_utf8(bytes).is_err_and(is_other) {
                true => Cow::Owned(
                    bytes.iter().map(|&byte| by_windows_1252(byte)).collect::<String>().into_bytes(),
                ),
                false => Cow::Borrowed(bytes),
            };
        }
    };
    let pairs = bytes.chunks_exact(2);
    // Half a unit at the end is no character either.
    let half = (!pairs.remainder().is_empty()).then_some(char::REPLACEMENT_CHARACTER);
    let units: Vec<u16> = pairs.map(|pair| unit([pair[0], pair[1]])).collect();
    Cow::Owned(String::from_utf16_lossy(&units).chars().chain(half).collect::<String>().into_bytes())
}

fn by_windows_1252(byte: u8) -> char {
    match byte {
        0x80..0xa0 => WINDOWS_1252.chars().nth(usize::from(byte) - 0x80).unwrap_or_default(),
        byte => char::from(byte),
    }
}

/// A table whose first lines are empty where they were blank; tabs that are known to separate cells are not.
pub(super) fn without_blank_lines(text: &[u8], delimiter: Option<u8>) -> Vec<u8> {
    // The library passes over a byte order mark of its own.
    let (mark, text) =
        text.split_at(if text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 });
    let is_blank = |byte: &u8| byte.is_ascii_whitespace() && !(*byte == b'\t' && delimiter == Some(b'\t'));
    let is_line_end = |byte: &u8| matches!(byte, b'\r' | b'\n');
    let filled = text.iter().position(|byte| !is_blank(byte)).unwrap_or(text.len());
    let start = match text[..filled].iter().rposition(is_line_end) {
        _ if filled == text.len() => filled,
        last => last.map_or(0, |last| last + 1),
    };
    // One line feed for each line, lest a carriage return and a line feed with blanks between become one line end.
    let ends = line_ends(text, 0, start) as usize;
    let mark = if start == 0 { mark } else { &[] };
    mark.iter().copied().chain(iter::repeat_n(b'\n', ends)).chain(text[start..].iter().copied()).collect()
}

/// Returns how many lines end in a range: a carriage return and a line feed right after it are one end.
pub(super) fn line_ends(text: &[u8], start: usize, end: usize) -> u64 {
    let ends = |&at: &usize| match text[at] {
        b'\n' => at == 0 || text[at - 1] != b'\r',
        byte => byte == b'\r',
    };
    (start..end).filter(ends).count() as u64
}

/// A semicolon, tab, comma or bar, if there is one outside quotes in the first line that is not blank.
pub fn detect(text: &[u8]) -> Option<u8> {
    let mut lines = text.split(|&byte| matches!(byte, b'\r' | b'\n'));
    let line = lines.find(|line| !line.trim_ascii().is_empty()).unwrap_or_default();
    let outside = line.split(|&byte| byte == b'"').step_by(2).collect::<Vec<_>>().concat();
    [b';', b'\t', b',', b'|'].into_iter().find(|delimiter| outside.contains(delimiter))
}

/// Fails when it is read.
pub(super) struct Failing(pub(super) Option<String>);

impl io::Read for Failing {
    fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
        self.0.take().map_or(Ok(0), |words| Err(io::Error::other(words)))
    }
}
