//! `boundfit judge`.

mod solutions;

use boundfit_ask::{Form, Readings, Solvable, TableWords};
use boundfit_exact::Foreign;
use boundfit_exact::english::in_words;
use boundfit_figures::{PictureFormat, draw_program};
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use self::solutions::SolutionArguments;
use super::asked::Job;
use super::set_files::SetFiles;
use crate::exit::{CommandResult, Failure};
use crate::options::{
    BAD_DATA, BAD_USAGE, LimitArguments, Notes, OutputArguments, PictureArguments, Words, formats, forms,
};
use crate::progress::while_working;

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

forms!(JudgeFormat: Text, Json, Latex, Markdown, Sarif, Junit, Ine, Ext);

/// Reads the model, solves it and writes the report.
pub(super) fn run(arguments: &JudgeArguments) -> CommandResult {
    let JudgeArguments { model, solutions, output: own, picture: look, limits, .. } = arguments;
    let (output, proof) = (own.file.output.as_deref(), arguments.proof.as_deref());
    let plot = arguments.plot.as_deref();
    let files = SetFiles { plot, proof, proof_library: arguments.proof_library, picture: look };
    let (encoding, theory) = files.checked(output, "a linear program")?;
    let inputs = || solutions.solutions.iter().chain([model]).map(String::as_str);
    if inputs().filter(|input| *input == "-").count() > 1 {
        return Err(Failure::Usage("the model and its solutions cannot share standard input".to_owned()));
    }
    let form = Form::from(own.format()?);
    let mut guard = own.file.replace.guard(inputs());
    guard.check(output)?;
    files.check(&guard)?;
    let table = TableWords { limits: limits.words(), ..TableWords::default() };
    let data = Words { path: model, readings: Readings { table, ..Readings::default() }, limits };
    let name = data.file_name();
    let job = Job { data, form, style: own.style(), output, proof, theory };
    job.run_with(&solutions.question(limits)?, &mut guard, |program, _, _| {
        let encoded = |(format, file)| Ok((picture(program, name, (format, look))?, file));
        encoding.zip(plot).map(encoded).transpose()
    })
}

/// The feasible set with the objective, encoded.
fn picture(
    program: &Solvable,
    file: Foreign<&str>,
    (format, asked): (PictureFormat, &PictureArguments),
) -> Result<Vec<u8>, Failure> {
    let (model, plane) = (program.model(), program.plane());
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
