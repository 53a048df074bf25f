//! Error bounds as they are asked for: a number, a law of data sheets, or a multiple of ε_min.

use boundfit_exact::{Limits, ParseNumberErrorKind, Rational, Reading};

use crate::law::Law;
use crate::scanner::Scanner;
use crate::terms::{ParseBoundError, ParseBoundErrorKind};

/// An error bound as it is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum AskedBound {
    /// This number; not negative.
    Number(Rational),
    /// A bound that a law gives for each reading.
    Law(Box<Law>),
    /// A positive multiple of ε_min of the same readings.
    TimesLeast(Rational),
}

impl AskedBound {
    /// Reads a number; or `min` and `1.2*min`; or a law, as [`Law::parse`] does. The factor of `min` is read as it is written,
    /// other numbers as `reading` says. Exact.
    ///
    /// # Errors
    /// With the position where the text stops making sense.
    pub fn parse(text: &str, reading: Reading, limits: &Limits) -> Result<Self, ParseBoundError> {
        // No other word of the grammar contains it.
        if text.contains("min") {
            let factor = times_least(text, limits).map_err(|error| Scanner::place(text, error))?;
            return Ok(AskedBound::TimesLeast(factor));
        }
        let number_error = match reading.read(text, limits) {
            Ok(number) if number.is_negative() => {
                return Err(ParseBoundError { position: 0, kind: ParseBoundErrorKind::NegativeNumber });
            }
            Ok(number) => return Ok(AskedBound::Number(number)),
            Err(error) => ParseBoundError { position: error.position, kind: error.kind.into() },
        };
        Law::parse(text, reading, limits).map(|law| AskedBound::Law(Box::new(law))).map_err(|error| {
            use ParseBoundErrorKind::{NoPlus, NotANumber, NotATerm};
            let is_number_meant = match (&error.kind, &number_error.kind) {
                (NoPlus, _) => error.position == number_error.position,
                (NotATerm, NotANumber(ParseNumberErrorKind::NotFinite | ParseNumberErrorKind::Empty)) => true,
                _ => false,
            };
            if is_number_meant { number_error } else { error }
        })
    }
}

/// The factor of `min`; errors count bytes.
fn times_least(text: &str, limits: &Limits) -> Result<Rational, ParseBoundError> {
    let mut scanner = Scanner::new(text, Reading::Decimal, limits);
    let factor = scanner.number(false)?;
    if factor.is_some() {
        scanner.take(&["*", "·"]);
    }
    let is_alone = scanner.take(&["min"]).is_some() && scanner.rest().is_empty();
    let factor = factor.unwrap_or_else(Rational::one);
    if is_alone && factor.is_positive() {
        Ok(factor)
    } else {
        Err(scanner.error(ParseBoundErrorKind::LeastAlone))
    }
}

#[cfg(test)]
mod tests {
    use super::ParseBoundErrorKind as Kind;
    use super::*;

    fn parse(text: &str) -> Result<AskedBound, ParseBoundError> {
        AskedBound::parse(text, Reading::Decimal, &Limits::default())
    }

    #[test]
    fn numbers_multiples_of_the_least_bound_and_laws_are_told_apart() {
        let ratio = Rational::ratio;
        for (text, number) in [
            ("0.5e-3", ratio(1, 2000)),
            ("+0.2", ratio(1, 5)),
            (" 1/3 ", ratio(1, 3)),
            ("1D-1", ratio(1, 10)),
        ] {
            assert_eq!(parse(text), Ok(AskedBound::Number(number)), "{text}");
        }
        for (text, factor) in [
            ("min", ratio(1, 1)),
            (" 1.2*min", ratio(6, 5)),
            ("3/2 * min ", ratio(3, 2)),
            ("2min", ratio(2, 1)),
            ("2 min", ratio(2, 1)),
        ] {
            assert_eq!(parse(text), Ok(AskedBound::TimesLeast(factor)), "{text}");
        }
        for text in ["written", "2*|y|", "0.1 + 0.2", "+0.2/-0.1", "1%*range(y)", "2|x|"] {
            assert!(matches!(parse(text), Ok(AskedBound::Law(law)) if *law.text() == *text), "{text}");
        }
    }

    #[test]
    fn what_is_no_bound_is_refused_with_its_place_and_advice() {
        use ParseNumberErrorKind::{Comma, Empty, MissingDigit, NotFinite, UnexpectedCharacter};
        let of_what = |text: &str| Kind::PercentOfWhat(text.into());
        for (text, position, kind) in [
            ("", 0, Kind::NotANumber(Empty)),
            ("nan", 0, Kind::NotANumber(NotFinite)),
            ("abc", 0, Kind::NotATerm),
            ("1,5", 1, Kind::NotANumber(Comma)),
            ("0x10", 1, Kind::NotANumber(UnexpectedCharacter('x'))),
            ("1e", 2, Kind::NotANumber(MissingDigit)),
            ("2%", 0, of_what("2%")),
            ("1e-3 + 2 %", 7, of_what("2 %")),
            ("35ppm", 0, of_what("35ppm")),
            ("|y|*0.01%", 3, Kind::FactorBehind),
            ("|y|/1000", 3, Kind::FactorBehind),
            ("0.1 mV", 4, Kind::UnitBehind),
            ("0.1mV + 2%*|y|", 3, Kind::UnitBehind),
            ("1% + 3 digits", 7, Kind::Digits),
            ("1%*|y| + 3 digits", 11, Kind::Digits),
            ("1%*|y| + 3 dgt", 11, Kind::Digits),
            ("|y| - 1", 4, Kind::Negative),
            ("|y| + −1", 6, Kind::Negative),
            ("-1", 0, Kind::NegativeNumber),
            ("-|y|", 0, Kind::Negative),
            ("|z|", 0, Kind::NotATerm),
            ("2*", 2, Kind::NotATerm),
            ("2*3", 2, Kind::NotATerm),
            ("2%*3", 0, of_what("2%")),
            ("1 |z|", 2, Kind::NotANumber(UnexpectedCharacter('|'))),
            ("|y| |x|", 4, Kind::NoPlus),
            ("+0.2/0.1", 5, Kind::NoBelow),
            ("+|y|", 4, Kind::NoBelow),
            ("1.2.3*|y|", 3, Kind::NotANumber(UnexpectedCharacter('.'))),
            ("-2*min", 0, Kind::LeastAlone),
            ("0*min", 5, Kind::LeastAlone),
            ("*min", 0, Kind::LeastAlone),
            ("a*min", 0, Kind::LeastAlone),
            ("min + 1", 4, Kind::LeastAlone),
            ("minimum", 3, Kind::LeastAlone),
            ("1.2.3*min", 3, Kind::NotANumber(UnexpectedCharacter('.'))),
        ] {
            assert_eq!(parse(text), Err(ParseBoundError { position, kind }), "{text}");
        }
    }

    #[test]
    fn messages_say_what_to_write() {
        let law = "(expected a number such as 0.5e-3, or a law such as \"0.05%*|y| + 2e-3\", \"written\" or \"+0.2/-0.1\")";
        for (text, message) in [
            (
                "2%",
                "2% of what? Write 2%*|y| for that share of each reading, 2%*range(y) for that share of the span of all readings; a share of a full scale is a number: 0.2 for 2% of 10"
                    .to_owned(),
            ),
            (
                "|y|/1000",
                format!("a factor behind its quantity at character 4: write 0.01%*|y|, or 0.001*|y| for |y|/1000 {law}"),
            ),
            (
                "0.1 mV",
                format!("a unit or a word behind a number at character 5: a bound is a number in the unit of what it bounds {law}"),
            ),
            (
                "1%*|z|",
                format!("neither a number nor one of |y|, |x|, range(y), written and min at character 4 {law}"),
            ),
            (
                "|y| - 1",
                format!(
                    "a term that is subtracted at character 5: for another bound above than below write +ABOVE/-BELOW {law}"
                ),
            ),
            (
                "min + 1",
                "min is the least bound that these very readings allow, and nothing but a positive factor goes with it: 1.2*min"
                    .to_owned(),
            ),
            (
                "1.2.3*|y|",
                "not a number: unexpected character '.' at character 4 (expected a number that is at least 0, such as 0.5e-3 or \
                 1/2000)"
                    .to_owned(),
            ),
        ] {
            assert_eq!(parse(text).unwrap_err().to_string(), message, "{text}");
        }
    }
}
