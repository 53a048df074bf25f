//! `boundfit status`.

use super::asked::Job;
use crate::CommandResult;
use crate::arguments::{StatusArguments, TableFormat};
use crate::exit::Failure;

/// Finds the set, judges every reading by it and writes.
pub(crate) fn run(arguments: &StatusArguments) -> CommandResult {
    arguments.threads.set()?;
    check_usage(arguments, arguments.output.format()?)?;
    let job = Job::of(arguments.data.words(), &arguments.output, arguments.proof.as_deref())?
        .with_theory(arguments.proof_library)?;
    let beside: Vec<&str> = arguments.new.as_deref().into_iter().collect();
    let mut guard = job.guard(&arguments.output.file.replace, &beside)?;
    job.run(&arguments.question(), &mut guard)
}

/// Refuses what only some formats have, and files that are named twice.
fn check_usage(arguments: &StatusArguments, format: TableFormat) -> Result<(), Failure> {
    let refuse = |problem: &str| Err(Failure::Usage(problem.to_owned()));
    if arguments.repair && format == TableFormat::Csv {
        return refuse(
            "'--repair' is no part of csv: a table has a row for each reading, and no room for it",
        );
    }
    if arguments.all && matches!(format, TableFormat::Json | TableFormat::Csv) {
        return refuse("'--all' is about text, latex and markdown; other formats list every reading anyway");
    }
    if arguments.new.as_deref() == Some("-") && arguments.data.path() == "-" {
        return refuse("DATA and '--new' would both be read from standard input: give one of them a file");
    }
    Ok(())
}
