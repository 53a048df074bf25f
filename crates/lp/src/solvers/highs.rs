//! HiGHS: dual simplex with presolve, at its default settings.

use highs::{HighsModelStatus, RowProblem, Sense};

use super::Solver;
use crate::outcome::{Optimum, Outcome};
use crate::program::FloatProgram;

pub(super) struct Highs;

impl Solver for Highs {
    fn name(&self) -> &'static str {
        "highs"
    }

    fn version(&self) -> &'static str {
        "1.15"
    }

    fn solve(&self, program: &FloatProgram) -> Outcome {
        let mut problem = RowProblem::default();
        let theta = program.objective.map(|cost| problem.add_column::<f64, _>(cost, ..));
        for [a1, a2, b] in &program.rows {
            problem.add_row(..=*b, [(theta[0], *a1), (theta[1], *a2)]);
        }
        let mut model = match problem.try_optimise(Sense::Minimise) {
            Ok(model) => model,
            Err(status) => return Outcome::Failed(format!("{status:?}")),
        };
        model.make_quiet();
        let solved = match model.try_solve() {
            Ok(solved) => solved,
            Err(status) => return Outcome::Failed(format!("{status:?}")),
        };
        match solved.status() {
            HighsModelStatus::Optimal => {
                let solution = solved.get_solution();
                let columns = solution.columns();
                Outcome::Optimal(Optimum {
                    theta: [columns[0], columns[1]],
                    objective: solved.objective_value(),
                    // HiGHS prices an active upper bound of a row negatively when it minimises.
                    duals: Some(solution.dual_rows().iter().map(|dual| -dual).collect()),
                })
            }
            HighsModelStatus::Infeasible => Outcome::Infeasible,
            HighsModelStatus::Unbounded => Outcome::Unbounded,
            HighsModelStatus::UnboundedOrInfeasible => Outcome::InfeasibleOrUnbounded,
            status => Outcome::Failed(format!("{status:?}")),
        }
    }
}
