//! Plain decimals as integers times powers of ten, read fast.

use crate::powers_of_ten;

/// The most digits of a text that [`plain_decimal`] reads, zeros included.
pub const PLAIN_DIGITS: usize = 40;
/// The largest absolute value of an exponent in a text that [`plain_decimal`] reads.
pub const PLAIN_EXPONENT: u32 = 999;

/// Returns a decimal (digits with an optional sign, point and exponent, in blanks or not) as `(mantissa, exponent)`,
/// meaning `mantissa · 10^exponent`. The mantissa must fit an `i64`, and the text must keep to [`PLAIN_DIGITS`] and
/// [`PLAIN_EXPONENT`]. The exponent is that of the last digit written; for zero it is 0.
///
/// `None` says nothing about whether the text is a number: [`Reading::read`](crate::Reading::read) tells. Exact.
pub fn plain_decimal(text: &[u8]) -> Option<(i64, i32)> {
    let text = text.trim_ascii();
    let text = text.strip_prefix(b"+").filter(|rest| !rest.starts_with(b"-")).unwrap_or(text);
    let prefix = plain_prefix(text).or_else(|| long_prefix(text))?;
    let exponent = match text.get(prefix.length..)? {
        [] => 0,
        [b'e' | b'E', exponent @ ..] => written_exponent(exponent)?,
        _ => return None,
    };
    let PlainPrefix { mantissa, fraction_digits, .. } = prefix;
    Some(if mantissa == 0 { (0, 0) } else { (mantissa, exponent - fraction_digits) })
}

/// The number at the start of a text: `mantissa · 10^-fraction_digits`, written in `length` bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlainPrefix<M = i64> {
    /// All digits, with the sign.
    pub mantissa: M,
    /// The number of digits after the point.
    pub fraction_digits: i32,
    /// The number of bytes that were read: up to the first that is no digit.
    pub length: usize,
}

/// Reads the digits, with or without a minus sign and a point, at the start of a text: from 1 to 18 of them, or 19 where
/// the mantissa fits. `None` when there are none, and for most texts with more. Exact. Cost: a few nanoseconds.
#[inline(always)]
pub fn plain_prefix(text: &[u8]) -> Option<PlainPrefix> {
    text.first_chunk().and_then(lone_prefix).or_else(|| other_prefix(text))
}

/// [`short_prefix`] of a text whose other bytes are not known. To learn them first takes longer.
#[inline(always)]
#[allow(clippy::indexing_slicing, reason = "at most seven digits, which the compiler sees")]
fn lone_prefix(text: &[u8; 32]) -> Option<PlainPrefix> {
    let negative = text[0] == b'-';
    // Both are at hand before the sign is known.
    let words = [text.first_chunk()?, text[1..].first_chunk()?].map(|bytes| u64::from_le_bytes(*bytes));
    let (whole, whole_digits, next) = short_digits(if negative { words[1] } else { words[0] })?;
    let (mut length, mut fraction, mut fraction_digits) =
        (usize::from(negative).wrapping_add(whole_digits), 0, 0);
    if next == b'.' {
        let start = length.wrapping_add(1);
        (fraction, fraction_digits, _) =
            short_digits(u64::from_le_bytes(*text.get(start..)?.first_chunk()?))?;
        length = start.wrapping_add(fraction_digits);
    }
    let short = ShortPrefix { negative, whole, fraction, fraction_digits, length };
    (whole_digits + fraction_digits > 0).then_some(short.into())
}

/// A number of up to seven digits on either side of the point: `whole + fraction · 10^-fraction_digits`, negative or not.
#[derive(Debug, Clone, Copy)]
pub struct ShortPrefix {
    /// `true` behind a minus sign.
    pub(crate) negative: bool,
    /// The digits before the point.
    pub(crate) whole: u64,
    /// The digits after the point.
    pub(crate) fraction: u64,
    /// The number of digits after the point.
    pub(crate) fraction_digits: usize,
    /// The number of bytes that were read: up to the first that is no digit.
    pub length: usize,
}

impl From<ShortPrefix> for PlainPrefix {
    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "at most seven digits")]
    fn from(short: ShortPrefix) -> Self {
        let ShortPrefix { negative, whole, fraction, fraction_digits, length } = short;
        let magnitude = whole.wrapping_mul(powers_of_ten::OF_U64[fraction_digits]).wrapping_add(fraction);
        let mantissa = signed(magnitude, negative);
        PlainPrefix { mantissa, fraction_digits: fraction_digits as i32, length }
    }
}

/// A magnitude of less than 64 bits with its sign, without a branch.
#[inline(always)]
pub(crate) fn signed(magnitude: u64, negative: bool) -> i64 {
    let flip = i64::from(negative).wrapping_neg();
    (magnitude as i64 ^ flip).wrapping_sub(flip)
}

/// [`plain_prefix`] of up to seven digits on either side of the point; `None` for all others, and for a few of these. `others` has
/// the bits of [`Others::behind`]. Most numbers are such ones. To know that none of them leaves these bytes halves the instructions.
#[inline(always)]
#[allow(clippy::indexing_slicing, reason = "at most seven digits, which the compiler sees")]
pub fn short_prefix(text: &[u8; 32], others: u64) -> Option<ShortPrefix> {
    let word = |at: usize| Some(u64::from_le_bytes(*text.get(at..)?.first_chunk()?));
    let negative = text[0] == b'-';
    let start = usize::from(negative);
    let others = others >> start;
    let whole_digits = others.trailing_zeros() as usize;
    if whole_digits > SHORT_DIGITS {
        return None;
    }
    let point = start + whole_digits;
    let whole = first_digits(word(start)?, whole_digits);
    if text[point] != b'.' {
        let short = ShortPrefix { negative, whole, fraction: 0, fraction_digits: 0, length: point };
        return (whole_digits > 0).then_some(short);
    }
    let fraction_digits = (others >> 1 >> whole_digits).trailing_zeros() as usize;
    if fraction_digits > SHORT_DIGITS || whole_digits + fraction_digits == 0 {
        return None;
    }
    let fraction = first_digits(word(point + 1)?, fraction_digits);
    Some(ShortPrefix { negative, whole, fraction, fraction_digits, length: point + 1 + fraction_digits })
}

/// The bytes of a text that are no digits, a part of the text at a time. They say where numbers end before anyone reads a digit:
/// finding the end of each number by its digits, and from there the next number, takes longer.
#[derive(Debug, Default)]
pub struct Others {
    /// The place of the part in the text.
    start: usize,
    /// A bit for each byte, 1 where it is no digit.
    bits: Vec<u8>,
}

impl Others {
    /// Bytes that are looked at together.
    const PART: usize = 4096;

    /// Returns the bits of the bytes from a place on, the first one lowest, of 57 bytes at least; behind the end of the text they
    /// are 1. It is always asked about the same text.
    #[inline(always)]
    pub fn behind(&mut self, text: &[u8], at: usize) -> u64 {
        let place = at.wrapping_sub(self.start);
        match self.bits.get(place / 8..).and_then(<[u8]>::first_chunk) {
            Some(bits) => u64::from_le_bytes(*bits) >> (place % 8),
            None => self.look(text, at),
        }
    }

    /// Looks at the part from a place on.
    #[inline(never)]
    fn look(&mut self, text: &[u8], at: usize) -> u64 {
        let rest = text.get(at..).unwrap_or_default();
        let (words, _) = rest.get(..Self::PART).unwrap_or(rest).as_chunks();
        self.start = at;
        self.bits.clear();
        self.bits.extend(words.iter().map(|word| bits_of_others(u64::from_le_bytes(*word)) as u8));
        match self.bits.first_chunk() {
            Some(bits) => u64::from_le_bytes(*bits),
            None => u64::MAX,
        }
    }
}

/// The most digits on either side of the point of a short number.
const SHORT_DIGITS: usize = 7;

/// The number that up to seven digits at the start of eight bytes spell.
#[inline(always)]
fn first_digits(bytes: u64, digits: usize) -> u64 {
    // They move to the high end, with zeros below: in two steps, as there may be none.
    value_of_digits(((bytes ^ DIGIT_ZEROS) << (8 * (SHORT_DIGITS - digits))) << 8)
}

/// Eight bits, one for each of eight bytes that is no digit, the first one lowest.
#[inline(always)]
fn bits_of_others(bytes: u64) -> u64 {
    // The product moves the lowest bit of each byte to a place of its own in the highest byte.
    (digits_and_others(bytes).1 >> 7).wrapping_mul(0x0102_0408_1020_4080) >> 56
}

/// The number that the digits at the start of eight bytes spell, how many these are, and the first other byte, if there is one.
#[inline(always)]
fn short_digits(bytes: u64) -> Option<(u64, usize, u8)> {
    let (values, others) = digits_and_others(bytes);
    if others == 0 {
        return None;
    }
    // The digits before the first other byte move to the high end, with zeros below: in two steps, as there may be none.
    let last = others.trailing_zeros();
    let digits = (values << (63 - last)) << 8;
    Some((value_of_digits(digits), (last / 8) as usize, (bytes >> (last - 7)) as u8))
}

/// Eight times the digit 0.
const DIGIT_ZEROS: u64 = 0x3030_3030_3030_3030;

/// Eight bytes in which digits have become their values, and a word with the high bit of every other byte.
#[inline(always)]
fn digits_and_others(bytes: u64) -> (u64, u64) {
    const LOW_BITS: u64 = 0x7f7f_7f7f_7f7f_7f7f;
    // Digits become 0 to 9; every other byte becomes 10 or more.
    let values = bytes ^ DIGIT_ZEROS;
    // 118 more sets the high bit of what is 10 to 127, and carries into no other byte; from 128 on it is set already.
    (values, ((values & LOW_BITS).wrapping_add(0x7676_7676_7676_7676) | values) & !LOW_BITS)
}

#[inline(never)]
fn other_prefix(text: &[u8]) -> Option<PlainPrefix> {
    let PlainPrefix { mantissa, fraction_digits, length } = long_plain_prefix(text)?;
    Some(PlainPrefix { mantissa: i64::try_from(mantissa).ok()?, fraction_digits, length })
}

/// Reads like [`plain_prefix`], up to a magnitude of 64 bits; sooner where numbers have 16 digits or more.
#[inline(always)]
pub fn long_plain_prefix(text: &[u8]) -> Option<PlainPrefix<i128>> {
    text.first_chunk().and_then(long_word_prefix).or_else(|| digits_prefix(text))
}

/// [`long_plain_prefix`] of 16 digits or more, with the point among the first eight bytes or none; `None` for all others. No branch
/// depends on the number of digits, which differs from cell to cell where doubles are written.
#[inline(always)]
#[allow(clippy::indexing_slicing, reason = "at most seven digits, which the compiler sees")]
fn long_word_prefix(text: &[u8; 32]) -> Option<PlainPrefix<i128>> {
    let negative = text[0] == b'-';
    let start = usize::from(negative);
    let (words, _) = text.get(start..)?.first_chunk::<24>()?.as_chunks();
    let &[first, second, third] = words.first_chunk()?;
    let [mut first, mut second, mut third] = [first, second, third].map(u64::from_le_bytes);
    let (_, others) = digits_and_others(first);
    let point = others.trailing_zeros() / 8;
    let has_point = others != 0;
    if has_point {
        if first.wrapping_shr(8 * point) as u8 != b'.' {
            return None;
        }
        // The digits behind the point move to its place.
        let before = 1_u64.wrapping_shl(8 * point).wrapping_sub(1);
        first = first & before | first >> 8 & !before | second << 56;
        second = second >> 8 | third << 56;
        // More digits may follow behind the three words.
        third = third >> 8 | u64::from(b'0') << 56;
    }
    let [(first, others), (second, more), (third, last)] = [first, second, third].map(digits_and_others);
    if others | more != 0 || last == 0 {
        return None;
    }
    let last = last.trailing_zeros();
    let count = (last / 8) as usize;
    let magnitude = value_of_digits(first)
        .wrapping_mul(powers_of_ten::OF_U64[8])
        .wrapping_add(value_of_digits(second))
        .checked_mul(powers_of_ten::OF_U64[count])?
        .checked_add(value_of_digits((third << (63 - last)) << 8))?;
    let magnitude = i128::from(magnitude);
    let mantissa = if negative { magnitude.wrapping_neg() } else { magnitude };
    let digits = 16_usize.wrapping_add(count);
    let fraction_digits = if has_point { digits as i32 - point as i32 } else { 0 };
    Some(PlainPrefix { mantissa, fraction_digits, length: start + digits + usize::from(has_point) })
}

/// Reads like [`long_plain_prefix`], eight digits at a time.
#[inline(never)]
fn digits_prefix(text: &[u8]) -> Option<PlainPrefix<i128>> {
    let negative = text.first() == Some(&b'-');
    let start = usize::from(negative);
    let (mut magnitude, whole_digits) = digits(text, start, 0);
    let mut length = start + whole_digits;
    let mut fraction_digits = 0;
    if text.get(length) == Some(&b'.') {
        (magnitude, fraction_digits) = digits(text, length + 1, magnitude);
        length += 1 + fraction_digits;
    }
    if !(1..=MOST_DIGITS).contains(&(whole_digits + fraction_digits)) {
        return None;
    }
    let magnitude = i128::from(magnitude);
    let mantissa = if negative { magnitude.wrapping_neg() } else { magnitude };
    Some(PlainPrefix { mantissa, fraction_digits: fraction_digits as i32, length })
}

/// An exponent behind the digits, from its `e` on to the first byte that is no digit: its value, and how many bytes it has.
/// `None` where there is none, or more than three digits. Exact.
#[inline]
pub fn exponent_prefix(text: &[u8]) -> Option<(i32, usize)> {
    let word = next_eight_bytes(text, 0);
    let [letter, sign, ..] = word.to_le_bytes();
    // No branch depends on the sign, which differs from cell to cell.
    let has_sign = matches!(sign, b'-' | b'+');
    let (magnitude, digits, _) = short_digits(word >> if has_sign { 16 } else { 8 })?;
    let length = 1 + usize::from(has_sign) + digits;
    let exponent = if sign == b'-' { -(magnitude as i32) } else { magnitude as i32 };
    let is_exponent = matches!(letter, b'e' | b'E') && (1..=MOST_EXPONENT_DIGITS).contains(&digits);
    is_exponent.then_some((exponent, length))
}

/// The number of digits of an exponent that keep to [`PLAIN_EXPONENT`].
const MOST_EXPONENT_DIGITS: usize = 3;

/// The number of digits that always fit a `u64`.
const MOST_DIGITS: usize = powers_of_ten::OF_U64.len() - 1;

/// The number that some digits spell when those from a position on follow them, and how many these are. Beyond 19 digits in
/// all it is another number, and not all may have been counted.
#[inline(always)]
#[allow(clippy::indexing_slicing, reason = "fewer than eight digits, and nine powers or more")]
fn digits(text: &[u8], at: usize, before: u64) -> (u64, usize) {
    let (mut value, mut count) = (before, 0);
    loop {
        let word = next_eight_bytes(text, at.wrapping_add(count));
        if let Some((more, digits, _)) = short_digits(word) {
            value = value.wrapping_mul(powers_of_ten::OF_U64[digits]).wrapping_add(more);
            return (value, count + digits);
        }
        let (values, _) = digits_and_others(word);
        value = value.wrapping_mul(powers_of_ten::OF_U64[8]).wrapping_add(value_of_digits(values));
        count += 8;
        if count > MOST_DIGITS {
            return (value, count);
        }
    }
}

/// The number that eight digits spell, the first one in the lowest byte (Lemire, *Quickly parsing eight digits*, 2018).
#[inline(always)]
pub(crate) fn value_of_digits(values: u64) -> u64 {
    // Neighbours are joined: eight digits, four pairs, two fours. Every sum stays within its part of the word, and what
    // a product carries beyond the word is not needed.
    let pairs = (values.wrapping_mul(1 + (10 << 8)) >> 8) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs.wrapping_mul(1 + (100 << 16)) >> 16) & 0x0000_ffff_0000_ffff;
    fours.wrapping_mul(1 + (10_000 << 32)) >> 32
}

/// Eight bytes as a word, the first one lowest; behind the end of the text there are zeros.
#[inline(always)]
pub(crate) fn next_eight_bytes(text: &[u8], at: usize) -> u64 {
    let rest = text.get(at..).unwrap_or_default();
    match rest.first_chunk() {
        Some(bytes) => u64::from_le_bytes(*bytes),
        None => last_bytes(rest),
    }
}

#[cold]
fn last_bytes(rest: &[u8]) -> u64 {
    rest.iter().rev().fold(0, |word, &byte| word << 8 | u64::from(byte))
}

/// Reads like [`plain_prefix`], for up to 40 digits whose value fits; slower.
fn long_prefix(text: &[u8]) -> Option<PlainPrefix> {
    let negative = text.first() == Some(&b'-');
    let start = usize::from(negative);
    let (mut magnitude, mut point, mut length) = (0_u64, None, start);
    while let Some(&byte) = text.get(length) {
        match byte {
            b'0'..=b'9' => magnitude = magnitude.checked_mul(10)?.checked_add(u64::from(byte - b'0'))?,
            b'.' if point.is_none() => point = Some(length),
            _ => break,
        }
        length += 1;
    }
    let digits = length - start - usize::from(point.is_some());
    if digits == 0 || digits > PLAIN_DIGITS {
        return None;
    }
    let mantissa =
        if negative { 0_i64.checked_sub_unsigned(magnitude) } else { 0_i64.checked_add_unsigned(magnitude) };
    let fraction_digits = point.map_or(0, |point| length - point - 1) as i32;
    Some(PlainPrefix { mantissa: mantissa?, fraction_digits, length })
}

/// The exponent after the `e`.
fn written_exponent(text: &[u8]) -> Option<i32> {
    let (negative, digits) = match text {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    if digits.is_empty() || digits.len() > 8 || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let magnitude = digits.iter().fold(0, |value, digit| value * 10 + i32::from(digit - b'0'));
    (magnitude.unsigned_abs() <= PLAIN_EXPONENT).then_some(if negative { -magnitude } else { magnitude })
}

#[cfg(test)]
mod tests;
