//! `boundfit bench-solvers`.

use std::fs;
use std::path::Path;
use std::time::Duration;

use boundfit_check::{Check, CheckOptions, check, source_names};
use boundfit_estimation::{Columns, EpsilonColumn, LineForm, Measurements, Problem};
use boundfit_exact::{Rational, Reading};
use boundfit_formats::{ColumnSelector, Source, TableOptions};
use boundfit_report::{conformance_json, conformance_table};

use crate::CommandResult;
use crate::arguments::{BenchSolversArguments, Format, ending, number_problem};
use crate::exit::{Exit, Failure};
use crate::output;
use crate::progress::while_working;

/// Runs every solver on every case of a folder and prints the worst verdict of each.
pub(crate) fn run(arguments: &BenchSolversArguments) -> CommandResult {
    let folder = &arguments.folder;
    let format = match (arguments.format, arguments.file.output.as_deref().and_then(ending).as_deref()) {
        // The text is Markdown.
        (None, Some("md" | "markdown")) => Format::Text,
        (asked, _) => arguments.file.format(asked)?,
    };
    let entries = fs::read_dir(folder)
        .map_err(|error| Failure::data(format_args!("{folder}: cannot read: {error}")))?;
    let mut names: Vec<String> = entries
        .filter_map(|entry| {
            entry.ok()?.file_name().into_string().ok()?.strip_suffix(".csv").map(ToOwned::to_owned)
        })
        .collect();
    names.sort();
    if names.is_empty() {
        return Err(Failure::data(format_args!("{folder}: there is no case NAME.csv with NAME.json")));
    }
    let path = |name: &String, ending: &str| {
        Path::new(folder).join(format!("{name}.{ending}")).to_string_lossy().into_owned()
    };
    let inputs: Vec<String> =
        names.iter().flat_map(|name| ["csv", "json"].map(|ending| path(name, ending))).collect();
    let guard = arguments.file.replace.guard(inputs.iter().map(String::as_str));
    let output = arguments.file.output.as_deref();
    guard.check(output)?;
    let limits = &arguments.limits;
    let table = TableOptions { limits: limits.number(), sizes: limits.sizes(), ..TableOptions::default() };
    let cases = while_working("solving", || {
        let judged =
            |name: String| judged_case(Path::new(folder), &name, &table).map(|judged| (name, judged));
        names.into_iter().map(judged).collect::<Result<Vec<_>, Failure>>()
    })?;
    let report = match format {
        Format::Text => conformance_table(&cases),
        Format::Json => conformance_json(&cases),
    };
    output::write(&report, output, &guard)?;
    Ok(Exit::Answer)
}

/// What an error bound may look like.
const EXPECTED: &str = "expected a text such as \"0.5e-3\" or \"1/2000\"";

/// A case: `NAME.csv` with columns x and y, and `"eps"` in `NAME.json`.
fn judged_case(folder: &Path, name: &str, table: &TableOptions) -> Result<Check, Failure> {
    let json = folder.join(format!("{name}.json"));
    let fail = |problem: String| Failure::data(format_args!("{}: {problem}", json.display()));
    let text = fs::read_to_string(&json).map_err(|error| fail(format!("cannot read: {error}")))?;
    let case: serde_json::Value = serde_json::from_str(&text).map_err(|error| fail(error.to_string()))?;
    let epsilon = case.get("eps").and_then(serde_json::Value::as_str);
    let epsilon = epsilon.ok_or_else(|| fail("there is no text \"eps\"".to_owned()))?;
    let epsilon = Reading::Decimal.read(epsilon, &table.limits);
    let epsilon = epsilon.map_err(|error| fail(format!("\"eps\": {}", number_problem(&error, EXPECTED))))?;
    let columns = Columns {
        first: ColumnSelector::name_or_number("x"),
        second: None,
        response: Some(ColumnSelector::name_or_number("y")),
        epsilon: EpsilonColumn::Uniform(epsilon),
        form: LineForm::default(),
    };
    let csv = folder.join(format!("{name}.csv"));
    let source = Source::open(&csv.to_string_lossy()).map_err(Failure::data)?;
    let measurements = Measurements::read(source, &columns, table).map_err(Failure::data)?;
    let problem = Problem { measurements, conditions: Vec::new() };
    let options = CheckOptions {
        solvers: source_names(),
        answers: Vec::new(),
        tolerance: Rational::ratio(1, 1_000_000),
        as_printed: true,
        time_limit: Duration::from_secs(60),
        directions: None,
    };
    check(&problem, Reading::Decimal, &options).map_err(Failure::data)
}
