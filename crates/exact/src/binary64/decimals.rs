//! The nearest doubles of decimals.

use super::{SIGNIFICAND_BITS, power_of_two};
use crate::plain_decimal;

/// The binary64 nearest to `mantissa · 10^exponent`; `None` where 64 bits of the power of ten do not tell it, and near the ends of
/// the format. Correctly rounded. Cost: some nanoseconds.
#[inline]
pub fn nearest_double(mantissa: i64, exponent: i32) -> Option<f64> {
    short_double(mantissa, exponent).or_else(|| double_by_leading_bits(mantissa.into(), exponent))
}

/// Returns the same for a mantissa of up to 64 bits, sooner for those above 2^53.
#[inline]
pub fn nearest_long_double(mantissa: i128, exponent: i32) -> Option<f64> {
    double_by_leading_bits(mantissa, exponent)
        .or_else(|| short_double(i64::try_from(mantissa).ok()?, exponent))
}

/// The binary64 nearest to `mantissa · 10^exponent`, when that takes one division or multiplication of numbers that
/// binary64 has: up to 2^53 and 10^22. Correctly rounded (Clinger, *How to read floating point numbers accurately*,
/// 1990, section 3).
#[inline]
pub(crate) fn short_double(mantissa: i64, exponent: i32) -> Option<f64> {
    const POWERS: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17,
        1e18, 1e19, 1e20, 1e21, 1e22,
    ];
    let power = *POWERS.get(exponent.unsigned_abs() as usize)?;
    if mantissa.unsigned_abs() > 1 << SIGNIFICAND_BITS {
        return None;
    }
    Some(if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power })
}

/// The same for a mantissa other than 0, when the leading bits of the power of ten decide (after Lemire, *Number parsing at a
/// gigabyte per second*, 2021).
#[inline]
fn double_by_leading_bits(mantissa: i128, exponent: i32) -> Option<f64> {
    let five = *FIVES.get(exponent.wrapping_add(MOST_FIVES as i32) as usize)?;
    let magnitude = u64::try_from(mantissa.unsigned_abs()).ok()?;
    let zeros = magnitude.leading_zeros();
    // The exact product is less than 2^64 above this one: so the number is from `least` to `least + 2` times a power of two.
    let product = u128::from(magnitude.wrapping_shl(zeros)) * u128::from(five);
    let least = (product >> 65) as i64;
    let double = least as f64;
    if double != least.wrapping_add(2) as f64 {
        return None;
    }
    // The first summand is the logarithm of 10^exponent, rounded down. The product does not round.
    let power = ((exponent * 217_706) >> 16) + 2 - zeros as i32;
    let double = double * power_of_two(power.into());
    Some(if mantissa < 0 { -double } else { double })
}

/// The powers of five up to this one have their leading bits in a table: 10^280 times any mantissa is still far from the ends of
/// the format.
const MOST_FIVES: usize = 280;

/// The leading 64 bits of each power of five from 5^-280 on, rounded down.
const FIVES: [u64; 2 * MOST_FIVES + 1] = {
    let mut fives = [1 << 63; 2 * MOST_FIVES + 1];
    let (mut power, mut inverse, mut exponent) = (1_u128 << 127, 1_u128 << 127, 1);
    #[allow(
        clippy::indexing_slicing,
        reason = "evaluated by the compiler, which refuses an index out of range"
    )]
    while exponent <= MOST_FIVES {
        power = (power >> 3) * 5;
        power <<= power.leading_zeros();
        inverse /= 5;
        inverse <<= inverse.leading_zeros();
        // A step drops less than 2^4 of 2^128, so that all of them drop less than 2^14: the leading bits stay the same.
        assert!(power as u64 <= u64::MAX - (1 << 14) && inverse as u64 <= u64::MAX - (1 << 14));
        fives[MOST_FIVES + exponent] = (power >> 64) as u64;
        fives[MOST_FIVES - exponent] = (inverse >> 64) as u64;
        exponent += 1;
    }
    fives
};

/// The binary64 nearest to a text that [`plain_decimal`] reads; `None` for other texts and beyond the largest binary64.
/// Correctly rounded.
pub fn plain_double(text: &[u8]) -> Option<f64> {
    let (mantissa, exponent) = plain_decimal(text)?;
    let parsed = || std::str::from_utf8(text.trim_ascii()).ok()?.parse().ok();
    nearest_double(mantissa, exponent).or_else(parsed).filter(|double: &f64| double.is_finite())
}
