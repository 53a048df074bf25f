//! microlp: a sparse simplex in Rust, descended from minilp. It gives no duals.

use microlp::{ComparisonOp, Error, OptimizationDirection, Problem, SolveOutcome};

use super::Solver;
use crate::outcome::{Optimum, Outcome};
use crate::program::FloatProgram;

pub(super) struct Microlp;

impl Solver for Microlp {
    fn name(&self) -> &'static str {
        "microlp"
    }

    fn version(&self) -> &'static str {
        "0.7"
    }

    fn solve(&self, program: &FloatProgram) -> Outcome {
        let mut problem = Problem::new(OptimizationDirection::Minimize);
        let free = (f64::NEG_INFINITY, f64::INFINITY);
        let theta = program.objective.map(|cost| problem.add_var(cost, free));
        for [a1, a2, b] in &program.rows {
            problem.add_constraint([(theta[0], *a1), (theta[1], *a2)], ComparisonOp::Le, *b);
        }
        match problem.solve() {
            Ok(SolveOutcome::Solution(solution)) => Outcome::Optimal(Optimum {
                theta: theta.map(|variable| solution.var_value(variable)),
                objective: solution.objective(),
                duals: None,
            }),
            Ok(SolveOutcome::Interrupted(_)) => Outcome::Failed("interrupted".to_owned()),
            Err(Error::Infeasible) => Outcome::Infeasible,
            Err(Error::Unbounded) => Outcome::Unbounded,
            Err(error) => Outcome::Failed(error.to_string()),
        }
    }
}
