//! The terms of error bounds as data sheets state them, and their texts.

use boundfit_exact::{Foreign, Limits, ParseNumberErrorKind, Rational, Reading};
use thiserror::Error;

use crate::scanner::{ParseTextError, Scanner, TextProblem};

/// The multiple of each quantity; no coefficient is negative.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Terms {
    pub(crate) constant: Rational,
    pub(crate) of_y: Rational,
    pub(crate) of_x: Rational,
    pub(crate) of_range: Rational,
    pub(crate) written: Rational,
}

impl Terms {
    #[cfg(feature = "files")]
    pub(crate) fn formula(&self) -> String {
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

    /// The sum for a reading, but for its multiples of the range of y. Exact.
    pub(crate) fn at(&self, x: &Rational, y: &Rational, written: &Rational) -> Rational {
        let mut sum = self.constant.clone();
        for (times, value) in [(&self.of_y, y), (&self.of_x, x), (&self.written, written)] {
            if !times.is_zero() {
                sum = sum + times * value.abs();
            }
        }
        sum
    }
}

/// The reason why a text is no error bound, and where.
pub type ParseBoundError = ParseTextError<ParseBoundErrorKind>;

/// The kind of mistake in a text that should be an error bound.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ParseBoundErrorKind {
    /// Neither a number nor a quantity.
    #[error("neither a number nor one of |y|, |x|, range(y), written and min")]
    NotATerm,
    /// A number that is not one.
    #[error("{verdict}: {0}", verdict = if .0.is_limit() { "refused" } else { "not a number" })]
    NotANumber(#[from] ParseNumberErrorKind),
    /// A number below 0.
    #[error("negative")]
    NegativeNumber,
    /// A percentage, or parts per million, of nothing.
    #[error(
        "{0} of what? Write {0}*|y| for that share of each reading, {0}*range(y) for that share of the span of all readings; a share of a full scale is a number: 0.2 for 2% of 10"
    )]
    PercentOfWhat(Foreign),
    /// Digits, as multimeters state them.
    #[error(
        "the digits of a data sheet are units of the last digit written, and 'written' is half of one: 3 digits are 6*written, \
         and \"1% + 3 digits\" is 1%*|y| + 6*written"
    )]
    Digits,
    /// A term that is subtracted.
    #[error("a term that is subtracted")]
    Negative,
    /// A second term without a plus before it.
    #[error("neither + nor the end")]
    NoPlus,
    /// A factor or a divisor behind a quantity.
    #[error("a factor behind its quantity")]
    FactorBehind,
    /// Letters behind a number, such as a unit.
    #[error("a unit or a word behind a number")]
    UnitBehind,
    /// An asymmetric law without its lower part.
    #[error("no /- with the bound below")]
    NoBelow,
    /// ε_min with more than a positive factor.
    #[error(
        "min is the least bound that these very readings allow, and nothing but a positive factor goes with it: 1.2*min"
    )]
    LeastAlone,
}

impl TextProblem for ParseBoundErrorKind {
    fn has_place(&self) -> bool {
        use ParseBoundErrorKind::{Digits, LeastAlone, NegativeNumber, PercentOfWhat};
        !matches!(self, Digits | LeastAlone | NegativeNumber | PercentOfWhat(_))
    }

    fn advice(&self) -> Option<&'static str> {
        match self {
            ParseBoundErrorKind::Negative => Some("for another bound above than below write +ABOVE/-BELOW"),
            ParseBoundErrorKind::FactorBehind => Some("write 0.01%*|y|, or 0.001*|y| for |y|/1000"),
            ParseBoundErrorKind::UnitBehind => Some("a bound is a number in the unit of what it bounds"),
            _ => None,
        }
    }

    fn expected(&self) -> Option<&'static str> {
        use ParseBoundErrorKind::{Digits, LeastAlone, NegativeNumber, NotANumber, PercentOfWhat};
        match self {
            NotANumber(kind) if kind.is_limit() => None,
            Digits | LeastAlone | PercentOfWhat(_) => None,
            NotANumber(_) | NegativeNumber => Some("a number that is at least 0, such as 0.5e-3 or 1/2000"),
            _ => Some(
                "a number such as 0.5e-3, or a law such as \"0.05%*|y| + 2e-3\", \"written\" or \"+0.2/-0.1\"",
            ),
        }
    }
}

/// Returns what is taken above y, and below where that is something else.
pub(crate) fn parse_terms(
    text: &str,
    reading: Reading,
    limits: &Limits,
) -> Result<(Terms, Option<Terms>), ParseBoundError> {
    let both = Parser { scanner: Scanner::new(text, reading, limits) }.both(text);
    both.map_err(|error| Scanner::place(text, error))
}

/// Reads a law; errors count bytes.
struct Parser<'a> {
    scanner: Scanner<'a>,
}

impl Parser<'_> {
    /// `SUM` or `+SUM/-SUM`.
    fn both(mut self, text: &str) -> Result<(Terms, Option<Terms>), ParseBoundError> {
        if let Some(position) = ["digit", "dgt"].into_iter().find_map(|word| text.find(word)) {
            return Err(ParseBoundError { position, kind: ParseBoundErrorKind::Digits });
        }
        let is_asymmetric = self.scanner.take(&["+"]).is_some();
        let above = self.sum(is_asymmetric)?;
        let mut below = None;
        if is_asymmetric {
            if self.scanner.take(&["/"]).and_then(|_| self.scanner.take(&["-", "−"])).is_none() {
                return Err(self.scanner.error(ParseBoundErrorKind::NoBelow));
            }
            below = Some(self.sum(false)?);
        }
        let rest = self.scanner.rest();
        match rest.chars().next() {
            None => Ok((above, below)),
            Some('-' | '−') => Err(self.scanner.error(ParseBoundErrorKind::Negative)),
            Some('*' | '·' | '/') => Err(self.scanner.error(ParseBoundErrorKind::FactorBehind)),
            Some(letter) if letter.is_alphabetic() && !rest.starts_with(['x', 'X']) => {
                Err(self.scanner.error(ParseBoundErrorKind::UnitBehind))
            }
            Some(_) => Err(self.scanner.error(ParseBoundErrorKind::NoPlus)),
        }
    }

    /// Terms with a plus between them.
    fn sum(&mut self, is_asymmetric: bool) -> Result<Terms, ParseBoundError> {
        let mut terms = Terms::default();
        loop {
            self.term(&mut terms, is_asymmetric)?;
            if self.scanner.take(&["+"]).is_none() {
                return Ok(terms);
            }
        }
    }

    /// `NUMBER`, `QUANTITY`, `NUMBER*QUANTITY` or `NUMBER%*QUANTITY`, with `ppm` as well as `%`.
    fn term(&mut self, terms: &mut Terms, is_asymmetric: bool) -> Result<(), ParseBoundError> {
        let start = self.scanner.start();
        let number = self.scanner.number(is_asymmetric)?;
        let is_number = number.is_some();
        if !is_number && self.scanner.rest().starts_with(['-', '−']) {
            return Err(self.scanner.error(ParseBoundErrorKind::Negative));
        }
        let mut factor = number.unwrap_or_else(Rational::one);
        let share_word = if is_number { self.scanner.take(&["%", "ppm"]) } else { None };
        let is_share = share_word.is_some();
        if let Some(word) = share_word {
            factor = factor * Rational::ratio(1, if word == "%" { 100 } else { 1_000_000 });
        }
        let share = self.scanner.since(start);
        let is_product = is_number && self.scanner.take(&["*", "·"]).is_some();
        let slot = match self.quantity() {
            Some(Quantity::Y) => &mut terms.of_y,
            Some(Quantity::X) => &mut terms.of_x,
            Some(Quantity::Range) => &mut terms.of_range,
            Some(Quantity::Written) => &mut terms.written,
            None if is_share
                && (!is_product || self.scanner.rest().starts_with(|c: char| c.is_ascii_digit())) =>
            {
                let kind = ParseBoundErrorKind::PercentOfWhat(share.into());
                return Err(ParseBoundError { position: start, kind });
            }
            None if is_number && !is_product => &mut terms.constant,
            None => return Err(self.scanner.error(ParseBoundErrorKind::NotATerm)),
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
        words.into_iter().find(|(words, _)| self.scanner.take(words).is_some()).map(|(_, quantity)| quantity)
    }
}

#[derive(Clone, Copy)]
enum Quantity {
    Y,
    X,
    Range,
    Written,
}
