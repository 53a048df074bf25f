//! `boundfit range`.

use super::asked::Job;
use crate::CommandResult;
use crate::arguments::RangeArguments;

/// Reads the data, finds the runs and writes.
pub(crate) fn run(arguments: &RangeArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job::of(arguments.data.words(), &arguments.output, arguments.proof.as_deref())?
        .with_theory(arguments.proof_library)?;
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question(), &mut guard)
}
