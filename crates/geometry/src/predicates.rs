//! Exact decisions. Nothing here makes a new point or number that outlives the question.

use std::cmp::Ordering;

use boundfit_exact::{Integer, Sign};

use crate::half_plane::HalfPlane;
use crate::point::{Direction, Point};

/// The place of a point with respect to a half-plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// `a·θ < b`.
    Inside,
    /// `a·θ = b`.
    Boundary,
    /// `a·θ > b`.
    Outside,
}

/// The turn from the direction `u` to the direction `v`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// No turn: both point in one direction.
    None,
    /// Counter-clockwise by less than a half turn.
    Left,
    /// A half turn.
    Half,
    /// Clockwise by less than a half turn.
    Right,
}

/// Returns the side of the half-plane's boundary on which the point lies.
pub fn side(half_plane: &HalfPlane, point: &Point) -> Side {
    let (x, y, w) = point.homogeneous();
    let [a1, a2, b] = &*half_plane.triple();
    match Integer::compare([(a1, x), (a2, y)], [(b, w)]) {
        Ordering::Less => Side::Inside,
        Ordering::Equal => Side::Boundary,
        Ordering::Greater => Side::Outside,
    }
}

/// The sign of `a·d`: whether moving in a direction leads towards the boundary and beyond (positive), along it
/// (zero) or away from it (negative).
pub fn approach(half_plane: &HalfPlane, direction: &Direction) -> Sign {
    let [a1, a2, _] = &*half_plane.triple();
    Integer::compare([(a1, direction.dx()), (a2, direction.dy())], []).into()
}

/// Returns the turn from `u` to `v`.
pub fn turn(u: &Direction, v: &Direction) -> Turn {
    turn_between((u.dx(), u.dy()), (v.dx(), v.dy()))
}

/// Returns the turn from the outward normal of `f` to that of `g`.
pub fn normal_turn(f: &HalfPlane, g: &HalfPlane) -> Turn {
    match (f.words(), g.words()) {
        (Some([f1, f2, _]), Some([g1, g2, _])) => {
            turn_by(products(f1, g2, f2, g1), || f1.signum() == g1.signum() && f2.signum() == g2.signum())
        }
        _ => turn_between(normal(&f.triple()), normal(&g.triple())),
    }
}

/// Returns the turn from the vector `u` to the vector `v`, given as components. Neither may be zero.
pub(crate) fn turn_between(u: (&Integer, &Integer), v: (&Integer, &Integer)) -> Turn {
    let is_along = || u.0.sign() == v.0.sign() && u.1.sign() == v.1.sign();
    turn_by(Integer::compare([(u.0, v.1)], [(u.1, v.0)]), is_along)
}

/// The turn by the order of the products of which the difference is the cross product.
fn turn_by(order: Ordering, is_along: impl Fn() -> bool) -> Turn {
    match order {
        Ordering::Greater => Turn::Left,
        Ordering::Less => Turn::Right,
        // Parallel vectors are never zero, so one comparison of signs tells them apart.
        Ordering::Equal if is_along() => Turn::None,
        Ordering::Equal => Turn::Half,
    }
}

/// Compares p·q with r·s. Exact.
fn products(p: i64, q: i64, r: i64, s: i64) -> Ordering {
    (i128::from(p) * i128::from(q)).cmp(&(i128::from(r) * i128::from(s)))
}

/// Compares outward normals by their angle in [0, 2π) from the positive θ1 axis.
pub fn by_angle(f: &HalfPlane, g: &HalfPlane) -> Ordering {
    match (f.words(), g.words()) {
        (Some([f1, f2, _]), Some([g1, g2, _])) => {
            let lower_half = |x: i64, y: i64| y < 0 || (y == 0 && x < 0);
            lower_half(f1, f2).cmp(&lower_half(g1, g2)).then_with(|| products(f2, g1, f1, g2))
        }
        _ => angle_order(normal(&f.triple()), normal(&g.triple())),
    }
}

/// The normal of the half-plane with this triple, as components.
pub(crate) fn normal([a1, a2, _]: &[Integer; 3]) -> (&Integer, &Integer) {
    (a1, a2)
}

/// Compares two vectors, as components, by angle in [0, 2π).
pub fn angle_order(u: (&Integer, &Integer), v: (&Integer, &Integer)) -> Ordering {
    // Angles in [0, π) come before those in [π, 2π); within each half the cross product decides.
    let lower_half = |(x, y): (&Integer, &Integer)| y.is_negative() || (y.is_zero() && x.is_negative());
    lower_half(u).cmp(&lower_half(v)).then_with(|| Integer::compare([(u.1, v.0)], [(u.0, v.1)]))
}

/// Compares two half-planes with the same direction of normal: `Less` when `f` lies inside `g`.
pub fn by_tightness(f: &HalfPlane, g: &HalfPlane) -> Ordering {
    let size = |h: &HalfPlane| h.a1().abs() + h.a2().abs();
    Integer::compare([(&f.b(), &size(g))], [(&g.b(), &size(f))])
}

/// Returns whether the corner of `f` and `h` lies in `g`, so that the other two imply the middle one. The three
/// half-planes have normals in this angular order within a half turn.
pub fn middle_is_implied(f: &HalfPlane, g: &HalfPlane, h: &HalfPlane) -> bool {
    order_of_middle(f, g, h).is_le()
}

/// Returns whether the boundaries of three half-planes meet in one point, or two of them are the same line. No two of them that
/// follow each other may have parallel normals.
pub(crate) fn are_concurrent(f: &HalfPlane, g: &HalfPlane, h: &HalfPlane) -> bool {
    order_of_middle(f, g, h).is_eq()
}

/// Compares the determinant of three half-planes with 0. With normals in this angular order within a half turn, it is `Less`
/// where the corner of `f` and `h` lies inside of `g`.
fn order_of_middle(f: &HalfPlane, g: &HalfPlane, h: &HalfPlane) -> Ordering {
    if let Some(order) = order_of_middle_in_words([f, g, h]) {
        return order;
    }
    let (f, g, h) = (f.triple(), g.triple(), h.triple());
    let minor = |p: &[Integer; 3], q: &[Integer; 3]| &p[0] * &q[1] - &p[1] * &q[0];
    // The corner of f and h has weight minor(f, h) > 0; Cramer's rule expands its slack along g.
    let (fg, gh, fh) = (minor(&f, &g), minor(&g, &h), minor(&f, &h));
    Integer::compare([(&f[2], &gh), (&h[2], &fg)], [(&g[2], &fh)])
}

/// The same of half-planes whose coefficients and minors are machine words, as those of most readings are; `None` of others.
#[inline]
fn order_of_middle_in_words(half_planes: [&HalfPlane; 3]) -> Option<Ordering> {
    let [f, g, h] = half_planes;
    let (f, g, h) = (f.words()?, g.words()?, h.words()?);
    let product = |left: i64, right: i64| i128::from(left) * i128::from(right);
    let minor = |[p1, p2, _]: [i64; 3], [q1, q2, _]: [i64; 3]| {
        i64::try_from(product(p1, q2).checked_sub(product(p2, q1))?).ok()
    };
    let outer = product(f[2], minor(g, h)?).checked_add(product(h[2], minor(f, g)?))?;
    Some(outer.cmp(&product(g[2], minor(f, h)?)))
}

/// Compares two points by θ1.
pub fn by_theta1(p: &Point, q: &Point) -> Ordering {
    let ((px, _, pw), (qx, _, qw)) = (p.homogeneous(), q.homogeneous());
    Integer::compare([(px, qw)], [(qx, pw)])
}

/// Compares two points by θ1, then by θ2.
pub fn lexicographic(p: &Point, q: &Point) -> Ordering {
    let ((_, py, pw), (_, qy, qw)) = (p.homogeneous(), q.homogeneous());
    by_theta1(p, q).then_with(|| Integer::compare([(py, qw)], [(qy, pw)]))
}

/// Returns the side of the line through `p` and `q`, in that order, `r` lies: `Positive` is to the left.
pub fn orientation(p: &Point, q: &Point, r: &Point) -> Sign {
    let (px, py, pw) = p.homogeneous();
    let (qx, qy, qw) = q.homogeneous();
    let (rx, ry, rw) = r.homogeneous();
    (rx * (py * qw - pw * qy) + ry * (pw * qx - px * qw) + rw * (px * qy - py * qx)).sign()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half_plane(a1: i64, a2: i64, b: i64) -> HalfPlane {
        HalfPlane::new(a1.into(), a2.into(), b.into()).unwrap()
    }

    fn point(x: i64, y: i64, w: i64) -> Point {
        Point::from_homogeneous(x.into(), y.into(), w.into()).unwrap()
    }

    #[test]
    fn sides_of_a_half_plane() {
        let h = half_plane(1, 2, 3);
        assert_eq!(side(&h, &point(1, 1, 1)), Side::Boundary);
        assert_eq!(side(&h, &point(1, 1, 2)), Side::Inside);
        assert_eq!(side(&h, &point(-5, -5, -2)), Side::Outside);
    }

    #[test]
    fn angles_go_once_around() {
        let normals = [(1, 0), (2, 1), (1, 1), (0, 3), (-1, 1), (-1, 0), (-2, -1), (0, -1), (1, -1), (5, -1)];
        for (i, &(a, b)) in normals.iter().enumerate() {
            for (j, &(c, d)) in normals.iter().enumerate() {
                assert_eq!(by_angle(&half_plane(a, b, 0), &half_plane(c, d, 1)), i.cmp(&j));
            }
        }
        assert_eq!(by_angle(&half_plane(1, 2, 0), &half_plane(2, 4, 1)), Ordering::Equal);
    }

    #[test]
    fn turns() {
        let direction = |x: i64, y: i64| Direction::new(x.into(), y.into()).unwrap();
        let east = direction(1, 0);
        for (x, y, expected) in [
            (3, 0, Turn::None),
            (1, 1, Turn::Left),
            (-1, 1, Turn::Left),
            (-2, 0, Turn::Half),
            (0, -1, Turn::Right),
        ] {
            assert_eq!(turn(&east, &direction(x, y)), expected);
        }
    }

    #[test]
    fn tightness_ignores_scale() {
        assert_eq!(by_tightness(&half_plane(2, 4, 3), &half_plane(1, 2, 2)), Ordering::Less);
        assert_eq!(by_tightness(&half_plane(2, 4, 5), &half_plane(1, 2, 2)), Ordering::Greater);
    }

    #[test]
    fn the_middle_half_plane_is_implied_when_it_contains_the_corner() {
        let (f, h) = (half_plane(1, 0, 1), half_plane(0, 1, 1));
        assert!(middle_is_implied(&f, &half_plane(1, 1, 2), &h));
        assert!(middle_is_implied(&f, &half_plane(1, 1, 3), &h));
        assert!(!middle_is_implied(&f, &half_plane(2, 2, 3), &h));
    }

    #[test]
    fn orientation_of_three_points() {
        let (o, e, n) = (point(0, 0, 1), point(3, 0, 2), point(0, 1, 7));
        assert_eq!(orientation(&o, &e, &n), Sign::Positive);
        assert_eq!(orientation(&o, &n, &e), Sign::Negative);
        assert_eq!(orientation(&o, &e, &point(9, 0, 1)), Sign::Zero);
    }
}
