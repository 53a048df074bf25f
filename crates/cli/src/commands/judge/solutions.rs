//! The solutions that `boundfit judge` judges.

use boundfit_ask::tolerance;
use boundfit_exact::Foreign;
use boundfit_judge::{Answer, Findings, Ground, JudgedSolution, Solution, Tolerances, read_solution};
use boundfit_lp::Model;
use clap::Args;

use crate::exit::Failure;
use crate::input::{named, read_text};
use crate::options::{LimitArguments, Switch, ToleranceArguments};
use crate::work::refuse_long_text;

/// Solutions of the model, and how far they may be off.
#[derive(Debug, Args)]
pub(crate) struct SolutionArguments {
    /// Judge this solution: a file of HiGHS, GLPK, CBC, CLP, SCIP, CPLEX (XML), Gurobi or MIPLIB, or JSON with
    /// "status", "objective", "x", "duals", "reduced_costs", "ray", "farkas"; its content decides; repeatable
    #[arg(long = "solution", visible_alias = "claim", value_name = "FILE")]
    pub(super) solutions: Vec<String>,
    #[command(flatten)]
    tolerance: ToleranceArguments,
}

/// Reads and judges all of them.
pub(super) fn judged(
    arguments: &SolutionArguments,
    limits: &LimitArguments,
    model: &Model,
    answer: &Answer,
) -> Result<Vec<JudgedSolution>, Failure> {
    let tolerances = Tolerances {
        relative: tolerance(&arguments.tolerance.given(), &limits.number()).map_err(Failure::misused)?,
        digits_as_printed: arguments.tolerance.digits_as_printed == Switch::On,
    };
    if arguments.solutions.is_empty() {
        return Ok(Vec::new());
    }
    let ground = Ground::new(model, answer);
    let one = |file: &String| {
        let text = read_text(file, limits.statement())?;
        let fail = |error| Failure::refused_of(Foreign::of(named(file)), error);
        refuse_long_text(Foreign::of(named(file)), &text, limits)?;
        let solution = Solution::new(&read_solution(&text, &limits.number()).map_err(fail)?, model);
        let solution = solution.map_err(fail)?;
        let findings = ground.judge(&solution, &tolerances);
        Ok(JudgedSolution { file: named(file).into(), solution, findings })
    };
    arguments.solutions.iter().map(one).collect()
}

/// Returns whether one of them is refuted.
pub(super) fn is_refuted(judged: &[JudgedSolution]) -> bool {
    judged.iter().any(|judged| Findings::is_refuted(&judged.findings))
}
