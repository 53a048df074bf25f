//! Closed intervals of rational numbers whose ends may be unbounded.

use std::fmt;

use crate::{Fraction, Integer, Rational, Rounding};

/// Returns the fewest significant digits, from `least` to 40, that are enough. More digits must never be less: a
/// decimal of so many digits is one of more digits too, so rounding to more never adds more. `least` where 40 are not
/// enough. Cost: `is_enough` of 40 digits first, since it takes long divisions of long numbers, and only where these
/// are enough of about five more numbers of digits.
pub fn fewest_digits(least: usize, is_enough: impl Fn(usize) -> bool) -> usize {
    const MOST: usize = 40;
    let most = MOST.max(least);
    if !is_enough(most) {
        return least;
    }
    let fewer: Vec<usize> = (least..most).collect();
    least + fewer.partition_point(|digits| !is_enough(*digits))
}

/// One end of an [`Interval`].
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Endpoint {
    /// The interval ends here, and contains this number.
    Finite(Rational),
    /// The interval has no end on this side.
    Unbounded,
}

impl Endpoint {
    /// The number, when there is one.
    pub fn value(&self) -> Option<&Rational> {
        match self {
            Endpoint::Finite(value) => Some(value),
            Endpoint::Unbounded => None,
        }
    }
}

impl From<Option<Rational>> for Endpoint {
    fn from(value: Option<Rational>) -> Self {
        value.map_or(Endpoint::Unbounded, Endpoint::Finite)
    }
}

/// A non-empty closed interval; either end may be unbounded.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Interval {
    lower: Endpoint,
    upper: Endpoint,
}

/// Closed ends in brackets and missing ones in parentheses: `[1/2, 3]`, `(-inf, 0]`.
impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.lower.value() {
            Some(lower) => write!(f, "[{lower}, ")?,
            None => f.write_str("(-inf, ")?,
        }
        match self.upper.value() {
            Some(upper) => write!(f, "{upper}]"),
            None => f.write_str("inf)"),
        }
    }
}

impl Interval {
    /// The interval between two ends, or `None` when the lower one is above the upper one.
    pub fn new(lower: Endpoint, upper: Endpoint) -> Option<Self> {
        let ordered = match (lower.value(), upper.value()) {
            (Some(lower), Some(upper)) => lower <= upper,
            _ => true,
        };
        ordered.then_some(Interval { lower, upper })
    }

    /// `[centre - radius, centre + radius]`, or `None` for a negative radius.
    pub fn around(centre: &Rational, radius: &Rational) -> Option<Self> {
        Interval::new(Endpoint::Finite(centre - radius), Endpoint::Finite(centre + radius))
    }

    /// The lower end.
    pub fn lower(&self) -> &Endpoint {
        &self.lower
    }

    /// The upper end.
    pub fn upper(&self) -> &Endpoint {
        &self.upper
    }

    /// Both ends, when both are finite.
    pub fn ends(&self) -> Option<(&Rational, &Rational)> {
        Some((self.lower.value()?, self.upper.value()?))
    }

    /// Returns whether the number lies in the interval, ends included.
    pub fn contains(&self, number: &Rational) -> bool {
        self.lower.value().is_none_or(|lower| lower <= number)
            && self.upper.value().is_none_or(|upper| number <= upper)
    }

    /// Upper minus lower end, or `None` when an end is unbounded. Exact.
    pub fn width(&self) -> Option<Rational> {
        self.ends().map(|(lower, upper)| upper - lower)
    }

    /// The centre, or `None` when an end is unbounded. Exact.
    pub fn midpoint(&self) -> Option<Rational> {
        self.ends().map(|(lower, upper)| (lower + upper).half())
    }

    /// Returns the number of significant digits to show the ends with, at least `least`. With these digits the
    /// interval between the ends rounded outward is at most a twentieth wider than this one. The comparison is exact.
    /// Beyond 40 digits a reader is better served by the exact fractions, and it is `least` again; also when there is
    /// no width. Cost: that of [`fewest_digits`], with two roundings for each number of digits.
    pub fn resolving_digits(&self, least: usize) -> usize {
        let Some((lower, upper)) = self.ends().filter(|(lower, upper)| lower != upper) else { return least };
        if self.is_far_wider_than_digits(least) {
            return least;
        }
        // Not in lowest terms: the common divisors of long ends would cost more than all the rest.
        let ([first, last], common) = Rational::over_common_denominator([lower, upper]);
        let most = Fraction::new((last - first) * Integer::from(21), common * Integer::from(20));
        let rounded = |digits: usize| {
            Fraction::from(&(upper.rounded(digits, Rounding::Up) - lower.rounded(digits, Rounding::Down)))
        };
        fewest_digits(least, |digits| most.as_ref().is_some_and(|most| rounded(digits) <= *most))
    }

    /// Returns whether a twentieth of the width is certainly more than rounding the ends outward adds, which is less than a unit of the last
    /// digit of each. Decides on a few more digits of both, rounded inward.
    fn is_far_wider_than_digits(&self, digits: usize) -> bool {
        const MORE: usize = 4;
        // Powers of ten up to here times significands of at most 18 digits stay far below 2^127.
        const MOST_SHIFT: i64 = 18;
        let known = |end: &Endpoint, inward| end.value()?.rounded_in_words(digits + MORE, inward);
        let (Some(lower), Some(upper)) =
            (known(&self.lower, Rounding::Up), known(&self.upper, Rounding::Down))
        else {
            return false;
        };
        // The unit of a zero may be any.
        let finest = match (lower.0, upper.0) {
            (0, _) => upper.1,
            (_, 0) => lower.1,
            _ => lower.1.min(upper.1),
        };
        let on_finest = |(mantissa, exponent): (i64, i64)| match exponent - finest {
            _ if mantissa == 0 => Some((0, 0)),
            shift @ 0..=MOST_SHIFT => {
                let unit = 10_i128.pow(shift as u32);
                Some((i128::from(mantissa) * unit, unit))
            }
            _ => None,
        };
        let (Some((lower, lower_unit)), Some((upper, upper_unit))) = (on_finest(lower), on_finest(upper))
        else {
            return false;
        };
        upper - lower > 20 * 10_i128.pow(MORE as u32) * (lower_unit + upper_unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interval(lower: Option<i64>, upper: Option<i64>) -> Option<Interval> {
        Interval::new(lower.map(Rational::from).into(), upper.map(Rational::from).into())
    }

    #[test]
    fn ends_are_ordered() {
        assert!(interval(Some(2), Some(1)).is_none());
        assert!(interval(Some(1), Some(1)).is_some());
        assert!(interval(Some(2), None).is_some());
        assert!(Interval::around(&Rational::one(), &Rational::from(-1)).is_none());
    }

    #[test]
    fn containment_respects_unbounded_ends() {
        let right = interval(Some(0), None).unwrap();
        let unit = interval(Some(0), Some(1)).unwrap();
        assert!(unit.contains(&Rational::one()) && !unit.contains(&Rational::from(2)));
        assert!(right.contains(&Rational::from(2)) && !right.contains(&Rational::from(-1)));
    }

    #[test]
    fn width_and_midpoint_need_both_ends() {
        assert_eq!(interval(Some(1), Some(4)).unwrap().midpoint(), Some(Rational::ratio(5, 2)));
        assert_eq!(interval(Some(1), Some(4)).unwrap().width(), Some(Rational::from(3)));
        assert_eq!(interval(Some(1), None).unwrap().width(), None);
    }

    #[test]
    fn narrow_intervals_are_shown_a_twentieth_wider_at_most() {
        let digits = |lower: Rational, width: Rational| {
            let upper = &lower + &width;
            Interval::new(Endpoint::Finite(lower), Endpoint::Finite(upper)).unwrap().resolving_digits(5)
        };
        let third = || Rational::ratio(1, 3);
        let unit = |exponent: i64| Rational::scientific(1, -exponent);
        // 1/3 rounded down and 1/3 + w rounded up: of w = 10^-k the next digit but one is the first to add less than w/20.
        assert_eq!([1, 2, 3, 4, 5, 6].map(|k| digits(third(), unit(k))), [5, 5, 5, 6, 7, 8]);
        // An end that the decimals hold is not widened at all.
        assert_eq!([3, 4, 5, 6].map(|k| digits(Rational::one(), unit(k))), [5, 5, 6, 7]);
        assert_eq!([38, 39, 60].map(|k| digits(third(), unit(k))), [40, 5, 5]);
        // Between 1 and 1.00001 exactly a twentieth is enough, and anything more is too much.
        let from = |lower: Rational| {
            let width = Rational::scientific(100_001, -5) - &lower;
            digits(lower, width)
        };
        let lower = Rational::one() + Rational::ratio(1, 2_100_000);
        assert_eq!(from(lower.clone()), 6);
        assert!(from(lower + Rational::scientific(1, -30)) > 6);
        assert_eq!(digits(Rational::zero(), Rational::scientific(123_456_789, -8)), 5);
        let point = |at: i64| interval(Some(at), Some(at)).unwrap();
        assert_eq!([0, 1].map(|at| point(at).resolving_digits(5)), [5, 5]);
        assert_eq!(interval(Some(1), None).unwrap().resolving_digits(5), 5);
    }

    #[test]
    fn printed_intervals_are_hardly_wider_and_digits_are_not_wasted() {
        for numerator in [-1_234_567_i64, -7, 1, 22, 355, 99_999] {
            for denominator in [1_i64, 3, 7, 113, 1024] {
                for exponent in 0..20 {
                    let lower = Rational::ratio(numerator, denominator);
                    let width = Rational::scientific(denominator % 9 + 1, -exponent);
                    let upper = &lower + &width;
                    let ends =
                        Interval::new(Endpoint::Finite(lower.clone()), Endpoint::Finite(upper.clone()));
                    let digits = ends.unwrap().resolving_digits(5);
                    let wider = |digits| {
                        let printed =
                            upper.rounded(digits, Rounding::Up) - lower.rounded(digits, Rounding::Down);
                        printed * Rational::from(20) > &width * Rational::from(21)
                    };
                    assert!(!wider(digits) && (digits == 5 || wider(digits - 1)), "{lower} {width} {digits}");
                }
            }
        }
    }
}
