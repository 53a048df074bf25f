//! `boundfit outliers`.

use super::asked::Job;
use crate::CommandResult;
use crate::arguments::OutliersArguments;

/// Reads the data, finds the outliers and writes the report.
pub(crate) fn run(arguments: &OutliersArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job {
        data: &arguments.data,
        form: arguments.output.format()?.into(),
        style: arguments.data.table.limits.limited(arguments.output.style()),
        output: arguments.output.file.output.as_deref(),
        proof: arguments.proof.as_deref(),
    };
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question(), &mut guard)
}
