//! `boundfit reduce`.

use boundfit_estimation::{ReducedColumns, ReducedTable};
use boundfit_formats::{ScanOptions, Source};

use crate::CommandResult;
use crate::arguments::{ReduceArguments, told_by_name};
use crate::exit::{Exit, Failure};
use crate::output;

/// Reads the data and writes those rows that decide every fit.
pub(crate) fn run(arguments: &ReduceArguments) -> CommandResult {
    arguments.threads.set()?;
    let output = arguments.file.output.as_deref();
    let guard = arguments.file.replace.guard([arguments.data.as_str()]);
    guard.check(output)?;
    told_by_name(output, &[("csv", ()), ("tsv", ()), ("txt", ())], None)?;
    let columns = ReducedColumns {
        x: arguments.x.clone(),
        y: arguments.y.clone(),
        epsilon: arguments.eps_column.clone(),
    };
    let source = Source::open(&arguments.data).map_err(Failure::data)?;
    let options = arguments.table.scan_options(&source, Some(&arguments.rows))?;
    let options = ScanOptions { list_rows: false, ..options };
    let reduced = ReducedTable::scan(source, &columns, &options).map_err(Failure::data)?;
    let mut text = Vec::new();
    // Writing to memory cannot fail.
    reduced.write(&mut text).map_err(Failure::data)?;
    output::write(&text, output, &guard)?;
    Ok(Exit::Answer)
}
