//! `boundfit check`.

use std::fs;
use std::path::Path;
use std::time::Duration;

use boundfit_ask::{Ask, AskedTheorem, Fit, Fittable, Refusal};
use boundfit_check::{
    Answer, AskedDirections, CheckOptions, ClaimLimits, ClaimText, Claims, check, is_solution_name,
    parse_claim_pui, read_claims, source_names,
};
use boundfit_estimation::Problem;
use boundfit_exact::{Foreign, Reading};
use boundfit_lp::Verdict;
use boundfit_report::{Theory, check_document, check_json};
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::proof_file::{self, SmallFile};
use crate::exit::{CommandResult, Exit, Failure};
use crate::input::read_text;
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Format, Notes, OutputArguments, Switch, ToleranceArguments, whole,
};
use crate::output::{self, files_apart};
use crate::progress::while_working;
use crate::work::{refuse_long_problem, refuse_long_text, times};

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

/// Reads the data and the claims, runs the solvers, judges and writes the report.
pub(super) fn run(arguments: &CheckArguments) -> CommandResult {
    let format = arguments.output.format()?;
    let claims = claim_files(&arguments.claims)?;
    let inputs = claims.iter().map(String::as_str).chain([arguments.data.path()]);
    let mut guard = arguments.output.file.replace.guard(inputs);
    let (output, proof) = (arguments.output.file.output.as_deref(), arguments.proof.as_deref());
    let theory = proof_file::only_theory(proof, arguments.proof_library, "the four ends")?;
    files_apart(output, &[("--proof", proof)])?;
    guard.check(output)?;
    guard.check(proof)?;
    let data = arguments.data.words().open()?;
    let boundfit_report::Origin { file, reading, .. } = data.origin;
    let claims = claims_in(arguments, claims)?;
    let mut options = options(arguments, &claims)?;
    let has_all = options.all_rows || theory.is_some();
    let problem = if has_all { data.problem()? } else { data.supporting_problem()? };
    options.answers.splice(..0, claims.answers(&problem));
    let limits = &arguments.data.table.limits;
    refuse_long_problem(arguments.data.file_name(), &problem, times::CHECK, limits)?;
    let check = while_working("solving", || check(&problem, reading, &options));
    let check = check.map_err(|error| Failure::Usage(error.to_string()))?;
    let (style, measurements) = (arguments.output.style(), &problem.measurements);
    let report = match format {
        Format::Json => check_json(&check, measurements, file, reading, &style),
        Format::Text => {
            check_document(&check, measurements, arguments.data.file_name(), reading, &style).to_text()
        }
    };
    let theorem = theory.map(|theory| theorem(arguments, problem, (reading, theory))).transpose()?;
    let theorem = theorem.as_deref().map(|text| (text.as_bytes(), proof));
    let parts: Vec<_> = theorem.into_iter().chain([(report.as_bytes(), output)]).collect();
    output::write_together(&parts, &mut guard)?;
    Ok(if check.worst(reading).is_some_and(Verdict::is_refutation) { Exit::Refuted } else { Exit::Answer })
}

/// The theorem about the set, which states its four ends.
fn theorem(
    arguments: &CheckArguments,
    problem: Problem,
    (reading, theory): (Reading, Theory),
) -> Result<String, Failure> {
    let (question, asked) = (Fit::default(), Fittable::from(problem));
    let failed = |refusal: Refusal| Failure::of(&refusal, arguments.data.file_name());
    let answer = while_working("fitting", || question.answer(&asked)).map_err(failed)?;
    let small = proof_file::small_file(arguments.data.path());
    let told = AskedTheorem { reading, theory, data: small.as_ref().map(SmallFile::parts) };
    question.theorem(&asked, &answer, told).map_err(failed)
}

/// The claims in these files.
fn claims_in(arguments: &CheckArguments, files: Vec<String>) -> Result<Claims, Failure> {
    let limits = &arguments.data.table.limits;
    let limits = ClaimLimits { number: limits.number(), nesting: limits.sizes().nesting };
    let mut claims = Vec::new();
    for file in files {
        let text = read_text(&file, arguments.data.table.limits.statement())?;
        refuse_long_text(Foreign::of(&file), &text, &arguments.data.table.limits)?;
        claims.push(ClaimText { file: file.into(), text });
    }
    read_claims(&claims, &limits).map_err(Failure::refused)
}

/// All options but the answers in files.
fn options(arguments: &CheckArguments, claims: &Claims) -> Result<CheckOptions, Failure> {
    let mut answers: Vec<Answer> = Vec::new();
    for text in &arguments.claimed_pui {
        let answer = parse_claim_pui(text);
        answers.push(answer.map_err(|error| Failure::value("--claim-pui <LO1,HI1,LO2,HI2>", text, error))?);
    }
    let tolerance = arguments.tolerance.value(&arguments.data.table.limits.number())?;
    // Without a word about whom to judge, everybody is.
    let solvers = if arguments.solvers.is_empty()
        && answers.is_empty()
        && arguments.claims.is_empty()
        && arguments.directions.is_none()
    {
        source_names()
    } else {
        arguments.solvers.clone()
    };
    Ok(CheckOptions {
        solvers,
        answers,
        tolerance,
        as_printed: arguments.tolerance.digits_as_printed == Switch::On,
        time_limit: Duration::from_secs(arguments.time_limit),
        directions: arguments
            .directions
            .map(|count| AskedDirections { count: usize::from(count), is_scaled: arguments.scaled }),
        all_rows: arguments.all_rows || claims.have_duals(),
    })
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
