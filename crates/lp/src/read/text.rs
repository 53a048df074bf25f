//! Lines and pieces of them, which know their places.

use boundfit_exact::{Rational, Reading, characters_before};

use super::error::{ModelError, ModelErrorKind, ModelPlace};
use super::{ModelLimits, bounds::Extended};

/// A line of a file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    /// The number of the line, from 1.
    pub(super) number: u64,
    /// The line without its end.
    pub(super) text: &'a str,
}

/// A piece of a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Field<'a> {
    pub(super) text: &'a str,
    pub(super) line: Line<'a>,
    /// The number of bytes of the line before it.
    start: usize,
}

/// The lines of a text, each of which is refused where it is too long or no text.
pub(super) fn lines<'a>(
    text: &'a str,
    limits: &ModelLimits,
) -> impl Iterator<Item = Result<Line<'a>, ModelError>> {
    let longest = limits.line;
    (1..).zip(text.lines()).map(move |(number, text)| {
        // A file may end with a carriage return alone.
        let line = Line { number, text: text.strip_suffix('\r').unwrap_or(text) };
        if text.len() > longest {
            return Err(line.whole().error(ModelErrorKind::LineTooLong { limit: longest }));
        }
        let is_strange = |character: char| character.is_control() && character != '\t';
        match line.text.char_indices().find(|(_, character)| is_strange(*character)) {
            None => Ok(line),
            Some((start, character)) => {
                let rest = line.text.get(start..).unwrap_or_default();
                Err(Field { text: rest, line, start }.error(ModelErrorKind::ControlCharacter(character)))
            }
        }
    })
}

impl<'a> Line<'a> {
    /// All of it but the white space around it.
    pub(super) fn whole(self) -> Field<'a> {
        self.piece(0, self.text.len())
    }

    /// The bytes from one to before another, without the white space around them.
    pub(super) fn piece(self, from: usize, to: usize) -> Field<'a> {
        let text = self.text.get(from..to).unwrap_or_default();
        let start = from + (text.len() - text.trim_start().len());
        Field { text: text.trim(), line: self, start }
    }

    /// Returns what blanks and tabs separate.
    pub(super) fn words(self) -> impl Iterator<Item = Field<'a>> {
        let mut rest = 0;
        std::iter::from_fn(move || {
            let is_blank = |character: char| character == ' ' || character == '\t';
            let tail = self.text.get(rest..)?;
            let start = rest + tail.find(|character| !is_blank(character))?;
            let word = self.text.get(start..)?;
            let word = word.split(is_blank).next().unwrap_or_default();
            rest = start + word.len();
            Some(Field { text: word, line: self, start })
        })
    }
}

impl Field<'_> {
    /// The error for something wrong here.
    pub(super) fn error(&self, kind: ModelErrorKind) -> ModelError {
        let place = ModelPlace {
            line: self.line.number,
            column: characters_before(self.line.text, self.start) + 1,
            text: self.text.into(),
        };
        ModelError { place: Some(Box::new(place)), kind }
    }

    /// The number that it spells.
    pub(super) fn number(&self, limits: &ModelLimits) -> Result<Rational, ModelError> {
        let number = Reading::Decimal.read(self.text, &limits.number);
        number.map_err(|error| self.error(ModelErrorKind::NotANumber(error)))
    }

    /// The infinity that it spells: `inf` or `infinity`, with a sign or without.
    pub(super) fn infinity(&self) -> Option<Extended> {
        let word = self.text.strip_prefix(['+', '-']).unwrap_or(self.text);
        let is_infinity = ["inf", "infinity"].iter().any(|name| word.eq_ignore_ascii_case(name));
        let sign = if self.text.starts_with('-') { Extended::Minus } else { Extended::Plus };
        is_infinity.then_some(sign)
    }

    /// The number that it spells, or an infinity, which every number from 10³⁰ on is.
    pub(super) fn extended(&self, limits: &ModelLimits) -> Result<Extended, ModelError> {
        self.infinity().map_or_else(|| self.number(limits).map(Extended::new), Ok)
    }
}
