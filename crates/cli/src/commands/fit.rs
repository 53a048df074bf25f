//! `boundfit fit`.

use std::time::Duration;

use boundfit_check::{CheckOptions, check, source_names};
use boundfit_estimation::{Problem, fit};
use boundfit_exact::{Rational, Reading};
use boundfit_report::{fit_json, fit_text, verdict_line};

use crate::CommandResult;
use crate::arguments::{FitArguments, Format};
use crate::exit::{Exit, Failure};
use crate::output;

/// Above this many rows a fit does not wait for an LP solver.
const MOST_ROWS_FOR_LP: usize = 100_000;

/// Reads the data, fits and writes the report.
pub(crate) fn run(arguments: &FitArguments) -> CommandResult {
    let reading = arguments.data.table.reading();
    let problem = arguments.data.problem(reading)?;
    let fit = fit(&problem);
    let style = arguments.output.style();
    let report = match arguments.output.format {
        Format::Json => fit_json(&problem, &fit, reading, &style),
        Format::Text => {
            let (file, rows) = (arguments.data.file_name(), arguments.data.rows_asked());
            let report = fit_text(&problem, &fit, file, rows, reading, &style);
            if arguments.no_lp { report } else { report + &lp_line(&problem, reading)? }
        }
    };
    output::write(&report, arguments.output.file.output.as_deref())?;
    Ok(if fit.fps.polyhedron().region().is_empty() { Exit::Empty } else { Exit::Answer })
}

/// What the default solver makes of the same data.
fn lp_line(problem: &Problem, reading: Reading) -> Result<String, Failure> {
    if problem.measurements.rows().len() > MOST_ROWS_FOR_LP {
        return Ok(format!("LP solver      not asked above {MOST_ROWS_FOR_LP} rows (see boundfit check)\n"));
    }
    let options = CheckOptions {
        solvers: source_names().into_iter().take(1).collect(),
        answers: Vec::new(),
        tolerance: Rational::ratio(1, 1_000_000),
        time_limit: Duration::from_secs(10),
        directions: None,
    };
    let check = check(problem, reading, &options).map_err(Failure::data)?;
    Ok(verdict_line(&check, reading).unwrap_or_default())
}
