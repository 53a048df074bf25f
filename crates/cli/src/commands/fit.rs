//! `boundfit fit`.

use std::time::Duration;

use boundfit_ask::Form;
use boundfit_check::{CheckOptions, EXACT_SIMPLEX, check, source_names};
use boundfit_estimation::{Measurements, Problem};
use boundfit_exact::{Rational, Reading};
use boundfit_report::{NextStep, verdict_line};

use crate::CommandResult;
use crate::arguments::{FitArguments, ReportFormat};
use crate::commands::asked::Job;
use crate::commands::{fleet, proof_file, window, x_errors};
use crate::exit::Failure;

/// Reads the data, fits and writes the report.
pub(crate) fn run(arguments: &FitArguments) -> CommandResult {
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
    pub(super) fn job(&self, form: Form) -> Job<'_> {
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
    let is_document = matches!(format, ReportFormat::Text | ReportFormat::Latex | ReportFormat::Markdown);
    let problem = if arguments.vertices && format != ReportFormat::Csv {
        "'--vertices' is about '--format csv'; other formats have the vertices anyway"
    } else if (arguments.brief || arguments.full || arguments.inverse) && !is_document {
        "'--brief', '--full' and '--inverse' need the format text, latex or markdown; other formats contain everything"
    } else if arguments.confidence.is_some() && !is_document && format != ReportFormat::Json {
        "'--confidence' is about text, latex, markdown and json; other formats have no place for a guarantee"
    } else {
        return Ok(());
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
    proof_file::check_place(proof, arguments.output.file.output.as_deref())
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
