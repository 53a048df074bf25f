//! Work that long numbers make, estimated from their lengths before it is done.
//!
//! The unit is a product of two words of 64 bits, of which a processor does about 10⁹ in a second. Sums, products,
//! quotients and common divisors of numbers of w words take at most some w² of them. A computation combines the
//! numbers of one reading with a few others, some tens of times for each reading. It adds fractions of all readings,
//! some tens of times, over a denominator that is at most the product of all that differ. So its work is within a
//! constant of
//!
//! 40 · Σ w² over readings of w words + 64 · d² for different denominators of d words together,
//!
//! with factors that were measured: what they estimate as 10⁹ takes from a third of a second to four. Some words of
//! both lengths are free, so that the estimate is 0 for rows of up to 1,800 digits, however many rows there are.
//! Their cost is linear in the bytes of a file, and needs no limit.

use std::collections::HashSet;
use std::sync::{Mutex, PoisonError};

use thiserror::Error;

use crate::english::counted;
use crate::{Integer, Rational};

/// The most products that are done unless more is asked for: about a second.
pub const MOST_WORK: u64 = 400_000_000;

/// The number of free words of a reading: two regressors, a response and two bounds. These are doubles of 17 digits
/// at the ends of their range, with numerators and denominators of 1,134 bits.
const FREE_WORDS: u64 = 96;
/// The number of words of a reading with usual numbers: three of 17 digits with exponents have a third of them.
const SHORT_WORDS: u64 = 16;
/// The divisor of a fit's work for each of many fits of the same readings.
const COMBINATIONS_LEFT_OUT: u64 = 4;
/// The number of free words of all different denominators together.
const FREE_DENOMINATOR_WORDS: u64 = 64;
/// The number of free products of the words of one number and of another one.
const FREE_PRODUCTS: u64 = 64 * 64;
const WORK_OF_READING: u64 = 40;
/// The ratio of the combinations of a reading's numbers in a fit to their products in a check.
const COMBINATIONS_PER_PRODUCT: u64 = 32;
const WORK_OF_DENOMINATOR: u64 = 64;

/// The work that numbers make, as far as they are long. The library's answers have no limit; a program that takes files from
/// anybody adds up what it is about to compute with, and then [checks](Work::check).
///
/// ```
/// use boundfit_exact::{MOST_WORK, Rational, Work};
///
/// let mut work = Work::default();
/// (1..1_000_000).for_each(|row| work.add(row, [&Rational::ratio(1, 3)]));
/// assert!(work.check(1, MOST_WORK).is_ok());
/// let long = Rational::scientific(1, 10_000);
/// (1..1_000).for_each(|row| work.add(row, [&long, &long]));
/// assert!(work.check(1, MOST_WORK).unwrap_err().to_string().starts_with("refused: exact arithmetic on 999 rows of up to 20002 digits"));
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    squares: u64,
    /// The squares of all rows that are not short, with their free words.
    all_squares: u64,
    /// The number of these rows.
    not_short: usize,
    long: usize,
    /// Bits and number of the row with the longest numbers.
    longest: (u64, usize),
    denominators: usize,
    denominator_bits: u64,
}

impl Work {
    /// Adds the numbers of a row, which are combined with each other. Cost: constant for each.
    pub fn add<'a>(&mut self, row: usize, numbers: impl IntoIterator<Item = &'a Rational>) {
        self.add_bits(row, numbers.into_iter().map(Rational::bits).sum());
    }

    /// Adds the numbers of a row, each of which is multiplied a few times by one of so many bits, and no more than that: what
    /// checking an answer takes. Cost: constant for each.
    pub fn add_products<'a>(
        &mut self,
        row: usize,
        numbers: impl IntoIterator<Item = &'a Rational>,
        other_bits: u64,
    ) {
        self.add_product_bits(row, numbers.into_iter().map(Rational::bits).sum(), other_bits);
    }

    fn add_product_bits(&mut self, row: usize, bits: u64, other_bits: u64) {
        let [words, other] = [bits, other_bits].map(|bits| bits.div_ceil(u64::BITS.into()).max(1));
        let beyond = words.saturating_mul(other).saturating_sub(FREE_PRODUCTS);
        if beyond == 0 {
            return;
        }
        self.squares = self.squares.saturating_add(beyond.div_ceil(COMBINATIONS_PER_PRODUCT));
        self.long += 1;
        if bits.max(other_bits) > self.longest.0 {
            self.longest = (bits.max(other_bits), row);
        }
    }

    /// The work of checking the numbers of a text that are written in full, whatever else it is, before any of them is built:
    /// the runs of its digits. Cost: linear.
    pub fn of_digits(text: &str) -> Self {
        let mut work = Work::default();
        for run in text.as_bytes().split(|byte| !byte.is_ascii_digit()) {
            // log2(10) is 3.3219.
            let bits = (run.len() as u64).saturating_mul(3_322) / 1_000;
            work.add_product_bits(0, bits, bits);
        }
        work
    }

    /// The work on these numbers as one row.
    pub fn of_numbers(numbers: &[&Rational]) -> Self {
        let mut work = Work::default();
        work.add(0, numbers.iter().copied());
        work
    }

    /// Adds other work of rows.
    pub fn append(&mut self, other: Work) {
        self.squares = self.squares.saturating_add(other.squares);
        self.all_squares = self.all_squares.saturating_add(other.all_squares);
        self.not_short += other.not_short;
        self.long += other.long;
        self.longest = self.longest.max(other.longest);
    }

    /// Returns whether numbers whose [bits](Rational::bits) add up to so many take no work.
    #[inline]
    pub fn is_short(bits: u64) -> bool {
        bits <= SHORT_WORDS * u64::from(u64::BITS)
    }

    /// As [`add`](Self::add), of numbers whose [bits](Rational::bits) add up to so many.
    #[inline]
    pub fn add_bits(&mut self, row: usize, bits: u64) {
        if !Work::is_short(bits) {
            self.add_long(row, bits);
        }
    }

    fn add_long(&mut self, row: usize, bits: u64) {
        let words = bits.div_ceil(u64::BITS.into());
        self.all_squares = self.all_squares.saturating_add(words.saturating_pow(2));
        self.not_short += 1;
        if bits > self.longest.0 {
            self.longest = (bits, row);
        }
        if words > FREE_WORDS {
            self.squares = self.squares.saturating_add((words - FREE_WORDS).saturating_pow(2));
            self.long += 1;
        }
    }

    /// The work on the numbers with exponents in a text, whatever else it is, before any of them is built: `1e9999`
    /// has six characters and ten thousand digits. Exponents beyond `most_exponent` are refused anyway. Cost: linear.
    pub fn of_text(text: &str, most_exponent: u32) -> Self {
        let mut work = Work::default();
        let bytes = text.as_bytes();
        for (place, _) in text.match_indices(['e', 'E', 'd', 'D']) {
            let (before, behind) = bytes.split_at(place);
            let behind = behind.get(1..).unwrap_or_default();
            let digits = behind.strip_prefix(b"-").or_else(|| behind.strip_prefix(b"+")).unwrap_or(behind);
            if !before.last().is_some_and(|byte| byte.is_ascii_digit() || *byte == b'.') {
                continue;
            }
            let digits = digits.iter().take_while(|byte| byte.is_ascii_digit());
            let value =
                |value: u64, digit: &u8| value.saturating_mul(10).saturating_add((digit - b'0').into());
            let exponent = digits.fold(0, value).min(most_exponent.into());
            // log2(10) is 3.3219.
            work.add_bits(0, exponent.saturating_mul(3_322) / 1_000);
        }
        work
    }

    /// The estimate for a computation that does all of it so many times, in products of two words.
    pub fn products(&self, times: u64) -> u64 {
        let denominators =
            self.denominator_bits.div_ceil(u64::BITS.into()).saturating_sub(FREE_DENOMINATOR_WORDS);
        let of_denominators = denominators.saturating_pow(2).saturating_mul(WORK_OF_DENOMINATOR);
        let of_readings = self.squares.saturating_mul(WORK_OF_READING);
        of_readings.saturating_add(of_denominators).saturating_mul(times)
    }

    /// Returns the work of as many fits of nearly all readings as there are readings. It grows with the square of
    /// their number, so the words that are free in one fit count.
    pub fn of_leaving_out_each(&self, readings: u64) -> Self {
        let squares = self.all_squares.saturating_mul(readings) / COMBINATIONS_LEFT_OUT;
        Work { squares, long: self.not_short, ..*self }
    }

    /// The work of something that takes so much more than a fit that the words which are free in one count.
    #[must_use]
    pub fn of_every_word(&self) -> Self {
        Work { squares: self.all_squares, long: self.not_short, ..*self }
    }

    /// Refuses what takes more products than this.
    ///
    /// # Errors
    /// With what is long.
    pub fn check(&self, times: u64, limit: u64) -> Result<(), TooMuchWork> {
        let products = self.products(times);
        if products <= limit {
            return Ok(());
        }
        let of_readings = self.squares.saturating_mul(WORK_OF_READING);
        let what = if of_readings.saturating_mul(2) >= self.products(1) {
            LongNumbers::Rows { count: self.long, digits: digits(self.longest.0), longest: self.longest.1 }
        } else {
            LongNumbers::Denominators { count: self.denominators, digits: digits(self.denominator_bits) }
        };
        Err(TooMuchWork { products, limit, what })
    }
}

/// Returns about how many digits numbers of so many bits have, not too few.
fn digits(bits: u64) -> u64 {
    // log10(2) is 0.30103.
    bits.saturating_mul(30_103) / 100_000 + 1
}

/// The work on numbers that are being read, one after the other and on many threads. Refused numbers have not been kept: long
/// numbers cost memory too, ten thousand digits of which are written in six characters.
#[derive(Debug, Default)]
pub struct WorkMeter(Mutex<Metered>);

#[derive(Debug, Default)]
struct Metered {
    work: Work,
    denominators: HashSet<Integer>,
}

impl WorkMeter {
    /// Adds the number of a cell, if it is long or a fraction `p/q`: decimals share their denominators. Cost: constant.
    ///
    /// # Errors
    /// When all numbers so far take more than `limit`.
    pub fn add(&self, number: &Rational, is_fraction: bool, limit: u64) -> Result<(), TooMuchWork> {
        let is_long = number.bits() > FREE_WORDS * u64::from(u64::BITS);
        if !is_long && !is_fraction {
            return Ok(());
        }
        // Counts are whole after every step.
        let mut metered = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let Metered { work, denominators } = &mut *metered;
        work.add(0, [number]);
        if is_fraction && denominators.insert(number.denominator()) {
            work.denominators += 1;
            work.denominator_bits += number.denominator().bits();
        }
        work.check(1, limit)
    }
}

/// More work than the limit allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("refused: exact arithmetic on {what} takes about {} products of machine words, more than {limit} (the limit)", rounded(*.products))]
pub struct TooMuchWork {
    /// The estimate.
    pub products: u64,
    /// The most that is done.
    pub limit: u64,
    /// The kind of numbers that are long.
    pub what: LongNumbers,
}

/// The reason why there is much work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LongNumbers {
    /// Rows with long numbers.
    Rows {
        /// The number of rows.
        count: usize,
        /// The approximate number of digits of the longest row's numbers together, above and below the bar.
        digits: u64,
        /// The number of the longest row; 0 where rows are not counted.
        longest: usize,
    },
    /// Fractions with denominators that differ.
    Denominators {
        /// The number of denominators.
        count: usize,
        /// The approximate number of their digits together.
        digits: u64,
    },
}

impl std::fmt::Display for LongNumbers {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match *self {
            LongNumbers::Rows { count, digits, longest: 0 } => {
                write!(f, "{} of up to {digits} digits", counted(count, "number", "numbers"))
            }
            LongNumbers::Rows { count, digits, longest } => {
                write!(f, "{} of up to {digits} digits (row {longest})", counted(count, "row", "rows"))
            }
            LongNumbers::Denominators { count, digits } => {
                write!(f, "fractions with {count} different denominators, {digits} digits together,")
            }
        }
    }
}

/// Two digits and a power of ten, such as `3.8e9`.
fn rounded(products: u64) -> String {
    format!("{:.1e}", products as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_usual_length_are_free_however_many() {
        let mut work = Work::default();
        let doubles = [f64::MAX, 5e-324].map(|double| Rational::from_f64(double).unwrap());
        let usual = Rational::scientific(12_345_678_901_234_567_i64, -20);
        (1..100_000).for_each(|row| work.add(row, [&usual; 3]));
        assert_eq!(work.of_leaving_out_each(100_000), Work::default());
        (1..100_000).for_each(|row| work.add(row, [&doubles[0], &doubles[1]]));
        let longest = Rational::scientific(12_345_678_901_234_567_i64, -324);
        work.add(1, [&longest; 5]);
        assert_eq!(work.products(1_000), 0);
        let meter = WorkMeter::default();
        let third = Rational::ratio(1, 3);
        for number in &doubles {
            assert_eq!(meter.add(number, false, 0), Ok(()));
        }
        (0..1_000).for_each(|_| assert_eq!(meter.add(&third, true, 0), Ok(())));
    }

    #[test]
    fn long_numbers_count_by_the_square_of_their_length() {
        let mut work = Work::default();
        let long = Rational::from(Integer::power_of_two(64 * (FREE_WORDS + 10) - 2));
        work.add(7, [&long]);
        assert_eq!(work.products(1), 100 * WORK_OF_READING);
        assert_eq!(work.products(3), 300 * WORK_OF_READING);
        assert_eq!(work.check(1, 4_000), Ok(()));
        let refused = work.check(1, 3_999).unwrap_err();
        assert_eq!(refused.what, LongNumbers::Rows { count: 1, digits: 2043, longest: 7 });
        assert_eq!(
            refused.to_string(),
            "refused: exact arithmetic on 1 row of up to 2043 digits (row 7) takes about 4.0e3 products of machine words, more than \
             3999 (the limit)"
        );
    }

    #[test]
    fn exponents_in_a_text_count_before_they_are_numbers() {
        let estimate = |text: &str| Work::of_text(text, 10_000).products(1);
        assert_eq!(estimate("x 1e9 + 2E300 <= -1.e+999, made by e9999 and 1edge"), 0);
        let one = estimate("1e10000");
        assert_eq!(one, 40 * (33_220_u64.div_ceil(64) - FREE_WORDS).pow(2));
        assert_eq!(estimate("{\"a\": 1.D-10000, \"b\": 7E+99999999999999999999}"), 2 * one);
    }

    #[test]
    fn products_of_long_numbers_with_others_count_by_both_lengths() {
        let bits = |words: u64| 64 * words - 2;
        let products = |words: u64, other: u64| {
            let mut work = Work::default();
            work.add_product_bits(3, bits(words), bits(other));
            work.products(1)
        };
        assert_eq!([products(64, 64), products(1, 4_096), products(2, 2_048)], [0; 3]);
        assert_eq!(products(100, 128), 40 * (100 * 128 - 64 * 64) / 32);
        let digits = |count: usize| Work::of_digits(&format!("[\"{}\", 7]", "1".repeat(count))).products(1);
        assert_eq!(digits(1_200), 0);
        assert_eq!(digits(10_000), 40 * (520 * 520 - 64 * 64) / 32);
    }

    #[test]
    fn leaving_out_each_of_some_readings_counts_what_is_free_in_one_fit() {
        let mut work = Work::default();
        let number = Rational::from(Integer::power_of_two(64 * 40 - 2));
        (0..200).for_each(|row| work.add(row, [&number]));
        assert_eq!(work.products(1_000), 0);
        assert_eq!(work.of_leaving_out_each(200).products(1), 40 * 200 * (200 * 40 * 40) / 4);
        assert_eq!(work.of_every_word().products(3), 3 * 40 * (200 * 40 * 40));
    }

    #[test]
    fn denominators_count_once_each() {
        let meter = WorkMeter::default();
        let fraction = |denominator: i64| Rational::ratio(1, denominator);
        let mut added = (1_000_000..).map(|denominator| meter.add(&fraction(denominator), true, 1_000));
        // 300 of 20 bits are 94 words, 30 more than are free.
        let position = added.position(|added| added.is_err()).unwrap();
        assert!((210..220).contains(&position), "{position}");
        let refused = meter.add(&fraction(7), true, 1_000).unwrap_err();
        assert!(refused.to_string().contains("different denominators"), "{refused}");
    }
}
