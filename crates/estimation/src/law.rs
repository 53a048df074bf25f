//! Laws by which data sheets state error bounds: `0.05%*|y| + 2e-3`, `1%*range(y)`, `written`, `+0.2/-0.1`.

use std::fmt;

use boundfit_exact::{Limits, ParseNumberErrorKind, Rational, Reading, characters_before};
use thiserror::Error;

use crate::measurements::{Bounds, Measurement};

/// How far φ·θ may be from each y, as a sum of multiples of what is known of the reading.
///
/// A law that is the same above and below y bounds |e|; `+a/-b` says that φ·θ lies in [y - b, y + a].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Law {
    text: String,
    above: Terms,
    below: Option<Terms>,
}

/// How many times each quantity is taken; no coefficient is negative.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Terms {
    constant: Rational,
    of_y: Rational,
    of_x: Rational,
    of_range: Rational,
    written: Rational,
}

/// Why a text is not a law, and where.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{kind} at character {}{}", position + 1, Expected(.kind))]
pub struct ParseLawError {
    /// How many characters come before.
    pub position: usize,
    /// What is wrong there.
    pub kind: ParseLawErrorKind,
}

/// What is wrong with a text that should be a law.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ParseLawErrorKind {
    /// Neither a number nor a quantity.
    #[error("neither a number nor one of |y|, |x|, range(y), written")]
    NotATerm,
    /// A number that is not one.
    #[error("{verdict}: {0}", verdict = if .0.is_limit() { "refused" } else { "not a number" })]
    NotANumber(ParseNumberErrorKind),
    /// A percentage of nothing.
    #[error("per cent of what? Of each reading it is {0}*|y|, of the span of all readings {0}*range(y)")]
    PercentOfWhat(String),
    /// Digits, as multimeters state them.
    #[error(
        "digits are units of the last digit written, of which 'written' is a half: 3 digits are 6*written, and \"1% + 3 digits\" is 1%*|y| + 6*written"
    )]
    Digits,
    /// A term that is subtracted.
    #[error("a term that is subtracted; for other bounds above than below write +ABOVE/-BELOW")]
    Negative,
    /// A second term without a plus before it.
    #[error("neither + nor the end")]
    NoPlus,
    /// An asymmetric law without its lower part.
    #[error("no /- with the bound below")]
    NoBelow,
}

/// What would be accepted, where the message does not say it itself.
struct Expected<'a>(&'a ParseLawErrorKind);

impl fmt::Display for Expected<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use ParseLawErrorKind::{Digits, NotANumber, PercentOfWhat};
        match self.0 {
            NotANumber(kind) if kind.is_limit() => Ok(()),
            PercentOfWhat(_) | Digits => Ok(()),
            _ => f.write_str(" (expected a law such as \"0.05%*|y| + 2e-3\", \"written\" or \"+0.2/-0.1\")"),
        }
    }
}

impl Law {
    /// Reads a law: a sum of numbers and of multiples of `|y|`, `|x|`, `range(y)` (largest less smallest y of the fitted
    /// readings) and `written` (half a unit of the last digit written of y), with `%` for hundredths; or `+SUM/-SUM` for
    /// other bounds above y than below. Numbers are read as `reading` says, all else is exact.
    ///
    /// # Errors
    /// With the position where the text stops making sense.
    pub fn parse(text: &str, reading: Reading, limits: &Limits) -> Result<Self, ParseLawError> {
        Law::read(text, reading, limits).map_err(|ParseLawError { position, kind }| ParseLawError {
            position: characters_before(text, position),
            kind,
        })
    }

    /// As [`Law::parse`]; errors count bytes.
    fn read(text: &str, reading: Reading, limits: &Limits) -> Result<Self, ParseLawError> {
        if let Some(position) = ["digit", "dgt"].into_iter().find_map(|word| text.find(word)) {
            return Err(ParseLawError { position, kind: ParseLawErrorKind::Digits });
        }
        let mut parser = Parser { text, position: 0, reading, limits };
        let is_asymmetric = parser.take(&["+"]);
        let above = parser.sum(is_asymmetric)?;
        let mut below = None;
        if is_asymmetric {
            if !(parser.take(&["/"]) && parser.take(&["-", "−"])) {
                return Err(parser.error(ParseLawErrorKind::NoBelow));
            }
            below = Some(parser.sum(false)?);
        }
        match parser.rest().chars().next() {
            None => Ok(Law { text: text.trim().to_owned(), above, below }),
            Some('-' | '−') => Err(parser.error(ParseLawErrorKind::Negative)),
            Some(_) => Err(parser.error(ParseLawErrorKind::NoPlus)),
        }
    }

    /// The law as it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The law in the only way in which laws that say the same of every reading are written here, with exact numbers:
    /// `1/20*|y| + 1/500`.
    #[cfg(feature = "files")]
    pub(crate) fn formula(&self) -> String {
        match &self.below {
            None => self.above.formula(),
            Some(below) => format!("+({}) -({})", self.above.formula(), below.formula()),
        }
    }

    /// Whether half units of last digits are asked for.
    pub fn needs_written(&self) -> bool {
        self.parts().any(|terms| !terms.written.is_zero())
    }

    /// Whether the range of y is asked for, which is known when all readings are.
    #[cfg(feature = "files")]
    pub(crate) fn needs_range(&self) -> bool {
        self.parts().any(|terms| !terms.of_range.is_zero())
    }

    /// Whether |x| is asked for, which two regressors do not have.
    pub fn needs_x(&self) -> bool {
        self.parts().any(|terms| !terms.of_x.is_zero())
    }

    /// Whether the bound above y is another one than that below.
    pub fn is_asymmetric(&self) -> bool {
        self.below.is_some()
    }

    /// Whether one number bounds all errors.
    pub fn is_uniform(&self) -> bool {
        self.below.is_none()
            && [&self.above.of_y, &self.above.of_x, &self.above.written].into_iter().all(Rational::is_zero)
    }

    /// The bound on all errors when y has this range, of a law that is uniform. Exact.
    pub fn uniform_bound(&self, range: &Rational) -> Rational {
        &self.above.constant + &self.above.of_range * range
    }

    /// How many times the range of y is taken above and below.
    #[cfg(any(feature = "files", test))]
    fn of_range(&self) -> [&Rational; 2] {
        [&self.above.of_range, &self.below.as_ref().unwrap_or(&self.above).of_range]
    }

    /// What a reading y at x says under this law but for its multiples of the range of y, which [`Law::widen`] adds when all
    /// readings are known. Exact.
    pub(crate) fn bounds(&self, x: &Rational, y: Rational, written: &Rational) -> Bounds {
        let above = self.above.at(x, &y, written);
        match &self.below {
            None => Bounds::Around { response: y, epsilon: above },
            Some(below) => {
                let (lower, upper) = (&y - below.at(x, &y, written), &y + above);
                Bounds::Between { lower: Some(lower), upper: Some(upper), response: Some(y) }
            }
        }
    }

    /// Adds the multiples of the range of y to what readings say. Exact.
    #[cfg(any(feature = "files", test))]
    pub(crate) fn widen(&self, rows: &mut [Measurement], range: &Rational) {
        let [above, below] = self.of_range().map(|times| times * range);
        if above.is_zero() && below.is_zero() {
            return;
        }
        for row in rows {
            match &mut row.bounds {
                Bounds::Around { epsilon, .. } => *epsilon = &*epsilon + &above,
                Bounds::Between { lower, upper, .. } => {
                    *lower = lower.as_ref().map(|lower| lower - &below);
                    *upper = upper.as_ref().map(|upper| upper + &above);
                }
            }
        }
    }

    /// What is taken above y and what below: a constant, when y has this range, and how many times |y|, |x| and `written` are.
    pub fn terms(&self, range: &Rational) -> [(Rational, Vec<(&'static str, Rational)>); 2] {
        [&self.above, self.below.as_ref().unwrap_or(&self.above)].map(|terms| {
            let multiples = [("y", &terms.of_y), ("x", &terms.of_x), ("written", &terms.written)];
            let multiples = multiples.into_iter().filter(|(_, times)| !times.is_zero());
            let constant = &terms.constant + &terms.of_range * range;
            (constant, multiples.map(|(name, times)| (name, times.clone())).collect())
        })
    }

    fn parts(&self) -> impl Iterator<Item = &Terms> {
        [&self.above].into_iter().chain(&self.below)
    }
}

/// The largest less the smallest y of readings; 0 without any. Exact.
pub(crate) fn range_of_y(rows: &[Measurement]) -> Rational {
    let responses = || rows.iter().filter_map(Measurement::response);
    match (responses().max(), responses().min()) {
        (Some(most), Some(least)) => most - least,
        _ => Rational::zero(),
    }
}

impl Terms {
    #[cfg(feature = "files")]
    fn formula(&self) -> String {
        let multiples = [
            ("|y|", &self.of_y),
            ("|x|", &self.of_x),
            ("range(y)", &self.of_range),
            ("written", &self.written),
        ];
        let multiples = multiples.into_iter().filter(|(_, times)| !times.is_zero());
        let mut terms: Vec<String> = multiples.map(|(name, times)| format!("{times}*{name}")).collect();
        if !self.constant.is_zero() || terms.is_empty() {
            terms.push(self.constant.to_string());
        }
        terms.join(" + ")
    }

    fn at(&self, x: &Rational, y: &Rational, written: &Rational) -> Rational {
        let mut sum = self.constant.clone();
        for (times, value) in [(&self.of_y, y), (&self.of_x, x), (&self.written, written)] {
            if !times.is_zero() {
                sum = sum + times * value.abs();
            }
        }
        sum
    }
}

struct Parser<'a> {
    text: &'a str,
    position: usize,
    reading: Reading,
    limits: &'a Limits,
}

impl<'a> Parser<'a> {
    /// Terms with a plus between them.
    fn sum(&mut self, is_asymmetric: bool) -> Result<Terms, ParseLawError> {
        let mut terms = Terms::default();
        loop {
            self.term(&mut terms, is_asymmetric)?;
            if !self.take(&["+"]) {
                return Ok(terms);
            }
        }
    }

    /// `NUMBER`, `QUANTITY`, `NUMBER*QUANTITY` or `NUMBER%*QUANTITY`.
    fn term(&mut self, terms: &mut Terms, is_asymmetric: bool) -> Result<(), ParseLawError> {
        let start = self.position + (self.text.len() - self.position - self.rest().len());
        let mut factor = Rational::one();
        let mut is_number = false;
        let length = number_length(self.rest(), is_asymmetric);
        if length > 0 {
            factor = self.number(length)?;
            is_number = true;
        } else if self.rest().starts_with(['-', '−']) {
            return Err(self.error(ParseLawErrorKind::Negative));
        }
        let is_percent = is_number && self.take(&["%"]);
        if is_percent {
            factor = factor * Rational::ratio(1, 100);
        }
        let number_end = self.position;
        let is_product = is_number && self.take(&["*", "·"]);
        let slot = match self.quantity() {
            Some(Quantity::Y) => &mut terms.of_y,
            Some(Quantity::X) => &mut terms.of_x,
            Some(Quantity::Range) => &mut terms.of_range,
            Some(Quantity::Written) => &mut terms.written,
            None if is_percent && !is_product => {
                let text = self.text[start..number_end].trim().to_owned();
                return Err(ParseLawError { position: start, kind: ParseLawErrorKind::PercentOfWhat(text) });
            }
            None if is_number && !is_product => &mut terms.constant,
            None => return Err(self.error(ParseLawErrorKind::NotATerm)),
        };
        *slot = &*slot + factor;
        Ok(())
    }

    fn quantity(&mut self) -> Option<Quantity> {
        let words: [(&[&'static str], Quantity); 4] = [
            (&["|y|", "abs(y)"], Quantity::Y),
            (&["|x|", "abs(x)"], Quantity::X),
            (&["range(y)"], Quantity::Range),
            (&["written"], Quantity::Written),
        ];
        words.into_iter().find(|(words, _)| self.take(words)).map(|(_, quantity)| quantity)
    }

    fn number(&mut self, length: usize) -> Result<Rational, ParseLawError> {
        let rest = self.rest();
        let value = self.reading.read(&rest[..length], self.limits).map_err(|error| ParseLawError {
            position: self.position + error.position,
            kind: ParseLawErrorKind::NotANumber(error.kind),
        })?;
        self.position += length;
        Ok(value)
    }

    fn take(&mut self, words: &[&str]) -> bool {
        let rest = self.rest();
        let found = words.iter().find(|word| rest.starts_with(**word));
        self.position += found.map_or(0, |word| word.len());
        found.is_some()
    }

    /// What follows the white space at the current position.
    fn rest(&mut self) -> &'a str {
        let rest = &self.text[self.position..];
        let trimmed = rest.trim_start();
        self.position += rest.len() - trimmed.len();
        trimmed
    }

    fn error(&mut self, kind: ParseLawErrorKind) -> ParseLawError {
        self.rest();
        ParseLawError { position: self.position, kind }
    }
}

#[derive(Clone, Copy)]
enum Quantity {
    Y,
    X,
    Range,
    Written,
}

/// How far an unsigned number reaches from the start of a text. A slash before a minus begins the lower part of an
/// asymmetric law.
fn number_length(text: &str, is_asymmetric: bool) -> usize {
    let bytes = text.as_bytes();
    let mut length = 0;
    while let Some(&byte) = bytes.get(length) {
        let before = length.checked_sub(1).map(|before| bytes[before]);
        let is_exponent_sign = matches!(byte, b'+' | b'-') && matches!(before, Some(b'e' | b'E'));
        let is_exponent =
            matches!(byte, b'e' | b'E') && before.is_some_and(|byte| byte.is_ascii_digit() || byte == b'.');
        // There are no fractions of decimals.
        let may_be_above_bar = bytes[..length].iter().all(u8::is_ascii_digit)
            && bytes.get(length + 1).is_some_and(u8::is_ascii_digit);
        let ends_here = byte == b'/' && is_asymmetric && !may_be_above_bar;
        let is_part = byte.is_ascii_digit() || matches!(byte, b'.' | b'/') || is_exponent || is_exponent_sign;
        if !is_part || ends_here {
            break;
        }
        length += 1;
    }
    length
}

#[cfg(test)]
mod tests {
    use super::ParseLawErrorKind as Kind;
    use super::*;

    fn parse(text: &str) -> Result<Law, ParseLawError> {
        Law::parse(text, Reading::Decimal, &Limits::default())
    }

    /// Lower and upper bound of y = -20 at x = 3 with half a unit of 1/2, and a range of y of 10.
    fn at_a_reading(text: &str) -> [Rational; 2] {
        let law = parse(text).unwrap();
        let regressor = [Rational::from(3), Rational::one()];
        let bounds = law.bounds(&regressor[0], Rational::from(-20), &Rational::ratio(1, 2));
        let mut rows = [Measurement { row: 1, regressor, bounds }];
        law.widen(&mut rows, &Rational::from(10));
        [rows[0].lower().unwrap(), rows[0].upper().unwrap()]
    }

    #[test]
    fn laws_are_evaluated_exactly() {
        let ratio = Rational::ratio;
        for (text, below, above) in [
            ("0.05%*|y| + 2e-3", ratio(12, 1000), ratio(12, 1000)),
            ("1/3", ratio(1, 3), ratio(1, 3)),
            ("2%*range(y)", ratio(1, 5), ratio(1, 5)),
            ("written", ratio(1, 2), ratio(1, 2)),
            ("6*written+1%*|y|", ratio(32, 10), ratio(32, 10)),
            ("1/7 * |x| + |x|", ratio(24, 7), ratio(24, 7)),
            ("1e+2%*|y|", ratio(20, 1), ratio(20, 1)),
            ("0", ratio(0, 1), ratio(0, 1)),
            ("+0.2/-0.1", ratio(1, 10), ratio(2, 10)),
            (" + 1/3 / - 1/4 ", ratio(1, 4), ratio(1, 3)),
            ("+0.2+written/-5%*|y| + range(y)", ratio(11, 1), ratio(7, 10)),
            ("+0/-written", ratio(1, 2), ratio(0, 1)),
        ] {
            let y = Rational::from(-20);
            assert_eq!(at_a_reading(text), [&y - below, &y + above], "{text}");
        }
    }

    #[test]
    fn what_is_not_a_law_is_refused_with_its_place_and_advice() {
        let of_what = |text: &str| Kind::PercentOfWhat(text.to_owned());
        for (text, position, kind) in [
            ("", 0, Kind::NotATerm),
            ("2%", 0, of_what("2%")),
            ("1e-3 + 2 %", 7, of_what("2 %")),
            ("1% + 3 digits", 7, Kind::Digits),
            ("1%*|y| + 3 digits", 11, Kind::Digits),
            ("1%*|y| + 3 dgt", 11, Kind::Digits),
            ("|y| - 1", 4, Kind::Negative),
            ("-1", 0, Kind::Negative),
            ("|z|", 0, Kind::NotATerm),
            ("2*", 2, Kind::NotATerm),
            ("2*3", 2, Kind::NotATerm),
            ("2%*3", 3, Kind::NotATerm),
            ("1 |z|", 2, Kind::NoPlus),
            ("+0.2", 4, Kind::NoBelow),
            ("+0.2/0.1", 5, Kind::NoBelow),
            ("1.2.3*|y|", 3, Kind::NotANumber(ParseNumberErrorKind::UnexpectedCharacter('.'))),
        ] {
            assert_eq!(parse(text), Err(ParseLawError { position, kind }), "{text}");
        }
        let message = |text: &str| parse(text).unwrap_err().to_string();
        assert_eq!(
            message("2%"),
            "per cent of what? Of each reading it is 2%*|y|, of the span of all readings 2%*range(y) at character 1"
        );
        assert_eq!(
            message("1%*|z|"),
            "neither a number nor one of |y|, |x|, range(y), written at character 4 (expected a law such as \
             \"0.05%*|y| + 2e-3\", \"written\" or \"+0.2/-0.1\")"
        );
    }
}
