//! Linear inequalities as given, and the half-planes they stand for.

use std::borrow::Cow;

use boundfit_exact::{Integer, Rational};

use crate::point::Direction;

/// `a1·θ1 + a2·θ2 ≤ b` with the coefficients as given. Multipliers of proofs refer to this form.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Inequality {
    /// The coefficients of θ1 and θ2.
    pub a: [Rational; 2],
    /// The right-hand side.
    pub b: Rational,
}

impl Inequality {
    /// `a1·θ1 + a2·θ2 ≤ b`.
    pub fn new(a1: Rational, a2: Rational, b: Rational) -> Self {
        Inequality { a: [a1, a2], b }
    }

    /// The inequality of a half-plane that has 1 or -1 for `a2`. Exact.
    pub(crate) fn of_line(half_plane: &HalfPlane) -> Self {
        let [a1, a2, b] = &*half_plane.triple();
        let over = |number: &Integer| Rational::new(number.clone(), a2.abs()).unwrap_or_default();
        Inequality { a: [over(a1), over(a2)], b: over(b) }
    }

    /// The half-plane that the inequality describes; a zero normal leaves `0 ≤ b`, which holds always or never.
    pub fn constraint(&self) -> Constraint {
        let [a1, a2] = &self.a;
        let ([p1, p2, q], common) = Rational::over_common_denominator([a1, a2, &self.b]);
        // A prime of the common denominator leaves some scaled number indivisible, and one of them is ± that denominator:
        // no common divisor is to be looked for.
        if p1.abs() == common || p2.abs() == common {
            return Constraint::HalfPlane(HalfPlane::of_coprime(p1, p2, q));
        }
        match HalfPlane::new(p1, p2, q) {
            Some(half_plane) => Constraint::HalfPlane(half_plane),
            None if self.b.is_negative() => Constraint::Never,
            None => Constraint::Always,
        }
    }

    /// `b - a·θ` at a point: negative where the inequality is violated, in the units of `b`.
    pub fn slack(&self, theta: &[Rational; 2]) -> Rational {
        &self.b - &self.a[0] * &theta[0] - &self.a[1] * &theta[1]
    }
}

/// The meaning of an inequality for the plane.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Constraint {
    /// The inequality cuts the plane.
    HalfPlane(HalfPlane),
    /// `0 ≤ b` with `b ≥ 0`: true everywhere.
    Always,
    /// `0 ≤ b` with `b < 0`: true nowhere.
    Never,
}

/// The half-plane `a1·θ1 + a2·θ2 ≤ b` with coprime integers `(a1, a2, b)` and a non-zero normal.
///
/// Equal half-planes have equal triples.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct HalfPlane(Size);

/// The form of a triple: words wherever all three fit, which take less than half of the memory.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Size {
    Words([i64; 3]),
    Long(Box<[Integer; 3]>),
}

impl HalfPlane {
    /// The half-plane of an integer inequality, or `None` for a zero normal.
    pub fn new(a1: Integer, a2: Integer, b: Integer) -> Option<Self> {
        if a1.is_zero() && a2.is_zero() {
            return None;
        }
        let is_unit = a2.to_i64().is_some_and(|a2| a2.unsigned_abs() == 1);
        if is_unit {
            // A reading of a line in integers: no common divisor is to be looked for.
            return Some(HalfPlane::of_coprime(a1, a2, b));
        }
        let divisor = a1.gcd(&a2).gcd(&b);
        let reduced = |value: Integer| value.quotient(&divisor);
        Some(HalfPlane::of_coprime(reduced(a1), reduced(a2), reduced(b)))
    }

    fn of_coprime(a1: Integer, a2: Integer, b: Integer) -> Self {
        HalfPlane(match (a1.to_i64(), a2.to_i64(), b.to_i64()) {
            (Some(a1), Some(a2), Some(b)) => Size::Words([a1, a2, b]),
            _ => Size::Long(Box::new([a1, a2, b])),
        })
    }

    /// First coefficient of the outward normal.
    #[inline]
    pub fn a1(&self) -> Integer {
        self.coefficient(0)
    }

    /// Second coefficient of the outward normal.
    #[inline]
    pub fn a2(&self) -> Integer {
        self.coefficient(1)
    }

    /// The right-hand side.
    #[inline]
    pub fn b(&self) -> Integer {
        self.coefficient(2)
    }

    #[inline]
    fn coefficient(&self, position: usize) -> Integer {
        match &self.0 {
            Size::Words(words) => Integer::from(words[position]),
            Size::Long(triple) => triple[position].clone(),
        }
    }

    /// The triple `(a1, a2, b)`, without copies of long numbers.
    #[inline]
    pub(crate) fn triple(&self) -> Cow<'_, [Integer; 3]> {
        match &self.0 {
            Size::Words([a1, a2, b]) => {
                Cow::Owned([Integer::from(*a1), Integer::from(*a2), Integer::from(*b)])
            }
            Size::Long(triple) => Cow::Borrowed(triple),
        }
    }

    /// The triple, where it is one of machine words.
    #[inline]
    pub(crate) fn words(&self) -> Option<[i64; 3]> {
        match self.0 {
            Size::Words(words) => Some(words),
            Size::Long(_) => None,
        }
    }

    /// The half-plane on the other side of the same line.
    pub fn opposite(&self) -> Self {
        HalfPlane::of_coprime(-self.a1(), -self.a2(), -self.b())
    }

    /// The direction of the outward normal `(a1, a2)`.
    pub fn normal(&self) -> Direction {
        // A half-plane has a non-zero normal by construction.
        Direction::new(self.a1(), self.a2()).expect("half-plane with a zero normal")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inequality(a1: Rational, a2: Rational, b: Rational) -> Constraint {
        Inequality::new(a1, a2, b).constraint()
    }

    #[test]
    fn the_same_half_plane_has_one_form() {
        let half = Rational::ratio(1, 2);
        let third = Rational::ratio(1, 3);
        let left = inequality(half.clone(), third.clone(), Rational::one());
        let right = inequality(Rational::from(30), Rational::from(20), Rational::from(60));
        assert_eq!(left, right);
        assert_ne!(left, inequality(-half, -third, -Rational::one()));
    }

    #[test]
    fn a_zero_normal_is_a_truth_value() {
        let zero = Rational::zero;
        assert_eq!(inequality(zero(), zero(), zero()), Constraint::Always);
        assert_eq!(inequality(zero(), zero(), Rational::ratio(1, 7)), Constraint::Always);
        assert_eq!(inequality(zero(), zero(), Rational::ratio(-1, 7)), Constraint::Never);
    }
}
