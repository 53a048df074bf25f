//! `boundfit check`.

use std::fs;
use std::io::Read;
use std::time::Duration;

use boundfit_check::{Answer, CheckOptions, check, parse_claim_file, parse_claim_pui, source_names};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_lp::Verdict;
use boundfit_report::{check_json, check_text};

use crate::CommandResult;
use crate::arguments::{CheckArguments, Format};
use crate::exit::{Exit, Failure};
use crate::output;
use crate::progress::while_working;

/// The largest claims file that is read, in bytes.
const LARGEST_CLAIM: u64 = 1 << 28;

/// Reads the data and the claims, runs the solvers, judges and writes the report.
pub(crate) fn run(arguments: &CheckArguments) -> CommandResult {
    let reading = arguments.data.table.reading();
    let options = options(arguments)?;
    let problem = arguments.data.problem()?;
    let check = while_working("solving", || check(&problem, reading, &options));
    let check = check.map_err(|error| Failure::Usage(error.to_string()))?;
    let style = arguments.output.style();
    let report = match arguments.output.format {
        Format::Json => check_json(&check, reading, &style),
        Format::Text => check_text(&check, arguments.data.file_name(), reading, &style),
    };
    output::write(&report, arguments.output.file.output.as_deref())?;
    Ok(if check.worst(reading).is_some_and(Verdict::is_refutation) { Exit::Refuted } else { Exit::Answer })
}

fn options(arguments: &CheckArguments) -> Result<CheckOptions, Failure> {
    let mut answers = Vec::new();
    for file in &arguments.claims {
        answers.push(read_claim(file)?);
    }
    for text in &arguments.claimed_pui {
        let answer = parse_claim_pui(text);
        answers.push(answer.map_err(|error| Failure::value("--claim-pui <LO1,HI1,LO2,HI2>", text, error))?);
    }
    let tolerance = &arguments.tolerance;
    let tolerance = Reading::Decimal.read(tolerance, &Limits::default()).map_err(|error| {
        Failure::value("--tolerance <NUM>", tolerance, format_args!("not a number: {error}"))
    })?;
    if tolerance < Rational::zero() {
        return Err(Failure::value("--tolerance <NUM>", &arguments.tolerance, "negative"));
    }
    // Without a word about whom to judge, everybody is.
    let solvers = if arguments.solvers.is_empty() && answers.is_empty() && arguments.directions.is_none() {
        source_names()
    } else {
        arguments.solvers.clone()
    };
    Ok(CheckOptions {
        solvers,
        answers,
        tolerance,
        time_limit: Duration::from_secs(arguments.time_limit),
        directions: arguments.directions.map(usize::from),
    })
}

fn read_claim(file: &str) -> Result<Answer, Failure> {
    let mut text = String::new();
    let opened =
        fs::File::open(file).map_err(|error| Failure::data(format_args!("{file}: cannot read: {error}")))?;
    let read = opened.take(LARGEST_CLAIM + 1).read_to_string(&mut text);
    read.map_err(|error| Failure::data(format_args!("{file}: cannot read: {error}")))?;
    if text.len() as u64 > LARGEST_CLAIM {
        return Err(Failure::data(format_args!("{file}: larger than {LARGEST_CLAIM} bytes (the limit)")));
    }
    parse_claim_file(&text, file).map_err(|error| Failure::data(format_args!("{file}: {error}")))
}
