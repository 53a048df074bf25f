//! `boundfit convert`.

use std::path::Path;

use boundfit_check::exchange_rows;
use boundfit_estimation::{ErrorBound, Model, MultipleOfLeast, Problem};
use boundfit_exact::{Foreign, Reading};
use boundfit_lp::{ExchangeFormat, PuiEnd};
use clap::Args;
use clap::builder::{NonEmptyStringValueParser, PossibleValue};

use crate::exit::{CommandResult, Exit, Failure};
use crate::input;
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Notes, ReplaceArguments, explained, named, told_by_name,
};
use crate::output::{self, Output};
use crate::progress::while_working;
use crate::work::{refuse_long, times};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "The four linear programs of a fit, as free MPS",
            "boundfit convert transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --to mps -o programs",
        ),
        (
            "The answers of GLPK to them, judged exactly",
            "for f in programs/*.mps; do glpsol --freemps $f -w ${f%.mps}.sol; done\n\
             boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --claim programs",
        ),
        (
            "One of them in LP format, with the numbers that a float solver would receive",
            "boundfit convert steam.csv --x x --y y --eps-column eps --reading binary64 \\\n\
             \x20 --to lp --objective theta1-max",
        ),
    ],
    statuses: &[(0, "the programs are written"), BAD_DATA, BAD_USAGE],
};

/// Write the linear programs behind the parameter uncertainty intervals as files for other solvers
///
/// The four programs are the minimum and the maximum of theta1 and of theta2 over the feasible parameter set; a maximum
/// is written as the minimum of the opposite. Each reading gives two rows, named after its data row (row14_upper,
/// row14_lower); each condition gives one (where_1; an equation with =). No number is rounded: it is a finite decimal,
/// or its row is multiplied to whole numbers, as a comment says.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct ConvertArguments {
    #[command(flatten)]
    data: DataArguments,
    /// Format of the programs. Default: the ending of the output file's name
    #[arg(long, value_parser = explained(ExchangeFormat::ALL.map(|format| {
        (PossibleValue::new(format.name()).help(format.title()), format)
    })))]
    to: Option<ExchangeFormat>,
    /// Write only this program. Default: all four, into a folder
    #[arg(long, value_parser = named(PuiEnd::ALL.map(|end| (end.name(), end))))]
    objective: Option<PuiEnd>,
    /// Write the four programs into this folder, or the program of '--objective' to this file instead of standard
    /// output; each file whole or not at all
    #[arg(short, long, value_name = "DIR|FILE", value_parser = NonEmptyStringValueParser::new())]
    output: Option<String>,
    #[command(flatten)]
    replace: ReplaceArguments,
}

/// The destination of programs.
enum Destination<'a> {
    /// One program to a file, or to standard output.
    One(PuiEnd, Option<&'a str>),
    /// All programs into a folder.
    All(&'a str),
}

/// Reads the data and writes the programs that are asked for.
pub(super) fn run(arguments: &ConvertArguments) -> CommandResult {
    let destination = destination(arguments)?;
    let format = match arguments.to {
        Some(format) => format,
        None => told_format(arguments)?,
    };
    let name = |end: PuiEnd| format!("{}.{}", end.name(), format.name());
    let guard = arguments.replace.guard([arguments.data.path()]);
    match destination {
        Destination::One(_, file) => guard.check(file)?,
        Destination::All(folder) => guard.check_all(folder, PuiEnd::ALL.map(name))?,
    }
    let data = arguments.data.words().open()?;
    let reading = data.origin.reading;
    let problem = data.problem_in_columns()?;
    let limits = &arguments.data.table.limits;
    let work = problem.work_of_shown();
    refuse_long(arguments.data.file_name(), &work, times::CONVERT * problem.looks(), limits)?;
    let read = &problem.measurements;
    input::say_table(arguments.data.file_name(), read.table(), read.rows_missing());
    let about = comments(arguments, reading, &problem);
    let rows = exchange_rows(&problem);
    drop(problem);
    let write = |end: PuiEnd| {
        let comments: Vec<String> = [heading(end)].into_iter().chain(about.iter().cloned()).collect();
        let rows = &rows;
        move |output: &mut Output| {
            while_working("writing", || {
                output::written(output, |text| rows.write(text, end, format, &comments))
            })
        }
    };
    match destination {
        Destination::One(end, file) => output::write_parts(write(end), file, &guard)?,
        Destination::All(folder) => {
            output::write_all(folder, &PuiEnd::ALL.map(|end| (name(end), write(end))), &guard)?;
        }
    }
    Ok(Exit::Answer)
}

/// The format that the name of the output file tells.
fn told_format(arguments: &ConvertArguments) -> Result<ExchangeFormat, Failure> {
    let endings = ExchangeFormat::ALL.map(|format| (format.name(), format));
    let told = told_by_name(arguments.output.as_deref(), &endings, Some("'--to'"))?;
    told.ok_or_else(|| {
        Failure::Usage("'--to <TO>' is missing: the format of the programs, mps or lp".to_owned())
    })
}

/// Returns the destination of each program.
fn destination(arguments: &ConvertArguments) -> Result<Destination<'_>, Failure> {
    let file = arguments.output.as_deref().filter(|file| *file != "-");
    if let Some(objective) = arguments.objective {
        return Ok(Destination::One(objective, file));
    }
    let folder = file.ok_or_else(|| {
        Failure::Usage(
            "a fit makes four programs: name a folder for them with '--output <DIR>', or one of them with '--objective'"
                .to_owned(),
        )
    })?;
    let ending =
        Path::new(folder).extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    let is_file_name = ending.is_some_and(|ending| ending == "mps" || ending == "lp");
    if is_file_name && !Path::new(folder).is_dir() {
        let problem =
            "a fit makes four programs (expected a folder for them, or '--objective' for one of them)";
        return Err(Failure::value("--output <DIR|FILE>", folder, problem));
    }
    Ok(Destination::All(folder))
}

/// Returns the aim of the program.
fn heading(end: PuiEnd) -> String {
    let what = match end {
        PuiEnd::Theta1Min => "the smallest theta1",
        PuiEnd::Theta1Max => "the largest theta1, as the smallest -theta1",
        PuiEnd::Theta2Min => "the smallest theta2",
        PuiEnd::Theta2Max => "the largest theta2, as the smallest -theta2",
    };
    format!("{}: {what}, that agrees with every reading", end.name())
}

/// Returns comments about the source of the rows.
fn comments(arguments: &ConvertArguments, reading: Reading, problem: &Problem) -> Vec<String> {
    let measurements = &problem.measurements;
    let (y, e) = (measurements.response(), measurements.error_name());
    let column = |name: &Option<Foreign>, none: &str| {
        name.as_ref().map_or_else(|| none.to_owned(), Foreign::to_string)
    };
    let bound = match measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => format!("|{e}| <= {epsilon}"),
        ErrorBound::Column(name) => format!("|{e}| <= {name}"),
        ErrorBound::Law(law) if law.is_asymmetric() => format!("{y} {}", law.text()),
        ErrorBound::Law(law) => format!("|{e}| <= {}", law.text()),
        ErrorBound::Interval { lower, upper } => {
            format!("between {} and {}", column(lower, "-inf"), column(upper, "inf"))
        }
    };
    let selection = measurements.selection();
    let rows = if selection.is_all() { String::new() } else { format!(", {selection}") };
    let line = match measurements.model() {
        Model::Line { x } => {
            let form = measurements.line_form();
            let name = form.abscissa(x);
            let shown = if form.x_origin.is_zero() { name } else { format!("({})", name.raw()).into() };
            format!("theta1*{shown}{}", if form.through_origin { "" } else { " + theta2" })
        }
        Model::TwoRegressors { regressors: [first, second] } => format!("theta1*{first} + theta2*{second}"),
    };
    let is_reduction = problem.measurements.is_of_reductions();
    let which = if is_reduction { "the rows that a reduction keeps" } else { "every row of them" };
    let mut comments = vec![
        format!("model: {y} = {line} + {e}, {bound}"),
        format!("data: {}{rows}, {which}", arguments.data.file_name()),
        format!("reading: {}; no number is rounded", reading.name()),
    ];
    comments.extend(measurements.multiple_of_least().map(|MultipleOfLeast { factor, least }| {
        format!("assumed: the error bound is {factor} times {least}, the least one of these very readings that leaves anything")
    }));
    let conditions = (1..).zip(&problem.conditions);
    comments.extend(conditions.map(|(number, condition)| format!("where_{number}: {}", condition.text())));
    comments
}
