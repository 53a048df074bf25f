//! Answers of the float solvers.

use std::time::Duration;

use boundfit_exact::Rational;
use boundfit_lp::{
    BoundClaim, Claimed, FloatProgram, Optimum, Outcome, Program, PuiEnd, Row, solve_guarded, solver_named,
    solvers,
};

use crate::answer::Answer;

/// The names of the float solvers of this build, the default first.
pub(crate) fn names() -> Vec<String> {
    solvers().iter().map(|solver| solver.name().to_owned()).collect()
}

/// Returns what a float solver answers, which gets the rows rounded to binary64 and at most `limit` for each program. `None` when
/// this build has none of that name.
pub(crate) fn answer_of(name: &str, rows: &[Row], limit: Duration) -> Option<Answer> {
    let solver = solver_named(name)?;
    let claims = PuiEnd::each(|end| {
        let program = FloatProgram::new(&Program { rows, objective: end.objective() });
        claim(end, solve_guarded(name, &program, limit))
    });
    let source = format!("{} {}", solver.name(), solver.version());
    Some(Answer { source: source.into(), exact_input: false, claims })
}

fn claim(end: PuiEnd, outcome: Outcome) -> BoundClaim {
    match outcome {
        Outcome::Optimal(Optimum { theta, duals, .. }) => {
            let [theta1, theta2] = theta.map(Rational::from_f64);
            match theta1.zip(theta2) {
                Some((theta1, theta2)) => BoundClaim::attained(end, [theta1.into(), theta2.into()], duals),
                None => BoundClaim::nothing("an optimum that is not finite"),
            }
        }
        Outcome::Infeasible => BoundClaim::bare(Claimed::Infeasible),
        Outcome::Unbounded => BoundClaim::bare(Claimed::Unbounded),
        Outcome::InfeasibleOrUnbounded => BoundClaim::bare(Claimed::InfeasibleOrUnbounded),
        Outcome::Failed(reason) => BoundClaim::nothing(&reason),
    }
}
