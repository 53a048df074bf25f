//! Numbers of one group as integers, without a copy where they stand together in a column.

use std::borrow::Cow;

use crate::moments::{bits, widest};

/// Numbers as integers on a power of ten.
pub(super) struct Counts<'a> {
    pub(super) counts: Integers<'a>,
    pub(super) exponent: i32,
}

/// Integers of the processor, most often those of a column.
pub(super) enum Integers<'a> {
    Short(Cow<'a, [i64]>),
    Long(Cow<'a, [i128]>),
}

impl Integers<'_> {
    pub(super) fn len(&self) -> usize {
        match self {
            Integers::Short(counts) => counts.len(),
            Integers::Long(counts) => counts.len(),
        }
    }

    #[inline]
    fn get(&self, index: usize) -> i128 {
        match self {
            Integers::Short(counts) => counts[index].into(),
            Integers::Long(counts) => counts[index],
        }
    }

    pub(super) fn iter(&self) -> impl ExactSizeIterator<Item = i128> + Clone {
        (0..self.len()).map(|index| self.get(index))
    }

    /// The bits of the largest magnitude.
    pub(super) fn widest(&self) -> u32 {
        match self {
            Integers::Short(counts) => widest(counts),
            Integers::Long(counts) => bits(counts.iter().fold(0, |all, count| all | count.unsigned_abs())),
        }
    }

    fn are_multiples(&self, divisor: i64) -> bool {
        match self {
            Integers::Short(counts) => counts.iter().all(|count| count % divisor == 0),
            Integers::Long(counts) => counts.iter().all(|count| count % i128::from(divisor) == 0),
        }
    }
}

impl Counts<'_> {
    /// The same numbers on the coarsest decimal unit up to 1 that they allow. The unit that they have is that of
    /// thousands of readings, of which some may have more digits.
    pub(super) fn coarsened(self) -> Self {
        let finest = (-self.exponent).clamp(0, 18).unsigned_abs();
        // Mostly the first reading refuses each coarser unit.
        let are_whole = |places: &u32| self.counts.are_multiples(10_i64.pow(*places));
        let Some(places) = (1..=finest).rev().find(are_whole) else { return self };
        let power = 10_i128.pow(places);
        let counts = Integers::Long(self.counts.iter().map(|count| count / power).collect());
        Counts { counts, exponent: self.exponent + places as i32 }
    }
}
