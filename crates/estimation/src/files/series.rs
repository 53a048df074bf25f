//! A column of any length in memory: eight bytes per number where the numbers allow it.

use std::ops::Range;

use boundfit_exact::{Column, Rational, Unit};

use super::counts::{Counts, Integers};

/// The number of numbers in a segment. One number that needs more room makes its segment longer, not the whole
/// column, and a column grows without being moved.
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
            let last = self.segments.last_mut().filter(|last| last.len() < SEGMENT);
            let upto = column.len().min(from + SEGMENT - last.as_ref().map_or(0, |last| last.len()));
            match last {
                Some(last) => last.append(column, from..upto),
                None => {
                    let mut fresh = column.part(from..upto);
                    // A column that grows by doubling would end up with up to twice the memory.
                    fresh.reserve(SEGMENT - fresh.len());
                    self.segments.push(fresh);
                }
            }
            from = upto;
        }
    }

    /// Returns whether some numbers did not fit into integers of machine words or doubles.
    pub(super) fn has_fractions(&self) -> bool {
        self.segments.iter().any(are_fractions)
    }

    /// Some numbers one after the other.
    pub(super) fn column_of_run(&self, rows: Range<usize>) -> Column {
        let mut column = Column::default();
        let mut start = rows.start;
        while start < rows.end {
            let upto = rows.end.min((start / SEGMENT + 1) * SEGMENT);
            let within = start % SEGMENT..start % SEGMENT + (upto - start);
            column.append(&self.segments[start / SEGMENT], within);
            start = upto;
        }
        column
    }

    /// Some of the numbers, by their ascending positions.
    pub(super) fn column(&self, rows: impl Iterator<Item = usize>) -> Column {
        let mut column = Column::default();
        let mut rows = rows.peekable();
        while let Some(segment) = rows.peek().map(|row| row / SEGMENT) {
            let own = std::iter::from_fn(|| rows.next_if(|row| row / SEGMENT == segment));
            let part = self.segments[segment].at(own.map(|row| row % SEGMENT));
            column.append(&part, 0..part.len());
        }
        column
    }

    /// A number.
    pub(super) fn get(&self, index: usize) -> Rational {
        self.segments[index / SEGMENT].get(index % SEGMENT)
    }

    /// Some numbers one after the other as [`Series::counts`] has them.
    pub(super) fn counts_of_run(&self, rows: Range<usize>) -> Option<Counts<'_>> {
        let first = rows.start / SEGMENT;
        let within = rows.start % SEGMENT..rows.start % SEGMENT + rows.len();
        if within.end > SEGMENT || rows.is_empty() {
            return self.counts(rows);
        }
        let segment = self.segments.get(first)?;
        let counts = match segment {
            Column::Narrow(scaled) => Integers::Short(scaled.counts().get(within)?.into()),
            Column::Wide(scaled) => Integers::Long(scaled.counts().get(within)?.into()),
            Column::Long(_) | Column::Doubles(_) | Column::Scattered(_) | Column::Fractions(_) => {
                return None;
            }
        };
        Some(Counts { counts, exponent: exponent(segment)? })
    }

    /// Some of the numbers as integers on a power of ten, where they are kept as such: on the finest one of their segments.
    pub(super) fn counts(
        &self,
        rows: impl ExactSizeIterator<Item = usize> + Clone,
    ) -> Option<Counts<'static>> {
        /// The most numbers of several segments that are copied. A larger group finds its deciding readings without a copy.
        const MOST_SPREAD: usize = 4096;
        let segment = |row: usize| row / SEGMENT;
        let first = rows.clone().next()?;
        if rows.len() > MOST_SPREAD && rows.clone().any(|row| segment(row) != segment(first)) {
            return None;
        }
        let mut exponents = rows.clone().map(|row| exponent(self.segments.get(row / SEGMENT)?));
        let first = exponents.next()??;
        let exponent_of_all = exponents.try_fold(first, |finest, own| Some(finest.min(own?)))?;
        let count = |row: usize| {
            let segment = self.segments.get(row / SEGMENT)?;
            let count = match segment {
                Column::Narrow(scaled) => scaled.counts().get(row % SEGMENT).copied().map(i128::from),
                Column::Wide(scaled) => scaled.counts().get(row % SEGMENT).copied(),
                Column::Long(_) | Column::Doubles(_) | Column::Scattered(_) | Column::Fractions(_) => None,
            }?;
            match exponent(segment)?.abs_diff(exponent_of_all) {
                0 => Some(count),
                finer => count.checked_mul(10_i128.checked_pow(finer)?),
            }
        };
        let counts = Integers::Long(rows.map(count).collect::<Option<_>>()?);
        Some(Counts { counts, exponent: exponent_of_all })
    }
}

/// Returns whether some numbers of a column did not fit into integers of machine words or doubles.
pub(super) fn are_fractions(column: &Column) -> bool {
    matches!(column, Column::Scattered(_) | Column::Fractions(_))
}

/// The power of ten of which the numbers of a segment are multiples by machine integers.
fn exponent(segment: &Column) -> Option<i32> {
    let unit = match segment {
        Column::Narrow(scaled) => scaled.unit(),
        Column::Wide(scaled) => scaled.unit(),
        Column::Long(_) | Column::Doubles(_) | Column::Scattered(_) | Column::Fractions(_) => {
            return None;
        }
    };
    match unit {
        Unit::Any => Some(0),
        Unit::TenTo(exponent) => Some(exponent),
        Unit::OneOver(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scaled(mantissas: &[i64], exponent: i32) -> Column {
        Column::of_counts(mantissas.iter().map(|&mantissa| mantissa.into()), Unit::TenTo(exponent))
    }

    #[test]
    fn numbers_come_back_as_they_went_in() {
        let columns = [
            scaled(&[12, -3, 0], -1),
            scaled(&[5, 7], 2),
            scaled(&[i64::MAX, i64::MIN], -1),
            scaled(&[1], -300),
            scaled(&[9], 0),
            Column::Fractions(vec![Rational::ratio(1, 3), Rational::one()]),
            Column::Doubles(vec![0.5, -0.25]),
            Column::Fractions(Vec::new()),
        ];
        let mut series = Series::default();
        columns.iter().for_each(|column| series.push(column));
        let count = columns.iter().map(Column::len).sum();
        let [all, gathered] = [series.column_of_run(0..count), series.column(0..count)];
        let some = series.column([1, 2, 5, 6].into_iter());
        assert_eq!([0, 3].map(|k| some.get(k)), [1, 6].map(|k| series.get(k)));
        let expected = columns.iter().flat_map(|column| (0..column.len()).map(|index| column.get(index)));
        for (index, expected) in expected.enumerate() {
            let found = [series.get(index), all.get(index), gathered.get(index)];
            assert_eq!(found, [expected.clone(), expected.clone(), expected], "{index}");
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
        assert!(series.segments.iter().all(|segment| matches!(segment, Column::Narrow(_))));
        assert_eq!(series.get(50_003), Rational::ratio(2, 100));
        assert_eq!(series.get(199_999), Rational::ratio(49_999 * 49_999 - 7, 100));
    }

    #[test]
    fn counts_of_several_segments_are_on_the_finest_unit() {
        let mut series = Series::default();
        let numbers: Vec<i64> = (1..=SEGMENT as i64).collect();
        for exponent in [-1, 2, -3] {
            series.push(&scaled(&numbers, exponent));
        }
        series.push(&Column::Doubles(vec![0.5]));
        let rows = [0, 7, SEGMENT, SEGMENT + 3, 2 * SEGMENT, 3 * SEGMENT - 1];
        for some in [&rows[..], &rows[..2], &rows[2..4], &rows[1..4], &rows[3..]] {
            let counts = series.counts(some.iter().copied()).expect("decimals");
            for run in [some[0]..some[0] + 1, some[0]..some[0] + 5] {
                let [own, by_row] =
                    [series.counts_of_run(run.clone()), series.counts(run)].map(Option::unwrap);
                let all = |own: &Counts| own.counts.iter().collect::<Vec<_>>();
                assert_eq!((all(&own), own.exponent), (all(&by_row), by_row.exponent));
            }
            let number = |count: i128| Rational::scientific(count, counts.exponent);
            let found: Vec<Rational> = counts.counts.iter().map(number).collect();
            assert_eq!(found, some.iter().map(|&row| series.get(row)).collect::<Vec<_>>());
        }
        let across = series.counts_of_run(SEGMENT - 2..SEGMENT + 2).expect("decimals");
        let by_row = series.counts(SEGMENT - 2..SEGMENT + 2).expect("decimals");
        assert!(across.counts.iter().eq(by_row.counts.iter()));
        assert!(series.counts_of_run(3 * SEGMENT..3 * SEGMENT + 1).is_none());
        assert!(series.counts([0, 3 * SEGMENT].into_iter()).is_none());
        assert!(series.counts([0, 5 * SEGMENT].into_iter()).is_none());
    }

    #[test]
    fn a_long_number_makes_its_own_segment_long_only() {
        let mut series = Series::default();
        let ones = vec![1; SEGMENT - 1];
        series.push(&scaled(&ones, 0));
        let tiny = Rational::scientific(1, -40);
        series.push(&Column::Fractions(vec![tiny.clone()]));
        series.push(&scaled(&ones, 0));
        assert!(matches!(series.segments.as_slice(), [Column::Fractions(_), Column::Narrow(_)]));
        assert_eq!(series.get(SEGMENT - 1), tiny);
        let across = [SEGMENT - 3, SEGMENT - 1, SEGMENT, SEGMENT + 4];
        let expected: Column = across.iter().map(|&row| series.get(row)).collect();
        assert_eq!(series.column(across.into_iter()), expected);
        let run = series.column_of_run(SEGMENT - 3..SEGMENT + 1);
        assert_eq!((run.len(), run.get(2), run.get(3)), (4, tiny, Rational::one()));
    }
}
