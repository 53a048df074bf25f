//! The sources of answers: the float solvers of this build, and the exact simplex.

use std::time::Duration;

use boundfit_exact::Foreign;
use boundfit_lp::{BoundClaim, Claimed, ExactOutcome, Printed, PuiEnd};
use thiserror::Error;

use crate::answer::Answer;
use crate::float;
use crate::rows::ProgramRows;

/// The name of the exact simplex on the command line.
pub const EXACT_SIMPLEX: &str = "exact-simplex";

/// A solver that this build does not have.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("there is no solver {name:?} in this build; it has {}", .available.join(", "))]
pub struct SourceError {
    /// The name asked for.
    pub name: Foreign,
    /// The names there are.
    pub available: Vec<String>,
}

/// The names of all solvers of this build, the default first: the float solvers, which the feature `float-solvers` brings, and
/// the exact simplex.
pub fn source_names() -> Vec<String> {
    float::names().into_iter().chain([EXACT_SIMPLEX.to_owned()]).collect()
}

/// Lets a solver answer the four programs. A float solver gets the rows rounded to binary64 and at most `limit` for each.
///
/// # Errors
/// When this build has no such solver.
pub fn answer_of(name: &str, rows: &ProgramRows, limit: Duration) -> Result<Answer, SourceError> {
    if name == EXACT_SIMPLEX {
        let simplex = rows.exact_simplex();
        let claims =
            PuiEnd::each(|end| exact_claim(end, simplex.minimise(&end.objective()), rows.rows().len()));
        return Ok(Answer { source: name.into(), exact_input: true, claims });
    }
    let unknown = || SourceError { name: name.into(), available: source_names() };
    float::answer_of(name, &rows.plain(), limit).ok_or_else(unknown)
}

fn exact_claim(end: PuiEnd, outcome: ExactOutcome, rows: usize) -> BoundClaim {
    let (theta, multipliers) = match outcome {
        ExactOutcome::Optimal { theta, multipliers, .. } => (theta, multipliers),
        ExactOutcome::Infeasible { .. } => return BoundClaim::bare(Claimed::Infeasible),
        ExactOutcome::Unbounded { .. } => return BoundClaim::bare(Claimed::Unbounded),
    };
    let mut duals = vec![0.0; rows];
    for multiplier in multipliers {
        if let Some(dual) = duals.get_mut(multiplier.row) {
            *dual = multiplier.value.to_f64();
        }
    }
    BoundClaim::attained(end, theta.map(Printed::exact), Some(duals))
}
