//! Long exact sums of binary64 numbers.

use crate::binary64::significand_and_exponent;
use crate::{Integer, Rational};

/// Exponents of products of two doubles go from twice the least one of a double up to twice the largest.
const LEAST_EXPONENT: i32 = -2148;
const EXPONENTS: usize = 4096;
/// So many products of two significands of 53 bits fit into 127 bits.
const MOST_TERMS: u32 = 1 << 20;

/// A running sum of finite doubles, or of products of two, each meant exactly: significands are added up apart for every
/// exponent, and put together once at the end.
#[derive(Debug, Clone)]
pub struct DoubleSum {
    by_exponent: Vec<i128>,
    terms: u32,
    settled: Rational,
}

impl Default for DoubleSum {
    fn default() -> Self {
        DoubleSum { by_exponent: vec![0; EXPONENTS], terms: 0, settled: Rational::zero() }
    }
}

impl DoubleSum {
    /// Adds a number, which must be finite.
    pub fn add(&mut self, term: f64) {
        self.add_product(term, 1.0);
    }

    /// Adds `left * right` without rounding; both must be finite.
    #[allow(
        clippy::indexing_slicing,
        reason = "exponents of finite doubles are at least -1074 each and at most 971: LEAST_EXPONENT to 1942, for which there are EXPONENTS places"
    )]
    pub fn add_product(&mut self, left: f64, right: f64) {
        let ((left, left_exponent), (right, right_exponent)) =
            (significand_and_exponent(left), significand_and_exponent(right));
        let position = (left_exponent + right_exponent - LEAST_EXPONENT) as usize;
        let product = i128::from(left) * i128::from(right);
        // By the bound on the number of terms this cannot overflow.
        self.by_exponent[position] = self.by_exponent[position].wrapping_add(product);
        self.terms += 1;
        if self.terms == MOST_TERMS {
            self.settle();
        }
    }

    /// The sum so far. Exact.
    pub fn total(mut self) -> Rational {
        self.settle();
        self.settled
    }

    fn settle(&mut self) {
        // From the largest exponent down, so that each step shifts what is there and adds.
        let mut sum = Integer::zero();
        let mut last = None;
        for (position, part) in self.by_exponent.iter_mut().enumerate().rev().filter(|(_, part)| **part != 0)
        {
            let shift = last.map_or(0, |last: usize| last - position);
            sum = sum * Integer::power_of_two(shift as u64) + Integer::from(std::mem::take(part));
            last = Some(position);
        }
        let exponent = last.map_or(0, |last| last as i64 + i64::from(LEAST_EXPONENT));
        let power = Rational::from(Integer::power_of_two(exponent.unsigned_abs()));
        let scaled = Rational::from(sum);
        let scaled =
            if exponent < 0 { scaled.checked_div(&power).unwrap_or_default() } else { scaled * power };
        self.settled = &self.settled + scaled;
        self.terms = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equals_the_sum_of_exact_fractions() {
        let terms =
            [0.1, -0.0, 1e300, -2.5, 5e-324, f64::MAX, -1e300, f64::MIN_POSITIVE, 3.0, -f64::MAX, 1e-300];
        let exact = |value: f64| Rational::from_f64(value).unwrap();
        let (mut sum, mut products) = (DoubleSum::default(), DoubleSum::default());
        let (mut expected, mut expected_products) = (Rational::zero(), Rational::zero());
        for left in terms {
            sum.add(left);
            expected = expected + exact(left);
            for right in terms {
                products.add_product(left, right);
                expected_products = expected_products + exact(left) * exact(right);
            }
        }
        assert_eq!(sum.total(), expected);
        assert_eq!(products.total(), expected_products);
    }

    #[test]
    fn more_terms_than_one_round_holds() {
        let mut sum = DoubleSum::default();
        // Twice as many of these would overflow, were they added up in one round.
        let count = (2 << 20) + 5;
        assert!(2 * MOST_TERMS < count);
        (0..count).for_each(|_| sum.add_product(-f64::MAX, f64::MAX));
        let largest = Rational::from_f64(f64::MAX).unwrap();
        assert_eq!(sum.total(), -(&largest * &largest * Rational::from(count)));
    }
}
