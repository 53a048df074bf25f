//! Decimals out: rounded to a number of significant digits, in a stated direction.

use crate::{Integer, Rational};

/// The direction in which a printed decimal may differ from the exact value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest, ties to the even last digit.
    Nearest,
    /// Towards minus infinity: the decimal is never above the value.
    Down,
    /// Towards plus infinity: the decimal is never below the value.
    Up,
}

impl Rational {
    /// The shortest decimal with at most `digits` significant digits (at least 1), rounded as asked.
    ///
    /// A value that `digits` digits hold is printed exactly, without trailing zeros; all other values get
    /// all `digits` digits. Scientific notation is used below 0.1 and where positional notation would have to
    /// pad with zeros. Rounded unless exact. Cost: one division of numbers of the value's size.
    ///
    /// ```
    /// use boundfit_exact::{Rational, Rounding};
    /// let value = Rational::ratio(21, 11726);
    /// assert_eq!(value.to_decimal(5, Rounding::Nearest), "1.7909e-3");
    /// assert_eq!(value.to_decimal(5, Rounding::Down), "1.7908e-3");
    /// assert_eq!(Rational::ratio(-3, 2).to_decimal(5, Rounding::Up), "-1.5");
    /// ```
    pub fn to_decimal(&self, digits: usize, rounding: Rounding) -> String {
        if self.is_zero() {
            return "0".to_owned();
        }
        let digits = digits.max(1);
        let away_from_zero = match rounding {
            Rounding::Nearest => None,
            Rounding::Down => Some(self.is_negative()),
            Rounding::Up => Some(self.is_positive()),
        };
        let magnitude = self.abs();
        let mut exponent = exponent_of(&magnitude);
        let (mut significand, exact) = significand(&magnitude, exponent, digits, away_from_zero);
        if significand == Integer::power_of_ten(digits as u32) {
            significand = Integer::power_of_ten(digits as u32 - 1);
            exponent += 1;
        }
        let text = significand.to_string();
        let text = if exact { text.trim_end_matches('0') } else { &text };
        let sign = if self.is_negative() { "-" } else { "" };
        format!("{sign}{}", place_point(text, exponent, exact))
    }

    /// The decimal that so many significant digits hold exactly, if they do. Cost: two of [`Rational::to_decimal`].
    pub fn exact_decimal(&self, digits: usize) -> Option<String> {
        let decimal = self.to_decimal(digits, Rounding::Down);
        (decimal == self.to_decimal(digits, Rounding::Up)).then_some(decimal)
    }

    /// The power of ten that the first significant digit weighs, `floor(log10 |self|)`, or `None` for 0. Exact.
    pub fn decimal_exponent(&self) -> Option<i64> {
        (!self.is_zero()).then(|| exponent_of(&self.abs()))
    }
}

/// `floor(log10(magnitude))` of a positive number.
fn exponent_of(magnitude: &Rational) -> i64 {
    let (numerator, denominator) = (magnitude.numerator(), magnitude.denominator());
    let bits = numerator.bits() as f64 - denominator.bits() as f64;
    // The estimate is off by less than one either way; the comparison below decides exactly.
    let estimate = (bits * std::f64::consts::LOG10_2).floor() as i64;
    let mut exponent = estimate - 1;
    while reaches_power_of_ten(&numerator, &denominator, exponent + 1) {
        exponent += 1;
    }
    exponent
}

/// Whether `numerator / denominator >= 10^exponent`.
fn reaches_power_of_ten(numerator: &Integer, denominator: &Integer, exponent: i64) -> bool {
    let power = Integer::power_of_ten(exponent.unsigned_abs() as u32);
    if exponent >= 0 { numerator >= &(denominator * power) } else { numerator * power >= *denominator }
}

/// `magnitude / 10^(exponent - digits + 1)` as a rounded integer, and whether nothing was lost.
fn significand(
    magnitude: &Rational,
    exponent: i64,
    digits: usize,
    away_from_zero: Option<bool>,
) -> (Integer, bool) {
    let shift = digits as i64 - 1 - exponent;
    let power = Integer::power_of_ten(shift.unsigned_abs() as u32);
    let (numerator, denominator) = if shift >= 0 {
        (magnitude.numerator() * power, magnitude.denominator())
    } else {
        (magnitude.numerator(), magnitude.denominator() * power)
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

/// Writes significant digits whose first one weighs `10^exponent`.
fn place_point(digits: &str, exponent: i64, exact: bool) -> String {
    let count = digits.len() as i64;
    match exponent {
        -1 => format!("0.{digits}"),
        0.. if exponent < count - 1 => {
            let (whole, fraction) = digits.split_at(exponent as usize + 1);
            format!("{whole}.{fraction}")
        }
        0.. if exponent == count - 1 => digits.to_owned(),
        // A short exact integer reads better as 20 than as 2e1.
        0..=5 if exact => format!("{digits}{}", "0".repeat((exponent + 1 - count) as usize)),
        _ if count == 1 => format!("{digits}e{exponent}"),
        _ => format!("{}.{}e{exponent}", &digits[..1], &digits[1..]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Reading};

    fn value(text: &str) -> Rational {
        Reading::Decimal.read(text, &Limits::default()).unwrap()
    }

    #[test]
    fn rounds_in_the_direction_asked() {
        for (text, digits, nearest, down, up) in [
            ("1/3", 3, "0.333", "0.333", "0.334"),
            ("-1/3", 3, "-0.333", "-0.334", "-0.333"),
            ("2/3", 5, "0.66667", "0.66666", "0.66667"),
            ("0.0018194243", 5, "1.8194e-3", "1.8194e-3", "1.8195e-3"),
            ("549.6238", 5, "549.62", "549.62", "549.63"),
            ("0.99999", 3, "1.00", "0.999", "1.00"),
            ("-0.99999", 3, "-1.00", "-1.00", "-0.999"),
            ("999.96", 4, "1000", "999.9", "1000"),
            ("123456", 5, "1.2346e5", "1.2345e5", "1.2346e5"),
            ("0.125", 2, "0.12", "0.12", "0.13"),
            ("0.135", 2, "0.14", "0.13", "0.14"),
        ] {
            let value = value(text);
            let printed = |rounding| value.to_decimal(digits, rounding);
            assert_eq!(printed(Rounding::Nearest), nearest, "{text}");
            assert_eq!(printed(Rounding::Down), down, "{text}");
            assert_eq!(printed(Rounding::Up), up, "{text}");
        }
    }

    #[test]
    fn exact_values_are_short() {
        for (text, printed) in [
            ("0", "0"),
            ("1/2", "0.5"),
            ("-1/2000", "-5e-4"),
            ("20", "20"),
            ("100000", "100000"),
            ("1e6", "1e6"),
            ("1200000", "1.2e6"),
            ("0.05", "5e-2"),
            ("12.5", "12.5"),
            ("12345", "12345"),
        ] {
            for rounding in [Rounding::Nearest, Rounding::Down, Rounding::Up] {
                assert_eq!(value(text).to_decimal(5, rounding), printed, "{text}");
            }
        }
    }

    #[test]
    fn a_directed_decimal_encloses_the_value_and_is_tight() {
        for numerator in -400_i64..400 {
            for denominator in [1, 3, 7, 10, 64, 999, 100_000] {
                let exact = Rational::ratio(numerator, denominator);
                for digits in 1..6 {
                    let down = value(&exact.to_decimal(digits, Rounding::Down));
                    let up = value(&exact.to_decimal(digits, Rounding::Up));
                    let nearest = value(&exact.to_decimal(digits, Rounding::Nearest));
                    assert!(down <= exact && exact <= up);
                    assert!(nearest == down || nearest == up);
                    let error = (&exact - &nearest).abs();
                    assert!(error <= (&exact - &down).abs() && error <= (&exact - &up).abs());
                }
            }
        }
    }

    #[test]
    fn the_decimal_exponent_is_that_of_the_first_digit() {
        for (text, exponent) in
            [("1", 0), ("-9.99", 0), ("10", 1), ("0.1", -1), ("0.0999", -2), ("1e-300", -300)]
        {
            assert_eq!(value(text).decimal_exponent(), Some(exponent), "{text}");
        }
        assert_eq!(Rational::zero().decimal_exponent(), None);
    }

    #[test]
    fn far_exponents() {
        let tiny = value("1.5e-9999");
        assert_eq!(tiny.to_decimal(5, Rounding::Nearest), "1.5e-9999");
        let huge = value("12345678e9000");
        assert_eq!(huge.to_decimal(3, Rounding::Up), "1.24e9007");
    }
}
