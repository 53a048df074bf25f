//! Exact numbers as decimal text.

use std::fmt::Write;

use boundfit_exact::Rational;

/// A finite decimal, digit for digit: `0.5`, `1.25e-20`; a fraction where the number has none. Exact. Cost: that of
/// writing an integer as long as the result.
pub(super) fn push_decimal(text: &mut String, value: &Rational) {
    /// Integers below are written with all their digits.
    const LEAST_WITH_POWER: u64 = 1_000_000;
    if let Some((whole, 1)) = value.to_words()
        && whole.unsigned_abs() < LEAST_WITH_POWER
    {
        // Writing to a string cannot fail.
        let _ = write!(text, "{whole}");
        return;
    }
    /// The number of digits that machine words can write, which is enough for nearly every number that was read.
    const FEW: usize = 18;
    let _ = match value.to_words().and_then(|_| value.exact_decimal(FEW)) {
        Some(decimal) => write!(text, "{}", decimal.compact()),
        None => match value.finite_decimal() {
            Some(digits) => text.write_str(&digits),
            None => write!(text, "{value}"),
        },
    };
}

/// Writes a number as [`push_decimal`] writes it.
pub(super) fn decimal(value: &Rational) -> String {
    let mut text = String::new();
    push_decimal(&mut text, value);
    text
}

/// Returns whether the number is a finite decimal of two machine words, so that it has fewer than a hundred digits and is within the
/// range of doubles. Cost: some nanoseconds.
pub(super) fn is_short(value: &Rational) -> bool {
    value.to_words().is_some_and(|(_, denominator)| {
        let mut odd = denominator >> denominator.trailing_zeros();
        while odd % 5 == 0 {
            odd /= 5;
        }
        odd == 1
    })
}

#[cfg(test)]
mod tests {
    use boundfit_exact::{Limits, Reading};

    use super::*;

    fn number(text: &str) -> Rational {
        Reading::Decimal.read(text, &Limits::default()).unwrap()
    }

    #[test]
    fn decimals_keep_every_digit() {
        for (value, text) in [
            ("0", "0"),
            ("1/2000", "5e-4"),
            ("-1/2000", "-5e-4"),
            ("1700000050.809414445", "1700000050.809414445"),
            ("12300", "12300"),
            ("1e15", "1e15"),
            ("-12e30", "-1.2e31"),
            ("1e9999", "1e9999"),
            ("1e-16", "1e-16"),
            ("1e-17", "1e-17"),
            ("-1.25e-20", "-1.25e-20"),
            ("10", "10"),
            ("7/64", "0.109375"),
            ("3/125", "2.4e-2"),
        ] {
            assert_eq!(decimal(&number(value)), text, "{value}");
        }
        for value in ["1/3", "-5/14", "1/30"] {
            assert_eq!(decimal(&number(value)), value);
            assert!(!number(value).is_finite_decimal() && !is_short(&number(value)), "{value}");
        }
        let tenth = Rational::from_f64(0.1).unwrap();
        let digits = "0.1000000000000000055511151231257827021181583404541015625";
        assert_eq!(decimal(&tenth), digits);
        for double in [5e-324, 1.7e308, -2.5e-10, 123_456.789, 1e22] {
            let value = Rational::from_f64(double).unwrap();
            assert_eq!(number(&decimal(&value)), value, "{double}");
        }
    }
}
