//! Touching points of integer columns.

use super::filter::{Listing, Place, places};
use super::point::touching_of_sorted;
use super::{GridPoint, touching};

/// The [`touching`] points of two columns of equal length; `row` tells the number of the row at a position, and ascends. At most
/// `most` numbers of each are listed.
///
/// Exact: a float filter discards only what is certainly strictly between the hulls. Cost: linear when few places are close
/// to the hulls, O(n log n) at worst.
pub fn touching_of_columns(x: &[i64], y: &[i64], row: &dyn Fn(usize) -> u64, most: usize) -> Vec<GridPoint> {
    touching(points(places(x, y, Listing { row, most })), most)
}

/// [`touching_of_columns`] with each of the places strictly within an edge.
pub fn touching_places_of_columns(
    x: &[i64],
    y: &[i64],
    row: &dyn Fn(usize) -> u64,
    most: usize,
) -> Vec<GridPoint> {
    let mut points = points(places(x, y, Listing { row, most }));
    points.sort_unstable();
    touching_of_sorted(points, most, false)
}

pub(super) fn points(places: Vec<Place<i64>>) -> Vec<GridPoint> {
    places.into_iter().map(|Place { x, y, rows }| GridPoint { x, y, rows }).collect()
}

/// Returns the places of two columns of equal length that may [touch](super::touching) a hull. Every place that
/// touches is among them, perhaps more than once; if the data have some width, few others are. `row` and `most` are
/// those of [`touching_of_columns`]. Exact in this sense. Cost: linear.
pub fn candidates_of_columns(
    x: &[i128],
    y: &[i128],
    row: &dyn Fn(usize) -> u64,
    most: usize,
) -> Vec<Place<i128>> {
    places(x, y, Listing { row, most })
}
