//! `boundfit check`.

use std::fs;
use std::path::Path;

use boundfit_ask::{Check, ClaimFile};
use boundfit_check::is_solution_name;
use boundfit_exact::Foreign;
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::asked::Job;
use super::proof_file;
use crate::exit::{CommandResult, Failure};
use crate::input::read_text;
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Notes, OutputArguments, Switch, ToleranceArguments, whole,
};

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
/// boundfit compares solvers of this build and claims from elsewhere with the exact answer. An end is right if it is
/// exact, rounded (by at most 4 units in the last place of a double, or half a unit of the last printed digit) or
/// within tolerance. Refuted ends are loose (too wide), infeasible points, unsafe (they cut off feasible parameters),
/// of the wrong status or in an inverted interval. The data as written decide the exit status; the report also judges
/// against the doubles that a solver receives.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("tolerance", |arg| arg.help(
    "The distance by which a bound may be off to either side, in widths of the interval, and a point outside, in units of eps"
)))]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    data: DataArguments,
    /// Judge this solver; repeatable. Default: all solvers of this build, unless a claim is given
    #[arg(long = "solver", value_name = "NAME")]
    solvers: Vec<String>,
    /// Judge the claims in this file: JSON, or a solution by GLPK, HiGHS, CPLEX (XML), CBC or SCIP of one of the
    /// programs of 'boundfit convert'. The file name says which program (theta1-min ...); a folder gives all solutions
    /// in it. The point of a solution is the claim ('boundfit judge' judges the objective, too); repeatable
    #[arg(long = "claim", value_name = "FILE|DIR")]
    claims: Vec<String>,
    /// Judge these ends of the intervals; inf and -inf claim an unbounded end; repeatable
    #[arg(long = "claim-pui", value_name = "LO1,HI1,LO2,HI2", allow_hyphen_values = true)]
    claimed_pui: Vec<String>,
    /// Give solvers the rows of all readings. By default solvers get at most 1000 readings of a line under one error
    /// bound: of more, only those that can bound the set. A claim with multipliers for all rows implies this option
    #[arg(long)]
    all_rows: bool,
    /// Compare the set with the optimal points of linear programs in N directions
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "16",
          value_parser = whole::<u16>(3, 10_000))]
    directions: Option<u16>,
    /// Spread these directions evenly after scaling the box of both intervals to a square, and not in the plane of
    /// theta1 and theta2
    #[arg(long, requires = "directions")]
    scaled: bool,
    /// Write a theorem for the kernel of Coq to this file, which ends in .v: the four ends, and the set that has them
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    proof_library: bool,
    #[command(flatten)]
    tolerance: ToleranceArguments,
    /// Seconds that a solver may spend on one program
    #[arg(long, value_name = "SECONDS", default_value_t = 60, value_parser = whole::<u64>(1, 86_400))]
    time_limit: u64,
    #[command(flatten)]
    output: OutputArguments,
}

impl CheckArguments {
    /// The question, with the texts of these claims.
    fn question(&self, files: Vec<String>) -> Result<Check, Failure> {
        let most = self.data.table.limits.statement();
        let claim = |file: String| Ok(ClaimFile { text: read_text(&file, most)?, file });
        Ok(Check {
            solver: self.solvers.clone(),
            claim: files.into_iter().map(claim).collect::<Result<_, Failure>>()?,
            claim_pui: self.claimed_pui.clone(),
            tolerance: Some(self.tolerance.given()),
            digits_as_printed: Some(self.tolerance.digits_as_printed == Switch::On),
            all_rows: self.all_rows,
            directions: self.directions,
            scaled: self.scaled,
            time_limit: Some(self.time_limit),
        })
    }
}

/// Reads the claims and the data, judges and writes the report, and the theorem if one is asked for.
pub(super) fn run(arguments: &CheckArguments) -> CommandResult {
    let proof = arguments.proof.as_deref();
    let job = Job::of(arguments.data.words(), &arguments.output, proof)?;
    let claims = claim_files(&arguments.claims)?;
    let theory = proof_file::only_theory(proof, arguments.proof_library, "the four ends")?;
    let job = Job { theory, ..job };
    let files: Vec<&str> = claims.iter().map(String::as_str).collect();
    let mut guard = job.guard(&arguments.output.file.replace, &files)?;
    job.run(&arguments.question(claims)?, &mut guard)
}

/// The files asked for, and of each folder those that answer one of the four programs, by name.
fn claim_files(asked: &[String]) -> Result<Vec<String>, Failure> {
    let mut files = Vec::new();
    for name in asked {
        if !Path::new(name).is_dir() {
            files.push(name.clone());
            continue;
        }
        let fail = |error| Failure::data(format_args!("{}: cannot read: {error}", Foreign::of(name)));
        let entries = fs::read_dir(name).map_err(fail)?.collect::<Result<Vec<_>, _>>().map_err(fail)?;
        let paths = entries.into_iter().map(|entry| entry.path());
        let mut found: Vec<String> = paths
            .filter(|path| path.is_file() && is_solution_name(path))
            .map(|path| path.to_string_lossy().into_owned())
            .collect();
        if found.is_empty() {
            return Err(Failure::data(format_args!(
                "{}: no solution is in this folder (expected files named after theta1-min, theta1-max, theta2-min, theta2-max)",
                Foreign::of(name)
            )));
        }
        found.sort();
        files.extend(found);
    }
    Ok(files)
}
