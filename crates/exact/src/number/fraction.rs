//! Fractions that are not in lowest terms.

use std::cmp::Ordering;

use super::{Integer, Rational, Sign};

/// A number as numerator over a positive denominator, not in lowest terms. Numbers that are made to be compared use
/// it, since a greatest common divisor for each would cost more than all comparisons. It equals what has the same
/// value.
#[derive(Debug, Clone)]
pub struct Fraction {
    numerator: Integer,
    denominator: Integer,
}

impl Fraction {
    /// `numerator / denominator`, or `None` when the denominator is 0. Exact.
    #[inline]
    pub fn new(numerator: Integer, denominator: Integer) -> Option<Self> {
        match denominator.sign() {
            Sign::Zero => None,
            Sign::Positive => Some(Fraction { numerator, denominator }),
            Sign::Negative => Some(Fraction { numerator: -numerator, denominator: -denominator }),
        }
    }

    /// The numerator, which carries the sign.
    #[inline]
    pub fn numerator(&self) -> &Integer {
        &self.numerator
    }

    /// The denominator, always positive.
    #[inline]
    pub fn denominator(&self) -> &Integer {
        &self.denominator
    }

    /// Numerator and denominator.
    #[inline]
    pub fn into_terms(self) -> (Integer, Integer) {
        (self.numerator, self.denominator)
    }
}

/// Compares by value. Exact; two products.
impl Ord for Fraction {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        Integer::compare([(&self.numerator, &other.denominator)], [(&other.numerator, &self.denominator)])
    }
}

impl PartialOrd for Fraction {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Fraction {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Fraction {}

impl From<Integer> for Fraction {
    fn from(value: Integer) -> Self {
        Fraction { numerator: value, denominator: Integer::one() }
    }
}

/// Reduces to lowest terms. Exact.
impl From<Fraction> for Rational {
    fn from(Fraction { numerator, denominator }: Fraction) -> Self {
        // The denominator is not 0.
        Rational::new(numerator, denominator).unwrap_or_default()
    }
}

/// Keeps the value. Exact.
impl From<&Rational> for Fraction {
    fn from(value: &Rational) -> Self {
        Fraction { numerator: value.numerator(), denominator: value.denominator() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_compare_by_value() {
        let fraction =
            |numerator: i64, denominator: i64| Fraction::new(numerator.into(), denominator.into()).unwrap();
        assert!(Fraction::new(Integer::one(), Integer::zero()).is_none());
        assert_eq!(fraction(2, -4), fraction(-1, 2));
        assert_eq!(fraction(4, 2), Fraction::from(Integer::from(2)));
        assert!(fraction(-1, 2) < fraction(1, -3) && fraction(2, 6) < fraction(1, 2));
        assert!(!fraction(-6, 4).denominator().is_negative() && fraction(6, -4).numerator().is_negative());
        assert_eq!(Rational::from(fraction(6, -4)), Rational::ratio(-3, 2));
        assert_eq!(Fraction::from(&Rational::ratio(-3, 2)), fraction(6, -4));
    }
}
