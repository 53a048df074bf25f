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
    pub(crate) model: String,
    /// Also draw the feasible set, the optimal points and the direction of improvement: FILE.svg, .png, .pdf, .tikz or
    /// .tex
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) plot: Option<String>,
    /// Write a theorem for the kernel of Coq to this file, which ends in .v: the feasible set, the optimum and all points
    /// that attain it. The program must have two columns
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    pub(crate) proof_library: bool,
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
    /// Findings about solutions, for code hosts: SARIF 2.1.0, a rule for each aspect
    Sarif,
    /// Findings about solutions, for continuous integration: JUnit XML, a test case for each aspect
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
