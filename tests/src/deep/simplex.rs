//! The exact simplex against the polygon engine.

use boundfit_exact::Rational;
use boundfit_geometry::{Polyhedron, Support};
use boundfit_lp::{ExactOutcome, Program, Row, exact_simplex};

use super::same;
use crate::lp_cases::rows_of;

/// Both engines give the same status and value for `min objective·θ`, each with a valid proof.
pub(super) fn same_maximum(polyhedron: &Polyhedron, objective: [Rational; 2]) -> Result<(), String> {
    let rows: Vec<Row> = rows_of(polyhedron.system());
    let program = Program { rows: &rows, objective };
    let outcome = exact_simplex(&program);
    if !outcome.verify(&program) {
        return Err(format!("the simplex proves nothing: {outcome:?} of {:?}", program.objective));
    }
    let system = polyhedron.system();
    let proved =
        |verified: Result<(), _>| verified.map_err(|error| format!("the polygon's proof: {error:?}"));
    match (&outcome, polyhedron.support(&program.objective.each_ref().map(|coefficient| -coefficient))) {
        (ExactOutcome::Optimal { value, .. }, Support::Bounded { proof, .. }) => {
            proved(proof.verify(system))?;
            same("the simplex's optimum and the polygon's", &-value, &proof.value)
        }
        (ExactOutcome::Infeasible { .. }, Support::Empty(farkas)) => proved(farkas.verify(system)),
        (ExactOutcome::Unbounded { .. }, Support::Unbounded(proof)) => proved(proof.verify(system)),
        (outcome, support) => Err(format!("the simplex says {outcome:?}, the polygon {support:?}")),
    }
}

/// Returns whether the rows leave anything, by the simplex alone.
pub(super) fn is_feasible(rows: &[Row]) -> bool {
    let objective = [Rational::zero(), Rational::zero()];
    !matches!(exact_simplex(&Program { rows, objective }), ExactOutcome::Infeasible { .. })
}
