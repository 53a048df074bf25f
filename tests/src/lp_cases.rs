//! Linear programs for the tests of solvers and of the referee.

use std::fs;
use std::path::Path;

use boundfit_check::ProgramRows;
use boundfit_estimation::{
    Columns, EpsilonColumn, ErrorBound, LineForm, Measurement, Measurements, Model, Problem,
};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{ColumnSelector, Source, TableOptions};
use boundfit_geometry::{Inequality, System};
use boundfit_lp::Row;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use serde_json::Value;

use crate::generate::{half_planes, rational_system, system};
use crate::program::root;
use crate::readings::problem;

/// A number from its text.
///
/// # Panics
/// When the text is not a number.
pub fn number(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).expect(text)
}

/// The rows of a system.
pub fn rows_of(system: &System) -> Vec<Row> {
    system.inequalities().iter().map(|row| Row { a: row.a.clone(), b: row.b.clone() }).collect()
}

/// The system of rows.
pub fn system_of(rows: &[Row]) -> System {
    rows.iter().map(|Row { a: [a1, a2], b }| Inequality::new(a1.clone(), a2.clone(), b.clone())).collect()
}

/// Rows from integers: a1, a2, b each.
pub fn whole_rows(rows: &[[i64; 3]]) -> Vec<Row> {
    rows.iter().map(|&[a1, a2, b]| Row { a: [a1.into(), a2.into()], b: b.into() }).collect()
}

/// 10 to a power.
pub fn ten_to(exponent: i32) -> Rational {
    Rational::scientific(1, exponent)
}

/// A number between -10 and 10 over a denominator of up to 18 digits.
pub fn fine(rng: &mut ChaCha8Rng) -> Rational {
    let denominator = rng.random_range(1..=999_999_999_999_999_999_i64 / 10);
    Rational::ratio(rng.random_range(-10 * denominator..=10 * denominator), denominator)
}

/// The rows of a generated program: of a fit, degenerate half-planes, and both in bad units. Everything that can go
/// wrong with a set occurs: empty, unbounded, without interior, without rows.
pub fn rows(rng: &mut ChaCha8Rng) -> Vec<Row> {
    let style = rng.random_range(0..8);
    let mut rows = match rng.random_range(0..4) {
        0 | 1 => ProgramRows::new(&problem(rng)).plain(),
        2 => rows_of(&system(&half_planes(rng))),
        _ => rows_of(&rational_system(rng)),
    };
    let mut change = |change: &mut dyn FnMut(&mut ChaCha8Rng, &mut Row)| {
        rows.iter_mut().for_each(|row| change(rng, row));
    };
    match style {
        // Each row in units of its own.
        0 => change(&mut |rng, row| {
            let unit = ten_to(rng.random_range(-12..=12));
            *row = times(row, &unit);
        }),
        // θ1 in units of 1e-9 and θ2 in units of 1e9: coefficients of both sizes in one row.
        1 => change(&mut |_, row| row.a = [&row.a[0] * ten_to(-9), &row.a[1] * ten_to(9)]),
        // Almost the same rows: b differs in the 12th decimal.
        2 => change(&mut |rng, row| row.b = &row.b + ten_to(-12) * Rational::from(rng.random_range(-3..=3))),
        // Large denominators.
        3 => change(&mut |rng, row| {
            *row = Row {
                a: row.a.each_ref().map(|a| a + fine(rng) * ten_to(-6)),
                b: &row.b + fine(rng) * ten_to(-6),
            };
        }),
        _ => {}
    }
    rows
}

/// A row times a positive number.
pub fn times(row: &Row, factor: &Rational) -> Row {
    Row { a: row.a.each_ref().map(|a| a * factor), b: &row.b * factor }
}

/// A line fit under one error bound.
pub fn line_problem(readings: &[(Rational, Rational)], epsilon: &Rational) -> Problem {
    let rows = readings.iter().zip(1..).map(|((x, y), row)| {
        Measurement::around(row, [x.clone(), Rational::one()], y.clone(), epsilon.clone())
    });
    let model = Model::Line { x: "x".into() };
    let bound = ErrorBound::Uniform(epsilon.clone());
    let measurements = Measurements::new(model, "y".into(), bound, rows.collect());
    Problem { measurements, conditions: Vec::new() }
}

/// Returns this many readings of a line with errors of up to 0.93 under the error bound 1.
pub fn long_problem(readings: usize) -> Problem {
    // A multiplicative sequence: cheap, and the same everywhere.
    let noise = |index: usize| (index as i64 * 7919) % 1901 - 950;
    let reading = |index: usize| {
        let x = Rational::ratio(index as i64, 128);
        let y = &x * Rational::ratio(5, 4) + Rational::from(3) + Rational::ratio(noise(index), 1024);
        (x, y)
    };
    line_problem(&(0..readings).map(reading).collect::<Vec<_>>(), &Rational::one())
}

/// A fit on which floating-point solvers fail.
#[derive(Debug)]
pub struct HardCase {
    /// The name of its files.
    pub name: String,
    /// The error bound as written.
    pub epsilon: String,
    /// The fit.
    pub problem: Problem,
    /// The known answer.
    pub expected: Value,
}

/// The cases in `fixtures/hard-lp`, by name.
///
/// # Panics
/// When one cannot be read.
pub fn hard_cases() -> Vec<HardCase> {
    let folder = root().join("fixtures/hard-lp");
    let mut names: Vec<String> = fs::read_dir(&folder)
        .expect("the folder is there")
        .filter_map(|entry| Some(entry.ok()?.file_name().to_str()?.strip_suffix(".csv")?.to_owned()))
        .collect();
    names.sort();
    names.into_iter().map(|name| hard_case(&folder, name)).collect()
}

/// The fit `NAME.csv` of a folder, with the error bound and the known answer in `NAME.json`.
///
/// # Panics
/// When it cannot be read.
pub fn hard_case(folder: &Path, name: String) -> HardCase {
    let text = fs::read_to_string(folder.join(format!("{name}.json"))).expect("a case has a JSON file");
    let mut json: Value = serde_json::from_str(&text).expect("a case's file is JSON");
    let epsilon = json["eps"].as_str().expect("eps is a text").to_owned();
    let column = ColumnSelector::name_or_number;
    let columns = Columns {
        first: column("x"),
        second: None,
        response: Some(column("y")),
        epsilon: EpsilonColumn::Uniform(number(&epsilon)),
        form: LineForm::default(),
    };
    let source = Source::open(&folder.join(format!("{name}.csv")).to_string_lossy()).expect("readable");
    let measurements =
        Measurements::read(source, &columns, &TableOptions::default()).expect("a case is a table");
    let problem = Problem { measurements, conditions: Vec::new() };
    HardCase { name, epsilon, problem, expected: json["expected"].take() }
}
