//! The convex hull of points as two chains (Andrew 1979, the monotone chain).

use boundfit_exact::Sign;

use crate::point::Point;
use crate::predicates::{by_theta1, orientation};

/// Lower and upper hull of points, as positions in the list, each by θ1 ascending. Of several points above each other
/// the lower hull has the lowest and the upper one the highest; of points within an edge, neither has any.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hulls {
    /// From the leftmost to the rightmost point below all others.
    pub lower: Vec<usize>,
    /// From the leftmost to the rightmost point above all others.
    pub upper: Vec<usize>,
}

impl Hulls {
    /// The hulls of items at points, sorted by [`lexicographic`](crate::predicates::lexicographic). Exact. Cost: linear.
    pub fn of_sorted<T>(items: &[T], point: impl Fn(&T) -> &Point) -> Self {
        let at = |position: usize| point(&items[position]);
        Hulls::by(
            items.len(),
            |p, q| by_theta1(at(p), at(q)).is_eq(),
            |p, q, r| orientation(at(p), at(q), at(r)),
        )
    }

    /// The hulls of points of any kind, sorted by θ1, then by θ2, from what is asked about their positions: whether two
    /// are above each other, and on which side of the line through two, in that order, a third lies (`Positive` is to the
    /// left). As exact as the answers. Cost: linear.
    pub fn by(
        count: usize,
        above_each_other: impl Fn(usize, usize) -> bool,
        orientation: impl Fn(usize, usize, usize) -> Sign,
    ) -> Self {
        let lower = chain(0..count, &above_each_other, &orientation);
        let mut upper = chain((0..count).rev(), &above_each_other, &orientation);
        upper.reverse();
        Hulls { lower, upper }
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

/// The positions where a walk over sorted points, either way, keeps turning left.
fn chain(
    walk: impl Iterator<Item = usize>,
    above_each_other: &impl Fn(usize, usize) -> bool,
    orientation: &impl Fn(usize, usize, usize) -> Sign,
) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for next in walk {
        // Walking forward the first point of each θ1 is its lowest, walking back its highest.
        if chain.last().is_some_and(|&last| above_each_other(last, next)) {
            continue;
        }
        while let [.., before, last] = chain.as_slice()
            && orientation(*before, *last, next) != Sign::Positive
        {
            chain.pop();
        }
        chain.push(next);
    }
    chain
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
        let hulls = Hulls::of_sorted(&sorted(points), |point| point);
        (hulls.lower.clone(), hulls.upper.clone(), hulls.corners())
    }

    #[test]
    fn points_above_each_other_and_in_line_are_left_out() {
        // 0 (0,0)  1 (0,1)  2 (0,2)  3 (1,0)  4 (1,2)  5 (2,0)  6 (2,1)  7 (2,2)
        let square = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1), (2, 2)];
        assert_eq!(hulls(&square), (vec![0, 5], vec![2, 7], vec![0, 5, 7, 2]));
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
