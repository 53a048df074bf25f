//! Long decimals in words of eighteen digits.

use std::cmp::Ordering;
use std::ops::Range;

use super::unit::Unit;
use crate::wide_sum::WideSum;
use crate::{Integer, Rational};

/// Digits of a word.
const WORD_DIGITS: i32 = 18;
/// The number above the largest count of a word.
const RADIX: i64 = 10_i64.pow(WORD_DIGITS as u32);
/// No number of a column takes more words, so that one long number among many short ones costs little memory.
pub(crate) const MOST_WORDS: usize = 16;

/// Decimals whose digits are kept in words of eighteen. Each word has the same place in all numbers: word `j` of a
/// number counts `10^(18·(place + j))`, and all words of a number have its sign. Numbers of different length are in
/// line without a product, their sums have no carries before the end, and they compare word by word.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Long {
    words: Vec<i64>,
    width: usize,
    place: i32,
}

/// The words of one number, the lowest first.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LongNumber {
    words: [i64; MOST_WORDS],
    width: usize,
    place: i32,
}

impl LongNumber {
    /// Returns the number with the words that count `10^(18·place)` and so on; `None` when there are too many.
    pub(crate) fn new(of: impl Iterator<Item = i64>, place: i32) -> Option<Self> {
        let (mut words, mut width) = ([0; MOST_WORDS], 0);
        for word in of {
            *words.get_mut(width)? = word;
            width += 1;
        }
        // Zeros in front need no room.
        let width = words.iter().rposition(|&word| word != 0).map_or(0, |top| top + 1);
        Some(LongNumber { words, width, place: if width == 0 { 0 } else { place } })
    }

    /// `count · 10^exponent`.
    fn of_count(count: i128, exponent: i32) -> Option<Self> {
        let radix = i128::from(RADIX);
        let place = exponent.div_euclid(WORD_DIGITS);
        let shift = i128::from(10_i64.pow(exponent.rem_euclid(WORD_DIGITS).unsigned_abs()));
        // In words before they move: three for the count, and one more for what moves beyond.
        let mut rest = count;
        let mut carry = 0;
        let words = std::iter::from_fn(|| {
            if rest == 0 && carry == 0 {
                return None;
            }
            // Less than 10^18 times 10^17 and what the word before left over.
            let moved = (rest % radix).wrapping_mul(shift).wrapping_add(carry);
            rest /= radix;
            carry = moved / radix;
            Some((moved % radix) as i64)
        });
        LongNumber::new(words, place)
    }

    fn words(&self) -> &[i64] {
        self.words.get(..self.width).unwrap_or_default()
    }
}

impl Long {
    fn new() -> Self {
        Long { words: Vec::new(), width: 0, place: 0 }
    }

    /// Returns a column of these counts of units; `None` when one is too long, or the unit no power of ten.
    pub(super) fn of_counts(counts: impl Iterator<Item = i128>, unit: Unit) -> Option<Self> {
        let exponent = match unit {
            Unit::Any => 0,
            Unit::TenTo(exponent) => exponent,
            Unit::OneOver(1) => 0,
            Unit::OneOver(_) => return None,
        };
        let mut column = Long::new();
        for count in counts {
            column.push(&LongNumber::of_count(count, exponent)?)?;
        }
        Some(column)
    }

    /// The number of numbers there are.
    pub fn len(&self) -> usize {
        self.words.len().checked_div(self.width).unwrap_or(0)
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// The words of each number, the lowest first.
    pub fn numbers(&self) -> impl ExactSizeIterator<Item = &[i64]> + Clone {
        self.words.chunks_exact(self.width.max(1))
    }

    /// The words of a number, the lowest first; none where there are not that many numbers.
    pub fn words(&self, index: usize) -> &[i64] {
        let start = index.saturating_mul(self.width);
        self.words.get(start..start.saturating_add(self.width)).unwrap_or_default()
    }

    /// Returns what the lowest words count.
    pub fn unit(&self) -> Unit {
        Unit::TenTo(self.place * WORD_DIGITS)
    }

    /// Returns how many words each number has.
    pub fn width(&self) -> usize {
        self.width
    }

    /// A number. Exact.
    pub(super) fn get(&self, index: usize) -> Rational {
        Rational::scientific(total(self.words(index)), self.place * WORD_DIGITS)
    }

    pub(super) fn part(&self, range: Range<usize>) -> Self {
        let range = range.start.saturating_mul(self.width)..range.end.saturating_mul(self.width);
        Long { words: self.words.get(range).unwrap_or_default().to_vec(), ..*self }
    }

    /// The numbers at these places; none at places beyond them.
    pub(super) fn at(&self, places: impl Iterator<Item = usize>) -> Self {
        Long { words: places.flat_map(|place| self.words(place)).copied().collect(), ..*self }
    }

    pub(super) fn reserve(&mut self, more: usize) {
        self.words.reserve_exact(more.saturating_mul(self.width));
    }

    /// Adds a number; `None` when the numbers would take too many words.
    pub(crate) fn push(&mut self, number: &LongNumber) -> Option<()> {
        let words = number.words();
        if self.width == 0 {
            (self.width, self.place) = (words.len().max(1), number.place);
        }
        // Where the number has words that the column does not.
        let below = self.place.saturating_sub(number.place).max(0);
        let top = |place: i32, width: usize| i64::from(place).saturating_add(width as i64);
        let above = top(number.place, words.len()).saturating_sub(top(self.place, self.width)).max(0);
        if (below > 0 || above > 0) && !words.is_empty() {
            self.widen(usize::try_from(below).ok()?, usize::try_from(above).ok()?)?;
        }
        let at = usize::try_from(number.place.saturating_sub(self.place)).unwrap_or(0);
        let start = self.words.len();
        self.words.resize(start + self.width, 0);
        if let Some(room) = self.words.get_mut(start + at..).and_then(|room| room.get_mut(..words.len())) {
            room.copy_from_slice(words);
        }
        Some(())
    }

    /// The number of these words as `count · 10^exponent` lowest units; `None` if its digits take more than two words.
    pub(super) fn short_count(words: &[i64]) -> Option<(i128, i32)> {
        let Some(low) = words.iter().position(|&word| word != 0) else { return Some((0, 0)) };
        let (own, above) = words.split_at_checked(low + 1)?;
        let (next, rest) = above.split_first().unwrap_or((&0, &[]));
        if rest.iter().any(|&word| word != 0) {
            return None;
        }
        let count = i128::from(*next).wrapping_mul(RADIX.into()).wrapping_add((*own.last()?).into());
        Some((count, low as i32 * WORD_DIGITS))
    }

    /// Adds so many units.
    pub(super) fn push_count(&mut self, count: i128, unit: Unit) -> Option<()> {
        match unit {
            Unit::Any | Unit::OneOver(1) => self.push(&LongNumber::of_count(count, 0)?),
            Unit::TenTo(exponent) => self.push(&LongNumber::of_count(count, exponent)?),
            Unit::OneOver(_) if count == 0 => self.push(&LongNumber::of_count(0, 0)?),
            Unit::OneOver(_) => None,
        }
    }

    /// Adds some of the numbers of another column; `None`, and none of them, when they would take too many words.
    pub(super) fn append(&mut self, other: &Long, range: Range<usize>) -> Option<()> {
        let before = self.len();
        for words in range.map(|index| other.words(index)) {
            let number = LongNumber::new(words.iter().copied(), other.place)?;
            if self.push(&number).is_none() {
                self.words.truncate(before * self.width);
                return None;
            }
        }
        Some(())
    }

    /// Makes room for so many more words of each number.
    #[cold]
    fn widen(&mut self, below: usize, above: usize) -> Option<()> {
        let width = self.width.checked_add(below)?.checked_add(above).filter(|&width| width <= MOST_WORDS)?;
        let mut words = vec![0; self.len() * width];
        for (room, own) in words.chunks_exact_mut(width).zip(self.numbers()) {
            if let Some(room) = room.get_mut(below..below + own.len()) {
                room.copy_from_slice(own);
            }
        }
        *self = Long { words, width, place: self.place - i32::try_from(below).ok()? };
        Some(())
    }

    /// Each number within 2^-50 of it, relatively; `None` where binary64 has no such numbers.
    pub(super) fn rounded(&self) -> Option<Vec<f64>> {
        let scales: Option<Vec<f64>> =
            (0..self.width as i32).map(|j| scale((self.place + j) * WORD_DIGITS)).collect();
        let scales = scales?;
        let round = |words: &[i64]| {
            let Some(top) = words.iter().rposition(|&word| word != 0) else { return 0.0 };
            let word = |j: usize| words.get(j).map_or(0.0, |&word| word as f64);
            // Lower words are less than 10^-18 of the number.
            let Some(next) = top.checked_sub(1) else { return word(0) * scales.first().unwrap_or(&0.0) };
            (word(top) * RADIX as f64 + word(next)) * scales.get(next).unwrap_or(&0.0)
        };
        Some(self.numbers().map(round).collect())
    }

    /// The words of the largest number of units that is not above a threshold, cut to those that the column has.
    pub fn floor_of(&self, threshold: &Rational) -> Vec<i64> {
        let Some(count) = threshold.checked_div(&self.unit().value()) else { return Vec::new() };
        let (mut rest, _) = count.numerator().div_rem_floor(&count.denominator());
        let is_negative = rest.is_negative();
        let radix = Integer::from(RADIX);
        let mut words = Vec::with_capacity(self.width);
        for _ in 0..self.width {
            let (quotient, remainder) = rest.abs().div_rem_floor(&radix);
            let word = remainder.to_i64().unwrap_or(0);
            words.push(if is_negative { -word } else { word });
            rest = if is_negative { -quotient } else { quotient };
        }
        if !rest.is_zero() {
            // Beyond all numbers of the column, on the side of its sign.
            words.fill(if is_negative { -RADIX } else { RADIX });
        }
        words
    }
}

/// `10^exponent` as the nearest binary64, unless products with it could overflow or underflow.
pub(super) fn scale(exponent: i32) -> Option<f64> {
    (-240..=200).contains(&exponent).then(|| Rational::scientific(1, exponent).to_f64())
}

/// Compares two numbers by their words, the lowest first, of which there are as many.
#[inline]
pub fn compare_words(left: &[i64], right: &[i64]) -> Ordering {
    left.iter().rev().cmp(right.iter().rev())
}

fn total(words: &[i64]) -> Integer {
    let radix = Integer::from(RADIX);
    words.iter().rev().fold(Integer::zero(), |total, &word| total * &radix + Integer::from(word))
}

/// A running sum of numbers of a [`Long`], word by word. Exact.
#[derive(Debug, Clone)]
pub struct LongTotal(Vec<WideSum>);

impl LongTotal {
    /// Returns an empty sum of numbers with so many words.
    pub fn new(width: usize) -> Self {
        LongTotal(vec![WideSum::default(); width])
    }

    /// Adds a number. Cost: an addition for each word.
    #[inline]
    pub fn add(&mut self, words: &[i64]) {
        self.0.iter_mut().zip(words).for_each(|(sum, &word)| sum.add(word.into()));
    }

    /// Returns how many of the units of the lowest words. Exact.
    pub fn total(&self) -> Integer {
        in_radix(&self.0)
    }
}

/// A running sum of products of two numbers of [`Long`]s. Exact.
#[derive(Debug, Clone)]
pub struct LongProducts(Vec<WideSum>);

impl LongProducts {
    /// Returns an empty sum of products of numbers with so many words.
    pub fn new(left: usize, right: usize) -> Self {
        LongProducts(vec![WideSum::default(); (left + right).saturating_sub(1)])
    }

    /// Adds `left * right`. Cost: a product for each pair of words.
    #[inline]
    pub fn add(&mut self, left: &[i64], right: &[i64]) {
        for (j, &own) in left.iter().enumerate() {
            let own = i128::from(own);
            for (sum, &other) in self.0.iter_mut().skip(j).zip(right) {
                sum.add(own.wrapping_mul(other.into()));
            }
        }
    }

    /// Returns how many of the product of the units of the lowest words. Exact.
    pub fn total(&self) -> Integer {
        in_radix(&self.0)
    }
}

fn in_radix(sums: &[WideSum]) -> Integer {
    let radix = Integer::from(RADIX);
    sums.iter().rev().fold(Integer::zero(), |total, sum| total * &radix + sum.total())
}

/// The digits of a decimal in words: a sign or none, digits with or without a point, an exponent or none, and nothing
/// else. `None` for everything else, and for what takes more than [`MOST_WORDS`] words.
pub(crate) fn long_number(text: &[u8]) -> Option<LongNumber> {
    /// The number of digits that `MOST_WORDS` words hold, wherever the point is.
    const MOST_DIGITS: usize = (MOST_WORDS - 1) * WORD_DIGITS as usize;
    let (negative, text) = match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, text),
    };
    let of_digits = |text: &[u8]| text.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let (whole, rest) = text.split_at_checked(of_digits(text))?;
    let (fraction, rest) = match rest {
        [b'.', rest @ ..] => rest.split_at_checked(of_digits(rest))?,
        _ => (<&[u8]>::default(), rest),
    };
    let written = match rest {
        [] => 0,
        [b'e' | b'E', rest @ ..] => {
            let (exponent, length) = crate::long_decimal::written_exponent(rest)?;
            (length == rest.len() + 1).then_some(exponent)?
        }
        _ => return None,
    };
    let count = whole.len() + fraction.len();
    if count == 0 || count > MOST_DIGITS {
        return None;
    }
    let mut digits = [b'0'; MOST_DIGITS];
    digits.get_mut(..whole.len())?.copy_from_slice(whole);
    digits.get_mut(whole.len()..count)?.copy_from_slice(fraction);
    let digits = digits.get(..count)?;
    let exponent = written - i32::try_from(fraction.len()).ok()?;
    let place = exponent.div_euclid(WORD_DIGITS);
    // The lowest word has the digits up to the next place only, in front of zeros.
    let zeros = exponent.rem_euclid(WORD_DIGITS).unsigned_abs();
    let (front, last) =
        digits.split_at_checked(count.saturating_sub((WORD_DIGITS as usize) - zeros as usize))?;
    let sign = if negative { -1 } else { 1 };
    let value = |digits: &[u8]| -> i64 {
        digits.iter().fold(0_i64, |value, digit| value.wrapping_mul(10).wrapping_add(i64::from(digit - b'0')))
    };
    let lowest = sign * value(last) * 10_i64.pow(zeros);
    let words =
        std::iter::once(lowest).chain(front.rchunks(WORD_DIGITS as usize).map(|own| sign * value(own)));
    LongNumber::new(words, place)
}

#[cfg(test)]
mod tests;
