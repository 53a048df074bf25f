//! Columns of some of the numbers of another.

use std::ops::Range;

use super::Column;

impl Column {
    /// Some of the numbers.
    ///
    /// # Panics
    /// When there are not that many.
    #[allow(clippy::indexing_slicing, reason = "documented to panic")]
    pub fn part(&self, range: Range<usize>) -> Column {
        match self {
            Column::Narrow(scaled) => Column::Narrow(scaled.part(range)),
            Column::Wide(scaled) => Column::Wide(scaled.part(range)),
            Column::Long(long) => Column::Long(long.part(range)),
            Column::Doubles(doubles) => Column::Doubles(doubles[range].to_vec()),
            Column::Scattered(scattered) => Column::Scattered(scattered.part(range)),
            Column::Fractions(numbers) => Column::Fractions(numbers[range].to_vec()),
        }
    }

    /// Returns the numbers at these places.
    ///
    /// # Panics
    /// When there are not that many.
    #[allow(clippy::indexing_slicing, reason = "documented to panic")]
    pub fn at(&self, places: impl Iterator<Item = usize>) -> Column {
        match self {
            Column::Narrow(scaled) => Column::Narrow(scaled.at(places)),
            Column::Wide(scaled) => Column::Wide(scaled.at(places)),
            Column::Doubles(doubles) => Column::Doubles(places.map(|place| doubles[place]).collect()),
            Column::Scattered(scattered) => Column::Scattered(scattered.at(places)),
            Column::Long(long) => Column::Long(long.at(places)),
            Column::Fractions(numbers) => {
                Column::Fractions(places.map(|place| numbers[place].clone()).collect())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Rational, Reading, Unit};

    #[test]
    fn every_kind_of_column_gives_numbers_at_places() {
        let read = |text: &str| Reading::Decimal.read(text, &Limits::default()).unwrap();
        let mut long = Column::default();
        for text in ["-0.1234567890123456789012345678901234567890123", "7e30", "0", "-3e-60", "12"] {
            assert!(long.push_text(text.as_bytes()));
        }
        let largest = (1 << 62) - 1;
        let columns = [
            Column::of_counts([3, -5, 0, largest, -largest].into_iter(), Unit::TenTo(-2)),
            Column::of_counts([3, -5, 0, 1 << 100, -1 << 100].into_iter(), Unit::OneOver(7)),
            long,
            Column::of_doubles(&[1.5, -0.25, 0.0, 1e300, 7.0]).unwrap(),
            Column::of_shortest(&[1.5e300, -2.5e-300, 0.0, -7.0, 8.5]).unwrap(),
            Column::Fractions([read("1/3"), read("-2/7"), read("0"), read("9e99"), read("1")].to_vec()),
        ];
        for column in columns {
            assert_eq!(column.has_zero(), (0..column.len()).any(|row| column.get(row).is_zero()));
            for places in [&[4, 0, 0, 2][..], &[], &[0, 1, 2, 3, 4]] {
                let some = column.at(places.iter().copied());
                assert_eq!(std::mem::discriminant(&column), std::mem::discriminant(&some));
                let numbers: Vec<Rational> = (0..some.len()).map(|row| some.get(row)).collect();
                assert_eq!(numbers, places.iter().map(|&place| column.get(place)).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn doubles_that_are_integers_have_counts() {
        let largest = ((1_i64 << 53) - 1) as f64;
        let integers = |doubles: &[f64]| Column::of_doubles(doubles).unwrap().integers();
        let counts = [0, -7, (1 << 53) - 1, 1 - (1 << 53)].into_iter();
        let expected = Column::of_counts(counts, Unit::TenTo(0));
        assert_eq!(integers(&[-0.0, -7.0, largest, -largest]), Some(expected));
        for other in [0.5, -1e-300, largest + 1.0, -1e300] {
            assert_eq!(integers(&[1.0, other]), None, "{other}");
        }
        assert_eq!(Column::of_counts([1].into_iter(), Unit::TenTo(0)).integers(), None);
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
