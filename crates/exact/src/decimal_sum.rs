//! Long exact sums of decimals of all sizes.

use std::collections::BTreeMap;

use crate::{Integer, Sum, Unit, WideSum};

/// A running sum of decimals, or of products of two: mantissas are added up apart for every exponent, and put together once at
/// the end. Exact.
///
/// ```
/// use boundfit_exact::{DecimalSum, Rational};
///
/// let mut sum = DecimalSum::default();
/// sum.add(3, 300);
/// sum.add(-5, -300);
/// sum.add(-3, 300);
/// assert_eq!(sum.total().total(), Rational::scientific(-5, -300));
/// ```
#[derive(Debug, Clone, Default)]
pub struct DecimalSum {
    parts: BTreeMap<i32, WideSum>,
}

impl DecimalSum {
    /// Adds `count · 10^exponent`. Cost: the search for an exponent.
    #[inline]
    pub fn add(&mut self, count: i128, exponent: i32) {
        self.parts.entry(exponent).or_default().add(count);
    }

    /// The sum so far. Exact. Cost: a product for each exponent that occurred.
    pub fn total(&self) -> Sum {
        // From the largest exponent down, so that each step shifts what is there and adds.
        let (mut count, mut last) = (Integer::zero(), None);
        for (&exponent, part) in self.parts.iter().rev() {
            let shift = last.map_or(0, |last: i32| last.abs_diff(exponent));
            count = count * Integer::power_of_ten(shift) + part.total();
            last = Some(exponent);
        }
        let mut sum = Sum::default();
        sum.add_units(count, &[last.map_or(Unit::Any, Unit::TenTo)]);
        sum
    }
}
