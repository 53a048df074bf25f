//! A fit's half-planes as the rows of linear programs.

use std::borrow::Cow;

use boundfit_estimation::{BoundName, Measurement, Problem, conditions_by_name, half_planes};
use boundfit_exact::Rational;
use boundfit_geometry::Inequality;
use boundfit_lp::{ExactSimplex, FloatProgram, Program, RefereeRow, Row};

/// The rows of M·θ ≤ b with M = [Φ; -Φ] and b = [y; -y] + ε, then the conditions.
#[derive(Debug, Clone)]
pub struct ProgramRows {
    rows: Vec<RefereeRow>,
    names: Vec<BoundName>,
}

impl ProgramRows {
    /// The rows of a problem: all upper bounds, all lower bounds, all conditions. Exact.
    pub fn new(problem: &Problem) -> Self {
        ProgramRows::of(problem.measurements.kept(), problem)
    }

    /// The rows of some readings of a problem, and of its conditions.
    pub(crate) fn of(readings: &[Measurement], problem: &Problem) -> Self {
        let row = |(name, Inequality { a, b }), epsilon| (name, RefereeRow { row: Row { a, b }, epsilon });
        let bounds = readings.iter().flat_map(|reading| {
            let epsilon = reading.half_width().map(Cow::into_owned);
            half_planes(reading).map(move |bound| row(bound, epsilon.clone()))
        });
        let (upper, lower): (Vec<_>, Vec<_>) =
            bounds.partition(|(name, _)| matches!(name, BoundName::Upper(_)));
        let conditions = conditions_by_name(&problem.conditions).map(|condition| row(condition, None));
        let (names, rows) = upper.into_iter().chain(lower).chain(conditions).unzip();
        ProgramRows { rows, names }
    }

    /// The rows with their error bounds.
    pub fn rows(&self) -> &[RefereeRow] {
        &self.rows
    }

    /// The rows alone.
    pub fn plain(&self) -> Vec<Row> {
        self.rows.iter().map(|row| row.row.clone()).collect()
    }

    /// The names of the rows.
    pub fn names(&self) -> &[BoundName] {
        &self.names
    }

    /// The exact simplex over these rows.
    pub(crate) fn exact_simplex(&self) -> ExactSimplex {
        ExactSimplex::new(self.rows.iter().map(|row| &row.row))
    }

    /// The name of a row.
    ///
    /// # Panics
    /// When there is no such row.
    #[allow(
        clippy::indexing_slicing,
        reason = "documented to panic; rows are counted by the referee of the same rows"
    )]
    pub fn name(&self, row: usize) -> BoundName {
        self.names[row]
    }

    /// The rows as a float solver receives them, taken exactly: every number rounded to the nearest binary64. `None`
    /// when one overflows.
    pub fn in_binary64(&self) -> Option<ProgramRows> {
        let plain = self.plain();
        let program = Program { rows: &plain, objective: [Rational::zero(), Rational::zero()] };
        let rounded = FloatProgram::new(&program).exact_rows()?;
        let rows = rounded
            .into_iter()
            .zip(&self.rows)
            .map(|(row, RefereeRow { epsilon, .. })| RefereeRow { row, epsilon: epsilon.clone() });
        Some(ProgramRows { rows: rows.collect(), names: self.names.clone() })
    }
}
