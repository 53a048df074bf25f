//! The arguments of `boundfit check`.

use clap::builder::NonEmptyStringValueParser;
use clap::{Args, value_parser};

use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::tolerance::ToleranceArguments;
use super::{DataArguments, OutputArguments};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "Every solver of this build against the exact answer",
            "boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3",
        ),
        (
            "The PUI that some other program printed",
            "boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 \\\n\
             \x20 --claim-pui 1.7909e-3,1.8484e-3,2.2596e-2,2.2807e-2",
        ),
        (
            "What a solver wrote about the programs of 'boundfit convert', four files in a folder",
            "boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --claim solutions",
        ),
        (
            "The hull of 16 LP optimisers, the set itself, and the half-planes behind the 16 optima",
            "boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --directions 16",
        ),
    ],
    statuses: &[(0, "no claim is refuted"), BAD_DATA, BAD_USAGE, (4, "a claim is refuted")],
};

/// Judge LP answers about the same fit: is each end of the parameter uncertainty intervals right?
///
/// boundfit compares solvers of this build and claims from elsewhere with the exact answer. Verdicts are exact, rounded
/// (at most 4 units in the last place of a double, or half a unit of the last printed digit), within tolerance (on
/// either side), loose (too wide), infeasible point, unsafe (cuts off feasible parameters), wrong status and inverted
/// interval. The data as written decide the exit status; the report also judges against the doubles that a solver
/// receives.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("tolerance", |arg| arg.help(
    "How far a bound may be off to either side, in widths of the interval, and how far outside a point, in units of eps"
)))]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// Judge this solver; repeatable. Default: all solvers of this build, unless a claim is given
    #[arg(long = "solver", value_name = "NAME")]
    pub(crate) solvers: Vec<String>,
    /// Judge the claims in this file: JSON, or a solution by GLPK, HiGHS, CPLEX (XML), CBC or SCIP of one of the
    /// programs of 'boundfit convert'. The file name says which program (theta1-min ...); a folder gives all solutions
    /// in it; repeatable
    #[arg(long = "claim", value_name = "FILE|DIR")]
    pub(crate) claims: Vec<String>,
    /// Judge these ends of the intervals; inf and -inf claim an unbounded end; repeatable
    #[arg(long = "claim-pui", value_name = "LO1,HI1,LO2,HI2", allow_hyphen_values = true)]
    pub(crate) claimed_pui: Vec<String>,
    /// Give solvers the rows of all readings. By default, for more than 1000 readings of a line under one error bound,
    /// solvers get only the rows that can bound the set, unless a claim has multipliers for all rows
    #[arg(long)]
    pub(crate) all_rows: bool,
    /// Compare the set with the optimal points of linear programs in N directions
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "16",
          value_parser = value_parser!(u16).range(3..=10000))]
    pub(crate) directions: Option<u16>,
    /// Spread these directions evenly after scaling the box of both intervals to a square, and not in the plane of
    /// theta1 and theta2
    #[arg(long, requires = "directions")]
    pub(crate) scaled: bool,
    /// Write a theorem for the kernel of Coq to this file, which ends in .v: the four ends, and the set that has them
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    pub(crate) proof_library: bool,
    #[command(flatten)]
    pub(crate) tolerance: ToleranceArguments,
    /// Seconds that a solver may spend on one program
    #[arg(long, value_name = "SECONDS", default_value_t = 60, value_parser = value_parser!(u64).range(1..=86400))]
    pub(crate) time_limit: u64,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}
