//! Integers of 256 bits: what is made of a few machine integers before it is rounded, in fixed memory.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

/// An integer of 256 bits in two's complement. Exact as long as nothing leaves 255 bits and a sign; the caller sees to that by
/// counting bits.
///
/// ```
/// use boundfit_exact::Wide;
///
/// let product = &Wide::product(-3, i128::MAX) * &Wide::from(-2);
/// assert_eq!((product + Wide::from(1)).bits(), 130);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wide {
    high: u128,
    low: u128,
}

impl From<i128> for Wide {
    #[inline]
    fn from(value: i128) -> Self {
        Wide { high: (value >> 127) as u128, low: value as u128 }
    }
}

impl Wide {
    /// The product. Exact. Cost: a multiplication of 64 bits, or four.
    #[inline]
    pub fn product(left: i128, right: i128) -> Self {
        if let (Ok(left), Ok(right)) = (i64::try_from(left), i64::try_from(right)) {
            return Wide::from(i128::from(left).wrapping_mul(i128::from(right)));
        }
        let (high, low) = long_product(left.unsigned_abs(), right.unsigned_abs());
        Wide { high, low }.negated_if((left < 0) != (right < 0))
    }

    /// The number of these words, the lowest first, of which it has 255 bits at most.
    #[inline]
    pub(crate) fn of_words([first, second, third, fourth]: [u64; 4]) -> Self {
        let pair = |low: u64, high: u64| u128::from(high) << u64::BITS | u128::from(low);
        Wide { high: pair(third, fourth), low: pair(first, second) }
    }

    /// Returns whether the number is less than 0.
    #[inline]
    pub fn is_negative(self) -> bool {
        (self.high as i128) < 0
    }

    /// Returns whether the number is 0.
    #[inline]
    pub fn is_zero(self) -> bool {
        (self.high | self.low) == 0
    }

    /// The opposite number, or the number itself.
    #[must_use]
    #[inline]
    pub fn negated_if(self, is_negated: bool) -> Self {
        if is_negated { Wide::default() - self } else { self }
    }

    /// Returns the number of bits of the absolute value; 0 for 0.
    #[inline]
    pub fn bits(self) -> u32 {
        let Wide { high, low } = self.magnitude();
        if high == 0 { u128::BITS - low.leading_zeros() } else { 2 * u128::BITS - high.leading_zeros() }
    }

    /// The absolute value without its lowest bits, rounded down, when it fits.
    #[inline]
    pub(crate) fn leading(self, without: u32) -> Option<u128> {
        let Wide { high, low } = self.magnitude();
        match without {
            0 => (high == 0).then_some(low),
            1..u128::BITS if high >> without == 0 => Some(high << (u128::BITS - without) | low >> without),
            1..u128::BITS => None,
            _ => Some(high.checked_shr(without - u128::BITS).unwrap_or_default()),
        }
    }

    /// The number as a multiple of 2^128 and a rest that is not negative.
    #[inline]
    pub(crate) fn halves(self) -> (i128, u128) {
        (self.high as i128, self.low)
    }

    #[inline]
    fn magnitude(self) -> Self {
        self.negated_if(self.is_negative())
    }

    /// The value, when it fits.
    #[inline]
    fn word(self) -> Option<i128> {
        let word = self.low as i128;
        (Wide::from(word) == self).then_some(word)
    }
}

impl Ord for Wide {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        self.halves().cmp(&other.halves())
    }
}

impl PartialOrd for Wide {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The sum.
impl Add for Wide {
    type Output = Wide;

    #[inline]
    fn add(self, other: Wide) -> Wide {
        let (low, carry) = self.low.overflowing_add(other.low);
        Wide { high: self.high.wrapping_add(other.high).wrapping_add(carry.into()), low }
    }
}

/// The difference.
impl Sub for Wide {
    type Output = Wide;

    #[inline]
    fn sub(self, other: Wide) -> Wide {
        let (low, borrow) = self.low.overflowing_sub(other.low);
        Wide { high: self.high.wrapping_sub(other.high).wrapping_sub(borrow.into()), low }
    }
}

/// The product. Cost: four multiplications of 64 bits, or a dozen.
impl Mul for &Wide {
    type Output = Wide;

    #[inline]
    fn mul(self, other: &Wide) -> Wide {
        if let (Some(left), Some(right)) = (self.word(), other.word()) {
            return Wide::product(left, right);
        }
        let (left, right) = (self.magnitude(), other.magnitude());
        let (high, low) = long_product(left.low, right.low);
        let crossed = left.high.wrapping_mul(right.low).wrapping_add(left.low.wrapping_mul(right.high));
        let product = Wide { high: high.wrapping_add(crossed), low };
        product.negated_if(self.is_negative() != other.is_negative())
    }
}

/// A product of two integers of 128 bits, its high 128 bits first.
#[inline]
fn long_product(left: u128, right: u128) -> (u128, u128) {
    let halves = |value: u128| (value >> 64, value & u128::from(u64::MAX));
    let ((a, b), (c, d)) = (halves(left), halves(right));
    let low = b.wrapping_mul(d);
    // A product of two halves leaves room for the sum of two halves.
    let middle = a.wrapping_mul(d).wrapping_add(low >> 64);
    let other = b.wrapping_mul(c).wrapping_add(middle & u128::from(u64::MAX));
    let high = a.wrapping_mul(c).wrapping_add(middle >> 64).wrapping_add(other >> 64);
    (high, other << 64 | (low & u128::from(u64::MAX)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Integer;

    fn integer(wide: Wide) -> Integer {
        let Wide { high, low } = wide.magnitude();
        let size = Integer::from(high) * Integer::power_of_two(128) + Integer::from(low);
        let integer = if wide.is_negative() { -size } else { size };
        assert_eq!(Integer::from(wide), integer);
        integer
    }

    #[test]
    fn wide_integers_compute_like_long_ones() {
        let edges =
            [0, 1, -1, 7, -10, i128::from(u64::MAX), 1 << 64, -(1 << 90) - 1, (1 << 126) + 3, i128::MAX];
        for a in edges {
            for b in edges {
                let product = Wide::product(a, b);
                let expected = Integer::from(a) * Integer::from(b);
                assert_eq!(integer(product), expected, "{a} {b}");
                assert_eq!(u64::from(product.bits()), expected.bits());
                for without in [0, 1, 63, 127, 128, 129, 200, 256, 300] {
                    assert_eq!(
                        product.leading(without),
                        expected.leading(without.into()),
                        "{a} {b} {without}"
                    );
                }
                for c in edges {
                    let other = Wide::product(c, 5);
                    let long = Integer::from(c) * Integer::from(5);
                    assert_eq!(integer(product + other), &expected + &long, "{a} {b} {c}");
                    assert_eq!(integer(product - other), &expected - &long, "{a} {b} {c}");
                    assert_eq!(product.cmp(&other), expected.cmp(&long), "{a} {b} {c}");
                    let [a, b, c, d, e] = [a, b, c, 5, a - 1].map(Integer::from);
                    let sums = (&expected + &long, &a * &e);
                    let compared = Integer::compare([(&a, &b), (&c, &d)], [(&a, &e)]);
                    assert_eq!(compared, sums.0.cmp(&sums.1), "{a} {b} {c}");
                    if expected.bits() + long.bits() < 255 {
                        assert_eq!(integer(&product * &other), &expected * &long, "{a} {b} {c}");
                    }
                }
            }
        }
    }
}
