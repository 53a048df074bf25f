//! The arguments about solutions that are judged.

use clap::Args;

use super::Switch;
use super::shared::LIMITS;

/// Solutions of the model, and how far they may be off.
#[derive(Debug, Args)]
pub(crate) struct SolutionArguments {
    /// Judge this solution: a file of HiGHS, GLPK, CBC, CLP, SCIP, CPLEX (XML), Gurobi or MIPLIB, or JSON with "status",
    /// "objective", "x", "duals", "reduced_costs", "ray", "farkas"; its content tells which; repeatable
    #[arg(long = "solution", visible_alias = "claim", value_name = "FILE")]
    pub(crate) solutions: Vec<String>,
    /// How far an answer may be off to either side, as a part of its size: of an optimum's, a row's, a price's
    #[arg(long, value_name = "NUM", default_value = "1e-6", allow_hyphen_values = true)]
    pub(crate) tolerance: String,
    /// Excuse nothing but rounding: a tolerance of 0
    #[arg(long, conflicts_with = "tolerance")]
    pub(crate) strict: bool,
    /// Take numbers in texts to be as precise as they are printed; off: to be meant exactly
    #[arg(long, value_name = "on|off", value_enum, default_value_t = Switch::On, hide_possible_values = true)]
    pub(crate) digits_as_printed: Switch,
    /// Bytes that a solution may have
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 28, help_heading = LIMITS, hide_short_help = true)]
    pub(crate) max_solution_size: u64,
}
