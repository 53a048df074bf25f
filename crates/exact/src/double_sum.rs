//! Long exact sums of binary64 numbers.

use crate::binary64::significand_and_exponent;
use crate::{Dyadic, Integer, Rational};

/// Exponents of products of two doubles go from twice the least one of a double up to twice the largest, and those of the upper
/// halves of products 64 further.
const LEAST_EXPONENT: i32 = -2148;
const BLOCK: usize = 64;
const BLOCKS: usize = 66;
/// The number of products of two significands of 53 bits whose sum fits into 127 bits.
const MOST_TERMS: usize = 1 << 20;

/// A running sum of finite doubles, or of products of two, each meant exactly: significands are added up apart for every
/// exponent, and put together once at the end.
#[derive(Debug, Clone)]
pub struct DoubleSum {
    /// The sums by exponent, in blocks that exist where an exponent has occurred.
    blocks: [Option<Box<[i128; BLOCK]>>; BLOCKS],
    terms: usize,
    settled: Rational,
}

impl Default for DoubleSum {
    fn default() -> Self {
        DoubleSum { blocks: [const { None }; BLOCKS], terms: 0, settled: Rational::zero() }
    }
}

impl DoubleSum {
    /// Adds a number, which must be finite.
    pub fn add(&mut self, term: f64) {
        self.add_product(term, 1.0);
    }

    /// Adds `left * right` without rounding; both must be finite.
    pub fn add_product(&mut self, left: f64, right: f64) {
        let ((left, left_exponent), (right, right_exponent)) =
            (significand_and_exponent(left), significand_and_exponent(right));
        self.make_room(1);
        self.add_at(left_exponent + right_exponent, i128::from(left) * i128::from(right));
    }

    /// Adds several numbers. Cost: a few instructions each, but for those of much less than the largest magnitude.
    pub fn add_all(&mut self, terms: &Dyadic) {
        self.make_room(Dyadic::CHUNK);
        // A chunk of counts has 72 bits.
        self.add_at(terms.exponent(), terms.counts().iter().map(|&count| i128::from(count)).sum());
        terms.others().for_each(|(_, term)| self.add(term));
    }

    /// Adds those of several numbers that are above another one, and gives how many these are. Cost: like that of
    /// [`DoubleSum::add_all`].
    pub fn add_above(&mut self, terms: &Dyadic, threshold: f64) -> usize {
        self.make_room(Dyadic::CHUNK);
        let (mut above, mut sum) = (0, 0_i128);
        for (&count, &value) in terms.counts().iter().zip(terms.values()) {
            let is_above = i64::from(value > threshold);
            above += is_above;
            sum = sum.wrapping_add(i128::from(count & -is_above));
        }
        self.add_at(terms.exponent(), sum);
        terms.others().filter(|&(_, term)| term > threshold).for_each(|(_, term)| self.add(term));
        above as usize
    }

    /// Adds the products of several numbers with as many others. Cost: like that of [`DoubleSum::add_all`].
    pub fn add_products(&mut self, left: &Dyadic, right: &Dyadic) {
        self.make_room(Dyadic::CHUNK);
        let (mut high, mut low) = (0_i128, 0_i128);
        for (&left, &right) in left.counts().iter().zip(right.counts()) {
            let product = i128::from(left) * i128::from(right);
            // Both halves of a chunk of products have room for 2^63 terms.
            high = high.wrapping_add(product >> 64);
            low = low.wrapping_add(i128::from(product as u64));
        }
        let exponent = left.exponent() + right.exponent();
        self.add_at(exponent + 64, high);
        self.add_at(exponent, low);
        // Their counts are 0: they are missing above, once or twice.
        let values = |position: usize| Some((left.values().get(position)?, right.values().get(position)?));
        let mut others = left.others().map(|(position, _)| position).peekable();
        let mut of_right = right.others().map(|(position, _)| position).peekable();
        while let Some(position) = [others.peek(), of_right.peek()].into_iter().flatten().min().copied() {
            others.next_if_eq(&position);
            of_right.next_if_eq(&position);
            if let Some((&left, &right)) = values(position) {
                self.add_product(left, right);
            }
        }
    }

    /// The sum so far. Exact.
    pub fn total(mut self) -> Rational {
        self.settle();
        self.settled
    }

    /// Lets so many more terms fit.
    #[inline]
    fn make_room(&mut self, terms: usize) {
        self.terms += terms;
        if self.terms > MOST_TERMS {
            self.settle();
            self.terms = terms;
        }
    }

    /// Adds what is no more than the terms that there is room for: `count · 2^exponent`.
    #[inline]
    #[allow(
        clippy::indexing_slicing,
        reason = "exponents of finite doubles are at least -1074 each and at most 971: LEAST_EXPONENT to 1942 and 64 more, for which there are BLOCKS blocks"
    )]
    fn add_at(&mut self, exponent: i32, count: i128) {
        let position = (exponent - LEAST_EXPONENT) as usize;
        let block = self.blocks[position / BLOCK].get_or_insert_with(|| Box::new([0; BLOCK]));
        // By the bound on the number of terms this cannot overflow.
        let part = &mut block[position % BLOCK];
        *part = part.wrapping_add(count);
    }

    fn settle(&mut self) {
        // From the largest exponent down, so that each step shifts what is there and adds.
        let mut sum = Integer::zero();
        let mut last = None;
        for (index, block) in self.blocks.iter_mut().enumerate().rev() {
            let parts = block.iter_mut().flat_map(|block| block.iter_mut().enumerate().rev());
            for (offset, part) in parts.filter(|(_, part)| **part != 0) {
                let position = index * BLOCK + offset;
                let shift = last.map_or(0, |last: usize| last - position);
                sum = sum * Integer::power_of_two(shift as u64) + Integer::from(std::mem::take(part));
                last = Some(position);
            }
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
        assert!(2 * MOST_TERMS < count as usize);
        (0..count).for_each(|_| sum.add_product(-f64::MAX, f64::MAX));
        let largest = Rational::from_f64(f64::MAX).unwrap();
        assert_eq!(sum.total(), -(&largest * &largest * Rational::from(count)));
    }
    /// Numbers whose exponents differ by up to 2000, ends of the format and halves that carry.
    #[test]
    fn many_at_a_time_are_the_sum_of_each() {
        let mut state: u64 = 0x2545_f491_4f6c_dd1d;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state
        };
        for spread in [1, 4, 9, 10, 60, 2046] {
            for least in [0, 1, 900, 2046 - spread] {
                let mut number = || {
                    let biased = least + (next() >> 30) % spread;
                    f64::from_bits(next() >> 63 << 63 | biased << 52 | next() >> 12)
                };
                let (mut left, mut right): (Vec<f64>, Vec<f64>) =
                    (0..3000).map(|_| (number(), number())).unzip();
                left.extend([0.0, -0.0, f64::MAX, -f64::MAX, f64::from_bits(1)]);
                right.extend([-0.0, f64::MAX, f64::MAX, f64::MIN_POSITIVE, -f64::from_bits(1)]);
                let threshold = right[17];
                let [mut each, mut products, mut above] = [(); 3].map(|()| DoubleSum::default());
                let [mut all, mut all_products, mut all_above] = [(); 3].map(|()| DoubleSum::default());
                let (mut count, mut all_count) = (0, 0);
                for (&left, &right) in left.iter().zip(&right) {
                    each.add(left);
                    products.add_product(left, right);
                    if right > threshold {
                        above.add(right);
                        count += 1;
                    }
                }
                for (left, right) in left.chunks(Dyadic::CHUNK).zip(right.chunks(Dyadic::CHUNK)) {
                    let (left, right) = (Dyadic::new(left), Dyadic::new(right));
                    all.add_all(&left);
                    all_products.add_products(&left, &right);
                    all_count += all_above.add_above(&right, threshold);
                }
                assert_eq!(all.total(), each.total(), "{spread} {least}");
                assert_eq!(all_products.total(), products.total(), "{spread} {least}");
                assert_eq!((all_count, all_above.total()), (count, above.total()), "{spread} {least}");
            }
        }
    }
}
