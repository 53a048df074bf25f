//! Linear programs as files state them: named columns and rows, each with a lower and an upper bound or without.

use boundfit_exact::{Foreign, Rational, Work};

/// The sense of the objective: to be made small or large.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ObjectiveSense {
    /// The least value is wanted, as in every file that does not say otherwise.
    #[default]
    Minimize,
    /// The largest value is wanted.
    Maximize,
}

/// The values between two bounds, both of which belong to them. A missing bound is infinite; a lower bound above the upper
/// one leaves no value, and the program is infeasible.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Bounds {
    /// The least value; `None` for −∞.
    pub lower: Option<Rational>,
    /// The largest value; `None` for +∞.
    pub upper: Option<Rational>,
}

impl Bounds {
    /// The only value that the bounds leave.
    pub fn fixed(&self) -> Option<&Rational> {
        self.lower.as_ref().filter(|lower| Some(*lower) == self.upper.as_ref())
    }
}

/// A column: a variable with what a unit of it adds to the objective.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ModelColumn {
    /// The name in the file.
    pub name: Foreign,
    /// The coefficient in the objective.
    pub cost: Rational,
    /// The values that it may have.
    pub bounds: Bounds,
}

/// A row: `lower ≤ Σ coefficient·column ≤ upper`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModelRow {
    /// The name in the file.
    pub name: Foreign,
    /// Columns by their place in [`Model::columns`], in rising order, each at most once, none with a coefficient of 0.
    pub coefficients: Vec<(usize, Rational)>,
    /// The values that the form may have.
    pub bounds: Bounds,
}

/// A linear program of any number of columns, every number exactly as the file spells it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Model {
    /// The name that the file gives it; may be empty.
    pub name: Foreign,
    /// The sense of the objective.
    pub sense: ObjectiveSense,
    /// The name of the objective; may be empty.
    pub objective_name: Foreign,
    /// The constant of the objective.
    pub constant: Rational,
    /// The columns, in the order of the file.
    pub columns: Vec<ModelColumn>,
    /// The rows, in the order of the file, without the objective and other rows of type N.
    pub rows: Vec<ModelRow>,
}

impl Model {
    /// The work that solving takes as far as numbers are long: those of the objective and of each row, where columns that bounds
    /// fix become constants. Cost: linear.
    pub fn work(&self) -> Work {
        let mut work = Work::default();
        work.add(0, [&self.constant]);
        for column in &self.columns {
            work.add(0, [&column.cost].into_iter().chain(&column.bounds.lower).chain(&column.bounds.upper));
        }
        for (number, row) in (1..).zip(&self.rows) {
            let fixed = |column: usize| self.columns.get(column).and_then(|column| column.bounds.fixed());
            // Terms of columns that are fixed become one number, which is as long as the longest of them.
            for (column, value) in &row.coefficients {
                work.add(number, [Some(value), fixed(*column)].into_iter().flatten());
            }
            work.add(number, row.bounds.lower.iter().chain(&row.bounds.upper));
        }
        work
    }
}
