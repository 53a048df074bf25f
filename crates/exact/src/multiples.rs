//! Long numbers as machine integers, where they are multiples of one long unit.

use crate::{Count, Integer, Rational};

/// Counts how many times each number contains the largest number that all are multiples of: 1.5e300 and 2e300 contain 5e299 three and four
/// times. `None` where a count goes beyond the integers of a [`Count`] of 62 bits. What such counts decide the numbers decide: which
/// is larger, and on which side of a line a point lies.
///
/// Exact. Cost: linear, a quotient for each number, and a greatest common divisor where the unit changes; it ends at the first number
/// that makes counts too large.
pub fn multiples<'a>(numbers: impl Iterator<Item = &'a Rational> + Clone) -> Option<Vec<i64>> {
    let mut unit = Rational::zero();
    let mut largest = Rational::zero();
    for number in numbers.clone().filter(|number| !number.is_zero()) {
        let grows = number.abs() > largest;
        if grows {
            largest = number.abs();
        }
        match counted(number, &unit) {
            None => unit = number.abs(),
            Some((_, rest)) if !rest.is_zero() => unit = common_unit(number, &unit),
            Some(_) if !grows => continue,
            Some(_) => {}
        }
        count(&largest, &unit)?;
    }
    numbers.map(|number| if unit.is_zero() { Some(0) } else { count(number, &unit) }).collect()
}

/// Divides a number by a unit. Returns the quotient, rounded down, and a remainder on some scale; `None` for the unit 0.
fn counted(number: &Rational, unit: &Rational) -> Option<(Integer, Integer)> {
    if unit.is_zero() {
        return None;
    }
    let [own, of_unit] = [number, unit].map(Rational::denominator);
    Some(match own == of_unit {
        true => number.numerator().div_rem_floor(&unit.numerator()),
        false => (number.numerator() * of_unit).div_rem_floor(&(unit.numerator() * own)),
    })
}

/// The count of a number that is a multiple.
fn count(number: &Rational, unit: &Rational) -> Option<i64> {
    <i64 as Count>::new(counted(number, unit)?.0.to_i128()?)
}

/// The largest number that two are multiples of.
fn common_unit(one: &Rational, other: &Rational) -> Rational {
    let ([one, other], common) = Rational::over_common_denominator([one, other]);
    Rational::new(one.gcd(&other), common).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(numbers: &[Rational]) -> Option<Vec<i64>> {
        multiples(numbers.iter())
    }

    #[test]
    fn long_numbers_with_short_digits_are_multiples() {
        let at = |count: i64, exponent: i32| Rational::scientific(i128::from(count), exponent);
        assert_eq!(of(&[at(15, 299), at(-2, 300), at(0, 0)]), Some(vec![3, -4, 0]));
        assert_eq!(of(&[at(-7, -305), at(21, -306), at(14, -306)]), Some(vec![-10, 3, 2]));
        assert_eq!(
            of(&[Rational::ratio(1, 6), Rational::ratio(1, 4), Rational::ratio(-5, 12)]),
            Some(vec![2, 3, -5])
        );
        assert_eq!((of(&[]), of(&[Rational::zero()])), (Some(vec![]), Some(vec![0])));
        assert_eq!(of(&[at(1, 300), at(1, 0)]), None);
        assert_eq!(of(&[at(1, 0), at(1, 300)]), None);
        let [most, beyond] = [(1_i64 << 62) - 1, 1 << 62];
        assert_eq!(of(&[at(1, 0), at(most, 0)]), Some(vec![1, most]));
        assert_eq!(of(&[at(1, 0), at(beyond, 0)]), None);
    }

    #[test]
    fn counts_keep_every_proportion() {
        for seed in 1..200_i64 {
            let numbers: Vec<Rational> =
                (1..9).map(|k| Rational::ratio(seed * k % 37 - 18, seed % 11 + k)).collect();
            let counts = of(&numbers).unwrap();
            for (one, count) in numbers.iter().zip(&counts) {
                for (other, further) in numbers.iter().zip(&counts) {
                    assert_eq!(one * Rational::from(*further), other * Rational::from(*count));
                }
            }
            let divisor = counts.iter().fold(Integer::zero(), |divisor, &count| divisor.gcd(&count.into()));
            assert!(divisor <= Integer::one(), "{counts:?}");
        }
    }
}
