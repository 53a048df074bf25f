//! A proof as it stands in its file (section 1).

use std::fmt;

use boundfit_exact::{Foreign, Limit, Limits, Rational, Reading};
use serde::de::{Deserializer, Error, Visitor};
use serde::{Deserialize, de};

use crate::name::Named;

/// The fields of the file, tuples included. A text of another shape is no proof.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Shape {
    pub(crate) schema: Foreign,
    pub(crate) sha256: Foreign,
    pub(crate) delimiter: Delimiter,
    pub(crate) header: bool,
    pub(crate) rows: Vec<u64>,
    #[serde(deserialize_with = "reading")]
    pub(crate) reading: Reading,
    pub(crate) model: [(u64, Number); 4],
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) interval: Option<[Option<u64>; 2]>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) law: Option<[Vec<(Quantity, u64, Number)>; 2]>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) x_origin: Option<Number>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) x_error: Option<(u64, Number)>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) response: Option<Vec<(u64, Number)>>,
    pub(crate) conditions: Vec<Condition>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) vertices: Option<Vec<VectorShape>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) active: Option<Vec<(u64, Named)>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) sides: Option<Vec<(Named, Option<u64>)>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) farkas: Option<MultiplesShape>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) bounds: Option<Vec<EndShape>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) statements: Option<Vec<StatementShape>>,
}

/// A statement of version 2: the scope, and the fields of its kind.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StatementShape {
    pub(crate) kind: Foreign,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) rows: Option<Vec<u64>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) without: Option<Vec<u64>>,
    #[serde(default, deserialize_with = "not_null", rename = "where")]
    pub(crate) conditions: Option<Vec<u64>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) factor: Option<Number>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) epsilon: Option<Number>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) side: Option<Foreign>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) form: Option<VectorShape>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) lower: Option<EndShape>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) upper: Option<EndShape>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) point: Option<VectorShape>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) multipliers: Option<MultiplesShape>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) vertices: Option<Vec<VectorShape>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) sides: Option<Vec<(Named, Option<u64>)>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) least: Option<u64>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) sets: Option<Vec<Vec<u64>>>,
    #[serde(default, deserialize_with = "not_null")]
    pub(crate) contradictions: Option<Vec<(Vec<u64>, MultiplesShape)>>,
}

impl StatementShape {
    /// Returns a field of another kind, those of its own having been taken.
    pub(crate) fn other_field(&self) -> Option<&'static str> {
        first_of([
            ("form", self.form.is_some()),
            ("lower", self.lower.is_some()),
            ("upper", self.upper.is_some()),
            ("point", self.point.is_some()),
            ("multipliers", self.multipliers.is_some()),
            ("vertices", self.vertices.is_some()),
            ("sides", self.sides.is_some()),
            ("least", self.least.is_some()),
            ("sets", self.sets.is_some()),
            ("contradictions", self.contradictions.is_some()),
        ])
    }
}

/// A point or a direction.
pub(crate) type VectorShape = [Number; 2];
/// Names and multipliers.
pub(crate) type MultiplesShape = Vec<(Named, Number)>;
/// Multipliers, a point and a ray.
pub(crate) type EndShape = (MultiplesShape, VectorShape, VectorShape);

/// The reason why a text is no proof.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{reason}")]
pub struct NotAProof {
    reason: Foreign,
    limit: Option<Limit>,
}

impl NotAProof {
    pub(crate) fn new(reason: impl fmt::Display) -> Self {
        NotAProof { reason: Foreign::from(reason.to_string()), limit: None }
    }

    /// The problem with a text that is neither kind of file, or has another schema: what a proof would have.
    pub(crate) fn unlike(reason: impl fmt::Display) -> Self {
        NotAProof::new(format_args!(
            "{reason} (expected JSON of schema boundfit/proof/1 or boundfit/proof/2, or a theorem of boundfit for Coq)"
        ))
    }

    /// The problem, with the number of the statement that has it.
    pub(crate) fn in_statement(self, number: usize) -> Self {
        NotAProof { reason: format!("statement {number}: {}", self.reason.raw()).into(), ..self }
    }

    /// The limit that was passed, if that is the problem.
    pub fn limit(&self) -> Option<Limit> {
        self.limit
    }
}

impl Shape {
    /// Reads JSON: an object in UTF-8 without a byte order mark, no field twice, no number of more digits than this.
    pub(crate) fn read(text: &[u8], most_digits: usize) -> Result<Self, NotAProof> {
        let is_object = text.trim_ascii_start().starts_with(b"{");
        if !is_object {
            let (line, start) = first_line(text);
            return Err(NotAProof::unlike(format_args!("line {line} begins with {start:?}, not with {{")));
        }
        check_digits(text, most_digits)?;
        serde_json::from_slice(text).map_err(|error| NotAProof::unlike(in_plain_words(&error.to_string())))
    }

    /// Returns a field of another version, those of this one having been taken.
    pub(crate) fn other_field(&self, is_of_statements: bool) -> Option<&'static str> {
        first_of([
            ("vertices", self.vertices.is_some()),
            ("active", self.active.is_some()),
            ("sides", self.sides.is_some()),
            ("farkas", self.farkas.is_some()),
            ("bounds", self.bounds.is_some()),
            ("statements", self.statements.is_some()),
            ("x_error", self.x_error.is_some() && !is_of_statements),
            ("response", self.response.is_some() && !is_of_statements),
        ])
    }

    /// Refuses a field of another version.
    pub(crate) fn refuse_others(&self, is_of_statements: bool) -> Result<(), NotAProof> {
        self.other_field(is_of_statements).map_or(Ok(()), |field| {
            Err(NotAProof::new(format_args!(
                "the schema {} has no field {field:?}",
                self.schema.borrowed().quoted()
            )))
        })
    }
}

fn first_of<const N: usize>(fields: [(&'static str, bool); N]) -> Option<&'static str> {
    fields.into_iter().find(|(_, is_there)| *is_there).map(|(field, _)| field)
}

/// The words of serde about a field that is missing, there twice or unknown, as people say it.
fn in_plain_words(problem: &str) -> String {
    let about = |words: &str| problem.strip_prefix(words)?.split_once('`');
    match (about("missing field `"), about("duplicate field `"), about("unknown field `")) {
        (Some((field, _)), ..) => without(field),
        (_, Some((field, place)), _) => format!("{field:?} is there twice{place}"),
        (.., Some((field, _))) => format!("there is no field {field:?} in a proof"),
        _ => problem.to_owned(),
    }
}

fn without(field: &str) -> String {
    format!("it has no {field:?}")
}

/// Returns the number of the first line that is not blank, and its beginning.
fn first_line(text: &[u8]) -> (usize, String) {
    let text = String::from_utf8_lossy(text);
    let line = (1..).zip(text.lines()).find(|(_, line)| !line.trim().is_empty());
    let (number, line) = line.unwrap_or((1, ""));
    (number, beginning(line))
}

/// Returns the beginning of a line.
pub(crate) fn beginning(line: &str) -> String {
    const MOST: usize = 40;
    line.chars().take(MOST).collect()
}

/// Refuses a number of more digits than this.
pub(crate) fn check_digits(text: &[u8], most_digits: usize) -> Result<(), NotAProof> {
    if text.split(|byte| !byte.is_ascii_digit()).any(|run| run.len() > most_digits) {
        let reason = format!("refused: a number with more than {most_digits} digits (10 times the limit)");
        return Err(NotAProof { limit: Some(Limit::Digits), ..NotAProof::new(reason) });
    }
    Ok(())
}

/// A field that what it stands in must have.
pub(crate) fn needed<T>(field: Option<T>, name: &str) -> Result<T, NotAProof> {
    field.ok_or_else(|| NotAProof::new(without(name)))
}

/// A number of a proof: a whole number or a fraction, in digits and with nothing else but a minus.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Number(pub(crate) Rational);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        text(deserializer, "a whole number or a fraction as text", |text| {
            let limits = Limits { digits: text.len(), exponent: 0 };
            let has_only_digits =
                text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'/'));
            let digits = text.strip_prefix('-').unwrap_or(text);
            let has_zero_in_front =
                digits.starts_with('0') && digits.as_bytes().get(1).is_some_and(u8::is_ascii_digit);
            let is_plain = has_only_digits && !has_zero_in_front;
            Reading::Decimal.read(text, &limits).ok().filter(|_| is_plain).map(Number)
        })
    }
}

/// The separator of cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Delimiter(pub(crate) u8);

impl<'de> Deserialize<'de> for Delimiter {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        text(deserializer, "\",\" \";\" \"\\t\" or \"|\"", |text| match text.as_bytes() {
            [byte @ (b',' | b';' | b'\t' | b'|')] => Some(Delimiter(*byte)),
            _ => None,
        })
    }
}

/// The quantity that is taken from a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// The number.
    Number,
    /// The number without its sign: `abs`.
    Abs,
    /// Half a unit of the last digit written: `written`.
    Written,
}

/// The quantities that a law may take.
impl<'de> Deserialize<'de> for Quantity {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        text(deserializer, "\"abs\" or \"written\"", |text| match text {
            "abs" => Some(Quantity::Abs),
            "written" => Some(Quantity::Written),
            _ => None,
        })
    }
}

/// a1, a2 and b of a condition, and whether it is an equation: `["a1", "a2", "b"]`, or with a fourth text `"="`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Condition {
    pub(crate) numbers: [Rational; 3],
    pub(crate) is_equation: bool,
}

impl<'de> Deserialize<'de> for Condition {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Parts;
        impl<'de> Visitor<'de> for Parts {
            type Value = Condition;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("three numbers, and \"=\" behind them for an equation")
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, mut parts: A) -> Result<Condition, A::Error> {
                let mut number = |count| {
                    let number = parts.next_element::<Number>()?;
                    number.map(|Number(number)| number).ok_or_else(|| A::Error::invalid_length(count, &Parts))
                };
                let numbers = [number(0)?, number(1)?, number(2)?];
                let is_equation = parts.next_element::<Equals>()?.is_some();
                Ok(Condition { numbers, is_equation })
            }
        }
        deserializer.deserialize_seq(Parts)
    }
}

struct Equals;

impl<'de> Deserialize<'de> for Equals {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        text(deserializer, "\"=\"", |text| (text == "=").then_some(Equals))
    }
}

fn reading<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Reading, D::Error> {
    text(deserializer, "\"decimal\" or \"binary64\"", |text| {
        Reading::ALL.into_iter().find(|reading| reading.name() == text)
    })
}

/// A field that may be left out, but not be null.
fn not_null<'de, T: Deserialize<'de>, D: Deserializer<'de>>(deserializer: D) -> Result<Option<T>, D::Error> {
    T::deserialize(deserializer).map(Some)
}

/// Returns what a text stands for.
fn text<'de, T, D: Deserializer<'de>>(
    deserializer: D,
    expected: &'static str,
    parse: impl Fn(&str) -> Option<T>,
) -> Result<T, D::Error> {
    struct Text<F>(&'static str, F);
    impl<T, F: Fn(&str) -> Option<T>> Visitor<'_> for Text<F> {
        type Value = T;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str(self.0)
        }

        fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
            (self.1)(text).ok_or_else(|| E::invalid_value(de::Unexpected::Str(text), &self))
        }
    }
    deserializer.deserialize_str(Text(expected, parse))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_proofs_are_whole_numbers_and_fractions() {
        let read = |text: &str| {
            serde_json::from_str::<Number>(&format!("{text:?}")).ok().map(|number| number.0.to_string())
        };
        for (text, number) in
            [("0", "0"), ("-12", "-12"), ("6/4", "3/2"), ("-0", "0"), ("-1/3", "-1/3"), ("0/5", "0")]
        {
            assert_eq!(read(text).as_deref(), Some(number), "{text}");
        }
        for text in [
            "",
            "-",
            "+1",
            "0.5",
            "1e1",
            "1e1000000",
            " 1",
            "1 ",
            "01",
            "-01",
            "1/0",
            "1/02",
            "01/2",
            "1/-2",
            "1/2/3",
            "/2",
            "1/",
            "--1",
            "\u{2212}1",
            "\u{660}",
            "1d0",
            "1.",
        ] {
            assert_eq!(read(text), None, "{text:?}");
        }
    }
}
