//! What is asked of readings beyond their fit: outliers, the linear range, windows, errors in x.

use boundfit::Problem;
use boundfit::engine::exact::Work;
use boundfit::files::{ColumnSelector, Measurements};
use boundfit::questions::{
    Extent, LinearRange, Moving, NoOutliers, Order, OutlierLimits, Outliers, Turn, XBounds, XErrorProblem,
    times,
};
use boundfit::report::{
    FleetTable, NoOutliersProof, OutliersReport, RangeReport, Style, TableJson, WindowReport, WindowSummary,
    outliers_csv, outliers_document, outliers_json, outliers_proof, range_csv, range_document, range_json,
    range_proof, write_window_json, x_error_csv, x_error_document, x_error_json, x_error_proof,
};
use pyo3::prelude::*;

use crate::asked::{AskedXBounds, in_words};
use crate::forms::{Form, NO_TEXT, asked};
use crate::numbers::{Given, refuse};
use crate::readings::{Readings, checked};

/// Runs that a proof may be about, each of which it fits.
const MOST_PROVED: usize = 1_000;

/// The fewest readings to leave out so that something is left.
#[pyfunction]
#[pyo3(signature = (readings, most, max_sets, max_steps, form, digits))]
pub(crate) fn outliers(
    py: Python<'_>,
    readings: &Readings,
    most: Option<usize>,
    max_sets: Option<usize>,
    max_steps: Option<u64>,
    form: &str,
    digits: Option<usize>,
) -> PyResult<String> {
    let usual = OutlierLimits::default();
    let limits =
        OutlierLimits { sets: max_sets.unwrap_or(usual.sets), steps: max_steps.unwrap_or(usual.steps) };
    let ask = |readings: &Readings, form, style: &Style| outliers_of(readings, most, &limits, form, style);
    asked(py, readings, form, digits, ask)
}

fn outliers_of(
    readings: &Readings,
    most: Option<usize>,
    limits: &OutlierLimits,
    form: Form,
    style: &Style,
) -> Result<String, String> {
    let problem = readings.every_reading("outliers are")?;
    checked(times::check_outliers(&problem, readings.most_work()))?;
    let fit = problem.fit();
    let found = Outliers::new(&problem, limits);
    let growth = match &found {
        Ok(outliers) => match outliers.growth(&problem, most.unwrap_or(outliers.least), limits) {
            Ok(growth) => growth,
            // What nobody asked for is left out where it takes too much.
            Err(_) if most.is_none() => Vec::new(),
            Err(why) => return Err(no_outliers(&why, limits)),
        },
        Err(NoOutliers::Conditions(_)) => Vec::new(),
        Err(why) => return Err(no_outliers(why, limits)),
    };
    let shows_growth = most.is_some() && found.is_ok();
    let report = OutliersReport {
        problem: &problem,
        fit: &fit,
        outliers: found.as_ref(),
        growth: &growth,
        shows_growth,
    };
    match form {
        Form::Json => Ok(outliers_json(&report, &readings.origin(), style)),
        Form::Csv => Ok(outliers_csv(found.as_ref().ok())),
        Form::Proof => outliers_proof(&report, readings.reading).map_err(|why| match why {
            NoOutliersProof::NoText => NO_TEXT.to_owned(),
            NoOutliersProof::TooMany(most) => format!("the proof would take more than {most} contradictions"),
        }),
        _ => Ok(form.of(&outliers_document(&report, &readings.shown_origin(), style))),
    }
}

fn no_outliers(why: &NoOutliers, limits: &OutlierLimits) -> String {
    let steps = limits.steps;
    match why {
        NoOutliers::NotInMemory => {
            "outliers are looked for among all readings, and these are a reduction".to_owned()
        }
        NoOutliers::Conditions(_) => "the conditions contradict each other".to_owned(),
        NoOutliers::Steps { at_least, enough, needed } => {
            let enough = enough.map(|enough| format!(", and {enough} are enough")).unwrap_or_default();
            format!(
                "at least {at_least} of the readings have to be left out{enough}; to find the least number takes {needed} crossings \
                 of bounds, more than max_steps={steps}"
            )
        }
        NoOutliers::GrowthSteps { needed } => format!(
            "to see how the set grows takes {needed} crossings of bounds, more than max_steps={steps}; a smaller most takes fewer"
        ),
        NoOutliers::Corners => "the set has more than 150000 corners (expected a smaller most)".to_owned(),
    }
}

/// Every run of readings that some parameters agree with.
#[pyfunction]
#[pyo3(signature = (readings, by, form, digits))]
pub(crate) fn range(
    py: Python<'_>,
    readings: &Readings,
    by: Option<&str>,
    form: &str,
    digits: Option<usize>,
) -> PyResult<String> {
    let order = match by {
        None => None,
        Some("x") if readings.question.columns.second.is_some() => {
            return Err(refuse(
                "by=\"x\" is about a line: two regressors have no order of x (expected \"row\")",
            ));
        }
        Some("x") => Some(Order::X),
        Some("row") => Some(Order::Row),
        Some(other) => return Err(refuse(format_args!("by={other:?}: expected \"x\" or \"row\""))),
    };
    asked(py, readings, form, digits, |readings, form, style| range_of(readings, order, form, style))
}

fn range_of(readings: &Readings, order: Option<Order>, form: Form, style: &Style) -> Result<String, String> {
    let problem = readings.every_reading("a linear range is")?;
    readings.check_problem(&problem, times::RANGE)?;
    let order = order.unwrap_or_else(|| Order::natural(problem.measurements.model()));
    let range = LinearRange::of(&problem, order);
    let all = problem.fit();
    let longest = range.longest().map(|run| {
        let own = range.problem_of(run, &problem, false);
        let fit = own.fit();
        (own, fit)
    });
    let report = RangeReport { problem: &problem, fit: &all, order, range: &range, longest };
    match form {
        Form::Json => Ok(range_json(&report, &readings.origin(), style)),
        Form::Csv => Ok(range_csv(&report)),
        Form::Proof if range.runs.len() > MOST_PROVED => {
            Err(format!("a proof is about at most {MOST_PROVED} runs, and there are {}", range.runs.len()))
        }
        Form::Proof => range_proof(&report, readings.reading).ok_or_else(|| NO_TEXT.to_owned()),
        _ => Ok(form.of(&range_document(&report, &readings.shown_origin(), style))),
    }
}

/// How far a window reaches back, and how far it moves on.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct AskedWindow {
    readings: Option<usize>,
    x: Option<Given>,
    step: usize,
}

/// The last readings, fitted again and again: a line for each window, of JSON each a document.
#[pyfunction]
#[pyo3(signature = (readings, window, form, digits))]
pub(crate) fn windows(
    py: Python<'_>,
    readings: &Readings,
    window: AskedWindow,
    form: &str,
    digits: Option<usize>,
) -> PyResult<String> {
    let extent = match (window.readings, &window.x) {
        (Some(0), _) => return Err(refuse("window=0: expected how many readings a window has, at least 1")),
        (Some(count), _) => Extent::Readings(count),
        (None, Some(_)) if readings.question.columns.second.is_some() => {
            return Err(refuse(
                "window_x is about a line: two regressors have no x to look back along; window counts readings",
            ));
        }
        (None, Some(given)) => {
            let span = given.number(readings.floats, "window_x")?;
            if !span.is_positive() {
                return Err(refuse(format_args!(
                    "window_x={:?}: expected a number above 0, such as 60 or 0.5",
                    given.shown
                )));
            }
            Extent::X(span)
        }
        (None, None) => {
            return Err(refuse("expected window, a number of readings, or window_x, a length of x"));
        }
    };
    if window.step == 0 {
        return Err(refuse("step=0: expected how many readings a window moves on, at least 1"));
    }
    let moving = Moving { extent, step: window.step };
    asked(py, readings, form, digits, |readings, form, style| windows_of(readings, &moving, form, style))
}

fn windows_of(readings: &Readings, moving: &Moving, form: Form, style: &Style) -> Result<String, String> {
    let problem = readings.every_reading("windows are")?;
    readings.check_problem(&problem, times::RANGE)?;
    let (mut summary, mut table) = (WindowSummary::default(), FleetTable::of_windows());
    let mut text = String::new();
    let mut lines: Vec<u8> = Vec::new();
    if form == Form::Csv {
        text.push_str(WindowReport::CSV_HEADER);
    }
    let taken_for = TableJson::of_measurements(&problem.measurements);
    let mut take = |turn: Turn<'_>| {
        let Some(window) = WindowReport::new(&turn, &problem) else { return Ok(()) };
        match form {
            Form::Json => write_window_json(&mut lines, &window, taken_for.as_ref(), style),
            Form::Csv => text.push_str(&window.csv(style)),
            Form::Text => {
                summary.add(&window);
                table.push(window.cells(style), &mut text);
            }
            _ => return Err("windows are written as text, csv or json".to_owned()),
        }
        Ok(())
    };
    let moved = moving.each(&problem, &mut take)?;
    if form == Form::Text {
        table.finish(&mut text);
        text = format!("{text}\n{}", summary.to_text(moving, &moved, style));
    }
    text.push_str(&String::from_utf8_lossy(&lines));
    Ok(text)
}

/// The lines that agree with all readings under errors in x as well.
#[pyfunction]
#[pyo3(signature = (readings, form, digits))]
pub(crate) fn x_errors(
    py: Python<'_>,
    readings: &Readings,
    form: &str,
    digits: Option<usize>,
) -> PyResult<String> {
    asked(py, readings, form, digits, x_errors_of)
}

fn x_errors_of(readings: &Readings, form: Form, style: &Style) -> Result<String, String> {
    let problem = x_error_problem(readings)?;
    let (plain, answer) = (problem.problem().fit(), problem.fit());
    match form {
        Form::Json => Ok(x_error_json(&problem, &answer, &plain, &readings.origin(), style)),
        Form::Csv => Ok(x_error_csv(&answer, &plain)),
        Form::Proof => x_error_proof(&problem, &answer, readings.reading).ok_or_else(|| NO_TEXT.to_owned()),
        _ => Ok(form.of(&x_error_document(&problem, &answer, &plain, &readings.shown_origin(), style))),
    }
}

fn x_error_problem(readings: &Readings) -> Result<XErrorProblem, String> {
    let asked = readings.x_errors.as_ref().ok_or("x_eps is missing")?;
    let source = readings.source()?;
    if source.is_reduction() {
        return Err(
            "x_eps needs every reading, and the file is a reduction: fit the table that it was made from"
                .to_owned(),
        );
    }
    let beside: Vec<ColumnSelector> = match &asked.bounds {
        AskedXBounds::Column(column) => vec![column.clone()],
        AskedXBounds::Uniform(_) => Vec::new(),
    };
    let read =
        Measurements::read_beside(source, &readings.question.columns, &beside, &readings.options.table);
    let (measurements, mut further) = read.map_err(|error| in_words(&error))?;
    let bounds = match &asked.bounds {
        AskedXBounds::Uniform(bound) => XBounds::Uniform(bound.clone()),
        AskedXBounds::Column(column) => {
            XBounds::PerRow { column: column.text().clone(), bounds: further.pop().unwrap_or_default() }
        }
    };
    let problem: Problem = readings.question.of_measurements(measurements);
    let problem = readings.short(problem)?;
    let problem = XErrorProblem::new(problem, bounds, asked.agreement).map_err(|error| error.to_string())?;
    let mut work = Work::default();
    for (row, width) in problem.readings() {
        let numbers = [row.lower(), row.upper()];
        work.add(row.row, row.regressor.iter().chain(numbers.iter().flatten()).chain([width]));
    }
    readings.check(&work, times::X_ERRORS)?;
    readings.check(&work.of_every_word(), times::X_ERROR_STEPS)?;
    Ok(problem)
}
