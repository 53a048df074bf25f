//! Numbers: both readings against num-rational and the standard library.

use boundfit_exact::{
    Limits, ParseNumberErrorKind, Rational, Reading, Rounding, plain_decimal, plain_double,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Zero};

const LIMITS: [Limits; 2] = [Limits { digits: 40, exponent: 400 }, Limits { digits: 3, exponent: 2 }];

/// Reads a text as num-rational reads it, or refuses it if it is no number, looks like a date or is beyond the
/// limits. The binary64 reading is the nearest double, and printed decimals enclose the number. The fast lanes read
/// nothing else.
pub fn number_parser(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let plain = plainly_written(text);
    let expected = reference(&plain);
    for limits in &LIMITS {
        let decimal = Reading::Decimal.read(text, limits);
        match (&expected, &decimal) {
            (Reference::Nothing, Ok(value)) => panic!("{text:?} is no number, but read as {value}"),
            (Reference::Nothing, Err(error)) => {
                assert!(error.position <= text.len(), "{text:?}: {error}");
                assert_ne!(error.kind, ParseNumberErrorKind::Date, "{text:?}");
            }
            (Reference::Date { digits }, decimal) => {
                let error = decimal.as_ref().expect_err("what looks like a date is no number");
                let is_within = *digits <= limits.digits;
                assert_eq!(error.kind == ParseNumberErrorKind::Date, is_within, "{text:?}: {error}");
                assert!(is_within || error.kind.is_limit(), "{text:?}: {error}");
            }
            (Reference::Number(number), decimal) if number.is_within(limits) => {
                let value = decimal.as_ref().unwrap_or_else(|error| panic!("{text:?}: {error}"));
                assert_eq!(value.to_string(), number.value().to_string(), "{text:?}");
                check_value(text, &plain, value, limits);
            }
            (Reference::Number(_), Ok(value)) => panic!("{text:?} is beyond {limits:?}, but read as {value}"),
            (Reference::Number(_), Err(error)) => assert!(error.kind.is_limit(), "{text:?}: {error}"),
        }
    }
}

/// Everything else about a number that was read, with its text as the standard library wants it.
fn check_value(text: &str, plain: &str, value: &Rational, limits: &Limits) {
    let binary64 = Reading::Binary64.read(text, limits);
    let double = value.to_f64();
    assert_eq!(binary64.as_ref().ok(), Rational::from_f64(double).as_ref(), "{text:?}");
    match plain.parse::<f64>() {
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

/// Characters around numbers beside white space of ASCII: spaces that do not break, of a digit's width, and thin.
const TYPESETTERS_SPACES: &str = "\u{a0}\u{2007}\u{2009}\u{202f}";

/// A text without the white space around it, with the minus of ASCII and the exponent of C. The remaining text may be
/// anything.
fn plainly_written(text: &str) -> String {
    let is_space =
        |character: char| character.is_ascii_whitespace() || TYPESETTERS_SPACES.contains(character);
    text.trim_matches(is_space).replace('\u{2212}', "-").replace(['d', 'D'], "e")
}

/// The kind of a text by another reading of the grammar.
enum Reference {
    Number(Number),
    /// A fraction that looks like a date, with the digits of the longer part that counts.
    Date {
        digits: usize,
    },
    Nothing,
}

/// A number that is not built yet.
struct Number {
    numerator: BigInt,
    denominator: BigInt,
    /// Digits of the decimal, or of numerator and denominator.
    digits: usize,
    /// The exponent as written, unless it has so many digits that it is beyond any limit.
    exponent: Option<i64>,
}

impl Number {
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

fn reference(plain: &str) -> Reference {
    let (sign, magnitude) = match plain.as_bytes().first() {
        Some(b'-') => (-1, &plain[1..]),
        Some(b'+') => (1, &plain[1..]),
        _ => (1, plain),
    };
    if let Some(digits) = date(magnitude) {
        return Reference::Date { digits };
    }
    let number = if magnitude.contains('/') { fraction(magnitude, sign) } else { decimal(magnitude, sign) };
    number.map_or(Reference::Nothing, Reference::Number)
}

/// Returns the most digits in the parts that show that this starts like a date. A date has digits on both sides of a
/// slash, and one part with a zero in front of another digit or another slash behind it.
fn date(magnitude: &str) -> Option<usize> {
    let (numerator, rest) = magnitude.split_once('/')?;
    whole(numerator)?;
    let denominator = rest.split(|character: char| !character.is_ascii_digit()).next().unwrap_or_default();
    let has_zero_in_front = |part: &str| part.len() > 1 && part.starts_with('0');
    let has_more = !denominator.is_empty() && rest[denominator.len()..].starts_with('/');
    (has_zero_in_front(numerator) || has_zero_in_front(denominator) || has_more)
        .then(|| numerator.len().max(denominator.len()))
}

fn fraction(magnitude: &str, sign: i8) -> Option<Number> {
    let (numerator, denominator) = magnitude.split_once('/')?;
    let digits = numerator.len().max(denominator.len());
    let (numerator, denominator) = (whole(numerator)? * sign, whole(denominator)?);
    (!denominator.is_zero()).then_some(Number { numerator, denominator, digits, exponent: Some(0) })
}

fn decimal(magnitude: &str, sign: i8) -> Option<Number> {
    let (mantissa, exponent) = match magnitude.split_once(['e', 'E']) {
        None => (magnitude, Some(0)),
        Some((mantissa, exponent)) => {
            whole(exponent.strip_prefix(['+', '-']).unwrap_or(exponent))?;
            (mantissa, exponent.parse().ok())
        }
    };
    let (before, after) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{before}{after}");
    Some(Number {
        numerator: whole(&digits)? * sign,
        denominator: BigInt::from(10).pow(after.len()),
        digits: digits.len(),
        exponent,
    })
}
