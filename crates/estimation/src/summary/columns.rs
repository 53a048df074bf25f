//! The two columns of a line, in the form in which they are summed and compared.

use boundfit_exact::{Integer, Rational};
use boundfit_formats::Column;

/// Mantissas of so many bits, in two parts, have sums of products in 128 bits: those of numbers with 17 digits, as other
/// programs print binary64, and exponents that differ by ten.
const MOST_BITS: u32 = 92;
/// Bits of the lower part of a mantissa.
pub(super) const LOW_BITS: u32 = 40;

/// x and y of consecutive readings.
pub(super) struct LineColumns<'a> {
    pub(super) x: &'a Column,
    pub(super) y: &'a Column,
    /// Both on wide integers, where those of 64 bits do not suffice.
    pub(super) wide: Option<[WideColumn; 2]>,
}

/// Numbers `mantissas[i] / denominator` in [`MOST_BITS`] bits.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct WideColumn {
    pub(super) mantissas: Vec<i128>,
    pub(super) denominator: i128,
}

impl<'a> LineColumns<'a> {
    pub(super) fn new(x: &'a Column, y: &'a Column) -> Self {
        let are_narrow = [x, y].iter().all(|column| matches!(column, Column::Scaled(_) | Column::Doubles(_)));
        let both = || Some([WideColumn::new(x)?, WideColumn::new(y)?]);
        LineColumns { x, y, wide: if are_narrow { None } else { both() } }
    }
}

impl WideColumn {
    /// A column on its least common denominator; `None` where a mantissa has too many bits.
    pub(super) fn new(column: &Column) -> Option<Self> {
        match column {
            Column::Scaled(scaled) if scaled.exponent <= 0 => Some(WideColumn {
                mantissas: scaled.mantissas.iter().map(|&mantissa| mantissa.into()).collect(),
                denominator: 10_i128.checked_pow(scaled.exponent.unsigned_abs())?,
            }),
            Column::Exact(numbers) => WideColumn::of_numbers(numbers),
            Column::Scaled(_) | Column::Doubles(_) => None,
        }
    }

    fn of_numbers(numbers: &[Rational]) -> Option<Self> {
        let mut column = WideColumn { mantissas: Vec::with_capacity(numbers.len()), denominator: 1 };
        // Neighbours often have the same denominator, and a division takes longer than all the rest.
        let mut last = (1, 1);
        for number in numbers {
            let (numerator, denominator) = (number.numerator().to_i128()?, number.denominator().to_i128()?);
            if denominator != last.0 {
                if column.denominator % denominator != 0 {
                    column.refine(denominator)?;
                }
                last = (denominator, column.denominator / denominator);
            }
            column.mantissas.push(within_limit(numerator.checked_mul(last.1)?)?);
        }
        Some(column)
    }

    /// Makes the denominator a multiple of another. It doubles at least, so this happens fewer than 127 times.
    #[cold]
    fn refine(&mut self, denominator: i128) -> Option<()> {
        let common = Integer::from(self.denominator).lcm(&Integer::from(denominator)).to_i128()?;
        let factor = common / self.denominator;
        for mantissa in &mut self.mantissas {
            *mantissa = within_limit(mantissa.checked_mul(factor)?)?;
        }
        self.denominator = common;
        Some(())
    }
}

fn within_limit(mantissa: i128) -> Option<i128> {
    (mantissa.unsigned_abs() >> MOST_BITS == 0).then_some(mantissa)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_values_on_a_common_denominator() {
        let texts = ["1/3", "0.1", "-7", "12345678901234567.89", "2e-9", "5/6"];
        let read =
            |text| boundfit_exact::Reading::Decimal.read(text, &boundfit_exact::Limits::default()).unwrap();
        let numbers: Vec<Rational> = texts.map(read).into();
        let column = WideColumn::new(&Column::Exact(numbers.clone())).unwrap();
        let value = |&mantissa: &i128| Rational::new(mantissa.into(), column.denominator.into()).unwrap();
        assert_eq!(column.mantissas.iter().map(value).collect::<Vec<_>>(), numbers);
        let too_wide = ["1e28", "1e-28"].map(|text| read(text) + Rational::ratio(1, 7));
        assert!(
            too_wide.iter().all(|number| WideColumn::new(&Column::Exact(vec![number.clone()])).is_none())
        );
    }
}
