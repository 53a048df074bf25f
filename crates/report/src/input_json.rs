//! The subject of a report, as JSON: the file, the rows, the model and the error bound.

use boundfit_estimation::{
    ErrorBound, FractionCells, Measurements, Model, MultipleOfLeast, Problem, Selection,
};
use boundfit_exact::Foreign;
use boundfit_exact::english::{split_unit, unit_by};

use crate::answer::input::{
    FractionsJson, FromLeastJson, InputJson, IntervalColumnsJson, SelectionJson, UnitsJson,
};
use crate::answer::table::TableJson;
use crate::origin::Origin;
use crate::style::Style;

impl UnitsJson {
    /// `None` where no name has a unit.
    fn new(model: &Model, y: Option<&Foreign>) -> Option<Self> {
        let unit_of = |name: &Foreign| split_unit(name.raw()).1.map(ToOwned::to_owned);
        let y = y.and_then(unit_of);
        let slope = |x: &Option<String>| y.as_deref().zip(x.as_deref()).map(|(y, x)| unit_by(y, x));
        let units = match model {
            Model::Line { x } => {
                let x = unit_of(x);
                UnitsJson { theta1: slope(&x), theta2: y.clone(), x: vec![x], y }
            }
            Model::TwoRegressors { regressors } => {
                let [first, second] = regressors.each_ref().map(unit_of);
                UnitsJson { theta1: slope(&first), theta2: slope(&second), x: vec![first, second], y }
            }
        };
        let is_known = units.y.is_some() || units.x.iter().any(Option::is_some);
        is_known.then_some(units)
    }
}

impl InputJson {
    /// Returns the description of the question.
    pub(crate) fn new(problem: &Problem, origin: &Origin, style: &Style) -> Self {
        let measurements = &problem.measurements;
        let form = measurements.line_form();
        let (model, x) = match measurements.model() {
            Model::Line { x } if form.through_origin => ("line-through-origin", vec![x.clone()]),
            Model::Line { x } => ("line", vec![x.clone()]),
            Model::TwoRegressors { regressors } => ("two-regressors", regressors.to_vec()),
        };
        let (epsilon, epsilon_column) = match measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => (Some(style.upper_number(epsilon)), None),
            ErrorBound::Column(column) => (None, Some(column.clone())),
            ErrorBound::Interval { .. } | ErrorBound::Law(_) => (None, None),
        };
        let interval = match measurements.error_bound() {
            ErrorBound::Interval { lower, upper } => {
                Some(IntervalColumnsJson { lower: lower.clone(), upper: upper.clone() })
            }
            _ => None,
        };
        InputJson {
            file: origin.file.map(Foreign::from),
            rows: measurements.fitted(),
            rows_total: measurements.rows_total(),
            selection: selection(measurements.selection()),
            rows_missing: measurements.rows_missing(),
            table: TableJson::of_measurements(measurements),
            fractions: measurements.fractions().iter().cloned().map(fractions).collect(),
            reading: origin.reading.name(),
            sha256: measurements.sha256().map(ToOwned::to_owned),
            model,
            x,
            y: measurements.has_response().then(|| measurements.response().to_owned()),
            units: UnitsJson::new(
                measurements.model(),
                measurements.has_response().then(|| measurements.response()),
            ),
            epsilon,
            epsilon_column,
            epsilon_law: measurements.law().map(|law| law.text().to_owned()),
            interval,
            epsilon_from_least: from_least(measurements, style),
            x_origin: (!form.x_origin.is_zero()).then(|| style.number(&form.x_origin)),
            r#where: problem.conditions.iter().map(|condition| condition.text().to_owned()).collect(),
        }
    }
}

/// The multiple of ε_min that bounds the errors, if it was asked for.
pub(crate) fn from_least(measurements: &Measurements, style: &Style) -> Option<FromLeastJson> {
    let MultipleOfLeast { factor, least } = measurements.multiple_of_least()?;
    Some(FromLeastJson {
        factor: style.number(factor),
        epsilon_min: style.upper_number(least),
        assumes: "that no error is larger: the bound was found from these very readings",
    })
}

pub(crate) fn selection(selection: &Selection) -> Option<SelectionJson> {
    let Selection { rows, without, conditions } = selection.clone();
    (!selection.is_all()).then_some(SelectionJson { rows, without, where_row: conditions })
}

pub(crate) fn fractions(FractionCells { column, cells, first }: FractionCells) -> FractionsJson {
    FractionsJson { column, cells, first }
}
