//! `boundfit judge`.

use boundfit_formats::{Source, WholeFile};
use boundfit_judge::{Answer, Plane};
use boundfit_lp::{ExchangeFormat, Model, ModelLimits, model_text, read_model};
use boundfit_report::{
    JudgeJson, h_representation, judge_document, judge_json, lean_theorems, solutions_document,
    solutions_json, solutions_junit, solutions_sarif, v_representation,
};

use super::solutions;
use crate::CommandResult;
use crate::arguments::{JudgeArguments, JudgeFormat, LimitArguments};
use crate::exit::{Exit, Failure};
use crate::output;
use crate::progress::while_working;

/// Reads the model, solves it and writes the report.
pub(crate) fn run(arguments: &JudgeArguments) -> CommandResult {
    check_usage_of_lean(arguments)?;
    let format = arguments.output.format()?;
    check_usage_of_format(arguments, format)?;
    let inputs = arguments.solutions.solutions.iter().chain([&arguments.model]).map(String::as_str);
    let mut guard = arguments.output.file.replace.guard(inputs);
    let output = arguments.output.file.output.as_deref();
    guard.check(output)?;
    guard.check(arguments.lean.as_deref())?;
    let file = read(arguments)?;
    let model = model_of(&file, &arguments.limits)?;
    let fail = |error| Failure::data(format_args!("{}: {error}", file.name));
    let plane = Plane::new(&model).map_err(fail)?;
    let answer = while_working("solving", || Answer::in_plane(&model, &plane)).map_err(fail)?;
    let judged = solutions::judged(&arguments.solutions, &arguments.limits, &model, &answer)?;
    let style = arguments.output.style();
    let document = || {
        let mut document = judge_document(&model, &plane, &answer, &file.name, &style);
        document.append(solutions_document(&model, &judged));
        document
    };
    let report = match format {
        JudgeFormat::Text => document().to_text(),
        JudgeFormat::Latex => document().to_latex(),
        JudgeFormat::Markdown => document().to_markdown(),
        JudgeFormat::Json => {
            let name = Some(arguments.model.as_str()).filter(|name| *name != "-");
            let json = JudgeJson::new(&model, &plane, &answer, name, &file.sha256, &style);
            judge_json(&json.with_solutions(solutions_json(&model, &judged, &style)))
        }
        JudgeFormat::Sarif => solutions_sarif(&model, &judged),
        JudgeFormat::Junit => solutions_junit(&model, &judged),
        JudgeFormat::Ine => h_representation(plane.polyhedron()),
        JudgeFormat::Ext => v_representation(plane.polyhedron()),
    };
    if let Some(lean) = &arguments.lean {
        output::write(lean_theorems(&model, &answer, &file.name), Some(lean), &guard)?;
        guard.keep_written(lean);
    }
    output::write(&report, output, &guard)?;
    Ok(match answer {
        _ if solutions::is_refuted(&judged) => Exit::Refuted,
        // Who asks about solutions is not asked to look at the status twice.
        Answer::Infeasible { .. } if judged.is_empty() => Exit::Empty,
        _ => Exit::Answer,
    })
}

/// Refuses formats that have a place for findings alone where none are asked for.
fn check_usage_of_format(arguments: &JudgeArguments, format: JudgeFormat) -> Result<(), Failure> {
    let name = match format {
        JudgeFormat::Sarif => "sarif",
        JudgeFormat::Junit => "junit",
        _ => return Ok(()),
    };
    match arguments.solutions.solutions.is_empty() {
        true => Err(Failure::Usage(format!(
            "'--format {name}' has what is found about solutions: give '--solution <FILE>'"
        ))),
        false => Ok(()),
    }
}

/// Refuses theorems that would have no file of their own.
fn check_usage_of_lean(arguments: &JudgeArguments) -> Result<(), Failure> {
    let Some(file) = arguments.lean.as_deref() else { return Ok(()) };
    let problem = match arguments.output.file.output.as_deref().unwrap_or("-") {
        "-" if file == "-" => {
            "'--lean -' and the report would both go to standard output: give one of them a file"
        }
        output if output != "-" && file != "-" && output::is_one_file(output, file) => {
            "'--lean' and '--output' name the same file"
        }
        _ => return Ok(()),
    };
    Err(Failure::Usage(problem.to_owned()))
}

fn read(arguments: &JudgeArguments) -> Result<WholeFile, Failure> {
    let source = Source::open(&arguments.model).map_err(Failure::data)?;
    WholeFile::read(source, &arguments.limits.sizes()).map_err(Failure::data)
}

/// The model in a file, in the format that its name or its first word tells.
fn model_of(file: &WholeFile, limits: &LimitArguments) -> Result<Model, Failure> {
    let fail = |error| Failure::data(format_args!("{}: {error}", file.name));
    let text = model_text(&file.content).map_err(fail)?;
    let sizes = limits.sizes();
    let limits = ModelLimits {
        number: limits.number(),
        line: sizes.line,
        rows: sizes.rows,
        columns: sizes.columns,
        ..ModelLimits::default()
    };
    let format = format_of_name(&file.name).unwrap_or_else(|| format_of_text(text));
    read_model(text, format, &limits).map_err(fail)
}

/// The format that a file's name announces, packed or not.
fn format_of_name(name: &str) -> Option<ExchangeFormat> {
    let name = name.to_ascii_lowercase();
    let name = name.strip_suffix(".gz").or_else(|| name.strip_suffix(".zst")).unwrap_or(&name);
    let (_, ending) = name.rsplit_once('.')?;
    ExchangeFormat::ALL.into_iter().find(|format| format.name() == ending)
}

/// The format of a text: LP begins with a comment behind `\` or with what is wanted of the objective.
fn format_of_text(text: &str) -> ExchangeFormat {
    let start = text.trim_start_matches('\u{feff}').trim_start();
    let word: String = start.chars().take(3).flat_map(char::to_lowercase).collect();
    if start.starts_with('\\') || word == "min" || word == "max" {
        ExchangeFormat::Lp
    } else {
        ExchangeFormat::Mps
    }
}
