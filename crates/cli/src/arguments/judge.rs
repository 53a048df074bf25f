//! The arguments of `boundfit judge`.

use clap::builder::NonEmptyStringValueParser;
use clap::{Args, ValueEnum};

use super::endings::NamedFormat;
use super::look::PictureArguments;
use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::{LimitArguments, OutputArguments, SolutionArguments};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "The exact answer: optimum, all optimal points, duals, reduced costs, basis, the feasible set",
            "boundfit judge model.mps",
        ),
        ("Everything as fractions, for a program", "boundfit judge model.lp --format json -o answer.json"),
        (
            "What solvers wrote about it, each aspect judged on its own; for a code host",
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

/// Solve any linear program of at most two columns that bounds do not fix, exactly, with a proof of the answer
///
/// The model is an MPS file (fixed or free) or an LP file as CPLEX writes it, packed by gzip or Zstandard or not; every number
/// is what its text says. The answer is found by intersecting half-planes, confirmed by an exact simplex method, and
/// multiplied out in the model as it was given: prices prove an optimum, Farkas multipliers that there is no feasible point,
/// a ray that the objective improves for ever. docs/lp-files.md says how files are meant where readers differ.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct JudgeArguments {
    /// MODEL.mps or MODEL.lp, or - for standard input, where the text tells which it is
    pub(crate) model: String,
    /// Also draw the feasible set, the optimal points and where the objective improves: FILE.svg, .png, .pdf, .tikz or .tex
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) plot: Option<String>,
    #[command(flatten)]
    pub(crate) picture: PictureArguments,
    #[command(flatten)]
    pub(crate) solutions: SolutionArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments<JudgeFormat>,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
}

/// Formats of the answer to a linear program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum JudgeFormat {
    /// A report for people
    #[default]
    Text,
    /// Everything, for programs
    Json,
    /// The report's tables in LaTeX (booktabs)
    Latex,
    /// The report's tables in Markdown
    Markdown,
    /// What is found about solutions, for code hosts: SARIF 2.1.0, a rule for each aspect
    Sarif,
    /// What is found about solutions, for continuous integration: JUnit XML, a test case for each aspect
    Junit,
    /// The irredundant half-planes of the feasible set as cdd's and lrs's H-representation
    Ine,
    /// The vertices, rays and lines of the feasible set as cdd's and lrs's V-representation
    Ext,
}

impl NamedFormat for JudgeFormat {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", JudgeFormat::Json),
        ("tex", JudgeFormat::Latex),
        ("md", JudgeFormat::Markdown),
        ("markdown", JudgeFormat::Markdown),
        ("sarif", JudgeFormat::Sarif),
        ("xml", JudgeFormat::Junit),
        ("ine", JudgeFormat::Ine),
        ("ext", JudgeFormat::Ext),
        ("txt", JudgeFormat::Text),
    ];
}
