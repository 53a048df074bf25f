//! Cells in memory as columns of exact numbers.

use std::ops::Range;

use boundfit_exact::{Column, Reading, Shortest, Unit};

use super::MemoryNumbers;
use super::texts::TextCells;
use crate::cells::{BadIndex, CellReader};
use crate::columns::Role;
use crate::error::InputErrorKind;

/// A cell that cannot be used: which one from 0, its text, and why.
pub(crate) struct BadNumber {
    pub(crate) index: usize,
    pub(crate) text: String,
    pub(crate) problem: InputErrorKind,
}

impl MemoryNumbers {
    /// Returns the number of cells.
    pub fn len(&self) -> usize {
        match self {
            MemoryNumbers::Doubles(doubles) => doubles.len(),
            MemoryNumbers::Floats(floats) => floats.len(),
            MemoryNumbers::Integers(integers) => integers.len(),
            MemoryNumbers::Exact(numbers) => numbers.len(),
            MemoryNumbers::Texts(texts) => texts.len(),
        }
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns whether a cell has no number.
    pub(crate) fn has_missing(&self) -> bool {
        match self {
            // Not `any`, so that many are compared at a time.
            MemoryNumbers::Doubles(doubles) => {
                doubles.iter().fold(false, |found, double| found | double.is_nan())
            }
            MemoryNumbers::Floats(floats) => floats.iter().fold(false, |found, float| found | float.is_nan()),
            MemoryNumbers::Integers(_) | MemoryNumbers::Exact(_) => false,
            MemoryNumbers::Texts(texts) => TextCells(texts).has_missing(),
        }
    }

    /// Returns whether this cell has no number.
    pub(crate) fn is_missing(&self, index: usize) -> bool {
        match self {
            MemoryNumbers::Doubles(doubles) => doubles.get(index).is_some_and(|double| double.is_nan()),
            MemoryNumbers::Floats(floats) => floats.get(index).is_some_and(|float| float.is_nan()),
            MemoryNumbers::Integers(_) | MemoryNumbers::Exact(_) => false,
            MemoryNumbers::Texts(texts) => TextCells(texts).is_missing(index),
        }
    }

    /// A cell as a CSV would show it, for this reading: the shortest text of a float of 32 bits is not that of the double which
    /// it is.
    pub(crate) fn text(&self, index: usize, reading: Reading) -> String {
        match self {
            MemoryNumbers::Doubles(doubles) => doubles.get(index).map(shown),
            MemoryNumbers::Floats(floats) => floats.get(index).map(|float| match reading {
                Reading::Decimal => shown(float),
                Reading::Binary64 => shown(&f64::from(*float)),
            }),
            MemoryNumbers::Integers(integers) => integers.get(index).map(ToString::to_string),
            MemoryNumbers::Exact(numbers) => numbers.get(index).map(ToString::to_string),
            MemoryNumbers::Texts(texts) => texts.get(index).cloned(),
        }
        .unwrap_or_default()
    }

    /// The values that a column takes from the cells in a range.
    pub(crate) fn column(&self, range: Range<usize>, reader: CellReader) -> Result<Column, BadNumber> {
        let column = match (self, reader.selector.role()) {
            (MemoryNumbers::Texts(texts), _) => TextCells(texts).column(range.clone(), reader),
            (_, Role::Number | Role::NonNegative) => self.given(range.clone(), reader),
            (_, Role::Presence) => {
                let counts = range.clone().map(|index| i128::from(!self.is_missing(index)));
                Ok(Column::of_counts(counts, Unit::TenTo(0)))
            }
            (_, Role::Optional) => self.optional(range.clone(), reader),
            (_, Role::HalfUnit) => {
                Err((0, InputErrorKind::NoDigits { format: "a column that is not of texts" }))
            }
        };
        column.map_err(|(index, problem)| {
            let index = range.start + index;
            BadNumber { index, text: self.text(index, reader.options.reading), problem }
        })
    }

    /// The numbers in a range, all of which are there.
    fn given(&self, range: Range<usize>, reader: CellReader) -> Result<Column, BadIndex> {
        let column = match self {
            MemoryNumbers::Doubles(doubles) => {
                let doubles = part(doubles, range);
                reader.floats(doubles, Column::of_shortest, || Column::of_doubles(doubles))?
            }
            MemoryNumbers::Floats(floats) => {
                let floats = part(floats, range);
                let doubles = || floats.iter().map(|&float| f64::from(float)).collect::<Vec<f64>>();
                reader.floats(floats, Column::of_shortest_f32, || Column::of_doubles(&doubles()))?
            }
            MemoryNumbers::Integers(integers) => {
                reader.counts(part(integers, range).iter().map(|&integer| integer.into()), 0)
            }
            MemoryNumbers::Exact(numbers) => {
                let mut column = Column::default();
                for (index, number) in part(numbers, range).iter().enumerate() {
                    // A fraction is one whatever it is read as.
                    let work = reader.meter.add(number, true, reader.options.sizes.work);
                    work.map_err(|problem| (index, problem.into()))?;
                    column.push(number.clone());
                }
                column
            }
            MemoryNumbers::Texts(texts) => reader.texts(part(texts, range).iter())?,
        };
        reader.refusing_negative(column)
    }

    /// The numbers in a range, with 0 where there is none.
    fn optional(&self, range: Range<usize>, reader: CellReader) -> Result<Column, BadIndex> {
        if !range.clone().any(|index| self.is_missing(index)) {
            return self.given(range, reader);
        }
        if let MemoryNumbers::Doubles(doubles) = self {
            let filled =
                part(doubles, range).iter().map(|&double| if double.is_nan() { 0.0 } else { double });
            let filled = MemoryNumbers::Doubles(filled.collect());
            return filled.given(0..filled.len(), reader);
        }
        reader.optional(range, |index| self.is_missing(index), |range| self.given(range, reader))
    }
}

/// A float as its shortest text.
fn shown(float: &impl Shortest) -> String {
    float.in_shortest_digits(format!("{float:?}"))
}

/// Some of the cells; those that there are.
fn part<T>(cells: &[T], range: Range<usize>) -> &[T] {
    cells.get(range).unwrap_or_default()
}
