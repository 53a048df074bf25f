//! Exact constructions. Nothing here decides; a construction that does not exist is `None`.

use boundfit_exact::{Integer, Rational};

use crate::half_plane::HalfPlane;
use crate::point::{Direction, Point};

/// The common point of two boundaries, unless they are parallel (Cramer's rule). Exact.
pub fn meet(f: &HalfPlane, g: &HalfPlane) -> Option<Point> {
    let [x, y, w] = crossing(f, g);
    Point::from_homogeneous(x, y, w)
}

/// The common point of two boundaries that are not parallel, one coordinate of which is known already. Exact.
pub(crate) fn meet_at(f: &HalfPlane, g: &HalfPlane, axis: usize, coordinate: &Rational) -> Option<Point> {
    let [x, y, w] = crossing(f, g);
    let other = if axis == 0 { y } else { x };
    Point::with_coordinate(axis, coordinate, other, &w)
}

/// The common point of two boundaries as a triple (x : y : w) with common divisors, `w` positive where the normals turn to the left
/// and 0 where they are parallel. Exact.
pub(crate) fn crossing(f: &HalfPlane, g: &HalfPlane) -> [Integer; 3] {
    if let (Some([f1, f2, f0]), Some([g1, g2, g0])) = (f.words(), g.words()) {
        // A product of two words has at most 126 bits and a sign, so that the difference of two fits.
        let minor = |[p, q]: [i64; 2], [r, s]: [i64; 2]| {
            Integer::from(i128::from(p) * i128::from(s) - i128::from(q) * i128::from(r))
        };
        return [minor([f0, f2], [g0, g2]), minor([f1, f0], [g1, g0]), minor([f1, f2], [g1, g2])];
    }
    let (f, g) = (f.triple(), g.triple());
    let ([f1, f2, f0], [g1, g2, g0]) = (&*f, &*g);
    [f0 * g2 - g0 * f2, f1 * g0 - g1 * f0, f1 * g2 - g1 * f2]
}

/// The point of the boundary that is nearest to the origin.
pub fn foot(half_plane: &HalfPlane) -> Point {
    let [a1, a2, b] = &*half_plane.triple();
    Point::from_homogeneous(a1 * b, a2 * b, a1 * a1 + a2 * a2).expect("half-plane with a zero normal")
}

/// The direction from one point to another, unless they are equal.
pub fn direction_between(from: &Point, to: &Point) -> Option<Direction> {
    let ((fx, fy, fw), (tx, ty, tw)) = (from.homogeneous(), to.homogeneous());
    Direction::new(tx * fw - fx * tw, ty * fw - fy * tw)
}

/// The mean of one or more points; the origin for none. Exact.
pub fn mean<'a>(points: impl ExactSizeIterator<Item = &'a Point> + Clone) -> Point {
    let count = Rational::from(points.len());
    let mean_of = |coordinate: fn(&Point) -> Rational| {
        let total: Rational = points.clone().map(coordinate).sum();
        total.checked_div(&count).unwrap_or_default()
    };
    Point::new(&mean_of(Point::theta1), &mean_of(Point::theta2))
}

/// The point reached from `start` by one step of each direction. Exact.
pub fn translated<'a>(start: &Point, steps: impl IntoIterator<Item = &'a Direction>) -> Point {
    let [mut theta1, mut theta2] = start.coordinates();
    for step in steps {
        theta1 = theta1 + Rational::from(step.dx());
        theta2 = theta2 + Rational::from(step.dy());
    }
    Point::new(&theta1, &theta2)
}

/// `c1·θ1 + c2·θ2` at a point.
pub fn value_of(form: &[Rational; 2], point: &Point) -> Rational {
    &form[0] * point.theta1() + &form[1] * point.theta2()
}

/// The mid-point between the nearest points to the origin of two parallel boundaries.
pub fn between_parallels(f: &HalfPlane, g: &HalfPlane) -> Point {
    mean([foot(f), foot(g)].iter())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boundaries_of_machine_words_cross_where_longer_ones_do() {
        let numbers = [0, 1, -1, 7, i64::MAX, i64::MIN, i64::MIN + 1];
        let triples = numbers.iter().flat_map(|&p| numbers.iter().map(move |&q| [p, q, p.wrapping_sub(q)]));
        let half_planes: Vec<HalfPlane> = triples
            .filter_map(|triple| {
                let [a1, a2, b] = triple.map(Integer::from);
                HalfPlane::new(a1, a2, b)
            })
            .collect();
        for f in &half_planes {
            for g in &half_planes {
                let ([f1, f2, f0], [g1, g2, g0]) = ([f.a1(), f.a2(), f.b()], [g.a1(), g.a2(), g.b()]);
                let expected = [&f0 * &g2 - &g0 * &f2, &f1 * &g0 - &g1 * &f0, &f1 * &g2 - &g1 * &f2];
                assert_eq!(crossing(f, g), expected, "{f:?} {g:?}");
            }
        }
    }
}
