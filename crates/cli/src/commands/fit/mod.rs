//! `boundfit fit`.

mod fleet;
mod window;
mod x_errors;

use std::time::Duration;

use boundfit_ask::{Fit, Form, Given, Window};
use boundfit_check::{CheckOptions, EXACT_SIMPLEX, check, source_names};
use boundfit_estimation::{Measurements, Problem};
use boundfit_exact::{Limit, Rational, Reading};
use boundfit_report::{NextStep, verdict_line};
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::asked::Job;
use super::proof_file;
use crate::exit::{CommandResult, Failure};
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Notes, OutputArguments, ReportFormat, ThreadArguments,
    XErrorArguments, column_text, limits, whole,
};
use crate::output::files_apart;

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "A line through columns Vz and z, data rows 14 to 36, every z known to 0.5 mm",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3",
        ),
        (
            "One error bound per row, and a slope that is known not to be negative",
            "boundfit fit steam.csv --x x --y y --eps-column eps --where 'theta1 >= 0'",
        ),
        (
            "How the set grows with the error bound, from half of eps to twice eps",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --sweep 0.5..2",
        ),
        (
            "Two regressors without a constant, from standard input, as JSON",
            "boundfit fit - --x 1,2 --y 3 --eps 1/100 --format json < readings.csv",
        ),
        (
            "Vectors of a MATLAB file; the vertices as a script for MATLAB and Octave (or csv, wkt, latex, markdown)",
            "boundfit fit transducer.mat --x Vz --y z --rows 14..36 --eps 0.5e-3 --format m -o vertices.m",
        ),
        (
            "A report with its proof, for somebody who does not trust it",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof proof.json",
        ),
        (
            "A theorem that the kernel of Coq checks without boundfit",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof answer.v\n\
             coqc answer.v",
        ),
        (
            "The guaranteed share of further readings in the band of eps_min, with confidence 0.99",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --confidence 0.99",
        ),
        (
            "Errors in x as well: lines that meet every box U +- 0.2, I +- 2",
            "boundfit fit current.csv --x U --y I --eps 2 --x-eps 0.2",
        ),
        (
            "Every sensor of a fleet on its own, one line each (--format json or csv for programs)",
            "boundfit fit fleet.csv --by sensor --x V --y level --eps 0.03",
        ),
        (
            "The last 10 readings, again after every 5 readings",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --window 10 --step 5",
        ),
    ],
    statuses: &[
        (0, "an answer was found"),
        BAD_DATA,
        BAD_USAGE,
        (
            3,
            "the feasible parameter set is empty (with --by or a window, at least one set); the proof is printed",
        ),
    ],
};

/// Fit y = theta1*x + theta2 + e with |e| <= eps: every parameter pair that agrees with all readings
///
/// The feasible parameter set (FPS) is the polygon of all (theta1, theta2) whose line stays within the error bound of
/// every reading. The report lists its vertices, the interval of each parameter (PUI), the central estimate, least
/// squares with its interval (EUI), and the smallest possible error bound.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("limit", limits::with(&[Limit::Fraction])))]
pub(crate) struct FitArguments {
    #[command(flatten)]
    data: DataArguments,
    #[command(flatten)]
    x_errors: XErrorArguments,
    /// Also report the sets FPS(s*eps) for all factors s from FROM to TO. The report has the factors at which the set
    /// begins and changes its shape, and each vertex and PUI end as an exact function of s
    #[arg(long, value_name = "FROM..TO")]
    sweep: Option<String>,
    /// Fit each group of rows with the same text in this column separately. The report has a line of text, JSON or
    /// CSV per group, in order of first occurrence, and a summary (with JSON and CSV on standard error)
    #[arg(long, value_name = "COL", value_parser = column_text, conflicts_with = "sweep")]
    by: Option<String>,
    /// Fit the last N readings in order of rows, repeatedly: one line of text, JSON or CSV per whole window
    #[arg(long, value_name = "N", value_parser = whole::<u64>(1, u64::MAX),
          conflicts_with_all = ["by", "sweep", "brief", "vertices", "inverse", "proof", "confidence"])]
    window: Option<u64>,
    /// Fit the readings whose x is at most NUM below the x of the newest, in order of x, repeatedly: one line per
    /// window
    #[arg(long, value_name = "NUM", allow_hyphen_values = true,
          conflicts_with_all = ["by", "sweep", "brief", "vertices", "inverse", "proof", "confidence"])]
    window_x: Option<String>,
    /// Number of readings by which a window moves each time [default: 1]
    #[arg(long, value_name = "K", value_parser = whole::<u64>(1, u64::MAX))]
    step: Option<u64>,
    /// Report everything: also the proof of each PUI end, all estimates of the inverse line, area, centroid, least squares in
    /// doubles, and the answer of an LP solver
    #[arg(long, conflicts_with_all = ["by", "window", "window_x"])]
    full: bool,
    /// With --full: do not ask an LP solver. Nothing else asks one
    #[arg(long)]
    no_lp: bool,
    /// Skip results that need a second pass over files of more than 10000 rows. These are the estimate uncertainty
    /// intervals (EUI), and eps_min unless the model is a line under a uniform error bound
    #[arg(long)]
    no_eui: bool,
    /// Report ten lines only: model, data, kind of set, PUI, central estimate, smallest error bound
    #[arg(long, conflicts_with = "by")]
    brief: bool,
    /// With --format csv: write the vertices, rays and lines of the set instead of intervals and estimates
    #[arg(long, conflicts_with = "by")]
    vertices: bool,
    /// Also report the inverse line x = gain*y + offset if the PUI of theta1 contains 0
    #[arg(long, conflicts_with = "by")]
    inverse: bool,
    /// Also report a guaranteed share of further readings in the band of eps_min, with this confidence between 0 and 1,
    /// such as 0.99. It assumes that all readings are independent draws from one source
    #[arg(long, value_name = "NUM", allow_hyphen_values = true, conflicts_with = "by")]
    confidence: Option<String>,
    /// Also write a proof of the answer to this file, whole or not at all. The proof is JSON that 'boundfit verify', or
    /// anybody else, checks against the data by arithmetic alone; in FILE.v it is a theorem for the kernel of Coq instead.
    /// - means standard output if the report goes to a file
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    proof_library: bool,
    #[command(flatten)]
    threads: ThreadArguments,
    #[command(flatten)]
    output: OutputArguments<ReportFormat>,
}

impl FitArguments {
    /// The question about the fit of all readings.
    fn question(&self) -> Fit {
        Fit {
            no_eui: self.no_eui,
            sweep: self.sweep.clone(),
            confidence: self.confidence.clone().map(Given::Read),
            brief: self.brief,
            full: self.full,
            inverse: self.inverse,
        }
    }

    /// The windows that are asked for, if they are.
    pub(crate) fn window(&self) -> Option<Window> {
        let is_asked = self.window.is_some() || self.window_x.is_some() || self.step.is_some();
        is_asked.then(|| Window {
            window: self.window.map(limits::size),
            window_x: self.window_x.clone().map(Given::Read),
            step: self.step.map(limits::size),
        })
    }
}

/// Reads the data, fits and writes the report.
pub(super) fn run(arguments: &FitArguments) -> CommandResult {
    arguments.threads.set()?;
    check_usage_of_proof(arguments)?;
    let format = arguments.output.format()?;
    check_usage_of_parts(arguments, format)?;
    let output = arguments.output.file.output.as_deref();
    let mut guard = arguments.output.file.replace.guard([arguments.data.path()]);
    guard.check(output)?;
    guard.check(arguments.proof.as_deref())?;
    if arguments.x_errors.are_asked() {
        return x_errors::run(arguments, format, &mut guard);
    }
    if let Some(by) = &arguments.by {
        return fleet::run(arguments, by, format, &mut guard);
    }
    if let Some(window) = arguments.window() {
        return window::run(arguments, &window, format, &mut guard);
    }
    let form = if arguments.vertices { Form::Vertices } else { format.into() };
    // A solver of linear programs in doubles is a part of this program, and of no other surface.
    let asks_solver = form == Form::Text && arguments.full && !arguments.no_lp;
    let job = arguments.job(form).with_theory(arguments.proof_library)?;
    job.run_with(&arguments.question(), &mut guard, |asked, answer, origin| {
        if asks_solver {
            answer.verdict = lp_verdict(&asked.problem, origin.reading)?;
        }
        answer.next_words = Some(next_words);
        Ok(None)
    })
}

impl FitArguments {
    /// Returns the data of the question, and the destination of the answer.
    fn job(&self, form: Form) -> Job<'_> {
        Job {
            data: self.data.words_with(&self.x_errors),
            form,
            style: self.data.table.limits.limited(self.output.style()),
            output: self.output.file.output.as_deref(),
            proof: self.proof.as_deref(),
            theory: None,
        }
    }
}

/// Says how a step is taken on the command line.
fn next_words(step: &NextStep) -> Option<String> {
    Some(match step {
        NextStep::Outliers => "boundfit outliers ...".to_owned(),
        NextStep::Status => "boundfit status ...".to_owned(),
        NextStep::LeastBound(least) => format!("boundfit fit ... --eps {least}"),
    })
}

/// Refuses what only some formats have.
fn check_usage_of_parts(arguments: &FitArguments, format: ReportFormat) -> Result<(), Failure> {
    let problem = if arguments.vertices && format != ReportFormat::Csv {
        "'--vertices' needs '--format csv'; other formats contain the vertices anyway"
    } else if arguments.no_eui && arguments.by.is_some() {
        "'--no-eui' is about one set: '--by' reads each group once, and no EUI needs another look"
    } else {
        // Lines of many sets are decimals in every format.
        let has_one_set = arguments.by.is_none() && arguments.window().is_none();
        let form = if arguments.vertices { Form::Vertices } else { format.into() };
        return if has_one_set { arguments.output.check_decimals(form) } else { Ok(()) };
    };
    Err(Failure::Usage(problem.to_owned()))
}

/// Refuses a proof that would have no file of its own, or be about many sets.
fn check_usage_of_proof(arguments: &FitArguments) -> Result<(), Failure> {
    if arguments.by.is_some() && arguments.proof.is_some() {
        let instead = "fit the rows of one group with '--rows', or a file with these rows only";
        return Err(Failure::Usage(format!("'--proof' is about one set and '--by' about many: {instead}")));
    }
    let proof = arguments.proof.as_deref();
    proof_file::theory(proof, arguments.proof_library)?;
    if arguments.x_errors.are_asked() || arguments.window().is_some() {
        proof_file::refuse_theorem(proof)?;
    }
    files_apart(arguments.output.file.output.as_deref(), &[("--proof", proof)])
}

/// Readings that an LP solver is asked about beside a fit. Measured: microlp takes 40 µs for each, for 50 about as long as the
/// whole program without it.
const MOST_READINGS_FOR_LP: usize = 50;

/// Asks the default float solver about the same data; where they are many, about those that can bound the set. Returns `None`
/// in a build without float solvers.
fn lp_verdict(problem: &Problem, reading: Reading) -> Result<Option<String>, Failure> {
    const MOST: usize = MOST_READINGS_FOR_LP;
    let Some(solver) = source_names().into_iter().find(|name| name != EXACT_SIMPLEX) else { return Ok(None) };
    let measurements = &problem.measurements;
    let fitted = measurements.fitted();
    let few = (fitted > MOST).then(|| measurements.supporting()).flatten();
    let asked = few.as_ref().map_or(fitted, Vec::len);
    if asked > MOST {
        let (which, more) = match few {
            Some(_) => (" that can bound the set", format!(", these are {asked}")),
            None => ("", String::new()),
        };
        return Ok(Some(format!(
            "not asked about more than {MOST} readings{which}{more} (see boundfit check)"
        )));
    }
    let few = few.map(|rows| {
        let (model, response) = (measurements.model().clone(), measurements.response().to_owned());
        let error_bound = measurements.error_bound().clone();
        let measurements = Measurements::new(model, response, error_bound, rows);
        Problem { measurements, conditions: problem.conditions.clone() }
    });
    let problem = few.as_ref().unwrap_or(problem);
    let options = CheckOptions {
        solvers: vec![solver],
        answers: Vec::new(),
        tolerance: Rational::ratio(1, 1_000_000),
        as_printed: true,
        time_limit: Duration::from_secs(10),
        directions: None,
        all_rows: true,
    };
    let check = check(problem, reading, &options).map_err(Failure::data)?;
    let about = match asked < fitted {
        true => format!(", on the {asked} of {fitted} readings that can bound the set"),
        false => String::new(),
    };
    Ok(verdict_line(&check, reading).map(|verdict| verdict + &about))
}
