//! Sums of many fractions whose denominators have little in common.

use std::collections::HashMap;

use crate::{Fraction, Integer, Rational};

/// Fractions to be added. Their sum has about as many digits as all of them together, so it is made only on demand,
/// by halves. Added one after the other, `n` fractions would cost `n` products and common divisors of that length.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LongSum {
    terms: Vec<Fraction>,
}

/// The limits of the effort of [`LongSum`].
#[derive(Clone, Copy)]
struct Effort {
    /// The longest denominators, in bits, whose common divisor is taken out.
    divided: u64,
    /// The longest denominator, in bits, that is not given up.
    longest: u64,
}

/// The number of bits beyond which two denominators share little, and a common divisor takes longer than all
/// products.
const LONG: u64 = 1 << 15;

/// Terms over equal denominators become one.
impl FromIterator<Fraction> for LongSum {
    fn from_iter<I: IntoIterator<Item = Fraction>>(fractions: I) -> Self {
        let mut places: HashMap<Integer, usize> = HashMap::new();
        let mut denominators = Vec::new();
        let mut numerators: Vec<Integer> = Vec::new();
        for fraction in fractions {
            let (numerator, denominator) = fraction.into_terms();
            let place = *places.entry(denominator.clone()).or_insert(numerators.len());
            match numerators.get_mut(place) {
                Some(sum) => *sum = &*sum + numerator,
                None => {
                    numerators.push(numerator);
                    denominators.push(denominator);
                }
            }
        }
        let terms = numerators.into_iter().zip(denominators).filter(|(numerator, _)| !numerator.is_zero());
        LongSum { terms: terms.filter_map(|(above, below)| Fraction::new(above, below)).collect() }
    }
}

impl LongSum {
    /// Bounds on the sum: for each term they are apart by at most `2^-bits` of the largest one. Cost: a division for each term.
    pub fn between(&self, bits: u64) -> (Rational, Rational) {
        // The quotient is less than two to this power, and at least a quarter of that.
        let exponent =
            |term: &Fraction| term.numerator().bits() as i64 - term.denominator().bits() as i64 + 1;
        let Some(largest) = self.terms.iter().map(exponent).max() else { return Default::default() };
        let scale = bits as i64 + 2 - largest;
        let power = Integer::power_of_two(scale.unsigned_abs());
        let (mut lower, mut rounded) = (Integer::zero(), 0_usize);
        for term in &self.terms {
            let (floor, rest) = match scale {
                0.. => (term.numerator() * &power).div_rem_floor(term.denominator()),
                _ => term.numerator().div_rem_floor(&(term.denominator() * &power)),
            };
            lower = lower + floor;
            rounded += usize::from(!rest.is_zero());
        }
        let upper = &lower + Integer::from(rounded);
        (Rational::binary(lower, -scale), Rational::binary(upper, -scale))
    }

    /// The sum, not in lowest terms. Exact. Cost: some products of the length of the result.
    pub fn total(&self) -> Fraction {
        let effort = Effort { divided: LONG, longest: u64::MAX };
        effort.sum(&self.terms).unwrap_or_else(|| Integer::zero().into())
    }

    /// The sum over the least common denominator of its terms, where that has at most so many bits. Exact; not in lowest
    /// terms. Cost: common divisors of that length.
    pub fn total_within(&self, bits: u64) -> Option<Fraction> {
        Effort { divided: u64::MAX, longest: bits }.sum(&self.terms)
    }
}

impl Effort {
    fn sum(self, terms: &[Fraction]) -> Option<Fraction> {
        let sum = match terms {
            [] => Integer::zero().into(),
            [only] => only.clone(),
            _ => {
                let (some, others) = terms.split_at(terms.len() / 2);
                self.added(&self.sum(some)?, &self.sum(others)?)?
            }
        };
        (sum.denominator().bits() <= self.longest).then_some(sum)
    }

    fn added(self, one: &Fraction, other: &Fraction) -> Option<Fraction> {
        let (own, others) = (one.denominator(), other.denominator());
        let is_long = own.bits().max(others.bits()) > self.divided;
        let common = if is_long { Integer::one() } else { own.gcd(others) };
        let rest = others.quotient(&common);
        let numerator = one.numerator() * &rest + other.numerator() * own.quotient(&common);
        Fraction::new(numerator, own * rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fraction(numerator: i64, denominator: i64) -> Fraction {
        Fraction::new(numerator.into(), denominator.into()).unwrap()
    }

    /// Fractions of which many share factors, some denominators are equal, and some cancel.
    fn fractions(count: i64) -> Vec<Fraction> {
        (0..count).map(|n| fraction((n * n) % 101 - 50, 1 + (n * 7919) % 1009 * (1 + n % 6))).collect()
    }

    #[test]
    fn it_is_the_sum_of_reduced_fractions() {
        for count in [0, 1, 2, 3, 7, 100, 700] {
            let naive: Rational = fractions(count).into_iter().map(Rational::from).sum();
            let long: LongSum = fractions(count).into_iter().collect();
            assert_eq!(Rational::from(long.total()), naive, "{count}");
            assert_eq!(Rational::from(long.total_within(u64::MAX).unwrap()), naive, "{count}");
        }
    }

    #[test]
    fn what_cancels_leaves_nothing() {
        let both = fractions(300).into_iter().flat_map(|term| {
            let (numerator, denominator) = term.clone().into_terms();
            [term, Fraction::new(-numerator, denominator).unwrap()]
        });
        let sum: LongSum = both.collect();
        assert!(sum.terms.is_empty());
        assert_eq!(sum.total(), fraction(0, 1));
    }

    #[test]
    fn bounds_enclose_the_sum_and_close_in() {
        for count in [1, 2, 50, 700] {
            let sum: LongSum = fractions(count).into_iter().collect();
            let exact = Rational::from(sum.total());
            let largest = sum.terms.iter().map(|term| Rational::from(term.clone()).abs()).max().unwrap();
            for bits in [0, 1, 40, 640] {
                let (lower, upper) = sum.between(bits);
                assert!(lower <= exact && exact <= upper, "{count} {bits}");
                let power = Rational::binary(Integer::from(sum.terms.len()), -(bits as i64));
                assert!(upper - lower <= power * &largest, "{count} {bits}");
            }
        }
        let whole: LongSum = [fraction(3, 8), fraction(-1, 2)].into_iter().collect();
        assert_eq!(whole.between(10), (Rational::ratio(-1, 8), Rational::ratio(-1, 8)));
        assert_eq!(LongSum::default().between(10), Default::default());
    }

    #[test]
    fn denominators_beyond_the_limit_are_given_up() {
        let sum: LongSum = [fraction(1, 6), fraction(1, 10), fraction(-4, 15)].into_iter().collect();
        // The least common denominator is 30, although nothing is left.
        assert_eq!(sum.total_within(5), Some(fraction(0, 1)));
        assert_eq!(sum.total_within(4), None);
        assert_eq!(LongSum::default().total_within(1), Some(fraction(0, 1)));
    }

    #[test]
    fn long_denominators_are_multiplied() {
        let powers = (1..40).map(|n| Integer::power_of_ten(1000) + Integer::from(n));
        let terms: Vec<Fraction> =
            powers.map(|power| Fraction::new(Integer::from(3), power).unwrap()).collect();
        let sum: LongSum = terms.iter().cloned().collect();
        assert_eq!(sum.total(), sum.total_within(u64::MAX).unwrap());
        assert!(sum.total().denominator().bits() > LONG);
    }
}
