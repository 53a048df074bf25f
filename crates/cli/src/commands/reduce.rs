//! `boundfit reduce`.

use boundfit_estimation::ReducedTable;
use boundfit_exact::{Foreign, Reading};
use boundfit_formats::{ScanOptions, Source};

use crate::CommandResult;
use crate::arguments::{ReduceArguments, told_by_name};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::output;

/// Reads the data and writes those rows that decide every fit.
pub(crate) fn run(arguments: &ReduceArguments) -> CommandResult {
    arguments.threads.set()?;
    let output = arguments.file.output.as_deref();
    let guard = arguments.file.replace.guard([arguments.data.as_str()]);
    guard.check(output)?;
    told_by_name(output, &[("csv", ()), ("tsv", ()), ("txt", ())], None)?;
    let source = input::open(&arguments.data).map_err(Failure::refused);
    let is_stored = source.as_ref().is_ok_and(Source::is_stored);
    let reading = if is_stored { Reading::Binary64 } else { arguments.table.reading() };
    let columns = arguments.columns(reading)?;
    let source = source?;
    let options = arguments.table.scan_options(&source, Some(&arguments.rows))?;
    let options = ScanOptions { list_rows: false, ..options };
    let reduced = ReducedTable::scan(source, &columns, &options).map_err(Failure::refused)?;
    input::say_table(Foreign::of(input::named(&arguments.data)), reduced.table());
    let mut text = Vec::new();
    // Writing to memory cannot fail.
    reduced.write(&mut text).map_err(Failure::data)?;
    output::write(&text, output, &guard)?;
    Ok(Exit::Answer)
}
