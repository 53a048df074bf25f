//! Decimals that end, found by looking at the factors of the denominator.

use crate::{Integer, Rational};

#[allow(
    clippy::indexing_slicing,
    reason = "evaluated by the compiler, which would refuse an index out of range"
)]
const fn powers<const N: usize>(base: u64) -> [u64; N] {
    let mut powers = [1; N];
    let mut exponent = 1;
    while exponent < powers.len() {
        powers[exponent] = powers[exponent - 1] * base;
        exponent += 1;
    }
    powers
}

/// The powers of five below 2⁶⁴.
const POWERS_OF_FIVE: [u64; 28] = powers(5);

/// Returns all digits of a number that is not 0, as an integer, and the power of ten that the first of them weighs.
/// Returns `None` where there are more than so many digits, or where finding them takes longer words.
pub(super) fn digits(value: &Rational, most: usize) -> Option<(u64, i64)> {
    let (numerator, denominator) = value.to_words()?;
    if numerator == 0 {
        return None;
    }
    let twos = denominator.trailing_zeros();
    let mut odd = denominator >> twos;
    let mut fives = 0;
    while odd % 5 == 0 {
        odd /= 5;
        fives += 1;
    }
    if odd != 1 {
        return None;
    }
    // 2ⁱ·5ʲ divides the power of ten with the larger of both exponents, and no lower one.
    let places = twos.max(fives);
    let missing = POWERS_OF_FIVE.get((places - fives) as usize)?.checked_shl(places - twos)?;
    let is_lossless = missing >> (places - twos) == *POWERS_OF_FIVE.get((places - fives) as usize)?;
    let digits = numerator.unsigned_abs().checked_mul(missing).filter(|_| is_lossless)?;
    let count = digits.ilog10() as usize + 1;
    (count <= most).then(|| (digits, count as i64 - 1 - i64::from(places)))
}

/// Returns what [`digits`] does, of a number of any size. Cost: two products of numbers as long as the result.
pub(super) fn long_digits(value: &Rational) -> Option<(String, i64)> {
    let (twos, fives) = value.denominator().powers_of_two_and_five()?;
    let places = twos.max(fives);
    let digits: Integer = value.numerator().abs().times_powers(places - twos, places - fives);
    let digits = digits.to_string();
    let exponent = digits.len() as i64 - 1 - i64::from(places);
    Some((digits, exponent))
}
