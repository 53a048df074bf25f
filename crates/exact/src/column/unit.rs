//! The unit that the integers of a column count.

use crate::powers_of_ten;
use crate::{Integer, Rational};

/// The unit that the integers of a column count. Powers of ten are kept apart from other fractions: numbers on them get into
/// lowest terms without a greatest common divisor, and into each other's units without a division.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unit {
    /// Zeros alone count anything.
    #[default]
    Any,
    /// A power of ten.
    TenTo(i32),
    /// `1/d` for this d, which is positive.
    OneOver(i128),
}

impl Unit {
    /// Returns the unit as a number.
    pub fn value(self) -> Rational {
        self.times(1)
    }

    /// Returns a count of units as a number. Exact. Cost: the size of the power.
    pub fn times(self, count: i128) -> Rational {
        match self {
            Unit::Any => Rational::from(count),
            Unit::OneOver(d) => Rational::new(count.into(), d.into()).unwrap_or_default(),
            Unit::TenTo(exponent) => Rational::scientific(count, exponent),
        }
    }

    /// Returns how many units of another kind make one of these; `None` unless that is an integer of 128 bits.
    #[inline]
    pub fn counted_in(self, finer: Unit) -> Option<i128> {
        match (self, finer) {
            (Unit::Any, _) => Some(1),
            (_, Unit::Any) => None,
            (Unit::TenTo(own), Unit::TenTo(finer)) => power_of_ten(own.checked_sub(finer)?),
            (Unit::TenTo(own @ 0..), Unit::OneOver(d)) => d.checked_mul(power_of_ten(own)?),
            (Unit::TenTo(own), Unit::OneOver(d)) => quotient(d, power_of_ten(own.checked_neg()?)?),
            (Unit::OneOver(own), Unit::TenTo(finer)) => quotient(power_of_ten(finer.checked_neg()?)?, own),
            (Unit::OneOver(own), Unit::OneOver(d)) => quotient(d, own),
        }
    }

    /// The largest unit that both are multiples of, of power of ten if both are; `None` where it takes more than 128 bits.
    pub fn common(self, other: Unit) -> Option<Unit> {
        match (self, other) {
            (Unit::Any, unit) | (unit, Unit::Any) => Some(unit),
            (Unit::TenTo(own), Unit::TenTo(other)) => Some(Unit::TenTo(own.min(other))),
            _ => {
                let (own, other) = (self.denominator()?, other.denominator()?);
                Some(Unit::OneOver(Integer::from(own).lcm(&other.into()).to_i128()?))
            }
        }
    }

    /// Returns the unit as a fraction that may not be in lowest terms.
    pub(crate) fn terms(self) -> (Integer, Integer) {
        match self {
            Unit::Any => (Integer::one(), Integer::one()),
            Unit::TenTo(exponent @ 0..) => (Integer::power_of_ten(exponent.unsigned_abs()), Integer::one()),
            Unit::TenTo(exponent) => (Integer::one(), Integer::power_of_ten(exponent.unsigned_abs())),
            Unit::OneOver(d) => (Integer::one(), Integer::from(d)),
        }
    }

    fn denominator(self) -> Option<i128> {
        match self {
            Unit::Any | Unit::TenTo(0..) => Some(1),
            Unit::TenTo(exponent) => power_of_ten(exponent.checked_neg()?),
            Unit::OneOver(d) => Some(d),
        }
    }
}

/// `10^exponent`, if it is an integer of 128 bits. From a table: rows whose numbers have different numbers of digits ask
/// for it once for each of these.
#[inline]
fn power_of_ten(exponent: i32) -> Option<i128> {
    powers_of_ten::OF_I128.get(usize::try_from(exponent).ok()?).copied()
}

/// `dividend / divisor` for a positive divisor, if it is an integer.
fn quotient(dividend: i128, divisor: i128) -> Option<i128> {
    (dividend.checked_rem(divisor)? == 0).then(|| dividend / divisor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_counted_in_common_ones() {
        let units = [
            Unit::TenTo(0),
            Unit::TenTo(3),
            Unit::TenTo(-2),
            Unit::TenTo(-30),
            Unit::OneOver(1),
            Unit::OneOver(3),
            Unit::OneOver(40),
            Unit::OneOver(1_000),
        ];
        for one in units {
            for other in units {
                let common = one.common(other).unwrap();
                for unit in [one, other] {
                    let count = unit.counted_in(common).unwrap();
                    assert_eq!(common.times(count), unit.value(), "{one:?} and {other:?}");
                }
            }
        }
    }

    #[test]
    fn what_is_no_multiple_is_not_counted() {
        for (coarse, fine) in [
            (Unit::TenTo(-3), Unit::TenTo(-2)),
            (Unit::TenTo(-1), Unit::OneOver(4)),
            (Unit::OneOver(3), Unit::TenTo(-5)),
            (Unit::OneOver(8), Unit::TenTo(-2)),
            (Unit::OneOver(6), Unit::OneOver(15)),
            (Unit::OneOver(1), Unit::TenTo(1)),
            (Unit::TenTo(i32::MIN), Unit::TenTo(i32::MAX)),
            (Unit::TenTo(0), Unit::Any),
        ] {
            assert_eq!(coarse.counted_in(fine), None, "{coarse:?} in {fine:?}");
        }
        let prime = Unit::OneOver(i128::MAX);
        assert_eq!(prime.common(Unit::TenTo(-1)), None);
        assert_eq!((Unit::Any.common(prime), Unit::Any.counted_in(prime)), (Some(prime), Some(1)));
    }

    #[test]
    fn counts_are_exact_at_any_power() {
        assert_eq!(Unit::TenTo(-1).times(-7), Rational::ratio(-7, 10));
        assert_eq!(Unit::TenTo(2).times(3), Rational::from(300));
        assert_eq!(Unit::TenTo(-20).times(10_i128.pow(22)), Rational::from(100));
        assert_eq!(
            Unit::TenTo(-3).times(i128::from(i64::MAX) + 1) * Rational::from(1000),
            Rational::from(1_i128 << 63)
        );
        assert_eq!(Unit::OneOver(6).times(4), Rational::ratio(2, 3));
        assert_eq!(Unit::Any.times(0), Rational::zero());
    }
}
