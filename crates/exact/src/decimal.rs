//! Decimals out: rounded to a number of significant digits, in a stated direction.

mod enclosing;
mod finite;
mod plus_minus;
mod quotient;
mod words;

use std::fmt;

use crate::{Integer, Rational};

pub use plus_minus::{PlacedDecimal, PlusMinus};
pub use quotient::WideQuotient;

/// The direction in which a printed decimal may differ from the exact value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rounding {
    /// Rounds to the nearest, ties to the even last digit.
    Nearest,
    /// Rounds towards minus infinity: the decimal is never above the value.
    Down,
    /// Rounds towards plus infinity: the decimal is never below the value.
    Up,
}

impl Rounding {
    /// Returns whether a value that needs rounding is rounded away from zero; `None` when that depends on what is cut off.
    fn away_from_zero(self, is_negative: bool) -> Option<bool> {
        match self {
            Rounding::Nearest => None,
            Rounding::Down => Some(is_negative),
            Rounding::Up => Some(!is_negative),
        }
    }
}

/// The numerator and the positive denominator of a number, which may have common divisors.
type Quotient<'a> = (&'a Integer, &'a Integer);

/// A number as a decimal, see [`Rational::decimal`].
#[derive(Debug, Clone, Copy)]
pub struct Decimal<'a> {
    terms: Quotient<'a>,
    digits: usize,
    rounding: Rounding,
    /// The least exponent that is written without a power of ten.
    least_plain: i64,
    /// All digits, where they are known already, and what the first of them weighs.
    known: Option<(u64, i64)>,
}

/// People read 0.0005 more easily than 5e-4, as the `%g` of printf and R have it.
const LEAST_PLAIN: i64 = -4;
/// Programs need no zeros before the digits.
const COMPACT: i64 = -1;

/// Rounded digits of a number's absolute value.
struct Significand<T> {
    /// The digits, as many as asked for, as an integer.
    digits: T,
    /// The weight of the first digit, as a power of ten.
    exponent: i64,
    /// True if nothing was cut off.
    exact: bool,
}

impl Rational {
    /// The shortest decimal with at most `digits` significant digits (at least 1), rounded as asked.
    ///
    /// A value that `digits` digits hold is printed exactly, without trailing zeros; all other values get
    /// all `digits` digits. Scientific notation is used below 0.0001 and where positional notation would have to
    /// pad with zeros on the right. Rounded unless exact. Cost: one division of numbers of the value's size.
    ///
    /// ```
    /// use boundfit_exact::{Rational, Rounding};
    /// let value = Rational::ratio(21, 11726);
    /// assert_eq!(value.to_decimal(5, Rounding::Nearest), "0.0017909");
    /// assert_eq!(value.to_decimal(5, Rounding::Down), "0.0017908");
    /// assert_eq!(value.decimal(5, Rounding::Down).compact().to_string(), "1.7908e-3");
    /// assert_eq!(Rational::ratio(-3, 2).to_decimal(5, Rounding::Up), "-1.5");
    /// ```
    pub fn to_decimal(&self, digits: usize, rounding: Rounding) -> String {
        self.decimal(digits, rounding).to_string()
    }

    /// The decimal of [`Rational::to_decimal`] for writing into something that exists already. Takes no memory of its
    /// own for numbers of up to 128 bits.
    pub fn decimal(&self, digits: usize, rounding: Rounding) -> Decimal<'_> {
        let (numerator, denominator) = self.terms();
        Decimal::of_quotient(numerator, denominator, digits, rounding)
    }

    /// The decimal that so many significant digits hold exactly, if they do. Cost: one of [`Rational::to_decimal`].
    pub fn exact_decimal(&self, digits: usize) -> Option<Decimal<'_>> {
        if let Some(known) = finite::digits(self, digits.max(1)) {
            return Some(Decimal { known: Some(known), ..self.decimal(digits, Rounding::Down) });
        }
        let is_exact = self.is_zero() || significand_of(self.terms(), digits.max(1), Rounding::Down).exact;
        is_exact.then(|| self.decimal(digits, Rounding::Down))
    }

    /// Returns whether the number is a finite decimal, whatever its length. Cost: that of a power of five as long as the denominator.
    pub fn is_finite_decimal(&self) -> bool {
        self.denominator().powers_of_two_and_five().is_some()
    }

    /// All digits of the number in [compact](Decimal::compact) form, if it is a finite decimal. Exact. Cost: that of
    /// writing an integer as long as the result.
    ///
    /// ```
    /// use boundfit_exact::Rational;
    /// let digits = Rational::ratio(-1, 1 << 30).finite_decimal();
    /// assert_eq!(digits.as_deref(), Some("-9.31322574615478515625e-10"));
    /// assert_eq!(Rational::ratio(1, 3).finite_decimal(), None);
    /// ```
    pub fn finite_decimal(&self) -> Option<String> {
        let (digits, exponent) = finite::long_digits(self)?;
        let mut text = String::with_capacity(digits.len() + 8);
        Parts::new(&digits, exponent, true, COMPACT).write(self.is_negative(), &mut text).ok()?;
        Some(text)
    }

    /// The number that [`Rational::decimal`] says. Cost: one division of numbers of the value's size.
    pub fn rounded(&self, digits: usize, rounding: Rounding) -> Rational {
        if self.is_zero() {
            return Rational::zero();
        }
        let digits = digits.max(1);
        let Significand { digits: significand, exponent, .. } =
            significand_of(self.terms(), digits, rounding);
        let size = Rational::scientific(significand, exponent + 1 - digits as i64);
        if self.is_negative() { -size } else { size }
    }

    /// The number that [`Rational::decimal`] says as `mantissa · 10^exponent`, where so many digits are known from words. Exact.
    pub(crate) fn rounded_in_words(&self, digits: usize, rounding: Rounding) -> Option<(i64, i64)> {
        if self.is_zero() {
            return Some((0, 0));
        }
        let Significand { digits: found, exponent, .. } = words::significand(self.terms(), digits, rounding)?;
        let mantissa = i64::try_from(found).ok()?;
        Some((if self.is_negative() { -mantissa } else { mantissa }, exponent + 1 - digits as i64))
    }

    /// The power of ten that the first significant digit weighs, `floor(log10 |self|)`, or `None` for 0. Exact.
    pub fn decimal_exponent(&self) -> Option<i64> {
        let exponent = || words::exponent(self.terms()).unwrap_or_else(|| exponent_of(self.terms()));
        (!self.is_zero()).then(exponent)
    }
}

impl<'a> Decimal<'a> {
    /// The decimal of `numerator / denominator` as [`Rational::decimal`] has it. The denominator must be positive. A number that
    /// is only rounded need not be in lowest terms, so that it takes no greatest common divisor.
    ///
    /// ```
    /// use boundfit_exact::{Decimal, Integer, Rounding};
    /// let [numerator, denominator] = [-210, 117_260].map(Integer::from);
    /// assert_eq!(Decimal::of_quotient(&numerator, &denominator, 5, Rounding::Up).to_string(), "-0.0017908");
    /// ```
    pub fn of_quotient(
        numerator: &'a Integer,
        denominator: &'a Integer,
        digits: usize,
        rounding: Rounding,
    ) -> Self {
        let terms = (numerator, denominator);
        Decimal { terms, digits: digits.max(1), rounding, least_plain: LEAST_PLAIN, known: None }
    }

    /// This decimal as files for programs have it: below 0.1 with a power of ten, so that no zeros stand before its digits.
    #[must_use]
    pub fn compact(self) -> Self {
        Decimal { least_plain: COMPACT, ..self }
    }

    /// Writes the decimal, as the [`Display`](fmt::Display) form has it, without a formatter.
    ///
    /// # Errors
    /// The first error of what is written to.
    pub fn write_to(&self, out: &mut impl fmt::Write) -> fmt::Result {
        let Decimal { terms, digits, rounding, least_plain, known } = *self;
        let (numerator, _) = terms;
        if numerator.is_zero() {
            return out.write_str("0");
        }
        let known = known.map(|(digits, exponent)| Significand { digits, exponent, exact: true });
        match known.or_else(|| words::significand(terms, digits, rounding)) {
            Some(found) => {
                let mut digits = itoa::Buffer::new();
                let digits = digits.format(found.digits);
                Parts::new(digits, found.exponent, found.exact, least_plain)
                    .write(numerator.is_negative(), out)
            }
            None => {
                let found = long_significand(terms, digits, rounding);
                let digits = found.digits.to_string();
                Parts::new(&digits, found.exponent, found.exact, least_plain)
                    .write(numerator.is_negative(), out)
            }
        }
    }
}

impl fmt::Display for Decimal<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_to(f)
    }
}

/// The rounded significand of a number that is not 0.
fn significand_of(terms: Quotient<'_>, digits: usize, rounding: Rounding) -> Significand<Integer> {
    match words::significand(terms, digits, rounding) {
        Some(Significand { digits, exponent, exact }) => {
            Significand { digits: Integer::from(digits), exponent, exact }
        }
        None => long_significand(terms, digits, rounding),
    }
}

/// The rounded significand of a number that is not 0, whatever its size.
fn long_significand(terms: Quotient<'_>, digits: usize, rounding: Rounding) -> Significand<Integer> {
    let mut exponent = exponent_of(terms);
    let away_from_zero = rounding.away_from_zero(terms.0.is_negative());
    let (mut significand, exact) = significand(terms, exponent, digits, away_from_zero);
    if significand == Integer::power_of_ten(digits as u32) {
        significand = Integer::power_of_ten(digits as u32 - 1);
        exponent += 1;
    }
    Significand { digits: significand, exponent, exact }
}

/// `floor(log10 |numerator / denominator|)` of a number that is not 0.
fn exponent_of((numerator, denominator): Quotient<'_>) -> i64 {
    let numerator = numerator.abs();
    let bits = numerator.bits() as f64 - denominator.bits() as f64;
    // The estimate is off by less than one either way; the comparison below decides exactly.
    let estimate = (bits * std::f64::consts::LOG10_2).floor() as i64;
    let mut exponent = estimate - 1;
    while reaches_power_of_ten(&numerator, denominator, exponent + 1) {
        exponent += 1;
    }
    exponent
}

/// Returns whether `numerator / denominator >= 10^exponent`.
fn reaches_power_of_ten(numerator: &Integer, denominator: &Integer, exponent: i64) -> bool {
    let power = Integer::power_of_ten(exponent.unsigned_abs() as u32);
    if exponent >= 0 { numerator >= &(denominator * power) } else { numerator * power >= *denominator }
}

/// `|numerator / denominator| / 10^(exponent - digits + 1)` as a rounded integer, and whether nothing was lost.
fn significand(
    (numerator, denominator): Quotient<'_>,
    exponent: i64,
    digits: usize,
    away_from_zero: Option<bool>,
) -> (Integer, bool) {
    let shift = digits as i64 - 1 - exponent;
    let power = Integer::power_of_ten(shift.unsigned_abs() as u32);
    let (numerator, denominator) = if shift >= 0 {
        (numerator.abs() * power, denominator.clone())
    } else {
        (numerator.abs(), denominator * power)
    };
    let (floor, remainder) = numerator.div_rem_floor(&denominator);
    if remainder.is_zero() {
        return (floor, true);
    }
    let up = away_from_zero.unwrap_or_else(|| {
        let twice = &remainder + &remainder;
        twice > denominator || (twice == denominator && !floor.is_even())
    });
    (if up { floor + Integer::one() } else { floor }, false)
}

/// A decimal without its sign: `before`, the digits around the point, zeros or a power of ten after them.
struct Parts<'a> {
    before: &'static str,
    whole: &'a str,
    fraction: &'a str,
    zeros: &'static str,
    power: Option<i64>,
}

impl<'a> Parts<'a> {
    /// Returns the decimal of significant digits whose first one weighs `10^exponent`. Down to `least_plain`, at
    /// least -9, there is no power of ten below 1.
    fn new(digits: &'a str, exponent: i64, exact: bool, least_plain: i64) -> Self {
        let zeros = digits.bytes().rev().take_while(|&digit| digit == b'0').count();
        let digits = if exact { &digits[..digits.len() - zeros] } else { digits };
        let count = digits.len() as i64;
        let plain = Parts { before: "", whole: digits, fraction: "", zeros: "", power: None };
        match exponent {
            ..=-1 if exponent >= least_plain => {
                Parts { before: &"0.00000000"[..(1 - exponent) as usize], ..plain }
            }
            0.. if exponent < count => {
                let (whole, fraction) = digits.split_at(exponent as usize + 1);
                Parts { whole, fraction, ..plain }
            }
            // A short exact integer reads better as 20 than as 2e1.
            0..=5 if exact => Parts { zeros: &"00000"[..(exponent + 1 - count) as usize], ..plain },
            _ => {
                let (whole, fraction) = digits.split_at(1);
                Parts { whole, fraction, power: Some(exponent), ..plain }
            }
        }
    }

    fn write(&self, negative: bool, out: &mut impl fmt::Write) -> fmt::Result {
        let sign = if negative { "-" } else { "" };
        let point = if self.fraction.is_empty() { "" } else { "." };
        for part in [sign, self.before, self.whole, point, self.fraction, self.zeros] {
            if !part.is_empty() {
                out.write_str(part)?;
            }
        }
        match self.power {
            Some(power) => {
                out.write_str("e")?;
                out.write_str(itoa::Buffer::new().format(power))
            }
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests;
