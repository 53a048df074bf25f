//! Selects columns of a table: by names in a header, or by numbers.

use boundfit_exact::Foreign;

use crate::error::{InputError, InputErrorKind, Place};
use crate::quoted_name::in_quotes;

/// The values that a column takes from its cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Role {
    /// The column's numbers.
    #[default]
    Number,
    /// The column's numbers, which must be at least 0.
    NonNegative,
    /// The column's numbers, and 0 where there is none: [`Role::Presence`] of the same column tells the two
    /// apart.
    Optional,
    /// 1 where there is a number, 0 where there is none.
    Presence,
    /// Half a unit of the last digit that is written: 0.005 for `12.30`, 500 for `1e3`.
    HalfUnit,
}

impl Role {
    /// Returns whether a row without a number in the column lacks it.
    pub(crate) fn is_needed(self) -> bool {
        matches!(self, Role::Number | Role::NonNegative)
    }
}

/// A column that is asked for, by name or by number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnSelector {
    text: Foreign,
    /// The column's number when there is no header, from 1.
    position: Option<usize>,
    role: Role,
}

impl ColumnSelector {
    /// A header name, or a number from 1. A text in quotes is a name, even if it looks like a number.
    ///
    /// ```
    /// use boundfit_formats::ColumnSelector;
    ///
    /// assert_eq!(ColumnSelector::name_or_number("2").number(), Some(2));
    /// assert_eq!(ColumnSelector::name_or_number("\"2\""), ColumnSelector::name("2"));
    /// ```
    pub fn name_or_number(text: &str) -> Self {
        if let Some(name) = in_quotes(text) {
            return ColumnSelector::name(name);
        }
        let mut selector = ColumnSelector { text: text.trim().into(), position: None, role: Role::default() };
        if selector.is_number() {
            selector.position = Some(selector.text.raw().parse().unwrap_or(usize::MAX));
        }
        selector
    }

    /// A header name, also where it looks like a number.
    pub fn name(text: &str) -> Self {
        ColumnSelector { text: text.trim().into(), position: None, role: Role::Number }
    }

    /// A header name, or a position from 1 in a table without a header.
    pub fn name_at(name: &str, position: usize) -> Self {
        ColumnSelector { text: name.into(), position: Some(position), role: Role::default() }
    }

    /// This column, with the demand that every number in it is at least 0.
    pub fn non_negative(self) -> Self {
        ColumnSelector { role: Role::NonNegative, ..self }
    }

    /// This column, with 0 for cells that have no number; see [`Role::Optional`].
    pub fn optional(self) -> Self {
        ColumnSelector { role: Role::Optional, ..self }
    }

    /// Asks for the rows in which this column has numbers; see [`Role::Presence`].
    pub fn presence(self) -> Self {
        ColumnSelector { role: Role::Presence, ..self }
    }

    /// Half a unit of the last digit written in each cell of this column; see [`Role::HalfUnit`].
    pub fn half_unit(self) -> Self {
        ColumnSelector { role: Role::HalfUnit, ..self }
    }

    /// The values taken from the cells.
    pub fn role(&self) -> Role {
        self.role
    }

    /// Returns whether every number in the column must be at least 0.
    pub fn is_non_negative(&self) -> bool {
        self.role == Role::NonNegative
    }

    /// The request.
    pub fn text(&self) -> &Foreign {
        &self.text
    }

    /// The column's number, when that is what was asked for.
    pub fn number(&self) -> Option<usize> {
        self.position.filter(|_| self.is_number())
    }

    /// Returns whether it is asked for by a name alone.
    pub(crate) fn is_name(&self) -> bool {
        self.position.is_none()
    }

    /// Returns the column's place when there is no header.
    pub(crate) fn position(&self) -> Option<usize> {
        self.position
    }

    /// Returns whether what was asked for is a number.
    pub(crate) fn is_number(&self) -> bool {
        !self.text.raw().is_empty() && self.text.raw().bytes().all(|byte| byte.is_ascii_digit())
    }
}

/// States whether the first row names the columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Header {
    /// Decides by the cells. The first record is a header if a column is asked for by name, or if the cells asked for
    /// look like names. It is a header, too, if a word or an empty cell stands above numbers. Where every cell is a
    /// number it does not.
    #[default]
    Auto,
    /// The first record is a header.
    Present,
    /// The first record is not a header.
    Absent,
}

impl Header {
    /// All three.
    pub const ALL: [Header; 3] = [Header::Auto, Header::Present, Header::Absent];

    /// The answer to "does the first row name the columns?" on the command line: `auto`, `yes` or `no`.
    pub fn name(self) -> &'static str {
        match self {
            Header::Auto => "auto",
            Header::Present => "yes",
            Header::Absent => "no",
        }
    }

    /// Returns words for what is asked for, if anything is.
    pub(crate) fn asked(self) -> Option<&'static str> {
        match self {
            Header::Auto => None,
            Header::Present => Some("a header is"),
            Header::Absent => Some("no header is"),
        }
    }
}

/// A column of a table.
#[derive(Debug, Clone)]
pub(crate) struct ColumnPlace {
    /// The column's number, from 1.
    pub(crate) position: usize,
    /// The column's name, when there is a header.
    pub(crate) name: Option<Foreign>,
}

impl ColumnPlace {
    /// Returns the column's name, or `col1` and so on where it has none.
    pub(crate) fn title(&self) -> Foreign {
        let given = self.name.clone().filter(|name| !name.raw().is_empty());
        given.unwrap_or_else(|| format!("col{}", self.position).into())
    }

    /// The error for a problem with a cell of this column.
    pub(crate) fn error(&self, file: &str, line: u64, cell: &[u8], problem: InputErrorKind) -> InputError {
        let place = Place {
            line: Some(line),
            column: Some((self.position, self.name.clone())),
            text: Some(String::from_utf8_lossy(cell).into_owned().into()),
            ..Place::default()
        };
        InputError::new(file, place, problem)
    }
}

/// Refuses a column that is asked for as two of the model's. Bounds, and what is taken from cells beside their numbers, may be those of any
/// column: a reading may be its own lower bound.
pub(crate) fn refuse_same<'a>(
    file: &str,
    columns: impl Iterator<Item = (&'a ColumnPlace, &'a ColumnSelector)> + Clone,
) -> Result<(), InputError> {
    let columns = columns.filter(|(_, selector)| selector.role() == Role::Number);
    for (index, (place, selector)) in columns.clone().enumerate() {
        let is_same = |(other, _): &(&ColumnPlace, &ColumnSelector)| other.position == place.position;
        if let Some((_, earlier)) = columns.clone().take(index).find(is_same) {
            let kind =
                InputErrorKind::SameColumn { first: earlier.text().clone(), second: selector.text().clone() };
            let column = Some((place.position, place.name.clone()));
            return Err(InputError::new(file, Place { column, ..Place::default() }, kind));
        }
    }
    Ok(())
}

/// The text of a cell.
pub(crate) fn decode(cell: &[u8]) -> Result<&str, InputErrorKind> {
    std::str::from_utf8(cell).map_err(|_| InputErrorKind::NotUtf8 { position: readable(cell), unit: "cell" })
}

/// Returns the number of characters before the first byte that belongs to none.
pub(crate) fn readable(bytes: &[u8]) -> usize {
    bytes.utf8_chunks().next().map_or(0, |chunk| chunk.valid().chars().count())
}
