//! The hulls of the readings that a reduction of a line keeps.

use std::cmp::Ordering;
use std::collections::HashSet;

use boundfit_exact::Rational;

use crate::hulls::{Extremes, Touching};
use crate::measurement::Measurement;

/// Both hulls of (x, y).
#[derive(Debug)]
pub(super) struct Outline<'a> {
    corners: HashSet<[&'a Rational; 2]>,
    /// The lower outline, sorted by x.
    lower: Vec<[&'a Rational; 2]>,
    /// The upper outline, sorted by x.
    upper: Vec<[&'a Rational; 2]>,
}

impl<'a> Outline<'a> {
    /// Returns the outline of readings with x as it is. Exact. Cost: O(n log n).
    pub(super) fn of(rows: &'a [Measurement]) -> Self {
        let extremes = Extremes::new(rows, None);
        let place = |position: usize| {
            let row = rows.get(position)?;
            Some([&row.regressor[0], row.response()?])
        };
        let chain = |is_on: fn(&&Touching) -> bool| {
            let on = extremes.touching.iter().filter(is_on);
            let mut chain: Vec<_> = on.filter_map(|own| place(own.position())).collect();
            chain.sort_unstable();
            chain
        };
        let [lower, upper] = [chain(|own| own.lower), chain(|own| own.upper)];
        Outline { corners: extremes.corners.iter().copied().filter_map(place).collect(), lower, upper }
    }

    /// Returns whether a reading lies at a corner.
    pub(super) fn has_corner(&self, x: &Rational, y: &Rational) -> bool {
        self.corners.contains(&[x, y])
    }

    /// Returns whether a point lies between the hulls, and on neither where that is asked for. So does the mean of points that do, and it
    /// is on neither where one of these is not. Exact. Cost: O(log n).
    pub(super) fn has_within(&self, point: &[Rational; 2], strictly: bool) -> bool {
        let within = |chain: &[[&Rational; 2]], outside: Ordering| match side(chain, point) {
            None => false,
            Some(Ordering::Equal) => !strictly,
            Some(side) => side != outside,
        };
        within(&self.lower, Ordering::Less) && within(&self.upper, Ordering::Greater)
    }
}

/// Returns where a point is as seen from a chain of points by x: below, on it or above; `None` beside it.
fn side(chain: &[[&Rational; 2]], [x, y]: &[Rational; 2]) -> Option<Ordering> {
    let next = chain.partition_point(|[own, _]| *own < x);
    let [next_x, next_y] = chain.get(next)?;
    if *next_x == x {
        return Some(y.cmp(next_y));
    }
    let [last_x, last_y] = chain.get(next.checked_sub(1)?)?;
    let rise = (*next_y - *last_y) * (x - *last_x);
    Some(((y - *last_y) * (*next_x - *last_x)).cmp(&rise))
}
