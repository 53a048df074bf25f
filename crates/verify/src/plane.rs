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

/// Returns whether the angle of a direction in [0, 2π) is π or more.
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
    /// The factor that multiplied the numbers.
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

    /// The memory that it takes, about.
    pub(crate) fn bits(&self) -> u64 {
        const WITHOUT_DIGITS: u64 = 512;
        let HalfPlane { a: [a1, a2], b, times } = self;
        WITHOUT_DIGITS + [a1, a2, b, times].map(Integer::bits).iter().sum::<u64>()
    }

    /// Compares a·θ with b at a point: not greater where the point is in the half-plane.
    pub(crate) fn compare_at(&self, point: &Point) -> Ordering {
        // Almost every half-plane of many.
        if point.near.is_some_and(|near| near.is_surely_within(self)) {
            return Ordering::Less;
        }
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
    near: Option<Near>,
}

/// A point from below: each coordinate is at least this many units of 2^-shift, and less than one more.
#[derive(Debug, Clone, Copy)]
struct Near {
    units: [i64; 2],
    shift: u32,
}

/// The largest shift, up to 60, for which a point has less than 2^61 units of 2^-shift in each coordinate. There is none for a
/// point that is too far away.
fn room(numerators: &[Integer; 2], denominator: &Integer) -> Option<u32> {
    let bits = numerators.iter().map(Integer::bits).max()?;
    u32::try_from((denominator.bits() + 60).checked_sub(bits)?.min(60)).ok()
}

/// A point from below, in units of 2^-shift.
fn units(numerators: &[Integer; 2], denominator: &Integer, shift: u32) -> Option<[i64; 2]> {
    let unit = Integer::power_of_two(shift.into());
    let units = numerators.each_ref().map(|own| (own * &unit).div_rem_floor(denominator).0.to_i64());
    let [Some(x), Some(y)] = units else { return None };
    Some([x, y])
}

impl Near {
    /// Returns the point with as many bits as there is room for.
    fn new(numerators: &[Integer; 2], denominator: &Integer) -> Option<Self> {
        let shift = room(numerators, denominator)?;
        Some(Near { units: units(numerators, denominator, shift)?, shift })
    }

    /// Returns whether a·p < b for sure: where a·θ < b holds with a unit's worth of each coordinate to spare. Few integers are so long
    /// that it cannot be told.
    fn is_surely_within(&self, HalfPlane { a: [a1, a2], b, .. }: &HalfPlane) -> bool {
        let (Some(a1), Some(a2), Some(b)) = (a1.to_i64(), a2.to_i64(), b.to_i64()) else { return false };
        let [a1, a2, b, x, y] = [a1, a2, b, self.units[0], self.units[1]].map(i128::from);
        // |a| is below 2^63 and |x| not above 2^61: nothing overflows.
        a1 * x + a2 * y + a1.abs() + a2.abs() < b << self.shift
    }
}

impl Point {
    pub(crate) fn new([x, y]: &Vector) -> Self {
        let (numerators, denominator) = Rational::over_common_denominator([x, y]);
        let near = Near::new(&numerators, &denominator);
        Point { numerators, denominator, near }
    }

    /// The largest shift for which the point's [units](Point::units) are small.
    pub(crate) fn room(&self) -> Option<u32> {
        room(&self.numerators, &self.denominator)
    }

    /// The point from below: each coordinate is at least this many units of 2^-shift, and less than one more. With no larger shift
    /// than there is [room](Point::room) for, they are at most 2^61 in size.
    pub(crate) fn units(&self, shift: u32) -> Option<[i64; 2]> {
        units(&self.numerators, &self.denominator, shift)
    }

    /// Compares u·self with u·other.
    pub(crate) fn compare_along(&self, u: &[Integer; 2], other: &Point) -> Ordering {
        let along = |point: &Point| &u[0] * &point.numerators[0] + &u[1] * &point.numerators[1];
        (along(self) * &other.denominator).cmp(&(along(other) * &self.denominator))
    }
}
