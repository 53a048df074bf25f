//! Directions, points and half-planes of the parameter plane.

use std::cmp::Ordering;

use boundfit_exact::{Integer, Rational};

/// A point or a direction.
pub(crate) type Vector = [Rational; 2];

/// u·v.
pub(crate) fn dot(u: &Vector, v: &Vector) -> Rational {
    &u[0] * &v[0] + &u[1] * &v[1]
}

/// The sign of u×v: greater where v lies less than half a turn to the left of u.
pub(crate) fn turn(u: &[Integer; 2], v: &[Integer; 2]) -> Ordering {
    (&u[0] * &v[1]).cmp(&(&u[1] * &v[0]))
}

/// Whether the angle of a direction in [0, 2π) is π or more.
fn is_low([x, y]: &[Integer; 2]) -> bool {
    y.is_negative() || y.is_zero() && x.is_negative()
}

/// Compares the angles of two directions in [0, 2π); neither is zero.
pub(crate) fn compare_angles(u: &[Integer; 2], v: &[Integer; 2]) -> Ordering {
    // Within a half, the angle of v is the larger one where v lies to the left of u.
    is_low(u).cmp(&is_low(v)).then_with(|| turn(v, u))
}

/// The points with a·θ ≤ b, in integers: those of the data, all of them multiplied by the same positive number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct HalfPlane {
    pub(crate) a: [Integer; 2],
    pub(crate) b: Integer,
    /// By what they were multiplied.
    pub(crate) times: Integer,
}

impl HalfPlane {
    /// The points with a·θ ≤ b for `[a1, a2, b]`.
    pub(crate) fn new([a1, a2, b]: &[Rational; 3]) -> Self {
        let ([a1, a2, b], times) = Rational::over_common_denominator([a1, a2, b]);
        HalfPlane { a: [a1, a2], b, times }
    }

    /// The points with -a·θ ≤ -b.
    pub(crate) fn opposite(&self) -> Self {
        let HalfPlane { a: [a1, a2], b, times } = self;
        HalfPlane { a: [-a1, -a2], b: -b, times: times.clone() }
    }

    /// a and b as they are in the data.
    pub(crate) fn numbers(&self) -> Option<(Vector, Rational)> {
        let number = |integer: &Integer| Rational::new(integer.clone(), self.times.clone());
        Some(([number(&self.a[0])?, number(&self.a[1])?], number(&self.b)?))
    }

    /// Compares a·θ with b at a point: not greater where the point is in the half-plane.
    pub(crate) fn compare_at(&self, point: &Point) -> Ordering {
        let [x, y] = &point.numerators;
        (&self.a[0] * x + &self.a[1] * y).cmp(&(&self.b * &point.denominator))
    }

    /// Compares a·d with 0: greater where one leaves the half-plane in this direction.
    pub(crate) fn compare_along(&self, direction: &Point) -> Ordering {
        let [x, y] = &direction.numerators;
        (&self.a[0] * x + &self.a[1] * y).cmp(&Integer::zero())
    }
}

/// A point, or a direction, in integers over one positive denominator.
#[derive(Debug, Clone)]
pub(crate) struct Point {
    numerators: [Integer; 2],
    denominator: Integer,
}

impl Point {
    pub(crate) fn new([x, y]: &Vector) -> Self {
        let (numerators, denominator) = Rational::over_common_denominator([x, y]);
        Point { numerators, denominator }
    }

    /// Compares u·self with u·other.
    pub(crate) fn compare_along(&self, u: &[Integer; 2], other: &Point) -> Ordering {
        let along = |point: &Point| &u[0] * &point.numerators[0] + &u[1] * &point.numerators[1];
        (along(self) * &other.denominator).cmp(&(along(other) * &self.denominator))
    }
}
