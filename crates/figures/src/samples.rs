//! Small problems for tests.

use boundfit_estimation::{Condition, ErrorBound, Measurement, Measurements, Model, Problem};
use boundfit_exact::{Limits, Rational, Reading};

/// A problem of model `line` or `two` with rows "x y ε" or "φ1 φ2 y ε".
pub(crate) fn problem(model: &str, rows: &[&str], conditions: &[&str]) -> Problem {
    let limits = Limits::default();
    let read = |text: &str| Reading::Decimal.read(text, &limits).unwrap();
    let row = |(index, text): (usize, &&str)| {
        let numbers: Vec<Rational> = text.split(' ').map(read).collect();
        let (regressor, rest) = match model {
            "line" => ([numbers[0].clone(), Rational::one()], &numbers[1..]),
            _ => ([numbers[0].clone(), numbers[1].clone()], &numbers[2..]),
        };
        Measurement::around(index + 1, regressor, rest[0].clone(), rest[1].clone())
    };
    let rows = rows.iter().enumerate().map(row).collect();
    let kind = match model {
        "line" => Model::Line { x: "x".into() },
        _ => Model::TwoRegressors { regressors: ["u".into(), "v".into()] },
    };
    let bound = ErrorBound::Column("eps".into());
    let condition = |text: &&str| Condition::parse(text, Reading::Decimal, &limits).unwrap();
    Problem {
        measurements: Measurements::new(kind, "y".into(), bound, rows),
        conditions: conditions.iter().map(condition).collect(),
    }
}
