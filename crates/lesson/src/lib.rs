//! A self-contained web page that teaches polytope geometry on a bounded-error fit.
//!
//! [`lesson_data`] computes everything that the page shows, exactly.
//! - The half-planes, and the effect of each step of clipping.
//! - The family of sets under growing error bounds.
//! - The estimates, and the results of linear programs for the same data.
//! - The set without each reading, and the fewest readings to leave out.
//! - Questions with answers.
//!
//! [`page`] puts it into one HTML file whose script draws it, and computes, as exactly, what depends on where the
//! mouse is.
//!
//! [`polytope`] answers about half-planes without readings, for the page's second view.
//!
//! The page's script may rely on the schema `boundfit/lesson/3`, whose types are in `page/js/lesson.d.ts`; its
//! sources are in the folder `page`.
//!
//! ```
//! use boundfit_estimation::{Columns, EpsilonColumn, LineForm, Measurements, Problem, fit};
//! use boundfit_exact::{Rational, Reading};
//! use boundfit_formats::{ColumnSelector, Source, TableOptions};
//! use boundfit_lesson::{LessonOptions, page};
//!
//! let table = Source::new("readings.csv", "x,y\n0,0\n1,1.5\n2,2\n".as_bytes());
//! let columns = Columns {
//!     first: ColumnSelector::name_or_number("x"),
//!     second: None,
//!     response: Some(ColumnSelector::name_or_number("y")),
//!     epsilon: EpsilonColumn::Uniform(Rational::ratio(1, 2)),
//!     form: LineForm::default(),
//! };
//! let measurements = Measurements::read(table, &columns, &TableOptions::default())?;
//! let problem = Problem { measurements, conditions: Vec::new() };
//! let page = page(&problem, &fit(&problem), Reading::Decimal, &LessonOptions::default())?;
//! assert!(page.starts_with("<!doctype html>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod asked;
mod corridor;
mod data;
mod engine;
mod half_planes;
mod layers;
mod leave_one_out;
mod number;
mod numbered;
mod options;
mod orders;
mod outliers;
mod playground;
mod points;
mod polytope;
mod questions;
mod readings;
mod redundancy;
mod region;
mod sweep;
mod template;
mod texts;
mod unscripted;

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::{Reading, TooMuchWork};
use serde_json::Value;

pub use crate::options::{LessonError, LessonOptions, MOST_ROWS, MOST_ROWS_EVER};
pub use crate::playground::playground;
pub use crate::polytope::{LONGEST_TEXT, MOST_HALF_PLANES, PolytopeError, PolytopeOptions, polytope};
pub use crate::texts::{Language, said};

/// The work of a lesson for readings of thousands of digits, divided by the work of a fit; leaving out each reading
/// comes on top.
const FITS: u64 = 24;

/// The lesson as one HTML file without outside parts. `reading` says how the problem's numbers were read.
///
/// Every run gives the same bytes. Cost: that of [`lesson_data`].
///
/// # Errors
/// With more than [`LessonOptions::most_rows`] readings, or when a picture cannot be drawn.
pub fn page(
    problem: &Problem,
    fit: &Fit,
    reading: Reading,
    options: &LessonOptions,
) -> Result<String, LessonError> {
    let data = data::build(problem, fit, reading, options)?;
    let json = serde_json::to_string(&data)?;
    let facts = unscripted::Facts { problem, fit, document: &data, options };
    let unscripted = unscripted::content(&facts)?;
    Ok(template::page(data.title(), &json, options.language, Some((&facts, &unscripted)))?)
}

/// [`lesson_data`] as text, as it stands in the page. Exact. Cost: that of [`lesson_data`].
///
/// # Errors
/// With more than [`LessonOptions::most_rows`] readings.
pub fn lesson_json(
    problem: &Problem,
    fit: &Fit,
    reading: Reading,
    options: &LessonOptions,
) -> Result<String, LessonError> {
    Ok(serde_json::to_string(&data::build(problem, fit, reading, options)?)?)
}

/// Refuses a lesson on numbers so long that it would take more work than this limit: it leaves out each reading in turn.
///
/// # Errors
/// When it does.
pub fn check_work(problem: &Problem, limit: u64) -> Result<(), TooMuchWork> {
    let readings = problem.measurements.kept().len() as u64;
    let work = problem.work(&[]);
    work.check((FITS + readings) * problem.looks(), limit)?;
    work.of_leaving_out_each(readings).check(1, limit)
}

/// Everything that the page shows, schema `boundfit/lesson/3`. Numbers are exact, their decimals rounded: ends of
/// intervals outward, error bounds upward, all others to nearest.
///
/// Cost for N readings: one fit without each of them, O(N² log N), and three runs of clipping. Every LP solver of
/// this build runs on four programs, each for at most ten seconds. Readings that contradict each other take at most
/// two million crossings.
///
/// # Errors
/// With more than [`LessonOptions::most_rows`] readings.
pub fn lesson_data(
    problem: &Problem,
    fit: &Fit,
    reading: Reading,
    options: &LessonOptions,
) -> Result<Value, LessonError> {
    Ok(serde_json::to_value(data::build(problem, fit, reading, options)?)?)
}
