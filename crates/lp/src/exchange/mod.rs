//! Linear programs as files that other solvers read. Every number is exact.
//!
//! Sources: the MPS format as in the HiGHS, GLPK and CPLEX manuals (free form); the LP format as in "CPLEX file formats" (IBM).

mod lp_format;
mod model;
mod mps;
mod number;
mod written;

use boundfit_exact::Rational;

use crate::format::ExchangeFormat;
use crate::model::{Bounds, ObjectiveSense};
use crate::program::Row;
use written::{Written, WrittenColumn, WrittenRow};

/// How a row `a·θ ≤ b` is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// As `a·θ ≤ b`.
    AtMost,
    /// As `-a·θ ≥ -b`.
    AtLeast,
    /// As `a·θ = b`, where the opposite row belongs to the program as well.
    Equal,
}

/// A row as it stands in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExchangeRow(WrittenRow);

impl ExchangeRow {
    /// A row under a name of letters, digits and `_`. Its numbers become decimals where all of them are finite; else the
    /// row is multiplied with the least number that makes them whole.
    pub fn new(name: String, row: &Row, sense: Sense) -> Self {
        let opposite;
        let (a, bounds) = match sense {
            Sense::AtMost => (&row.a, Bounds { lower: None, upper: Some(row.b.clone()) }),
            Sense::Equal => (&row.a, Bounds { lower: Some(row.b.clone()), upper: Some(row.b.clone()) }),
            Sense::AtLeast => {
                opposite = row.a.each_ref().map(|a| -a);
                (&opposite, Bounds { lower: Some(-&row.b), upper: None })
            }
        };
        ExchangeRow(WrittenRow::new(name, a.iter().enumerate(), &bounds))
    }
}

/// A program `min objective·θ` with free variables `theta1` and `theta2`, ready to be written.
#[derive(Debug, Clone)]
pub struct ExchangeProgram<'a> {
    /// The name of the program.
    pub name: &'a str,
    /// The name of the objective, of letters, digits and `_`.
    pub objective_name: &'a str,
    /// The form to be minimised.
    pub objective: [Rational; 2],
    /// The rows.
    pub rows: &'a [ExchangeRow],
    /// What is said about it at the top. Characters other than printable ASCII are escaped.
    pub comments: &'a [String],
}

impl ExchangeProgram<'_> {
    /// The file. Exact: whoever reads its decimals as such has the same program, up to the scale of rows that it names
    /// in comments. Cost: linear in the result.
    pub fn text(&self, format: ExchangeFormat) -> String {
        let costs = self.objective.iter().enumerate();
        let objective = WrittenRow::new(self.objective_name.to_owned(), costs, &Bounds::default());
        let free = |name: &str| WrittenColumn { name: name.to_owned(), lower: None, upper: None };
        let rows: Vec<&WrittenRow> = self.rows.iter().map(|ExchangeRow(row)| row).collect();
        let comments = self.comments.iter().map(|line| escaped(line));
        let said = std::iter::once(&objective).chain(rows.iter().copied()).flat_map(WrittenRow::remarks);
        let program = Written {
            name: self.name,
            sense: ObjectiveSense::Minimize,
            objective: &objective,
            constant: ["0", "0"].map(str::to_owned),
            columns: &["theta1", "theta2"].map(free),
            remarks: comments.chain(said).collect(),
            rows,
        };
        program.text(format)
    }
}

/// A text as a comment can have it: characters other than printable ASCII are escaped.
fn escaped(text: &str) -> String {
    text.escape_default().to_string().replace("\\'", "'").replace("\\\"", "\"")
}
