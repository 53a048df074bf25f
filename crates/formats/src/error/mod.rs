//! The possible problems of an input file, and where.

mod expected;
mod kind;
mod names;
mod ways;
mod words;

use std::{fmt, io};

use boundfit_exact::Foreign;
use thiserror::Error;

use crate::reduction::error::ReductionError;

pub use kind::InputErrorKind;
pub(crate) use names::are_no_names;
pub use names::nearest;
pub use ways::{Setting, Way};

/// The name of the input `-` in messages.
pub(crate) const STANDARD_INPUT: &str = "standard input";

/// The place of an error in a file. The parts that make no sense for a problem are `None`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Place {
    /// The sheet of a workbook, whose rows are then the lines.
    pub sheet: Option<Foreign>,
    /// Line of the file, from 1.
    pub line: Option<u64>,
    /// Number of the data row, from 1, in a file without lines or with several rows in one line.
    pub row: Option<usize>,
    /// Column of the table, from 1, with its name when there is a header.
    pub column: Option<(usize, Option<Foreign>)>,
    /// The text found there.
    pub text: Option<Foreign>,
}

/// An input file that cannot be used.
#[derive(Debug, Error)]
#[error("{file}{place}: {kind}{}", Expected(.kind))]
pub struct InputError {
    /// The file, as it was named.
    pub file: Foreign,
    /// The place in the file.
    pub place: Box<Place>,
    /// The problem there.
    #[source]
    pub kind: InputErrorKind,
}

impl InputError {
    /// The error for a file in which something is wrong as a whole.
    pub fn of_file(file: impl Into<Foreign>, kind: impl Into<InputErrorKind>) -> Self {
        InputError::new(file, Place::default(), kind)
    }

    /// The error for something wrong on a line of a file, counted from 1.
    pub(crate) fn of_line(file: impl Into<Foreign>, line: u64, kind: impl Into<InputErrorKind>) -> Self {
        InputError::new(file, Place { line: Some(line), ..Place::default() }, kind)
    }

    /// The error for something wrong with a data row of a file, counted from 1.
    pub fn of_row(file: impl Into<Foreign>, row: usize, kind: impl Into<InputErrorKind>) -> Self {
        InputError::new(file, Place { row: Some(row), ..Place::default() }, kind)
    }

    /// Settings with which the file is read, the most helpful first.
    pub fn ways(&self) -> Vec<Way> {
        let text = self.place.text.as_ref().map(Foreign::raw);
        match (&self.kind, text.and_then(grouping_mark)) {
            (InputErrorKind::NotANumber(_) | InputErrorKind::NoNumberInFirstRow { .. }, Some(mark)) => {
                vec![Way::new(Setting::Thousands, mark, "reads digits in groups of three")]
            }
            _ => self.kind.ways(),
        }
    }

    /// This error, where so many more lines come before its own.
    pub(crate) fn after_lines(&mut self, lines: u64) {
        if let Some(line) = &mut self.place.line {
            *line += lines;
        }
    }

    /// This error about the text of a sheet, as one about the sheet.
    #[cfg(feature = "spreadsheets")]
    pub(crate) fn in_sheet(mut self, sheet: &str) -> Self {
        self.place.sheet = Some(sheet.into());
        let is_formula = |text: &Foreign| text.raw().starts_with('=');
        let says = |is_it: &dyn Fn(&Foreign) -> bool| self.place.text.as_ref().is_some_and(is_it);
        match self.kind {
            InputErrorKind::NotANumber(_) | InputErrorKind::NoNumberInFirstRow { .. }
                if says(&is_formula) =>
            {
                self.kind = InputErrorKind::NoValue;
            }
            _ => {}
        }
        self
    }

    /// The error for something wrong at a place of a file.
    pub(crate) fn new(file: impl Into<Foreign>, place: Place, kind: impl Into<InputErrorKind>) -> Self {
        InputError { file: file.into(), place: Box::new(place), kind: kind.into() }
    }
}

impl From<io::Error> for InputErrorKind {
    fn from(error: io::Error) -> Self {
        // A reduction is shown as a stream of bytes, whose errors are those of a stream.
        match error.downcast::<ReductionError>().map(InputErrorKind::Reduction) {
            Ok(kind) => kind,
            // Streams that unpack a file carry their problems in the same way.
            Err(error) => error.downcast::<InputErrorKind>().unwrap_or_else(InputErrorKind::Io),
        }
    }
}

/// The mark that groups the digits of a number in threes, as the option for it takes it. A point or a comma does where there are several,
/// or where the other one follows: `3.100,5`.
fn grouping_mark(number: &str) -> Option<&'static str> {
    const MARKS: [(&str, &str); 4] =
        [(" \u{a0}\u{202f}\u{2009}\u{2007}", "' '"), ("'\u{2019}", "\"'\""), (".", "'.'"), (",", "','")];
    let number = number.trim().trim_start_matches(['+', '-']);
    let mark = number.chars().find(|character| !character.is_ascii_digit())?;
    let (_, option) = MARKS.iter().find(|(marks, _)| marks.contains(mark))?;
    let other = |character: char| matches!(character, '.' | ',') && character != mark;
    let (whole, decimals) = number.split_once(other).unzip();
    let groups: Vec<&str> = whole.unwrap_or(number).split(mark).collect();
    let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let (first, others) = groups.split_first()?;
    // No group stands behind a zero: 0'001 is no number, whatever groups digits.
    let is_grouped = (1..=3).contains(&first.len())
        && !first.starts_with('0')
        && others.iter().all(|group| group.len() == 3);
    let is_clear = !matches!(mark, '.' | ',') || others.len() > 1 || decimals.is_some();
    let is_number = groups.iter().chain(&decimals).all(|text| are_digits(text));
    (!others.is_empty() && is_grouped && is_clear && is_number).then_some(*option)
}

/// The part of a message that says what would be accepted.
struct Expected<'a>(&'a InputErrorKind);

impl fmt::Display for Expected<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.expected() {
            Some(expected) => write!(f, " (expected {expected})"),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(sheet) = &self.sheet {
            return self.write_in_sheet(sheet, f);
        }
        if let Some(line) = self.line {
            write!(f, ": line {line}")?;
        }
        if let Some(row) = self.row {
            write!(f, "{} row {row}", if self.line.is_some() { "," } else { ":" })?;
        }
        if let Some((number, name)) = &self.column {
            let separator = if self.line.is_none() && self.row.is_none() { ":" } else { "," };
            write!(f, "{separator} column {number}")?;
            if let Some(name) = name {
                write!(f, " ({name})")?;
            }
        }
        if let Some(text) = &self.text {
            write!(f, ": {}", text.quoted())?;
        }
        Ok(())
    }
}

impl Place {
    /// The place as spreadsheets name it: `Sheet1!B7 (x)`.
    fn write_in_sheet(&self, sheet: &Foreign, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.column, self.line) {
            (Some((column, name)), line) => {
                let row = line.map(|line| line.to_string()).unwrap_or_default();
                write!(f, ": {sheet}!{}{row}", letters(*column))?;
                if let Some(name) = name {
                    write!(f, " ({name})")?;
                }
            }
            (None, Some(line)) => write!(f, ": {sheet}, row {line}")?,
            (None, None) => write!(f, ": {sheet}")?,
        }
        match &self.text {
            Some(text) => write!(f, ": {}", text.quoted()),
            None => Ok(()),
        }
    }
}

/// The letters of a column, counted from 1: A to Z, AA, AB and so on.
fn letters(column: usize) -> String {
    let mut letters = Vec::new();
    let mut rest = column;
    while rest > 0 {
        letters.push(char::from(b'A' + ((rest - 1) % 26) as u8));
        rest = (rest - 1) / 26;
    }
    letters.iter().rev().collect()
}

#[cfg(test)]
mod tests {
    use super::letters;

    #[test]
    fn columns_have_the_letters_of_spreadsheets() {
        for (column, expected) in
            [(1, "A"), (26, "Z"), (27, "AA"), (52, "AZ"), (702, "ZZ"), (703, "AAA"), (16_384, "XFD")]
        {
            assert_eq!(letters(column), expected);
        }
    }
}
