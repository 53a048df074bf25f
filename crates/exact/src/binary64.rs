//! The one door between exact numbers and IEEE 754 binary64.

mod decimals;

use std::cmp::Ordering;

use crate::{Fraction, Integer, Rational, Wide};

pub(crate) use decimals::short_double;
pub use decimals::{nearest_double, nearest_long_double, plain_double};

/// Binary exponent of the smallest positive binary64.
pub(crate) const LEAST_EXPONENT: i64 = -1074;
/// Bits of a binary64 significand.
const SIGNIFICAND_BITS: i64 = 53;

/// Significand and exponent of a finite binary64: `significand * 2^exponent`, exactly. They mean nothing for an infinity or NaN.
#[inline]
pub fn significand_and_exponent(value: f64) -> (i64, i32) {
    let bits = value.to_bits();
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let biased = ((bits >> 52) & 0x7ff) as i32;
    let (significand, exponent) =
        if biased == 0 { (fraction, LEAST_EXPONENT as i32) } else { (fraction | (1 << 52), biased - 1075) };
    (if value.is_sign_negative() { -significand } else { significand }, exponent)
}

impl Rational {
    /// The exact value of a finite binary64, or `None` for an infinity or NaN.
    ///
    /// ```
    /// # use boundfit_exact::Rational;
    /// assert_eq!(Rational::from_f64(0.1).unwrap().to_string(), "3602879701896397/36028797018963968");
    /// ```
    pub fn from_f64(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let (significand, exponent) = significand_and_exponent(value);
        Some(Rational::dyadic(significand, exponent))
    }

    /// The nearest binary64, ties to even, as IEEE 754 rounds: overflows to an infinity, underflows to 0.
    /// Correctly rounded in every case.
    pub fn to_f64(&self) -> f64 {
        self.nearest_f64().0
    }

    /// The binary64 of [`Rational::to_f64`] and how it compares with this number. Exact. Cost: one division of machine words for
    /// numbers of up to 63 bits, and for most others.
    pub fn nearest_f64(&self) -> (f64, Ordering) {
        let (numerator, denominator) = self.terms();
        nearest(numerator, denominator)
    }

    /// The largest binary64 that is not above this number; −∞ where every finite one is.
    ///
    /// A double is above the number when it is above this one. Exact.
    pub fn floor_to_f64(&self) -> f64 {
        floor(self.nearest_f64())
    }

    /// The least binary64 that is not below this number; ∞ where every finite one is. Exact.
    pub fn ceil_to_f64(&self) -> f64 {
        ceil(self.nearest_f64())
    }

    /// The least binary64 that is not below this error bound plus the distance of its estimate from [`Rational::to_f64`]. Around that
    /// double it covers what the error bound covers around the estimate. Exact.
    pub fn ceil_to_f64_beside(&self, estimate: &Self) -> f64 {
        let (double, side) = estimate.nearest_f64();
        if side.is_eq() || double.is_infinite() {
            return self.ceil_to_f64();
        }
        if let Some(least) = ceil_beside_by_leading_bits(self, estimate, double) {
            return least;
        }
        let (significand, exponent) = significand_and_exponent(double);
        let power = Integer::power_of_two(exponent.unsigned_abs().into());
        let ((error, below), (own, weight)) = (self.terms(), estimate.terms());
        let (double, one) = (Integer::from(significand), Integer::one());
        let (double, scale) = if exponent < 0 { (double, power) } else { (double * power, one) };
        // Over the product of all three denominators.
        let distance = (double * weight - own * &scale).abs();
        let sum = distance * below + error * weight * &scale;
        ceil(nearest(&sum, &(scale * weight * below)))
    }

    /// The number to within three roundings, several times faster than the nearest where numerator and denominator are words.
    #[inline]
    pub fn near_f64(&self) -> f64 {
        match self.to_words() {
            Some((numerator, denominator)) => numerator as f64 / denominator as f64,
            None => self.to_f64(),
        }
    }

    /// The number that [`Rational::to_f64`] gives, if it is a finite one.
    pub fn to_finite_f64(&self) -> Option<f64> {
        Some(self.to_f64()).filter(|double| double.is_finite())
    }
}

impl Fraction {
    /// The nearest binary64, as [`Rational::to_f64`] rounds, without a greatest common divisor.
    pub fn to_f64(&self) -> f64 {
        nearest(self.numerator(), self.denominator()).0
    }
}

/// The largest double that is not above the number to which this one is the nearest.
fn floor((nearest, side): (f64, Ordering)) -> f64 {
    if side.is_gt() { nearest.next_down() } else { nearest }
}

/// The least double that is not below the number to which this one is the nearest; never -0.0.
fn ceil((nearest, side): (f64, Ordering)) -> f64 {
    if side.is_lt() { nearest.next_up() } else { nearest + 0.0 }
}

/// The nearest double of a quotient with a positive denominator, and how the double compares with the quotient.
fn nearest(numerator: &Integer, denominator: &Integer) -> (f64, Ordering) {
    let (magnitude, side) = nearest_of_words(numerator, denominator)
        .or_else(|| nearest_by_leading_bits(numerator, denominator))
        .unwrap_or_else(|| nearest_magnitude(&numerator.abs(), denominator));
    if numerator.is_negative() { (-magnitude, side.reverse()) } else { (magnitude, side) }
}

/// The nearest double of a quotient of words, without its sign; `None` for 0 and longer numbers.
#[inline]
fn nearest_of_words(numerator: &Integer, denominator: &Integer) -> Option<(f64, Ordering)> {
    let numerator = numerator.to_i64()?.unsigned_abs();
    let denominator = denominator.to_i64()?.unsigned_abs();
    if numerator == 0 {
        return None;
    }
    // The quotient of the shifted ones has 55 or 56 bits. So what is cut off is less than a quarter of a double's last bit.
    let shift = 55 + numerator.leading_zeros() as i32 - denominator.leading_zeros() as i32;
    let (above, below) = (u128::from(numerator), u128::from(denominator));
    let (above, below) = if shift < 0 { (above, below << -shift) } else { (above << shift, below) };
    let quotient = above / below;
    let (quotient, is_exact) = (quotient as u64, quotient * below == above);
    let significand = (quotient | u64::from(!is_exact)) as f64;
    let side = match (significand as u64).cmp(&quotient) {
        Ordering::Equal if !is_exact => Ordering::Less,
        side => side,
    };
    // From 2^-63 to 2^63: this multiplication does not round.
    Some((significand * power_of_two(-i64::from(shift)), side))
}

fn nearest_magnitude(numerator: &Integer, denominator: &Integer) -> (f64, Ordering) {
    if numerator.is_zero() {
        return (0.0, Ordering::Equal);
    }
    // The leading bit of the quotient weighs 2^leading or 2^(leading - 1).
    let leading = numerator.bits() as i64 - denominator.bits() as i64;
    let mut exponent = (leading - SIGNIFICAND_BITS).max(LEAST_EXPONENT);
    let (mut significand, mut side) = rounded_quotient(numerator, denominator, exponent);
    if significand >= 1 << SIGNIFICAND_BITS {
        // One bit too many: round again from the exact quotient, not from the rounded one.
        exponent += 1;
        (significand, side) = rounded_quotient(numerator, denominator, exponent);
    }
    if exponent > 1023 {
        return (f64::INFINITY, Ordering::Greater);
    }
    // Both factors are binary64 numbers and so is their product: this multiplication does not round. A significand of 2^53 at the
    // largest exponent makes an infinity.
    let double = significand as f64 * power_of_two(exponent);
    (double, if double.is_infinite() { Ordering::Greater } else { side })
}

/// The nearest binary64 to a quotient of numbers, without its sign, where their leading bits decide; `None` for 0, for others, and for
/// quotients near the ends of the range.
///
/// The leading 126 and 62 bits say that the numerator is from n to n + 1 and the denominator from d to d + 1. Their quotient is then
/// from n/(d + 1) to (n + 1)/d. Both ends decide if they have one nearest significand on one side of it; a tie is left to others.
fn nearest_by_leading_bits(numerator: &Integer, denominator: &Integer) -> Option<(f64, Ordering)> {
    let ([least, most], dropped) =
        enclosed(leading_bits(numerator, NUMERATOR_BITS)?, leading_bits(denominator, DENOMINATOR_BITS)?);
    let left = (u128::BITS - least.leading_zeros()).checked_sub(SIGNIFICAND_BITS as u32)?;
    let half = 1 << left >> 1;
    let (significand, same) = ((least + half) >> left, (most + half) >> left);
    let rounded = significand << left;
    let is_open =
        significand != same || (least + half) & ((1 << left) - 1) == 0 || (least..=most).contains(&rounded);
    let exponent = dropped + i64::from(left);
    // A significand of 54 bits, 2^53, is among those that may be too large.
    (!is_open && (LEAST_EXPONENT..=970).contains(&exponent))
        .then(|| (significand as f64 * power_of_two(exponent), rounded.cmp(&least)))
}

/// Computes [`Rational::ceil_to_f64_beside`] of an error bound above 0, for an estimate with this nearest double. `None` where leading bits
/// do not decide, and for long numbers.
fn ceil_beside_by_leading_bits(error: &Rational, estimate: &Rational, double: f64) -> Option<f64> {
    const MOST_BITS: u64 = 250;
    let (significand, exponent) = significand_and_exponent(double);
    // The double is an integer on this power of two, and the power a word.
    let shift = u32::try_from(-exponent).ok().filter(|shift| *shift < 127)?;
    let ((bound, below), (own, weight)) = (error.terms(), estimate.terms());
    let is_long = own.bits() + u64::from(shift) > MOST_BITS || weight.bits() + 53 > MOST_BITS;
    if is_long || !error.is_positive() {
        return None;
    }
    let on_double = &Wide::from(i128::from(significand)) * &weight.wide()?;
    let apart = on_double - &own.wide()? * &Wide::from(1_i128 << shift);
    let apart = leading_of(apart.bits().into(), |beyond| apart.leading(beyond as u32), NUMERATOR_BITS)?;
    let ([closest, farthest], place_apart) = enclosed(apart, leading_bits(weight, DENOMINATOR_BITS)?);
    let bound = leading_bits(bound, NUMERATOR_BITS)?;
    let ([least, most], place) = enclosed(bound, leading_bits(below, DENOMINATOR_BITS)?);
    let finer = u32::try_from(place - (place_apart - i64::from(shift))).ok()?;
    let on_place = |distance: u128| distance.checked_shr(finer).unwrap_or_default();
    let (least, most) = (least + on_place(closest), most + on_place(farthest) + 1);
    let left = (u128::BITS - least.leading_zeros()).checked_sub(SIGNIFICAND_BITS as u32)?;
    let [significand, same] = [least, most].map(|sum| (sum + ((1 << left) - 1)) >> left);
    let exponent = place + i64::from(left);
    (significand == same && (LEAST_EXPONENT..=970).contains(&exponent))
        .then(|| significand as f64 * power_of_two(exponent))
}

/// Bits of a numerator and of a denominator that decide nearly always, so that a quotient has at least ten more than a double.
const NUMERATOR_BITS: u32 = 126;
const DENOMINATOR_BITS: u32 = 62;

/// A quotient of numbers that begin with these bits, from below and from above, and the power of two that both count.
fn enclosed((above, dropped): (u128, i64), (below, dropped_below): (u128, i64)) -> ([u128; 2], i64) {
    ([above / (below + 1), (above + 1) / below + 1], dropped - dropped_below)
}

/// Returns the first `bits` bits of a number without its sign, and the number of bits behind them, which is negative where zeros are
/// added. Returns `None` for 0.
fn leading_bits(number: &Integer, bits: u32) -> Option<(u128, i64)> {
    leading_of(number.bits(), |beyond| number.leading(beyond), bits)
}

/// Returns the same as [`leading_bits`] for a number of `length` bits. `without(n)` is the number without its lowest n bits.
fn leading_of(length: u64, without: impl FnOnce(u64) -> Option<u128>, bits: u32) -> Option<(u128, i64)> {
    let dropped = length as i64 - i64::from(bits);
    let leading = without(dropped.max(0) as u64).filter(|leading| *leading > 0)?;
    Some((leading << dropped.min(0).unsigned_abs(), dropped))
}

/// `numerator / (denominator * 2^exponent)` to the nearest integer, ties to even, and how that compares with the quotient; below 2^55 by
/// the choice of the exponent.
fn rounded_quotient(numerator: &Integer, denominator: &Integer, exponent: i64) -> (u64, Ordering) {
    let power = Integer::power_of_two(exponent.unsigned_abs());
    let (scaled_numerator, scaled_denominator) = if exponent >= 0 {
        (numerator.clone(), denominator * &power)
    } else {
        (numerator * &power, denominator.clone())
    };
    let (quotient, remainder) = scaled_numerator.div_rem_floor(&scaled_denominator);
    let odd = !quotient.is_even();
    let twice = &remainder + &remainder;
    let up = twice > scaled_denominator || (twice == scaled_denominator && odd);
    let side = if up { Ordering::Greater } else { Integer::zero().cmp(&remainder) };
    (quotient.to_u64().map_or(u64::MAX, |floor| floor + u64::from(up)), side)
}

/// 2 to a power from -1074 to 1023.
pub(crate) fn power_of_two(exponent: i64) -> f64 {
    if exponent >= -1022 {
        f64::from_bits(((exponent + 1023) as u64) << 52)
    } else {
        f64::from_bits(1 << (exponent - LEAST_EXPONENT))
    }
}

#[cfg(test)]
mod tests;
