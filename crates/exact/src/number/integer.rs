//! Integers of any size.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::fmt;

use super::digits::write_words;
use super::gcd::gcd;
use super::lehmer::long_gcd;
use super::library::{BigInt, BigSign, DivisionAndGcd as _, ToPrimitive as _};
use super::{Sign, number, operators};
use crate::{Wide, powers_of_ten};

/// An integer of any size. Every operation is exact.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Integer(Size);

/// The form in which an integer is kept. A big one never fits into the small one.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Size {
    Small(Word),
    Big(Box<BigInt>),
}

/// 128 bits aligned to 64, which makes every number a quarter smaller: 24 bytes in place of 32.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[repr(C, packed(8))]
struct Word(i128);

impl Word {
    #[inline]
    fn get(self) -> i128 {
        self.0
    }
}

use Size::{Big, Small};

number!(Integer);
operators!(Integer: Add add sum_of, Sub sub difference_of, Mul mul product_of);

#[inline]
fn sum_of(left: &Integer, right: &Integer) -> Integer {
    if let (Some(left), Some(right)) = (left.word(), right.word())
        && let Some(sum) = left.checked_add(right)
    {
        return Integer::of_word(sum);
    }
    big_sum(left, right)
}

#[inline]
fn difference_of(left: &Integer, right: &Integer) -> Integer {
    if let (Some(left), Some(right)) = (left.word(), right.word())
        && let Some(difference) = left.checked_sub(right)
    {
        return Integer::of_word(difference);
    }
    big_difference(left, right)
}

#[inline]
fn product_of(left: &Integer, right: &Integer) -> Integer {
    if let (Some(left), Some(right)) = (left.word(), right.word())
        // A product of two 64-bit words needs no check, which costs more than the product.
        && let (Ok(left), Ok(right)) = (i64::try_from(left), i64::try_from(right))
    {
        return Integer::of_word(i128::from(left) * i128::from(right));
    }
    long_product(left, right)
}

// The rest is rare and stays out of the callers, which the short cases are compiled into.

#[cold]
fn big_sum(left: &Integer, right: &Integer) -> Integer {
    Integer::from_big(&*left.big() + &*right.big())
}

#[cold]
fn big_difference(left: &Integer, right: &Integer) -> Integer {
    Integer::from_big(&*left.big() - &*right.big())
}

#[inline(never)]
fn long_product(left: &Integer, right: &Integer) -> Integer {
    if let (Some(left), Some(right)) = (left.word(), right.word())
        && let Some(product) = left.checked_mul(right)
    {
        return Integer::of_word(product);
    }
    Integer::from_big(&*left.big() * &*right.big())
}

/// A sum of products of 64-bit words, where it fits.
#[inline]
fn word_sum(products: &[(&Integer, &Integer)]) -> Option<i128> {
    products.iter().try_fold(0_i128, |sum, (left, right)| {
        // As in [`product_of`].
        sum.checked_add(i128::from(left.to_i64()?) * i128::from(right.to_i64()?))
    })
}

/// A sum of at most four products, where these are so short that it fits.
fn wide_sum(products: &[(&Integer, &Integer)]) -> Option<Wide> {
    /// Bits of both factors of a product, so that four of them fit.
    const MOST_BITS: u64 = 252;
    let short = |integer: &Integer| integer.word().filter(|word| word.unsigned_abs() >> (MOST_BITS / 2) == 0);
    let mut sum = Wide::default();
    for (left, right) in products {
        let product = match (short(left), short(right)) {
            (Some(left), Some(right)) => Wide::product(left, right),
            _ if left.bits() + right.bits() <= MOST_BITS => &left.wide()? * &right.wide()?,
            _ => return None,
        };
        sum = sum + product;
    }
    Some(sum)
}

#[cold]
fn long_sum(products: &[(&Integer, &Integer)]) -> Integer {
    products.iter().map(|(left, right)| *left * *right).sum()
}

impl Ord for Integer {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        if let (Some(own), Some(other)) = (self.word(), other.word()) {
            return own.cmp(&other);
        }
        match (&self.0, &other.0) {
            (Small(_), Small(_)) => Ordering::Equal,
            (Big(own), Big(other)) => own.cmp(other),
            // Beyond all small numbers, on the side of its sign.
            (Big(own), Small(_)) => own.sign().cmp(&BigSign::NoSign),
            (Small(_), Big(other)) => BigSign::NoSign.cmp(&other.sign()),
        }
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let is_plain = f.width().is_none() && !f.sign_plus();
        match &self.0 {
            _ if is_plain => self.write_to(f),
            Small(value) => fmt::Display::fmt(&value.get(), f),
            Big(value) => fmt::Display::fmt(value, f),
        }
    }
}

macro_rules! from_primitive {
    ($($primitive:ty),*) => {$(
        impl From<$primitive> for Integer {
            #[inline]
            fn from(value: $primitive) -> Self {
                match i128::try_from(value) {
                    Ok(value) => Integer::of_word(value),
                    Err(_) => Integer(Big(Box::new(BigInt::from(value)))),
                }
            }
        }
    )*};
}

from_primitive!(i8, i16, i32, i64, i128, isize, u8, u16, u32, u64, u128, usize);

impl From<Wide> for Integer {
    #[inline]
    fn from(value: Wide) -> Self {
        let (high, low) = value.halves();
        match i128::try_from(low) {
            Ok(low) if high == 0 => Integer::of_word(low),
            _ => Integer::from(high) * Integer::power_of_two(128) + Integer::from(low),
        }
    }
}

impl Integer {
    /// Writes the digits, as the [`Display`](fmt::Display) form has them, without a formatter and, up to 256 bits, without memory.
    pub(super) fn write_to(&self, out: &mut impl fmt::Write) -> fmt::Result {
        match &self.0 {
            Small(value) => match i64::try_from(value.get()) {
                // Dividing 64 bits takes a third of the time.
                Ok(short) => out.write_str(itoa::Buffer::new().format(short)),
                Err(_) => out.write_str(itoa::Buffer::new().format(value.get())),
            },
            Big(value) => match self.words() {
                Some(words) => {
                    out.write_str(if self.is_negative() { "-" } else { "" })?;
                    write_words(out, words)
                }
                None => write!(out, "{value}"),
            },
        }
    }

    /// The number 0.
    #[inline]
    pub fn zero() -> Self {
        Integer::of_word(0)
    }

    /// The number 1.
    #[inline]
    pub fn one() -> Self {
        Integer::of_word(1)
    }

    /// Returns whether the number is less than, equal to or greater than 0.
    #[inline]
    pub fn sign(&self) -> Sign {
        match &self.0 {
            Small(value) => value.get().cmp(&0).into(),
            Big(value) => value.sign().cmp(&BigSign::NoSign).into(),
        }
    }

    #[inline]
    pub(super) fn negated(&self) -> Self {
        if let Some(value) = self.word()
            && let Some(negated) = value.checked_neg()
        {
            return Integer::of_word(negated);
        }
        Integer::from_big(-self.to_big())
    }

    /// 10 to the given power. Cost: the size of the result.
    pub fn power_of_ten(exponent: u32) -> Self {
        match powers_of_ten::OF_I128.get(exponent as usize) {
            Some(&power) => Integer::of_word(power),
            None => Integer::from_big(BigInt::from(10).pow(exponent)),
        }
    }

    /// The number of bits of [`Integer::power_of_ten`], without the power.
    pub fn bits_of_power_of_ten(exponent: u32) -> u64 {
        // log2(10) to 27 decimals: no multiple below 2^32 comes near enough to an integer for their error to matter.
        const LOG: u128 = 3_321_928_094_887_362_347_870_319_429;
        const UNIT: u128 = 10_u128.pow(27);
        (u128::from(exponent) * LOG / UNIT) as u64 + 1
    }

    /// 2 to the given power.
    pub fn power_of_two(exponent: u64) -> Self {
        Integer::from_big(BigInt::from(1) << exponent)
    }

    /// The non-negative greatest common divisor; `gcd(0, 0) = 0`.
    #[inline]
    pub fn gcd(&self, other: &Self) -> Self {
        if self.word() == Some(1) || other.word() == Some(1) { Integer::one() } else { self.long_gcd(other) }
    }

    #[inline(never)]
    fn long_gcd(&self, other: &Self) -> Self {
        match (&self.0, &other.0) {
            (Small(own), Small(other)) => {
                Integer::from(gcd(own.get().unsigned_abs(), other.get().unsigned_abs()))
            }
            (Small(word), Big(big)) | (Big(big), Small(word)) if word.get() != 0 => {
                // One division brings both down to words.
                let word = word.get().unsigned_abs();
                Integer::from(gcd((big.magnitude() % word).to_u128().unwrap_or_default(), word))
            }
            _ => Integer::from_big(long_gcd(self.big().magnitude(), other.big().magnitude()).into()),
        }
    }

    /// The non-negative least common multiple.
    #[inline]
    pub fn lcm(&self, other: &Self) -> Self {
        if self == other || other.word() == Some(1) { self.abs() } else { self.long_lcm(other) }
    }

    #[inline(never)]
    fn long_lcm(&self, other: &Self) -> Self {
        let divisor = self.gcd(other);
        if divisor.is_zero() { divisor } else { (self.quotient(&divisor) * other).abs() }
    }

    /// Quotient rounded down and the remainder, which has the sign of the divisor.
    ///
    /// # Panics
    /// When the divisor is 0.
    pub fn div_rem_floor(&self, divisor: &Self) -> (Self, Self) {
        // The least small number has no small opposite, so its quotient by -1 is big.
        if let (Some(own), Some(divisor)) = (self.word(), divisor.word())
            && own != i128::MIN
        {
            // A division of 64 bits is several times faster than one of 128.
            if let (Ok(own), Ok(divisor)) = (i64::try_from(own), i64::try_from(divisor))
                && own != i64::MIN
            {
                let (quotient, remainder) = own.div_mod_floor(&divisor);
                return (Integer::from(quotient), Integer::from(remainder));
            }
            let (quotient, remainder) = own.div_mod_floor(&divisor);
            return (Integer::of_word(quotient), Integer::of_word(remainder));
        }
        let (quotient, remainder) = self.big().div_mod_floor(&*divisor.big());
        (Integer::from_big(quotient), Integer::from_big(remainder))
    }

    /// The quotient by a divisor of the number. Cheaper than [`Integer::div_rem_floor`]; by anything else the result
    /// means nothing.
    ///
    /// # Panics
    /// When the divisor is 0.
    #[inline]
    pub fn quotient(&self, divisor: &Self) -> Self {
        if divisor.word() == Some(1) { self.clone() } else { self.divided(divisor) }
    }

    #[inline(never)]
    fn divided(&self, divisor: &Self) -> Self {
        match (self.word(), divisor.word()) {
            (Some(own), Some(divisor)) if own != i128::MIN => {
                match (i64::try_from(own), i64::try_from(divisor)) {
                    // As above; the least number by -1 does not fit.
                    (Ok(own), Ok(divisor)) if own != i64::MIN => Integer::from(own / divisor),
                    _ => Integer::of_word(own / divisor),
                }
            }
            _ => Integer::from_big(&*self.big() / &*divisor.big()),
        }
    }

    /// Half of an even number.
    pub(super) fn halved(&self) -> Self {
        match &self.0 {
            Small(value) => Integer::of_word(value.get() / 2),
            Big(value) => Integer::from_big(&**value >> 1),
        }
    }

    /// Returns whether the number is divisible by 2.
    pub fn is_even(&self) -> bool {
        match &self.0 {
            Small(value) => value.get() % 2 == 0,
            Big(value) => value.is_even(),
        }
    }

    /// Number of bits of the absolute value; 0 for 0.
    #[inline]
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Small(value) => u64::from(u128::BITS - value.get().unsigned_abs().leading_zeros()),
            Big(value) => value.bits(),
        }
    }

    /// The absolute value without its lowest bits, rounded down, when it fits.
    pub(crate) fn leading(&self, without: u64) -> Option<u128> {
        match &self.0 {
            Small(value) => Some(value.get().unsigned_abs().checked_shr(without as u32).unwrap_or_default()),
            Big(value) => {
                if self.bits().saturating_sub(without) > u64::from(u128::BITS) {
                    return None;
                }
                let (words, bits) = ((without / 64) as usize, without % 64);
                let mut words = value.iter_u64_digits().skip(words).map(u128::from);
                let mut next = || words.next().unwrap_or_default();
                let (low, middle, high) = (next(), next(), next());
                // Above the bits that are left there are none.
                Some(
                    (middle << 64 | low) >> bits
                        | (high << 64).checked_shl(64 - bits as u32).unwrap_or_default(),
                )
            }
        }
    }

    /// The words of the absolute value, the lowest first, when it has 256 bits at most.
    pub(super) fn words(&self) -> Option<[u64; 4]> {
        match &self.0 {
            Small(value) => {
                let magnitude = value.get().unsigned_abs();
                Some([magnitude as u64, (magnitude >> u64::BITS) as u64, 0, 0])
            }
            Big(value) => {
                let mut words = [0; 4];
                let mut own = value.iter_u64_digits();
                words.iter_mut().zip(own.by_ref()).for_each(|(word, digits)| *word = digits);
                own.next().is_none().then_some(words)
            }
        }
    }

    /// The lowest 64 bits of the value: the number modulo 2^64.
    #[inline]
    pub(super) fn lowest_word(&self) -> u64 {
        match &self.0 {
            Small(value) => value.get() as u64,
            Big(value) => {
                let magnitude = value.iter_u64_digits().next().unwrap_or_default();
                if self.is_negative() { magnitude.wrapping_neg() } else { magnitude }
            }
        }
    }

    /// The value in fixed memory, when it has 255 bits at most.
    pub(crate) fn wide(&self) -> Option<Wide> {
        let words = self.words().filter(|_| self.bits() < 256)?;
        Some(Wide::of_words(words).negated_if(self.is_negative()))
    }

    /// The value as `u64`, when it fits.
    pub fn to_u64(&self) -> Option<u64> {
        match &self.0 {
            Small(value) => u64::try_from(value.get()).ok(),
            Big(_) => None,
        }
    }

    /// The value as `i64`, when it fits.
    #[inline]
    pub fn to_i64(&self) -> Option<i64> {
        match &self.0 {
            Small(value) => i64::try_from(value.get()).ok(),
            Big(_) => None,
        }
    }

    /// The value as `i128`, when it fits.
    pub fn to_i128(&self) -> Option<i128> {
        match &self.0 {
            Small(value) => Some(value.get()),
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

    #[inline]
    fn of_word(value: i128) -> Self {
        Integer(Small(Word(value)))
    }

    /// Compares two sums of at most four products. Exact. Cost: takes no memory where no product has more than 252 bits.
    ///
    /// ```
    /// # use boundfit_exact::Integer;
    /// let [two, three] = [2, 3].map(Integer::from);
    /// assert!(Integer::compare([(&two, &two), (&two, &three)], [(&three, &three)]).is_gt());
    /// ```
    #[inline]
    pub fn compare<const N: usize, const M: usize>(
        left: [(&Integer, &Integer); N],
        right: [(&Integer, &Integer); M],
    ) -> Ordering {
        if let (Some(left), Some(right)) = (word_sum(&left), word_sum(&right)) {
            return left.cmp(&right);
        }
        match (wide_sum(&left), wide_sum(&right)) {
            (Some(left), Some(right)) => left.cmp(&right),
            _ => long_sum(&left).cmp(&long_sum(&right)),
        }
    }

    /// The value, when it is small.
    #[inline]
    fn word(&self) -> Option<i128> {
        match &self.0 {
            Small(word) => Some(word.get()),
            Big(_) => None,
        }
    }

    /// The library's form.
    pub(super) fn to_big(&self) -> BigInt {
        self.big().into_owned()
    }

    /// The library's form; that of a long number is there already.
    fn big(&self) -> Cow<'_, BigInt> {
        match &self.0 {
            Small(value) => Cow::Owned(BigInt::from(value.get())),
            Big(value) => Cow::Borrowed(value),
        }
    }

    pub(super) fn from_big(value: BigInt) -> Self {
        match value.to_i128() {
            Some(value) => Integer::of_word(value),
            None => Integer(Big(Box::new(value))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_divisors_are_those_of_the_library() {
        let edges = [0, 1, -6, 35 << 64, 3_i128.pow(70), i128::MIN, i128::MAX].map(Integer::from);
        let products = edges.iter().flat_map(|own| edges.iter().map(move |other| own * other));
        let all: Vec<Integer> = edges.iter().cloned().chain(products).collect();
        for left in &all {
            for right in &all {
                let expected = Integer::from_big(left.big().gcd(&right.big()));
                assert_eq!(left.gcd(right), expected, "{left} {right}");
            }
        }
    }

    #[test]
    fn bits_of_powers_of_ten_are_those_of_the_powers() {
        for exponent in (0..2_000).chain([9_999, 40_000]) {
            assert_eq!(Integer::bits_of_power_of_ten(exponent), Integer::power_of_ten(exponent).bits());
        }
    }

    #[test]
    fn sums_of_products_compare_alike_at_every_length() {
        let [one, two, three] = [1, 2, -3].map(Integer::from);
        for bits in [1, 60, 62, 64, 124, 126, 127, 128, 190, 248, 250, 251, 252, 255, 256, 300] {
            let long = Integer::power_of_two(bits) + Integer::one();
            let opposite = -&long;
            let compared = |more: &Integer| {
                Integer::compare([(&long, &two), (&long, &one)], [(&opposite, &three), (more, &one)])
            };
            assert_eq!(compared(&Integer::zero()), Ordering::Equal, "{bits}");
            assert_eq!([compared(&one), compared(&-&one)], [Ordering::Less, Ordering::Greater], "{bits}");
        }
    }
}
