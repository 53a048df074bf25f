//! The four programs behind the parameter uncertainty intervals as files for other solvers.

use std::fmt;

use boundfit_estimation::{BoundName, Problem, conditions_by_name};
use boundfit_lp::{ExchangeFormat, ExchangeProgram, PuiEnd, Sense};

/// The rows of a fit, ready to be written as files for other solvers.
#[derive(Debug, Clone)]
pub struct ExchangeRows(boundfit_lp::ExchangeRows);

impl ExchangeRows {
    /// All upper bounds, all lower bounds, all conditions, named after data row and bound: `row14_upper`, `row14_lower` (written
    /// with ≥), `where_1`. Both sides of an equation are one row, written with =. Exact.
    pub fn new(problem: &Problem) -> Self {
        let mut rows = boundfit_lp::ExchangeRows::default();
        let readings = problem.measurements.kept();
        for reading in readings {
            if let Some(upper) = reading.upper() {
                rows.push(format_args!("row{}_upper", reading.row), &reading.regressor, upper, Sense::AtMost);
            }
        }
        for reading in readings {
            if let Some(lower) = reading.lower() {
                rows.push(
                    format_args!("row{}_lower", reading.row),
                    &reading.regressor,
                    lower,
                    Sense::AtLeast,
                );
            }
        }
        for (name, condition) in conditions_by_name(&problem.conditions) {
            let (number, sense) = match name {
                BoundName::Where(number) => (number, Sense::AtMost),
                BoundName::WhereUpper(number) => (number, Sense::Equal),
                BoundName::Upper(_) | BoundName::Lower(_) | BoundName::WhereLower(_) => continue,
            };
            rows.push(format_args!("where_{number}"), &condition.a, condition.b, sense);
        }
        ExchangeRows(rows)
    }

    /// Writes the file of one program, with comments at its top. Exact; see [`ExchangeProgram::write`].
    ///
    /// # Errors
    /// The errors are the ones of the writer.
    pub fn write(
        &self,
        text: &mut impl fmt::Write,
        end: PuiEnd,
        format: ExchangeFormat,
        comments: &[String],
    ) -> fmt::Result {
        let program = ExchangeProgram {
            name: end.name(),
            objective_name: end.objective_name(),
            objective: end.objective(),
            rows: &self.0,
            comments,
        };
        program.write(text, format)
    }

    /// The file of one program as a text.
    pub fn text(&self, end: PuiEnd, format: ExchangeFormat, comments: &[String]) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = self.write(&mut text, end, format, comments);
        text
    }
}
