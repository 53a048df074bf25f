//! Points and directions in homogeneous integer coordinates.

use boundfit_exact::{Integer, Rational};

/// A point of the plane, kept as the primitive integer triple `(x : y : w)` with `w > 0`.
///
/// Equal points have equal triples, so `==` is equality in the plane.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Point {
    x: Integer,
    y: Integer,
    w: Integer,
}

impl Point {
    /// The point with the given coordinates.
    pub fn new(theta1: &Rational, theta2: &Rational) -> Self {
        let ([x, y], w) = Rational::over_common_denominator([theta1, theta2]);
        Point { x, y, w }
    }

    /// The point `(x / w, y / w)`, or `None` when `w` is 0.
    pub fn from_homogeneous(x: Integer, y: Integer, w: Integer) -> Option<Self> {
        if w.is_zero() {
            return None;
        }
        // The gcd of two numbers is often 1 already, and then the third does not matter.
        let divisor = w.gcd(&x).gcd(&y);
        let divisor = if w.is_negative() { -divisor } else { divisor };
        let reduced = |value: Integer| value.quotient(&divisor);
        Some(Point { x: reduced(x), y: reduced(y), w: reduced(w) })
    }

    /// The point with this coordinate on an axis, 0 or 1, and `other / w` on the other one; `None` when `w` is 0. The coordinate's
    /// denominator divides `w`. Takes one greatest common divisor, of less than the whole numbers.
    pub(crate) fn with_coordinate(
        axis: usize,
        coordinate: &Rational,
        other: Integer,
        w: &Integer,
    ) -> Option<Self> {
        if w.is_zero() {
            return None;
        }
        let (numerator, denominator) = (coordinate.numerator(), coordinate.denominator());
        // Only divisors of this factor divide all three.
        let times = w.quotient(&denominator);
        let divisor = times.gcd(&other);
        let divisor = if times.is_negative() { -divisor } else { divisor };
        let (times, other) = (times.quotient(&divisor), other.quotient(&divisor));
        let (own, w) = (numerator * &times, denominator * times);
        Some(if axis == 0 { Point { x: own, y: other, w } } else { Point { x: other, y: own, w } })
    }

    /// The origin.
    pub fn origin() -> Self {
        Point { x: Integer::zero(), y: Integer::zero(), w: Integer::one() }
    }

    /// First coordinate.
    pub fn theta1(&self) -> Rational {
        Rational::new(self.x.clone(), self.w.clone()).unwrap_or_default()
    }

    /// Second coordinate.
    pub fn theta2(&self) -> Rational {
        Rational::new(self.y.clone(), self.w.clone()).unwrap_or_default()
    }

    /// Both coordinates.
    pub fn coordinates(&self) -> [Rational; 2] {
        [self.theta1(), self.theta2()]
    }

    /// The primitive triple `(x, y, w)`, `w > 0`.
    #[inline]
    pub fn homogeneous(&self) -> (&Integer, &Integer, &Integer) {
        (&self.x, &self.y, &self.w)
    }
}

/// A direction: a primitive integer vector, never zero.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Direction {
    dx: Integer,
    dy: Integer,
}

impl Direction {
    /// The direction of a vector, or `None` for the zero vector.
    pub fn new(dx: Integer, dy: Integer) -> Option<Self> {
        let divisor = dx.gcd(&dy);
        if divisor.is_zero() {
            return None;
        }
        Some(Direction { dx: dx.quotient(&divisor), dy: dy.quotient(&divisor) })
    }

    /// The direction of a rational vector, or `None` for the zero vector.
    pub fn from_rational(vector: &[Rational; 2]) -> Option<Self> {
        let [x, y] = vector;
        Direction::new(x.numerator() * y.denominator(), y.numerator() * x.denominator())
    }

    /// First component.
    #[inline]
    pub fn dx(&self) -> &Integer {
        &self.dx
    }

    /// Second component.
    #[inline]
    pub fn dy(&self) -> &Integer {
        &self.dy
    }

    /// The opposite direction.
    pub fn reversed(&self) -> Self {
        Direction { dx: -&self.dx, dy: -&self.dy }
    }

    /// A quarter turn counter-clockwise.
    pub fn turned_left(&self) -> Self {
        Direction { dx: -&self.dy, dy: self.dx.clone() }
    }

    /// A quarter turn clockwise.
    pub fn turned_right(&self) -> Self {
        Direction { dx: self.dy.clone(), dy: -&self.dx }
    }

    /// Returns, of the two opposite directions along the same line, the one whose first non-zero component is
    /// positive.
    pub fn of_line(&self) -> Self {
        let negative = if self.dx.is_zero() { self.dy.is_negative() } else { self.dx.is_negative() };
        if negative { self.reversed() } else { self.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_coordinate_leaves_the_point_as_it_is() {
        let numbers = [-210, -60, -7, -1, 0, 1, 6, 35, 420].map(Integer::from);
        for x in &numbers {
            for y in &numbers {
                for w in &numbers {
                    let point = Point::from_homogeneous(x.clone(), y.clone(), w.clone());
                    for (axis, own, other) in [(0, x, y), (1, y, x)] {
                        let coordinate = Rational::new(own.clone(), w.clone()).unwrap_or_default();
                        let known = Point::with_coordinate(axis, &coordinate, other.clone(), w);
                        assert_eq!(known, point, "({x} : {y} : {w})");
                    }
                }
            }
        }
    }
}
