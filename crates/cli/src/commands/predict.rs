//! `boundfit predict`.

use boundfit_ask::Predict;

use super::asked::Job;
use crate::CommandResult;
use crate::arguments::{PredictArguments, TableFormat};
use crate::exit::Failure;

/// Reads the data, fits, and writes what is predicted.
pub(crate) fn run(arguments: &PredictArguments) -> CommandResult {
    arguments.threads.set()?;
    let question = arguments.question();
    let files = files(&question);
    check_usage(arguments, arguments.output.format()?, &question, &files)?;
    let job = Job::of(arguments.data.words(), &arguments.output, arguments.proof.as_deref())?
        .with_theory(arguments.proof_library)?;
    let mut guard = job.guard(&arguments.output.file.replace, &files)?;
    job.run(&question, &mut guard)
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
    if question.proofs && matches!(format, TableFormat::Csv | TableFormat::Json) {
        return refuse(
            "'--proofs' is about text, latex and markdown; JSON has them anyway, and CSV has no room",
        );
    }
    let inputs = files.iter().copied().chain([arguments.data.path()]).filter(|file| *file == "-").count();
    if inputs > 1 {
        return refuse("standard input is read once: give one of the tables a file");
    }
    Ok(())
}
