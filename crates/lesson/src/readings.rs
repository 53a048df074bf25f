//! What was measured, and under which model.

use boundfit_estimation::{Condition, ErrorBound, Measurement, Measurements, Model};
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
}

#[derive(Debug, Serialize)]
pub(crate) struct ConditionJson {
    number: usize,
    text: String,
}

pub(crate) fn model(measurements: &Measurements) -> ModelJson {
    let y = measurements.response().to_owned();
    match measurements.model() {
        Model::Line { x } => ModelJson::Line { x: measurements.line_form().abscissa(x), y },
        Model::TwoRegressors { regressors } => ModelJson::TwoRegressors { regressors: regressors.clone(), y },
    }
}

pub(crate) fn epsilon(bound: &ErrorBound) -> EpsilonJson {
    match bound {
        ErrorBound::Uniform(epsilon) => {
            EpsilonJson { uniform: Some(STYLE.given_number(epsilon)), column: None }
        }
        ErrorBound::PerRow(column) => EpsilonJson { uniform: None, column: Some(column.clone()) },
        ErrorBound::Law(law) => EpsilonJson { uniform: None, column: Some(law.text().to_owned()) },
        ErrorBound::Interval { .. } => EpsilonJson { uniform: None, column: None },
    }
}

/// The readings that are fitted.
pub(crate) fn fitted(measurements: &Measurements) -> Vec<ReadingJson> {
    let with_epsilon =
        |row: &Measurement| reading(row, row.half_width().map(|epsilon| STYLE.given_number(&epsilon)));
    measurements.kept().iter().map(with_epsilon).collect()
}

/// Other readings of the file.
pub(crate) fn others(measurements: &Measurements) -> Vec<ReadingJson> {
    let others = measurements.others();
    let spaced = others.iter().step_by(others.len().div_ceil(MOST_OTHERS).max(1));
    spaced.map(|row| reading(row, None)).collect()
}

pub(crate) fn conditions(conditions: &[Condition]) -> Vec<ConditionJson> {
    let numbered = (1..).zip(conditions);
    numbered.map(|(number, condition)| ConditionJson { number, text: condition.text().to_owned() }).collect()
}

fn reading(row: &Measurement, epsilon: Option<Number>) -> ReadingJson {
    ReadingJson {
        row: row.row,
        phi: row.regressor.each_ref().map(|value| STYLE.given_number(value)),
        y: STYLE.given_number(&row.value().unwrap_or_default()),
        epsilon,
    }
}
