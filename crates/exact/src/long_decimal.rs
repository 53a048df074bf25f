//! Decimals of up to 38 digits as integers of 128 bits times powers of ten, read fast.

use crate::plain::{PLAIN_EXPONENT, next_eight_bytes, value_of_digits};
use crate::powers_of_ten;

/// The number of digits that always fit into an `i128`.
pub const LONG_DIGITS: usize = 38;

/// The number at the start of a text: `mantissa · 10^exponent`, written in `length` bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LongPrefix {
    /// All digits, with the sign.
    pub mantissa: i128,
    /// The exponent of the last digit written; 0 for zero.
    pub exponent: i32,
    /// The number of bytes that were read: up to the first that cannot go on.
    pub length: usize,
}

/// Reads the decimal at the start of a text: a sign or none, from 1 to [`LONG_DIGITS`] digits with or without a point, and
/// an exponent within [`PLAIN_EXPONENT`] or none. `None` for all others, which may be numbers all the same. Exact. Cost: some
/// nanoseconds for each eight digits.
#[inline]
pub fn long_prefix(text: &[u8]) -> Option<LongPrefix> {
    let (negative, start) = match text.first()? {
        b'-' => (true, 1),
        b'+' => (false, 1),
        _ => (false, 0),
    };
    let mut digits = Digits::default();
    let whole = digits.read(text, start)?;
    let mut length = start + whole;
    let mut fraction = 0;
    if text.get(length) == Some(&b'.') {
        fraction = digits.read(text, length + 1)?;
        length += 1 + fraction;
    }
    if whole + fraction == 0 {
        return None;
    }
    let (written, more) = match text.get(length) {
        Some(b'e' | b'E') => written_exponent(text.get(length + 1..)?)?,
        _ => (0, 0),
    };
    let magnitude = digits.value()? as i128;
    let mantissa = if negative { magnitude.wrapping_neg() } else { magnitude };
    // Neither has more than a few digits.
    let exponent = if magnitude == 0 { 0 } else { written.wrapping_sub(fraction as i32) };
    Some(LongPrefix { mantissa, exponent, length: length + more })
}

/// Digits read so far: those of the last word or two, and all before them.
#[derive(Default)]
struct Digits {
    before: u128,
    last: u64,
    last_count: usize,
    count: usize,
}

/// The number of digits that always fit into a `u64`.
pub(crate) const WORD_DIGITS: usize = 19;

impl Digits {
    /// Takes the digits from a position on, and tells how many they are; `None` when they become too many.
    #[inline]
    fn read(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let mut read = 0;
        loop {
            let (word, count) = digits_of_word(next_eight_bytes(text, at.wrapping_add(read)));
            if self.last_count + count > WORD_DIGITS {
                self.carry()?;
            }
            self.last_count += count;
            // Below 10^19, by the lines before.
            self.last = self.last.wrapping_mul(power_of_ten(count)).wrapping_add(value_of_digits(word));
            read += count;
            if count < 8 {
                return Some(read);
            }
        }
    }

    /// Makes room for other last digits.
    #[cold]
    fn carry(&mut self) -> Option<()> {
        let count = self.count + self.last_count;
        self.before = self.value().filter(|_| count <= LONG_DIGITS)?;
        (self.last, self.last_count, self.count) = (0, 0, count);
        Some(())
    }

    /// The number that all digits spell; `None` for too many.
    #[inline]
    fn value(&self) -> Option<u128> {
        if self.count == 0 {
            return Some(u128::from(self.last));
        }
        let shifted = self.before.wrapping_mul(u128::from(power_of_ten(self.last_count)));
        // Below 10^38.
        (self.count + self.last_count <= LONG_DIGITS).then_some(shifted.wrapping_add(self.last.into()))
    }
}

/// Returns the digits at the start of eight bytes, up to the first other byte, and their number. The values of the
/// digits stand in the high bytes of a word, the last one highest, with zeros below.
#[inline]
fn digits_of_word(bytes: u64) -> (u64, usize) {
    const LOW_BITS: u64 = 0x7f7f_7f7f_7f7f_7f7f;
    // Digits become 0 to 9; every other byte becomes 10 or more.
    let values = bytes ^ 0x3030_3030_3030_3030;
    // 118 more sets the high bit of what is 10 to 127, and carries into no other byte; from 128 on it is set already.
    let others = (((values & LOW_BITS) + 0x7676_7676_7676_7676) | values) & !LOW_BITS;
    let count = others.trailing_zeros() / 8;
    (values.unbounded_shl(64 - 8 * count), count as usize)
}

/// `10^exponent` for an exponent up to 19.
#[inline]
#[allow(clippy::indexing_slicing, reason = "documented: who asks has counted the digits of a word")]
pub(crate) fn power_of_ten(exponent: usize) -> u64 {
    powers_of_ten::OF_U64[exponent]
}

/// The exponent after the `e`, and how many bytes it takes with that.
#[inline]
pub(crate) fn written_exponent(text: &[u8]) -> Option<(i32, usize)> {
    let (negative, start) = match text.first()? {
        b'-' => (true, 1),
        b'+' => (false, 1),
        _ => (false, 0),
    };
    let (mut magnitude, mut length) = (0_u32, start);
    while let Some(digit @ b'0'..=b'9') = text.get(length) {
        magnitude = magnitude.wrapping_mul(10).wrapping_add(u32::from(digit - b'0'));
        length += 1;
        if magnitude > PLAIN_EXPONENT {
            return None;
        }
    }
    let exponent = if negative { -(magnitude as i32) } else { magnitude as i32 };
    (length > start).then_some((exponent, length + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Rational, Reading};

    fn prefix(text: &str) -> Option<(i128, i32, usize)> {
        long_prefix(text.as_bytes()).map(|prefix| (prefix.mantissa, prefix.exponent, prefix.length))
    }

    #[test]
    fn edges_of_long_decimals() {
        let most = "9".repeat(LONG_DIGITS);
        for (text, expected) in [
            ("0", Some((0, 0, 1))),
            ("-0.000e50,", Some((0, 0, 9))),
            ("1.50\n", Some((150, -2, 4))),
            ("-.5", Some((-5, -1, 3))),
            ("5.;", Some((5, 0, 2))),
            ("+12.5E-3", Some((125, -4, 8))),
            ("9.880959662437583946e-1,", Some((9_880_959_662_437_583_946, -19, 23))),
            ("1e999", Some((1, 999, 5))),
            ("1e1000", None),
            ("1e00000000000012", Some((1, 12, 16))),
            (&most, Some((10_i128.pow(38) - 1, 0, 38))),
            (&format!("-0.{}", &most[1..]), Some((1 - 10_i128.pow(37), -37, 40))),
            (&format!("0.{most}"), None),
            (&format!("{most}0"), None),
            ("1.2.3", Some((12, -1, 3))),
            ("1-2", Some((1, 0, 1))),
            ("1e-", None),
            ("1e", None),
            ("1d5", Some((1, 0, 1))),
            ("", None),
            ("-", None),
            (".", None),
            ("+-1", None),
            ("e5", None),
        ] {
            assert_eq!(prefix(text), expected, "{text}");
        }
    }

    /// The way that takes numbers of any size is the reference.
    #[test]
    fn any_number_of_digits_before_and_after_the_point() {
        let digits = "91827364554637281900819273645546372819";
        for count in 1..=LONG_DIGITS {
            for before in 0..=count {
                for (sign, exponent) in [("", ""), ("-", "e-7"), ("+", "E+21"), ("-", "e0")] {
                    let text = format!("{sign}{}.{}{exponent}", &digits[..before], &digits[before..count]);
                    let (mantissa, power, length) = prefix(&text).unwrap();
                    assert_eq!(length, text.len(), "{text}");
                    let expected = Reading::Decimal.read(&text, &Limits::default()).unwrap();
                    assert_eq!(Rational::scientific(mantissa, power), expected, "{text}");
                }
            }
        }
    }
}
