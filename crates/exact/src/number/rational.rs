//! Rational numbers.

use std::cmp::Ordering;
use std::fmt;

use super::{Integer, Sign, number, operators};
use crate::short_text::ShortText;

/// A rational number in lowest terms with a positive denominator. Every operation is exact.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: Integer,
    denominator: Integer,
}

number!(Rational);
operators!(Rational: Add add sum_of, Sub sub difference_of, Mul mul product_of);

fn sum_of(left: &Rational, right: &Rational) -> Rational {
    combined(left, right, |own, other| own + other)
}

fn difference_of(left: &Rational, right: &Rational) -> Rational {
    combined(left, right, |own, other| own - other)
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
        let is_plain = f.width().is_none() && !f.sign_plus();
        if let (Some(numerator), Some(denominator), true) =
            (self.numerator.to_i128(), self.denominator.to_i128(), is_plain)
        {
            let mut text = ShortText::new();
            if numerator < 0 {
                text.push("-");
            }
            text.push_integer(numerator.unsigned_abs());
            if denominator != 1 {
                text.push("/");
                text.push_integer(denominator.unsigned_abs());
            }
            return f.write_str(text.as_str()?);
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

    /// Half of the number.
    pub fn half(&self) -> Self {
        if self.numerator.is_even() {
            return Rational { numerator: self.numerator.halved(), denominator: self.denominator.clone() };
        }
        Rational { numerator: self.numerator.clone(), denominator: &self.denominator + &self.denominator }
    }
}

#[cfg(test)]
mod tests {
    use super::super::library::{BigInt, BigRational};
    use super::*;

    #[test]
    fn lowest_terms_with_positive_denominator() {
        let number = Rational::new(Integer::from(6), Integer::from(-4)).unwrap();
        assert_eq!(number.to_string(), "-3/2");
        assert_eq!(number.denominator(), Integer::from(2));
        assert_eq!(Rational::new(Integer::one(), Integer::zero()), None);
        assert_eq!(Rational::ratio(8, 4).to_string(), "2");
        assert_eq!(format!("{number:>6}|{number:06}|{:+}", number.abs()), "  -3/2|-003/2|+3/2");
    }

    #[test]
    fn quotients_times_powers_of_ten_are_in_lowest_terms() {
        for numerator in [0_i128, 1, -75, 640, 10_i128.pow(30), -(1 << 100)] {
            for denominator in [1_i128, -3, 8, 125, 6_000, 7 * 10_i128.pow(25)] {
                for exponent in [-40, -3, -1, 0, 2, 17, 45] {
                    let number = Rational::scaled_quotient(numerator.into(), denominator.into(), exponent);
                    let quotient = Rational::new(numerator.into(), denominator.into()).unwrap();
                    assert_eq!(number, Some(quotient * Rational::scientific(1, exponent)));
                }
            }
        }
        assert_eq!(Rational::scaled_quotient(Integer::one(), Integer::zero(), 3), None);
    }

    #[test]
    fn decimals_are_in_lowest_terms() {
        let mantissas =
            [0, 1, -1, 5, 10, -25, 64, 1000, 12_345, 1 << 62, i64::MAX, i64::MIN, -10_i64.pow(18)];
        for mantissa in mantissas {
            for places in 0..=18 {
                let expected = Rational::new(mantissa.into(), Integer::power_of_ten(places)).unwrap();
                assert_eq!(Rational::of_decimal(mantissa, places), expected, "{mantissa}e-{places}");
            }
        }
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

    /// The library's operators are the reference, for terms on both sides of 63 and of 127 bits.
    #[test]
    fn all_sizes_agree_with_the_library() {
        let edges =
            [0, 1, -1, 2, -6, 97, i64::MAX.into(), i64::MIN.into(), i128::from(i64::MAX) + 1, 1 << 62]
                .into_iter()
                .chain([-(1 << 40), 1 << 100, i128::MAX, i128::MIN, i128::MAX - 1, i128::MIN + 1])
                .map(BigInt::from)
                .chain([BigInt::from(i128::MAX) + 1, BigInt::from(i128::MIN) - 1, BigInt::from(3) << 200]);
        let numerators: Vec<BigInt> = edges.collect();
        let denominators = [1, 2, 6, 1_000_000_007, i128::from(i64::MAX), i128::MAX - 1].map(BigInt::from);
        let numbers: Vec<BigRational> = numerators
            .iter()
            .flat_map(|n| denominators.iter().map(|d| BigRational::new(n.clone(), d.clone())))
            .collect();
        let own: Vec<Rational> = numbers.iter().cloned().map(Rational::from).collect();
        for (left, own_left) in numbers.iter().zip(&own) {
            assert_eq!(own_left.to_string(), left.to_string());
            assert_eq!(BigRational::from(&own_left.half()), left / BigInt::from(2));
            assert_eq!(BigRational::from(&-own_left), -left);
            assert!(!own_left.abs().is_negative());
            for (right, own_right) in numbers.iter().zip(&own) {
                assert_eq!(own_left + own_right, Rational::from(left + right));
                assert_eq!(own_left - own_right, Rational::from(left - right));
                assert_eq!(own_left * own_right, Rational::from(left * right));
                assert_eq!(own_left.cmp(own_right), left.cmp(right));
                assert_eq!(own_left == own_right, left == right);
                let quotient = own_left.checked_div(own_right);
                let expected = (!own_right.is_zero()).then(|| Rational::from(left / right));
                assert_eq!(quotient, expected);
            }
        }
    }

    #[test]
    fn integers_of_all_sizes_agree_with_the_library() {
        use super::super::library::DivisionAndGcd as _;
        let edges: Vec<BigInt> = [0, 1, -1, 2, -3, 12, i64::MAX.into(), i64::MIN.into(), 1 << 64, -(1 << 90)]
            .into_iter()
            .chain([i128::MAX, i128::MIN, i128::MIN + 1])
            .map(BigInt::from)
            .chain([BigInt::from(i128::MAX) + 1, BigInt::from(i128::MIN) - 1, BigInt::from(6) << 150])
            .collect();
        for left in &edges {
            let own_left = Integer::from(left.clone());
            assert_eq!(own_left.bits(), left.bits());
            assert_eq!(own_left.is_even(), left.is_even());
            assert_eq!(own_left.to_string(), left.to_string());
            let digits = left.magnitude().to_string();
            assert_eq!(Integer::from_ascii_digits(digits.as_bytes()), Some(own_left.abs()));
            for right in &edges {
                let own_right = Integer::from(right.clone());
                let of = |value: BigInt| Integer::from(value);
                assert_eq!(&own_left + &own_right, of(left + right));
                assert_eq!(&own_left - &own_right, of(left - right));
                assert_eq!(&own_left * &own_right, of(left * right));
                assert_eq!(own_left.cmp(&own_right), left.cmp(right));
                assert_eq!(own_left.gcd(&own_right), of(left.gcd(right)));
                assert_eq!(own_left.lcm(&own_right), of(left.lcm(right)));
                if !own_right.is_zero() {
                    let (quotient, remainder) = left.div_mod_floor(right);
                    let is_divisor = remainder == BigInt::from(0);
                    assert_eq!(own_left.div_rem_floor(&own_right), (of(quotient.clone()), of(remainder)));
                    if is_divisor {
                        assert_eq!(own_left.quotient(&own_right), of(quotient));
                    }
                }
            }
        }
    }

    #[test]
    fn floor_division_follows_the_divisor() {
        let (quotient, remainder) = Integer::from(-7).div_rem_floor(&Integer::from(2));
        assert_eq!((quotient, remainder), (Integer::from(-4), Integer::from(1)));
    }

    #[test]
    fn integers_and_words_are_the_same_number() {
        for value in [0, 7, -7, i64::MAX] {
            assert_eq!(Rational::from(&Integer::from(value)), Rational::ratio(value, 1));
            assert_eq!(Rational::from(value).to_words(), Some((value, 1)));
        }
        assert_eq!(Rational::ratio(-3, 4).to_words(), Some((-3, 4)));
        assert_eq!(Rational::from(&Integer::power_of_two(70)).to_words(), None);
    }
}
