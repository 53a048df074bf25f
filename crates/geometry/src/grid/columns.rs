//! Touching points of integer columns.

use super::filter::candidates;
use super::{GridPoint, touching};

/// The [`touching`] points of two columns of equal length, with ids `first_id`, `first_id + 1`, …
///
/// Exact: a float filter discards only what is certainly strictly between the hulls. Cost: linear when few rows are close
/// to the hulls, O(n log n) at worst.
///
/// # Panics
/// When an id does not fit into 64 bits.
pub fn touching_of_columns(x: &[i64], y: &[i64], first_id: u64) -> Vec<GridPoint> {
    let point = |row: usize| GridPoint { x: x[row], y: y[row], id: first_id + row as u64 };
    touching(candidates(x, y).into_iter().map(point).collect())
}

/// Positions, ascending, of the rows of two columns of equal length that may [touch](super::touching) a hull: every one that
/// does is among them, and of data with some width few others. Exact in this sense. Cost: linear.
pub fn candidates_of_columns(x: &[i128], y: &[i128]) -> Vec<usize> {
    candidates(x, y)
}
