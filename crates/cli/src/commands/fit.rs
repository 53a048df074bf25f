//! `boundfit fit`.

use boundfit_estimation::{Columns, Condition, EpsilonColumn, Measurements, Problem, fit};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{Source, TableOptions};
use boundfit_report::{fit_json, fit_text};

use crate::CommandResult;
use crate::arguments::{FitArguments, Format};
use crate::exit::{Exit, Failure};
use crate::output;

/// Reads the data, fits and writes the report.
pub(crate) fn run(arguments: &FitArguments) -> CommandResult {
    let reading = arguments.table.reading();
    let problem = problem(arguments, reading)?;
    let fit = fit(&problem);
    let style = arguments.output.style();
    let report = match arguments.output.format {
        Format::Json => fit_json(&problem, &fit, reading, &style),
        Format::Text => {
            let rows = arguments.rows.as_ref().map(|rows| rows.text.as_str());
            let file = if arguments.data == "-" { "standard input" } else { &arguments.data };
            fit_text(&problem, &fit, file, rows, reading, &style)
        }
    };
    output::write(&report, arguments.output.output.as_deref())?;
    Ok(if fit.fps.polyhedron().region().is_empty() { Exit::Empty } else { Exit::Answer })
}

fn problem(arguments: &FitArguments, reading: Reading) -> Result<Problem, Failure> {
    let limits = Limits::default();
    let epsilon = match (&arguments.epsilon.eps, &arguments.epsilon.eps_column) {
        (Some(eps), _) => EpsilonColumn::Uniform(error_bound(eps, reading, &limits)?),
        (None, Some(column)) => EpsilonColumn::Column(column.clone()),
        (None, None) => return Err(Failure::Usage("'--eps' or '--eps-column' is missing".to_owned())),
    };
    let condition = |text: &String| {
        Condition::parse(text, reading, &limits)
            .map_err(|error| Failure::value("--where <CONDITION>", text, error))
    };
    let conditions = arguments.conditions.iter().map(condition).collect::<Result<_, _>>()?;
    let columns = Columns {
        first: arguments.x.first.clone(),
        second: arguments.x.second.clone(),
        response: arguments.y.clone(),
        epsilon,
    };
    let options = TableOptions {
        header: arguments.table.header(),
        delimiter: arguments.table.delimiter(),
        rows: arguments.rows.as_ref().map(|rows| rows.range),
        reading,
        limits,
    };
    let source = Source::open(&arguments.data).map_err(Failure::data)?;
    let measurements = Measurements::read(source, &columns, &options).map_err(Failure::data)?;
    Ok(Problem { measurements, conditions })
}

fn error_bound(text: &str, reading: Reading, limits: &Limits) -> Result<Rational, Failure> {
    let expected = "expected a number that is at least 0, such as 0.5e-3 or 1/2000";
    let refuse =
        |problem: String| Failure::value("--eps <NUM>", text, format_args!("{problem} ({expected})"));
    let value = reading.read(text, limits).map_err(|error| refuse(format!("not a number: {error}")))?;
    if value.is_negative() { Err(refuse("negative".to_owned())) } else { Ok(value) }
}
