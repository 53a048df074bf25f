//! Numbers: both readings against num-rational and the standard library.

use boundfit_exact::{Limits, Rational, Reading, Rounding, plain_decimal, plain_double};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Zero};

const LIMITS: [Limits; 2] = [Limits { digits: 40, exponent: 400 }, Limits { digits: 3, exponent: 2 }];

/// A text is read as num-rational reads it, or refused when it is no number or beyond the limits; the binary64 reading is
/// the nearest double; decimals printed enclose the number; the fast lanes read nothing else.
pub fn number_parser(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let expected = reference(text);
    for limits in &LIMITS {
        let decimal = Reading::Decimal.read(text, limits);
        match (&expected, &decimal) {
            (None, Ok(value)) => panic!("{text:?} is no number, but read as {value}"),
            (None, Err(error)) => assert!(error.position <= text.len(), "{text:?}: {error}"),
            (Some(number), decimal) if number.is_within(limits) => {
                let value = decimal.as_ref().unwrap_or_else(|error| panic!("{text:?}: {error}"));
                assert_eq!(value.to_string(), number.value().to_string(), "{text:?}");
                check_value(text, value, limits);
            }
            (Some(_), Ok(value)) => panic!("{text:?} is beyond {limits:?}, but read as {value}"),
            (Some(_), Err(error)) => assert!(error.kind.is_limit(), "{text:?}: {error}"),
        }
    }
}

/// Everything else about a number that was read.
fn check_value(text: &str, value: &Rational, limits: &Limits) {
    let binary64 = Reading::Binary64.read(text, limits);
    let double = value.to_f64();
    assert_eq!(binary64.as_ref().ok(), Rational::from_f64(double).as_ref(), "{text:?}");
    match text.trim_ascii().parse::<f64>() {
        Ok(parsed) => assert_eq!((parsed + 0.0).to_bits(), (double + 0.0).to_bits(), "{text:?}"),
        Err(_) => check_nearest(text, value, double),
    }
    if let Some((mantissa, exponent)) = plain_decimal(text.as_bytes()) {
        let power = crate::lp_cases::ten_to(exponent);
        assert_eq!(&(Rational::from(mantissa) * power), value, "{text:?}");
    }
    if let Some(plain) = plain_double(text.as_bytes()) {
        assert_eq!(plain + 0.0, double + 0.0, "{text:?}");
    }
    let read = |text: &str| {
        Reading::Decimal.read(text, &Limits::default()).unwrap_or_else(|error| panic!("{text:?}: {error}"))
    };
    assert_eq!(&read(&value.to_string()), value);
    for digits in [1, 5, 17] {
        let below = read(&value.to_decimal(digits, Rounding::Down));
        let above = read(&value.to_decimal(digits, Rounding::Up));
        let nearest = read(&value.to_decimal(digits, Rounding::Nearest));
        assert!(below <= *value && *value <= above, "{text:?} to {digits} digits: [{below}, {above}]");
        assert!(nearest == below || nearest == above, "{text:?} to {digits} digits: {nearest}");
    }
}

/// No double is nearer to the value.
fn check_nearest(text: &str, value: &Rational, double: f64) {
    let Some(exact) = Rational::from_f64(double) else { return };
    let away = (value - &exact).abs();
    for neighbour in [double.next_down(), double.next_up()] {
        if let Some(other) = Rational::from_f64(neighbour) {
            let other_away = (value - &other).abs();
            let is_even = double.to_bits().is_multiple_of(2);
            assert!(away < other_away || away == other_away && is_even, "{text:?}: {double:e}");
        }
    }
}

/// A number by another reading of the grammar.
struct Reference {
    numerator: BigInt,
    denominator: BigInt,
    /// Digits of the decimal, or of numerator and denominator.
    digits: usize,
    /// The exponent as written, unless it has so many digits that it is beyond any limit.
    exponent: Option<i64>,
}

impl Reference {
    fn is_within(&self, limits: &Limits) -> bool {
        self.digits <= limits.digits
            && self.exponent.is_some_and(|exponent| exponent.unsigned_abs() <= limits.exponent.into())
    }

    fn value(&self) -> BigRational {
        let ratio = BigRational::new(self.numerator.clone(), self.denominator.clone());
        ratio * BigRational::from_integer(BigInt::from(10)).pow(self.exponent.unwrap_or_default() as i32)
    }
}

fn whole(digits: &str) -> Option<BigInt> {
    (!digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())).then(|| digits.parse().ok())?
}

fn reference(text: &str) -> Option<Reference> {
    let text = text.trim_matches(|character: char| character.is_ascii_whitespace());
    let (sign, magnitude) = match text.as_bytes().first()? {
        b'-' => (-1, &text[1..]),
        b'+' => (1, &text[1..]),
        _ => (1, text),
    };
    if let Some((numerator, denominator)) = magnitude.split_once('/') {
        let digits = numerator.len().max(denominator.len());
        let (numerator, denominator) = (whole(numerator)? * sign, whole(denominator)?);
        let is_number = !denominator.is_zero();
        return is_number.then_some(Reference { numerator, denominator, digits, exponent: Some(0) });
    }
    let (mantissa, exponent) = match magnitude.split_once(['e', 'E']) {
        None => (magnitude, Some(0)),
        Some((mantissa, exponent)) => {
            whole(exponent.strip_prefix(['+', '-']).unwrap_or(exponent))?;
            (mantissa, exponent.parse().ok())
        }
    };
    let (before, after) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{before}{after}");
    Some(Reference {
        numerator: whole(&digits)? * sign,
        denominator: BigInt::from(10).pow(after.len()),
        digits: digits.len(),
        exponent,
    })
}
