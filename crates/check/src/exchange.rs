//! The four programs behind the parameter uncertainty intervals as files for other solvers.

use boundfit_estimation::BoundName;
use boundfit_lp::{ExchangeFormat, ExchangeProgram, ExchangeRow, PuiEnd, Sense};

use crate::rows::ProgramRows;

/// The rows of a fit, ready to be written as files for other solvers.
#[derive(Debug, Clone)]
pub struct ExchangeRows(Vec<ExchangeRow>);

impl ExchangeRows {
    /// The rows in their order, named after data row and bound: `row14_upper`, `row14_lower` (written with ≥), `where_1`.
    /// Both sides of an equation are one row, written with =.
    pub fn new(rows: &ProgramRows) -> Self {
        let named = rows.rows().iter().zip(rows.names()).filter_map(|(row, name)| {
            let (name, sense) = match name {
                BoundName::Upper(row) => (format!("row{row}_upper"), Sense::AtMost),
                BoundName::Lower(row) => (format!("row{row}_lower"), Sense::AtLeast),
                BoundName::Where(number) => (format!("where_{number}"), Sense::AtMost),
                BoundName::WhereUpper(number) => (format!("where_{number}"), Sense::Equal),
                BoundName::WhereLower(_) => return None,
            };
            Some(ExchangeRow::new(name, &row.row, sense))
        });
        ExchangeRows(named.collect())
    }

    /// The file of one program, with comments at its top. Exact; see [`ExchangeProgram::text`].
    pub fn text(&self, end: PuiEnd, format: ExchangeFormat, comments: &[String]) -> String {
        let program = ExchangeProgram {
            name: end.name(),
            objective_name: end.objective_name(),
            objective: end.objective(),
            rows: &self.0,
            comments,
        };
        program.text(format)
    }
}
