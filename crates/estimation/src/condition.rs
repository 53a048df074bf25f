//! Prior knowledge of the parameters as linear inequalities and equations: `theta1 >= 0`, `2*theta1 - theta2 = 1/3`.

use boundfit_exact::{Foreign, Limits, ParseNumberErrorKind, Rational, Reading};
use boundfit_geometry::Inequality;
use thiserror::Error;

use crate::scanner::{ParseTextError, Scanner, TextProblem};

/// A linear inequality in θ1 and θ2 as text and in ≤ form, or an equation, which is two of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Condition {
    text: Foreign,
    inequality: Inequality,
    is_equation: bool,
}

/// The reason why a text is not a condition, and where.
pub type ParseConditionError = ParseTextError<ParseConditionErrorKind>;

/// The kind of mistake in a text that should be a condition.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ParseConditionErrorKind {
    /// Neither a number nor theta1 nor theta2.
    #[error("neither a number nor theta1 nor theta2")]
    NotATerm,
    /// A number that is not one.
    #[error("{verdict}: {0}", verdict = if .0.is_limit() { "refused" } else { "not a number" })]
    NotANumber(#[from] ParseNumberErrorKind),
    /// No `<=`, `>=` or `=` where one belongs.
    #[error("neither <=, >= nor = nor another term")]
    NoRelation,
    /// A factor or a divisor behind a parameter.
    #[error("a factor or divisor behind a parameter")]
    FactorBehind,
    /// A strict inequality.
    #[error("a strict inequality")]
    WrongRelation,
    /// A second `<=`, `>=` or `=`.
    #[error("a second relation")]
    SecondRelation,
}

impl TextProblem for ParseConditionErrorKind {
    fn has_place(&self) -> bool {
        true
    }

    fn advice(&self) -> Option<&'static str> {
        match self {
            ParseConditionErrorKind::WrongRelation => {
                Some("< and > leave out the boundary, which is part of every set here; <= and >= keep it")
            }
            ParseConditionErrorKind::FactorBehind => {
                Some("write 3*theta2 for theta2*3, 1/3*theta2 for theta2/3")
            }
            _ => None,
        }
    }

    fn expected(&self) -> Option<&'static str> {
        match self {
            ParseConditionErrorKind::NotANumber(kind) if kind.is_limit() => None,
            _ => Some("a condition such as \"2*theta1 - theta2 <= 1/3\" or \"theta2 = 0\""),
        }
    }
}

impl Condition {
    /// Reads a condition: sums of numbers, `theta1`, `theta2` and `number*theta1`, with `<=`, `>=` or `=` between them.
    /// `θ1`, `θ2`, `≤`, `≥`, `==`, a missing `*` and a sign after a sign (`+ -1*theta2`) are understood. Exact as `reading`
    /// says.
    ///
    /// # Errors
    /// With the position where the text stops making sense.
    pub fn parse(text: &str, reading: Reading, limits: &Limits) -> Result<Self, ParseConditionError> {
        Self::parse_words(text, PARAMETERS, reading, limits)
    }

    /// Reads a half-plane or a line of the plane as [`Condition::parse`] does, where the coordinates may be called `x` and `y`
    /// as well.
    ///
    /// # Errors
    /// The errors of [`Condition::parse`].
    pub fn parse_in_plane(
        text: &str,
        reading: Reading,
        limits: &Limits,
    ) -> Result<Self, ParseConditionError> {
        Self::parse_words(text, COORDINATES, reading, limits)
    }

    fn parse_words(
        text: &str,
        words: &'static [&'static str],
        reading: Reading,
        limits: &Limits,
    ) -> Result<Self, ParseConditionError> {
        let parser = Parser { scanner: Scanner::new(text, reading, limits), words };
        let (inequality, is_equation) = parser.condition().map_err(|error| Scanner::place(text, error))?;
        Ok(Condition { text: text.trim().into(), inequality, is_equation })
    }

    /// `theta2 = 0`, as if it had been written: the condition of a line through the origin.
    pub fn no_intercept() -> Self {
        let inequality = Inequality::new(Rational::zero(), Rational::one(), Rational::zero());
        Condition { text: "theta2 = 0".into(), inequality, is_equation: true }
    }

    /// The condition as it was written.
    pub fn text(&self) -> &Foreign {
        &self.text
    }

    /// The condition in ≤ form; of an equation a·θ = b the half-plane a·θ ≤ b.
    pub fn inequality(&self) -> &Inequality {
        &self.inequality
    }

    /// Returns whether it is an equation: the opposite inequality holds, too.
    pub fn is_equation(&self) -> bool {
        self.is_equation
    }

    /// Every half-plane of the condition in ≤ form: one, or of an equation a·θ = b first a·θ ≤ b and then -a·θ ≤ -b.
    pub fn inequalities(&self) -> impl Iterator<Item = Inequality> + '_ {
        let opposite = || {
            let Inequality { a: [a1, a2], b } = &self.inequality;
            Inequality::new(-a1, -a2, -b)
        };
        [self.inequality.clone()].into_iter().chain(self.is_equation.then(opposite))
    }
}

/// The sign between the two sides of a condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Relation {
    AtMost,
    AtLeast,
    Equal,
}

/// The names of θ1 and θ2.
const PARAMETERS: &[&str] = &["theta1", "θ1", "theta2", "θ2"];
/// The names of θ1 and θ2 where the text speaks only of the plane.
const COORDINATES: &[&str] = &["theta1", "θ1", "θ₁", "x", "theta2", "θ2", "θ₂", "y"];

struct Parser<'a> {
    scanner: Scanner<'a>,
    /// Names of the first parameter, then as many of the second.
    words: &'static [&'static str],
}

impl Parser<'_> {
    /// The whole text, in ≤ form, and whether it is an equation; errors count bytes.
    fn condition(mut self) -> Result<(Inequality, bool), ParseConditionError> {
        let left = self.sum()?;
        let relation = self.relation()?;
        let right = self.sum()?;
        if !self.scanner.rest().is_empty() {
            return Err(match self.scanner.rest().starts_with(['<', '>', '=', '≤', '≥']) {
                true => self.scanner.error(ParseConditionErrorKind::SecondRelation),
                false => self.no_relation(),
            });
        }
        let sign = if relation == Relation::AtLeast { -Rational::one() } else { Rational::one() };
        let [a1, a2, b] = [0, 1, 2].map(|i| (&left[i] - &right[i]) * &sign);
        Ok((Inequality::new(a1, a2, -b), relation == Relation::Equal))
    }

    /// Coefficients of θ1, θ2 and 1.
    fn sum(&mut self) -> Result<[Rational; 3], ParseConditionError> {
        let mut total = [Rational::zero(), Rational::zero(), Rational::zero()];
        let mut operator = Some("+");
        while let Some(word) = operator {
            // A program that prints `{a}*theta1 + {b}*theta2` writes `2*theta1 + -1*theta2`.
            let sign = self.scanner.take(&["-", "+"]).unwrap_or("+");
            let (column, value) = self.term()?;
            total[column] = &total[column] + if word == sign { value } else { -value };
            operator = self.scanner.take(&["-", "+"]);
        }
        Ok(total)
    }

    fn term(&mut self) -> Result<(usize, Rational), ParseConditionError> {
        if let Some(column) = self.parameter() {
            return Ok((column, Rational::one()));
        }
        let Some(factor) = self.scanner.number(false)? else {
            return Err(self.scanner.error(ParseConditionErrorKind::NotATerm));
        };
        let starred = self.scanner.take(&["*"]).is_some();
        match self.parameter() {
            Some(column) => Ok((column, factor)),
            None if starred => Err(self.scanner.error(ParseConditionErrorKind::NotATerm)),
            None => Ok((2, factor)),
        }
    }

    fn parameter(&mut self) -> Option<usize> {
        let found = self.scanner.take(self.words)?;
        let position = self.words.iter().position(|word| *word == found)?;
        Some(if position < self.words.len() / 2 { 0 } else { 1 })
    }

    fn relation(&mut self) -> Result<Relation, ParseConditionError> {
        // Longer words first: `=` begins several of them.
        match self.scanner.take(&["<=", "=<", "≤", ">=", "=>", "≥", "==", "="]) {
            Some("<=" | "=<" | "≤") => Ok(Relation::AtMost),
            Some(">=" | "=>" | "≥") => Ok(Relation::AtLeast),
            Some(_) => Ok(Relation::Equal),
            None if self.scanner.rest().starts_with(['<', '>']) => {
                Err(self.scanner.error(ParseConditionErrorKind::WrongRelation))
            }
            None => Err(self.no_relation()),
        }
    }

    /// The error at what is neither a relation nor another term; a comma between digits is meant as a decimal one. A slash behind a
    /// number belongs to the number.
    fn no_relation(&mut self) -> ParseConditionError {
        let mut around = self.scanner.rest().chars();
        let kind = match around.next() {
            Some('*' | '/') => ParseConditionErrorKind::FactorBehind,
            Some(',') if around.next().is_some_and(|next| next.is_ascii_digit()) => {
                ParseNumberErrorKind::Comma.into()
            }
            _ => ParseConditionErrorKind::NoRelation,
        };
        self.scanner.error(kind)
    }
}

#[cfg(test)]
mod tests {
    use super::ParseConditionErrorKind as Kind;
    use super::*;

    fn parse(text: &str) -> Result<Inequality, ParseConditionError> {
        Condition::parse(text, Reading::Decimal, &Limits::default()).map(|condition| condition.inequality)
    }

    #[test]
    fn conditions_become_inequalities_in_at_most_form() {
        let ratio = Rational::ratio;
        for (text, a1, a2, b) in [
            ("theta1 >= 0", ratio(-1, 1), ratio(0, 1), ratio(0, 1)),
            ("2*theta1 - theta2 <= 1/3", ratio(2, 1), ratio(-1, 1), ratio(1, 3)),
            ("θ1≤2.5e-3", ratio(1, 1), ratio(0, 1), ratio(1, 400)),
            ("1 - theta1 + 2 >= -3 theta2 + theta1", ratio(2, 1), ratio(-3, 1), ratio(3, 1)),
            ("-1/2*theta2+theta2 >= 1e+2", ratio(0, 1), ratio(-1, 2), ratio(-100, 1)),
            ("0*theta1 <= -1", ratio(0, 1), ratio(0, 1), ratio(-1, 1)),
            ("0 <= theta2", ratio(0, 1), ratio(-1, 1), ratio(0, 1)),
            ("2*theta1 + -1*theta2 <= -2", ratio(2, 1), ratio(-1, 1), ratio(-2, 1)),
            ("+theta1 - -3*theta2 - +1/2 >= - 4", ratio(-1, 1), ratio(-3, 1), ratio(7, 2)),
        ] {
            assert_eq!(parse(text), Ok(Inequality::new(a1, a2, b)), "{text}");
        }
    }

    #[test]
    fn equations_become_two_inequalities() {
        for text in ["2*theta1 - theta2 = 1/3", "2 theta1 == 1/3 + theta2", "2θ1-θ2=1/3"] {
            let condition = Condition::parse(text, Reading::Decimal, &Limits::default()).unwrap();
            assert!(condition.is_equation(), "{text}");
            let [two, one, third] = [(2, 1), (1, 1), (1, 3)].map(|(p, q)| Rational::ratio(p, q));
            let upper = Inequality::new(two.clone(), -&one, third.clone());
            let lower = Inequality::new(-two, one, -third);
            assert_eq!(condition.inequalities().collect::<Vec<_>>(), [upper, lower], "{text}");
        }
        let no_intercept = Condition::parse("theta2 = 0", Reading::Decimal, &Limits::default());
        assert_eq!(no_intercept, Ok(Condition::no_intercept()));
    }

    #[test]
    fn in_the_plane_coordinates_may_be_called_x_and_y() {
        let parse_in_plane = |text| Condition::parse_in_plane(text, Reading::Decimal, &Limits::default());
        let expected = Condition::parse("2*theta1 - theta2 <= 1/3", Reading::Decimal, &Limits::default());
        let expected = expected.unwrap();
        for text in ["2x - y <= 1/3", "2*θ₁≤1/3+y", "2 θ1 - theta2 ≤ 1/3", "y >= 2x - 1/3"] {
            assert_eq!(parse_in_plane(text).unwrap().inequality(), expected.inequality(), "{text}");
        }
        assert_eq!(
            parse_in_plane("2z <= 1"),
            Err(ParseConditionError { position: 1, kind: Kind::NoRelation })
        );
        assert_eq!(parse("x >= 0"), Err(ParseConditionError { position: 0, kind: Kind::NotATerm }));
    }

    #[test]
    fn what_is_not_a_condition_is_refused_with_its_place() {
        for (text, position, kind) in [
            ("", 0, Kind::NotATerm),
            ("theta1", 6, Kind::NoRelation),
            ("theta1 > 0", 7, Kind::WrongRelation),
            ("theta1 < 0", 7, Kind::WrongRelation),
            ("theta1 === 0", 9, Kind::NotATerm),
            ("theta1 = theta2 = 0", 16, Kind::SecondRelation),
            ("theta1 <= ", 10, Kind::NotATerm),
            ("theta3 >= 0", 0, Kind::NotATerm),
            ("- -theta1 >= 0", 2, Kind::NotATerm),
            ("theta1 + - -theta2 >= 0", 11, Kind::NotATerm),
            ("2*3 >= 0", 2, Kind::NotATerm),
            ("0 <= theta1 <= 1", 12, Kind::SecondRelation),
            ("theta1 >= 10%", 12, Kind::NoRelation),
            ("theta1 * 2 <= 1", 7, Kind::FactorBehind),
            ("theta2/3 >= 1", 6, Kind::FactorBehind),
            ("1.2.3 <= theta1", 3, Kind::NotANumber(ParseNumberErrorKind::UnexpectedCharacter('.'))),
            ("1e999999 <= theta1", 2, Kind::NotANumber(ParseNumberErrorKind::ExponentTooLarge(10_000))),
        ] {
            assert_eq!(parse(text), Err(ParseConditionError { position, kind }), "{text}");
        }
    }
}
