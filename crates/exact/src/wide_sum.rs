//! Sums of wide integers in fixed memory.

use crate::Integer;

/// A running sum of integers of 128 bits. Exact: no number of terms that a memory holds overflows its 192 bits.
///
/// ```
/// use boundfit_exact::{Integer, WideSum};
///
/// let mut sum = WideSum::default();
/// (0..3).for_each(|_| sum.add(i128::MIN));
/// assert_eq!(sum.total(), Integer::from(i128::MIN) * Integer::from(3));
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct WideSum {
    low: u128,
    high: i64,
}

impl WideSum {
    /// Adds an integer. Cost: three additions.
    #[inline]
    pub fn add(&mut self, term: i128) {
        self.add_unsigned(term as u128);
        // Negative numbers were taken for 2^128 more than they are.
        self.high = self.high.wrapping_add((term >> 127) as i64);
    }

    #[inline]
    fn add_unsigned(&mut self, term: u128) {
        let (low, carries) = self.low.overflowing_add(term);
        self.low = low;
        self.high = self.high.wrapping_add(i64::from(carries));
    }

    /// The sum so far. Exact.
    pub fn total(&self) -> Integer {
        Integer::from(self.high) * Integer::power_of_two(128) + Integer::from(self.low)
    }
}

/// A running sum of products of two integers of 128 bits. Exact: what two halves of 64 bits make is summed apart for each
/// power of two, so that no carry goes from one to the next before the end.
///
/// ```
/// use boundfit_exact::{Integer, WideProducts};
///
/// let mut sum = WideProducts::default();
/// sum.add(i128::MIN, i128::MIN);
/// sum.add(i128::MAX, -3);
/// let product = |left: i128, right: i128| Integer::from(left) * Integer::from(right);
/// assert_eq!(sum.total(), product(i128::MIN, i128::MIN) + product(i128::MAX, -3));
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct WideProducts {
    high: WideSum,
    middle: WideSum,
    low: WideSum,
}

impl WideProducts {
    /// Adds `left * right`. Cost: four multiplications of 64 bits.
    #[inline]
    pub fn add(&mut self, left: i128, right: i128) {
        // A signed half times an unsigned one stays within 127 bits.
        let product = |signed: i64, unsigned: u64| i128::from(signed).wrapping_mul(i128::from(unsigned));
        let ((left_high, left_low), (right_high, right_low)) = (halves(left), halves(right));
        self.low.add_unsigned(u128::from(left_low).wrapping_mul(u128::from(right_low)));
        self.middle.add(product(left_high, right_low));
        self.middle.add(product(right_high, left_low));
        self.high.add(i128::from(left_high).wrapping_mul(i128::from(right_high)));
    }

    /// The sum so far. Exact.
    pub fn total(&self) -> Integer {
        let shift = Integer::power_of_two(64);
        (self.high.total() * &shift + self.middle.total()) * shift + self.low.total()
    }
}

/// `high · 2^64 + low`.
#[inline]
fn halves(value: i128) -> (i64, u64) {
    ((value >> 64) as i64, value as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_long_integers() {
        let mut state = 1_u64;
        let mut word = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            u128::from(state)
        };
        let edges = [i128::MIN, i128::MIN + 1, -1 << 64, -1, 0, 1, (1 << 64) - 1, 1 << 64, i128::MAX];
        let mut number = |index: usize| {
            let any = (word() << 64 ^ word() ^ word() >> 40) as i128 >> (word() % 127);
            *edges.get(index % 37).unwrap_or(&any)
        };
        let (mut sum, mut long_sum) = (WideSum::default(), Integer::zero());
        let (mut products, mut long_products) = (WideProducts::default(), Integer::zero());
        for index in 0..20_000 {
            let (left, right) = (number(index), number(index * 5 / 7));
            sum.add(left);
            long_sum = long_sum + Integer::from(left);
            products.add(left, right);
            long_products = long_products + Integer::from(left) * Integer::from(right);
        }
        assert_eq!(sum.total(), long_sum);
        assert_eq!(products.total(), long_products);
    }
}
