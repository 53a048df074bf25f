//! Directions and half-planes of the parameter plane.

use boundfit_exact::Rational;
use serde::Deserialize;

/// A point or a direction.
pub(crate) type Vector = [Rational; 2];

/// u·v.
pub(crate) fn dot(u: &Vector, v: &Vector) -> Rational {
    &u[0] * &v[0] + &u[1] * &v[1]
}

/// u×v: positive where v lies less than half a turn to the left of u.
pub(crate) fn cross(u: &Vector, v: &Vector) -> Rational {
    &u[0] * &v[1] - &u[1] * &v[0]
}

/// The points with a·θ ≤ b; in files `[a1, a2, b]`.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(from = "[Rational; 3]")]
pub(crate) struct HalfPlane {
    pub(crate) a: Vector,
    pub(crate) b: Rational,
}

impl From<[Rational; 3]> for HalfPlane {
    fn from([a1, a2, b]: [Rational; 3]) -> Self {
        HalfPlane { a: [a1, a2], b }
    }
}

/// The angle of a direction in [0, 2π), as something that grows with it: there is no need for the angle itself.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Angle {
    /// Whether it is π or more. Comes first: `derive` compares from the top.
    is_low: bool,
    /// -cot, which grows from -∞ to ∞ within each half; none at 0 and π, where a half begins. `None` sorts first.
    minus_cotangent: Option<Rational>,
}

impl Angle {
    /// `None` for the zero vector, which has no direction.
    pub(crate) fn of([x, y]: &Vector) -> Option<Angle> {
        if x.is_zero() && y.is_zero() {
            return None;
        }
        let is_low = y.is_negative() || y.is_zero() && x.is_negative();
        Some(Angle { is_low, minus_cotangent: (-x).checked_div(y) })
    }
}
