//! `boundfit judge`.

mod solutions;

use boundfit_exact::Foreign;
use boundfit_exact::english::in_words;
use boundfit_figures::{PictureFormat, draw_program};
use boundfit_formats::WholeFile;
use boundfit_judge::{Answer, Plane};
use boundfit_lp::{ExchangeFormat, Model, ModelErrorKind, ModelLimits, model_text, read_model};
use boundfit_report::{
    JudgeJson, Theory, h_representation, judge_document, judge_json, kernel_program, solutions_document,
    solutions_json, solutions_junit, solutions_sarif, v_representation,
};
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use self::solutions::SolutionArguments;
use super::set_files::SetFiles;
use crate::exit::{CommandResult, Exit, Failure, command_for};
use crate::input;
use crate::options::{
    BAD_DATA, BAD_USAGE, LimitArguments, Notes, OutputArguments, PictureArguments, formats,
};
use crate::progress::while_working;
use crate::work::{refuse_long, refuse_long_text, times};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "The exact answer: optimum, all optimal points, duals, reduced costs, basis, the feasible set",
            "boundfit judge model.mps",
        ),
        ("Everything as fractions, for a program", "boundfit judge model.lp --format json -o answer.json"),
        (
            "Files that solvers wrote about it, each aspect judged on its own; for a code host",
            "boundfit judge model.mps --solution highs.sol --solution glpk.sol --format sarif",
        ),
    ],
    statuses: &[
        (0, "there is an answer, and no solution is refuted"),
        BAD_DATA,
        BAD_USAGE,
        (3, "the program is infeasible, with the proof printed, and no solution is judged"),
        (4, "a solution is refuted"),
    ],
};

/// Solve a linear program with at most two free variables exactly, with a proof of the answer
///
/// The model is an MPS file (fixed or free) or an LP file as CPLEX writes it, plain or packed by gzip or Zstandard.
/// Each number means what its text says. boundfit intersects half-planes, confirms the answer by an exact simplex
/// method, and multiplies it out in the model. Prices prove an optimum, Farkas multipliers prove infeasibility, and a
/// ray proves that the objective is unbounded. docs/lp-files.md explains the files where readers differ.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct JudgeArguments {
    /// MODEL.mps or MODEL.lp, or - for standard input, whose text decides the format
    model: String,
    /// Also draw the feasible set, the optimal points and the direction of improvement, or the bounds that contradict
    /// each other: FILE.svg, .png, .pdf, .tikz or .tex
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    plot: Option<String>,
    /// Write a theorem for the kernel of Coq to this file, which ends in .v: the feasible set, the optimum and all points
    /// that attain it. The program must have two columns
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    proof_library: bool,
    #[command(flatten)]
    picture: PictureArguments,
    #[command(flatten)]
    solutions: SolutionArguments,
    #[command(flatten)]
    output: OutputArguments<JudgeFormat>,
    #[command(flatten)]
    limits: LimitArguments,
}

formats! {
    /// Formats of the answer to a linear program.
    JudgeFormat {
        /// Everything, for programs
        Json: "json";
        /// The report's tables in LaTeX (booktabs)
        Latex: "tex";
        /// The report's tables in Markdown
        Markdown: "md", "markdown";
        /// Findings about solutions, for code hosts: SARIF 2.1.0, a rule for each aspect
        Sarif: "sarif";
        /// Findings about solutions, for continuous integration: JUnit XML, a test case for each aspect
        Junit: "xml";
        /// The irredundant half-planes of the feasible set as cdd's and lrs's H-representation
        Ine: "ine";
        /// The vertices, rays and lines of the feasible set as cdd's and lrs's V-representation
        Ext: "ext";
    }
}

/// Reads the model, solves it and writes the report.
pub(super) fn run(arguments: &JudgeArguments) -> CommandResult {
    let output = arguments.output.file.output.as_deref();
    let files = SetFiles {
        plot: arguments.plot.as_deref(),
        proof: arguments.proof.as_deref(),
        proof_library: arguments.proof_library,
        picture: &arguments.picture,
    };
    let (plot, theory) = files.checked(output, "a linear program")?;
    let inputs = arguments.solutions.solutions.iter().chain([&arguments.model]);
    if inputs.filter(|input| *input == "-").count() > 1 {
        return Err(Failure::Usage("the model and its solutions cannot share standard input".to_owned()));
    }
    let format = arguments.output.format()?;
    check_usage_of_format(arguments, format)?;
    let inputs = arguments.solutions.solutions.iter().chain([&arguments.model]).map(String::as_str);
    let mut guard = arguments.output.file.replace.guard(inputs);
    guard.check(output)?;
    files.check(&guard)?;
    let file = read(arguments)?;
    let model = model_of(&file, &arguments.limits)?;
    theory.map_or(Ok(()), |_| refuse_other_columns(&model, &file))?;
    let fail = |error| Failure::data(format_args!("{}: {error}", file.name));
    refuse_long(file.name.borrowed(), &model.work(), times::JUDGE, &arguments.limits)?;
    let plane = Plane::new(&model).map_err(fail)?;
    let answer = while_working("solving", || Answer::in_plane(&model, &plane)).map_err(fail)?;
    let judged = solutions::judged(&arguments.solutions, &arguments.limits, &model, &answer)?;
    let style = arguments.output.style();
    let document = || {
        let mut document = judge_document(&model, &plane, &answer, file.name.borrowed(), &style);
        document.append(solutions_document(&model, &judged));
        document
    };
    let report = match format {
        JudgeFormat::Text => document().to_text(),
        JudgeFormat::Latex => document().to_latex(),
        JudgeFormat::Markdown => document().to_markdown(),
        JudgeFormat::Json => {
            let name = Some(Foreign::of(&arguments.model)).filter(|name| *name != "-");
            let json = JudgeJson::new(&model, &plane, &answer, name, &file.sha256, &style);
            judge_json(&json.with_solutions(solutions_json(&model, &judged, &style)))
        }
        JudgeFormat::Sarif => solutions_sarif(&model, &judged),
        JudgeFormat::Junit => solutions_junit(&model, &judged),
        JudgeFormat::Ine => h_representation(plane.polyhedron()),
        JudgeFormat::Ext => v_representation(plane.polyhedron()),
    };
    let picture =
        plot.map(|format| picture(&model, &plane, &file.name, (format, &arguments.picture))).transpose()?;
    let theorem = theory.map(|theory| theorem(&model, &answer, theory, &file)).transpose()?;
    files.write((&report, output), picture.as_deref(), theorem.as_deref(), &mut guard)?;
    Ok(match answer {
        _ if solutions::is_refuted(&judged) => Exit::Refuted,
        // Who asks about solutions is not asked to look at the status twice.
        Answer::Infeasible { .. } if judged.is_empty() => Exit::Empty,
        _ => Exit::Answer,
    })
}

/// Refuses to prove programs that are not in the plane as they stand in the file.
fn refuse_other_columns(model: &Model, file: &WholeFile) -> Result<(), Failure> {
    match model.columns.len() {
        2 => Ok(()),
        count => Err(Failure::Usage(format!(
            "'--proof' is about linear programs in two columns, and {} has {}: there is no theorem about its answer",
            file.name,
            in_words(count)
        ))),
    }
}

/// The theorem about the answer.
fn theorem(model: &Model, answer: &Answer, theory: Theory, file: &WholeFile) -> Result<String, Failure> {
    kernel_program(model, answer, Some(&file.sha256), theory)
        .ok_or_else(|| Failure::data(format_args!("{}: this answer has no certificate", file.name)))
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
            "'--format {name}' writes findings about solutions: give '--solution <FILE>'"
        ))),
        false => Ok(()),
    }
}

/// The feasible set with the objective, encoded.
fn picture(
    model: &Model,
    plane: &Plane,
    file: &Foreign,
    (format, asked): (PictureFormat, &PictureArguments),
) -> Result<Vec<u8>, Failure> {
    let [first, second] = plane.columns() else {
        let count = in_words(plane.columns().len());
        let problem = match model.columns.len() == plane.columns().len() {
            true => format!("this model has {count}"),
            false => format!("bounds fix all but {count} of this model"),
        };
        return Err(Failure::data(format_args!("{file}: '--plot' draws two columns, and {problem}")));
    };
    let name =
        |column: &usize| model.columns.get(*column).map_or_else(Foreign::default, |own| own.name.clone());
    let names = [name(first), name(second)];
    let title = Foreign::from(format!("Linear program of {}", file.raw()));
    let options = asked.options();
    let draw = || draw_program(plane.polyhedron(), plane.gain(), &names, &title, &options);
    let picture = while_working("drawing", draw).map_err(Failure::data)?;
    picture.encoded_as(format, &asked.encoding()).map_err(Failure::data)
}

fn read(arguments: &JudgeArguments) -> Result<WholeFile, Failure> {
    let source = input::open(&arguments.model).map_err(Failure::refused)?;
    WholeFile::read(source, &arguments.limits.sizes()).map_err(Failure::refused)
}

/// The command for a file that is no model and has no name of one: most are tables.
const READS_TABLES: &str =
    "'boundfit fit' fits the readings of a table; MPS and LP are the formats of linear programs";

/// The model in a file, in the format that its name or its first word tells.
fn model_of(file: &WholeFile, limits: &LimitArguments) -> Result<Model, Failure> {
    let fail = |error| Failure::refused_of(file.name.borrowed(), error);
    let text = model_text(&file.content).map_err(fail)?;
    refuse_long_text(file.name.borrowed(), text, limits)?;
    let sizes = limits.sizes();
    let limits = ModelLimits {
        number: limits.number(),
        line: sizes.line,
        rows: sizes.rows,
        columns: sizes.columns,
        entries: sizes.elements,
    };
    let format = format_of_name(file.name.raw());
    let is_unnamed = format.is_none();
    read_model(text, format.unwrap_or_else(|| format_of_text(text)), &limits).map_err(|error| {
        let is_table = || matches!(error.kind, ModelErrorKind::UnknownSection).then_some(READS_TABLES);
        match command_for(file.name.raw()).or_else(is_table).filter(|_| is_unnamed) {
            Some(command) => Failure::data(format_args!("{}: no linear program; {command}", file.name)),
            None => fail(error),
        }
    })
}

/// The format that a file's name announces, packed or not.
fn format_of_name(name: &str) -> Option<ExchangeFormat> {
    let name = name.to_ascii_lowercase();
    let name = name.strip_suffix(".gz").or_else(|| name.strip_suffix(".zst")).unwrap_or(&name);
    let (_, ending) = name.rsplit_once('.')?;
    ExchangeFormat::ALL.into_iter().find(|format| format.name() == ending)
}

/// The format of a text: LP begins with a comment behind `\` or with what is wanted of the objective. A comment behind `/` is lp_solve's,
/// whose format the reader of LP knows.
fn format_of_text(text: &str) -> ExchangeFormat {
    let start = text.trim_start_matches('\u{feff}').trim_start();
    let word: String = start.chars().take(3).flat_map(char::to_lowercase).collect();
    if start.starts_with(['\\', '/']) || word == "min" || word == "max" {
        ExchangeFormat::Lp
    } else {
        ExchangeFormat::Mps
    }
}
