//! Integers of any size.

use std::cmp::Ordering;
use std::fmt;

use super::gcd::gcd;
use super::library::{BigInt, BigSign, DivisionAndGcd as _, ToPrimitive as _};
use super::{Sign, number, operators};

/// An integer of any size. Every operation is exact.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Integer(Size);

/// How an integer is kept. A big one never fits into the small one.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Size {
    Small(i128),
    Big(Box<BigInt>),
}

use Size::{Big, Small};

number!(Integer);
operators!(Integer: Add add sum_of, Sub sub difference_of, Mul mul product_of);

fn sum_of(left: &Integer, right: &Integer) -> Integer {
    if let (Small(left), Small(right)) = (&left.0, &right.0)
        && let Some(sum) = left.checked_add(*right)
    {
        return Integer(Small(sum));
    }
    Integer::from_big(left.to_big() + right.to_big())
}

fn difference_of(left: &Integer, right: &Integer) -> Integer {
    if let (Small(left), Small(right)) = (&left.0, &right.0)
        && let Some(difference) = left.checked_sub(*right)
    {
        return Integer(Small(difference));
    }
    Integer::from_big(left.to_big() - right.to_big())
}

fn product_of(left: &Integer, right: &Integer) -> Integer {
    if let (Small(left), Small(right)) = (&left.0, &right.0) {
        // A product of two 64-bit words needs no check, which costs more than the product.
        if let (Ok(left), Ok(right)) = (i64::try_from(*left), i64::try_from(*right)) {
            return Integer(Small(i128::from(left) * i128::from(right)));
        }
        if let Some(product) = left.checked_mul(*right) {
            return Integer(Small(product));
        }
    }
    Integer::from_big(left.to_big() * right.to_big())
}

impl Ord for Integer {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Small(own), Small(other)) => own.cmp(other),
            (Big(own), Big(other)) => own.cmp(other),
            // Beyond all small numbers, on the side of its sign.
            (Big(own), Small(_)) => own.sign().cmp(&BigSign::NoSign),
            (Small(_), Big(other)) => BigSign::NoSign.cmp(&other.sign()),
        }
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Small(value) => fmt::Display::fmt(value, f),
            Big(value) => fmt::Display::fmt(value, f),
        }
    }
}

macro_rules! from_primitive {
    ($($primitive:ty),*) => {$(
        impl From<$primitive> for Integer {
            fn from(value: $primitive) -> Self {
                match i128::try_from(value) {
                    Ok(value) => Integer(Small(value)),
                    Err(_) => Integer(Big(Box::new(BigInt::from(value)))),
                }
            }
        }
    )*};
}

from_primitive!(i32, i64, i128, u32, u64, u128, usize);

impl Integer {
    /// The number 0.
    pub fn zero() -> Self {
        Integer(Small(0))
    }

    /// The number 1.
    pub fn one() -> Self {
        Integer(Small(1))
    }

    /// Whether the number is less than, equal to or greater than 0.
    pub fn sign(&self) -> Sign {
        match &self.0 {
            Small(value) => value.cmp(&0).into(),
            Big(value) => value.sign().cmp(&BigSign::NoSign).into(),
        }
    }

    pub(super) fn negated(&self) -> Self {
        if let Small(value) = self.0
            && let Some(negated) = value.checked_neg()
        {
            return Integer(Small(negated));
        }
        Integer::from_big(-self.to_big())
    }

    /// 10 to the given power. Cost: the size of the result.
    pub fn power_of_ten(exponent: u32) -> Self {
        Integer::from_big(BigInt::from(10).pow(exponent))
    }

    /// 2 to the given power.
    pub fn power_of_two(exponent: u64) -> Self {
        Integer::from_big(BigInt::from(1) << exponent)
    }

    /// The non-negative greatest common divisor; `gcd(0, 0) = 0`.
    pub fn gcd(&self, other: &Self) -> Self {
        match (&self.0, &other.0) {
            (Small(own), Small(other)) => Integer::from(gcd(own.unsigned_abs(), other.unsigned_abs())),
            _ => Integer::from_big(self.to_big().gcd(&other.to_big())),
        }
    }

    /// The non-negative least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        if self == other {
            return self.abs();
        }
        let divisor = self.gcd(other);
        if divisor.is_zero() { divisor } else { (self.quotient(&divisor) * other).abs() }
    }

    /// Quotient rounded down and the remainder, which has the sign of the divisor.
    ///
    /// # Panics
    /// When the divisor is 0.
    pub fn div_rem_floor(&self, divisor: &Self) -> (Self, Self) {
        // The least small number has no small opposite, so its quotient by -1 is big.
        if let (Small(own), Small(divisor)) = (&self.0, &divisor.0)
            && *own != i128::MIN
        {
            let (quotient, remainder) = own.div_mod_floor(divisor);
            return (Integer(Small(quotient)), Integer(Small(remainder)));
        }
        let (quotient, remainder) = self.to_big().div_mod_floor(&divisor.to_big());
        (Integer::from_big(quotient), Integer::from_big(remainder))
    }

    /// The quotient by a divisor of the number.
    pub(super) fn quotient(&self, divisor: &Self) -> Self {
        match (&self.0, &divisor.0) {
            (_, Small(1)) => self.clone(),
            (Small(own), Small(divisor)) if *own != i128::MIN => {
                match (i64::try_from(*own), i64::try_from(*divisor)) {
                    // A division of 64 bits is several times faster than one of 128.
                    (Ok(own), Ok(divisor)) => Integer::from(i128::from(own / divisor)),
                    _ => Integer(Small(own / divisor)),
                }
            }
            _ => Integer::from_big(self.to_big() / divisor.to_big()),
        }
    }

    /// Whether the number is divisible by 2.
    pub fn is_even(&self) -> bool {
        match &self.0 {
            Small(value) => value % 2 == 0,
            Big(value) => value.is_even(),
        }
    }

    /// Number of bits of the absolute value; 0 for 0.
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Small(value) => u64::from(u128::BITS - value.unsigned_abs().leading_zeros()),
            Big(value) => value.bits(),
        }
    }

    /// The value as `u64`, when it fits.
    pub fn to_u64(&self) -> Option<u64> {
        match &self.0 {
            Small(value) => u64::try_from(*value).ok(),
            Big(_) => None,
        }
    }

    /// Reads ASCII digits, at least one.
    pub(crate) fn from_ascii_digits(digits: &[u8]) -> Option<Self> {
        /// Numbers of so many digits fit into 63 bits.
        const SHORT: usize = 18;
        if digits.len() <= SHORT && !digits.is_empty() {
            let value = digits.iter().try_fold(0_i64, |value, digit| {
                digit.is_ascii_digit().then(|| value * 10 + i64::from(digit - b'0'))
            });
            return value.map(Integer::from);
        }
        BigInt::parse_bytes(digits, 10).map(Integer::from_big)
    }

    /// The library's form.
    pub(super) fn to_big(&self) -> BigInt {
        match &self.0 {
            Small(value) => BigInt::from(*value),
            Big(value) => (**value).clone(),
        }
    }

    pub(super) fn from_big(value: BigInt) -> Self {
        match value.to_i128() {
            Some(value) => Integer(Small(value)),
            None => Integer(Big(Box::new(value))),
        }
    }
}
