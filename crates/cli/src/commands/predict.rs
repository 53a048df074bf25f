//! `boundfit predict`.

use std::io::{self, Write};

use boundfit_ask::{Ask, Predict};
use boundfit_exact::DecimalMark;
use boundfit_formats::TableNotes;
use clap::{ArgGroup, Args};

use super::asked::Job;
use crate::exit::{CommandResult, Failure};
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Notes, OutputArguments, ProofArguments, TableFormat, ThreadArguments,
};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "Where the line runs at two x, and where a further reading lies there",
            "boundfit predict transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --at 3.7,9/2",
        ),
        (
            "The x that a reading may come from, with the rows that prove it",
            "boundfit predict transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --from 0.012 --proofs",
        ),
        (
            "The corridor at 101 values of x, as a table",
            "boundfit predict transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --grid 0..10/100 \\\n\
             \x20 -o corridor.csv",
        ),
        (
            "At all values of a column of another file",
            "boundfit predict readings.csv --x x --y y --eps 0.1 --at new.csv:x --format csv",
        ),
    ],
    statuses: &[
        (0, "an answer was found"),
        BAD_DATA,
        BAD_USAGE,
        (3, "the feasible parameter set is empty, and predicts nothing; the proof is printed"),
    ],
};

/// Predict the line at an x, a further reading there, and the x that a reading may come from
///
/// At x the lines that agree with all readings take the values of an interval, which is exact and has a proof. A
/// further reading lies in it, widened by the reading's own error bound: that of the fitted readings if it applies to
/// other readings, or --new-eps. Conversely a reading may come from each x where the widened interval contains it: one
/// interval or two, some unbounded.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(),
          group(ArgGroup::new("asked").required(true).multiple(true).args(["at", "from", "grid"])))]
pub(crate) struct PredictArguments {
    #[command(flatten)]
    data: DataArguments,
    /// The x to ask about: numbers exactly as written, 3.7,9/2, or a column of a table, FILE:COL. With two regressors
    /// pairs, '1;2,3;4' or FILE:COL;COL2. Repeatable
    #[arg(long, value_name = "X,...|FILE:COL", allow_hyphen_values = true)]
    at: Vec<String>,
    /// Readings whose x is wanted: numbers, or a column, FILE:COL. Repeatable
    #[arg(long, value_name = "Y,...|FILE:COL", allow_hyphen_values = true)]
    from: Vec<String>,
    /// Ask at N + 1 values of x in equal steps, ends included
    #[arg(long, value_name = "FROM..TO/N", allow_hyphen_values = true)]
    grid: Option<String>,
    /// Error bound of a further reading, if it differs from that of the fitted ones: a number, or a law as in --eps
    #[arg(long, value_name = "NUM", allow_hyphen_values = true)]
    new_eps: Option<String>,
    /// Show in text the readings that prove each end (JSON always does)
    #[arg(long)]
    proofs: bool,
    #[command(flatten)]
    proof: ProofArguments,
    #[command(flatten)]
    threads: ThreadArguments,
    #[command(flatten)]
    output: OutputArguments<TableFormat>,
}

impl PredictArguments {
    /// The question.
    fn question(&self) -> Predict {
        Predict {
            at: self.at.clone(),
            from: self.from.clone(),
            grid: self.grid.clone(),
            new_eps: self.new_eps.clone(),
            proofs: self.proofs,
        }
    }
}

/// Reads the data, fits, and writes what is predicted.
pub(super) fn run(arguments: &PredictArguments) -> CommandResult {
    arguments.threads.set()?;
    let question = arguments.question();
    let files = files(&question);
    check_usage(arguments, arguments.output.format()?, &question, &files)?;
    let job = Job::proving(arguments.data.words(), &arguments.output, &arguments.proof)?;
    let mut guard = job.guard(&arguments.output.file.replace, &files)?;
    job.run_with(&question, &mut guard, |asked, _, _| {
        say_commas(&question, question.table(asked));
        Ok(None)
    })
}

/// Says on standard error that commas separate values, where the data have commas before decimals and the values may be meant so.
fn say_commas(question: &Predict, table: Option<&TableNotes>) {
    let has_comma = table.is_some_and(|table| table.dialect.notation.decimal == DecimalMark::Comma);
    for (option, texts) in [("--at", &question.at), ("--from", &question.from)] {
        let text = texts.iter().find(|text| has_comma && has_comma_of_digits(text));
        if let Some(text) = text {
            let _ = writeln!(
                io::stderr(),
                "note: '{option} {text}' has several values: a comma separates them, and a point comes before decimals, whatever \
                 the data have: 1.5"
            );
        }
    }
}

/// Returns whether a comma stands between two digits.
fn has_comma_of_digits(text: &str) -> bool {
    let bytes = text.as_bytes();
    bytes.windows(3).any(|around| matches!(around, [before, b',', behind] if before.is_ascii_digit() && behind.is_ascii_digit()))
}

/// The files whose columns are values: no number has a colon.
fn files(question: &Predict) -> Vec<&str> {
    let texts = question.at.iter().chain(&question.from);
    texts.filter_map(|text| Some(text.rsplit_once(':')?.0)).collect()
}

/// Refuses what cannot be written or read together.
fn check_usage(
    arguments: &PredictArguments,
    format: TableFormat,
    question: &Predict,
    files: &[&str],
) -> Result<(), Failure> {
    let refuse = |problem: &str| Err(Failure::Usage(problem.to_owned()));
    let is_at = !question.at.is_empty() || question.grid.is_some();
    if format == TableFormat::Csv && is_at && !question.from.is_empty() {
        return refuse(
            "'--format csv' writes one table: ask '--at' or '--grid', and '--from', in runs of their own",
        );
    }
    let inputs = files.iter().copied().chain([arguments.data.path()]).filter(|file| *file == "-").count();
    if inputs > 1 {
        return refuse("standard input is read once: give one of the tables a file");
    }
    Ok(())
}
