//! Problems with a value of a request.

use std::ops::RangeInclusive;

use boundfit_estimation::{
    ParseBoundError, ParseBoundErrorKind, ParseConditionError, ParseConditionErrorKind, ParseTextError,
    TextProblem,
};
use boundfit_exact::{Limit, ParseNumberError, ParseNumberErrorKind};
use boundfit_formats::ParseRowConditionError;

/// A problem with a value.
#[derive(Debug)]
pub enum ValueProblem {
    /// The value is no number, or one beyond a limit.
    Number {
        /// The problem with it.
        error: ParseNumberError,
        /// The expectation.
        expected: &'static str,
    },
    /// A part of it is no number, or one beyond a limit.
    Part {
        /// The part.
        part: String,
        /// The problem with it.
        error: ParseNumberError,
        /// The expectation.
        expected: &'static str,
    },
    /// The number is below 0, where this was expected.
    Negative(&'static str),
    /// The value is no error bound.
    Bound(ParseBoundError),
    /// The value is a law of |x|, and two regressors have none.
    LawOfX,
    /// The value is no condition.
    Condition(ParseConditionError),
    /// The value is no condition on rows.
    RowCondition(ParseRowConditionError),
    /// The value is none of these words.
    OneOf(Vec<String>),
    /// The value is no number that the limit with this name may be set to.
    Range {
        /// The limit.
        name: &'static str,
        /// The numbers that it may be.
        range: RangeInclusive<u64>,
    },
    /// The value is something else than this.
    Expected(&'static str),
    /// The value asks for more than a limit allows.
    TooMany {
        /// The number that is allowed.
        most: usize,
        /// The limit.
        limit: Limit,
    },
    /// Something else.
    Other(String),
}

impl ValueProblem {
    /// The limit that it passes.
    pub(crate) fn limit(&self) -> Option<Limit> {
        match self {
            ValueProblem::TooMany { limit, .. } => Some(*limit),
            _ => self.number().and_then(Limit::of_number),
        }
    }

    /// The number that is none.
    fn number(&self) -> Option<&ParseNumberErrorKind> {
        match self {
            ValueProblem::Number { error, .. } | ValueProblem::Part { error, .. } => Some(&error.kind),
            ValueProblem::Bound(error) => of_bound(error),
            ValueProblem::Condition(error) => of_condition(error),
            ValueProblem::RowCondition(ParseRowConditionError::NotANumber { error, .. }) => Some(&error.kind),
            _ => None,
        }
    }

    /// Returns whether the text may be the name of a column, in place of an error bound.
    pub(crate) fn may_name_a_column(&self, text: &str) -> bool {
        let is_no_term =
            matches!(self, ValueProblem::Bound(error) if error.kind == ParseBoundErrorKind::NotATerm);
        is_no_term && text.chars().all(|letter| letter.is_alphanumeric() || letter == '_')
    }

    /// Says the problem in words.
    pub fn words(&self) -> String {
        match self {
            ValueProblem::Number { error, expected } => number_problem(error, expected),
            ValueProblem::Part { part, error, expected } => {
                format!("{part:?}: {}", number_problem(error, expected))
            }
            ValueProblem::Negative(expected) => format!("negative ({expected})"),
            ValueProblem::Bound(error) => text_problem(error, of_bound(error)),
            ValueProblem::LawOfX => no_law_of_x("|y|, range(y) and written"),
            ValueProblem::Condition(error) => text_problem(error, of_condition(error)),
            ValueProblem::RowCondition(error) if self.limit().is_some() => error.to_string(),
            ValueProblem::RowCondition(error) => format!(
                "{error} (expected a column, one of < <= = != >= >, and a number, such as 'temperature >= 20')"
            ),
            ValueProblem::OneOf(names) => {
                let names: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
                format!("expected one of {}", names.join(", "))
            }
            ValueProblem::Range { name, range } if *range.end() == u64::MAX => {
                format!("no value of the limit {name} (expected an integer from {})", range.start())
            }
            ValueProblem::Range { name, range } => {
                format!(
                    "no value of the limit {name} (expected an integer from {} to {})",
                    range.start(),
                    range.end()
                )
            }
            ValueProblem::Expected(expected) => (*expected).to_owned(),
            ValueProblem::TooMany { most, .. } => format!("refused: more than {most} values"),
            ValueProblem::Other(problem) => problem.clone(),
        }
    }
}

/// Says that two regressors have laws of these terms alone.
pub(crate) fn no_law_of_x(terms: &str) -> String {
    format!("two regressors have no |x| (expected a law of {terms})")
}

fn of_bound(error: &ParseBoundError) -> Option<&ParseNumberErrorKind> {
    match &error.kind {
        ParseBoundErrorKind::NotANumber(kind) => Some(kind),
        _ => None,
    }
}

fn of_condition(error: &ParseConditionError) -> Option<&ParseNumberErrorKind> {
    match &error.kind {
        ParseConditionErrorKind::NotANumber(kind) => Some(kind),
        _ => None,
    }
}

/// Returns the problem with a text; where that is a number in it, as it is said of every number.
fn text_problem<K: TextProblem>(error: &ParseTextError<K>, number: Option<&ParseNumberErrorKind>) -> String {
    match number {
        Some(kind) => {
            let expected = error.kind.expected().unwrap_or_default();
            let number = ParseNumberError { position: error.position, kind: kind.clone() };
            number_problem(&number, &format!("expected {expected}"))
        }
        None => error.to_string(),
    }
}

/// Returns the problem with a number: that it is none, with what was expected, or that it passes a limit.
fn number_problem(error: &ParseNumberError, expected: &str) -> String {
    match &error.kind {
        kind if kind.is_limit() => format!("refused: {error}"),
        ParseNumberErrorKind::Comma => {
            format!(
                "not a number: {error} (a point comes before decimals, whatever the data have: 1.5, not 1,5)"
            )
        }
        _ => format!("not a number: {error} ({expected})"),
    }
}
