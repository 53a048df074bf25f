//! Numbers from text: decimals, scientific notation and fractions, each read as the exact rational it spells.

use std::borrow::Cow;
use std::fmt;

use serde::Deserialize;
use thiserror::Error;

use crate::notation::SPACES;
use crate::{DecimalMark, Integer, Notation, PLAIN_DIGITS, PLAIN_EXPONENT, Rational, plain_decimal};

/// The limits of a number in a file. A number beyond a limit is refused before it is built.
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

/// The exact number that a text stands for.
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

    /// Reads a number such as `1.30e-2`, `-.5`, `+3` or `7/19`. White space around it is ignored, the spaces of
    /// typesetters too; the minus may be U+2212, and the exponent Fortran's `1.0D+03`.
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
        self.read_written(text, Notation::default(), limits)
    }

    /// Reads a number that is written like this: [`Self::read`] with another decimal mark or with grouped digits.
    ///
    /// ```
    /// use boundfit_exact::{DecimalMark, Limits, Notation, Rational, Reading, Thousands};
    ///
    /// let german = Notation { decimal: DecimalMark::Comma, thousands: Some(Thousands::Point) };
    /// let read = |text| Reading::Decimal.read_written(text, german, &Limits::default());
    /// assert_eq!(read("1.234,5"), Ok(Rational::ratio(12345, 10)));
    /// assert_eq!(read("1.23").unwrap_err().to_string(), "digits that are not in groups of three at character 3");
    /// ```
    ///
    /// # Errors
    /// The errors of [`Self::read`], and an error for digits grouped in any other way than in threes after one to
    /// three digits, of which the first is not 0.
    pub fn read_written(
        self,
        text: &str,
        notation: Notation,
        limits: &Limits,
    ) -> Result<Rational, ParseNumberError> {
        // Most numbers are plain, and within any limit that is not below what plain numbers keep to.
        let is_roomy = limits.digits >= PLAIN_DIGITS && limits.exponent >= PLAIN_EXPONENT;
        let plain = (is_roomy && notation == Notation::default()).then(|| plain_decimal(text.as_bytes()));
        let exact = match plain.flatten() {
            Some((mantissa, exponent)) => Rational::scientific(mantissa, exponent),
            None => Scanner { bytes: text.as_bytes(), text, position: 0, notation, limits }.number()?,
        };
        match self {
            Reading::Decimal => Ok(exact),
            Reading::Binary64 => Rational::from_f64(exact.to_f64())
                .ok_or(ParseNumberError { position: 0, kind: ParseNumberErrorKind::Binary64Overflow }),
        }
    }
}

/// The reason why a text is not a number, and where.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{kind}{}", At(.kind, *.position))]
pub struct ParseNumberError {
    /// The number of characters before the offending one.
    pub position: usize,
    /// The problem at that character.
    pub kind: ParseNumberErrorKind,
}

/// The problem with a text that should be a number.
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
    /// A comma, where the decimal mark is a point.
    #[error("unexpected ',' (the decimal mark is a point)")]
    Comma,
    /// A point, where the decimal mark is a comma.
    #[error("unexpected '.' (the decimal mark is a comma)")]
    Point,
    /// Grouped digits that are not one to three and then groups of three.
    #[error("digits that are not in groups of three")]
    NotInThrees,
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
    /// Returns whether the text is a number, but beyond what is accepted.
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
    notation: Notation,
    limits: &'a Limits,
}

impl Scanner<'_> {
    fn number(mut self) -> Result<Rational, ParseNumberError> {
        self.skip_white_space();
        if self.position == self.bytes.len() {
            return Err(self.error(ParseNumberErrorKind::Empty));
        }
        let negative = self.sign();
        let magnitude = match self.whole_digits()? {
            Cow::Borrowed(whole) if self.next_is(b"/") && !whole.is_empty() => {
                self.position += 1;
                self.fraction(whole)?
            }
            whole => self.decimal(&whole)?,
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
        let fraction = if self.next_is(&[self.notation.decimal.byte()]) {
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

    /// The digits before the decimal mark; a copy of them where they are in groups.
    fn whole_digits<'b>(&mut self) -> Result<Cow<'b, [u8]>, ParseNumberError>
    where
        Self: 'b,
    {
        let start = self.position;
        let first = self.digits(self.limits.digits)?;
        let Some(length) = self.group_mark().filter(|_| !first.is_empty()) else {
            return Ok(Cow::Borrowed(first));
        };
        if first.len() > 3 || first.starts_with(b"0") {
            return Err(self.error_at(start, ParseNumberErrorKind::NotInThrees));
        }
        let mut all = first.to_vec();
        let mut mark = Some(length);
        while let Some(length) = mark {
            self.position += length;
            let start = self.position;
            let group = self.digits(self.limits.digits.saturating_sub(all.len()))?;
            if group.len() != 3 {
                return Err(self.error_at(start, ParseNumberErrorKind::NotInThrees));
            }
            all.extend_from_slice(group);
            mark = self.group_mark();
        }
        Ok(Cow::Owned(all))
    }

    /// Returns how long the mark between groups is that comes next; a blank is one only before a digit.
    fn group_mark(&self) -> Option<usize> {
        let rest = self.text.get(self.position..)?;
        let length = self.notation.thousands?.length_in(rest);
        let is_mark = length > 0
            && (!rest.starts_with(char::is_whitespace)
                || rest.as_bytes().get(length).is_some_and(u8::is_ascii_digit));
        is_mark.then_some(length)
    }

    /// An optional `e±digits`.
    fn exponent(&mut self) -> Result<i64, ParseNumberError> {
        if !self.next_is(b"eEdD") {
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
        let rest = self.bytes.get(self.position..).unwrap_or_default();
        let minus = ["-", "\u{2212}"].into_iter().find(|minus| rest.starts_with(minus.as_bytes()));
        self.position += minus.map_or(usize::from(rest.starts_with(b"+")), str::len);
        minus.is_some()
    }

    fn next_is(&self, any_of: &[u8]) -> bool {
        self.bytes.get(self.position).is_some_and(|byte| any_of.contains(byte))
    }

    fn skip_white_space(&mut self) {
        while let Some(&byte) = self.bytes.get(self.position) {
            self.position += match byte {
                byte if byte.is_ascii_whitespace() => 1,
                128.. => match self.text.get(self.position..).and_then(|rest| rest.chars().next()) {
                    Some(character) if SPACES.contains(&character) => character.len_utf8(),
                    _ => return,
                },
                _ => return,
            };
        }
    }

    /// The error for whatever stands at the current position.
    fn unexpected(&self) -> ParseNumberError {
        let rest = self.text.get(self.position..).unwrap_or_default();
        self.error(match rest.chars().next() {
            None => ParseNumberErrorKind::MissingDigit,
            Some(',') if self.notation.decimal == DecimalMark::Point => ParseNumberErrorKind::Comma,
            Some('.') if self.notation.decimal == DecimalMark::Comma => ParseNumberErrorKind::Point,
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

/// Returns how many characters of a text come before this byte: messages count what people see.
pub fn characters_before(text: &str, byte: usize) -> usize {
    text.char_indices().take_while(|(start, _)| *start < byte).count()
}

fn is_not_finite(text: &str) -> bool {
    let word = text.trim_end().to_ascii_lowercase();
    ["nan", "inf", "infinity"].contains(&word.as_str())
}

#[cfg(test)]
mod tests;
