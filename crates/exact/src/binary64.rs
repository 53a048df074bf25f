//! The one door between exact numbers and IEEE 754 binary64.

use crate::{Integer, Rational};

/// Binary exponent of the smallest positive binary64.
const LEAST_EXPONENT: i64 = -1074;
/// Bits of a binary64 significand.
const SIGNIFICAND_BITS: i64 = 53;

impl Rational {
    /// The exact value of a finite binary64, or `None` for an infinity or NaN.
    ///
    /// ```
    /// # use boundfit_exact::Rational;
    /// assert_eq!(Rational::from_f64(0.1).unwrap().to_string(), "3602879701896397/36028797018963968");
    /// ```
    pub fn from_f64(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let bits = value.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let biased = ((bits >> 52) & 0x7ff) as i64;
        let (significand, exponent) =
            if biased == 0 { (fraction, LEAST_EXPONENT) } else { (fraction | (1 << 52), biased - 1075) };
        let power = Integer::power_of_two(exponent.unsigned_abs());
        let magnitude = if exponent >= 0 {
            Rational::from(Integer::from(significand) * power)
        } else {
            Rational::new(Integer::from(significand), power)?
        };
        Some(if value.is_sign_negative() { -magnitude } else { magnitude })
    }

    /// The nearest binary64, ties to even, as IEEE 754 rounds: overflows to an infinity, underflows to 0.
    /// Correctly rounded in every case.
    pub fn to_f64(&self) -> f64 {
        let magnitude = nearest_magnitude(&self.numerator().abs(), &self.denominator());
        if self.is_negative() { -magnitude } else { magnitude }
    }
}

fn nearest_magnitude(numerator: &Integer, denominator: &Integer) -> f64 {
    if numerator.is_zero() {
        return 0.0;
    }
    // The leading bit of the quotient weighs 2^leading or 2^(leading - 1).
    let leading = numerator.bits() as i64 - denominator.bits() as i64;
    let mut exponent = (leading - SIGNIFICAND_BITS).max(LEAST_EXPONENT);
    let mut significand = rounded_quotient(numerator, denominator, exponent);
    if significand >= 1 << SIGNIFICAND_BITS {
        // One bit too many: round again from the exact quotient, not from the rounded one.
        exponent += 1;
        significand = rounded_quotient(numerator, denominator, exponent);
    }
    if exponent > 1023 {
        return f64::INFINITY;
    }
    // Both factors are binary64 numbers and so is their product: this multiplication does not round.
    significand as f64 * power_of_two(exponent)
}

/// `numerator / (denominator * 2^exponent)` to the nearest integer, ties to even; below 2^55 by the choice
/// of the exponent.
fn rounded_quotient(numerator: &Integer, denominator: &Integer, exponent: i64) -> u64 {
    let power = Integer::power_of_two(exponent.unsigned_abs());
    let (scaled_numerator, scaled_denominator) = if exponent >= 0 {
        (numerator.clone(), denominator * &power)
    } else {
        (numerator * &power, denominator.clone())
    };
    let (quotient, remainder) = scaled_numerator.div_rem_floor(&scaled_denominator);
    let odd = !quotient.is_even();
    let twice = &remainder + &remainder;
    let up = twice > scaled_denominator || (twice == scaled_denominator && odd);
    quotient.to_u64().map_or(u64::MAX, |floor| floor + u64::from(up))
}

/// 2 to a power from -1074 to 1023.
fn power_of_two(exponent: i64) -> f64 {
    if exponent >= -1022 {
        f64::from_bits(((exponent + 1023) as u64) << 52)
    } else {
        f64::from_bits(1 << (exponent - LEAST_EXPONENT))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Limits, Reading};

    fn exact(text: &str) -> Rational {
        Reading::Decimal.read(text, &Limits::default()).unwrap()
    }

    #[test]
    fn agrees_with_the_standard_library_on_decimal_text() {
        // A small generator is enough here: digits, sign and exponent from one multiplicative sequence.
        let mut state: u64 = 0x9e37_79b9_7f4a_7c15;
        for _ in 0..20_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let digits = state >> (state % 60);
            let exponent = (state >> 40) as i64 % 700 - 350;
            let text = format!("{}{digits}e{exponent}", if state & 1 == 0 { "-" } else { "" });
            assert_eq!(exact(&text).to_f64(), text.parse::<f64>().unwrap(), "{text}");
        }
    }

    #[test]
    fn edges_of_the_format() {
        for text in [
            "0",
            "1",
            "0.1",
            "5e-324",
            "2.4703282292062328e-324",
            "2.4703282292062327e-324",
            "1e-400",
            "2.2250738585072011e-308",
            "2.2250738585072014e-308",
            "1.7976931348623157e308",
            "1.7976931348623158e308",
            "1.797693134862315808e308",
            "1e400",
            "-1e400",
            "9007199254740993",
            "9007199254740992.9999",
            "9007199254740995",
            "18014398509481989",
            "18014398509481990",
            "0.500000000000000166533453693773481063544750213623046875",
        ] {
            assert_eq!(exact(text).to_f64(), text.parse::<f64>().unwrap(), "{text}");
        }
        assert_eq!(Rational::ratio(1, 3).to_f64(), 1.0 / 3.0);
    }

    #[test]
    fn every_finite_double_survives_the_round_trip() {
        for value in [0.0, 0.1, -2.5, f64::MAX, f64::MIN_POSITIVE, 5e-324, 1.0 + f64::EPSILON, 1e300, -1e-300]
        {
            assert_eq!(Rational::from_f64(value).unwrap().to_f64(), value);
        }
        assert_eq!(Rational::from_f64(f64::NAN), None);
        assert_eq!(Rational::from_f64(f64::NEG_INFINITY), None);
    }
}
