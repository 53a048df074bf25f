//! JSON as a stream of cells: what a record holds is text or nothing, and what is nested deeper is passed over.

use std::io::{self, Read};

use super::lane::{Passed, is_of_word};
use crate::error::{InputError, InputErrorKind, Place};
use crate::limits::SizeLimits;

/// The number of bytes read at a time.
const BUFFER: usize = 1 << 16;

/// The number of bytes of unreadable text that a message shows.
const SHOWN: usize = 20;

/// Names for an object or array where a number belongs.
pub(super) const NESTED: [&str; 2] = ["{...}", "[...]"];

/// JSON on its way.
pub(super) struct Tokens<'a, R> {
    file: &'a str,
    input: R,
    buffer: Vec<u8>,
    at: usize,
    line: u64,
    /// The number of bytes passed over, and the number of bytes of the record that are held.
    passed: u64,
    held: usize,
    sizes: &'a SizeLimits,
}

impl<'a, R: Read> Tokens<'a, R> {
    pub(super) fn new(file: &'a str, input: R, sizes: &'a SizeLimits) -> Self {
        Tokens { file, input, buffer: Vec::new(), at: 0, line: 1, passed: 0, held: 0, sizes }
    }

    pub(super) fn input(&self) -> &R {
        &self.input
    }

    /// The line reached, from 1.
    pub(super) fn line(&self) -> u64 {
        self.line
    }

    /// Returns the number of bytes that were passed over.
    pub(super) fn passed(&self) -> u64 {
        self.passed
    }

    /// The bytes that were read and come next.
    pub(super) fn at_hand(&self) -> &[u8] {
        self.buffer.get(self.at..).unwrap_or_default()
    }

    /// Passes over some of the bytes at hand, as one of them after the other would; `true`.
    pub(super) fn advance(&mut self, passed: Passed) -> bool {
        self.at += passed.bytes;
        self.passed += passed.bytes as u64;
        self.line += passed.lines;
        true
    }

    /// Returns the most bytes of keys and values that a record may have.
    pub(super) fn longest_record(&self) -> usize {
        self.sizes.line
    }

    /// Begins a record: what one holds is limited.
    pub(super) fn begin_record(&mut self) {
        self.held = 0;
    }

    /// The next byte, which stays; nothing at the end.
    fn peek(&mut self) -> Result<Option<u8>, InputError> {
        loop {
            if let Some(&byte) = self.buffer.get(self.at) {
                return Ok(Some(byte));
            }
            self.buffer.resize(BUFFER, 0);
            self.at = 0;
            let read = self.input.read(&mut self.buffer);
            self.buffer.truncate(read.as_ref().map_or(0, |count| *count));
            match read {
                Ok(0) => return Ok(None),
                Err(error) if error.kind() != io::ErrorKind::Interrupted => {
                    return Err(InputError::of_line(self.file, self.line, error));
                }
                _ => {}
            }
        }
    }

    fn pass(&mut self) {
        self.line += u64::from(self.buffer.get(self.at) == Some(&b'\n'));
        self.at += 1;
        self.passed += 1;
    }

    /// The next byte that is no white space, which stays.
    pub(super) fn next(&mut self) -> Result<Option<u8>, InputError> {
        while let Some(byte) = self.peek()? {
            if !byte.is_ascii_whitespace() {
                return Ok(Some(byte));
            }
            self.pass();
        }
        Ok(None)
    }

    /// Passes over this byte, if it is the next one behind white space.
    pub(super) fn take(&mut self, wanted: u8) -> Result<bool, InputError> {
        let is_it = self.next()? == Some(wanted);
        if is_it {
            self.pass();
        }
        Ok(is_it)
    }

    /// Passes over this byte, which must come next.
    pub(super) fn must(&mut self, wanted: u8, expected: &'static str) -> Result<(), InputError> {
        if self.take(wanted)? { Ok(()) } else { Err(self.wrong(expected)) }
    }

    /// The error for what comes next, where something else belongs.
    pub(super) fn wrong(&self, expected: &'static str) -> InputError {
        let rest = self.at_hand();
        let shown = rest.get(..SHOWN).unwrap_or(rest);
        let shown = String::from_utf8_lossy(shown);
        let shown = shown.lines().next().unwrap_or_default().trim_end_matches(char::REPLACEMENT_CHARACTER);
        let text = (!shown.is_empty()).then(|| shown.into());
        let place = Place { line: Some(self.line), text, ..Place::default() };
        // The next byte was looked for before: where there is none, the text ends.
        let kind = match rest.is_empty() {
            true => InputErrorKind::JsonEnds { expected },
            false => InputErrorKind::Json { expected },
        };
        InputError::new(self.file, place, kind)
    }

    /// Counts so many bytes that are held of a record.
    fn hold(&mut self, bytes: usize) -> Result<(), InputError> {
        self.held += bytes;
        let limit = self.sizes.line;
        if self.held <= limit {
            return Ok(());
        }
        Err(InputError::of_line(self.file, self.line, InputErrorKind::RowTooLong { limit }))
    }

    /// A value as the text of a cell: a number as it is written, nothing for `null`.
    pub(super) fn cell(&mut self) -> Result<String, InputError> {
        match self.next()? {
            Some(b'"') => self.string(),
            Some(open @ (b'{' | b'[')) => {
                self.pass_nested()?;
                Ok(NESTED
                    .into_iter()
                    .find(|text| text.as_bytes().first() == Some(&open))
                    .unwrap_or_default()
                    .to_owned())
            }
            Some(first) if is_of_word(first) => {
                let word = self.word()?;
                Ok(if word == "null" { String::new() } else { word })
            }
            _ => Err(self.wrong("a value")),
        }
    }

    /// A number, or a word such as `null`.
    fn word(&mut self) -> Result<String, InputError> {
        let mut word = String::new();
        while let Some(byte) = self.peek()? {
            if !is_of_word(byte) {
                break;
            }
            self.hold(1)?;
            word.push(char::from(byte));
            self.pass();
        }
        Ok(word)
    }

    /// A text in quotes.
    pub(super) fn string(&mut self) -> Result<String, InputError> {
        self.must(b'"', "a text in quotes")?;
        let mut text = Vec::new();
        loop {
            let Some(byte) = self.peek()? else { return Err(self.wrong("the quote that ends a text")) };
            match byte {
                b'"' => break self.pass(),
                b'\\' => {
                    self.pass();
                    let character = self.escaped()?;
                    text.extend(character.encode_utf8(&mut [0; 4]).as_bytes());
                }
                byte => {
                    text.push(byte);
                    self.pass();
                }
            }
            self.hold(1)?;
        }
        Ok(match String::from_utf8(text) {
            Ok(text) => text,
            Err(error) => String::from_utf8_lossy(error.as_bytes()).into_owned(),
        })
    }

    /// The character that stands behind a backslash.
    fn escaped(&mut self) -> Result<char, InputError> {
        let expected = "one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u";
        let Some(byte) = self.peek()? else { return Err(self.wrong(expected)) };
        let character = match byte {
            b'"' | b'\\' | b'/' => char::from(byte),
            b'b' => '\u{8}',
            b'f' => '\u{c}',
            b'n' => '\n',
            b'r' => '\r',
            b't' => '\t',
            b'u' => {
                self.pass();
                return self.utf16();
            }
            _ => return Err(self.wrong(expected)),
        };
        self.pass();
        Ok(character)
    }

    /// The character that one or two units of UTF-16 in hexadecimal are. Half of a pair is none.
    fn utf16(&mut self) -> Result<char, InputError> {
        let high = self.unit()?;
        let mut units = vec![high];
        if (0xd800..0xdc00).contains(&high) {
            for wanted in b"\\u" {
                if self.peek()? != Some(*wanted) {
                    return Ok(char::REPLACEMENT_CHARACTER);
                }
                self.pass();
            }
            units.push(self.unit()?);
        }
        let character = char::decode_utf16(units).next().and_then(Result::ok);
        Ok(character.unwrap_or(char::REPLACEMENT_CHARACTER))
    }

    fn unit(&mut self) -> Result<u16, InputError> {
        let mut unit = 0;
        for _ in 0..4 {
            let digit = self.peek()?.and_then(|byte| char::from(byte).to_digit(16));
            let Some(digit) = digit else { return Err(self.wrong("four hexadecimal digits")) };
            unit = unit << 4 | digit as u16;
            self.pass();
        }
        Ok(unit)
    }

    /// Passes over an object or array and all that is in it.
    pub(super) fn pass_nested(&mut self) -> Result<(), InputError> {
        let mut open = Vec::new();
        loop {
            match self.next()? {
                Some(bracket @ (b'{' | b'[')) => {
                    if open.len() >= self.sizes.nesting {
                        return Err(self.wrong("no object or array that is nested so deeply"));
                    }
                    open.push(bracket);
                    self.pass();
                }
                Some(bracket @ (b'}' | b']')) => {
                    // Both brackets of a pair are two apart.
                    if open.pop() != Some(bracket - 2) {
                        return Err(self.wrong("the other bracket"));
                    }
                    self.pass();
                }
                Some(b'"') => self.pass_string()?,
                Some(_) => self.pass(),
                None => return Err(self.wrong("the end of an object or array")),
            }
            if open.is_empty() {
                return Ok(());
            }
        }
    }

    fn pass_string(&mut self) -> Result<(), InputError> {
        self.pass();
        loop {
            let byte = self.peek()?;
            self.pass();
            match byte {
                None => return Err(self.wrong("the quote that ends a text")),
                Some(b'"') => return Ok(()),
                Some(b'\\') => self.pass(),
                Some(_) => {}
            }
        }
    }
}
