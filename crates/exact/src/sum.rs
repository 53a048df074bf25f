//! Long exact sums without a reduction to lowest terms at every step.

use crate::{Integer, Rational, Unit};

/// A running sum of rational numbers, or of products of two.
///
/// The sum is kept over a common denominator that grows only when a term needs it. Decimal data share one after the
/// first few terms, so a step costs one integer division and one multiplication instead of a greatest common divisor.
/// Exact.
#[derive(Debug, Clone)]
pub struct Sum {
    numerator: Integer,
    denominator: Integer,
}

impl Default for Sum {
    fn default() -> Self {
        Sum { numerator: Integer::zero(), denominator: Integer::one() }
    }
}

impl Sum {
    /// Adds a number.
    pub fn add(&mut self, term: &Rational) {
        self.add_fraction(term.numerator(), &term.denominator());
    }

    /// Adds `left * right`.
    pub fn add_product(&mut self, left: &Rational, right: &Rational) {
        let denominator = left.denominator() * right.denominator();
        self.add_fraction(left.numerator() * right.numerator(), &denominator);
    }

    /// Adds so many times the product of some units. Exact. Cost: a few products of long integers, without a common divisor where
    /// the units are powers of ten.
    pub fn add_units(&mut self, count: Integer, units: &[Unit]) {
        let (mut numerator, mut denominator) = (count, Integer::one());
        for unit in units {
            let (above, below) = unit.terms();
            numerator = numerator * above;
            denominator = denominator * below;
        }
        self.add_fraction(numerator, &denominator);
    }

    /// Adds the terms of another sum. Exact.
    pub fn merge(&mut self, other: Sum) {
        self.add_fraction(other.numerator, &other.denominator);
    }

    /// The sum so far, in lowest terms. Exact.
    pub fn total(&self) -> Rational {
        Rational::new(self.numerator.clone(), self.denominator.clone()).unwrap_or_default()
    }

    fn add_fraction(&mut self, numerator: Integer, denominator: &Integer) {
        if &self.denominator == denominator {
            self.numerator = &self.numerator + numerator;
            return;
        }
        let (factor, remainder) = self.denominator.div_rem_floor(denominator);
        if remainder.is_zero() {
            self.numerator = &self.numerator + numerator * factor;
            return;
        }
        let common = self.denominator.lcm(denominator);
        let (own, _) = common.div_rem_floor(&self.denominator);
        let (others, _) = common.div_rem_floor(denominator);
        self.numerator = &self.numerator * own + numerator * others;
        self.denominator = common;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equals_the_sum_of_reduced_fractions() {
        let terms: Vec<Rational> =
            (1..60).map(|n| Rational::ratio(if n % 2 == 0 { n } else { -n }, 1 + n * n % 17)).collect();
        let mut sum = Sum::default();
        let mut squares = Sum::default();
        for term in &terms {
            sum.add(term);
            squares.add_product(term, term);
        }
        assert_eq!(sum.total(), terms.iter().cloned().sum());
        assert_eq!(squares.total(), terms.iter().map(|term| term * term).sum());
        assert_eq!(Sum::default().total(), Rational::zero());
    }

    #[test]
    fn units_and_other_sums_are_added_for_what_they_are() {
        let units = [Unit::TenTo(-3), Unit::TenTo(4), Unit::OneOver(60), Unit::Any, Unit::TenTo(-40)];
        let (mut all, mut half, mut expected) = (Sum::default(), Sum::default(), Rational::zero());
        for (count, one) in (-7..).step_by(5).zip(units) {
            for other in units {
                all.add_units(Integer::from(count), &[one, other]);
                half.add_units(Integer::from(count), &[one]);
                expected = expected + Rational::from(count) * one.value() * (other.value() + Rational::one());
            }
        }
        all.merge(half);
        assert_eq!(all.total(), expected);
    }
}
