//! Decimals of quotients that nobody has reduced: what is only rounded needs no greatest common divisor.

use super::enclosing::Terms;
use super::words::{self, MOST_DIGITS, bits_beyond};
use super::{PlacedDecimal, PlusMinus, Rounding, Significand};
use crate::{Wide, powers_of_ten};

/// A quotient of two integers of up to 255 bits times a power of ten, not in lowest terms. It is only rounded: each answer is that of
/// the [`Rational`](crate::Rational) with the same value, or `None` where it takes longer numbers to tell.
///
/// ```
/// use boundfit_exact::{Rounding, Wide, WideQuotient};
///
/// let value = WideQuotient::new(Wide::from(210), Wide::from(-117_260), 0);
/// assert_eq!(value.decimal(5, Rounding::Down).map(|decimal| decimal.to_string()).as_deref(), Some("-0.0017909"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WideQuotient {
    numerator: Wide,
    /// Positive.
    denominator: Wide,
    exponent: i32,
}

impl WideQuotient {
    /// `numerator / denominator · 10^exponent`; the denominator must not be 0.
    pub fn new(numerator: Wide, denominator: Wide, exponent: i32) -> Self {
        let is_negative = denominator.is_negative();
        let [numerator, denominator] = [numerator, denominator].map(|term| term.negated_if(is_negative));
        WideQuotient { numerator, denominator, exponent }
    }

    /// The decimal with this number of significant digits, as [`Rational::decimal`](crate::Rational::decimal) has it. Cost: a division, or
    /// two.
    pub fn decimal(&self, digits: usize, rounding: Rounding) -> Option<PlacedDecimal> {
        let is_negative = self.numerator.is_negative();
        if self.numerator.is_zero() {
            return Some(PlacedDecimal::of_units(is_negative, 0, 0, true));
        }
        let digits = digits.max(1);
        let [numerator, denominator] = [self.numerator, self.denominator];
        let Significand { digits: units, exponent, exact } =
            significand(numerator, denominator, digits, rounding.away_from_zero(is_negative))?;
        Some(PlacedDecimal::of_units(
            is_negative,
            units,
            exponent + 1 - digits as i64 + i64::from(self.exponent),
            exact,
        ))
    }

    /// The ends of an interval, rounded outward to the digits that it takes, from `digits` on
    /// ([`Interval::resolving_digits`](crate::Interval::resolving_digits)); `None` where these may be more. Cost: that of both decimals.
    pub fn resolved([lower, upper]: &[Self; 2], digits: usize) -> Option<[PlacedDecimal; 2]> {
        let ends = [lower.decimal(digits, Rounding::Down)?, upper.decimal(digits, Rounding::Up)?];
        let places = ends.iter().filter(|end| !end.units.is_zero()).map(|end| end.place);
        let finest = places.min()?;
        // The end and a unit of its last place, on the finer place.
        let on_finest = |end: &PlacedDecimal| {
            let units = i128::from(end.units.to_u64()?);
            if units == 0 {
                return Some((0, 0));
            }
            let unit = i128::from(*powers_of_ten::OF_I64.get(usize::try_from(end.place - finest).ok()?)?);
            let size = units.checked_mul(unit)?;
            Some((if end.is_negative { -size } else { size }, unit))
        };
        let ((first, first_unit), (last, last_unit)) = (on_finest(&ends[0])?, on_finest(&ends[1])?);
        // Rounding added less than both units, so that the interval itself is wider than twenty of them.
        (last - first >= 21 * (first_unit + last_unit)).then_some(ends)
    }

    /// The middle of an interval and half its width, which must not be 0, as [`PlusMinus::enclosing`] has them. Both ends must have the
    /// same exponent, and products of their terms 254 bits at most. Cost: three divisions, or twice as many.
    pub fn middle([lower, upper]: &[Self; 2], digits: usize) -> Option<PlusMinus> {
        let digits = digits.max(1);
        let left = &lower.numerator * &upper.denominator;
        let right = &upper.numerator * &lower.denominator;
        let (centre, error) = (left + right, right - left);
        let denominator = &lower.denominator * &upper.denominator;
        let denominator = denominator + denominator;
        if lower.exponent != upper.exponent || error.is_negative() || error.is_zero() {
            return None;
        }
        let rounded = significand(error, denominator, digits, Some(true))?;
        // Not more than 18 digits, by now.
        let terms = Terms::of_wide([centre, error, denominator], digits)?;
        let mut enclosing = terms.enclosing(rounded.exponent, digits)?;
        enclosing.place += i64::from(lower.exponent);
        Some(PlusMinus::of_units(centre.is_negative(), &enclosing))
    }
}

/// The rounded significand of the absolute value of a quotient that is not 0.
fn significand(
    numerator: Wide,
    denominator: Wide,
    digits: usize,
    away_from_zero: Option<bool>,
) -> Option<Significand<u64>> {
    if digits > MOST_DIGITS {
        return None;
    }
    let beyond = bits_beyond(numerator.bits().max(denominator.bits()).into(), digits) as u32;
    let (numerator, denominator) = (numerator.leading(beyond)?, denominator.leading(beyond)?);
    match beyond {
        0 => words::of_terms(numerator, denominator, digits, away_from_zero),
        _ => words::of_leading(numerator, denominator, digits, away_from_zero),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Endpoint, Interval, Rational};

    /// The integer as a fraction, and as one of 256 bits.
    fn terms() -> impl Iterator<Item = (i128, i128)> {
        let numerators = [
            0,
            1,
            -1,
            5,
            123_456,
            -99_999,
            10_i128.pow(17) + 1,
            -(1 << 90) - 7,
            (1 << 120) + 3,
            10_i128.pow(30),
        ];
        let denominators =
            [1, 3, 8, 125, 7919, 10_i128.pow(12), (1 << 70) - 1, 3 * 10_i128.pow(28), 10_i128.pow(35)];
        numerators.into_iter().flat_map(move |n| denominators.map(|d| (n, d)))
    }

    fn rational(numerator: i128, denominator: i128, exponent: i32) -> Rational {
        Rational::scaled_quotient(numerator.into(), denominator.into(), exponent).unwrap()
    }

    #[test]
    fn decimals_are_those_of_fractions_in_lowest_terms() {
        let mut found = 0;
        for (numerator, denominator) in terms() {
            for common in [1, 6, (1 << 90) + 1] {
                for (digits, exponent) in [(1, 0), (3, -4), (5, 2), (5, -17), (9, 1), (17, -3)] {
                    let wide = [numerator, -denominator].map(|term| Wide::product(term, common));
                    let quotient = WideQuotient::new(wide[0], wide[1], exponent);
                    let value = -rational(numerator, denominator, exponent);
                    for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                        let Some(decimal) = quotient.decimal(digits, rounding) else { continue };
                        found += 1;
                        let expected = value.decimal(digits, rounding);
                        assert_eq!(
                            decimal.to_string(),
                            expected.to_string(),
                            "{value} {digits} {rounding:?}"
                        );
                        assert_eq!(decimal.compact().to_string(), expected.compact().to_string());
                    }
                }
            }
        }
        assert!(found > 3000, "{found}");
    }

    #[test]
    fn intervals_are_those_of_fractions_in_lowest_terms() {
        let (mut resolved, mut middles) = (0, 0);
        for (numerator, denominator) in terms() {
            for (width, common) in [(1, 1), (7, 40), (30_000, 1), (123_457, 3), ((1 << 40) + 1, 1 << 20)] {
                for (digits, exponent) in [(1, 0), (3, -4), (5, 2), (5, -17), (9, 1)] {
                    // The lower one of both ends is on a smaller denominator.
                    let Some(raised) = numerator.checked_mul(1000).map(|lower| lower + width) else {
                        continue;
                    };
                    let bits = [raised, denominator, denominator * 1000]
                        .map(|term| Wide::product(term, common).bits());
                    if bits[0].max(bits[2]) + bits[1] > 250 {
                        continue;
                    }
                    let ends = [
                        WideQuotient::new(Wide::from(numerator), Wide::from(denominator), exponent),
                        WideQuotient::new(
                            Wide::product(raised, common),
                            Wide::product(denominator, 1000 * common),
                            exponent,
                        ),
                    ];
                    let lower = rational(numerator, denominator, exponent);
                    let upper = rational(raised, denominator * 1000, exponent);
                    let interval =
                        Interval::new(Endpoint::Finite(lower.clone()), Endpoint::Finite(upper.clone()))
                            .unwrap();
                    if let Some([first, last]) = WideQuotient::resolved(&ends, digits) {
                        resolved += 1;
                        assert_eq!(interval.resolving_digits(digits), digits);
                        assert_eq!(first.to_string(), lower.to_decimal(digits, Rounding::Down));
                        assert_eq!(last.to_string(), upper.to_decimal(digits, Rounding::Up));
                    }
                    if let Some(PlusMinus { centre, error }) = WideQuotient::middle(&ends, digits) {
                        middles += 1;
                        let half = interval.width().unwrap().half();
                        let centre_of_both = interval.midpoint().unwrap();
                        let expected = PlusMinus::enclosing_long(&centre_of_both, &half, digits);
                        let shown = |own: &PlusMinus| format!("{} ± {}", own.centre, own.error);
                        assert_eq!(
                            shown(&PlusMinus { centre: centre.clone(), error: error.clone() }),
                            shown(&expected)
                        );
                        let compact = [centre, error].map(|own| own.compact().to_string());
                        assert_eq!(
                            compact,
                            [expected.centre, expected.error].map(|own| own.compact().to_string())
                        );
                    }
                }
            }
        }
        assert!(resolved > 500 && middles > 900, "{resolved} {middles}");
    }
}
