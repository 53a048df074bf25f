//! The numbers of a variable, whichever way they are stored.

use std::io::Read;
use std::ops::Range;

use boundfit_exact::{Column, Reading, Unit};

use super::elements::{ByteOrder, Damage, Elements};
use crate::budget::HeldMemory;
use crate::cells::CellReader;
use crate::columns::Role;
use crate::doubles::double_text;
use crate::error::InputErrorKind;
use crate::memory::{BadNumber, MemoryNumbers};
use crate::memory_use::MemoryUse;

/// Numbers exactly as they are stored.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Numbers {
    /// Doubles, singles, and integers of up to 32 bits: doubles have them all.
    Doubles(Vec<f64>),
    /// Integers of 64 bits.
    Integers(Vec<i128>),
    /// Numbers as text, which are read as those of a table of text are.
    Texts(MemoryNumbers),
}

impl Numbers {
    /// Reads the element with so many numbers, for which memory is asked. It is taken for what is there, not for what is announced.
    pub(super) fn read<R: Read>(
        elements: &mut Elements<R>,
        count: u64,
        memory: &HeldMemory,
    ) -> Result<Self, Damage> {
        let tag = elements.some_tag()?;
        let size: u64 = match tag.kind {
            1 | 2 => 1,
            3 | 4 => 2,
            5..=7 => 4,
            9 | 12 | 13 => 8,
            other => return Err(Damage::format(format!("its numbers have the element type {other}"))),
        };
        if count.checked_mul(size) != Some(tag.bytes) {
            let reason =
                format!("{count} numbers of {size} bytes are announced, but {} bytes follow", tag.bytes);
            return Err(Damage::format(reason));
        }
        let order = elements.order();
        let (mut numbers, in_memory) = match tag.kind {
            12 | 13 => (Numbers::Integers(Vec::new()), size_of::<i128>()),
            _ => (Numbers::Doubles(Vec::new()), size_of::<f64>()),
        };
        ask_for(count, in_memory, memory)?;
        elements.each_part(tag, |part| match &mut numbers {
            Numbers::Integers(integers) if tag.kind == 12 => {
                integers.extend(words(part, order).map(|word| i128::from(i64::from_le_bytes(word))));
            }
            Numbers::Integers(integers) => {
                integers.extend(words(part, order).map(|word| i128::from(u64::from_le_bytes(word))));
            }
            Numbers::Doubles(doubles) => extend(doubles, tag.kind, part, order),
            Numbers::Texts(_) => {}
        })?;
        Ok(numbers)
    }

    /// The values that a column takes from the numbers in a range; a NaN is none.
    pub(super) fn column(&self, range: Range<usize>, reader: CellReader) -> Result<Column, BadNumber> {
        if let Numbers::Texts(texts) = self {
            return texts.column(range, reader);
        }
        match reader.selector.role() {
            role @ (Role::Number | Role::NonNegative) => self.numbers(range, role == Role::NonNegative),
            Role::Presence => {
                Ok(Column::of_counts(range.map(|index| i128::from(!self.is_missing(index))), Unit::TenTo(0)))
            }
            Role::Optional => match self {
                Numbers::Doubles(doubles) => {
                    let own = doubles.get(range.clone()).unwrap_or_default();
                    if let Some(index) = own.iter().position(|double| double.is_infinite()) {
                        let index = range.start + index;
                        let problem = InputErrorKind::NotFinite;
                        return Err(BadNumber { index, text: self.text(index), problem });
                    }
                    let filled = own.iter().map(|&double| if double.is_nan() { 0.0 } else { double + 0.0 });
                    Ok(Column::Doubles(filled.collect()))
                }
                Numbers::Integers(_) | Numbers::Texts(_) => self.numbers(range, false),
            },
            Role::HalfUnit => {
                let problem = InputErrorKind::NoDigits { format: "a MATLAB file" };
                Err(BadNumber { index: range.start, text: self.text(range.start), problem })
            }
        }
    }

    /// Returns whether a value is a NaN, which is none.
    pub(super) fn is_missing(&self, index: usize) -> bool {
        match self {
            Numbers::Doubles(doubles) => doubles.get(index).is_some_and(|double| double.is_nan()),
            Numbers::Integers(_) => false,
            Numbers::Texts(texts) => texts.is_missing(index),
        }
    }

    /// The numbers in a range as a column.
    fn numbers(&self, range: Range<usize>, non_negative: bool) -> Result<Column, BadNumber> {
        let bad = |index: usize, problem| {
            let index = range.start + index;
            BadNumber { index, text: self.text(index), problem }
        };
        let column = match self {
            Numbers::Doubles(doubles) => {
                let doubles = doubles.get(range.clone()).unwrap_or_default();
                if let Some(index) = doubles.iter().position(|double| !double.is_finite()) {
                    return Err(bad(index, InputErrorKind::NotFinite));
                }
                // Zero has one sign.
                Column::Doubles(doubles.iter().map(|double| double + 0.0).collect())
            }
            Numbers::Integers(integers) => {
                let integers = integers.get(range.clone()).unwrap_or_default();
                let doubles = integers.iter().map(|&integer| as_double(integer)).collect();
                let exact = || Column::of_counts(integers.iter().copied(), Unit::TenTo(0));
                Option::map_or_else(doubles, exact, Column::Doubles)
            }
            Numbers::Texts(_) => Column::default(),
        };
        let negative = if non_negative { column.first_negative() } else { None };
        match negative {
            Some(index) => Err(bad(index, InputErrorKind::NegativeErrorBound)),
            None => Ok(column),
        }
    }

    /// A number as text that reads back as the same one; nothing where there is none.
    pub(super) fn text(&self, index: usize) -> String {
        let text = match self {
            Numbers::Doubles(doubles) => doubles.get(index).map(|&double| double_text(double)),
            Numbers::Integers(integers) => integers.get(index).map(i128::to_string),
            Numbers::Texts(texts) => Some(texts.text(index, Reading::Decimal)),
        };
        text.unwrap_or_default()
    }

    /// The first number in a range that no double has.
    pub(super) fn first_beyond_doubles(&self, range: Range<usize>) -> Option<usize> {
        let Numbers::Integers(integers) = self else { return None };
        let beyond = |&integer: &i128| as_double(integer).is_none();
        integers.get(range.clone())?.iter().position(beyond).map(|index| range.start + index)
    }
}

/// Asks for memory for so many numbers of so many bytes each.
pub(super) fn ask_for(count: u64, bytes: usize, memory: &HeldMemory) -> Result<(), Damage> {
    memory.ask(count.saturating_mul(bytes as u64), MemoryUse::Variables).map_err(Damage::Refused)
}

/// The words of a part with their bytes in little-endian order.
fn words<const N: usize>(part: &[u8], order: ByteOrder) -> impl Iterator<Item = [u8; N]> {
    part.as_chunks().0.iter().map(move |word: &[u8; N]| {
        let mut word = *word;
        if order == ByteOrder::Big {
            word.reverse();
        }
        word
    })
}

/// Adds the numbers in a part, of an element type that doubles have all numbers of.
pub(super) fn extend(doubles: &mut Vec<f64>, kind: u32, part: &[u8], order: ByteOrder) {
    match kind {
        1 => doubles.extend(words(part, order).map(|word| f64::from(i8::from_le_bytes(word)))),
        2 => doubles.extend(words(part, order).map(|word| f64::from(u8::from_le_bytes(word)))),
        3 => doubles.extend(words(part, order).map(|word| f64::from(i16::from_le_bytes(word)))),
        4 => doubles.extend(words(part, order).map(|word| f64::from(u16::from_le_bytes(word)))),
        5 => doubles.extend(words(part, order).map(|word| f64::from(i32::from_le_bytes(word)))),
        6 => doubles.extend(words(part, order).map(|word| f64::from(u32::from_le_bytes(word)))),
        7 => doubles.extend(words(part, order).map(|word| f64::from(f32::from_le_bytes(word)))),
        _ => doubles.extend(words(part, order).map(f64::from_le_bytes)),
    }
}

/// The double with this value, if there is one.
fn as_double(integer: i128) -> Option<f64> {
    let double = integer as f64;
    (double as i128 == integer).then_some(double)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::budget::MemoryBudget;

    fn read(kind: u8, bytes: &[u8], order: ByteOrder, count: u64) -> Result<Numbers, Damage> {
        let mut element = vec![kind, 0, 0, 0, bytes.len() as u8, 0, 0, 0];
        if order == ByteOrder::Big {
            element[..4].reverse();
            element[4..].reverse();
        }
        element.extend(bytes);
        let budget = MemoryBudget::new(1000);
        Numbers::read(&mut Elements::new(element.as_slice(), order), count, &budget.nothing())
    }

    #[test]
    fn every_storage_type_is_exact_in_both_byte_orders() {
        for order in [ByteOrder::Little, ByteOrder::Big] {
            let number = |kind: u8, little: &[u8]| {
                let mut bytes = little.to_vec();
                if order == ByteOrder::Big {
                    bytes.reverse();
                }
                read(kind, &bytes, order, 1).unwrap()
            };
            let double = |double: f64| Numbers::Doubles(vec![double]);
            assert_eq!(number(1, &(-7_i8).to_le_bytes()), double(-7.0));
            assert_eq!(number(2, &[250]), double(250.0));
            assert_eq!(number(3, &(-30_000_i16).to_le_bytes()), double(-30_000.0));
            assert_eq!(number(4, &60_000_u16.to_le_bytes()), double(60_000.0));
            assert_eq!(number(5, &i32::MIN.to_le_bytes()), double(-2_147_483_648.0));
            assert_eq!(number(6, &u32::MAX.to_le_bytes()), double(4_294_967_295.0));
            assert_eq!(number(7, &0.1_f32.to_le_bytes()), double(f64::from(0.1_f32)));
            assert_eq!(number(9, &0.1_f64.to_le_bytes()), double(0.1));
            assert_eq!(number(12, &i64::MIN.to_le_bytes()), Numbers::Integers(vec![i64::MIN.into()]));
            assert_eq!(number(13, &u64::MAX.to_le_bytes()), Numbers::Integers(vec![u64::MAX.into()]));
        }
    }

    #[test]
    fn more_or_fewer_bytes_than_announced_are_refused() {
        for count in [0, 1, 3, u64::MAX] {
            assert!(matches!(read(9, &[0; 16], ByteOrder::Little, count), Err(Damage::Format(_))), "{count}");
        }
        assert!(matches!(read(8, &[0; 16], ByteOrder::Little, 2), Err(Damage::Format(_))));
    }

    #[test]
    fn integers_stay_exact_where_no_double_has_them() {
        let numbers = Numbers::Integers(vec![1 << 53, (1 << 53) + 1, -1]);
        let column = |range: Range<usize>, non_negative| numbers.numbers(range, non_negative).ok();
        assert_eq!(column(0..1, true), Some(Column::Doubles(vec![9_007_199_254_740_992.0])));
        assert_eq!(column(1..2, true), Some(Column::of_counts([(1 << 53) + 1].into_iter(), Unit::TenTo(0))));
        assert_eq!(column(0..3, true), None);
        assert_eq!(column(0..3, false).map(|column| column.len()), Some(3));
        assert_eq!((numbers.first_beyond_doubles(0..3), numbers.first_beyond_doubles(2..3)), (Some(1), None));
    }
}
