//! Sums of many fractions whose denominators have little in common.

use std::collections::HashMap;

use crate::{Fraction, Integer};

/// Fractions to be added. Their sum has about as many digits as all of them together, so that it is only made where it is
/// asked for, by halves: added one after the other, `n` fractions cost `n` products and common divisors of such length.
#[derive(Debug, Clone, Default)]
pub struct LongSum {
    terms: Vec<Fraction>,
}

/// How far [`LongSum`] goes.
#[derive(Clone, Copy)]
struct Effort {
    /// The longest denominators, in bits, whose common divisor is taken out.
    divided: u64,
    /// The longest denominator, in bits, that is not given up.
    longest: u64,
}

/// Beyond so many bits two denominators share little, and a common divisor takes longer than all products.
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
    /// This sum and another, or less another. Adds nothing yet.
    pub fn combined(&self, other: &LongSum, is_subtracted: bool) -> LongSum {
        let others = other.terms.iter().filter_map(|term| {
            let (numerator, denominator) = term.clone().into_terms();
            Fraction::new(if is_subtracted { -numerator } else { numerator }, denominator)
        });
        self.terms.iter().cloned().chain(others).collect()
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
    use crate::Rational;

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
    fn sums_are_added_and_subtracted_term_by_term() {
        let [some, others]: [LongSum; 2] =
            [fractions(40), fractions(70)].map(|terms| terms.into_iter().collect());
        let [own, other] = [&some, &others].map(|sum| Rational::from(sum.total()));
        assert_eq!(Rational::from(some.combined(&others, false).total()), &own + &other);
        assert_eq!(Rational::from(some.combined(&others, true).total()), own - other);
        assert!(some.combined(&some, true).terms.is_empty());
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
