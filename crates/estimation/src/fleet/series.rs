//! A column of any length in memory: eight bytes per number where the numbers allow it.

use boundfit_exact::{Rational, Scaled};
use boundfit_formats::Column;

/// How many numbers a segment has. One number that needs the long form makes its segment long, not the whole column, and
/// a column grows without being moved.
const SEGMENT: usize = 1 << 16;

/// Numbers, added at the end and read anywhere. Exact.
#[derive(Debug, Clone, Default)]
pub(super) struct Series {
    /// All but the last have [`SEGMENT`] numbers.
    segments: Vec<Column>,
}

impl Series {
    /// Adds the numbers of a column.
    pub(super) fn push(&mut self, column: &Column) {
        let mut from = 0;
        while from < column.len() {
            let last = self.segments.last().filter(|last| last.len() < SEGMENT);
            let upto = column.len().min(from + SEGMENT - last.map_or(0, Column::len));
            let fresh = part(column, from, upto);
            match self.segments.last_mut().filter(|last| last.len() < SEGMENT) {
                Some(last) => append(last, fresh),
                None => self.segments.push(with_room(fresh)),
            }
            from = upto;
        }
    }

    /// A number.
    pub(super) fn get(&self, index: usize) -> Rational {
        self.segments[index / SEGMENT].get(index % SEGMENT)
    }
}

/// Some numbers of a column.
fn part(column: &Column, from: usize, upto: usize) -> Column {
    match column {
        Column::Scaled(Scaled { mantissas, exponent }) => {
            Column::Scaled(Scaled { mantissas: mantissas[from..upto].to_vec(), exponent: *exponent })
        }
        Column::Doubles(doubles) => Column::Doubles(doubles[from..upto].to_vec()),
        Column::Exact(numbers) => Column::Exact(numbers[from..upto].to_vec()),
    }
}

/// The first numbers of a segment, with room for all the others: a column that grows by doubling would end up with up to
/// twice the memory.
fn with_room(mut fresh: Column) -> Column {
    if let Column::Scaled(Scaled { mantissas, .. }) = &mut fresh {
        mantissas.reserve_exact(SEGMENT - mantissas.len());
    }
    fresh
}

/// Adds numbers to a segment, which becomes long when nothing shorter holds both.
fn append(segment: &mut Column, fresh: Column) {
    match (&mut *segment, fresh) {
        (Column::Doubles(own), Column::Doubles(fresh)) => own.extend(fresh),
        (Column::Scaled(own), Column::Scaled(mut fresh)) => {
            let exponent = own.exponent.min(fresh.exponent);
            if lower(own, exponent) && lower(&mut fresh, exponent) {
                own.mantissas.extend(fresh.mantissas);
            } else {
                append_long(segment, &Column::Scaled(fresh));
            }
        }
        (_, fresh) => append_long(segment, &fresh),
    }
}

fn append_long(segment: &mut Column, fresh: &Column) {
    if !matches!(segment, Column::Exact(_)) {
        *segment = Column::Exact((0..segment.len()).map(|index| segment.get(index)).collect());
    }
    if let Column::Exact(own) = segment {
        own.extend((0..fresh.len()).map(|index| fresh.get(index)));
    }
}

/// Brings numbers to a smaller power of ten; leaves them as they are and says so when they do not fit.
fn lower(scaled: &mut Scaled, exponent: i32) -> bool {
    if scaled.exponent == exponent {
        return true;
    }
    let factor = scaled.exponent.abs_diff(exponent);
    let factor = 10_i64.checked_pow(factor);
    let times = |mantissa: &i64| factor.and_then(|factor| mantissa.checked_mul(factor));
    match scaled.mantissas.iter().map(times).collect() {
        Some(mantissas) => {
            *scaled = Scaled { mantissas, exponent };
            true
        }
        None => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scaled(mantissas: &[i64], exponent: i32) -> Column {
        Column::Scaled(Scaled { mantissas: mantissas.to_vec(), exponent })
    }

    #[test]
    fn numbers_come_back_as_they_went_in() {
        let columns = [
            scaled(&[12, -3, 0], -1),
            scaled(&[5, 7], 2),
            scaled(&[i64::MAX, i64::MIN], -1),
            scaled(&[1], -300),
            scaled(&[9], 0),
            Column::Exact(vec![Rational::ratio(1, 3), Rational::one()]),
            Column::Doubles(vec![0.5, -0.25]),
            Column::Exact(Vec::new()),
        ];
        let mut series = Series::default();
        columns.iter().for_each(|column| series.push(column));
        let expected = columns.iter().flat_map(|column| (0..column.len()).map(|index| column.get(index)));
        for (index, expected) in expected.enumerate() {
            assert_eq!(series.get(index), expected, "{index}");
        }
    }

    #[test]
    fn short_numbers_stay_short_across_segments() {
        let mut series = Series::default();
        let numbers: Vec<i64> = (0..50_000).map(|k| k * k - 7).collect();
        for exponent in [-3, -2, -3, -2] {
            series.push(&scaled(&numbers, exponent));
        }
        assert_eq!(
            series.segments.iter().map(Column::len).collect::<Vec<_>>(),
            [65_536, 65_536, 65_536, 3_392]
        );
        assert!(series.segments.iter().all(|segment| matches!(segment, Column::Scaled(_))));
        assert_eq!(series.get(50_003), Rational::ratio(2, 100));
        assert_eq!(series.get(199_999), Rational::ratio(49_999 * 49_999 - 7, 100));
    }

    #[test]
    fn a_long_number_makes_its_own_segment_long_only() {
        let mut series = Series::default();
        let ones = vec![1; SEGMENT - 1];
        series.push(&scaled(&ones, 0));
        series.push(&Column::Exact(vec![Rational::ratio(1, 3)]));
        series.push(&scaled(&ones, 0));
        assert!(matches!(series.segments.as_slice(), [Column::Exact(_), Column::Scaled(_)]));
        assert_eq!(series.get(SEGMENT - 1), Rational::ratio(1, 3));
    }
}
