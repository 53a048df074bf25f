//! What is refused: in the words of the program for whoever asks, and as data for the page, which has words and ways out of its own.

use std::fmt::Display;

use boundfit::engine::estimation::{ParseBoundErrorKind, ParseConditionErrorKind};
use boundfit::engine::exact::{DecimalMark, ParseNumberErrorKind};
use boundfit::engine::formats::{InputError, Place};
use boundfit::files::InputErrorKind;
use boundfit::lesson::LessonError;
use serde::Serialize;
use serde_json::{Value, json};

/// Why there is no answer.
#[derive(Debug)]
pub(crate) struct Refusal {
    /// As the program says it.
    pub(crate) message: String,
    problem: Box<Problem>,
}

/// What is wrong, as data.
#[derive(Debug, Default, Serialize)]
struct Problem {
    /// The name of what is wrong; the page has words for those that it knows.
    kind: &'static str,
    /// In English, without what could be done elsewhere.
    words: String,
    /// The key of the options.
    #[serde(skip_serializing_if = "Option::is_none")]
    key: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<u64>,
    /// The number of the column, and its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    /// What stands there.
    #[serde(skip_serializing_if = "Option::is_none")]
    text: Option<String>,
    /// The character in it, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<usize>,
    /// What a sentence about it needs.
    #[serde(skip_serializing_if = "Option::is_none")]
    values: Option<Value>,
}

/// A name, and what a sentence needs.
type Named = (&'static str, Option<Value>);

impl Refusal {
    /// What is wrong with a text of the options, at a character of it if that is known.
    pub(crate) fn of_text(
        key: &'static str,
        text: &str,
        (kind, values): Named,
        position: Option<usize>,
        problem: impl Display,
        words: String,
    ) -> Self {
        let text = Some(text.to_owned());
        let message = format!("{key}: {:?}: {problem}", text.as_deref().unwrap_or_default());
        Refusal {
            message,
            problem: Box::new(Problem {
                kind,
                words,
                key: Some(key),
                text,
                position,
                values,
                ..Problem::default()
            }),
        }
    }

    /// The data, as JSON.
    pub(crate) fn json(&self) -> String {
        serde_json::to_string(&self.problem).unwrap_or_else(|_| "null".to_owned())
    }
}

impl From<String> for Refusal {
    fn from(message: String) -> Self {
        Refusal { problem: Box::new(Problem { words: message.clone(), ..Problem::default() }), message }
    }
}

impl From<InputError> for Refusal {
    fn from(error: InputError) -> Self {
        let message = error.to_string();
        let Place { line, column, text, .. } = *error.place;
        let (kind, values) = of_input(&error.kind);
        let position = match &error.kind {
            InputErrorKind::NotANumber(number) => position_of(&number.kind, number.position),
            _ => None,
        };
        let (column, name) = column.map_or((None, None), |(column, name)| (Some(column), name));
        let problem = Problem {
            kind,
            words: error.kind.to_string(),
            line,
            column,
            name: name.map(|name| name.to_string()).filter(|name| !name.is_empty()),
            text: text.map(|text| text.to_string()),
            position,
            values,
            ..Problem::default()
        };
        Refusal { message, problem: Box::new(problem) }
    }
}

impl Refusal {
    /// Why there is no lesson about a file.
    pub(crate) fn of_lesson(file: &str, error: &LessonError) -> Self {
        let (kind, values) = match error {
            LessonError::TooManyRows { rows, limit } => {
                ("too-many-readings", Some(json!({"count": rows, "limit": limit})))
            }
            _ => ("", None),
        };
        let words = error.to_string();
        Refusal {
            message: format!("{file}: {error}"),
            problem: Box::new(Problem { kind, words, values, ..Problem::default() }),
        }
    }
}

fn of_input(kind: &InputErrorKind) -> Named {
    let limit = |kind, limit: u64| (kind, Some(json!({"limit": limit})));
    match kind {
        InputErrorKind::NotANumber(error) => of_number(&error.kind),
        InputErrorKind::Comma => ("number-comma", None),
        InputErrorKind::Time => ("time", None),
        InputErrorKind::AnotherDecimalMark { before: DecimalMark::Comma } => ("mark-point", None),
        InputErrorKind::AnotherDecimalMark { before: DecimalMark::Point } => ("mark-comma", None),
        InputErrorKind::NoNumberInFirstRow => ("units", None),
        InputErrorKind::Missing { rows, .. } => ("missing", Some(json!({"count": rows}))),
        InputErrorKind::AllMissing { .. } => ("all-missing", None),
        InputErrorKind::NoDelimiter { .. } => ("delimiter", None),
        InputErrorKind::RaggedRow { found, expected } => {
            ("ragged", Some(json!({"found": found, "expected": expected})))
        }
        InputErrorKind::CommasTwice { found, expected } => {
            ("commas-twice", Some(json!({"found": found, "expected": expected})))
        }
        InputErrorKind::SeveralBlocks { total, .. } => ("several-blocks", Some(json!({"count": total}))),
        InputErrorKind::SameColumn { .. } => ("same-column", None),
        InputErrorKind::NameOrNumber { wanted, .. } => {
            ("name-or-number", Some(json!({"name": wanted.to_string()})))
        }
        InputErrorKind::UnknownColumn { wanted, .. } => {
            ("unknown-column", Some(json!({"name": wanted.to_string()})))
        }
        InputErrorKind::AmbiguousColumn { wanted } => {
            ("several-columns", Some(json!({"name": wanted.to_string()})))
        }
        InputErrorKind::Empty => ("empty", None),
        InputErrorKind::NoRows => ("no-rows", None),
        InputErrorKind::NotUtf8 { .. } | InputErrorKind::Utf16 => ("encoding", None),
        InputErrorKind::BinaryTable { .. } | InputErrorKind::Unreadable { .. } => ("binary", None),
        InputErrorKind::TooManyRows { limit: rows } => limit("too-many-rows", *rows as u64),
        InputErrorKind::TooManyColumns { limit: columns } => limit("too-many-columns", *columns as u64),
        InputErrorKind::OpenQuote | InputErrorKind::RowTooLong { .. } => ("quote", None),
        InputErrorKind::BlanksTwice => ("blanks", None),
        InputErrorKind::NegativeErrorBound => ("negative-bound", None),
        InputErrorKind::NoBound => ("no-bound", None),
        InputErrorKind::NoLastDigit => ("no-last-digit", None),
        InputErrorKind::NoDigits { .. } => ("no-digits", None),
        _ => ("", None),
    }
}

fn of_number(kind: &ParseNumberErrorKind) -> Named {
    use ParseNumberErrorKind as Kind;
    match kind {
        Kind::Empty => ("number-empty", None),
        Kind::MissingDigit => ("number-digit", None),
        Kind::UnexpectedCharacter(_) => ("number", None),
        Kind::Comma => ("number-comma", None),
        Kind::Point => ("number-point", None),
        Kind::NotInThrees | Kind::Underscore => ("number-groups", None),
        Kind::NotFinite => ("number-infinite", None),
        Kind::Date => ("number-date", None),
        Kind::ZeroDenominator => ("number-zero", None),
        Kind::TooManyDigits(_) | Kind::ExponentTooLarge(_) | Kind::Binary64Overflow => ("number-long", None),
    }
}

/// The character from 1 where a number makes no sense, unless it is meant as a whole.
fn position_of(kind: &ParseNumberErrorKind, position: usize) -> Option<usize> {
    use ParseNumberErrorKind::{MissingDigit, UnexpectedCharacter};
    matches!(kind, MissingDigit | UnexpectedCharacter(_)).then_some(position + 1)
}

/// What is wrong with an error bound.
pub(crate) fn of_bound(kind: &ParseBoundErrorKind) -> Named {
    use ParseBoundErrorKind as Kind;
    match kind {
        Kind::NotATerm => ("bound-term", None),
        Kind::NotANumber(number) => of_number(number),
        Kind::NegativeNumber => ("negative-bound", None),
        Kind::PercentOfWhat(share) => ("bound-percent", Some(json!({"share": share.to_string()}))),
        Kind::Digits => ("bound-digits", None),
        Kind::Negative => ("bound-minus", None),
        Kind::NoPlus => ("bound-plus", None),
        Kind::NoBelow => ("bound-below", None),
        Kind::LeastAlone => ("bound-least", None),
    }
}

/// What is wrong with a condition.
pub(crate) fn of_condition(kind: &ParseConditionErrorKind) -> Named {
    use ParseConditionErrorKind as Kind;
    match kind {
        Kind::NotATerm => ("condition-term", None),
        Kind::NotANumber(number) => of_number(number),
        Kind::NoRelation => ("condition-relation", None),
        Kind::WrongRelation => ("condition-strict", None),
        Kind::SecondRelation => ("condition-second", None),
    }
}
