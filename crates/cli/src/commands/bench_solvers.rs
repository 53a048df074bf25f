//! `boundfit bench-solvers`.

use std::fs;
use std::path::Path;
use std::time::Duration;

use boundfit_check::{Check, CheckOptions, check, source_names};
use boundfit_estimation::{Columns, EpsilonColumn, LineForm, Measurements, Problem};
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_formats::{ColumnSelector, TableOptions, WholeFile};
use boundfit_judge::{Answer, JudgedSolver, Plane, SolveError, Tolerances, judge_solvers};
use boundfit_report::{CaseVerdicts, cases_json, cases_table};

use super::judge::model_of;
use crate::CommandResult;
use crate::arguments::{BenchSolversArguments, Format, LimitArguments, ending, number_problem};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::output;
use crate::progress::while_working;
use crate::work::{refuse_long, refuse_long_problem, times};

/// Runs every solver on every case of a folder and prints the worst verdict of each.
pub(crate) fn run(arguments: &BenchSolversArguments) -> CommandResult {
    let folder = arguments.folder.as_str();
    let named = Foreign::of(folder);
    let format = match (arguments.format, arguments.file.output.as_deref().and_then(ending).as_deref()) {
        // The text is Markdown.
        (None, Some("md" | "markdown")) => Format::Text,
        (asked, _) => arguments.file.format(asked)?,
    };
    let entries =
        fs::read_dir(folder).map_err(|error| Failure::data(format_args!("{named}: cannot read: {error}")))?;
    let mut cases: Vec<(String, Kind)> = entries
        .filter_map(|entry| {
            let file = entry.ok()?.file_name().into_string().ok()?;
            let of_kind = |kind: Kind| Some((file.strip_suffix(kind.ending())?.to_owned(), kind));
            of_kind(Kind::Fit).or_else(|| of_kind(Kind::Model))
        })
        .collect();
    cases.sort();
    if cases.is_empty() {
        let wanted = "there is no case NAME.csv or NAME.mps with NAME.json";
        return Err(Failure::data(format_args!("{named}: {wanted}")));
    }
    let path = |name: &String, ending: &str| {
        Path::new(folder).join(format!("{name}{ending}")).to_string_lossy().into_owned()
    };
    let inputs: Vec<String> = cases
        .iter()
        .flat_map(|(name, kind)| [kind.ending(), ".json"].map(|ending| path(name, ending)))
        .collect();
    let guard = arguments.file.replace.guard(inputs.iter().map(String::as_str));
    let output = arguments.file.output.as_deref();
    guard.check(output)?;
    let limits = &arguments.limits;
    let table = TableOptions { limits: limits.number(), sizes: limits.sizes(), ..TableOptions::default() };
    let cases = while_working("solving", || {
        let judged = |(name, kind): (String, Kind)| match kind {
            Kind::Fit => {
                let check = judged_fit(Path::new(folder), &name, &table, limits)?;
                Ok(CaseVerdicts::of_fit(name.into(), &check))
            }
            Kind::Model => {
                let solvers = judged_model(Path::new(folder), &name, limits)?;
                Ok(CaseVerdicts::of_model(name.into(), &solvers))
            }
        };
        cases.into_iter().map(judged).collect::<Result<Vec<_>, Failure>>()
    })?;
    let report = match format {
        Format::Text => cases_table(&cases),
        Format::Json => cases_json(&cases),
    };
    output::write(&report, output, &guard)?;
    Ok(Exit::Answer)
}

/// What a case is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// A line fit, whose four programs are solved.
    Fit,
    /// A linear program in a file.
    Model,
}

impl Kind {
    /// How the name of its file ends.
    fn ending(self) -> &'static str {
        match self {
            Kind::Fit => ".csv",
            Kind::Model => ".mps",
        }
    }
}

/// How long a solver may work on one program.
const TIME_LIMIT: Duration = Duration::from_secs(60);

/// A path in messages.
fn shown(path: &Path) -> Foreign {
    Foreign::from(path.to_string_lossy().into_owned())
}

/// A value that is JSON.
fn json_of(path: &Path) -> Result<serde_json::Value, Failure> {
    let fail = |problem: String| Failure::data(format_args!("{}: {problem}", shown(path)));
    let text = fs::read_to_string(path).map_err(|error| fail(format!("cannot read: {error}")))?;
    serde_json::from_str(&text).map_err(|error| fail(Foreign::from(error.to_string()).to_string()))
}

/// A case: a linear program in `NAME.mps`, with its `"status"` and, if it is optimal, its `"objective"` in `NAME.json`. What is
/// expected has to be the exact answer.
fn judged_model(folder: &Path, name: &str, limits: &LimitArguments) -> Result<Vec<JudgedSolver>, Failure> {
    let json = folder.join(format!("{name}.json"));
    let case = json_of(&json)?;
    let mps = folder.join(format!("{name}.mps")).to_string_lossy().into_owned();
    let fail = |error: SolveError| Failure::data(format_args!("{}: {error}", Foreign::of(&mps)));
    let source = input::open(&mps).map_err(Failure::refused)?;
    let file = WholeFile::read(source, &limits.sizes()).map_err(Failure::refused)?;
    let model = model_of(&file, limits)?;
    refuse_long(Foreign::of(&mps), &model.work(), times::CHECK, limits)?;
    let plane = Plane::new(&model).map_err(fail)?;
    let answer = Answer::in_plane(&model, &plane).map_err(fail)?;
    compare(&case, &answer, limits)
        .map_err(|problem| Failure::data(format_args!("{}: {problem}", shown(&json))))?;
    let tolerances = Tolerances { relative: Rational::ratio(1, 1_000_000), digits_as_printed: true };
    judge_solvers(&plane, TIME_LIMIT, &tolerances).map_err(fail)
}

/// Whether what is expected is the exact answer.
fn compare(case: &serde_json::Value, answer: &Answer, limits: &LimitArguments) -> Result<(), String> {
    let text = |key: &str| {
        let text = case.get(key).and_then(serde_json::Value::as_str);
        text.ok_or_else(|| format!("there is no text \"{key}\""))
    };
    let (exact, value) = match answer {
        Answer::Optimal { value, .. } => ("optimal", Some(value)),
        Answer::Infeasible { .. } => ("infeasible", None),
        Answer::Unbounded { .. } => ("unbounded", None),
    };
    let status = text("status")?;
    if status != exact {
        return Err(format!("\"status\" is {status:?}, but the program is {exact}"));
    }
    let Some(value) = value else { return Ok(()) };
    let expected = Reading::Decimal.read(text("objective")?, &limits.number());
    let expected = expected.map_err(|error| {
        format!("\"objective\": {}", number_problem(&error, "expected a text such as \"2.5\" or \"5/2\""))
    })?;
    match expected == *value {
        true => Ok(()),
        false => Err(format!("\"objective\" is {expected}, but the exact optimum is {value}")),
    }
}

/// What an error bound may look like.
const EXPECTED: &str = "expected a text such as \"0.5e-3\" or \"1/2000\"";

/// A case: `NAME.csv` with columns x and y, and `"eps"` in `NAME.json`.
fn judged_fit(
    folder: &Path,
    name: &str,
    table: &TableOptions,
    limits: &LimitArguments,
) -> Result<Check, Failure> {
    let json = folder.join(format!("{name}.json"));
    let fail = |problem: String| Failure::data(format_args!("{}: {problem}", shown(&json)));
    let case = json_of(&json)?;
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
    let csv = folder.join(format!("{name}.csv")).to_string_lossy().into_owned();
    let source = input::open(&csv).map_err(Failure::refused)?;
    let measurements = Measurements::read(source, &columns, table).map_err(Failure::refused)?;
    let problem = Problem { measurements, conditions: Vec::new() };
    refuse_long_problem(Foreign::of(&csv), &problem, times::CHECK, limits)?;
    let options = CheckOptions {
        solvers: source_names(),
        answers: Vec::new(),
        tolerance: Rational::ratio(1, 1_000_000),
        as_printed: true,
        time_limit: TIME_LIMIT,
        directions: None,
        all_rows: true,
    };
    check(&problem, Reading::Decimal, &options).map_err(Failure::data)
}
