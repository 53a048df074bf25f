//! `boundfit range`.

use boundfit_estimation::fit;
use boundfit_exact::{Foreign, Reading};
use boundfit_questions::LinearRange;
use boundfit_report::{RangeReport, range_csv, range_document, range_json, range_proof};

use super::{proof_file, refuse_reductions};
use crate::CommandResult;
use crate::arguments::{RangeArguments, RangeFormat};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::memory;
use crate::progress::while_working;
use crate::work::{refuse_long_problem, times};

/// Reads the data, finds the runs and writes.
pub(crate) fn run(arguments: &RangeArguments) -> CommandResult {
    arguments.threads.set()?;
    let format = arguments.output.format()?;
    arguments.check_order()?;
    let output = arguments.output.file.output.as_deref();
    let mut guard = arguments.output.file.replace.guard([arguments.data.path()]);
    guard.check(output)?;
    guard.check(arguments.proof.as_deref())?;
    proof_file::check(arguments.proof.as_deref(), output)?;
    let data = arguments.data.open().holding(memory::OF_A_RANGE);
    let origin = data.origin();
    let shows_data = format == RangeFormat::Json || arguments.proof.is_some();
    let problem = data.every_reading(shows_data, shows_data)?;
    refuse_reductions(&problem, arguments.data.file_name(), "'range' is")?;
    refuse_long_problem(arguments.data.file_name(), &problem, times::RANGE, &arguments.data.table.limits)?;
    if format == RangeFormat::Csv {
        input::say_table(arguments.data.file_name(), problem.measurements.table());
    }
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
    let proof = match &arguments.proof {
        Some(file) => Some((proof(&report, origin.reading, arguments.data.file_name())?, file.as_str())),
        None => None,
    };
    proof_file::write(text.as_bytes(), output, proof, &mut guard)?;
    Ok(if range.runs.is_empty() { Exit::Empty } else { Exit::Answer })
}

/// Runs that a proof may be about, each of which it fits.
const MOST_PROVED: usize = 1_000;

fn proof(report: &RangeReport, reading: Reading, file: Foreign<&str>) -> Result<String, Failure> {
    if report.range.runs.len() > MOST_PROVED {
        return Err(Failure::Usage(format!("'--proof' is about at most {MOST_PROVED} runs")));
    }
    range_proof(report, reading).ok_or_else(|| proof_file::no_text(file))
}
