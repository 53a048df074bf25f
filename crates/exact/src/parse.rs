//! Numbers from text: decimals, scientific notation and fractions, each read as the exact rational it spells.

use std::fmt;

use serde::Deserialize;
use thiserror::Error;

use crate::{Integer, Rational};

/// How much a number in a file may ask for. A number beyond a limit is refused before it is built.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// The most digits that one number may have (numerator and denominator each, for a fraction).
    pub digits: usize,
    /// The largest absolute value of a decimal exponent.
    pub exponent: u32,
}

impl Default for Limits {
    /// 10,000 digits and exponents from -10,000 to 10,000.
    fn default() -> Self {
        Limits { digits: 10_000, exponent: 10_000 }
    }
}

/// Which exact number a text stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Reading {
    /// The number as written: `0.1` is 1/10.
    #[default]
    Decimal,
    /// The IEEE 754 binary64 nearest to the number as written, taken exactly: what a float solver receives.
    Binary64,
}

impl Reading {
    /// Both of them.
    pub const ALL: [Reading; 2] = [Reading::Decimal, Reading::Binary64];

    /// The name used on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Reading::Decimal => "decimal",
            Reading::Binary64 => "binary64",
        }
    }

    /// Reads a number such as `1.30e-2`, `-.5`, `+3` or `7/19`. White space around it is ignored.
    ///
    /// Exact. Cost: quadratic in the number of digits, which `limits` bounds; what is beyond them is refused before any
    /// number is made of it.
    ///
    /// ```
    /// use boundfit_exact::{Limits, ParseNumberErrorKind, Rational, Reading};
    ///
    /// let limits = Limits::default();
    /// assert_eq!(Reading::Decimal.read("0.1", &limits)?, Rational::ratio(1, 10));
    /// assert_eq!(Reading::Decimal.read("-7/21", &limits)?, Rational::ratio(-1, 3));
    /// // The nearest double is not 1/10, and is taken for what it is.
    /// let double = Reading::Binary64.read("0.1", &limits)?;
    /// assert_eq!(double.to_string(), "3602879701896397/36028797018963968");
    /// let refused = Reading::Decimal.read("1e999999999", &limits).unwrap_err();
    /// assert_eq!((refused.position, refused.kind), (2, ParseNumberErrorKind::ExponentTooLarge(10_000)));
    /// # Ok::<(), boundfit_exact::ParseNumberError>(())
    /// ```
    ///
    /// # Errors
    /// With the position in `text` where the number stops making sense or passes a limit; under
    /// [`Reading::Binary64`] also for a number that overflows binary64.
    pub fn read(self, text: &str, limits: &Limits) -> Result<Rational, ParseNumberError> {
        let exact = Scanner { bytes: text.as_bytes(), text, position: 0, limits }.number()?;
        match self {
            Reading::Decimal => Ok(exact),
            Reading::Binary64 => Rational::from_f64(exact.to_f64())
                .ok_or(ParseNumberError { position: 0, kind: ParseNumberErrorKind::Binary64Overflow }),
        }
    }
}

/// Why a text is not a number, and where.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{kind}{}", At(.kind, *.position))]
pub struct ParseNumberError {
    /// How many characters come before the offending one.
    pub position: usize,
    /// What is wrong there.
    pub kind: ParseNumberErrorKind,
}

/// What is wrong with a text that should be a number.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ParseNumberErrorKind {
    /// Nothing but white space.
    #[error("nothing to read")]
    Empty,
    /// A digit had to come here.
    #[error("a digit is missing")]
    MissingDigit,
    /// A character that no number contains.
    #[error("unexpected character {0:?}")]
    UnexpectedCharacter(char),
    /// A comma.
    #[error("unexpected ',' (the decimal mark is a point)")]
    Comma,
    /// A grouping mark.
    #[error("unexpected '_' (digits are not grouped)")]
    Underscore,
    /// `nan`, `inf` or a relative of theirs.
    #[error("not a finite number")]
    NotFinite,
    /// More digits than [`Limits::digits`].
    #[error("more than {0} digits (the limit)")]
    TooManyDigits(usize),
    /// An exponent beyond [`Limits::exponent`].
    #[error("exponent beyond {0} (the limit)")]
    ExponentTooLarge(u32),
    /// A fraction with a zero in front, or several slashes.
    #[error("this looks like a date")]
    Date,
    /// A fraction with denominator 0.
    #[error("zero denominator")]
    ZeroDenominator,
    /// A number beyond the largest binary64.
    #[error("overflows binary64")]
    Binary64Overflow,
}

impl ParseNumberErrorKind {
    /// Whether the text is a number, but beyond what is accepted.
    pub fn is_limit(&self) -> bool {
        use ParseNumberErrorKind::{Binary64Overflow, ExponentTooLarge, TooManyDigits};
        matches!(self, TooManyDigits(_) | ExponentTooLarge(_) | Binary64Overflow)
    }
}

/// The place, unless the number as a whole is meant.
struct At<'a>(&'a ParseNumberErrorKind, usize);

impl fmt::Display for At<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            At(ParseNumberErrorKind::Binary64Overflow | ParseNumberErrorKind::Date, _) => Ok(()),
            At(_, position) => write!(f, " at character {}", position + 1),
        }
    }
}

struct Scanner<'a> {
    bytes: &'a [u8],
    text: &'a str,
    position: usize,
    limits: &'a Limits,
}

impl Scanner<'_> {
    fn number(mut self) -> Result<Rational, ParseNumberError> {
        self.skip_white_space();
        if self.position == self.bytes.len() {
            return Err(self.error(ParseNumberErrorKind::Empty));
        }
        let negative = self.sign();
        let whole = self.digits(self.limits.digits)?;
        let magnitude = if self.next_is(b"/") && !whole.is_empty() {
            self.position += 1;
            self.fraction(whole)?
        } else {
            self.decimal(whole)?
        };
        self.skip_white_space();
        if self.position < self.bytes.len() {
            return Err(self.unexpected());
        }
        Ok(if negative { -magnitude } else { magnitude })
    }

    /// The rest of `p/q` after the slash.
    fn fraction(&mut self, numerator: &[u8]) -> Result<Rational, ParseNumberError> {
        let start = self.position;
        let digits = self.digits(self.limits.digits)?;
        // Nobody writes 03/04 for three quarters, but spreadsheets do for a day.
        let has_zero_in_front = |digits: &[u8]| digits.len() > 1 && digits.starts_with(b"0");
        if has_zero_in_front(numerator)
            || has_zero_in_front(digits)
            || self.next_is(b"/") && !digits.is_empty()
        {
            return Err(self.error_at(start - 1, ParseNumberErrorKind::Date));
        }
        let zero = self.error_at(start, ParseNumberErrorKind::ZeroDenominator);
        match (Integer::from_ascii_digits(numerator), Integer::from_ascii_digits(digits)) {
            (Some(numerator), Some(denominator)) => Rational::new(numerator, denominator).ok_or(zero),
            _ => Err(self.unexpected()),
        }
    }

    /// The rest of a decimal after the digits before the point.
    fn decimal(&mut self, whole: &[u8]) -> Result<Rational, ParseNumberError> {
        let fraction = if self.next_is(b".") {
            self.position += 1;
            self.digits(self.limits.digits.saturating_sub(whole.len()))?
        } else {
            &[]
        };
        let digits = [whole, fraction].concat();
        let Some(mantissa) = Integer::from_ascii_digits(&digits) else {
            return Err(self.unexpected());
        };
        let start = self.position;
        let too_large = |scanner: &Self| {
            scanner.error_at(start, ParseNumberErrorKind::ExponentTooLarge(scanner.limits.exponent))
        };
        let places = i64::try_from(fraction.len()).map_err(|_| too_large(self))?;
        let exponent = self.exponent()?.saturating_sub(places);
        let power = u32::try_from(exponent.unsigned_abs()).map_err(|_| too_large(self))?;
        let power = Integer::power_of_ten(power);
        let value = if exponent >= 0 {
            Some(Rational::from(mantissa * power))
        } else {
            Rational::new(mantissa, power)
        };
        value.ok_or_else(|| self.error(ParseNumberErrorKind::ZeroDenominator))
    }

    /// An optional `e±digits`.
    fn exponent(&mut self) -> Result<i64, ParseNumberError> {
        if !self.next_is(b"eE") {
            return Ok(0);
        }
        self.position += 1;
        let negative = self.sign();
        let start = self.position;
        let digits = self.digits(usize::MAX)?;
        if digits.is_empty() {
            return Err(self.unexpected());
        }
        let limit = i64::from(self.limits.exponent);
        let magnitude = digits
            .iter()
            .fold(0_i64, |value, digit| value.saturating_mul(10).saturating_add(i64::from(digit - b'0')));
        if magnitude > limit {
            return Err(self.error_at(start, ParseNumberErrorKind::ExponentTooLarge(self.limits.exponent)));
        }
        Ok(if negative { -magnitude } else { magnitude })
    }

    fn digits<'b>(&mut self, most: usize) -> Result<&'b [u8], ParseNumberError>
    where
        Self: 'b,
    {
        let rest = self.bytes.get(self.position..).unwrap_or_default();
        let count = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        if count > most {
            let kind = ParseNumberErrorKind::TooManyDigits(self.limits.digits);
            return Err(self.error_at(self.position + most, kind));
        }
        self.position += count;
        Ok(rest.get(..count).unwrap_or_default())
    }

    fn sign(&mut self) -> bool {
        let negative = self.next_is(b"-");
        if self.next_is(b"+-") {
            self.position += 1;
        }
        negative
    }

    fn next_is(&self, any_of: &[u8]) -> bool {
        self.bytes.get(self.position).is_some_and(|byte| any_of.contains(byte))
    }

    fn skip_white_space(&mut self) {
        while self.bytes.get(self.position).is_some_and(u8::is_ascii_whitespace) {
            self.position += 1;
        }
    }

    /// The error for whatever stands at the current position.
    fn unexpected(&self) -> ParseNumberError {
        let rest = self.text.get(self.position..).unwrap_or_default();
        self.error(match rest.chars().next() {
            None => ParseNumberErrorKind::MissingDigit,
            Some(',') => ParseNumberErrorKind::Comma,
            Some('_') => ParseNumberErrorKind::Underscore,
            Some(_) if is_not_finite(rest) => ParseNumberErrorKind::NotFinite,
            Some(character) => ParseNumberErrorKind::UnexpectedCharacter(character),
        })
    }

    fn error(&self, kind: ParseNumberErrorKind) -> ParseNumberError {
        self.error_at(self.position, kind)
    }

    fn error_at(&self, position: usize, kind: ParseNumberErrorKind) -> ParseNumberError {
        ParseNumberError { position: characters_before(self.text, position), kind }
    }
}

/// How many characters of a text come before this byte: messages count what people see.
pub fn characters_before(text: &str, byte: usize) -> usize {
    text.char_indices().take_while(|(start, _)| *start < byte).count()
}

fn is_not_finite(text: &str) -> bool {
    let word = text.trim_end().to_ascii_lowercase();
    ["nan", "inf", "infinity"].contains(&word.as_str())
}

#[cfg(test)]
mod tests {
    use super::ParseNumberErrorKind as Kind;
    use super::*;

    fn read(text: &str) -> Result<Rational, ParseNumberError> {
        Reading::Decimal.read(text, &Limits::default())
    }

    #[test]
    fn decimals_and_fractions_are_exact() {
        for (text, numerator, denominator) in [
            ("1.30e-2", 13, 1000),
            ("-.5", -1, 2),
            ("+3", 3, 1),
            ("7/19", 7, 19),
            ("-6/4", -3, 2),
            ("0/5", 0, 1),
            ("10/20", 1, 2),
            ("0.1", 1, 10),
            ("5e-4", 1, 2000),
            ("5.", 5, 1),
            ("2E+3", 2000, 1),
            ("-0", 0, 1),
            ("000.00100", 1, 1000),
            (" 1.5\t", 3, 2),
        ] {
            assert_eq!(read(text), Ok(Rational::ratio(numerator, denominator)), "{text}");
        }
    }

    #[test]
    fn what_is_not_a_number_is_refused_with_its_place() {
        for (text, position, kind) in [
            ("", 0, Kind::Empty),
            ("  ", 2, Kind::Empty),
            ("1_000", 1, Kind::Underscore),
            ("1,5", 1, Kind::Comma),
            ("0x10", 1, Kind::UnexpectedCharacter('x')),
            ("abc", 0, Kind::UnexpectedCharacter('a')),
            ("nan", 0, Kind::NotFinite),
            ("-inf", 1, Kind::NotFinite),
            ("Infinity", 0, Kind::NotFinite),
            ("-", 1, Kind::MissingDigit),
            (".", 1, Kind::MissingDigit),
            (".e5", 1, Kind::UnexpectedCharacter('e')),
            ("1e", 2, Kind::MissingDigit),
            ("1e+", 3, Kind::MissingDigit),
            ("1e5.5", 3, Kind::UnexpectedCharacter('.')),
            ("1/0", 2, Kind::ZeroDenominator),
            ("1/", 2, Kind::MissingDigit),
            ("/2", 0, Kind::UnexpectedCharacter('/')),
            ("1/-2", 2, Kind::UnexpectedCharacter('-')),
            ("1/2/3", 1, Kind::Date),
            ("2012/01/01", 4, Kind::Date),
            ("2012/01", 4, Kind::Date),
            ("03/04", 2, Kind::Date),
            (" 00/5", 3, Kind::Date),
            ("0/05", 1, Kind::Date),
            ("-1/2/", 2, Kind::Date),
            ("1//2", 2, Kind::UnexpectedCharacter('/')),
            ("1.5/2", 3, Kind::UnexpectedCharacter('/')),
            ("--1", 1, Kind::UnexpectedCharacter('-')),
            ("1 2", 2, Kind::UnexpectedCharacter('2')),
            ("\u{2212}1", 0, Kind::UnexpectedCharacter('\u{2212}')),
            ("1\u{2009}000", 1, Kind::UnexpectedCharacter('\u{2009}')),
        ] {
            assert_eq!(read(text), Err(ParseNumberError { position, kind }), "{text:?}");
        }
    }

    #[test]
    fn hostile_numbers_meet_the_limit() {
        let too_large = Kind::ExponentTooLarge(10_000);
        assert_eq!(read("1e999999999"), Err(ParseNumberError { position: 2, kind: too_large.clone() }));
        assert_eq!(read("1e-10001"), Err(ParseNumberError { position: 3, kind: too_large.clone() }));
        let endless = format!("1e{}", "9".repeat(100_000));
        assert_eq!(read(&endless), Err(ParseNumberError { position: 2, kind: too_large }));
        let digits = "7".repeat(20_000);
        let too_many = Err(ParseNumberError { position: 10_000, kind: Kind::TooManyDigits(10_000) });
        assert_eq!(read(&digits), too_many);
        let fraction = format!("0.{digits}");
        let too_many = ParseNumberError { position: 2 + 9_999, kind: Kind::TooManyDigits(10_000) };
        assert_eq!(read(&fraction).unwrap_err(), too_many);
        assert_eq!(too_many.to_string(), "more than 10000 digits (the limit) at character 10002");
        assert!(read(&"7".repeat(10_000)).is_ok());
        assert!(read("1e10000").is_ok());
    }

    #[test]
    fn binary64_is_the_nearest_double_taken_exactly() {
        let read = |text| Reading::Binary64.read(text, &Limits::default());
        assert_eq!(read("0.1"), Ok(Rational::from_f64(0.1).unwrap()));
        assert_eq!(read("1/3"), Ok(Rational::from_f64(1.0 / 3.0).unwrap()));
        assert_eq!(read("0.5"), Ok(Rational::ratio(1, 2)));
        assert_eq!(read("1e-400"), Ok(Rational::zero()));
        assert_eq!(read("1e400").unwrap_err().kind, Kind::Binary64Overflow);
    }

    #[test]
    fn limits_are_told_from_what_is_no_number() {
        for (text, is_limit) in [("1e99999", true), ("x", false), ("", false), ("1/0", false), ("1_0", false)]
        {
            assert_eq!(read(text).unwrap_err().kind.is_limit(), is_limit, "{text:?}");
        }
        assert!(read(&"7".repeat(20_000)).unwrap_err().kind.is_limit());
        assert!(Reading::Binary64.read("1e400", &Limits::default()).unwrap_err().kind.is_limit());
    }
}
