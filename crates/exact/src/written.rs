//! The digits that a number is written with, which say how precisely its writer knew it.

use crate::{DecimalMark, trim_number};

/// The digits of a decimal as they are written, zeros at the end among them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WrittenDigits {
    /// The power of ten that the last digit stands for: -2 for `12.30`, 3 for `1e3`.
    pub last_place: i64,
    /// The number of digits there are from the first one that is not 0: 4 for `12.30`, 0 for `0.00`.
    pub significant: usize,
    /// Says whether there are neither a decimal mark nor an exponent, as in `1200`.
    pub is_whole: bool,
}

impl WrittenDigits {
    /// The digits of a text that is read as a number; of other texts they mean nothing. `None` for a fraction, which has no
    /// last digit. Where no decimal mark is known, the first of both that occurs is taken for it. Exact.
    ///
    /// ```
    /// use boundfit_exact::WrittenDigits;
    ///
    /// let digits = WrittenDigits::of("-1.790e-3", None).unwrap();
    /// assert_eq!((digits.last_place, digits.significant, digits.is_whole), (-6, 4, false));
    /// assert_eq!(WrittenDigits::of("1/15", None), None);
    /// ```
    pub fn of(text: &str, mark: Option<DecimalMark>) -> Option<Self> {
        let text = trim_number(text).replace('\u{2212}', "-");
        if text.contains('/') {
            return None;
        }
        let parts = text.split_once(['e', 'E', 'd', 'D']);
        let (mantissa, exponent) = parts.unwrap_or((&text, "0"));
        let split = |mark: DecimalMark| mantissa.split_once(char::from(mark.byte()));
        let halves = mark.map_or_else(|| DecimalMark::ALL.into_iter().find_map(split), split);
        let places = halves.map_or(0, |(_, places)| places.len());
        let exponent: i64 = exponent.parse().unwrap_or(0);
        let digits = mantissa.bytes().filter(u8::is_ascii_digit);
        Some(WrittenDigits {
            last_place: exponent.saturating_sub(i64::try_from(places).unwrap_or(i64::MAX)),
            significant: digits.skip_while(|digit| *digit == b'0').count(),
            is_whole: parts.is_none() && halves.is_none(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_count_as_they_are_written() {
        for (text, last_place, significant, is_whole) in [
            ("12.30", -2, 4, false),
            ("1200", 0, 4, true),
            ("1200.", 0, 4, false),
            ("1e3", 3, 1, false),
            (" -1.50E-2 ", -4, 3, false),
            ("+.5", -1, 1, false),
            ("0.00100", -5, 3, false),
            ("0", 0, 0, true),
            ("0.000", -3, 0, false),
            ("1,5D\u{2212}03", -4, 2, false),
            ("\u{2212}7", 0, 1, true),
        ] {
            let expected = WrittenDigits { last_place, significant, is_whole };
            assert_eq!(WrittenDigits::of(text, None), Some(expected), "{text}");
        }
        let comma = WrittenDigits::of("1.234,50", Some(DecimalMark::Comma)).unwrap();
        assert_eq!((comma.last_place, comma.significant), (-2, 6));
        assert_eq!(WrittenDigits::of("1.234", Some(DecimalMark::Comma)).unwrap().last_place, 0);
        assert_eq!(WrittenDigits::of("1/3", None), None);
    }
}
