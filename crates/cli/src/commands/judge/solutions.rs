//! The solutions that `boundfit judge` judges.

use boundfit_ask::{ClaimFile, Judge};
use clap::Args;

use crate::exit::Failure;
use crate::input::{named, read_text};
use crate::options::{LimitArguments, Switch, ToleranceArguments};

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

impl SolutionArguments {
    /// The question, with the texts of the solutions.
    pub(super) fn question(&self, limits: &LimitArguments) -> Result<Judge, Failure> {
        let solution = |file: &String| {
            Ok(ClaimFile { file: named(file).to_owned(), text: read_text(file, limits.statement())? })
        };
        Ok(Judge {
            solution: self.solutions.iter().map(solution).collect::<Result<_, Failure>>()?,
            tolerance: Some(self.tolerance.given()),
            digits_as_printed: Some(self.tolerance.digits_as_printed == Switch::On),
        })
    }
}
