//! Exact numbers as decimal text.

use boundfit_exact::{Integer, Rational};

/// So many zeros after the point, or before it at the end of a whole number, are written out.
const MOST_ZEROS: usize = 15;

/// The decimal that is the number, digit for digit, or `None` where no finite decimal is: `0.0005`, `1.25e-20`. Exact.
/// Cost: that of some divisions of numbers as long as the result.
pub(super) fn finite_decimal(value: &Rational) -> Option<String> {
    let denominator = value.denominator();
    let places = decimal_places(&denominator)?;
    let scaled = value.numerator().abs() * Integer::power_of_ten(places).quotient(&denominator);
    let sign = if value.is_negative() { "-" } else { "" };
    Some(format!("{sign}{}", placed(&scaled.to_string(), places as usize)))
}

/// The least k for which the number divides 10^k.
fn decimal_places(denominator: &Integer) -> Option<u32> {
    let divides = |places: u32| Integer::power_of_ten(places).div_rem_floor(denominator).1.is_zero();
    // A power of two or five in a number has an exponent below the number's length in bits.
    let (mut low, mut high) = (0, u32::try_from(denominator.bits()).ok()?);
    if !divides(high) {
        return None;
    }
    while low < high {
        let middle = low + (high - low) / 2;
        if divides(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    Some(low)
}

/// Digits that are followed by so many decimal places with their point, or with an exponent where that is shorter.
fn placed(digits: &str, places: usize) -> String {
    let significant = digits.trim_end_matches('0');
    let zeros = digits.len() - significant.len();
    if digits == "0" || (places == 0 && zeros <= MOST_ZEROS) {
        return digits.to_owned();
    }
    match digits.len().checked_sub(places) {
        Some(whole) if whole > 0 && places > 0 => match digits.split_at_checked(whole) {
            Some((whole, fraction)) => format!("{whole}.{fraction}"),
            None => digits.to_owned(),
        },
        None | Some(0) if places - digits.len() <= MOST_ZEROS => {
            format!("0.{}{digits}", "0".repeat(places - digits.len()))
        }
        _ => {
            let exponent = digits.len() as i64 - 1 - places as i64;
            match significant.split_at_checked(1) {
                Some((first, "")) => format!("{first}e{exponent}"),
                Some((first, rest)) => format!("{first}.{rest}e{exponent}"),
                None => digits.to_owned(),
            }
        }
    }
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
            ("1/2000", "0.0005"),
            ("-1/2000", "-0.0005"),
            ("1700000050.809414445", "1700000050.809414445"),
            ("12300", "12300"),
            ("1e15", "1000000000000000"),
            ("-12e30", "-1.2e31"),
            ("1e9999", "1e9999"),
            ("1e-16", "0.0000000000000001"),
            ("1e-17", "1e-17"),
            ("-1.25e-20", "-1.25e-20"),
            ("10", "10"),
            ("7/64", "0.109375"),
            ("3/125", "0.024"),
        ] {
            assert_eq!(finite_decimal(&number(value)).as_deref(), Some(text), "{value}");
        }
        for value in ["1/3", "-5/14", "1/30"] {
            assert_eq!(finite_decimal(&number(value)), None, "{value}");
        }
        let tenth = Rational::from_f64(0.1).unwrap();
        let digits = "0.1000000000000000055511151231257827021181583404541015625";
        assert_eq!(finite_decimal(&tenth).as_deref(), Some(digits));
        for double in [5e-324, 1.7e308, -2.5e-10, 123_456.789, 1e22] {
            let value = Rational::from_f64(double).unwrap();
            assert_eq!(number(&finite_decimal(&value).unwrap()), value, "{double}");
        }
    }
}
