//! The words of a file of cdd or lrs, and the rows that they make.

use boundfit_exact::Rational;

use crate::error::{InputError, InputErrorKind, Place};

/// The mark that lrs writes in place of a number of rows that it does not know yet.
const UNKNOWN_ROWS: &str = "*****";

/// A word of the file with its line and column, from 1.
#[derive(Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) text: &'a str,
    pub(super) line: u64,
    pub(super) column: usize,
}

/// A row of the matrix.
pub(super) struct MatrixRow<'a> {
    /// The row's first word, for messages.
    pub(super) start: Token<'a>,
    /// The row's three numbers.
    pub(super) numbers: [Rational; 3],
    /// `true` if it is on a `linearity` line.
    pub(super) is_linear: bool,
}

impl Token<'_> {
    /// The error for something wrong with this word.
    pub(super) fn error(&self, file: &str, problem: InputErrorKind) -> InputError {
        let place = Place {
            line: Some(self.line),
            column: Some((self.column, None)),
            text: Some(self.text.into()),
            ..Place::default()
        };
        InputError::new(file, place, problem)
    }
}

pub(super) fn is_linearity(word: &str) -> bool {
    word == "linearity" || word == "equality"
}

/// Returns whether a line has this word and nothing else but a comment.
pub(super) fn is_line(line: u64, text: &str, word: &str) -> bool {
    let mut words = words(line, text);
    words.next().is_some_and(|first| first.text == word) && words.next().is_none()
}

/// The text after the mark of an unknown number of rows, in a size line that has it. Any other line of asterisks is a comment.
pub(super) fn after_unknown_rows(text: &str) -> Option<&str> {
    let rest = text.trim_start().strip_prefix(UNKNOWN_ROWS)?;
    let mut words = rest.split_ascii_whitespace();
    let is_size = words.next()?.parse::<usize>().is_ok() && words.next().is_some();
    (is_size && rest.starts_with([' ', '\t'])).then_some(rest)
}

/// The words of a line. A `*` starts a comment.
pub(super) fn words(line: u64, text: &str) -> impl Iterator<Item = Token<'_>> {
    words_of_rest(line, text, text)
}

/// The words of the end of a line.
pub(super) fn words_of_rest<'a>(line: u64, text: &'a str, rest: &'a str) -> impl Iterator<Item = Token<'a>> {
    let rest = rest.split('*').next().unwrap_or_default();
    rest.split_ascii_whitespace().map(move |word| Token {
        text: word,
        line,
        column: 1 + word.as_ptr() as usize - text.as_ptr() as usize,
    })
}
