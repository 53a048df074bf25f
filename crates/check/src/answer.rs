//! Answers to the four programs behind the PUI.

use std::time::Duration;

use boundfit_exact::Rational;
use boundfit_lp::{
    BoundClaim, Claimed, ExactOutcome, FloatProgram, Optimum, Outcome, Program, exact_simplex,
    pui_objectives, solve_guarded, solvers,
};
use thiserror::Error;

use crate::rows::ProgramRows;

/// The name of the exact simplex on the command line.
pub const EXACT_SIMPLEX: &str = "exact-simplex";

/// What a source claims about the intervals of θ1 and θ2: lower and upper end of each.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Who claims it.
    pub source: String,
    /// Whether the source worked on the exact rows, so that their rounding is no excuse.
    pub exact_input: bool,
    /// By parameter, then lower and upper.
    pub claims: [[BoundClaim; 2]; 2],
}

/// A solver that this build does not have.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("there is no solver {name:?} in this build; it has {}", .available.join(", "))]
pub struct SourceError {
    /// The name asked for.
    pub name: String,
    /// The names there are.
    pub available: Vec<String>,
}

/// The names of all solvers of this build, the default first.
pub fn source_names() -> Vec<String> {
    solvers().iter().map(|solver| solver.name().to_owned()).chain([EXACT_SIMPLEX.to_owned()]).collect()
}

/// Lets a solver answer the four programs. A float solver gets the rows rounded to binary64 and at most `limit` for each.
///
/// # Errors
/// When this build has no such solver.
pub fn answer_of(name: &str, rows: &ProgramRows, limit: Duration) -> Result<Answer, SourceError> {
    let plain = rows.plain();
    let claims: Vec<BoundClaim>;
    let source;
    if name == EXACT_SIMPLEX {
        source = name.to_owned();
        claims = pui_objectives()
            .into_iter()
            .enumerate()
            .map(|(number, objective)| {
                exact_claim(number / 2, exact_simplex(&Program { rows: &plain, objective }), plain.len())
            })
            .collect();
    } else {
        let unknown = || SourceError { name: name.to_owned(), available: source_names() };
        let solver = solvers().into_iter().find(|solver| solver.name() == name).ok_or_else(unknown)?;
        source = format!("{} {}", solver.name(), solver.version());
        claims = pui_objectives()
            .into_iter()
            .enumerate()
            .map(|(number, objective)| {
                let program = FloatProgram::new(&Program { rows: &plain, objective });
                float_claim(number / 2, solve_guarded(name, &program, limit))
            })
            .collect();
    }
    let mut claims = claims.into_iter();
    let mut next = || claims.next().unwrap_or_else(|| nothing("not asked"));
    let exact_input = name == EXACT_SIMPLEX;
    Ok(Answer { source, exact_input, claims: [[next(), next()], [next(), next()]] })
}

/// No claim, for a reason.
pub(crate) fn nothing(reason: &str) -> BoundClaim {
    BoundClaim { claimed: Claimed::Nothing(reason.to_owned()), point: None, duals: None }
}

fn exact_claim(axis: usize, outcome: ExactOutcome, rows: usize) -> BoundClaim {
    match outcome {
        ExactOutcome::Optimal { theta, multipliers, .. } => {
            let mut duals = vec![0.0; rows];
            for multiplier in multipliers {
                if let Some(dual) = duals.get_mut(multiplier.row) {
                    *dual = multiplier.value.to_f64();
                }
            }
            let [theta1, theta2] = &theta;
            BoundClaim {
                claimed: Claimed::Value(if axis == 0 { theta1 } else { theta2 }.clone()),
                point: Some(theta),
                duals: Some(duals),
            }
        }
        ExactOutcome::Infeasible { .. } => {
            BoundClaim { claimed: Claimed::Infeasible, point: None, duals: None }
        }
        ExactOutcome::Unbounded { .. } => {
            BoundClaim { claimed: Claimed::Unbounded, point: None, duals: None }
        }
    }
}

fn float_claim(axis: usize, outcome: Outcome) -> BoundClaim {
    let status = |claimed| BoundClaim { claimed, point: None, duals: None };
    match outcome {
        Outcome::Optimal(Optimum { theta, duals, .. }) => {
            let [theta1, theta2] = theta.map(Rational::from_f64);
            match theta1.zip(theta2) {
                Some((theta1, theta2)) => {
                    let end = if axis == 0 { &theta1 } else { &theta2 };
                    let claimed = Claimed::Value(end.clone());
                    BoundClaim { claimed, point: Some([theta1, theta2]), duals }
                }
                None => nothing("an optimum that is not finite"),
            }
        }
        Outcome::Infeasible => status(Claimed::Infeasible),
        Outcome::Unbounded => status(Claimed::Unbounded),
        Outcome::InfeasibleOrUnbounded => status(Claimed::InfeasibleOrUnbounded),
        Outcome::Failed(reason) => nothing(&reason),
    }
}
