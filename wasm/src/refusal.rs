//! Refusals: in words with the keys that help the caller, and as data for the page, which has words and remedies of
//! its own.

use boundfit::ask::{self, Surface, ValueProblem};
use boundfit::engine::estimation::{ParseBoundErrorKind, ParseConditionErrorKind, TextProblem};
use boundfit::engine::exact::{DecimalMark, Limit, ParseNumberErrorKind};
use boundfit::engine::formats::{InputError, Place, Setting};
use boundfit::files::{InputErrorKind, Way};
use boundfit::lesson::{LONGEST_TEXT, LessonError, MOST_HALF_PLANES, PolytopeError};
use serde::Serialize;
use serde_json::{Value, json};

/// The reason why there is no answer.
#[derive(Debug)]
pub(crate) struct Refusal {
    /// The program's message, with keys in the place of its options.
    pub(crate) message: String,
    problem: Box<Problem>,
}

/// The fault, as data.
#[derive(Debug, Default, Serialize)]
struct Problem {
    /// The name of what is wrong; the page has words for those that it knows.
    kind: &'static str,
    /// The fault in English, without remedies on other surfaces.
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
    /// The text at the place.
    #[serde(skip_serializing_if = "Option::is_none")]
    text: Option<String>,
    /// The character in it, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<usize>,
    /// The values that a sentence about it needs.
    #[serde(skip_serializing_if = "Option::is_none")]
    values: Option<Value>,
}

/// A name, and what a sentence needs.
type Named = (&'static str, Option<Value>);

impl Refusal {
    /// The data, as JSON.
    pub(crate) fn json(&self) -> String {
        serde_json::to_string(&self.problem).unwrap_or_else(|_| "null".to_owned())
    }

    /// Returns the refusal of a question about a file.
    pub(crate) fn of_file(file: &str, refusal: ask::Refusal) -> Self {
        let says_file = refusal.names_file() || refusal.is_misuse();
        let own = Refusal::from(refusal);
        if says_file { own } else { Refusal { message: format!("{file}: {}", own.message), ..own } }
    }
}

impl From<String> for Refusal {
    fn from(message: String) -> Self {
        Refusal { problem: Box::new(Problem { words: message.clone(), ..Problem::default() }), message }
    }
}

/// The names of settings in the words of keys.
struct Keys;

impl Surface for Keys {
    fn key(&self, key: &str) -> String {
        key.to_owned()
    }

    fn value(&self, key: &str, text: &str) -> String {
        format!("{key}: {text:?}")
    }

    /// `decimal: "comma" reads 1,5`.
    fn way(&self, way: &Way) -> String {
        let Way { setting, value, effect } = way;
        match setting {
            // They have keys of their own.
            Setting::Limit(Limit::Steps) => format!("max_steps: N {effect}"),
            Setting::Limit(Limit::Readings) => format!("max_readings: N {effect}"),
            Setting::Limit(limit) => format!("limits: {{{:?}: N}} {effect}", limit.name()),
            Setting::SkipLines => format!("skip_lines: {value} {effect}"),
            Setting::UnitsRow => format!("units_row: true {effect}"),
            setting => format!("{}: {:?} {effect}", setting.name(), value.trim_matches('\'')),
        }
    }
}

impl From<ask::Refusal> for Refusal {
    fn from(refusal: ask::Refusal) -> Self {
        let message = refusal.words(&Keys);
        let problem = match refusal {
            ask::Refusal::Input(error) => of_error(error),
            ask::Refusal::Value { key, text, problem } => of_value(key, text, &problem),
            refusal => Problem { words: refusal.sentence(&Keys), ..Problem::default() },
        };
        Refusal { message, problem: Box::new(problem) }
    }
}

impl From<InputError> for Refusal {
    fn from(error: InputError) -> Self {
        ask::Refusal::Input(error).into()
    }
}

/// Returns the fault of a table.
fn of_error(error: InputError) -> Problem {
    let Place { line, column, text, .. } = *error.place;
    let (kind, values) = of_input(&error.kind);
    let position = match &error.kind {
        InputErrorKind::NotANumber(number) => position_of(&number.kind, number.position),
        _ => None,
    };
    let (column, name) = column.map_or((None, None), |(column, name)| (Some(column), name));
    Problem {
        kind,
        words: error.kind.to_string(),
        line,
        column,
        name: name.map(|name| name.to_string()).filter(|name| !name.is_empty()),
        text: text.map(|text| text.to_string()),
        position,
        values,
        ..Problem::default()
    }
}

/// Returns the fault of a value of the options, at a character of it if that is known.
fn of_value(key: &'static str, text: String, problem: &ValueProblem) -> Problem {
    let (named, position, words) = match problem {
        ValueProblem::Bound(error) => {
            let position = error.kind.has_place().then_some(error.position + 1);
            (of_bound(&error.kind), position, error.kind.to_string())
        }
        ValueProblem::Condition(error) => {
            (of_condition(&error.kind), Some(error.position + 1), error.kind.to_string())
        }
        ValueProblem::LawOfX => (("bound-x", None), None, problem.words()),
        _ => (("", None), None, problem.words()),
    };
    let (kind, values) = named;
    Problem { kind, words, key: Some(key), text: Some(text), position, values, ..Problem::default() }
}

impl Refusal {
    /// Returns the reason why there is no lesson about a file.
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

    /// Returns the refusal of half-planes without readings.
    pub(crate) fn of_half_planes(error: &PolytopeError) -> Self {
        let (kind, values) = match error {
            PolytopeError::TooMany(count) => {
                ("too-many-half-planes", Some(json!({"count": count, "limit": MOST_HALF_PLANES})))
            }
            PolytopeError::TooLong(_) => ("half-planes-too-long", Some(json!({"limit": LONGEST_TEXT}))),
            _ => ("", None),
        };
        let words = error.to_string();
        Refusal {
            message: words.clone(),
            problem: Box::new(Problem { kind, words, values, ..Problem::default() }),
        }
    }

    /// A refusal for which the page has no words of its own.
    pub(crate) fn of_words(words: String) -> Self {
        Refusal { message: words.clone(), problem: Box::new(Problem { words, ..Problem::default() }) }
    }
}

fn of_input(kind: &InputErrorKind) -> Named {
    let limit = |kind, limit: u64| (kind, Some(json!({"limit": limit})));
    match kind {
        InputErrorKind::NotANumber(error) => of_number(&error.kind),
        InputErrorKind::UnitBehind => ("number-unit", None),
        InputErrorKind::Comma => ("number-comma", None),
        InputErrorKind::Time => ("time", None),
        InputErrorKind::AnotherDecimalMark { before: DecimalMark::Comma } => ("mark-point", None),
        InputErrorKind::AnotherDecimalMark { before: DecimalMark::Point } => ("mark-comma", None),
        InputErrorKind::NoNumberInFirstRow { .. } => ("units", None),
        InputErrorKind::NumbersAsUnits => ("numbers-as-units", None),
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
        InputErrorKind::BehindQuotes => ("behind-quote", None),
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

/// Returns the fault of an error bound.
fn of_bound(kind: &ParseBoundErrorKind) -> Named {
    use ParseBoundErrorKind as Kind;
    match kind {
        Kind::NotATerm => ("bound-term", None),
        Kind::NotANumber(number) => of_number(number),
        Kind::NegativeNumber => ("negative-bound", None),
        Kind::PercentOfWhat(share) => ("bound-percent", Some(json!({"share": share.to_string()}))),
        Kind::Digits => ("bound-digits", None),
        Kind::Negative => ("bound-minus", None),
        Kind::NoPlus => ("bound-plus", None),
        Kind::FactorBehind => ("bound-factor", None),
        Kind::UnitBehind => ("bound-unit", None),
        Kind::NoBelow => ("bound-below", None),
        Kind::LeastAlone => ("bound-least", None),
    }
}

/// Returns the fault of a condition.
fn of_condition(kind: &ParseConditionErrorKind) -> Named {
    use ParseConditionErrorKind as Kind;
    match kind {
        Kind::NotATerm => ("condition-term", None),
        Kind::NotANumber(number) => of_number(number),
        Kind::NoRelation => ("condition-relation", None),
        Kind::FactorBehind => ("condition-factor", None),
        Kind::WrongRelation => ("condition-strict", None),
        Kind::SecondRelation => ("condition-second", None),
    }
}
