//! The question, in the words of the engine in the page: with it, the readings of a page make that page again.
//!
//! The table is the one that the page writes (`page/js/model/table.js`): regressors, the response if there is one,
//! then the columns of bounds if there are any. Each reading has x as it was before it was counted from an origin,
//! and its cells as they were written if that is known.

use boundfit_estimation::{ErrorBound, Law, Measurement, Measurements, Model, MultipleOfLeast, Problem};
use boundfit_exact::{DecimalMark, Foreign, Reading};
use boundfit_report::row_ranges;
use serde::Serialize;

use crate::options::{LessonOptions, MOST_ROWS};

/// The options of a lesson, by the names that `docs/wasm.md` has for them.
#[derive(Debug, Serialize)]
pub(crate) struct AskedJson {
    file: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    x_unit: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    y_unit: Option<String>,
    x: Regressors,
    #[serde(skip_serializing_if = "Option::is_none")]
    y: Option<String>,
    #[serde(flatten)]
    bounds: Bounds<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    r#where: Vec<String>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    through_origin: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    x_origin: Option<String>,
    reading: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    max_readings: Option<usize>,
    header: &'static str,
    delimiter: &'static str,
    decimal: &'static str,
    comment: &'static str,
    /// The numbers of all rows of the table, fitted or not.
    row_numbers: Vec<[usize; 2]>,
    /// The numbers of those that are fitted.
    rows: Vec<[usize; 2]>,
}

#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Regressors {
    One(String),
    Two([String; 2]),
}

/// The bounds on the errors, by what is asked for and the columns that the table needs for it.
#[derive(Debug, Serialize)]
enum Bounds<C> {
    /// Bounds in words, which need no column.
    #[serde(rename = "eps")]
    Words(String),
    /// A column of distances.
    #[serde(rename = "eps_column")]
    Column(C),
    /// Columns of lower and upper bounds.
    #[serde(untagged)]
    Interval {
        #[serde(skip_serializing_if = "Option::is_none")]
        lower: Option<C>,
        #[serde(skip_serializing_if = "Option::is_none")]
        upper: Option<C>,
    },
}

/// The question, and the names of the columns of the table. `others` are the readings of the page that are not fitted.
pub(crate) fn asked(
    problem: &Problem,
    reading: Reading,
    options: &LessonOptions,
    file: &str,
    others: &[&Measurement],
) -> (AskedJson, Vec<String>) {
    let measurements = &problem.measurements;
    let bounds = bounds(measurements);
    let columns = columns(measurements, &bounds);
    let mut selectors = selectors(&columns).into_iter();
    let mut next = || selectors.next().unwrap_or_default();
    let x = match measurements.model() {
        Model::Line { .. } => Regressors::One(next()),
        Model::TwoRegressors { .. } => Regressors::Two([next(), next()]),
    };
    let y = measurements.has_response().then(&mut next);
    let bounds = match bounds {
        Bounds::Words(eps) => Bounds::Words(eps),
        Bounds::Column(_) => Bounds::Column(next()),
        Bounds::Interval { lower, upper } => {
            Bounds::Interval { lower: lower.map(|_| next()), upper: upper.map(|_| next()) }
        }
    };
    let shown = measurements.kept().iter().chain(others.iter().copied());
    let mut cells = shown.flat_map(|row| measurements.cells(row.row).unwrap_or_default());
    let has_comma = cells.any(|cell| cell.contains(','));
    let form = measurements.line_form();
    let own = |text: &Option<Foreign>| text.as_ref().map(|text| text.raw().to_owned());
    let rows = || measurements.kept().iter().map(|row| row.row);
    let mut all: Vec<usize> = rows().chain(others.iter().map(|row| row.row)).collect();
    all.sort_unstable();
    let asked = AskedJson {
        file: file.to_owned(),
        title: own(&options.title),
        x_unit: own(&options.x_unit),
        y_unit: own(&options.y_unit),
        x,
        y,
        bounds,
        r#where: conditions(problem),
        through_origin: form.through_origin,
        x_origin: (!form.x_origin.is_zero()).then(|| form.x_origin.to_string()),
        reading: reading.name(),
        max_readings: (options.most_rows != MOST_ROWS).then_some(options.most_rows),
        header: "yes",
        delimiter: if has_comma { "semicolon" } else { "comma" },
        decimal: if has_comma { DecimalMark::Comma } else { DecimalMark::Point }.name(),
        comment: "none",
        row_numbers: row_ranges(all),
        rows: row_ranges(rows()),
    };
    (asked, columns)
}

fn bounds(measurements: &Measurements) -> Bounds<Foreign> {
    let has_cells = measurements.kept().iter().all(|row| measurements.cells(row.row).is_some());
    if let Some(MultipleOfLeast { factor, .. }) = measurements.multiple_of_least() {
        return Bounds::Words(format!("{factor}*min"));
    }
    match (measurements.error_bound(), measurements.law()) {
        // Half a unit of the last digit is that of the cells as they were written.
        (_, Some(law)) if law.needs_written() && !has_cells => own_bounds(law),
        (_, Some(law)) => Bounds::Words(law.text().raw().to_owned()),
        (ErrorBound::Column(column), None) => Bounds::Column(column.clone()),
        (ErrorBound::Interval { lower, upper }, None) => {
            Bounds::Interval { lower: lower.clone(), upper: upper.clone() }
        }
        (ErrorBound::Law(law), None) => own_bounds(law),
        (ErrorBound::Uniform(epsilon), None) => Bounds::Words(epsilon.to_string()),
    }
}

/// Returns the bounds that a law gives each reading, as columns.
fn own_bounds(law: &Law) -> Bounds<Foreign> {
    match law.is_asymmetric() {
        true => Bounds::Interval { lower: Some("lower".into()), upper: Some("upper".into()) },
        false => Bounds::Column(law.text().clone()),
    }
}

fn columns(measurements: &Measurements, bounds: &Bounds<Foreign>) -> Vec<String> {
    let regressors: Vec<&Foreign> = match measurements.model() {
        Model::Line { x } => vec![x],
        Model::TwoRegressors { regressors } => regressors.iter().collect(),
    };
    let response = measurements.has_response().then(|| measurements.response());
    let of_bounds: Vec<&Foreign> = match bounds {
        Bounds::Words(_) => Vec::new(),
        Bounds::Column(column) => vec![column],
        Bounds::Interval { lower, upper } => [lower, upper].into_iter().flatten().collect(),
    };
    let names = regressors.into_iter().chain(response).chain(of_bounds);
    names.map(|name| name.raw().to_owned()).collect()
}

/// Returns the selector of each column: its name, or its number if it shares its name with another one.
fn selectors(columns: &[String]) -> Vec<String> {
    let is_alone = |name: &String| columns.iter().filter(|other| *other == name).count() == 1;
    let selector = |(number, name): (usize, &String)| match is_alone(name) {
        true => name.clone(),
        false => number.to_string(),
    };
    (1..).zip(columns).map(selector).collect()
}

/// The conditions but the one that belongs to lines through the origin, which is asked for in a word.
fn conditions(problem: &Problem) -> Vec<String> {
    let is_of_form = |text: &str| problem.measurements.line_form().through_origin && text == "theta2 = 0";
    let texts = problem.conditions.iter().map(|condition| condition.text().raw());
    texts.filter(|text| !is_of_form(text)).map(ToOwned::to_owned).collect()
}
