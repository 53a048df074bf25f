//! Our own format: `{"status", "objective", "x", "duals", "reduced_costs", "ray", "farkas"}`. Vectors are objects by name, or
//! arrays in the order of the model. A JSON number is the binary64 that it is read as; a text is exact.

use std::collections::HashMap;

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_lp::Printed;
use serde_json::{Value, json};

use super::error::{SolutionError, quoted};
use super::figure::Figure;
use super::{Entry, Reference, SolutionFile, SolverStatus};

const JSON: &str = "JSON";
const FIELDS: &str = "source, status, objective, x, duals, reduced_costs, ray or farkas, see docs/claims.md";
const NUMBER: &str = "a number, or a text like \"1/3\"";

pub(super) fn is_json(text: &str) -> bool {
    text.trim_start_matches('\u{feff}').trim_start().starts_with(['{', '['])
}

pub(super) fn parse(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let text = text.trim_start_matches('\u{feff}');
    let value: Value = serde_json::from_str(text).map_err(SolutionError::Json)?;
    refuse_second_values(text)?;
    let reader = Reader { text, limits };
    let Value::Object(fields) = value else {
        return Err(reader.expected("", &value, "an object with \"status\", \"objective\", \"x\""));
    };
    let mut file = SolutionFile { omits_zero_duals: true, ..SolutionFile::new(JSON) };
    let (mut status, mut prices) = (None, None);
    for (name, value) in &fields {
        match name.as_str() {
            "source" => {}
            "status" => {
                let words =
                    value.as_str().ok_or_else(|| reader.expected(name, value, "a text like \"optimal\""))?;
                (status, file.status_line) = (Some(status_of(words)), reader.line(name));
            }
            "objective" | "x" | "duals" | "reduced_costs" | "ray" | "farkas" if value.is_null() => {}
            "objective" => {
                file.objective = Some((reader.figure(name, value)?, reader.line(name)));
            }
            "x" => file.columns = reader.vector(name, value, false)?,
            "reduced_costs" => prices = Some(reader.vector(name, value, true)?),
            "duals" => (file.rows, file.has_duals) = (reader.vector(name, value, true)?, true),
            "ray" => file.ray = Some(reader.vector(name, value, false)?),
            "farkas" => file.farkas = Some(reader.vector(name, value, false)?),
            _ => return Err(reader.expected(name, value, FIELDS)),
        }
    }
    // Values may be given in another order than prices.
    for price in prices.into_iter().flatten() {
        match file.columns.iter_mut().find(|entry| entry.of == price.of) {
            Some(entry) => (entry.price, entry.price_line) = (price.price, price.line),
            None => file.columns.push(price),
        }
    }
    file.status = match status {
        Some(status) => status,
        None if file.farkas.is_some() => SolverStatus::Infeasible,
        None if file.ray.is_some() => SolverStatus::Unbounded,
        None if !file.columns.is_empty() || file.objective.is_some() => SolverStatus::Optimal,
        None => return Err(SolutionError::End { format: JSON, missing: "\"status\"" }),
    };
    // An optimum without a point has no "x".
    let x = fields.get("x").filter(|_| file.status == SolverStatus::Optimal);
    if let Some(x) = x.filter(|x| **x == json!([]) || **x == json!({})) {
        return Err(reader.expected("x", x, "a number for each column"));
    }
    Ok(file)
}

/// Refuses a text in which an object has a name twice: its reader would keep the last one. Cost: linear.
///
/// # Errors
/// With the first such name. The text must be JSON.
fn refuse_second_values(text: &str) -> Result<(), SolutionError> {
    let mut objects: Vec<HashMap<String, usize>> = Vec::new();
    let (mut rest, mut line) = (text, 1);
    while let Some(start) = rest.find(['{', '}', '"', '\n']) {
        let (_, found) = rest.split_at(start);
        let length = if found.starts_with('"') { length_of_text(found) } else { 1 };
        let (own, after) = found.split_at(length);
        rest = after;
        match own {
            "\n" => line += 1,
            "{" => objects.push(HashMap::new()),
            "}" => drop(objects.pop()),
            _ if after.trim_start().starts_with(':') => {
                let name: String = serde_json::from_str(own).map_err(SolutionError::Json)?;
                let of = quoted(&name);
                if let Some(first) = objects.last_mut().and_then(|object| object.insert(name, line)) {
                    return Err(SolutionError::Twice { line, of, first });
                }
            }
            _ => {}
        }
    }
    Ok(())
}

/// The length of the text in quotes that JSON starts with, both quotes included.
fn length_of_text(json: &str) -> usize {
    let mut is_escaped = false;
    let end = json.bytes().skip(1).position(|byte| {
        let is_end = byte == b'"' && !is_escaped;
        is_escaped = byte == b'\\' && !is_escaped;
        is_end
    });
    end.map_or(json.len(), |end| end + 2)
}

fn status_of(words: &str) -> SolverStatus {
    match words.trim().to_ascii_lowercase().as_str() {
        "optimal" => SolverStatus::Optimal,
        "infeasible" => SolverStatus::Infeasible,
        "unbounded" => SolverStatus::Unbounded,
        "infeasible-or-unbounded" | "infeasible or unbounded" => SolverStatus::InfeasibleOrUnbounded,
        _ => SolverStatus::Other(words.trim().to_owned()),
    }
}

/// A place in a text, for the lines of names that follow each other.
struct Cursor<'a> {
    rest: &'a str,
    line: usize,
}

impl<'a> Cursor<'a> {
    /// Returns where a field is; the first line where it is not found.
    fn at(text: &'a str, field: &str) -> Self {
        let mut cursor = Cursor { rest: text, line: 1 };
        cursor.next(field);
        cursor
    }

    /// The line of the next place of a name. One that is spelled in another way ends the search, so that a text is looked at
    /// once.
    fn next(&mut self, name: &str) -> usize {
        let quoted = Value::from(name).to_string();
        let (before, rest) = self.rest.split_once(&quoted).unwrap_or_default();
        self.line += before.bytes().filter(|byte| *byte == b'\n').count();
        self.rest = rest;
        self.line
    }
}

struct Reader<'a> {
    text: &'a str,
    limits: &'a Limits,
}

impl Reader<'_> {
    /// The line of a field, from 1.
    fn line(&self, field: &str) -> usize {
        Cursor::at(self.text, field).line
    }

    fn expected(&self, field: &str, found: &Value, expected: &'static str) -> SolutionError {
        SolutionError::Field {
            line: self.line(field),
            field: quoted(field),
            found: quoted(&found.to_string()),
            expected,
        }
    }

    fn figure(&self, field: &str, value: &Value) -> Result<Figure, SolutionError> {
        let wrong = || self.expected(field, value, NUMBER);
        match value {
            Value::Number(number) => {
                let double = number.as_f64().and_then(Rational::from_f64).ok_or_else(wrong)?;
                Ok(Figure::Finite(Printed::exact(double)))
            }
            Value::String(text) => {
                let number =
                    Reading::Decimal.read(text, self.limits).map_err(|error| SolutionError::NumberAt {
                        format: JSON,
                        line: self.line(field),
                        text: quoted(text),
                        error,
                    })?;
                Ok(Figure::Finite(Printed::typed(text, number)))
            }
            _ => Err(wrong()),
        }
    }

    fn vector(&self, field: &str, value: &Value, is_price: bool) -> Result<Vec<Entry>, SolutionError> {
        let entry = |of, line, value: &Value| {
            let figure = Some(self.figure(field, value)?);
            let (value, price) = if is_price { (None, figure) } else { (figure, None) };
            Ok(Entry { of, line, value, price, price_line: line })
        };
        let mut cursor = Cursor::at(self.text, field);
        match value {
            Value::Object(entries) => entries
                .iter()
                .map(|(name, value)| entry(Reference::Name(name.clone()), cursor.next(name), value))
                .collect(),
            Value::Array(entries) => {
                let line = self.line(field);
                let places = entries.iter().enumerate();
                places.map(|(place, value)| entry(Reference::Place(place), line, value)).collect()
            }
            Value::Null => Ok(Vec::new()),
            _ => Err(self.expected(field, value, "numbers by name, or an array of them")),
        }
    }
}
