//! An estimate and its error bound as decimals that belong together.

use std::fmt;

use super::enclosing::{Enclosing, Terms};
use super::{LEAST_PLAIN, Parts, Rounding, significand, significand_of, words};
use crate::{Integer, Rational, Wide};

/// The most digits of an estimate that its error bound asks for.
const MOST_DIGITS: usize = 40;

/// The least exponent down to which an error bound has no power of ten, beside an estimate without one.
const LEAST_PLAIN_BESIDE_PLAIN: i64 = -9;

/// An estimate c and its error bound g as decimals c' and g' with the same last place.
///
/// They are rounded so that [c' - g', c' + g'] contains [c - g, c + g].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlusMinus {
    /// The estimate, to nearest.
    pub centre: PlacedDecimal,
    /// The error bound.
    pub error: PlacedDecimal,
}

/// A decimal whose last digit has a given place. [`Display`](fmt::Display) omits the zeros at its end where it is exact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlacedDecimal {
    pub(super) is_negative: bool,
    /// The size of the number in units of the last place.
    pub(super) units: Integer,
    /// The last place, as a power of ten.
    pub(super) place: i64,
    pub(super) is_exact: bool,
    pub(super) least_plain: i64,
}

impl PlusMinus {
    /// Rounds the estimate to the last place of its error bound with so many digits (at least 1), and the error bound up
    /// by as much as covers that.
    ///
    /// Where the estimate would take more than 40 digits, both have fewer places.
    ///
    /// ```
    /// use boundfit_exact::{PlusMinus, Rational};
    /// let (centre, error) = (Rational::ratio(34_761, 10_000), Rational::ratio(1_905, 10_000));
    /// let shown = PlusMinus::enclosing(&centre, &error, 3);
    /// assert_eq!(format!("{} ± {}", shown.centre, shown.error), "3.476 ± 0.191");
    /// ```
    pub fn enclosing(centre: &Rational, error: &Rational, digits: usize) -> Self {
        let digits = digits.max(1);
        PlusMinus::by_leading_bits(centre, error, digits)
            .unwrap_or_else(|| PlusMinus::enclosing_long(centre, error, digits))
    }

    /// [`PlusMinus::enclosing`] of an error above 0; `None` where leading bits do not tell. Cost: three products and six divisions; a
    /// common denominator that is not the least one needs no greatest common divisor.
    fn by_leading_bits(centre: &Rational, error: &Rational, digits: usize) -> Option<Self> {
        if error.is_zero() {
            return None;
        }
        // Not more than 18 digits.
        let rounded = words::significand(error.terms(), digits, Rounding::Up)?;
        let ((own, denominator), (bound, other)) = (centre.terms(), error.terms());
        let factors = [(own, other), (bound, denominator), (denominator, other)];
        let words =
            |(left, right): (&Integer, &Integer)| Some(Wide::product(left.to_i128()?, right.to_i128()?));
        let terms = match factors.map(words) {
            [Some(centre), Some(error), Some(unit)] => Terms::of_wide([centre, error, unit], digits)?,
            _ => {
                let terms = factors.map(|(left, right)| left * right);
                let bits = terms.iter().map(Integer::bits).max()?;
                Terms::new(bits, digits, |beyond| terms.each_ref().map(|term| term.leading(beyond)))?
            }
        };
        let enclosing = terms.enclosing(rounded.exponent, digits)?;
        Some(PlusMinus::of_units(centre.is_negative(), &enclosing))
    }

    /// The decimals of these units.
    pub(super) fn of_units(is_negative: bool, enclosing: &Enclosing) -> Self {
        let Enclosing { centre, error, place, is_exact, is_error_exact } = *enclosing;
        let centre = PlacedDecimal::of_units(is_negative, centre, place, is_exact);
        let mut error = PlacedDecimal::of_units(false, error, place, is_error_exact);
        error.least_plain = centre.least_plain_beside();
        PlusMinus { centre, error }
    }

    /// [`PlusMinus::enclosing`] of numbers of any size.
    pub(super) fn enclosing_long(centre: &Rational, error: &Rational, digits: usize) -> Self {
        let mut place = last_place(centre, error, digits);
        loop {
            let shown = PlusMinus::at(centre, error, place);
            // Covering the rounding may carry into one more digit.
            if error.is_zero() || shown.error.units < Integer::power_of_ten(digits as u32) {
                return shown;
            }
            place += 1;
        }
    }

    /// Returns the estimate and its error bound with this last place.
    fn at(centre: &Rational, error: &Rational, place: i64) -> Self {
        let centre_shown = PlacedDecimal::rounded(centre, place, Rounding::Nearest);
        let covering = error + (centre_shown.value() - centre).abs();
        let mut error = PlacedDecimal::rounded(&covering, place, Rounding::Up);
        error.least_plain = centre_shown.least_plain_beside();
        PlusMinus { centre: centre_shown, error }
    }
}

/// The place of the last of so many digits of the error bound; of an error bound of 0 that of the estimate.
fn last_place(centre: &Rational, error: &Rational, digits: usize) -> i64 {
    let last =
        |value: &Rational, digits: usize| value.decimal_exponent().map(|first| first + 1 - digits as i64);
    let asked = match error.is_zero() {
        true => last(centre, digits).unwrap_or(0),
        false => significand_of(error.terms(), digits, Rounding::Up).exponent + 1 - digits as i64,
    };
    match last(centre, digits.max(MOST_DIGITS)) {
        Some(finest) if finest > asked && centre.exact_decimal(MOST_DIGITS).is_none() => finest,
        _ => asked,
    }
}

impl PlacedDecimal {
    pub(super) fn of_units(is_negative: bool, units: u64, place: i64, is_exact: bool) -> Self {
        PlacedDecimal { is_negative, units: Integer::from(units), place, is_exact, least_plain: LEAST_PLAIN }
    }

    fn rounded(value: &Rational, place: i64, rounding: Rounding) -> Self {
        let away_from_zero = rounding.away_from_zero(value.is_negative());
        let (units, is_exact) = significand(value.terms(), place, 1, away_from_zero);
        PlacedDecimal { is_negative: value.is_negative(), units, place, is_exact, least_plain: LEAST_PLAIN }
    }

    /// The number that the decimal says. Exact.
    pub fn value(&self) -> Rational {
        let size = Rational::scientific(self.units.clone(), self.place);
        if self.is_negative { -size } else { size }
    }

    /// Returns the form of files for programs: below 0.1 with a power of ten.
    #[must_use]
    pub fn compact(self) -> Self {
        PlacedDecimal { least_plain: -1, ..self }
    }

    /// Returns the least exponent down to which an error bound beside it has no power of ten.
    fn least_plain_beside(&self) -> i64 {
        if !self.is_exact && self.is_plain() { LEAST_PLAIN_BESIDE_PLAIN } else { LEAST_PLAIN }
    }

    /// Returns whether a rounded one is written without a power of ten.
    fn is_plain(&self) -> bool {
        if self.place > 0 || self.units.is_zero() {
            return self.place <= 0;
        }
        let first = match self.units.to_u64() {
            Some(units) => i64::from(units.ilog10()),
            None => self.units.to_string().len() as i64 - 1,
        };
        first + self.place >= LEAST_PLAIN
    }

    /// Writes the decimal, as the [`Display`](fmt::Display) form has it, without a formatter.
    ///
    /// # Errors
    /// The first error of what is written to.
    pub fn write_to(&self, out: &mut impl fmt::Write) -> fmt::Result {
        if self.units.is_zero() {
            // Rounded, 0 has as many places as its error bound.
            return match usize::try_from(-self.place) {
                Ok(places @ 1..=MOST_DIGITS) if !self.is_exact => write!(out, "0.{:0<places$}", ""),
                _ => out.write_str("0"),
            };
        }
        let mut write = |digits: &str| {
            let first = digits.len() as i64 - 1 + self.place;
            Parts::new(digits, first, self.is_exact, self.least_plain).write(self.is_negative, out)
        };
        match self.units.to_u64() {
            Some(units) => write(itoa::Buffer::new().format(units)),
            None => write(&self.units.to_string()),
        }
    }
}

impl fmt::Display for PlacedDecimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_to(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Reading};

    fn value(text: &str) -> Rational {
        Reading::Decimal.read(text, &Limits::default()).unwrap()
    }

    #[test]
    fn the_estimate_has_the_places_of_its_error_bound_which_covers_its_rounding() {
        for (centre, error, digits, printed) in [
            ("3.4761", "0.1905", 3, "3.476 ± 0.191"),
            ("1/3", "0.25", 2, "0.33 ± 0.26"),
            ("0.5", "1/3", 3, "0.5 ± 0.334"),
            ("9.996", "0.01", 2, "9.996 ± 0.01"),
            ("29.9999", "0.1", 2, "30.00 ± 0.11"),
            // Covering carries: 0.99 + 0.0033 takes a place less.
            ("1/3", "0.99", 2, "0.3 ± 1.1"),
            ("1/3", "0.99", 1, "0 ± 2"),
            ("-1/3", "0.0123", 2, "-0.333 ± 0.013"),
            ("0.0018195", "2.87436e-5", 5, "0.0018195 ± 2.8744e-5"),
            ("0.00181959573", "2.87436e-5", 5, "0.001819596 ± 0.000028744"),
            ("1/30000", "2.87436e-6", 3, "3.333e-5 ± 2.88e-6"),
            ("123456789", "12345", 2, "1.23457e8 ± 1.3e4"),
            ("1/700", "12", 3, "0.0 ± 12.1"),
            ("1/7", "0", 4, "0.1429 ± 0.0001"),
            ("7", "0", 4, "7 ± 0"),
            ("0", "0", 4, "0 ± 0"),
            ("0", "1/3", 4, "0 ± 0.3334"),
            ("1.7", "1e-9999", 5, "1.7 ± 1e-9999"),
        ] {
            let PlusMinus { centre, error } = PlusMinus::enclosing(&value(centre), &value(error), digits);
            assert_eq!(format!("{centre} ± {error}"), printed);
        }
    }

    #[test]
    fn an_estimate_beside_a_tiny_error_bound_has_no_endless_digits() {
        let shown = PlusMinus::enclosing(&value("1/3"), &value("1e-9999"), 5);
        let threes = "3".repeat(40);
        assert_eq!(shown.centre.to_string(), format!("0.{threes}"));
        assert_eq!(shown.error.to_string(), "1e-40");
    }

    #[test]
    fn what_is_printed_encloses_what_is_exact_and_is_hardly_wider() {
        for numerator in [-1_234_567_i64, -7, 0, 1, 22, 355, 99_999] {
            for denominator in [1_i64, 3, 7, 113, 1024] {
                for exponent in -9..9 {
                    for digits in 1..=12 {
                        let centre = Rational::ratio(numerator, denominator);
                        let error =
                            Rational::scientific(numerator.abs() % 19, exponent) * Rational::ratio(1, 7);
                        let shown = PlusMinus::enclosing(&centre, &error, digits);
                        assert_eq!(shown, PlusMinus::enclosing_long(&centre, &error, digits));
                        let compact = [shown.centre.clone(), shown.error.clone()].map(PlacedDecimal::compact);
                        for [c, g] in [[shown.centre.clone(), shown.error.clone()], compact] {
                            let [c, g] = [c, g].map(|own| value(&own.to_string()));
                            assert_eq!([&c, &g], [&shown.centre.value(), &shown.error.value()]);
                            assert!(&c - &g <= &centre - &error, "{centre} {error} {digits}: {c} {g}");
                            assert!(&c + &g >= &centre + &error, "{centre} {error} {digits}: {c} {g}");
                            let unit = Rational::scientific(1, shown.error.place);
                            assert!(g <= &error + unit.clone() + unit, "{centre} {error} {digits}: {c} {g}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn leading_bits_tell_what_long_numbers_do() {
        let (mut told, mut asked) = (0, 0);
        for numerator in
            ["0", "1", "-1", "123456", "-99999", "100000000000000001", "-1237940039285380274899124231"]
        {
            for denominator in ["1", "3", "8", "7919", "1180591620717411303423", "1e35"] {
                for (above, below) in
                    [("1", "8"), ("40", "3"), ("12345", "7919"), ("1267650600228229401496703205383", "3e34")]
                {
                    for (digits, exponent) in [(1, 0), (5, -2), (5, -20), (9, 4), (18, -1)] {
                        let over = |above, below| value(above).checked_div(&value(below)).unwrap();
                        // Longer than 128 bits together.
                        let centre =
                            over(numerator, denominator) * over("1e27", "1237940039285380274899124223");
                        let error = over(above, below) * Rational::scientific(1, exponent);
                        let expected = PlusMinus::enclosing_long(&centre, &error, digits);
                        assert_eq!(
                            PlusMinus::enclosing(&centre, &error, digits),
                            expected,
                            "{centre} {error}"
                        );
                        told += usize::from(PlusMinus::by_leading_bits(&centre, &error, digits).is_some());
                        asked += 1;
                    }
                }
            }
        }
        assert!(told * 3 > asked, "{told} of {asked}");
    }
}
