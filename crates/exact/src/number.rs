//! The two number types. No other file of the project names the libraries behind them.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// The sign of an exact number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Exactly zero.
    Zero,
    /// Greater than zero.
    Positive,
}

impl From<Ordering> for Sign {
    fn from(ordering: Ordering) -> Self {
        match ordering {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }
}

/// An integer of any size.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Integer(BigInt);

/// A rational number in lowest terms with a positive denominator. Every operation is exact.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Rational(BigRational);

macro_rules! exact_operators {
    ($type:ident: $($trait:ident $method:ident),*) => {$(
        impl $trait<&$type> for &$type {
            type Output = $type;
            fn $method(self, other: &$type) -> $type { $type($trait::$method(&self.0, &other.0)) }
        }
        impl $trait<$type> for &$type {
            type Output = $type;
            fn $method(self, other: $type) -> $type { $type($trait::$method(&self.0, other.0)) }
        }
        impl $trait<&$type> for $type {
            type Output = $type;
            fn $method(self, other: &$type) -> $type { $type($trait::$method(self.0, &other.0)) }
        }
        impl $trait<$type> for $type {
            type Output = $type;
            fn $method(self, other: $type) -> $type { $type($trait::$method(self.0, other.0)) }
        }
    )*};
}

macro_rules! exact_type {
    ($type:ident, $inner:ident) => {
        impl Neg for $type {
            type Output = $type;
            fn neg(self) -> $type {
                $type(-self.0)
            }
        }
        impl Neg for &$type {
            type Output = $type;
            fn neg(self) -> $type {
                $type(-&self.0)
            }
        }
        impl $type {
            /// The number 0.
            pub fn zero() -> Self {
                $type($inner::zero())
            }
            /// The number 1.
            pub fn one() -> Self {
                $type($inner::one())
            }
            /// Whether the number is 0.
            pub fn is_zero(&self) -> bool {
                self.0.is_zero()
            }
            /// Whether the number is less than, equal to or greater than 0.
            pub fn sign(&self) -> Sign {
                if self.0.is_zero() {
                    Sign::Zero
                } else if self.0.is_negative() {
                    Sign::Negative
                } else {
                    Sign::Positive
                }
            }
            /// Whether the number is less than 0.
            pub fn is_negative(&self) -> bool {
                self.0.is_negative()
            }
            /// Whether the number is greater than 0.
            pub fn is_positive(&self) -> bool {
                self.0.is_positive()
            }
            /// The absolute value.
            pub fn abs(&self) -> Self {
                $type(self.0.abs())
            }
        }
        impl fmt::Debug for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{}", self.0)
            }
        }
        /// The exact value: `n`, or `p/q` in lowest terms.
        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }
        impl std::iter::Sum for $type {
            fn sum<I: Iterator<Item = $type>>(numbers: I) -> $type {
                numbers.fold($type::zero(), |total, number| total + number)
            }
        }
    };
}

exact_type!(Integer, BigInt);
exact_type!(Rational, BigRational);
exact_operators!(Integer: Add add, Sub sub, Mul mul);

macro_rules! rational_operators {
    ($($trait:ident $method:ident $function:ident),*) => {$(
        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational { $function(self, other) }
        }
        impl $trait<Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational { $function(self, &other) }
        }
        impl $trait<&Rational> for Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational { $function(&self, other) }
        }
        impl $trait<Rational> for Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational { $function(&self, &other) }
        }
    )*};
}

rational_operators!(Add add sum_of, Sub sub difference_of, Mul mul product_of);

/// Numerators and denominators of two numbers, when all four fit into 64 bits.
fn small_terms(left: &Rational, right: &Rational) -> Option<[i128; 4]> {
    let [a, b] = [left.0.numer().to_i64()?, left.0.denom().to_i64()?];
    let [c, d] = [right.0.numer().to_i64()?, right.0.denom().to_i64()?];
    Some([a, b, c, d].map(i128::from))
}

/// A fraction of machine integers in lowest terms; the denominator is positive. The library's own reduction takes its
/// greatest common divisor on big integers, which costs ten times as much.
fn reduced(numerator: i128, denominator: i128) -> Rational {
    let divisor = greatest_common_divisor(numerator.unsigned_abs(), denominator.unsigned_abs()) as i128;
    Rational(BigRational::new_raw((numerator / divisor).into(), (denominator / divisor).into()))
}

/// Euclid's algorithm; `right` is not 0.
fn greatest_common_divisor(left: u128, right: u128) -> u128 {
    let (mut left, mut right) = (left, right);
    while right > u128::from(u64::MAX) || left > u128::from(u64::MAX) {
        if right == 0 {
            return left;
        }
        (left, right) = (right, left % right);
    }
    // Division of 64 bits is many times faster than of 128.
    let (mut left, mut right) = (left as u64, right as u64);
    while right != 0 {
        (left, right) = (right, left % right);
    }
    u128::from(left)
}

fn sum_of(left: &Rational, right: &Rational) -> Rational {
    match small_terms(left, right) {
        Some([a, b, c, d]) if b == d => reduced(a + c, b),
        // Both products stay below 2^126.
        Some([a, b, c, d]) => reduced(a * d + c * b, b * d),
        None => Rational(&left.0 + &right.0),
    }
}

fn difference_of(left: &Rational, right: &Rational) -> Rational {
    match small_terms(left, right) {
        Some([a, b, c, d]) if b == d => reduced(a - c, b),
        Some([a, b, c, d]) => reduced(a * d - c * b, b * d),
        None => Rational(&left.0 - &right.0),
    }
}

fn product_of(left: &Rational, right: &Rational) -> Rational {
    match small_terms(left, right) {
        Some([a, b, c, d]) => reduced(a * c, b * d),
        None => Rational(&left.0 * &right.0),
    }
}

macro_rules! from_primitive {
    ($($primitive:ty),*) => {$(
        impl From<$primitive> for Integer {
            fn from(value: $primitive) -> Self { Integer(BigInt::from(value)) }
        }
        impl From<$primitive> for Rational {
            fn from(value: $primitive) -> Self { Rational(BigRational::from_integer(BigInt::from(value))) }
        }
    )*};
}

from_primitive!(i32, i64, i128, u32, u64, u128, usize);

impl From<Integer> for Rational {
    fn from(value: Integer) -> Self {
        Rational(BigRational::from_integer(value.0))
    }
}

impl From<&Integer> for Rational {
    fn from(value: &Integer) -> Self {
        Rational(BigRational::from_integer(value.0.clone()))
    }
}

impl Integer {
    /// 10 to the given power. Cost: the size of the result.
    pub fn power_of_ten(exponent: u32) -> Self {
        Integer(BigInt::from(10).pow(exponent))
    }

    /// 2 to the given power.
    pub fn power_of_two(exponent: u64) -> Self {
        Integer(BigInt::one() << exponent)
    }

    /// The non-negative greatest common divisor; `gcd(0, 0) = 0`.
    pub fn gcd(&self, other: &Self) -> Self {
        Integer(self.0.gcd(&other.0))
    }

    /// The non-negative least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        Integer(self.0.lcm(&other.0))
    }

    /// Quotient rounded down and the remainder, which has the sign of the divisor.
    ///
    /// # Panics
    /// When the divisor is 0.
    pub fn div_rem_floor(&self, divisor: &Self) -> (Self, Self) {
        let (quotient, remainder) = self.0.div_mod_floor(&divisor.0);
        (Integer(quotient), Integer(remainder))
    }

    /// Whether the number is divisible by 2.
    pub fn is_even(&self) -> bool {
        self.0.is_even()
    }

    /// Number of bits of the absolute value; 0 for 0.
    pub fn bits(&self) -> u64 {
        self.0.bits()
    }

    /// The value as `u64`, when it fits.
    pub fn to_u64(&self) -> Option<u64> {
        self.0.to_u64()
    }

    /// Reads ASCII digits, at least one.
    pub(crate) fn from_ascii_digits(digits: &[u8]) -> Option<Self> {
        BigInt::parse_bytes(digits, 10).map(Integer)
    }
}

impl Rational {
    /// `numerator / denominator` in lowest terms, or `None` when the denominator is 0.
    pub fn new(numerator: Integer, denominator: Integer) -> Option<Self> {
        match (numerator.0.to_i64(), denominator.0.to_i64()) {
            (_, Some(0)) => None,
            (Some(numerator), Some(denominator)) => {
                let sign = i128::from(denominator.signum());
                Some(reduced(i128::from(numerator) * sign, i128::from(denominator) * sign))
            }
            _ => Some(Rational(BigRational::new(numerator.0, denominator.0))),
        }
    }

    /// `numerator / denominator` for literals.
    ///
    /// # Panics
    /// When the denominator is 0.
    pub fn ratio(numerator: i64, denominator: i64) -> Self {
        Rational(BigRational::new(numerator.into(), denominator.into()))
    }

    /// The numerator, which carries the sign.
    pub fn numerator(&self) -> Integer {
        Integer(self.0.numer().clone())
    }

    /// The denominator, always positive.
    pub fn denominator(&self) -> Integer {
        Integer(self.0.denom().clone())
    }

    /// The quotient, or `None` when the divisor is 0.
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        divisor.recip().map(|reciprocal| self * reciprocal)
    }

    /// `1 / self`, or `None` for 0.
    pub fn recip(&self) -> Option<Self> {
        (!self.is_zero()).then(|| Rational(self.0.recip()))
    }

    /// Half of the number.
    pub fn half(&self) -> Self {
        Rational(&self.0 / BigInt::from(2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lowest_terms_with_positive_denominator() {
        let number = Rational::new(Integer::from(6), Integer::from(-4)).unwrap();
        assert_eq!(number.to_string(), "-3/2");
        assert_eq!(number.denominator(), Integer::from(2));
        assert_eq!(Rational::new(Integer::one(), Integer::zero()), None);
        assert_eq!(Rational::ratio(8, 4).to_string(), "2");
    }

    #[test]
    fn arithmetic_is_exact() {
        let (a, b) = (Rational::ratio(1, 10), Rational::ratio(2, 10));
        assert_eq!(&a + &b, Rational::ratio(3, 10));
        assert_eq!(&a - &b, Rational::ratio(-1, 10));
        assert_eq!(&a * &b, Rational::ratio(1, 50));
        assert_eq!(a.checked_div(&b), Some(Rational::ratio(1, 2)));
        assert_eq!(a.checked_div(&Rational::zero()), None);
        assert_eq!(b.half(), a);
        assert_eq!((-&a).sign(), Sign::Negative);
    }

    #[test]
    fn small_and_big_arithmetic_agree() {
        // The library's operators are the reference for numbers on both sides of the 64-bit boundary.
        let edges =
            [0, 1, -1, 2, 3, -6, 97, i64::MAX, i64::MIN, i64::MAX - 1, i64::MIN + 1, 1 << 62, -(1 << 40)];
        let mut numbers = Vec::new();
        for numerator in edges {
            for denominator in [1, 2, 3, 6, 1_000_000_007, i64::MAX, i64::MAX - 1] {
                let small = Rational::ratio(numerator, denominator);
                numbers.push(Rational(&small.0 * BigRational::from_integer(BigInt::from(1_u128 << 70))));
                numbers.push(small);
            }
        }
        for left in &numbers {
            for right in &numbers {
                assert_eq!((left + right).0, &left.0 + &right.0);
                assert_eq!((left - right).0, &left.0 - &right.0);
                assert_eq!((left * right).0, &left.0 * &right.0);
                let quotient = left.checked_div(right).map(|quotient| quotient.0);
                assert_eq!(quotient, (!right.is_zero()).then(|| &left.0 / &right.0));
                let product = left * right;
                assert_eq!(BigRational::new(product.0.numer().clone(), product.0.denom().clone()), product.0);
                let made = Rational::new(left.numerator(), right.numerator());
                let expected = (!right.is_zero())
                    .then(|| BigRational::new(left.0.numer().clone(), right.0.numer().clone()));
                assert_eq!(made.map(|made| made.0), expected);
            }
        }
    }

    #[test]
    fn floor_division_follows_the_divisor() {
        let (quotient, remainder) = Integer::from(-7).div_rem_floor(&Integer::from(2));
        assert_eq!((quotient, remainder), (Integer::from(-4), Integer::from(1)));
    }
}
