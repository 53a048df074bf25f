//! The rows of the four programs behind the parameter uncertainty intervals, for other solvers.

use boundfit_estimation::{BoundName, Problem, conditions_by_name};
use boundfit_lp::{Bounds, ExchangeRows};

/// Returns the rows of a fit, ready to be written as files for other solvers: all upper bounds, all lower bounds, all conditions. Exact.
/// They are named after data row and bound: `row14_upper`, `row14_lower` (written with ≥), `where_1`. Both sides of an equation are one
/// row, written with =.
pub fn exchange_rows(problem: &Problem) -> ExchangeRows {
    let mut rows = ExchangeRows::default();
    for reading in problem.measurements.each_shown() {
        let bounds = Bounds { lower: None, upper: reading.upper() };
        if bounds != Bounds::default() {
            rows.push(format_args!("row{}_upper", reading.row), &reading.regressor, &bounds);
        }
    }
    for reading in problem.measurements.each_shown() {
        let bounds = Bounds { lower: reading.lower(), upper: None };
        if bounds != Bounds::default() {
            rows.push(format_args!("row{}_lower", reading.row), &reading.regressor, &bounds);
        }
    }
    for (name, condition) in conditions_by_name(&problem.conditions) {
        let (number, lower) = match name {
            BoundName::Where(number) => (number, None),
            BoundName::WhereUpper(number) => (number, Some(condition.b.clone())),
            BoundName::Upper(_) | BoundName::Lower(_) | BoundName::WhereLower(_) => continue,
        };
        let bounds = Bounds { lower, upper: Some(condition.b) };
        rows.push(format_args!("where_{number}"), &condition.a, &bounds);
    }
    rows
}
