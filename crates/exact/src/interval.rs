//! Closed intervals of rational numbers whose ends may be unbounded.

use std::fmt;

use crate::Rational;

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

    /// Whether the number lies in the interval, ends included.
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

    /// How many significant digits the ends are to be shown with: `usual`, unless one unit of the last of these is wider
    /// than the interval; then one digit beyond the first that differs. Beyond 40 digits a reader is better served by the
    /// exact fractions, and it is `usual` again.
    pub fn resolving_digits(&self, usual: usize) -> usize {
        const MOST: usize = 40;
        let Some((lower, upper)) = self.ends() else { return usual };
        let magnitude = upper.abs().max(lower.abs()).decimal_exponent();
        let Some((magnitude, width)) = magnitude.zip((upper - lower).decimal_exponent()) else {
            return usual;
        };
        let first_that_differs = usize::try_from(magnitude - width + 1).unwrap_or(0);
        let resolves = first_that_differs > usual && first_that_differs < MOST;
        if resolves { first_that_differs + 1 } else { usual }
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
    fn narrow_intervals_are_shown_to_one_digit_beyond_the_first_that_differs() {
        let digits = |lower: i64, exponent: u32| {
            let unit = Rational::scientific(1, -i64::from(exponent));
            let start = Rational::from(lower);
            Interval::new(Endpoint::Finite(start.clone()), Endpoint::Finite(start + unit))
                .unwrap()
                .resolving_digits(5)
        };
        // One unit of the fifth digit is as wide as the interval.
        assert_eq!([0, 3, 4, 5, 6].map(|exponent| digits(1, exponent)), [5, 5, 5, 7, 8]);
        assert_eq!([2, 3, 4].map(|exponent| digits(-70, exponent)), [5, 5, 7]);
        assert_eq!([38, 39, 60].map(|exponent| digits(1, exponent)), [40, 5, 5]);
        let point = |at: i64| interval(Some(at), Some(at)).unwrap();
        assert_eq!([0, 1].map(|at| point(at).resolving_digits(5)), [5, 5]);
        assert_eq!(interval(Some(1), None).unwrap().resolving_digits(5), 5);
    }
}
