//! Cells that are texts, whoever holds them.

use std::ops::Range;

use boundfit_exact::{Column, DecimalMark, Rational, Unit, is_missing};

use crate::cells::{BadIndex, CellReader};
use crate::columns::{ColumnSelector, Role};
use crate::dialect::MissingWords;
use crate::roles::instead_of_number;

/// The cells of a column as texts.
pub(crate) struct TextCells<'a, S>(pub(crate) &'a [S]);

impl<'a, S: AsRef<str>> TextCells<'a, S> {
    /// Returns true if a cell has no number.
    pub(crate) fn has_missing(&self) -> bool {
        self.0.iter().any(|text| is_missing(text.as_ref()))
    }

    /// Returns true if this cell has no number.
    pub(crate) fn is_missing(&self, index: usize) -> bool {
        self.0.get(index).is_some_and(|text| is_missing(text.as_ref()))
    }

    /// A cell; nothing where there is none.
    pub(crate) fn text(&self, index: usize) -> &'a str {
        self.0.get(index).map_or("", AsRef::as_ref)
    }

    /// A cell as the key of its row: without the spaces and tabs around it.
    pub(crate) fn key(&self, index: usize) -> &'a str {
        self.text(index).trim_matches([' ', '\t'])
    }

    /// The values that a column takes from the cells in a range.
    pub(crate) fn column(&self, range: Range<usize>, reader: CellReader) -> Result<Column, BadIndex> {
        match reader.selector.role() {
            Role::Number | Role::NonNegative => self.given(range, reader),
            Role::Presence => {
                let counts = range.map(|index| i128::from(!self.is_missing(index)));
                Ok(Column::of_counts(counts, Unit::TenTo(0)))
            }
            Role::Optional => {
                if !range.clone().any(|index| self.is_missing(index)) {
                    return self.given(range, reader);
                }
                reader.optional(range, |index| self.is_missing(index), |range| self.given(range, reader))
            }
            Role::HalfUnit => self.half_units(range, reader.selector),
        }
    }

    /// Some of the cells; those that there are.
    fn part(&self, range: Range<usize>) -> &'a [S] {
        self.0.get(range).unwrap_or_default()
    }

    /// The numbers in a range, all of which are there.
    fn given(&self, range: Range<usize>, reader: CellReader) -> Result<Column, BadIndex> {
        reader.refusing_negative(reader.texts(self.part(range).iter())?)
    }

    /// Half a unit of the last digit of each cell.
    fn half_units(&self, range: Range<usize>, selector: &ColumnSelector) -> Result<Column, BadIndex> {
        let mut column = Column::default();
        for (index, text) in self.part(range).iter().enumerate() {
            let value = instead_of_number(
                text.as_ref().as_bytes(),
                selector,
                Some(DecimalMark::Point),
                &MissingWords::default(),
            );
            let (mantissa, exponent) = value.map_err(|problem| (index, problem))?.unwrap_or_default();
            column.push(Rational::scientific(mantissa, exponent));
        }
        Ok(column)
    }
}
