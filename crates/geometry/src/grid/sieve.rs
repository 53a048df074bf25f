//! A filter from points that are known already, for many columns one after the other.

use super::cells::Equal;
use super::columns::{points, touching_of_columns};
use super::filter::{Filter, Listing, tied};
use super::sample::Sample;
use super::{GridPoint, touching};

/// Discards what is certainly strictly between the hulls of some points: a filter that is made once, where one from a
/// sample would be made for each pair of columns.
pub struct Sieve(Filter<i64, Equal>);

impl Sieve {
    /// From points of the whole, best those that [touch](super::touching) its hulls so far; `None` when they span no width.
    /// Cost: O(n log n).
    pub fn new(points: &[GridPoint]) -> Option<Self> {
        let [x, y] = [|point: &GridPoint| point.x, |point: &GridPoint| point.y]
            .map(|of| points.iter().map(of).collect::<Vec<i64>>());
        let sample = Sample::of(&x, &y, points.len())?;
        let cells = sample.equal_cells()?;
        Some(Sieve(Filter::new(&sample, cells)))
    }

    /// The [`touching`](super::touching) points of two columns, perhaps without some that do not touch the hulls of these and the
    /// sieve's points together. `row` and `most` are those of [`touching_of_columns`]. Exact in this sense: with the sieve's
    /// points, they have the same touching points as all. Cost: linear when few rows are close to the hulls, O(n log n) at worst.
    pub fn touching_of_columns(
        &self,
        x: &[i64],
        y: &[i64],
        row: &dyn Fn(usize) -> u64,
        most: usize,
    ) -> Vec<GridPoint> {
        /// Of so many rows one may be left; with more, the points were not those of these data.
        const RARE: usize = 16;
        let survivors = self.0.survivors(x, y);
        let found = survivors.len();
        let places = tied(x, y, survivors.into_iter(), Listing { row, most });
        if found * RARE > x.len() && 2 * places.len() > found {
            return touching_of_columns(x, y, row, most);
        }
        touching(points(places), most)
    }
}
