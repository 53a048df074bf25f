//! Linear programs as files that other solvers read. Every number is exact.
//!
//! Sources: the MPS format as in the HiGHS, GLPK and CPLEX manuals (free form); the LP format as in "CPLEX file formats" (IBM).

mod lp_format;
mod model;
mod mps;
mod number;
mod rows;
mod written;

use std::fmt;

use boundfit_exact::Rational;

use crate::claim::PuiEnd;
use crate::format::ExchangeFormat;
use crate::model::{Bounds, ObjectiveSense};
use rows::{LargeBounds, WrittenRows};
use written::{Written, WrittenColumn};

/// The rows of the programs of a fit, in free variables `theta1` and `theta2`, as they stand in files: in about 60 bytes each where
/// numbers are short.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ExchangeRows(WrittenRows);

impl ExchangeRows {
    /// Adds a row under a name of letters, digits and `_`. Its numbers become decimals where all of them are finite; else the
    /// row is multiplied with the least number that makes them whole. A row with a bound from 10²⁰ on is multiplied with a power of ten,
    /// since some readers take that for infinite.
    pub fn push(&mut self, name: impl fmt::Display, [a1, a2]: &[Rational; 2], bounds: &Bounds) {
        self.0.push(name, &[(0, a1), (1, a2)], bounds, LargeBounds::FiniteForAll);
    }

    /// Writes the program of one end piece by piece, with comments at its top, in which characters other than printable ASCII are
    /// escaped. Exact: whoever reads its decimals as such has the same program, up to the scale of rows that it names in comments. Cost:
    /// linear in the result; memory for a line.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn write(
        &self,
        text: &mut impl fmt::Write,
        end: PuiEnd,
        format: ExchangeFormat,
        comments: &[String],
    ) -> fmt::Result {
        let ExchangeRows(rows) = self;
        let [first, second] = &end.objective();
        let mut objective = WrittenRows::default();
        let costs = [(0, first), (1, second)];
        objective.push(end.objective_name(), &costs, &Bounds::default(), LargeBounds::Kept);
        let comments: Vec<String> = comments.iter().map(|line| escaped(line)).collect();
        let remarks = comments.iter().chain(objective.remarks()).chain(rows.remarks());
        let free = |name: &str| WrittenColumn { name: name.to_owned(), lower: None, upper: None };
        let Some(written) = objective.iter().next() else { return Ok(()) };
        let program = Written {
            name: end.name(),
            sense: ObjectiveSense::Minimize,
            objective: written,
            constant: ["0", "0"].map(str::to_owned),
            columns: &["theta1", "theta2"].map(free),
            remarks: remarks.map(String::as_str).collect(),
            rows,
        };
        write(text, &program, format)
    }

    /// The file of one program as a text.
    pub fn text(&self, end: PuiEnd, format: ExchangeFormat, comments: &[String]) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = self.write(&mut text, end, format, comments);
        text
    }
}

fn write(text: &mut impl fmt::Write, program: &Written<'_>, format: ExchangeFormat) -> fmt::Result {
    match format {
        ExchangeFormat::Mps => mps::write(text, program),
        ExchangeFormat::Lp => lp_format::write(text, program),
    }
}

/// A text as a comment can have it: characters other than printable ASCII are escaped.
fn escaped(text: &str) -> String {
    text.escape_default().to_string().replace("\\'", "'").replace("\\\"", "\"")
}
