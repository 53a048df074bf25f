//! How numbers are shown.

use std::fmt;

use boundfit_exact::{Decimal, Endpoint, Interval, Rational, Rounding};
use serde::ser::{Serialize, SerializeStruct, Serializer};

/// The longest fraction that text reports show without being asked for exact numbers.
const LONGEST_FRACTION: usize = 80;

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
#[derive(Debug, Clone, PartialEq, Eq)]
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

/// A number in JSON: `{"exact": "p/q", "decimal": "1.8194e-3"}`. It becomes text only where it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Number {
    exact: Rational,
    digits: usize,
    rounding: Rounding,
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Number", 2)?;
        fields.serialize_field("exact", &Written(&self.exact))?;
        fields.serialize_field("decimal", &Written(self.exact.decimal(self.digits, self.rounding)))?;
        fields.end()
    }
}

/// Something with a text as a string in JSON, without a `String` between.
struct Written<T>(T);

impl<T: fmt::Display> Serialize for Written<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0)
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
    pub(crate) fn number(&self, value: &Rational) -> Number {
        self.rounded(value, Rounding::Nearest)
    }

    /// Both forms of a lower end.
    pub(crate) fn lower_number(&self, value: &Rational) -> Number {
        self.rounded(value, self.directed(Rounding::Down))
    }

    /// Both forms of an upper end or an error bound.
    pub(crate) fn upper_number(&self, value: &Rational) -> Number {
        self.rounded(value, self.directed(Rounding::Up))
    }

    /// A given number as text, in full: its decimal when that is exact, else its fraction.
    pub(crate) fn given_text(&self, value: &Rational) -> String {
        const MOST: usize = 20;
        value
            .exact_decimal(MOST.max(self.digits))
            .filter(|_| !self.exact)
            .unwrap_or_else(|| self.proof_text(value))
    }

    /// A multiplier of a proof as text: exact, since rounded ones prove nothing, unless too long to read.
    pub(crate) fn proof_text(&self, value: &Rational) -> String {
        let exact = value.to_string();
        if exact.len() <= LONGEST_FRACTION || self.exact {
            exact
        } else {
            format!("about {}", self.text(value))
        }
    }

    /// An error bound as text, with the exact value behind it when the decimal is rounded.
    pub(crate) fn upper_text_with_exact(&self, value: &Rational) -> String {
        match value.exact_decimal(self.digits) {
            _ if self.exact => value.to_string(),
            Some(decimal) => decimal,
            None if value.to_string().len() > LONGEST_FRACTION => self.upper_text(value),
            None => format!("{} (exactly {value})", self.upper_text(value)),
        }
    }

    /// This style with as many more digits as it takes to tell the ends of an interval apart: when one unit of the last
    /// digit is wider than the interval, one digit beyond the first that differs.
    pub(crate) fn resolving(&self, interval: &Interval) -> Style {
        Style { digits: interval.resolving_digits(self.digits), ..self.clone() }
    }

    /// One style for each of two parameters, resolving their ranges when these are known.
    pub(crate) fn resolving_both(&self, ranges: Option<&[Interval; 2]>) -> [Style; 2] {
        [0, 1].map(|axis| ranges.map_or_else(|| self.clone(), |ranges| self.resolving(&ranges[axis])))
    }

    /// A number as text.
    pub(crate) fn text(&self, value: &Rational) -> String {
        self.shown(value).to_string()
    }

    /// A lower end as text.
    pub(crate) fn lower_text(&self, value: &Rational) -> String {
        self.lower_shown(value).to_string()
    }

    /// An upper end or an error bound as text.
    pub(crate) fn upper_text(&self, value: &Rational) -> String {
        self.upper_shown(value).to_string()
    }

    /// A number as text, for writing.
    pub(crate) fn shown<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.chosen(value, Rounding::Nearest)
    }

    /// A lower end as text, for writing.
    pub(crate) fn lower_shown<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.chosen(value, self.directed(Rounding::Down))
    }

    /// An upper end or an error bound as text, for writing.
    pub(crate) fn upper_shown<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.chosen(value, self.directed(Rounding::Up))
    }

    /// An interval as text: `[1.5, 2]`, `(-inf, 2]`.
    pub(crate) fn interval_text(&self, interval: &Interval) -> String {
        let lower = match interval.lower() {
            Endpoint::Finite(value) => format!("[{}", self.lower_text(value)),
            Endpoint::Unbounded => "(-inf".to_owned(),
        };
        let upper = match interval.upper() {
            Endpoint::Finite(value) => format!("{}]", self.upper_text(value)),
            Endpoint::Unbounded => "inf)".to_owned(),
        };
        format!("{lower}, {upper}")
    }

    /// A union of intervals as text.
    pub(crate) fn union_text(&self, intervals: &[Interval]) -> String {
        let intervals: Vec<String> = intervals.iter().map(|interval| self.interval_text(interval)).collect();
        if intervals.is_empty() { "-".to_owned() } else { intervals.join(" or ") }
    }

    fn directed(&self, outward: Rounding) -> Rounding {
        match self.ends {
            EndRounding::Outward => outward,
            EndRounding::Nearest => Rounding::Nearest,
        }
    }

    fn rounded(&self, value: &Rational, rounding: Rounding) -> Number {
        Number { exact: value.clone(), digits: self.digits, rounding }
    }

    fn chosen<'a>(&self, value: &'a Rational, rounding: Rounding) -> Shown<'a> {
        if self.exact { Shown::Exact(value) } else { Shown::Rounded(value.decimal(self.digits, rounding)) }
    }
}

#[cfg(test)]
mod tests {
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
        assert_eq!(style.resolving(&narrow).interval_text(&narrow), "[1.7, 1.700000003]");
        assert_eq!(style.resolving(&interval(base.clone(), base.clone())), style);
        let hopeless = Rational::new(1.into(), boundfit_exact::Integer::power_of_ten(9_999)).unwrap();
        assert_eq!(style.resolving(&interval(base.clone(), &base + &hopeless)), style);
    }

    #[test]
    fn given_numbers_are_shown_in_full() {
        let style = Style::default();
        assert_eq!(style.given_text(&Rational::ratio(373_923_265, 1_000_000_000)), "0.373923265");
        assert_eq!(style.given_text(&Rational::ratio(1, 3)), "1/3");
        assert_eq!(style.upper_text_with_exact(&Rational::ratio(1, 3)), "0.33334 (exactly 1/3)");
        assert_eq!(style.upper_text_with_exact(&Rational::ratio(1, 4)), "0.25");
    }
}
