//! The measured data and the model.

use std::borrow::Cow;

use boundfit_estimation::{Condition, ErrorBound, Measurement, Measurements, Model};
use boundfit_exact::{Foreign, Rational};
use boundfit_report::Number;
use serde::Serialize;

use crate::number::STYLE;

/// The most readings that are shown beside the fitted ones; of more, evenly spaced ones.
const MOST_OTHERS: usize = 500;

#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub(crate) enum ModelJson {
    Line { x: String, y: String },
    TwoRegressors { regressors: [String; 2], y: String },
}

#[derive(Debug, Serialize)]
pub(crate) struct EpsilonJson {
    uniform: Option<Number>,
    column: Option<String>,
}

#[derive(Debug, Serialize)]
pub(crate) struct ReadingJson {
    row: usize,
    phi: [Number; 2],
    y: Number,
    /// Absent for readings that are not fitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    epsilon: Option<Number>,
    /// The middle between the bounds, if it is not y.
    #[serde(skip_serializing_if = "Option::is_none")]
    middle: Option<Number>,
    /// The bounds that do not grow.
    #[serde(skip_serializing_if = "Option::is_none")]
    lower: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    upper: Option<Number>,
    /// The cells of the table as they are written, as far as they are known.
    #[serde(skip_serializing_if = "Option::is_none")]
    cells: Option<Vec<String>>,
}

#[derive(Debug, Serialize)]
pub(crate) struct ConditionJson {
    number: usize,
    text: String,
}

pub(crate) fn model(measurements: &Measurements) -> ModelJson {
    let y = measurements.response().label();
    match measurements.model() {
        Model::Line { x } => ModelJson::Line { x: measurements.line_form().abscissa(x).label(), y },
        Model::TwoRegressors { regressors } => {
            ModelJson::TwoRegressors { regressors: regressors.each_ref().map(Foreign::label), y }
        }
    }
}

pub(crate) fn epsilon(bound: &ErrorBound) -> EpsilonJson {
    match bound {
        ErrorBound::Uniform(epsilon) => {
            EpsilonJson { uniform: Some(STYLE.given_number(epsilon)), column: None }
        }
        ErrorBound::Column(column) => EpsilonJson { uniform: None, column: Some(column.label()) },
        ErrorBound::Law(law) => EpsilonJson { uniform: None, column: Some(law.text().to_string()) },
        ErrorBound::Interval { .. } => EpsilonJson { uniform: None, column: None },
    }
}

/// The readings that are fitted.
pub(crate) fn fitted(measurements: &Measurements) -> Vec<ReadingJson> {
    let reading = |row: &Measurement| ReadingJson { cells: cells_of(measurements, row), ..with_bounds(row) };
    measurements.kept().iter().map(reading).collect()
}

/// Other readings of the file.
pub(crate) fn others(measurements: &Measurements) -> Vec<ReadingJson> {
    let other = |row: &Measurement| ReadingJson { cells: cells_of(measurements, row), ..reading(row) };
    shown_others(measurements).into_iter().map(other).collect()
}

fn cells_of(measurements: &Measurements, row: &Measurement) -> Option<Vec<String>> {
    measurements.cells(row.row).map(<[String]>::to_vec)
}

/// Returns the other readings that are shown.
pub(crate) fn shown_others(measurements: &Measurements) -> Vec<&Measurement> {
    let others = measurements.others();
    others.iter().step_by(others.len().div_ceil(MOST_OTHERS).max(1)).collect()
}

pub(crate) fn conditions(conditions: &[Condition]) -> Vec<ConditionJson> {
    let numbered = (1..).zip(conditions);
    numbered.map(|(number, condition)| ConditionJson { number, text: condition.text().to_string() }).collect()
}

/// A reading with its bounds: as a distance from their middle where a factor on it moves them.
fn with_bounds(row: &Measurement) -> ReadingJson {
    let growing = row.half_width().filter(|width| !width.is_negative());
    let given = |value: &Rational| STYLE.given_number(value);
    let fixed = |side: Option<Rational>| side.filter(|_| growing.is_none()).map(|side| given(&side));
    let (value, middle) = (row.value(), row.middle());
    ReadingJson {
        epsilon: growing.as_deref().map(given),
        middle: middle.filter(|_| growing.is_some() && value != row.middle()).as_deref().map(given),
        lower: fixed(row.lower()),
        upper: fixed(row.upper()),
        ..reading(row)
    }
}

/// A reading without its bounds. Where there is neither y nor the middle of two bounds, the one bound stands for them.
fn reading(row: &Measurement) -> ReadingJson {
    let level = row.value().map(Cow::into_owned);
    let level = level.or_else(|| row.lower()).or_else(|| row.upper()).unwrap_or_default();
    ReadingJson {
        row: row.row,
        phi: row.regressor.each_ref().map(|value| STYLE.given_number(value)),
        y: STYLE.given_number(&level),
        epsilon: None,
        middle: None,
        lower: None,
        upper: None,
        cells: None,
    }
}
