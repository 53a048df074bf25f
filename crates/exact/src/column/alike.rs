//! Finds equal numbers of a column.

use std::hash::{Hash, Hasher};

use super::Column;

impl Column {
    /// Hands a hasher what numbers of this column have in common where they are equal.
    ///
    /// # Panics
    /// When there are not that many numbers.
    #[allow(
        clippy::indexing_slicing,
        reason = "documented to panic; who asks counts the rows of the same column"
    )]
    pub fn hash_at(&self, index: usize, state: &mut impl Hasher) {
        match self {
            Column::Narrow(scaled) => scaled.counts()[index].hash(state),
            Column::Wide(scaled) => scaled.counts()[index].hash(state),
            Column::Long(long) => long.words(index).hash(state),
            Column::Doubles(doubles) => doubles[index].to_bits().hash(state),
            Column::Scattered(scattered) => scattered.numbers()[index].hash(state),
            Column::Fractions(numbers) => numbers[index].hash(state),
        }
    }

    /// Returns whether two numbers of this column are equal. Exact.
    ///
    /// # Panics
    /// When there are not that many numbers.
    #[allow(
        clippy::indexing_slicing,
        reason = "documented to panic; who asks counts the rows of the same column"
    )]
    pub fn are_equal(&self, one: usize, other: usize) -> bool {
        match self {
            Column::Narrow(scaled) => scaled.counts()[one] == scaled.counts()[other],
            Column::Wide(scaled) => scaled.counts()[one] == scaled.counts()[other],
            Column::Long(long) => long.words(one) == long.words(other),
            Column::Doubles(doubles) => doubles[one] == doubles[other],
            Column::Scattered(scattered) => scattered.numbers()[one] == scattered.numbers()[other],
            Column::Fractions(numbers) => numbers[one] == numbers[other],
        }
    }
}
