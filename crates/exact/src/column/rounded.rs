//! Columns as binary64, for filters with a margin.

use super::long::scale;
use super::{Column, Count, Scaled, Unit};
use crate::Rational;
use crate::binary64::short_double;

impl Column {
    /// Each number within 2^-50 of it, relatively; `None` where binary64 has no such numbers. Cost: a nanosecond or two per
    /// number.
    pub fn rounded(&self) -> Option<Vec<f64>> {
        match self {
            Column::Narrow(scaled) => of_scaled(scaled, |count| count as f64),
            Column::Wide(scaled) => of_scaled(scaled, of_wide),
            Column::Long(long) => long.rounded(),
            Column::Doubles(doubles) => Some(doubles.clone()),
            Column::Scattered(scattered) => scattered.rounded(),
            Column::Fractions(numbers) => {
                let rounded = |number: &Rational| {
                    let double = number.to_f64();
                    (double.is_normal() || number.is_zero()).then_some(double)
                };
                numbers.iter().map(rounded).collect()
            }
        }
    }

    /// Each number as [`Rational::near_f64`] tells it. Cost: some nanoseconds for each short decimal or double.
    pub fn near_f64(&self) -> Vec<f64> {
        match self {
            Column::Narrow(scaled) => {
                let unit = scaled.unit();
                let near = |&count: &i64| {
                    let decimal =
                        if let Unit::TenTo(exponent) = unit { short_double(count, exponent) } else { None };
                    decimal.unwrap_or_else(|| unit.times(count.into()).near_f64())
                };
                scaled.counts().iter().map(near).collect()
            }
            Column::Doubles(doubles) => doubles.clone(),
            _ => (0..self.len()).map(|index| self.get(index).near_f64()).collect(),
        }
    }
}

/// A unit that is rounded once and a product once more.
fn of_scaled<I: Count>(scaled: &Scaled<I>, round: impl Fn(I) -> f64) -> Option<Vec<f64>> {
    let unit = match scaled.unit() {
        Unit::Any => 1.0,
        Unit::TenTo(exponent) => scale(exponent)?,
        // From 2^-127 to 1.
        unit @ Unit::OneOver(_) => unit.value().to_f64(),
    };
    Some(scaled.counts().iter().map(|&count| round(count) * unit).collect())
}

/// Returns the number within 2^-52, relatively: both halves are rounded, and their sum. Several times faster than the
/// nearest.
#[inline]
fn of_wide(count: i128) -> f64 {
    // The rest of 126 bits has 63 bits, too.
    const LOW_BITS: u32 = 63;
    // The magnitude counts: the halves of a negative number would cancel each other.
    let magnitude = count.unsigned_abs();
    let (high, low) = ((magnitude >> LOW_BITS) as i64, (magnitude as i64) & i64::MAX);
    let rounded = high as f64 * (1_u64 << LOW_BITS) as f64 + low as f64;
    if count < 0 { -rounded } else { rounded }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_and_numbers_are_the_same_near_doubles() {
        let counts = [0, 1, -7, 56_847, 99_999_999_999_999_999, -(1 << 53) - 1, 1 << 61];
        let mut columns = vec![Column::of_doubles(&[0.1, -2.5, 1e300, 5e-324]).unwrap()];
        for unit in
            [0, -1, -4, -17, -22, -30, -320, 3, 25].map(Unit::TenTo).into_iter().chain([Unit::OneOver(7)])
        {
            columns.push(Column::of_counts(counts.into_iter(), unit));
        }
        columns.push(Column::of_counts([1 << 100, -(3 << 90)].into_iter(), Unit::TenTo(-20)));
        for column in columns {
            let expected: Vec<f64> = (0..column.len()).map(|index| column.get(index).near_f64()).collect();
            assert_eq!(column.near_f64(), expected);
        }
    }

    #[test]
    fn every_kind_of_column_is_rounded_within_its_bound() {
        let mut state = 1_u64;
        let mut word = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            u128::from(state >> 1)
        };
        let mut counts = || -> Vec<i128> {
            let mut count = || ((word() << 63 ^ word()) as i128) >> (word() % 126);
            (0..500).map(|k| if k % 2 == 0 { count() } else { -count() }).chain([0, 1, -1]).collect()
        };
        let read = |text: &str| crate::Reading::Decimal.read(text, &crate::Limits::default()).unwrap();
        let mut long = Column::default();
        for text in ["-0.1234567890123456789012345678901234567890123", "7e30", "0", "-3e-60", "1e-72"] {
            assert!(long.push_text(text.as_bytes()));
        }
        assert!(matches!(long, Column::Long(_)));
        let columns = [
            Column::of_counts(counts().into_iter().map(|count| count >> 70), Unit::TenTo(-3)),
            Column::of_counts(counts().into_iter(), Unit::TenTo(-21)),
            Column::of_counts(counts().into_iter(), Unit::OneOver(7)),
            Column::Fractions(vec![Rational::ratio(1, 3), read("1e-40")]),
            long,
        ];
        for column in columns {
            let rounded = column.rounded().unwrap();
            assert_eq!(rounded.len(), column.len());
            for (index, &double) in rounded.iter().enumerate() {
                let (exact, rounded) = (column.get(index), Rational::from_f64(double).unwrap());
                let error = (&exact - rounded).abs();
                assert!(error * Rational::from(1_i128 << 50) <= exact.abs(), "{exact} as {double}");
            }
        }
        for far in ["1e-400", "1e400"] {
            assert_eq!(Column::from_iter([read(far)]).rounded(), None, "{far}");
        }
    }
}
