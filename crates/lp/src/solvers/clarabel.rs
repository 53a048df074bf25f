//! Clarabel: an interior-point method (Goulart and Chen 2024), at its default settings.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus};

use super::Solver;
use crate::outcome::{Optimum, Outcome};
use crate::program::FloatProgram;

pub(super) struct Clarabel;

impl Solver for Clarabel {
    fn name(&self) -> &'static str {
        "clarabel"
    }

    fn version(&self) -> &'static str {
        "0.11"
    }

    fn solve(&self, program: &FloatProgram) -> Outcome {
        let count = program.rows.len();
        let quadratic = CscMatrix::<f64>::zeros((2, 2));
        let (first, second) = (program.rows.iter().map(|row| row[0]), program.rows.iter().map(|row| row[1]));
        let values = first.chain(second).collect();
        let row_numbers = (0..count).chain(0..count).collect();
        let matrix = CscMatrix::new(count, 2, vec![0, count, 2 * count], row_numbers, values);
        let bounds: Vec<f64> = program.rows.iter().map(|row| row[2]).collect();
        let settings = match DefaultSettingsBuilder::default().verbose(false).build() {
            Ok(settings) => settings,
            Err(error) => return Outcome::Failed(error.to_string()),
        };
        let cones = [NonnegativeConeT(count)];
        let mut solver =
            match DefaultSolver::new(&quadratic, &program.objective, &matrix, &bounds, &cones, settings) {
                Ok(solver) => solver,
                Err(error) => return Outcome::Failed(error.to_string()),
            };
        solver.solve();
        let solution = &solver.solution;
        match solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => match *solution.x.as_slice() {
                [theta1, theta2] => Outcome::Optimal(Optimum {
                    theta: [theta1, theta2],
                    objective: solution.obj_val,
                    duals: Some(solution.z.clone()),
                }),
                _ => Outcome::Failed("an optimum with other than two numbers".to_owned()),
            },
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => Outcome::Infeasible,
            // A certificate of dual infeasibility is a falling ray; Clarabel takes a feasible point for granted.
            SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible => Outcome::Unbounded,
            status => Outcome::Failed(status.to_string()),
        }
    }
}
