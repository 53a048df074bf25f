//! The convex hull of sorted points as two chains (Andrew 1979, the monotone chain).

use std::borrow::Borrow;

use boundfit_exact::Sign;

use crate::point::Point;
use crate::predicates::{by_theta1, orientation};

/// The chain's questions about two points; about three points it asks for their orientation.
pub trait Site {
    /// Returns whether both have the same x.
    fn is_above_or_below(&self, other: &Self) -> bool;
    /// Returns whether both are at one place.
    fn coincides(&self, other: &Self) -> bool;
}

impl<P: Borrow<Point>> Site for P {
    fn is_above_or_below(&self, other: &Self) -> bool {
        by_theta1(self.borrow(), other.borrow()).is_eq()
    }

    fn coincides(&self, other: &Self) -> bool {
        self.borrow() == other.borrow()
    }
}

/// One of the two hulls, and with it the way along which it is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HullSide {
    /// The hull below all points, from left to right.
    Lower,
    /// The hull above all points, from right to left.
    Upper,
}

/// One of the two hulls of points, as positions in their list, counter-clockwise. If several points are above each
/// other, it has the lowest or the highest only.
#[derive(Debug, Clone)]
pub struct Hull {
    side: HullSide,
    links: Vec<Link>,
}

/// A point on a hull, of those that coincide the first on the way.
#[derive(Debug, Clone, Copy)]
struct Link {
    position: usize,
    /// `true` if the point is not within an edge.
    is_corner: bool,
}

impl Hull {
    /// The hull of points sorted by x, then y. `orientation` says on which side of the line through the first two points, in
    /// that order, the third lies (`Positive` is to the left). As exact as that. Cost: linear.
    pub fn new<P: Site>(side: HullSide, sorted: &[P], orientation: impl Fn(&P, &P, &P) -> Sign) -> Self {
        let links = match side {
            HullSide::Lower => chain(0..sorted.len(), sorted, orientation),
            HullSide::Upper => chain((0..sorted.len()).rev(), sorted, orientation),
        };
        Hull { side, links }
    }

    /// The lower and the upper hull of points sorted by x, then y, as [`Hull::new`] finds them. Cost: that of one hull where all points
    /// are corners of the lower one.
    pub fn both<P: Site>(sorted: &[P], orientation: impl Fn(&P, &P, &P) -> Sign) -> [Self; 2] {
        let lower = Hull::new(HullSide::Lower, sorted, &orientation);
        // A corner of the lower hull between its ends lies strictly below the upper one.
        let mut is_below = vec![false; sorted.len()];
        if let [_, between @ .., _] = lower.links.as_slice() {
            between.iter().for_each(|link| is_below[link.position] = link.is_corner);
        }
        let walk = (0..sorted.len()).rev().filter(|&position| !is_below[position]);
        let links = chain(walk, sorted, orientation);
        [lower, Hull { side: HullSide::Upper, links }]
    }

    /// Positions of the corners.
    pub fn corners(&self) -> impl DoubleEndedIterator<Item = usize> {
        self.links.iter().filter(|link| link.is_corner).map(|link| link.position)
    }

    /// Positions of everything on the hull: corners, points within edges, and every repetition of each.
    pub fn support<P: Site>(&self, sorted: &[P]) -> impl Iterator<Item = usize> {
        self.links.iter().flat_map(|link| self.repetitions(sorted, link.position))
    }

    /// [`Hull::support`], and of what is strictly within an edge the corners at its ends.
    pub(crate) fn support_by_edge<P: Site>(
        &self,
        sorted: &[P],
    ) -> impl Iterator<Item = (usize, Option<[usize; 2]>)> {
        let mut before = 0;
        // The last link is a corner, and so is that of each run.
        self.links.chunk_by(|one, _| !one.is_corner).flat_map(move |run| {
            let after = run.last().map_or(before, |corner| corner.position);
            let ends = [std::mem::replace(&mut before, after), after];
            run.iter().flat_map(move |link| {
                let edge = (!link.is_corner).then_some(ends);
                self.repetitions(sorted, link.position).map(move |position| (position, edge))
            })
        })
    }

    /// Positions of the corners, each alone, and of the points strictly within each edge; of those that coincide only the first
    /// on the way.
    pub(crate) fn corners_and_edges(&self) -> impl Iterator<Item = impl Iterator<Item = usize> + Clone> {
        let groups = self.links.chunk_by(|one, next| !one.is_corner && !next.is_corner);
        groups.map(|links| links.iter().map(|link| link.position))
    }

    /// All positions with the point of a link, in the order of the way.
    fn repetitions<P: Site>(&self, sorted: &[P], first: usize) -> impl Iterator<Item = usize> {
        let (ahead, behind) = match self.side {
            HullSide::Lower => (first..sorted.len(), 0..0),
            HullSide::Upper => (0..0, 0..first + 1),
        };
        ahead.chain(behind.rev()).take_while(move |&position| sorted[position].coincides(&sorted[first]))
    }
}

/// Returns where a walk over sorted points keeps turning left or going straight on.
fn chain<P: Site>(
    walk: impl Iterator<Item = usize>,
    sorted: &[P],
    orientation: impl Fn(&P, &P, &P) -> Sign,
) -> Vec<Link> {
    // Room for the hull of a small table; a larger one grows.
    let mut chain: Vec<Link> = Vec::with_capacity(sorted.len().min(32));
    for position in walk {
        // Walking forward the first point of each x is its lowest, walking back its highest.
        if chain.last().is_some_and(|last| sorted[last.position].is_above_or_below(&sorted[position])) {
            continue;
        }
        while let [.., before, last] = chain.as_mut_slice() {
            match orientation(&sorted[before.position], &sorted[last.position], &sorted[position]) {
                Sign::Negative => chain.pop(),
                turn => {
                    // Said anew by each point that comes next: the one that stays has the last word.
                    last.is_corner = turn == Sign::Positive;
                    break;
                }
            };
        }
        chain.push(Link { position, is_corner: true });
    }
    chain
}

/// The corners of lower and upper hull, as positions in the list of points, each from left to right.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hulls {
    /// The hull below all points.
    pub lower: Vec<usize>,
    /// The hull above all points.
    pub upper: Vec<usize>,
}

impl Hulls {
    /// The hulls of points sorted by [`lexicographic`](crate::predicates::lexicographic). Exact. Cost: linear.
    pub fn of_sorted<P: Borrow<Point>>(points: &[P]) -> Self {
        let hull = |side: HullSide| {
            Hull::new(side, points, |p: &P, q: &P, r: &P| orientation(p.borrow(), q.borrow(), r.borrow()))
        };
        Hulls {
            lower: hull(HullSide::Lower).corners().collect(),
            upper: hull(HullSide::Upper).corners().rev().collect(),
        }
    }

    /// The corners of the convex hull of distinct points, counter-clockwise from the leftmost lowest.
    pub fn corners(&self) -> Vec<usize> {
        let mut corners = self.lower.clone();
        let above = self.upper.iter().rev().filter(|position| !self.ends().contains(position));
        corners.extend(above);
        corners
    }

    /// The ends of the lower hull, which the upper one may share.
    fn ends(&self) -> [&usize; 2] {
        [self.lower.first().unwrap_or(&0), self.lower.last().unwrap_or(&0)]
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Rational;

    use super::*;
    use crate::predicates::lexicographic;

    fn sorted(points: &[(i64, i64)]) -> Vec<Point> {
        let point = |&(x, y)| Point::new(&Rational::from(x), &Rational::from(y));
        let mut points: Vec<Point> = points.iter().map(point).collect();
        points.sort_by(lexicographic);
        points
    }

    fn hulls(points: &[(i64, i64)]) -> (Vec<usize>, Vec<usize>, Vec<usize>) {
        let hulls = Hulls::of_sorted(&sorted(points));
        (hulls.lower.clone(), hulls.upper.clone(), hulls.corners())
    }

    #[test]
    fn points_above_each_other_and_in_line_are_left_out() {
        // 0 (0,0)  1 (0,1)  2 (0,2)  3 (1,0)  4 (1,2)  5 (2,0)  6 (2,1)  7 (2,2)
        let square = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1), (2, 2)];
        assert_eq!(hulls(&square), (vec![0, 5], vec![2, 7], vec![0, 5, 7, 2]));
    }

    #[test]
    fn the_support_has_everything_on_a_hull() {
        // 0 (0,0)  1 (0,0)  2 (0,3)  3 (1,0)  4 (2,0)  5 (2,0)  6 (2,9)  7 (3,1)  8 (4,0)  9 (4,3)  10 (4,3)
        let points =
            sorted(&[(0, 0), (0, 0), (0, 3), (1, 0), (2, 0), (2, 0), (2, 9), (3, 1), (4, 0), (4, 3), (4, 3)]);
        let hull = |side| Hull::new(side, &points, orientation);
        let (lower, upper) = (hull(HullSide::Lower), hull(HullSide::Upper));
        assert_eq!(lower.support(&points).collect::<Vec<_>>(), [0, 1, 3, 4, 5, 8]);
        assert_eq!(lower.corners().collect::<Vec<_>>(), [0, 8]);
        assert_eq!(upper.support(&points).collect::<Vec<_>>(), [10, 9, 6, 2]);
        assert_eq!(upper.corners().collect::<Vec<_>>(), [10, 6, 2]);
    }

    #[test]
    fn both_hulls_are_those_that_are_found_alone() {
        let mut seed = 7_u64;
        for round in 0..2_000 {
            let mut next = || {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (seed >> 33) as i64 % [2, 4, 40][round % 3]
            };
            // On a line, whose points are on both hulls, on a parabola, whose corners are those of one hull, and anywhere.
            let point = |place: usize| match ((round / 12) % 5, place % 4) {
                (0, _) => Some(next()).map_or((0, 0), |x| (x, 2 * x)),
                (_, 0) => (next(), next()),
                (1, _) => Some(next()).map_or((0, 0), |x| (x, -x * x)),
                _ => Some(next()).map_or((0, 0), |x| (x, x * x)),
            };
            let points = sorted(&(0..round % 12).map(point).collect::<Vec<_>>());
            let [lower, upper] = Hull::both(&points, orientation);
            for (own, side) in [(lower, HullSide::Lower), (upper, HullSide::Upper)] {
                let alone = Hull::new(side, &points, orientation);
                let parts = |hull: &Hull| -> (Vec<usize>, Vec<usize>) {
                    (hull.corners().collect(), hull.support(&points).collect())
                };
                assert_eq!(parts(&own), parts(&alone), "{points:?}");
            }
        }
    }

    #[test]
    fn flat_and_small_sets_have_hulls() {
        assert_eq!(hulls(&[]), (vec![], vec![], vec![]));
        assert_eq!(hulls(&[(3, 4)]), (vec![0], vec![0], vec![0]));
        assert_eq!(hulls(&[(0, 0), (1, 1), (2, 2)]), (vec![0, 2], vec![0, 2], vec![0, 2]));
        assert_eq!(hulls(&[(5, 0), (5, 1), (5, 2)]), (vec![0], vec![2], vec![0, 2]));
        assert_eq!(hulls(&[(0, 0), (1, 3), (2, 0)]), (vec![0, 2], vec![0, 1, 2], vec![0, 2, 1]));
    }

    #[test]
    fn the_corners_of_grid_points_are_those_no_triangle_contains() {
        let mut seed = 1_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as i64 % 5
        };
        for _ in 0..500 {
            let mut points: Vec<(i64, i64)> = (0..8).map(|_| (next(), next())).collect();
            points.sort_unstable();
            points.dedup();
            let (_, _, mut corners) = hulls(&points);
            corners.sort_unstable();
            let cross = |p: (i64, i64), q: (i64, i64), r: (i64, i64)| {
                (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0)
            };
            // A point is no corner when it lies in a triangle or between two of the others.
            let inside = |r: (i64, i64)| {
                let others: Vec<(i64, i64)> = points.iter().copied().filter(|&point| point != r).collect();
                let within = |a, b, c| {
                    let turns = [cross(a, b, r), cross(b, c, r), cross(c, a, r)];
                    cross(a, b, c) != 0 && (turns.iter().all(|&t| t >= 0) || turns.iter().all(|&t| t <= 0))
                };
                let between = |a: (i64, i64), b: (i64, i64)| {
                    cross(a, b, r) == 0 && (a.0 - r.0) * (b.0 - r.0) + (a.1 - r.1) * (b.1 - r.1) < 0
                };
                others.iter().any(|&a| {
                    others.iter().any(|&b| between(a, b) || others.iter().any(|&c| within(a, b, c)))
                })
            };
            let expected: Vec<usize> = (0..points.len()).filter(|&k| !inside(points[k])).collect();
            assert_eq!(corners, expected, "{points:?}");
        }
    }
}
