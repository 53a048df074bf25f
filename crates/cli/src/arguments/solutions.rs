//! The arguments about solutions that are judged.

use clap::Args;

use super::tolerance::ToleranceArguments;

/// Solutions of the model, and how far they may be off.
#[derive(Debug, Args)]
pub(crate) struct SolutionArguments {
    /// Judge this solution: a file of HiGHS, GLPK, CBC, CLP, SCIP, CPLEX (XML), Gurobi or MIPLIB, or JSON with
    /// "status", "objective", "x", "duals", "reduced_costs", "ray", "farkas"; its content decides; repeatable
    #[arg(long = "solution", visible_alias = "claim", value_name = "FILE")]
    pub(crate) solutions: Vec<String>,
    #[command(flatten)]
    pub(crate) tolerance: ToleranceArguments,
}
