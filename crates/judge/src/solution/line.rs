//! A line of a solution file, for its words and for what is wrong with them.

use std::borrow::Cow;

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_lp::{NumberFormat, Printed};

use super::error::{SolutionError, quoted};
use super::figure::Figure;
use super::{Entry, Reference};

#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    pub(super) format: &'static str,
    /// The number of the line, from 1.
    pub(super) number: usize,
    pub(super) text: &'a str,
}

/// The entries that files count, one and many.
pub(super) const COLUMNS: (&str, &str) = ("column", "columns");
pub(super) const ROWS: (&str, &str) = ("row", "rows");

impl<'a> Line<'a> {
    /// The lines of a file.
    pub(super) fn all(format: &'static str, text: &'a str) -> impl Iterator<Item = Line<'a>> + Clone {
        (1..).zip(text.lines()).map(move |(number, text)| Line { format, number, text })
    }

    pub(super) fn words(&self) -> Vec<&'a str> {
        self.text.split_whitespace().collect()
    }

    /// The line is not what it should be.
    pub(super) fn expected(&self, expected: impl Into<Cow<'static, str>>) -> SolutionError {
        SolutionError::Line {
            format: self.format,
            line: self.number,
            text: quoted(self.text),
            expected: expected.into(),
        }
    }

    /// The file lists another number of columns or rows than this line says.
    pub(super) fn listed(&self, count: usize, (kind, kinds): (&'static str, &'static str)) -> SolutionError {
        SolutionError::Listed { line: self.number, text: quoted(self.text), count, kind, kinds }
    }

    /// This line and another one cannot both be true.
    pub(super) fn contradicts(&self, other: &Line<'_>) -> SolutionError {
        SolutionError::Contradiction {
            line: self.number,
            text: quoted(self.text),
            other: other.number,
            other_text: quoted(other.text),
        }
    }

    /// Returns the entry of this line for a column or a row: a value, a price, or both.
    pub(super) fn entry(
        &self,
        of: impl Into<Reference>,
        value: Option<Figure>,
        price: Option<Figure>,
    ) -> Entry {
        Entry { of: of.into(), line: self.number, value, price, price_line: self.number }
    }

    /// Reads a number, exactly as a program prints it that prints numbers like this.
    pub(super) fn figure(
        &self,
        text: &str,
        format: NumberFormat,
        limits: &Limits,
    ) -> Result<Figure, SolutionError> {
        self.read(text, limits, |value| Printed::by_writer(text, value, format))
    }

    fn read(
        &self,
        text: &str,
        limits: &Limits,
        printed: impl Fn(Rational) -> Printed,
    ) -> Result<Figure, SolutionError> {
        let lower = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
        if ["inf", "infinity", "nan", "1.#inf", "1.#ind"].contains(&lower.as_str()) {
            return Ok(Figure::NotFinite);
        }
        let read = Reading::Decimal.read(text, limits);
        read.map(|value| Figure::Finite(printed(value))).map_err(|error| SolutionError::NumberAt {
            format: self.format,
            line: self.number,
            text: quoted(text),
            error,
        })
    }
}
