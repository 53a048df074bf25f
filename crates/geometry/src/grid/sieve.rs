//! A filter from points that are known already, for many columns one after the other.

use super::cells::Equal;
use super::columns::{points, touching_of_columns};
use super::filter::{Filter, Listing, tied};
use super::known_hulls::KnownHulls;
use super::sample::Sample;
use super::{GridPoint, touching};

/// Discards what is certainly strictly between the hulls of some points: a filter that is made once, where one from a
/// sample would be made for each pair of columns.
pub struct Sieve {
    filter: Filter<i64, Equal>,
    hulls: Option<KnownHulls>,
}

impl Sieve {
    /// Returns a sieve from points of the whole, best those that [touch](super::touching) its hulls so far; `None`
    /// when they span no width. Cost: O(n log n).
    pub fn new(points: &[GridPoint]) -> Option<Self> {
        let [x, y] = [|point: &GridPoint| point.x, |point: &GridPoint| point.y]
            .map(|of| points.iter().map(of).collect::<Vec<i64>>());
        let sample = Sample::of(&x, &y, points.len())?;
        let cells = sample.equal_cells()?;
        Some(Sieve { filter: Filter::new(&sample, cells), hulls: KnownHulls::new(points) })
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
        /// The number of rows of which at most one may remain; if more remain, the points did not come from these
        /// data.
        const RARE: usize = 16;
        if self.filter.is_beside(x) {
            return touching_of_columns(x, y, row, most);
        }
        let listing = Listing { row, most };
        let survivors = self.filter.survivors(x, y);
        let places = match &self.hulls {
            Some(hulls) => hulls.places(x, y, survivors, listing),
            None => tied(x, y, survivors.into_iter(), listing),
        };
        if places.len() * RARE > x.len() {
            return touching_of_columns(x, y, row, most);
        }
        touching(points(places), most)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_which_most_are_beside_the_points_are_noticed() {
        let known: Vec<GridPoint> = (0..100).map(|x| GridPoint::of_row(x, x * x % 7, x as u64)).collect();
        let sieve = Sieve::new(&known).unwrap();
        for (x, expected) in [
            (0..100, false),
            (100..200, true),
            (-200..0, true),
            (50..140, false),
            (50..180, true),
            (-90..190, true),
            (0..0, false),
        ] {
            assert_eq!(sieve.filter.is_beside(&x.clone().collect::<Vec<i64>>()), expected, "{x:?}");
        }
    }

    /// Steps so few that many points are strictly within an edge; sometimes all on one line.
    #[test]
    fn with_the_sieve_s_points_nothing_is_lost_and_everything_is_counted_once() {
        let mut seed = 9_u64;
        let mut below = |size: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as i64 % size
        };
        let mut sieves = 0;
        for round in 0..4_000 {
            let (width, height) = (1 + below(12), 1 + below(4));
            let slope = below(5) - 2;
            let count = below(120) as usize;
            let (x, y): (Vec<i64>, Vec<i64>) = (0..count)
                .map(|_| {
                    let x = below(width);
                    (x, slope * x + below(height))
                })
                .unzip();
            let first = below(count as i64 + 1) as usize;
            for most in [2, usize::MAX] {
                let known = touching_of_columns(&x[..first], &y[..first], &|row| row as u64, most);
                let Some(sieve) = Sieve::new(&known) else { continue };
                sieves += 1;
                let row = |row: usize| (first + row) as u64;
                let mut all = known;
                all.extend(sieve.touching_of_columns(&x[first..], &y[first..], &row, most));
                let whole = touching_of_columns(&x, &y, &|row| row as u64, most);
                assert_eq!(touching(all, most), whole, "{round} {most} {first} {x:?} {y:?}");
            }
        }
        assert!(sieves > 5_000, "{sieves}");
    }
}
