//! Rational numbers.

use std::cmp::Ordering;
use std::fmt;

use super::gcd::gcd;
use super::{Integer, Sign, number, operators};

/// A rational number in lowest terms with a positive denominator. Every operation is exact.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: Integer,
    denominator: Integer,
}

number!(Rational);
operators!(Rational: Add add sum_of, Sub sub difference_of, Mul mul product_of);

fn sum_of(left: &Rational, right: &Rational) -> Rational {
    combined_words(left, right, false).unwrap_or_else(|| combined(left, right, |own, other| own + other))
}

fn difference_of(left: &Rational, right: &Rational) -> Rational {
    combined_words(left, right, true).unwrap_or_else(|| combined(left, right, |own, other| own - other))
}

/// Computes a sum or difference in lowest terms. It takes common divisors of the denominators only, which are smaller
/// than those of the result (Knuth, *The Art of Computer Programming* 2, section 4.5.1).
fn combined(left: &Rational, right: &Rational, combine: impl Fn(&Integer, &Integer) -> Integer) -> Rational {
    let (Rational { numerator: a, denominator: b }, Rational { numerator: c, denominator: d }) =
        (left, right);
    if b == d {
        return Rational::reduced(combine(a, c), b.clone());
    }
    let common = b.gcd(d);
    if common == Integer::one() {
        return Rational { numerator: combine(&(a * d), &(c * b)), denominator: b * d };
    }
    let (b_rest, d_rest) = (b.quotient(&common), d.quotient(&common));
    let numerator = combine(&(a * &d_rest), &(c * &b_rest));
    let shared = numerator.gcd(&common);
    Rational { numerator: numerator.quotient(&shared), denominator: b_rest * d.quotient(&shared) }
}

/// Computes the same of words, as most numbers are, without a long number between.
fn combined_words(left: &Rational, right: &Rational, is_difference: bool) -> Option<Rational> {
    let ((a, b), (c, d)) = (left.to_words()?, right.to_words()?);
    // Products of two words, and the sum of two of them, fit into 128 bits.
    let sum = |times_a: i64, times_c: i64| {
        let (own, other) = (i128::from(a) * i128::from(times_a), i128::from(c) * i128::from(times_c));
        if is_difference { own - other } else { own + other }
    };
    let over = |numerator: i128, divisor: i64| match i64::try_from(numerator) {
        // A division of 64 bits is several times faster than one of 128.
        Ok(numerator) => i128::from(numerator / divisor),
        Err(_) => numerator / i128::from(divisor),
    };
    // A divisor of a positive word is one.
    let divisor_of =
        |number: i128, word: i64| gcd(number.unsigned_abs(), u128::from(word.unsigned_abs())) as i64;
    let common = match (b, d) {
        _ if b == d => b,
        (1, _) | (_, 1) => 1,
        _ => divisor_of(b.into(), d),
    };
    if common == 1 {
        // Neither denominator has a divisor that the sum could share.
        let denominator = i128::from(b) * i128::from(d);
        return Some(Rational { numerator: sum(d, b).into(), denominator: denominator.into() });
    }
    let (b_rest, d_rest) = (b / common, d / common);
    let numerator = sum(d_rest, b_rest);
    let shared = divisor_of(numerator, common);
    let denominator = i128::from(b_rest) * i128::from(d / shared);
    Some(Rational { numerator: over(numerator, shared).into(), denominator: denominator.into() })
}

/// Numerators against the other's denominators: what is left has no common divisor.
fn product_of(left: &Rational, right: &Rational) -> Rational {
    let (Rational { numerator: a, denominator: b }, Rational { numerator: c, denominator: d }) =
        (left, right);
    let (above, below) = (a.gcd(d), c.gcd(b));
    Rational {
        numerator: a.quotient(&above) * c.quotient(&below),
        denominator: b.quotient(&below) * d.quotient(&above),
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.denominator == other.denominator {
            return self.numerator.cmp(&other.numerator);
        }
        Integer::compare([(&self.numerator, &other.denominator)], [(&other.numerator, &self.denominator)])
    }
}

/// The exact value: `n`, or `p/q` in lowest terms.
impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if f.width().is_none() && !f.sign_plus() {
            return self.write_to(f);
        }
        if self.denominator == Integer::one() {
            return self.numerator.fmt(f);
        }
        f.pad_integral(
            !self.numerator.is_negative(),
            "",
            &format!("{}/{}", self.numerator.abs(), self.denominator),
        )
    }
}

macro_rules! from_integer {
    ($($integer:ty),*) => {$(
        impl From<$integer> for Rational {
            fn from(value: $integer) -> Self { Rational { numerator: Integer::from(value), denominator: Integer::one() } }
        }
    )*};
}

from_integer!(i32, i64, i128, u32, u64, u128, usize, Integer);

impl From<&Integer> for Rational {
    fn from(value: &Integer) -> Self {
        Rational::from(value.clone())
    }
}

impl Rational {
    /// Writes the number, as the [`Display`](fmt::Display) form has it, without a formatter, which takes half of the time. Exact.
    ///
    /// # Errors
    /// The first error of what is written to.
    pub fn write_to(&self, out: &mut impl fmt::Write) -> fmt::Result {
        self.numerator.write_to(out)?;
        if self.denominator == Integer::one() {
            return Ok(());
        }
        out.write_str("/")?;
        self.denominator.write_to(out)
    }

    /// The number 0.
    #[inline]
    pub fn zero() -> Self {
        Rational { numerator: Integer::zero(), denominator: Integer::one() }
    }

    /// The number 1.
    #[inline]
    pub fn one() -> Self {
        Rational { numerator: Integer::one(), denominator: Integer::one() }
    }

    /// `numerator / denominator` in lowest terms, or `None` when the denominator is 0.
    pub fn new(numerator: Integer, denominator: Integer) -> Option<Self> {
        match denominator.sign() {
            Sign::Zero => None,
            Sign::Positive => Some(Rational::reduced(numerator, denominator)),
            Sign::Negative => Some(Rational::reduced(-numerator, -denominator)),
        }
    }

    /// `numerator / denominator · 10^exponent` in lowest terms, or `None` when the denominator is 0. Exact. Cost: two greatest
    /// common divisors, each of less than the whole numbers.
    pub fn scaled_quotient(numerator: Integer, denominator: Integer, exponent: i32) -> Option<Self> {
        let Rational { numerator, denominator } = Rational::new(numerator, denominator)?;
        let power = Integer::power_of_ten(exponent.unsigned_abs());
        if exponent == 0 {
            return Some(Rational { numerator, denominator });
        }
        let common = power.gcd(if exponent > 0 { &denominator } else { &numerator });
        let power = power.quotient(&common);
        Some(if exponent > 0 {
            Rational { numerator: numerator * power, denominator: denominator.quotient(&common) }
        } else {
            Rational { numerator: numerator.quotient(&common), denominator: denominator * power }
        })
    }

    /// `numerator / denominator` for literals.
    ///
    /// # Panics
    /// When the denominator is 0.
    pub fn ratio(numerator: i64, denominator: i64) -> Self {
        let ratio = Rational::new(numerator.into(), denominator.into());
        #[allow(clippy::expect_used, reason = "documented: for literals, none of which comes from input")]
        ratio.expect("a literal with denominator 0")
    }

    /// Lowest terms of a fraction with a positive denominator.
    fn reduced(numerator: Integer, denominator: Integer) -> Self {
        let divisor = numerator.gcd(&denominator);
        Rational { numerator: numerator.quotient(&divisor), denominator: denominator.quotient(&divisor) }
    }

    /// `mantissa · 10^exponent`. Exact. Cost: the size of the power.
    ///
    /// ```
    /// # use boundfit_exact::Rational;
    /// assert_eq!(Rational::scientific(-125, -3), Rational::ratio(-1, 8));
    /// ```
    pub fn scientific(mantissa: impl Into<Integer>, exponent: impl Into<i64>) -> Self {
        let (mantissa, exponent) = (mantissa.into(), exponent.into());
        if let (Some(mantissa), -18..=0) = (mantissa.to_i64(), exponent) {
            return Rational::of_decimal(mantissa, exponent.unsigned_abs() as u32);
        }
        if let (Some(mantissa), -38..=0) = (mantissa.to_i128(), exponent) {
            return Rational::of_long_decimal(mantissa, exponent.unsigned_abs() as u32);
        }
        // No memory holds a power whose exponent is beyond 32 bits.
        let power = Integer::power_of_ten(u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX));
        if exponent >= 0 {
            return Rational::from(mantissa * power);
        }
        Rational::new(mantissa, power).unwrap_or_default()
    }

    /// `mantissa · 2^exponent`. Exact. Cost: the size of the power.
    pub fn binary(mantissa: Integer, exponent: i64) -> Self {
        let power = Integer::power_of_two(exponent.unsigned_abs());
        if exponent >= 0 {
            return Rational::from(mantissa * power);
        }
        Rational::new(mantissa, power).unwrap_or_default()
    }

    /// `significand · 2^exponent`. Exact. Only twos divide a power of two, which takes no greatest common divisor.
    pub(crate) fn dyadic(significand: i64, exponent: i32) -> Self {
        if significand == 0 {
            return Rational::zero();
        }
        let twos = significand.trailing_zeros();
        let (odd, exponent) = (Integer::from(significand >> twos), exponent + twos as i32);
        let power = Integer::power_of_two(exponent.unsigned_abs().into());
        if exponent >= 0 {
            return Rational::from(odd * power);
        }
        Rational { numerator: odd, denominator: power }
    }

    /// `mantissa / 10^places`, for at most 18 places. Only 2 and 5 divide a power of ten, which takes a tenth of the time of
    /// a greatest common divisor.
    #[allow(clippy::indexing_slicing, reason = "there are 19 powers for at most 18 places")]
    fn of_decimal(mantissa: i64, places: u32) -> Self {
        #[allow(
            clippy::indexing_slicing,
            reason = "evaluated by the compiler, which would refuse an index out of range"
        )]
        const POWERS_OF_FIVE: [i64; 19] = {
            let mut powers = [1; 19];
            let mut exponent = 1;
            while exponent < powers.len() {
                powers[exponent] = 5 * powers[exponent - 1];
                exponent += 1;
            }
            powers
        };
        if mantissa == 0 {
            return Rational::zero();
        }
        let twos = mantissa.trailing_zeros().min(places);
        let mut numerator = mantissa >> twos;
        let mut fives = places;
        while fives > 0 && numerator % 5 == 0 {
            numerator /= 5;
            fives -= 1;
        }
        let denominator = POWERS_OF_FIVE[fives as usize] << (places - twos);
        Rational { numerator: numerator.into(), denominator: denominator.into() }
    }

    /// `mantissa / 10^places`, for at most 38 places: the same of longer integers, whose divisions take several times as long.
    fn of_long_decimal(mantissa: i128, places: u32) -> Self {
        if mantissa == 0 {
            return Rational::zero();
        }
        let twos = mantissa.trailing_zeros().min(places);
        let mut numerator = mantissa >> twos;
        let mut fives = places;
        while fives > 0 && numerator % 5 == 0 {
            numerator /= 5;
            fives -= 1;
        }
        // At most 10^38, which is less than 2^127.
        let denominator = 5_i128.pow(fives) << (places - twos);
        Rational { numerator: numerator.into(), denominator: denominator.into() }
    }

    /// Returns whether the number is less than, equal to or greater than 0.
    #[inline]
    pub fn sign(&self) -> Sign {
        self.numerator.sign()
    }

    #[inline]
    fn negated(&self) -> Self {
        Rational { numerator: self.numerator.negated(), denominator: self.denominator.clone() }
    }

    /// Bits of numerator and denominator together: how long the number is.
    #[inline]
    pub fn bits(&self) -> u64 {
        self.numerator.bits() + self.denominator.bits()
    }

    /// The numerator, which carries the sign.
    #[inline]
    pub fn numerator(&self) -> Integer {
        self.numerator.clone()
    }

    /// The denominator, always positive.
    #[inline]
    pub fn denominator(&self) -> Integer {
        self.denominator.clone()
    }

    /// Numerator and denominator.
    #[inline]
    pub(crate) fn terms(&self) -> (&Integer, &Integer) {
        (&self.numerator, &self.denominator)
    }

    /// Numerator and denominator, when both fit into 64 bits.
    #[inline]
    pub fn to_words(&self) -> Option<(i64, i64)> {
        Some((self.numerator.to_i64()?, self.denominator.to_i64()?))
    }

    /// Returns whether the number is `numerator / denominator`, whose denominator is not 0. Exact. Cost: two products of the lowest words,
    /// of the whole numbers where these are equal.
    pub fn is_quotient(&self, numerator: &Integer, denominator: &Integer) -> bool {
        let product = |one: &Integer, other: &Integer| one.lowest_word().wrapping_mul(other.lowest_word());
        product(&self.numerator, denominator) == product(numerator, &self.denominator)
            && Integer::compare([(&self.numerator, denominator)], [(numerator, &self.denominator)]).is_eq()
    }

    /// Numbers as integers over their least common denominator, which comes last and is positive. Exact.
    ///
    /// ```
    /// use boundfit_exact::{Integer, Rational};
    ///
    /// let (halves, sixths) = (Rational::ratio(3, 2), Rational::ratio(-1, 6));
    /// let (integers, denominator) = Rational::over_common_denominator([&halves, &sixths]);
    /// assert_eq!((integers, denominator), ([9, -1].map(Integer::from), Integer::from(6)));
    /// ```
    #[inline]
    pub fn over_common_denominator<const N: usize>(numbers: [&Rational; N]) -> ([Integer; N], Integer) {
        let mut denominators = numbers.iter().map(|number| &number.denominator);
        let first = denominators.next().map_or_else(Integer::one, Integer::clone);
        let common = denominators.fold(first, |common, denominator| common.lcm(denominator));
        (numbers.map(|number| &number.numerator * common.quotient(&number.denominator)), common)
    }

    /// The quotient, or `None` when the divisor is 0.
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        divisor.recip().map(|reciprocal| self * reciprocal)
    }

    /// `1 / self`, or `None` for 0.
    pub fn recip(&self) -> Option<Self> {
        let (numerator, denominator) = (self.denominator.clone(), self.numerator.clone());
        match self.sign() {
            Sign::Zero => None,
            Sign::Positive => Some(Rational { numerator, denominator }),
            Sign::Negative => Some(Rational { numerator: -numerator, denominator: -denominator }),
        }
    }

    /// The sum and the difference of two numbers. Exact. Cost: both take the common divisor of the denominators once.
    pub fn sum_and_difference(&self, other: &Self) -> (Self, Self) {
        let (Rational { numerator: a, denominator: b }, Rational { numerator: c, denominator: d }) =
            (self, other);
        let common = b.gcd(d);
        let (b_rest, d_rest) = (b.quotient(&common), d.quotient(&common));
        let (own, others) = (a * &d_rest, c * &b_rest);
        // Divisors of the sum and of the denominator are those of the common divisor: see `combined`.
        let over = |numerator: Integer| {
            let shared = numerator.gcd(&common);
            let denominator = &b_rest * d.quotient(&shared);
            Rational { numerator: numerator.quotient(&shared), denominator }
        };
        (over(&own + &others), over(own - others))
    }

    /// Half of the number.
    pub fn half(&self) -> Self {
        if self.numerator.is_even() {
            return Rational { numerator: self.numerator.halved(), denominator: self.denominator.clone() };
        }
        Rational { numerator: self.numerator.clone(), denominator: &self.denominator + &self.denominator }
    }
}

#[cfg(test)]
mod tests;
