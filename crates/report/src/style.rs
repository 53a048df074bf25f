//! The style of numbers.

use std::borrow::Cow;
use std::fmt;

use boundfit_exact::english::counted;
use boundfit_exact::{Decimal, Integer, Interval, Limit, PlacedDecimal, PlusMinus, Rational, Rounding};
use boundfit_geometry::Measure;

use crate::document::{Inline, Symbol, Text};
use crate::number::{Number, Outward, Reader};

/// The longest fraction that text reports show without being asked for exact numbers.
const LONGEST_READABLE: usize = 80;

/// Significant digits up to which a given number is shown in full.
const GIVEN_DIGITS: usize = 20;

/// Significant digits where nothing asks for more.
pub(crate) const USUAL_DIGITS: usize = 5;

/// The direction in which the ends of intervals and the error bounds are rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum EndRounding {
    /// Away from the inside: the printed interval contains the exact one.
    #[default]
    Outward,
    /// The nearest decimal, as papers print it: the printed interval may be too narrow by half a unit of its last
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

/// The style of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// Significant digits of decimals; `None` for five, and as many more as it takes for ranges to be hardly wider than they
    /// are and for vertices to look different.
    pub digits: Option<usize>,
    /// The rounding of the ends of intervals and of error bounds.
    pub ends: EndRounding,
    /// `true` if text shows exact fractions in place of decimals.
    pub exact: bool,
    /// The reader of the numbers in JSON.
    pub reader: Reader,
    /// Decimal digits that the fraction of a sum over all vertices may have; where it takes more, only its decimal is shown.
    pub longest_fraction: usize,
}

/// The digits of the longest fraction of a sum where nothing else is asked for.
pub const LONGEST_FRACTION: usize = 10_000;

impl Default for Style {
    /// Digits that follow the numbers, ends outward, decimals.
    fn default() -> Self {
        Style {
            digits: None,
            ends: EndRounding::Outward,
            exact: false,
            reader: Reader::Program,
            longest_fraction: LONGEST_FRACTION,
        }
    }
}

/// A number in the form that text shows.
pub(crate) enum Shown<'a> {
    Exact(Cow<'a, Rational>),
    Rounded(Decimal<'a>),
    Placed(PlacedDecimal),
}

/// An estimate and its error bound, which enclose together what they enclose exactly.
pub(crate) struct GiveOrTake<'a> {
    pub(crate) centre: Shown<'a>,
    pub(crate) error: Shown<'a>,
}

impl Shown<'_> {
    /// Writes the number, as the [`Display`](fmt::Display) form has it, without a formatter.
    pub(crate) fn write_to(&self, out: &mut impl fmt::Write) -> fmt::Result {
        match self {
            Shown::Exact(value) => value.write_to(out),
            Shown::Rounded(decimal) => decimal.write_to(out),
            Shown::Placed(decimal) => decimal.write_to(out),
        }
    }

    /// Returns the style of files for programs.
    pub(crate) fn compact(self) -> Self {
        match self {
            Shown::Exact(_) => self,
            Shown::Rounded(decimal) => Shown::Rounded(decimal.compact()),
            Shown::Placed(decimal) => Shown::Placed(decimal.compact()),
        }
    }
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Shown::Exact(value) => value.fmt(f),
            Shown::Rounded(decimal) => decimal.fmt(f),
            Shown::Placed(decimal) => decimal.fmt(f),
        }
    }
}

impl Style {
    /// Returns the number of significant digits of decimals by default.
    pub fn significant(&self) -> usize {
        self.digits.unwrap_or(USUAL_DIGITS)
    }

    /// Both forms of a number that is neither an end of an interval nor an error bound.
    pub fn number(&self, value: &Rational) -> Number {
        self.json_number(value, self.significant(), Rounding::Nearest)
    }

    /// Both forms of a lower end.
    pub fn lower_number(&self, value: &Rational) -> Number {
        self.json_number(value, self.significant(), self.directed(Rounding::Down)).outward(Outward::Down)
    }

    /// Both forms of an upper end or an error bound.
    pub fn upper_number(&self, value: &Rational) -> Number {
        self.json_number(value, self.significant(), self.directed(Rounding::Up)).outward(Outward::Up)
    }

    /// Both forms of a given number: its decimal in full where that is exact.
    pub fn given_number(&self, value: &Rational) -> Number {
        let is_exact = value.exact_decimal(GIVEN_DIGITS).is_some();
        let digits = if is_exact { GIVEN_DIGITS } else { self.significant() };
        self.json_number(value, digits, Rounding::Nearest)
    }

    pub(crate) fn numbers(&self, values: &[Rational; 2]) -> [Number; 2] {
        values.each_ref().map(|value| self.number(value))
    }

    /// Both forms of a sum over all vertices, without the fraction where that is too long.
    pub(crate) fn measure_number(&self, measure: &Measure) -> Number {
        let digits = self.significant();
        match measure.exact_within(self.longest_fraction) {
            Some(exact) => self.number(&exact),
            None => {
                let alike = measure.rounding_alike_in_binary64(digits);
                Number::without_fraction(alike, digits, Rounding::Nearest, self.reader)
            }
        }
    }

    /// Both forms of an estimate of both parameters and of its error bounds. As decimals they enclose what they enclose exactly, and
    /// so do the nearest double of the estimate and the outward one of the error bound.
    pub(crate) fn estimate_numbers(
        &self,
        theta: &[Rational; 2],
        errors: &[Rational; 2],
    ) -> ([Number; 2], [Number; 2]) {
        let number = |value: &Rational, decimal: PlacedDecimal| {
            let is_for_person = self.reader == Reader::Person;
            Number::placed(value, if is_for_person { decimal } else { decimal.compact() }, self.reader)
        };
        let [[theta1, error1], [theta2, error2]] = [0, 1].map(|axis| {
            let (theta, error) = (&theta[axis], &errors[axis]);
            let [shown, bound] = match self.ends {
                EndRounding::Nearest => [self.number(theta), self.upper_number(error)],
                EndRounding::Outward => {
                    let PlusMinus { centre, error: bound } =
                        PlusMinus::enclosing(theta, error, self.significant());
                    [number(theta, centre), number(error, bound)]
                }
            };
            [shown, bound.outward(Outward::At(error.ceil_to_f64_beside(theta)))]
        });
        ([theta1, theta2], [error1, error2])
    }

    /// An estimate and its error bound: as printed they enclose what they enclose exactly. Where ends are rounded to nearest they do
    /// not, and the estimate is shown as by `alone`.
    pub(crate) fn give_or_take<'a>(
        &self,
        estimate: &'a Rational,
        error: &'a Rational,
        alone: &Style,
    ) -> GiveOrTake<'a> {
        if self.exact || self.ends == EndRounding::Nearest {
            return GiveOrTake { centre: alone.nearest(estimate), error: self.upper(error) };
        }
        let PlusMinus { centre, error } = PlusMinus::enclosing(estimate, error, self.significant());
        GiveOrTake { centre: Shown::Placed(centre), error: Shown::Placed(error) }
    }

    fn json_number(&self, value: &Rational, digits: usize, rounding: Rounding) -> Number {
        Number::rounded(value, digits, rounding, self.reader)
    }

    /// This style with the digits that an interval takes.
    pub(crate) fn resolving(&self, interval: &Interval) -> Style {
        match self.digits {
            Some(_) => *self,
            None => Style { digits: Some(interval.resolving_digits(USUAL_DIGITS)), ..*self },
        }
    }

    /// This style with so many digits or more, where nobody asked for a number of them.
    pub(crate) fn with_at_least(&self, digits: usize) -> Style {
        match self.digits {
            Some(own) if own >= digits => *self,
            _ => Style { digits: Some(digits.max(self.significant())), ..*self },
        }
    }

    /// One style for each of two parameters, with the digits that their ranges take when these are known.
    pub fn resolving_both(&self, ranges: Option<&[Interval; 2]>) -> [Style; 2] {
        [0, 1].map(|axis| ranges.map_or(*self, |ranges| self.resolving(&ranges[axis])))
    }

    /// A number, to nearest.
    pub(crate) fn nearest<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.shown(value, Rounding::Nearest)
    }

    /// A sum over all vertices, to nearest.
    pub(crate) fn measure(&self, measure: &Measure) -> Text {
        if !self.exact {
            return Text::new().number(self.nearest(&measure.rounding_alike(self.significant())));
        }
        match measure.exact_within(self.longest_fraction) {
            Some(exact) => Text::new().number(exact),
            None => {
                let rounded = measure.rounding_alike(self.significant());
                let decimal = rounded.decimal(self.significant(), Rounding::Nearest);
                let beyond = format!(" ({})", self.too_long());
                Text::from("about ").number(decimal).words(beyond)
            }
        }
    }

    /// A sum over all vertices where people can read its fraction, or asked for it, and `true`; else a number that is rounded
    /// like it.
    pub(crate) fn readable_or_alike(&self, measure: &Measure) -> (Rational, bool) {
        // A readable result may come from terms that have more in common than can be foreseen.
        let enough = 10 * LONGEST_READABLE;
        match measure.exact_within(if self.exact { self.longest_fraction } else { enough }) {
            Some(exact) => {
                let is_whole = self.exact || is_readable(&exact.abs());
                (exact, is_whole)
            }
            None => (measure.rounding_alike(self.significant()), false),
        }
    }

    /// Returns the reason why the fraction of a sum over all vertices is not shown.
    pub(crate) fn too_long(&self) -> String {
        let digits = counted(self.longest_fraction, "digit", "digits");
        format!("the exact fraction takes more than {digits} (the limit '{}')", Limit::Fraction.name())
    }

    /// A lower end.
    pub(crate) fn lower<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.shown(value, self.directed(Rounding::Down))
    }

    /// An upper end or an error bound.
    pub(crate) fn upper<'a>(&self, value: &'a Rational) -> Shown<'a> {
        self.shown(value, self.directed(Rounding::Up))
    }

    /// A given number in full: its decimal when that is exact, the text that it stands for when it is a double, else its
    /// fraction.
    pub(crate) fn given(&self, value: &Rational) -> Text {
        if self.exact {
            return self.proof(value);
        }
        if let Some(decimal) = value.exact_decimal(GIVEN_DIGITS.max(self.significant())) {
            return Text::new().number(decimal);
        }
        let read = value.shortest_of_f64();
        if let Some(decimal) = read.as_ref().and_then(|read| read.exact_decimal(GIVEN_DIGITS)) {
            return Text::new().number(decimal).words(" (as a double)");
        }
        let decimal = value.exact_decimal(LONGEST_READABLE);
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
        if self.is_shown_exactly(value) || !is_readable(value) {
            upper
        } else {
            upper.words(" (exactly ").number(value).words(")")
        }
    }

    /// An interval: `[1.5, 2]`, `(-inf, 2]`. One without width is the number that it is: `exactly 2`, `about 0.33333`.
    pub(crate) fn interval(&self, interval: &Interval) -> Text {
        if let Some((value, _)) = interval.ends().filter(|(lower, upper)| lower == upper) {
            let word = if self.is_shown_exactly(value) { "exactly " } else { "about " };
            return Text::from(word).number(self.nearest(value));
        }
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

    pub(crate) fn is_shown_exactly(&self, value: &Rational) -> bool {
        self.exact || value.exact_decimal(self.significant()).is_some()
    }

    pub(crate) fn directed(&self, outward: Rounding) -> Rounding {
        match self.ends {
            EndRounding::Outward => outward,
            EndRounding::Nearest => Rounding::Nearest,
        }
    }

    pub(crate) fn shown<'a>(&self, value: &'a Rational, rounding: Rounding) -> Shown<'a> {
        if self.exact {
            Shown::Exact(Cow::Borrowed(value))
        } else {
            Shown::Rounded(value.decimal(self.significant(), rounding))
        }
    }

    /// The number `numerator / denominator`, with a positive denominator, as [`Style::shown`] has the number in lowest terms.
    pub(crate) fn quotient<'a>(
        &self,
        numerator: &'a Integer,
        denominator: &'a Integer,
        rounding: Rounding,
    ) -> Shown<'a> {
        if self.exact {
            let value = Rational::new(numerator.clone(), denominator.clone());
            Shown::Exact(Cow::Owned(value.unwrap_or_default()))
        } else {
            Shown::Rounded(Decimal::of_quotient(numerator, denominator, self.significant(), rounding))
        }
    }
}

/// Returns whether a fraction is short enough to be read.
pub(crate) fn is_readable(value: &Rational) -> bool {
    value.to_string().len() <= LONGEST_READABLE
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
    use boundfit_exact::{Endpoint, Limits, Reading};

    use super::*;

    fn interval(lower: Rational, upper: Rational) -> Interval {
        Interval::new(Endpoint::Finite(lower), Endpoint::Finite(upper)).unwrap()
    }

    #[test]
    fn narrow_intervals_get_the_digits_that_they_take() {
        let style = Style::default();
        let shown = |interval: &Interval| style.resolving(interval).interval(interval).to_string();
        let wide = interval(Rational::ratio(21, 11726), Rational::ratio(70, 37871));
        assert_eq!(shown(&wide), "[0.0017908, 0.0018484]");
        let base = Rational::ratio(17, 10);
        let narrow = interval(base.clone(), &base + Rational::ratio(3, 1_000_000_000));
        assert_eq!(shown(&narrow), "[1.7, 1.700000003]");
        let asked = Style { digits: Some(3), ..style };
        assert_eq!(asked.resolving(&narrow).interval(&narrow).to_string(), "[1.7, 1.71]");
        let hopeless = Rational::new(1.into(), boundfit_exact::Integer::power_of_ten(9_999)).unwrap();
        assert_eq!(shown(&interval(base.clone(), &base + &hopeless)), "[1.7, 1.7001]");
    }

    #[test]
    fn an_interval_without_width_is_a_number() {
        let style = Style::default();
        let shown =
            |value: Rational, style: &Style| style.interval(&interval(value.clone(), value)).to_string();
        assert_eq!(shown(Rational::ratio(17, 10), &style), "exactly 1.7");
        assert_eq!(shown(Rational::ratio(-2, 3), &style), "about -0.66667");
        assert_eq!(shown(Rational::ratio(-2, 3), &Style { exact: true, ..style }), "exactly -2/3");
    }

    #[test]
    fn given_numbers_are_shown_in_full() {
        let style = Style::default();
        assert_eq!(style.given(&Rational::ratio(373_923_265, 1_000_000_000)).to_string(), "0.373923265");
        assert_eq!(style.given(&Rational::ratio(1, 3)).to_string(), "1/3");
        for text in ["0.733333333333333333333", "123456789012345678901.5"] {
            let given = Reading::Decimal.read(text, &Limits::default()).unwrap();
            assert_eq!(style.given(&given).to_string(), text);
        }
        for (double, text) in [(0.1, "0.1 (as a double)"), (-2e-7, "-2e-7 (as a double)"), (0.75, "0.75")] {
            assert_eq!(style.given(&Rational::from_f64(double).unwrap()).to_string(), text);
        }
        assert_eq!(style.upper_with_exact(&Rational::ratio(1, 3)).to_string(), "0.33334 (exactly 1/3)");
        assert_eq!(style.upper_with_exact(&Rational::ratio(1, 4)).to_string(), "0.25");
    }
}
