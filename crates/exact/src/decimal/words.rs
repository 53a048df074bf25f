//! Decimals by words of 128 bits: no big number, no memory, one division, or two where the terms are longer.

use crate::powers_of_ten;
use std::cmp::Ordering;

use super::{Quotient, Rounding, Significand};

/// The most digits of a significand that fits into 64 bits, whatever they are.
pub(super) const MOST_DIGITS: usize = 18;

/// The absolute values of numerator and denominator, when both fit.
fn words((numerator, denominator): Quotient<'_>) -> Option<(u128, u128)> {
    Some((numerator.to_i128()?.unsigned_abs(), denominator.to_i128()?.unsigned_abs()))
}

/// The rounded significand of a number that is not 0; `None` where it takes longer numbers to tell.
pub(super) fn significand(
    terms: Quotient<'_>,
    digits: usize,
    rounding: Rounding,
) -> Option<Significand<u64>> {
    if digits > MOST_DIGITS {
        return None;
    }
    let away_from_zero = rounding.away_from_zero(terms.0.is_negative());
    words(terms)
        .and_then(|(numerator, denominator)| of_terms(numerator, denominator, digits, away_from_zero))
        .or_else(|| bracketed(terms, digits, away_from_zero))
}

/// The rounded significand of a quotient of positive numbers, of at most 18 digits; `None` where it takes longer numbers to tell.
pub(super) fn of_terms(
    numerator: u128,
    denominator: u128,
    digits: usize,
    away_from_zero: Option<bool>,
) -> Option<Significand<u64>> {
    let scaled = scaled(numerator, denominator, digits)?;
    if scaled.remainder == 0 {
        return Some(Significand { digits: scaled.quotient, exponent: scaled.exponent, exact: true });
    }
    let up = away_from_zero.unwrap_or_else(|| {
        let half = scaled.against_half();
        half.is_gt() || (half.is_eq() && !scaled.quotient.is_multiple_of(2))
    });
    Some(scaled.rounded(up, digits))
}

/// Computes [`significand`] from the leading bits of both terms alone.
fn bracketed(
    (numerator, denominator): Quotient<'_>,
    digits: usize,
    away_from_zero: Option<bool>,
) -> Option<Significand<u64>> {
    let beyond = bits_beyond(numerator.bits().max(denominator.bits()), digits);
    of_leading(numerator.leading(beyond)?, denominator.leading(beyond)?, digits, away_from_zero)
}

/// Returns how many of the lowest bits to drop, so that the others leave room for a power of ten of these digits.
pub(super) fn bits_beyond(bits: u64, digits: usize) -> u64 {
    // Four bits hold a digit.
    let room = 4 * (digits as u64 + 2);
    bits.saturating_sub(u64::from(u128::BITS).saturating_sub(room))
}

/// The rounded significand of a quotient of positive numbers that begin with these bits; `None` where that does not tell. The least
/// and the largest number with these bits must have the same digits before the cut, and lie on one side of a half where that
/// matters. Then every number between them has the same digits, too.
pub(super) fn of_leading(
    numerator: u128,
    denominator: u128,
    digits: usize,
    away_from_zero: Option<bool>,
) -> Option<Significand<u64>> {
    // One so much shorter than the other leaves nothing to tell by.
    if numerator == 0 || denominator == 0 {
        return None;
    }
    let least = scaled(numerator, denominator + 1, digits)?;
    let most = scaled(numerator + 1, denominator, digits)?;
    if (least.exponent, least.quotient) != (most.exponent, most.quotient) || least.remainder == 0 {
        return None;
    }
    let up = match away_from_zero {
        Some(up) => up,
        None if least.against_half().is_gt() => true,
        None if most.against_half().is_lt() => false,
        None => return None,
    };
    Some(least.rounded(up, digits))
}

/// `floor(log10 |value|)` of a number that is not 0; `None` where it takes longer numbers.
pub(super) fn exponent(terms: Quotient<'_>) -> Option<i64> {
    let (numerator, denominator) = words(terms)?;
    scaled(numerator, denominator, 1).map(|scaled| scaled.exponent)
}

/// `numerator / denominator / 10^(exponent - digits + 1)` as quotient and remainder.
struct Scaled {
    /// Such that the quotient has the digits asked for.
    exponent: i64,
    quotient: u64,
    remainder: u128,
    divisor: u128,
}

impl Scaled {
    /// Compares what is cut off with half a unit of the last digit.
    fn against_half(&self) -> Ordering {
        // Twice the remainder may have 129 bits.
        self.remainder.cmp(&(self.divisor - self.remainder))
    }

    /// The digits of a number that they do not hold exactly, or the next larger ones.
    #[allow(clippy::indexing_slicing, reason = "there are 39 powers, and 18 digits at most")]
    fn rounded(self, up: bool, digits: usize) -> Significand<u64> {
        let Scaled { exponent, quotient, .. } = self;
        let rounded = quotient + u64::from(up);
        if u128::from(rounded) == powers_of_ten::OF_U128[digits] {
            return Significand { digits: rounded / 10, exponent: exponent + 1, exact: false };
        }
        Significand { digits: rounded, exponent, exact: false }
    }
}

#[allow(clippy::indexing_slicing, reason = "from 1 to 18 digits are asked for, and there are 39 powers")]
fn scaled(numerator: u128, denominator: u128, digits: usize) -> Option<Scaled> {
    let mut exponent = likely_exponent(numerator, denominator);
    for _ in 0..3 {
        let shift = digits as i64 - 1 - exponent;
        let power = *powers_of_ten::OF_U128.get(usize::try_from(shift.unsigned_abs()).ok()?)?;
        let (dividend, divisor) = if shift >= 0 {
            (numerator.checked_mul(power)?, denominator)
        } else {
            (numerator, denominator.checked_mul(power)?)
        };
        let (quotient, remainder) = divided(dividend, divisor);
        if quotient >= powers_of_ten::OF_U128[digits] {
            exponent += 1;
        } else if quotient < powers_of_ten::OF_U128[digits - 1] {
            exponent -= 1;
        } else {
            return Some(Scaled { exponent, quotient: u64::try_from(quotient).ok()?, remainder, divisor });
        }
    }
    None
}

/// Guesses `floor(log10(numerator / denominator))` of positive integers. The quotient and the powers of ten are right to a few units of
/// their last place. The guess is therefore off by one at most, and only next to a power of ten.
fn likely_exponent(numerator: u128, denominator: u128) -> i64 {
    let rounded = |term: u128| u64::try_from(term).map_or_else(|_| term as f64, |term| term as f64);
    let quotient = rounded(numerator) / rounded(denominator);
    // log10(2) is 1233/4096 and less than 10⁻⁵ more.
    let binary = (quotient.to_bits() >> 52) as i64 - 1023;
    let least = (binary * 1233) >> 12;
    let next = usize::try_from(least + 1 - powers_of_ten::LEAST_OF_F64).ok();
    let reaches_next =
        next.and_then(|next| powers_of_ten::OF_F64.get(next)).is_some_and(|next| quotient >= *next);
    least + i64::from(reaches_next)
}

/// A division of 64 bits is several times faster than one of 128.
pub(super) fn divided(dividend: u128, divisor: u128) -> (u128, u128) {
    match (u64::try_from(dividend), u64::try_from(divisor)) {
        (Ok(dividend), Ok(divisor)) => (u128::from(dividend / divisor), u128::from(dividend % divisor)),
        _ => {
            let quotient = dividend / divisor;
            (quotient, dividend - quotient * divisor)
        }
    }
}
