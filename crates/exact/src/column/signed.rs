//! Columns with other signs.

use super::{Column, Long, Scaled};
use crate::Rational;

impl Column {
    /// The numbers, those negated for whose row this says so; rows beyond it stay as they are. Exact. Cost: linear.
    pub fn negated_where(&self, is_negated: &[bool]) -> Column {
        let signs = || is_negated.iter().copied().chain(std::iter::repeat(false));
        match self {
            Column::Narrow(scaled) => {
                let mut counts = scaled.counts().to_vec();
                // All bits turned, and 1 added; no magnitude has all bits.
                for (count, &is_negated) in counts.iter_mut().zip(is_negated) {
                    let mask = -i64::from(is_negated);
                    *count = (*count ^ mask).wrapping_sub(mask);
                }
                Column::Narrow(Scaled::of_counts(counts, scaled.unit()))
            }
            Column::Wide(scaled) => {
                let mut counts = scaled.counts().to_vec();
                for (count, &is_negated) in counts.iter_mut().zip(is_negated) {
                    let mask = -i128::from(is_negated);
                    *count = (*count ^ mask).wrapping_sub(mask);
                }
                Column::Wide(Scaled::of_counts(counts, scaled.unit()))
            }
            Column::Long(long) => Column::Long(Long::negated_where(long, signs())),
            Column::Doubles(doubles) => {
                // Zero has one sign.
                let signed =
                    doubles.iter().zip(signs()).map(|(&d, negated)| if negated { 0.0 - d } else { d });
                Column::Doubles(signed.collect())
            }
            Column::Scattered(scattered) => Column::Scattered(scattered.negated_where(signs())),
            Column::Fractions(numbers) => {
                let signed =
                    |(number, negated): (&Rational, bool)| if negated { -number } else { number.clone() };
                Column::Fractions(numbers.iter().zip(signs()).map(signed).collect())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Reading, Unit};

    #[test]
    fn every_kind_of_column_takes_signs() {
        let read = |text: &str| Reading::Decimal.read(text, &Limits::default()).unwrap();
        let mut long = Column::default();
        for text in ["-0.1234567890123456789012345678901234567890123", "7e30", "0", "-3e-60"] {
            assert!(long.push_text(text.as_bytes()));
        }
        let largest = (1 << 62) - 1;
        let columns = [
            Column::of_counts([3, -5, 0, largest, -largest].into_iter(), Unit::TenTo(-2)),
            Column::of_counts([3, -5, 0, 1 << 100, -1 << 100].into_iter(), Unit::OneOver(7)),
            long,
            Column::of_doubles(&[1.5, -0.25, 0.0, 1e300]).unwrap(),
            Column::of_shortest(&[1.5e300, -2.5e-300, 0.0, -7.0]).unwrap(),
            Column::Fractions([read("1/3"), read("-2/7"), read("0"), read("9e99")].to_vec()),
        ];
        for column in columns {
            let is_negated: Vec<bool> = (0..column.len() - 1).map(|row| row % 3 != 1).collect();
            let signed = column.negated_where(&is_negated);
            assert_eq!(column.has_zero(), (0..column.len()).any(|row| column.get(row).is_zero()));
            assert_eq!(std::mem::discriminant(&column), std::mem::discriminant(&signed));
            for row in 0..column.len() {
                let number = column.get(row);
                let expected = if is_negated.get(row) == Some(&true) { -number } else { number };
                assert_eq!(signed.get(row), expected);
            }
            if let Column::Doubles(doubles) = signed {
                assert!(doubles.iter().all(|double| *double != 0.0 || double.is_sign_positive()));
            }
        }
    }

    #[test]
    fn offsets_are_counted_from_any_base() {
        let largest = (1 << 62) - 1;
        for base in [0, -7, largest, largest - 5, -largest, -largest - 1, i64::MAX, i64::MIN] {
            let offsets = [0, 5, u32::MAX];
            let column = Column::of_offsets(base, &offsets, Unit::TenTo(-1));
            let counts = offsets.map(|offset| i128::from(base) + i128::from(offset));
            assert_eq!(column, Column::of_counts(counts.into_iter(), Unit::TenTo(-1)), "{base}");
        }
        assert_eq!(Column::of_offsets(3, &[], Unit::Any), Column::default());
    }
}
