//! The pieces of a file in LP format.

use std::collections::VecDeque;

use crate::read::ModelLimits;
use crate::read::error::{ModelError, ModelErrorKind};
use crate::read::text::{Field, Line, lines};

/// The kinds of pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A number without a sign.
    Number,
    /// A name or a keyword.
    Word,
    Plus,
    Minus,
    AtMost,
    AtLeast,
    Equal,
    Colon,
    /// A part of a quadratic term: a bracket, `^` or `*`.
    Quadratic,
    /// The arrow of an indicator constraint.
    Arrow,
    /// Anything else.
    Other,
}

impl Kind {
    pub(super) fn is_relation(self) -> bool {
        matches!(self, Kind::AtMost | Kind::AtLeast | Kind::Equal)
    }

    pub(super) fn is_sign(self) -> bool {
        matches!(self, Kind::Plus | Kind::Minus)
    }
}

/// A piece of the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) kind: Kind,
    pub(super) field: Field<'a>,
}

impl Token<'_> {
    /// Returns whether it is one of these words, in upper or lower case.
    pub(super) fn is_word(&self, words: &[&str]) -> bool {
        self.kind == Kind::Word && words.iter().any(|word| self.field.text.eq_ignore_ascii_case(word))
    }

    /// Returns whether it stands for infinity.
    pub(super) fn is_infinity(&self) -> bool {
        self.is_word(&["inf", "infinity"])
    }
}

/// The pieces of a text in their order, a few of them ahead.
pub(super) struct Tokens<'a, I> {
    lines: I,
    ahead: VecDeque<Token<'a>>,
    /// The last line that had a piece.
    pub(super) last: Option<Line<'a>>,
    /// The line of the last piece that was passed; 0 before the first.
    pub(super) passed: u64,
}

/// The pieces of a text.
pub(super) fn tokens<'a>(
    text: &'a str,
    limits: &ModelLimits,
) -> Tokens<'a, impl Iterator<Item = Result<Line<'a>, ModelError>>> {
    Tokens { lines: lines(text, limits), ahead: VecDeque::new(), last: None, passed: 0 }
}

impl<'a, I: Iterator<Item = Result<Line<'a>, ModelError>>> Tokens<'a, I> {
    /// The piece that comes so many pieces after the next one.
    pub(super) fn peek(&mut self, after: usize) -> Result<Option<Token<'a>>, ModelError> {
        while self.ahead.len() <= after {
            let Some(line) = self.lines.next() else { return Ok(None) };
            let line = line?;
            let before = self.ahead.len();
            self.ahead.extend(Pieces { line, position: 0 });
            if self.ahead.len() > before {
                self.last = Some(line);
            }
        }
        Ok(self.ahead.get(after).copied())
    }

    /// The next piece, which is passed.
    ///
    /// # Errors
    /// Where the file ends.
    pub(super) fn next(&mut self) -> Result<Token<'a>, ModelError> {
        self.peek(0)?;
        let token = self.ahead.pop_front().ok_or_else(|| self.end())?;
        self.passed = token.field.line.number;
        Ok(token)
    }

    /// The error for a file that stops here.
    pub(super) fn end(&self) -> ModelError {
        let format = crate::format::ExchangeFormat::Lp;
        match self.last {
            None => ModelError::of_file(ModelErrorKind::Empty(format)),
            Some(line) => line.whole().error(ModelErrorKind::NoEnd(format)),
        }
    }
}

/// The pieces of a line.
struct Pieces<'a> {
    line: Line<'a>,
    position: usize,
}

impl<'a> Iterator for Pieces<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        let rest = self.line.text.get(self.position..)?;
        let start = self.position + rest.find(|character| character != ' ' && character != '\t')?;
        let rest = self.line.text.get(start..)?;
        let first = rest.chars().next()?;
        let begins = |text: &str| rest.starts_with(text);
        let (kind, length) = match first {
            // A comment follows.
            '\\' => return None,
            '-' if begins("->") => (Kind::Arrow, 2),
            '+' => (Kind::Plus, 1),
            '-' => (Kind::Minus, 1),
            '<' => (Kind::AtMost, if begins("<=") { 2 } else { 1 }),
            '>' => (Kind::AtLeast, if begins(">=") { 2 } else { 1 }),
            '=' if begins("=<") => (Kind::AtMost, 2),
            '=' if begins("=>") => (Kind::AtLeast, 2),
            '=' => (Kind::Equal, 1),
            ':' => (Kind::Colon, 1),
            '[' | ']' | '^' | '*' => (Kind::Quadratic, 1),
            '/' => (Kind::Other, 1),
            '0'..='9' | '.' => (Kind::Number, number_length(rest)),
            _ => (Kind::Word, rest.find(ends_name).unwrap_or(rest.len())),
        };
        self.position = start + length;
        Some(Token { kind, field: self.line.piece(start, self.position) })
    }
}

/// Returns whether a name cannot go on with this character. CPLEX's names have fewer characters; those of Gurobi and HiGHS may look
/// like `x[1]`.
pub(crate) fn ends_name(character: char) -> bool {
    matches!(character, ' ' | '\t' | '+' | '-' | '<' | '>' | '=' | ':' | '^' | '*' | '\\')
}

/// Returns how long the number is that a text begins with: digits with a point, an exponent that has digits, a denominator.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let is = |place: usize, any_of: &[u8]| bytes.get(place).is_some_and(|byte| any_of.contains(byte));
    let whole = digits(0);
    let mut end = whole;
    if is(end, b".") {
        end += 1 + digits(end + 1);
    } else if is(end, b"/") && digits(end + 1) > 0 {
        return end + 1 + digits(end + 1);
    }
    let exponent = end + 1 + usize::from(is(end + 1, b"+-"));
    if is(end, b"eEdD") && digits(exponent) > 0 { exponent + digits(exponent) } else { end }
}
