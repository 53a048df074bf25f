//! `boundfit range`.

use boundfit_estimation::fit;
use boundfit_questions::LinearRange;
use boundfit_report::{RangeReport, range_csv, range_document, range_json};

use crate::CommandResult;
use crate::arguments::{RangeArguments, RangeFormat};
use crate::exit::{Exit, Failure};
use crate::output;
use crate::progress::while_working;
use crate::work::{refuse_long_problem, times};

/// Reads the data, finds the runs and writes.
pub(crate) fn run(arguments: &RangeArguments) -> CommandResult {
    arguments.threads.set()?;
    let format = arguments.output.format()?;
    arguments.check_order()?;
    let output = arguments.output.file.output.as_deref();
    let guard = arguments.output.file.replace.guard([arguments.data.path()]);
    guard.check(output)?;
    let data = arguments.data.open();
    let origin = data.origin();
    let problem = data.every_reading(format == RangeFormat::Json)?;
    if problem.measurements.is_of_reductions() {
        let file = arguments.data.file_name();
        return Err(Failure::Usage(format!(
            "'range' is about every reading, and {file} is a reduction: ask about the table that it was made from"
        )));
    }
    refuse_long_problem(arguments.data.file_name(), &problem, times::RANGE, &arguments.data.table.limits)?;
    let order = arguments.order(problem.measurements.model());
    let range = while_working("finding runs", || LinearRange::of(&problem, order));
    let all = while_working("fitting", || fit(&problem));
    let longest = range.longest().map(|run| {
        let own = range.problem_of(run, &problem, false);
        let fit = fit(&own);
        (own, fit)
    });
    let style = arguments.output.style();
    let report = RangeReport { problem: &problem, fit: &all, order, range: &range, longest };
    let text = match format {
        RangeFormat::Text => range_document(&report, &origin, &style).to_text(),
        RangeFormat::Json => range_json(&report, &origin, &style),
        RangeFormat::Csv => range_csv(&report),
    };
    output::write(text, output, &guard)?;
    Ok(if range.runs.is_empty() { Exit::Empty } else { Exit::Answer })
}
