//! Columns of the decimals that floats stand for.

use super::scaled::Count;
use super::{Column, Scaled, Unit};
use crate::long_decimal::{WORD_DIGITS, power_of_ten};
use crate::shortest::{on_common_places, shortest_decimal, shortest_decimal_of_f32};

impl Column {
    /// The shortest decimals that are read as these doubles: 1/10 for what is stored when 0.1 is read. Exact. Cost: about a
    /// nanosecond for each of up to 15 digits, some ten for each of more.
    ///
    /// ```
    /// use boundfit_exact::{Column, Rational};
    ///
    /// let column = Column::of_shortest(&[0.1, 2.5]).unwrap();
    /// assert_eq!(column.get(0), Rational::ratio(1, 10));
    /// assert!(matches!(column, Column::Narrow(scaled) if scaled.counts() == [1, 25]));
    /// assert_eq!(Column::of_shortest(&[0.1, f64::NAN]), Err(1));
    /// ```
    ///
    /// # Errors
    /// With the position of the first infinity or NaN.
    pub fn of_shortest(doubles: &[f64]) -> Result<Self, usize> {
        if let Some((counts, places)) = on_common_places(doubles) {
            let is_zero = counts.iter().fold(0, |all, count| all | count) == 0;
            let unit = if is_zero { Unit::Any } else { Unit::TenTo(-(places as i32)) };
            // At most 15 digits.
            return Ok(Column::Narrow(Scaled::of_counts(counts, unit)));
        }
        Column::of_each(doubles, shortest_decimal)
    }

    /// The shortest decimals that are read as these floats of 32 bits, like [`Column::of_shortest`].
    ///
    /// # Errors
    /// With the position of the first infinity or NaN.
    pub fn of_shortest_f32(floats: &[f32]) -> Result<Self, usize> {
        Column::of_each(floats, shortest_decimal_of_f32)
    }

    fn of_each<F: Copy>(floats: &[F], decimal: impl Fn(F) -> Option<(i64, i32)>) -> Result<Self, usize> {
        let mut decimals = Vec::with_capacity(floats.len());
        for (position, &float) in floats.iter().enumerate() {
            decimals.push(decimal(float).ok_or(position)?);
        }
        Ok(Column::of_decimals(&decimals))
    }

    /// Several `mantissa · 10^exponent`, as if they were pushed one by one. Exact. Cost: some nanoseconds each.
    pub fn of_decimals(decimals: &[(i64, i32)]) -> Self {
        let exponents =
            || decimals.iter().filter(|(mantissa, _)| *mantissa != 0).map(|&(_, exponent)| exponent);
        let (Some(least), Some(most)) = (exponents().min(), exponents().max()) else {
            return Column::Narrow(Scaled::of_counts(vec![0; decimals.len()], Unit::Any));
        };
        let unit = Unit::TenTo(least);
        let on_unit = |&(mantissa, exponent): &(i64, i32)| product(mantissa, exponent.checked_sub(least)?);
        if most.checked_sub(least).is_some_and(|spread| (spread as usize) <= WORD_DIGITS) {
            let counts =
                decimals.iter().map(|&(mantissa, exponent)| word_product(mantissa, exponent - least));
            if let Some(column) = Column::of_words(counts.collect(), unit) {
                return column;
            }
        } else if let Some(wide) = Scaled::of_options(decimals.iter().map(on_unit), unit) {
            return Column::Wide(wide);
        }
        let mut column = Column::default();
        decimals.iter().for_each(|&(mantissa, exponent)| column.push_decimal(mantissa, exponent));
        column
    }

    /// Returns a column of these counts of units, in the shorter integers if these hold all of them; `None` if
    /// neither do.
    fn of_words(counts: Vec<i128>, unit: Unit) -> Option<Self> {
        let bits = counts.iter().fold(0, |bits, count| bits | count.unsigned_abs());
        if bits >> <i64 as Count>::BITS == 0 {
            let counts = counts.into_iter().map(|count| count as i64).collect();
            return Some(Column::Narrow(Scaled::of_counts(counts, unit)));
        }
        (bits >> <i128 as Count>::BITS == 0).then(|| Column::Wide(Scaled::of_counts(counts, unit)))
    }
}

/// `mantissa · 10^exponent` for an exponent from 0 to 19, or with zero any; without a branch, as many are computed together.
#[inline]
fn word_product(mantissa: i64, exponent: i32) -> i128 {
    // The product of a word and an unsigned one has 127 bits at most.
    i128::from(mantissa) * i128::from(power_of_ten((exponent as usize).min(WORD_DIGITS)))
}

/// `mantissa · 10^exponent`, with zero at any exponent.
fn product(mantissa: i64, exponent: i32) -> Option<i128> {
    match u32::try_from(exponent) {
        Ok(exponent) if mantissa != 0 => i128::from(mantissa).checked_mul(10_i128.checked_pow(exponent)?),
        _ => (mantissa == 0).then_some(0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Rational, Reading};

    fn read_each(doubles: &[f64]) -> Vec<Rational> {
        let read = |double: &f64| Reading::Decimal.read(&format!("{double:e}"), &Limits::default()).unwrap();
        doubles.iter().map(read).collect()
    }

    #[test]
    fn columns_have_the_decimals_of_all_sizes() {
        type IsKept = fn(&Column) -> bool;
        let columns: [(&[f64], IsKept); 7] = [
            (&[], |column| matches!(column, Column::Narrow(_))),
            (&[0.0, -0.0], |column| matches!(column, Column::Narrow(scaled) if scaled.unit() == Unit::Any)),
            (
                &[1.5, -2.25, 1e3],
                |column| matches!(column, Column::Narrow(scaled) if scaled.unit() == Unit::TenTo(-2)),
            ),
            (&[0.1 + 0.2, 0.5], |column| matches!(column, Column::Narrow(_))),
            (&[0.1 + 0.2, 1e9, 0.0], |column| matches!(column, Column::Wide(_))),
            (&[1e300, 1e-300, -7.25], |column| matches!(column, Column::Scattered(_))),
            (&[f64::MAX, f64::from_bits(1), f64::MIN_POSITIVE], |column| {
                matches!(column, Column::Scattered(_))
            }),
        ];
        for (doubles, is_kept) in columns {
            let column = Column::of_shortest(doubles).unwrap();
            let numbers: Vec<Rational> = (0..column.len()).map(|index| column.get(index)).collect();
            assert_eq!(numbers, read_each(doubles));
            assert!(is_kept(&column), "{column:?}");
        }
    }

    #[test]
    fn several_decimals_are_kept_as_if_they_were_pushed_one_by_one() {
        let mut state: u64 = 0x9e37_79b9_7f4a_7c15;
        let mut next = |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 20) % below
        };
        for _ in 0..3000 {
            let (digits, spread) = (1 + next(18), 1 + next(30));
            let decimals: Vec<(i64, i32)> = (0..next(6))
                .map(|_| {
                    let mantissa = next(10_u64.pow(digits as u32)) as i64 - 10_i64.pow(digits as u32 - 1);
                    if next(4) == 0 { (0, 0) } else { (mantissa, next(spread) as i32 - 20) }
                })
                .collect();
            let mut pushed = Column::default();
            decimals.iter().for_each(|&(mantissa, exponent)| pushed.push_decimal(mantissa, exponent));
            assert_eq!(Column::of_decimals(&decimals), pushed, "{decimals:?}");
        }
    }

    #[test]
    fn floats_of_32_bits_have_decimals_of_their_own() {
        let column = Column::of_shortest_f32(&[0.1, 16_777_216.0, -1e-45]).unwrap();
        let texts: Vec<String> = (0..3).map(|index| column.get(index).to_string()).collect();
        assert_eq!(texts[..2], ["1/10", "16777216"]);
        assert_eq!(column.get(2), Rational::scientific(-1, -45));
        assert_eq!(Column::of_shortest_f32(&[1.0, f32::NAN]), Err(1));
        assert_eq!(Column::of_shortest(&[1.0, 1e-30, f64::INFINITY]), Err(2));
    }
}
