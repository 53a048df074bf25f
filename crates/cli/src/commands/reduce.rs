//! `boundfit reduce`.

use boundfit_estimation::{Question, ReducedTable};
use boundfit_formats::ScanOptions;

use crate::CommandResult;
use crate::arguments::{ReduceArguments, told_by_name};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::output;

/// The refusal of readings of two regressors.
const NO_BOUNDS: &str = "which readings of two regressors decide depends on their bounds: say them with '--eps', as a number or a \
                         law, '--eps-column' or '--lower' and '--upper'";

/// Reads the data and writes those rows that decide every fit.
pub(crate) fn run(arguments: &ReduceArguments) -> CommandResult {
    arguments.threads.set()?;
    let output = arguments.file.output.as_deref();
    let guard = arguments.file.replace.guard([arguments.data.as_str()]);
    guard.check(output)?;
    told_by_name(output, &[("csv", ()), ("tsv", ()), ("txt", ())], None)?;
    let words = arguments.words();
    let has_bounds = words.readings.has_bounds();
    let (asked, source) = words.open_for(has_bounds)?.scan();
    let Question { columns, multiple_of_least, .. } = &asked.question;
    if columns.second.is_some() && (!has_bounds || multiple_of_least.is_some()) {
        return Err(Failure::Usage(NO_BOUNDS.to_owned()));
    }
    let options = ScanOptions { list_rows: false, ..asked.options.clone() };
    let reduced = ReducedTable::scan(source, columns, &options).map_err(Failure::refused)?;
    input::say_table(words.file_name(), reduced.table());
    let mut text = Vec::new();
    // Writing to memory cannot fail.
    reduced.write(&mut text).map_err(Failure::data)?;
    output::write(&text, output, &guard)?;
    Ok(Exit::Answer)
}
