//! The door to other exact arithmetic: conversions to and from the numbers of num-bigint and num-rational.
//!
//! None of them rounds. A conversion that does not always fit is a `TryFrom`.

use thiserror::Error;

use super::library::{BigInt, BigRational, Ratio};
use super::{Integer, Rational};

/// A rational number whose numerator or denominator does not fit into 64 bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("numerator or denominator does not fit into 64 bits")]
pub struct TooWide;

/// Exact. Cost: linear in the size of the number.
impl From<BigInt> for Integer {
    fn from(value: BigInt) -> Self {
        Integer::from_big(value)
    }
}

/// Exact. Cost: linear in the size of the number.
///
/// ```
/// use boundfit_exact::Integer;
/// use num_bigint::BigInt;
///
/// let googol = Integer::power_of_ten(100);
/// assert_eq!(BigInt::from(&googol), BigInt::from(10).pow(100));
/// assert_eq!(Integer::from(BigInt::from(10).pow(100)), googol);
/// ```
impl From<&Integer> for BigInt {
    fn from(value: &Integer) -> Self {
        value.to_big()
    }
}

/// Exact, and in lowest terms with a positive denominator also where `Ratio::new_raw` left others. Cost: that of a greatest
/// common divisor.
///
/// # Panics
/// When the denominator is 0, which `Ratio::new_raw` alone can make.
impl From<BigRational> for Rational {
    fn from(value: BigRational) -> Self {
        let (numerator, denominator) = value.into_raw();
        of_parts(numerator.into(), denominator.into())
    }
}

/// Exact. Cost: linear in the size of the number.
///
/// ```
/// use boundfit_exact::Rational;
/// use num_rational::BigRational;
///
/// let third = Rational::ratio(1, 3);
/// let shared = BigRational::from(&third);
/// assert_eq!(shared.pow(-2).to_string(), "9");
/// assert_eq!(Rational::from(shared), third);
/// ```
impl From<&Rational> for BigRational {
    fn from(value: &Rational) -> Self {
        // A rational number is in lowest terms with a positive denominator already, which is all that `new` would see to.
        BigRational::new_raw(value.numerator().to_big(), value.denominator().to_big())
    }
}

impl From<Rational> for BigRational {
    fn from(value: Rational) -> Self {
        BigRational::from(&value)
    }
}

/// Exact, and in lowest terms, as for a `BigRational`.
///
/// # Panics
/// When the denominator is 0, which `Ratio::new_raw` alone can make.
impl From<Ratio<i64>> for Rational {
    fn from(value: Ratio<i64>) -> Self {
        let (numerator, denominator) = value.into_raw();
        of_parts(numerator.into(), denominator.into())
    }
}

/// Exact.
///
/// # Errors
/// When numerator or denominator does not fit.
///
/// ```
/// use boundfit_exact::{Integer, Rational, TooWide};
/// use num_rational::Ratio;
///
/// assert_eq!(Ratio::<i64>::try_from(&Rational::ratio(-3, 4)), Ok(Ratio::new(-3, 4)));
/// assert_eq!(Rational::from(Ratio::new(6_i64, -8)), Rational::ratio(-3, 4));
/// let wide = Rational::from(Integer::power_of_ten(20));
/// assert_eq!(Ratio::<i64>::try_from(&wide), Err(TooWide));
/// ```
impl TryFrom<&Rational> for Ratio<i64> {
    type Error = TooWide;

    fn try_from(value: &Rational) -> Result<Self, TooWide> {
        let (numerator, denominator) = value.to_words().ok_or(TooWide)?;
        Ok(Ratio::new_raw(numerator, denominator))
    }
}

fn of_parts(numerator: Integer, denominator: Integer) -> Rational {
    #[allow(
        clippy::expect_used,
        reason = "documented: no fraction that the library has computed has such a denominator"
    )]
    Rational::new(numerator, denominator).expect("a fraction with denominator 0")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_that_are_not_reduced_become_so() {
        let expected = Rational::ratio(-3, 4);
        assert_eq!(Rational::from(Ratio::new_raw(6_i64, -8)), expected);
        assert_eq!(Rational::from(BigRational::new_raw(BigInt::from(6), BigInt::from(-8))), expected);
        assert_eq!(Rational::from(Ratio::new_raw(0_i64, i64::MIN)), Rational::zero());
    }

    #[test]
    fn all_sizes_go_and_come_back() {
        for exponent in [0, 1, 62, 63, 64, 126, 127, 128, 300] {
            let power = Integer::power_of_two(exponent);
            for integer in [&power - Integer::one(), -&power, power] {
                assert_eq!(Integer::from(BigInt::from(&integer)), integer);
                let number = Rational::new(integer, Integer::from(15)).unwrap_or_default();
                assert_eq!(Rational::from(BigRational::from(&number)), number);
                let words = Ratio::<i64>::try_from(&number).map(Rational::from);
                assert_eq!(words, if number.to_words().is_some() { Ok(number) } else { Err(TooWide) });
            }
        }
    }
}
