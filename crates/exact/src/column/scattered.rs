//! Short decimals of all sizes.

use super::long::Long;
use super::unit::Unit;
use crate::long_decimal::{WORD_DIGITS, power_of_ten};
use crate::{Integer, Rational};

/// The largest exponent without its sign, so that sums of two and numbers of digits are far from any limit.
const MOST_EXPONENT: u32 = 1 << 20;
/// The digits by which numbers of the same size are compared: as many as a mantissa has at most.
const DIGITS: i64 = WORD_DIGITS as i64;

/// Decimals `mantissa · 10^exponent` with an exponent each. They differ so much in size that no words on a common unit hold
/// them, but each has few digits.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Scattered {
    /// No mantissa but 0 ends with a zero, and 0 has the exponent 0, so that equal numbers are equal pairs.
    numbers: Vec<(i64, i32)>,
}

impl Scattered {
    /// The numbers of a column that outgrew its words; `None` if one of them has too many digits.
    pub(super) fn of_long(long: &Long) -> Option<Self> {
        let Unit::TenTo(least) = long.unit() else { return None };
        let mut column = Scattered::default();
        for words in long.numbers() {
            let (count, place) = Long::short_count(words)?;
            column.push(count, Unit::TenTo(least.checked_add(place)?))?;
        }
        Some(column)
    }

    /// Mantissa and exponent of each number; no mantissa but 0 ends with a zero.
    #[inline]
    pub fn numbers(&self) -> &[(i64, i32)] {
        &self.numbers
    }

    #[allow(clippy::indexing_slicing, reason = "who asks counts the rows of the same column")]
    pub(super) fn part(&self, range: std::ops::Range<usize>) -> Self {
        Scattered { numbers: self.numbers[range].to_vec() }
    }

    #[allow(clippy::indexing_slicing, reason = "who asks counts the rows of the same column")]
    pub(super) fn at(&self, places: impl Iterator<Item = usize>) -> Self {
        Scattered { numbers: places.map(|place| self.numbers[place]).collect() }
    }

    pub(super) fn numbers_mut(&mut self) -> &mut Vec<(i64, i32)> {
        &mut self.numbers
    }

    /// A number. Exact.
    pub(super) fn number((mantissa, exponent): (i64, i32)) -> Rational {
        Rational::scientific(mantissa, exponent)
    }

    /// Adds the number `count` times `unit`. Returns `None` if it is no short decimal.
    pub(super) fn push(&mut self, mut count: i128, unit: Unit) -> Option<()> {
        let mut exponent = match unit {
            _ if count == 0 => 0,
            Unit::TenTo(exponent) => exponent,
            Unit::Any | Unit::OneOver(1) => 0,
            Unit::OneOver(_) => return None,
        };
        if exponent.unsigned_abs() > MOST_EXPONENT {
            return None;
        }
        while count > i64::MAX.into() || count < i64::MIN.into() {
            if count % 10 != 0 {
                return None;
            }
            (count, exponent) = (count / 10, exponent + 1);
        }
        let mut mantissa = count as i64;
        while mantissa != 0 && mantissa % 10 == 0 {
            (mantissa, exponent) = (mantissa / 10, exponent + 1);
        }
        // So that each has a negative.
        if mantissa == i64::MIN {
            return None;
        }
        self.numbers.push((mantissa, exponent));
        Some(())
    }

    /// The numbers above a threshold. Exact. Cost: some nanoseconds each.
    pub fn above(&self, threshold: &Rational) -> impl Iterator<Item = (i64, i32)> {
        let floor = floor_of(threshold);
        self.numbers.iter().copied().filter(move |&(mantissa, exponent)| place(mantissa, exponent) > floor)
    }

    /// Each number within 2^-50 of it, relatively; `None` where binary64 has no such numbers.
    pub(super) fn rounded(&self) -> Option<Vec<f64>> {
        self.numbers.iter().map(|&(mantissa, exponent)| rounded(mantissa, exponent)).collect()
    }
}

/// A number's place in the order of all: with its sign, the exponent of its first digit and the digits from there on.
#[inline]
fn place(mantissa: i64, exponent: i32) -> i128 {
    let magnitude = mantissa.unsigned_abs();
    let Some(last) = magnitude.checked_ilog10() else { return 0 };
    // Below 10^19.
    let digits = magnitude.wrapping_mul(power_of_ten(WORD_DIGITS - 1 - last as usize));
    placed(mantissa < 0, i64::from(exponent) + i64::from(last), digits)
}

fn placed(is_negative: bool, first: i64, digits: u64) -> i128 {
    let place = (i128::from(first) + (1 << 62)) << 64 | i128::from(digits);
    if is_negative { -place } else { place }
}

/// The place of the largest number that is not above a threshold and has no more digits than a mantissa.
fn floor_of(threshold: &Rational) -> i128 {
    if threshold.is_zero() {
        return 0;
    }
    let (above, below) = (threshold.numerator().abs(), threshold.denominator());
    // The exponent of the first digit, or less: a bit is 0.30102 to 0.30103 digits.
    let bits = above.bits() as i64 - below.bits() as i64 - 1;
    let mut first = (bits * if bits < 0 { 30_103 } else { 30_102 }).div_euclid(100_000);
    loop {
        let power = |exponent: i64| Integer::power_of_ten(u32::try_from(exponent).unwrap_or(0));
        let finer = DIGITS - 1 - first;
        let (digits, rest) = (&above * power(finer)).div_rem_floor(&(&below * power(-finer)));
        let is_whole = rest.is_zero();
        match digits.to_i128() {
            Some(digits) if digits < i128::from(TOO_MANY) => {
                let magnitude = digits as u64 + u64::from(threshold.is_negative() && !is_whole);
                // A carry may make one digit more.
                return match magnitude {
                    TOO_MANY => placed(true, first + 1, TOO_MANY / 10),
                    _ => placed(threshold.is_negative(), first, magnitude),
                };
            }
            _ => first += 1,
        }
    }
}

/// The least number of more digits than a mantissa has.
const TOO_MANY: u64 = 10_u64.pow(WORD_DIGITS as u32);

/// The number within 2^-50, relatively: six roundings at most.
#[inline]
fn rounded(mantissa: i64, mut exponent: i32) -> Option<f64> {
    /// Every sixteenth power of ten.
    const POWERS: [f64; 39] = [
        1e-304, 1e-288, 1e-272, 1e-256, 1e-240, 1e-224, 1e-208, 1e-192, 1e-176, 1e-160, 1e-144, 1e-128,
        1e-112, 1e-96, 1e-80, 1e-64, 1e-48, 1e-32, 1e-16, 1e0, 1e16, 1e32, 1e48, 1e64, 1e80, 1e96, 1e112,
        1e128, 1e144, 1e160, 1e176, 1e192, 1e208, 1e224, 1e240, 1e256, 1e272, 1e288, 1e304,
    ];
    const LEAST: i32 = -304;
    let mut number = mantissa as f64;
    // After two steps only numbers below the normal ones are still too small.
    for _ in 0..2 {
        if exponent < LEAST {
            (number, exponent) = (number / 1e22, exponent + 22);
        }
    }
    let above = usize::try_from(exponent - LEAST).ok()?;
    let rounded = number * power_of_ten(above % 16) as f64 * POWERS.get(above / 16)?;
    (rounded.is_normal() || mantissa == 0).then_some(rounded)
}

#[cfg(test)]
mod tests;
