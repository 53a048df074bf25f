//! Small inputs that take long.

use std::io::Cursor;
use std::time::Duration;

use boundfit_estimation::{Columns, EpsilonColumn, LineForm, Measurements, Problem, fit};
use boundfit_exact::{MOST_WORK, Rational, Reading};
use boundfit_formats::{ColumnSelector, Source, TableOptions, read_half_planes};
use boundfit_geometry::Polyhedron;
use boundfit_judge::{Answer, Plane};
use boundfit_lp::{ExchangeFormat, ModelLimits, model_text, read_model};
use boundfit_report::{Origin, Style, fit_json, h_representation};
use cpu_time::ThreadTime;

/// The largest input.
const MOST_BYTES: usize = 4096;
/// The longest time for each way of reading an input.
const LONGEST: Duration = Duration::from_secs(2);

/// Reads, solves and writes an input within two seconds, whatever it is read as: a table under three bounds,
/// half-planes, a linear program. The input has a few kilobytes and is not refused for its work.
pub fn slow_units(data: &[u8]) {
    if data.len() > MOST_BYTES {
        return;
    }
    let ten_to = |exponent: i64| Rational::scientific(1, exponent);
    for epsilon in [Rational::zero(), Rational::one(), ten_to(9_999)] {
        in_time("a table", || table(data, &epsilon));
    }
    in_time("half-planes", || half_planes(data));
    in_time("a linear program", || model(data));
}

fn in_time(what: &str, work: impl FnOnce()) {
    let started = ThreadTime::now();
    work();
    let taken = started.elapsed();
    assert!(taken <= LONGEST, "slow unit: {taken:?} as {what}");
}

fn table(data: &[u8], epsilon: &Rational) {
    let columns = Columns {
        first: ColumnSelector::name_or_number("1"),
        second: None,
        response: Some(ColumnSelector::name_or_number("2")),
        epsilon: EpsilonColumn::Uniform(epsilon.clone()),
        form: LineForm::default(),
    };
    let source = Source::new("data.csv", Cursor::new(data.to_vec()));
    let Ok(measurements) = Measurements::read(source, &columns, &TableOptions::default()) else { return };
    let problem = Problem { measurements, conditions: Vec::new() };
    if problem.work(&[]).check(1, MOST_WORK).is_ok() {
        let origin = Origin { file: None, reading: Reading::Decimal, is_stored: false };
        let written = fit_json(&problem, &fit(&problem), None, None, &origin, &Style::default());
        assert!(!written.is_empty());
    }
}

fn half_planes(data: &[u8]) {
    let source = Source::new("data.ine", Cursor::new(data.to_vec()));
    let Ok(file) = read_half_planes(source, &TableOptions::default()) else { return };
    if file.system.work().check(1, MOST_WORK).is_ok() {
        assert!(!h_representation(&Polyhedron::intersect(file.system)).is_empty());
    }
}

fn model(data: &[u8]) {
    let Ok(text) = model_text(data) else { return };
    for format in ExchangeFormat::ALL {
        let Ok(model) = read_model(text, format, &ModelLimits::default()) else { continue };
        if model.work().check(1, MOST_WORK).is_ok()
            && let Ok(plane) = Plane::new(&model)
        {
            assert!(Answer::in_plane(&model, &plane).is_ok());
        }
    }
}
