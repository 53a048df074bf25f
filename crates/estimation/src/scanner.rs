//! Texts that are read from left to right: words, numbers, and where they stop making sense.

use std::error::Error;
use std::fmt;

use boundfit_exact::{Limits, ParseNumberErrorKind, Rational, Reading, characters_before};

/// The reason why a text is not what it should be, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParseTextError<K> {
    /// The number of characters before the place.
    pub position: usize,
    /// The kind of mistake there.
    pub kind: K,
}

/// The possible mistakes in a text of some kind, as a message reports them: the problem, its place, the remedy, and
/// the accepted forms.
pub trait TextProblem: fmt::Display + From<ParseNumberErrorKind> {
    /// Returns whether the problem is one of a place rather than of the whole text.
    fn has_place(&self) -> bool;

    /// Returns what is written instead.
    fn advice(&self) -> Option<&'static str>;

    /// Returns what would be accepted, where the message does not say it otherwise.
    fn expected(&self) -> Option<&'static str>;
}

impl<K: TextProblem> fmt::Display for ParseTextError<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.kind)?;
        if self.kind.has_place() {
            write!(f, " at character {}", self.position + 1)?;
        }
        if let Some(advice) = self.kind.advice() {
            write!(f, ": {advice}")?;
        }
        self.kind.expected().map_or(Ok(()), |expected| write!(f, " (expected {expected})"))
    }
}

impl<K: TextProblem + fmt::Debug> Error for ParseTextError<K> {}

/// A text of which some is read. Errors count bytes until [`Scanner::place`] counts characters.
pub(crate) struct Scanner<'a> {
    text: &'a str,
    position: usize,
    reading: Reading,
    limits: &'a Limits,
}

impl<'a> Scanner<'a> {
    /// A text, with its numbers read like this.
    pub(crate) fn new(text: &'a str, reading: Reading, limits: &'a Limits) -> Self {
        Scanner { text, position: 0, reading, limits }
    }

    /// Returns what follows the white space at the current position.
    pub(crate) fn rest(&mut self) -> &'a str {
        let rest = &self.text[self.position..];
        let trimmed = rest.trim_start();
        self.position += rest.len() - trimmed.len();
        trimmed
    }

    /// Returns where the text goes on, behind white space.
    pub(crate) fn start(&mut self) -> usize {
        self.rest();
        self.position
    }

    /// Returns what was read from there on.
    pub(crate) fn since(&self, start: usize) -> &'a str {
        self.text[start..self.position].trim()
    }

    /// The first of some words that comes next, which is passed.
    pub(crate) fn take(&mut self, words: &[&'static str]) -> Option<&'static str> {
        let rest = self.rest();
        let found = words.iter().copied().find(|word| rest.starts_with(word))?;
        self.position += found.len();
        Some(found)
    }

    /// The unsigned number that comes next, if one does. Where two bounds stand side by side, a slash before a sign separates them.
    pub(crate) fn number<K: TextProblem>(
        &mut self,
        side_by_side: bool,
    ) -> Result<Option<Rational>, ParseTextError<K>> {
        let rest = self.rest();
        let length = number_length(rest, side_by_side);
        if length == 0 {
            return Ok(None);
        }
        let value = self.reading.read(&rest[..length], self.limits);
        let value = value.map_err(|error| ParseTextError {
            position: self.position + error.position,
            kind: K::from(error.kind),
        })?;
        self.position += length;
        Ok(Some(value))
    }

    /// The error at what comes next.
    pub(crate) fn error<K>(&mut self, kind: K) -> ParseTextError<K> {
        ParseTextError { position: self.start(), kind }
    }

    /// An error with its place in characters, which people count.
    pub(crate) fn place<K>(text: &str, error: ParseTextError<K>) -> ParseTextError<K> {
        ParseTextError { position: characters_before(text, error.position), kind: error.kind }
    }
}

/// Returns how far an unsigned number reaches from the start of a text: digits, points, a slash, and exponents with a sign.
fn number_length(text: &str, side_by_side: bool) -> usize {
    let bytes = text.as_bytes();
    let mut length = 0;
    while let Some(&byte) = bytes.get(length) {
        let before = length.checked_sub(1).map(|before| bytes[before]);
        let is_exponent_sign = matches!(byte, b'+' | b'-') && matches!(before, Some(b'e' | b'E'));
        let is_exponent =
            matches!(byte, b'e' | b'E') && before.is_some_and(|byte| byte.is_ascii_digit() || byte == b'.');
        // There are no fractions of decimals.
        let may_be_above_bar = bytes[..length].iter().all(u8::is_ascii_digit)
            && bytes.get(length + 1).is_some_and(u8::is_ascii_digit);
        let ends_here = byte == b'/' && side_by_side && !may_be_above_bar;
        let is_part = byte.is_ascii_digit() || matches!(byte, b'.' | b'/') || is_exponent || is_exponent_sign;
        if !is_part || ends_here {
            break;
        }
        length += 1;
    }
    length
}
