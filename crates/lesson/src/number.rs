//! Numbers as the page shows them.

use boundfit_estimation::Fit;
use boundfit_exact::{Endpoint, Interval, Rational, Rounding};
use serde::Serialize;

/// Significant digits of decimals.
pub(crate) const DIGITS: usize = 5;

/// Significant digits up to which a given number is shown in full.
const GIVEN_DIGITS: usize = 20;

/// A number: `{"exact": "p/q", "decimal": "1.8194e-3"}`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct Number {
    exact: String,
    decimal: String,
}

/// The ends of an interval; `None` where it has none.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct Range {
    lower: Option<Number>,
    upper: Option<Number>,
}

impl Number {
    /// A number that was given: in full where twenty digits will do.
    pub(crate) fn given(value: &Rational) -> Self {
        let full = value.exact_decimal(GIVEN_DIGITS);
        let decimal = full.unwrap_or_else(|| value.to_decimal(DIGITS, Rounding::Nearest));
        Number { exact: value.to_string(), decimal }
    }

    /// Rounded to nearest.
    pub(crate) fn nearest(value: &Rational) -> Self {
        Number::rounded(value, DIGITS, Rounding::Nearest)
    }

    /// An error bound: rounded up.
    pub(crate) fn up(value: &Rational) -> Self {
        Number::rounded(value, DIGITS, Rounding::Up)
    }

    pub(crate) fn rounded(value: &Rational, digits: usize, rounding: Rounding) -> Self {
        Number { exact: value.to_string(), decimal: value.to_decimal(digits, rounding) }
    }
}

/// A number in a sentence: with a minus sign in place of the hyphen.
pub(crate) fn with_minus(number: &str) -> String {
    number.replace('-', "−")
}

/// How many digits each of the two parameters is shown with: enough to tell the ends of its interval apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ParameterDigits([usize; 2]);

impl ParameterDigits {
    pub(crate) fn of(fit: &Fit) -> Self {
        ParameterDigits(
            fit.pui_intervals()
                .map_or([DIGITS; 2], |pui| [0, 1].map(|axis| pui[axis].resolving_digits(DIGITS))),
        )
    }

    /// The digits of one parameter.
    pub(crate) fn of_parameter(self, axis: usize) -> usize {
        self.0[axis]
    }

    /// A point of the parameter plane.
    pub(crate) fn point(self, theta: &[Rational; 2]) -> [Number; 2] {
        [0, 1].map(|axis| Number::rounded(&theta[axis], self.0[axis], Rounding::Nearest))
    }

    /// A range of one parameter, rounded outward.
    pub(crate) fn range(self, axis: usize, interval: &Interval) -> Range {
        let end = |end: &Endpoint, rounding| {
            end.value().map(|value| Number::rounded(value, self.0[axis], rounding))
        };
        Range { lower: end(interval.lower(), Rounding::Down), upper: end(interval.upper(), Rounding::Up) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn given_numbers_are_shown_in_full() {
        assert_eq!(Number::given(&Rational::ratio(123_456_789, 1000)).decimal, "123456.789");
        assert_eq!(Number::given(&Rational::ratio(2, 3)).decimal, "0.66667");
    }

    #[test]
    fn narrow_intervals_get_more_digits() {
        let interval = |lower: Rational, upper: Rational| {
            Interval::new(Endpoint::Finite(lower), Endpoint::Finite(upper)).unwrap()
        };
        let base = Rational::ratio(17, 10);
        let narrow = interval(base.clone(), &base + Rational::ratio(3, 1_000_000_000));
        assert_eq!((narrow).resolving_digits(DIGITS), 11);
        assert_eq!((interval(base.clone(), &base + Rational::one())).resolving_digits(DIGITS), DIGITS);
        assert_eq!((interval(base.clone(), base)).resolving_digits(DIGITS), DIGITS);
    }
}
