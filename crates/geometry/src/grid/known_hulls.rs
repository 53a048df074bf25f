//! The hulls of points that are known already, to tell exactly which points are strictly within an edge. Readings in
//! few steps have many such points, at more places than a table remembers.

use boundfit_exact::Sign;

use super::filter::{Counted, Listing, Place, tied_by};
use super::point::are_narrow;
use super::{GridPoint, doubled_area, touching};
use crate::hull::{Hull, HullSide};

/// Corners of both hulls, from left to right.
pub(super) struct KnownHulls([Vec<GridPoint>; 2]);

/// The place of a point, as one hull sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Seen {
    /// The side where the other hull is.
    Inside,
    /// Strictly within the edge that begins at this corner.
    Within(usize),
    /// The other side, a corner, or left or right of all.
    Elsewhere,
}

impl KnownHulls {
    /// Returns the hulls of points of the whole; `None` where products of coordinates do not fit. Cost: O(n log n).
    pub(super) fn new(points: &[GridPoint]) -> Option<Self> {
        let touching = touching(points.to_vec(), 1);
        if !are_narrow(&touching) {
            return None;
        }
        let hull = |side| Hull::new(side, &touching, |p, q, r| doubled_area(p, q, r).cmp(&0).into());
        let corner = |position: usize| touching[position].clone();
        let lower = hull(HullSide::Lower).corners().map(corner).collect();
        let upper = hull(HullSide::Upper).corners().rev().map(corner).collect();
        Some(KnownHulls([lower, upper]))
    }

    /// The places of some rows, ascending by position, without those strictly between these hulls: those strictly within an edge
    /// together as the first of them. Exact.
    pub(super) fn places(
        &self,
        x: &[i64],
        y: &[i64],
        positions: Vec<usize>,
        listing: Listing,
    ) -> Vec<Place<i64>> {
        let counted = |x: i64, y: i64| {
            let point = GridPoint::of_row(x, y, 0);
            match [false, true].map(|is_upper| self.seen(is_upper, &point)) {
                [Seen::Inside, Seen::Inside] => Counted::Nowhere,
                [Seen::Within(edge), _] => Counted::Among(edge),
                [_, Seen::Within(edge)] => Counted::Among(self.0[0].len() + edge),
                _ => Counted::Alone,
            }
        };
        tied_by(x, y, positions.into_iter(), listing, counted)
    }

    fn seen(&self, is_upper: bool, point: &GridPoint) -> Seen {
        let corners = &self.0[usize::from(is_upper)];
        let after = corners.partition_point(|corner| corner.x < point.x);
        let Some([from, to]) =
            after.checked_sub(1).and_then(|from| corners.get(from..=from + 1)?.first_chunk())
        else {
            return Seen::Elsewhere;
        };
        if point.x == to.x {
            let is_inside = if is_upper { point.y < to.y } else { point.y > to.y };
            return if is_inside { Seen::Inside } else { Seen::Elsewhere };
        }
        if !are_narrow(std::slice::from_ref(point)) {
            return Seen::Elsewhere;
        }
        let inside = if is_upper { Sign::Negative } else { Sign::Positive };
        match doubled_area(from, to, point).cmp(&0).into() {
            Sign::Zero => Seen::Within(after - 1),
            sign if sign == inside => Seen::Inside,
            _ => Seen::Elsewhere,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The square from (0, 0) to (8, 8) without its sides, and a corner of the upper hull at (4, 9).
    #[test]
    fn what_is_within_an_edge_is_told_from_what_is_not() {
        let corners = [(0, 0), (0, 8), (8, 0), (8, 8), (4, 9), (4, 4)];
        let points: Vec<GridPoint> =
            (0..).zip(corners).map(|(row, (x, y))| GridPoint::of_row(x, y, row)).collect();
        let known = KnownHulls::new(&points).unwrap();
        let rows = [
            (3, 0),
            (5, 0),
            (5, 1),
            (5, -1),
            (0, 4),
            (0, 0),
            (4, 9),
            (4, 10),
            (-1, 3),
            (8, 9),
            (8, 3),
            (i64::MAX, 0),
            (3, i64::MIN),
            (5, 0),
        ];
        let (x, y): (Vec<i64>, Vec<i64>) = rows.into_iter().unzip();
        let listing = Listing { row: &|row| row as u64, most: 9 };
        let places = known.places(&x, &y, (0..x.len()).collect(), listing);
        let mut found: Vec<Vec<u64>> = places.iter().map(|place| place.rows.rows().collect()).collect();
        found.sort_unstable();
        // (0, 4) is left of the edges; only what is at the first x is looked at again.
        let expected: [&[u64]; 10] = [&[0, 1, 13], &[3], &[4], &[5], &[6], &[7], &[8], &[9], &[11], &[12]];
        assert_eq!(found, expected);
    }
}
