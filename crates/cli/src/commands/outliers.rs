//! `boundfit outliers`.

use super::asked::Job;
use crate::CommandResult;
use crate::arguments::OutliersArguments;

/// Reads the data, finds the outliers and writes the report.
pub(crate) fn run(arguments: &OutliersArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job::of(arguments.data.words(), &arguments.output, arguments.proof.as_deref())?
        .with_theory(arguments.proof_library)?;
    let job = Job { style: arguments.data.table.limits.limited(job.style), ..job };
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question(), &mut guard)
}
