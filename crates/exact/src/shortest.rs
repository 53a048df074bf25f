//! The shortest decimals of binary floats, without their text.
//!
//! A float c·2^q stands for all numbers that are nearer to it than to its neighbours. Let 10^k be the largest power
//! of ten that is not longer than this interval. The interval contains a multiple of 10^k and at most one multiple of
//! 10^(k+1). The latter, or else the nearer of the two multiples of 10^k beside the float, is the shortest decimal
//! (R. Giulietti, *The Schubfach way to render doubles*, 2020). The float and the ends of its interval are compared
//! with these multiples on integers, in quarters of 10^k. [`Scale::quarters`] tells where 192 bits are too few, so
//! that nothing rests on the rarity of that case.

use crate::binary64::{LEAST_EXPONENT, significand_and_exponent};
use crate::{Rational, plain_decimal};

/// Digits after the point up to which a power of ten is a double, so that a division by it rounds once.
const MOST_PLACES: usize = 22;
/// Powers of ten that are doubles.
const DOUBLES: [f64; MOST_PLACES + 1] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// The shortest decimal that is read as this binary64, and of those that are equally short the nearest one, as
/// `(mantissa, exponent)`, meaning `mantissa · 10^exponent`; `None` for an infinity or NaN. The mantissa has at most
/// 17 digits, and no zero at its end unless it is 0. If two such decimals are equally near it is the even one, as
/// Python and the libraries that write tables from it print it. The standard library of Rust takes the larger one.
///
/// ```
/// # use boundfit_exact::shortest_decimal;
/// assert_eq!(shortest_decimal(0.1), Some((1, -1)));
/// assert_eq!(shortest_decimal(1_732_372_800_000_000.25), Some((17_323_728_000_000_002, -1)));
/// assert_eq!(shortest_decimal(-2.0 / 3.0), Some((-6_666_666_666_666_666, -16)));
/// ```
pub fn shortest_decimal(value: f64) -> Option<(i64, i32)> {
    let (significand, exponent) = significand_and_exponent(value);
    let is_power = significand.unsigned_abs() == 1 << 52 && i64::from(exponent) > LEAST_EXPONENT;
    let shortest = || signed(shortest_of(significand.unsigned_abs(), exponent, is_power)?, significand < 0);
    value.is_finite().then(|| shortest().or_else(|| plain_decimal(format!("{value:e}").as_bytes()))).flatten()
}

/// The shortest decimal that is read as this float of 32 bits, like [`shortest_decimal`]; at most 9 digits.
pub fn shortest_decimal_of_f32(value: f32) -> Option<(i64, i32)> {
    const LEAST: i32 = -149;
    let (fraction, biased) = (value.to_bits() & ((1 << 23) - 1), (value.to_bits() >> 23 & 0xff) as i32);
    let (significand, exponent) =
        if biased == 0 { (fraction, LEAST) } else { (fraction | 1 << 23, biased - 150) };
    let is_power = significand == 1 << 23 && exponent > LEAST;
    let shortest = || signed(shortest_of(significand.into(), exponent, is_power)?, value.is_sign_negative());
    value.is_finite().then(|| shortest().or_else(|| plain_decimal(format!("{value:e}").as_bytes()))).flatten()
}

impl Rational {
    /// Returns the shortest decimal that is read as this number, if the number is exactly a binary64: `0.1` for the
    /// double that is stored when 0.1 is read. Returns `None` for all other numbers.
    ///
    /// ```
    /// # use boundfit_exact::Rational;
    /// assert_eq!(Rational::from_f64(0.1).unwrap().shortest_of_f64().unwrap(), Rational::ratio(1, 10));
    /// assert_eq!(Rational::ratio(1, 10).shortest_of_f64(), None);
    /// ```
    pub fn shortest_of_f64(&self) -> Option<Rational> {
        let double = self.to_finite_f64()?;
        let is_exact = Rational::from_f64(double).as_ref() == Some(self);
        let (mantissa, exponent) = shortest_decimal(double)?;
        is_exact.then(|| Rational::scientific(mantissa, exponent))
    }
}

/// A float that has a shortest decimal.
pub trait Shortest: Copy + std::fmt::Debug + std::fmt::Display + std::fmt::LowerExp {
    /// See [`shortest_decimal`].
    fn shortest(self) -> Option<(i64, i32)>;

    /// Returns what the standard library writes of this float by `{}`, `{:?}` or `{:e}`, with the digits of [`shortest_decimal`].
    ///
    /// ```
    /// # use boundfit_exact::Shortest;
    /// assert_eq!(0.25.in_shortest_digits(0.25.to_string()), "0.25");
    /// let stamp = 1_732_372_800_000_000.25;
    /// assert_eq!(stamp.in_shortest_digits(stamp.to_string()), "1732372800000000.2");
    /// ```
    fn in_shortest_digits(self, written: String) -> String {
        let (digits, exponent) = written.split_once('e').unwrap_or((&written, ""));
        // For two decimals that are equally near the standard library writes the upper one: the odd one, if it is not ours.
        let Some((rest, odd @ ('1' | '3' | '5' | '7' | '9'))) = last_character(digits) else {
            return written;
        };
        let is_ours =
            plain_decimal(written.as_bytes()).is_none_or(|written| Some(written) == self.shortest());
        if is_ours {
            return written;
        }
        let even = char::from(odd as u8 - 1);
        if exponent.is_empty() { format!("{rest}{even}") } else { format!("{rest}{even}e{exponent}") }
    }
}

impl Shortest for f64 {
    fn shortest(self) -> Option<(i64, i32)> {
        shortest_decimal(self)
    }
}

impl Shortest for f32 {
    fn shortest(self) -> Option<(i64, i32)> {
        shortest_decimal_of_f32(self)
    }
}

fn last_character(text: &str) -> Option<(&str, char)> {
    let last = text.chars().next_back()?;
    Some((text.strip_suffix(last)?, last))
}

/// A mantissa of at most 17 digits with its sign.
fn signed((mantissa, exponent): (u64, i32), is_negative: bool) -> Option<(i64, i32)> {
    let mantissa = mantissa as i64;
    Some((if is_negative { -mantissa } else { mantissa }, exponent))
}

/// Returns the shortest decimal of `significand · 2^exponent`, or `None` where the integers below do not tell. If the
/// number is a power of two, its neighbour below is half as far as the one above.
#[inline]
fn shortest_of(significand: u64, exponent: i32, is_power: bool) -> Option<(u64, i32)> {
    if significand == 0 {
        return Some((0, 0));
    }
    let scale = Scale::new(exponent, is_power);
    let [lower, value, upper] = scale.quarters(significand, is_power)?;
    // A number half way between two floats is read as the one whose significand is even.
    let open = significand & 1;
    let is_above = |multiple: u64| lower + open <= 4 * multiple;
    let is_below = |multiple: u64| 4 * multiple + open <= upper;
    let floor = value / 4;
    let tens = floor / 10;
    let (tens_above, tens_below) = (is_above(10 * tens), is_below(10 * tens + 10));
    let (floor_above, floor_below) = (is_above(floor), is_below(floor + 1));
    // The even one of two that are equally near: only a value that is exactly between them is an even number of quarters.
    let nearer = floor + u64::from(value + (floor & 1) > 4 * floor + 2);
    // No branches: whether digits are few is as good as random, and a wrong guess costs more than all of this.
    let one_of_two = floor + u64::from(floor_below);
    let multiple = if floor_above != floor_below { one_of_two } else { nearer };
    let is_of_tens = (tens > 0) & (tens_above != tens_below);
    let mantissa = if is_of_tens { tens + u64::from(tens_below) } else { multiple };
    Some(without_zeros(mantissa, scale.power + i32::from(is_of_tens)))
}

/// A power of ten, and how numbers are counted in quarters of it.
struct Scale {
    /// The unit is 10 to this power.
    power: i32,
    /// `10^-power` times a power of two, rounded down.
    inverse: u128,
    /// True if it has not been rounded.
    is_exact: bool,
    shift: i32,
}

impl Scale {
    /// The largest power of ten that is not longer than the interval of floats with this exponent: 2^exponent, and three quarters
    /// of it at a power of two.
    #[inline]
    #[allow(
        clippy::indexing_slicing,
        reason = "exponents from -1074 to 971 have powers from -324 to 292, for which there is a table; a test asks for all"
    )]
    fn new(exponent: i32, is_power: bool) -> Self {
        // floor(exponent · log10 2), also with log10 ¾ added, and floor(-power · log2 10): a test compares all with integers.
        let power = (exponent * 1_262_611 - if is_power { 524_031 } else { 0 }) >> 22;
        let shift = exponent + ((-power * 1_741_647) >> 19) + 1;
        let inverse = INVERSES[(MOST_POWER - power) as usize];
        Scale { power, inverse, is_exact: (0..=55).contains(&-power), shift }
    }

    /// Returns a float with this significand and the ends of its interval, from below, in quarters of the power of
    /// ten. Each is that integer, or else the odd one of the two integers beside it. Both compare with an even
    /// integer alike. `None` where the bits do not tell.
    ///
    /// The float is 4·significand quarters of 2^exponent, the ends are two more and two less, or one less. Each
    /// number n of these is n·2^shift·g/2^128 quarters of the power of ten; g = `inverse` is too small by less than
    /// 1, and n·2^shift is less than 2^60. The product is therefore too small by less than 2^60. So the quotient is
    /// no integer where there is a deficit, as long as the product does not come that close to the next integer.
    #[inline]
    fn quarters(&self, significand: u64, is_power: bool) -> Option<[u64; 3]> {
        let n = u128::from(significand << (self.shift + 2));
        let low = n * u128::from(self.inverse as u64);
        let value = (n * (self.inverse >> 64) + (low >> 64), low as u64);
        // The closure multiplies g by these powers of two, which are shifts by 2 to 5 bits.
        let times = |bits: i32| (self.inverse >> (64 - bits), (self.inverse << bits) as u64);
        let (half, below) = (times(self.shift + 1), times(self.shift + i32::from(!is_power)));
        let (rest, carries) = value.1.overflowing_add(half.1);
        let upper = (value.0 + half.0 + u128::from(carries), rest);
        let (rest, borrows) = value.1.overflowing_sub(below.1);
        let lower = (value.0 - below.0 - u128::from(borrows), rest);
        let quotients = [lower, value, upper];
        if self.is_exact {
            let odd = |(high, rest): (u128, u64)| (high >> 64) as u64 | u64::from(high as u64 | rest != 0);
            return Some(quotients.map(odd));
        }
        let is_clear = quotients.iter().all(|(high, _)| *high as u64 != u64::MAX);
        is_clear.then(|| quotients.map(|(high, _)| (high >> 64) as u64 | 1))
    }
}

/// The same number with the least mantissa.
#[inline]
fn without_zeros(mut mantissa: u64, mut exponent: i32) -> (u64, i32) {
    if !mantissa.is_multiple_of(10) {
        return (mantissa, exponent);
    }
    // From 17 digits none to 16 go.
    for zeros in [8, 4, 2, 1] {
        let power = 10_u64.pow(zeros);
        while mantissa.is_multiple_of(power) {
            mantissa /= power;
            exponent += zeros as i32;
        }
    }
    (mantissa, exponent)
}

/// The largest power of ten that is a scale.
const MOST_POWER: i32 = 292;
const LEAST_POWER: i32 = -324;
const SCALES: usize = (MOST_POWER - LEAST_POWER) as usize + 1;

/// The upper 128 bits of 10^-292 to 10^324.
static INVERSES: [u128; SCALES] = upper_bits_of_powers();

/// The test uses integers of 18 words, the lowest first.
#[allow(
    clippy::indexing_slicing,
    reason = "evaluated by the compiler, which would refuse an index out of range"
)]
const fn upper_bits_of_powers() -> [u128; SCALES] {
    const WORDS: usize = 18;
    let zero = MOST_POWER as usize;
    let mut powers = [0; SCALES];
    let mut number = [0; WORDS];
    number[0] = 1_u64;
    let mut exponent = zero;
    while exponent < SCALES {
        powers[exponent] = upper_bits(&number);
        let (mut carry, mut word) = (0, 0);
        while word < WORDS {
            let product = number[word] as u128 * 10 + carry;
            number[word] = product as u64;
            carry = product >> 64;
            word += 1;
        }
        exponent += 1;
    }
    // The number is a power of two divided by tens; rounding down often is rounding down once.
    number = [0; WORDS];
    number[WORDS - 1] = 1 << 63;
    exponent = zero;
    while exponent > 0 {
        let (mut remainder, mut word) = (0, WORDS);
        while word > 0 {
            word -= 1;
            let dividend = remainder << 64 | number[word] as u128;
            number[word] = (dividend / 10) as u64;
            remainder = dividend % 10;
        }
        exponent -= 1;
        powers[exponent] = upper_bits(&number);
    }
    powers
}

/// The 128 bits from the highest one that is set; with zeros below, where there are no more.
#[allow(
    clippy::indexing_slicing,
    reason = "evaluated by the compiler, which would refuse an index out of range"
)]
const fn upper_bits(number: &[u64; 18]) -> u128 {
    let mut top = number.len() - 1;
    while number[top] == 0 {
        top -= 1;
    }
    let zeros = number[top].leading_zeros();
    let second = if top > 0 { number[top - 1] } else { 0 };
    let third = if top > 1 { number[top - 2] } else { 0 };
    let upper = (number[top] as u128) << 64 | second as u128;
    if zeros == 0 { upper } else { upper << zeros | (third >> (64 - zeros)) as u128 }
}

/// Returns doubles as integers on the largest power of ten, 1 at most, that all their shortest decimals are multiples
/// of, with the number of its places. Returns `None` unless these integers have at most 15 digits, and there are at
/// most 22 places. Exact. Cost: about a nanosecond each, a few times where the first numbers have fewer places than
/// others.
///
/// Two decimals of at most 15 digits are never read as one double (W. Kahan's bound for binary64). So a double that such
/// a decimal is read as has no other, and this is its shortest one: all that is shorter has at most 15 digits too.
pub(crate) fn on_common_places(values: &[f64]) -> Option<(Vec<i64>, usize)> {
    let mut counts = Vec::with_capacity(values.len());
    let mut places = 0;
    while let Some(first) = first_off_scale(values, places, &mut counts) {
        let value = *values.get(first)?;
        places = (places + 1..=MOST_PLACES).find(|&places| is_on_scale(value, places))?;
    }
    Some((counts, places))
}

/// Counts so many places after the point of each number, up to the first that has more: its position.
fn first_off_scale(values: &[f64], places: usize, counts: &mut Vec<i64>) -> Option<usize> {
    const BLOCK: usize = 64;
    let scale = *DOUBLES.get(places)?;
    counts.clear();
    for (block, values) in values.chunks(BLOCK).enumerate() {
        let mut are_on_scale = true;
        counts.extend(values.iter().map(|&value| {
            let (count, is_on_scale) = count(value, scale);
            are_on_scale &= is_on_scale;
            count
        }));
        if !are_on_scale {
            let first = values.iter().position(|&value| !count(value, scale).1);
            return first.map(|first| block * BLOCK + first);
        }
    }
    None
}

fn is_on_scale(value: f64, places: usize) -> bool {
    DOUBLES.get(places).is_some_and(|&scale| count(value, scale).1)
}

/// Returns the integer of at most 15 digits whose quotient by a power of ten is the nearest to a double. Returns as
/// well whether the double is the nearest to this quotient. The division of two doubles is rounded to the nearest.
#[inline]
fn count(value: f64, scale: f64) -> (i64, bool) {
    /// Added to a number of at most 2^51, it leaves the nearest integer in the last bits of the sum.
    const ROUNDING: f64 = (3_u64 << 51) as f64;
    let sum = value * scale + ROUNDING;
    let integer = sum - ROUNDING;
    // Not `&&`, and no branch: many are looked at together.
    let is_on_scale = (integer / scale == value) & (integer.abs() < 1e15);
    (sum.to_bits().wrapping_sub(ROUNDING.to_bits()) as i64, is_on_scale)
}

#[cfg(test)]
mod tests;
