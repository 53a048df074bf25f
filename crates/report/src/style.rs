//! How numbers are shown.

use std::fmt;

use boundfit_exact::{Decimal, Interval, Rational, Rounding};

use crate::document::{Inline, Symbol, Text};
use crate::number::Number;

/// The longest fraction that text reports show without being asked for exact numbers.
const LONGEST_FRACTION: usize = 80;

/// Significant digits up to which a given number is shown in full.
const GIVEN_DIGITS: usize = 20;

/// In which direction the ends of intervals and the error bounds are rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum EndRounding {
    /// Away from the inside: the printed interval contains the exact one.
    #[default]
    Outward,
    /// To the nearest decimal, as papers print them: the printed interval may be too narrow by half a unit of its last
    /// digit.
    Nearest,
}

impl EndRounding {
    /// Both of them.
    pub const ALL: [EndRounding; 2] = [EndRounding::Outward, EndRounding::Nearest];

    /// The name on the command line: `outward` or `nearest`.
    pub fn name(self) -> &'static str {
        match self {
            EndRounding::Outward => "outward",
            EndRounding::Nearest => "nearest",
        }
    }
}

/// How numbers are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// Significant digits of decimals.
    pub digits: usize,
    /// How ends of intervals and error bounds are rounded.
    pub ends: EndRounding,
    /// Whether text shows exact fractions in place of decimals.
    pub exact: bool,
}

impl Default for Style {
    /// Five digits, ends outward, decimals.
    fn default() -> Self {
        Style { digits: 5, ends: EndRounding::Outward, exact: false }
    }
}

/// A number in the form that text shows.
pub(crate) enum Shown<'a> {
    Exact(&'a Rational),
    Rounded(Decimal<'a>),
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Shown::Exact(value) => value.fmt(f),
            Shown::Rounded(decimal) => decimal.fmt(f),
        }
    }
}

impl Style {
    /// Both forms of a number that is neither an end of an interval nor an error bound.
    pub fn number(&self, value: &Rational) -> Number {
        Number::rounded(value, self.digits, Rounding::Nearest)
    }

    /// Both forms of a lower end.
    pub fn lower_number(&self, value: &Rational) -> Number {
        Number::rounded(value, self.digits, self.directed(Rounding::Down))
    }

    /// Both forms of an upper end or an error bound.
    pub fn upper_number(&self, value: &Rational) -> Number {
        Number::rounded(value, self.digits, self.directed(Rounding::Up))
    }

    /// Both forms of a given number: its decimal in full where that is exact.
    pub fn given_number(&self, value: &Rational) -> Number {
        let digits = if value.exact_decimal(GIVEN_DIGITS).is_some() { GIVEN_DIGITS } else { self.digits };
        Number::rounded(value, digits, Rounding::Nearest)
    }

    pub(crate) fn numbers(&self, values: &[Rational; 2]) -> [Number; 2] {
        values.each_ref().map(|value| self.number(value))
    }

    /// This style with as many more digits as it takes to tell the ends of an interval apart: when one unit of the last
    /// digit is wider than the interval, one digit beyond the first that differs.
    pub(crate) fn resolving(&self, interval: &Interval) -> Style {
        Style { digits: interval.resolving_digits(self.digits), ..*self }
    }

    /// One style for each of two parameters, which tell the ends of their ranges apart when these are known.
    pub fn resolving_both(&self, ranges: Option<&[Interval; 2]>) -> [Style; 2] {
        [0, 1].map(|axis| ranges.map_or(*self, |ranges| self.resolving(&ranges[axis])))
    }

    /// A number, to nearest.
    pub(crate) fn nearest<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.shown(value, Rounding::Nearest)
    }

    /// A lower end.
    pub(crate) fn lower<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.shown(value, self.directed(Rounding::Down))
    }

    /// An upper end or an error bound.
    pub(crate) fn upper<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.shown(value, self.directed(Rounding::Up))
    }

    /// A given number in full: its decimal when that is exact, else its fraction.
    pub(crate) fn given(&self, value: &Rational) -> Text {
        let decimal = value.exact_decimal(GIVEN_DIGITS.max(self.digits)).filter(|_| !self.exact);
        decimal.map_or_else(|| self.proof(value), |decimal| Text::new().number(decimal))
    }

    /// A number of a proof: exact, since rounded ones prove nothing, unless too long to read.
    pub(crate) fn proof(&self, value: &Rational) -> Text {
        if self.exact || is_readable(value) {
            Text::new().number(value)
        } else {
            Text::from("about ").number(self.nearest(value))
        }
    }

    /// An error bound with the exact value behind it when the decimal is rounded.
    pub(crate) fn upper_with_exact(&self, value: &Rational) -> Text {
        let upper = Text::new().number(self.upper(value));
        if self.exact || value.exact_decimal(self.digits).is_some() || !is_readable(value) {
            upper
        } else {
            upper.words(" (exactly ").number(value).words(")")
        }
    }

    /// An interval: `[1.5, 2]`, `(-inf, 2]`.
    pub(crate) fn interval(&self, interval: &Interval) -> Text {
        let lower = interval.lower().value().map(|value| Text::new().number(self.lower(value)));
        let upper = interval.upper().value().map(|value| Text::new().number(self.upper(value)));
        range(lower, upper)
    }

    /// A union of intervals; a hyphen when there is none.
    pub(crate) fn union(&self, intervals: &[Interval]) -> Text {
        match intervals {
            [] => "-".into(),
            _ => {
                let or = Inline::Words(" or ".to_owned());
                Text::joined(intervals.iter().map(|interval| self.interval(interval)), &or)
            }
        }
    }

    fn directed(&self, outward: Rounding) -> Rounding {
        match self.ends {
            EndRounding::Outward => outward,
            EndRounding::Nearest => Rounding::Nearest,
        }
    }

    fn shown<'a>(&self, value: &'a Rational, rounding: Rounding) -> Shown<'a> {
        if self.exact { Shown::Exact(value) } else { Shown::Rounded(value.decimal(self.digits, rounding)) }
    }
}

/// Whether a fraction is short enough to be read.
pub(crate) fn is_readable(value: &Rational) -> bool {
    value.to_string().len() <= LONGEST_FRACTION
}

/// An interval with these ends; infinite where there is none.
pub(crate) fn range(lower: Option<Text>, upper: Option<Text>) -> Text {
    let lower = match lower {
        Some(lower) => Text::new().mark("[").then(lower),
        None => Text::new().mark("(").mark("-").symbol(Symbol::Infinity),
    };
    let upper = match upper {
        Some(upper) => upper.mark("]"),
        None => Text::from(Symbol::Infinity).mark(")"),
    };
    lower.mark(", ").then(upper)
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Endpoint;

    use super::*;

    fn interval(lower: Rational, upper: Rational) -> Interval {
        Interval::new(Endpoint::Finite(lower), Endpoint::Finite(upper)).unwrap()
    }

    #[test]
    fn narrow_intervals_get_the_digits_to_tell_their_ends_apart() {
        let style = Style::default();
        let wide = interval(Rational::ratio(21, 11726), Rational::ratio(70, 37871));
        assert_eq!(style.resolving(&wide), style);
        let base = Rational::ratio(17, 10);
        let narrow = interval(base.clone(), &base + Rational::ratio(3, 1_000_000_000));
        assert_eq!(style.resolving(&narrow).interval(&narrow).to_string(), "[1.7, 1.700000003]");
        assert_eq!(style.resolving(&interval(base.clone(), base.clone())), style);
        let hopeless = Rational::new(1.into(), boundfit_exact::Integer::power_of_ten(9_999)).unwrap();
        assert_eq!(style.resolving(&interval(base.clone(), &base + &hopeless)), style);
    }

    #[test]
    fn given_numbers_are_shown_in_full() {
        let style = Style::default();
        assert_eq!(style.given(&Rational::ratio(373_923_265, 1_000_000_000)).to_string(), "0.373923265");
        assert_eq!(style.given(&Rational::ratio(1, 3)).to_string(), "1/3");
        assert_eq!(style.upper_with_exact(&Rational::ratio(1, 3)).to_string(), "0.33334 (exactly 1/3)");
        assert_eq!(style.upper_with_exact(&Rational::ratio(1, 4)).to_string(), "0.25");
    }
}
