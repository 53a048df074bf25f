//! `boundfit fit`.

use std::time::Duration;

use boundfit_check::{CheckOptions, check, source_names};
use boundfit_estimation::{Family, Keep, Problem, fit};
use boundfit_exact::{Rational, Reading};
use boundfit_report::{fit_json, fit_text, sweep_text, verdict_line};

use crate::CommandResult;
use crate::arguments::{FactorRange, FitArguments, FitFormat};
use crate::commands::fleet;
use crate::exit::{Exit, Failure};
use crate::output;
use crate::progress::while_working;

/// Reads the data, fits and writes the report.
pub(crate) fn run(arguments: &FitArguments) -> CommandResult {
    arguments.threads.set()?;
    if let Some(by) = &arguments.by {
        return fleet::run(arguments, by);
    }
    if arguments.output.format == FitFormat::Csv {
        return Err(Failure::Usage("'--format csv' needs '--by <COL>': it has one row per group".to_owned()));
    }
    let reading = arguments.data.table.reading();
    let is_hash_shown = arguments.output.format == FitFormat::Json;
    let problem = arguments.data.scanned_problem(!arguments.no_eui, is_hash_shown)?;
    let fit = while_working("fitting", || fit(&problem));
    let family = arguments.sweep.as_ref().map(|FactorRange { from, to }| {
        while_working("sweeping", || Family::new(&problem, from.clone(), to.clone()))
    });
    let style = arguments.output.style();
    let report = match arguments.output.format {
        FitFormat::Json => fit_json(&problem, &fit, family.as_ref(), reading, &style),
        FitFormat::Text | FitFormat::Csv => {
            let (file, rows) = (arguments.data.file_name(), arguments.data.rows_asked());
            let report = fit_text(&problem, &fit, file, rows, reading, &style);
            let lp_line = if arguments.no_lp { String::new() } else { lp_line(&problem, reading)? };
            let sweep = family.map(|family| format!("\n{}", sweep_text(&problem, &family, &style)));
            report + &lp_line + &sweep.unwrap_or_default()
        }
    };
    output::write(&report, arguments.output.file.output.as_deref())?;
    Ok(if fit.fps.polyhedron().region().is_empty() { Exit::Empty } else { Exit::Answer })
}

/// What the default solver makes of the same data.
fn lp_line(problem: &Problem, reading: Reading) -> Result<String, Failure> {
    if problem.measurements.fitted() > Keep::MOST_ROWS {
        return Ok(format!("LP solver      not asked above {} rows (see boundfit check)\n", Keep::MOST_ROWS));
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
