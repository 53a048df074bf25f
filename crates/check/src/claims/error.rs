//! The errors of a claim.

use boundfit_exact::english::counted;
use boundfit_exact::{Foreign, Limit, ParseNumberError, TooMuchWork};
use boundfit_judge::SolutionError;
use boundfit_lp::PuiEnd;
use thiserror::Error;

/// The reason why a claim cannot be used.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ClaimError {
    /// A text that is not JSON, or not of the form of a claim.
    #[error(
        "{} (expected {{\"source\": \"...\", \"status\": \"optimal|infeasible|unbounded\", \"pui\": [[LO, HI], [LO, HI]]}})",
        Foreign::from(.0.to_string())
    )]
    Json(#[from] serde_json::Error),
    /// JSON that is a list.
    #[error(
        "a list (expected {{\"source\": \"...\", \"status\": \"optimal|infeasible|unbounded\", \"pui\": [[LO, HI], [LO, HI]]}})"
    )]
    NoObject,
    /// JSON with arrays or objects too deep inside each other.
    #[error("nested deeper than {limit} levels (the limit) at line {line} column {column}")]
    Nesting {
        /// The deepest level that is read.
        limit: usize,
        /// The line of the bracket that is too much, from 1.
        line: usize,
        /// The byte in the line, from 1.
        column: usize,
    },
    /// A text with numbers that are too long.
    #[error(transparent)]
    Work(#[from] TooMuchWork),
    /// A text that should be a number.
    #[error("{text:?} is not a number: {error}")]
    Number {
        /// The text.
        text: Foreign,
        /// The problem.
        error: ParseNumberError,
    },
    /// A status that is none.
    #[error("{0:?} is not a status (expected optimal, infeasible, unbounded or infeasible-or-unbounded)")]
    Status(Foreign),
    /// An optimum without a value.
    #[error("the status is optimal, but there is neither \"pui\" nor \"points\"")]
    NoValue,
    /// A number of values other than four.
    #[error("{} (expected four: LO1,HI1,LO2,HI2, each a number, inf or -inf)", counted(*.0, "value", "values"))]
    Count(usize),
    /// Content of no known kind.
    #[error(
        "this is no claim (expected JSON, or a solution as GLPK, HiGHS, CBC, CLP, SCIP, Gurobi, MIPLIB or, in XML, CPLEX writes it)"
    )]
    UnknownFormat,
    /// Something is wrong with a solution file.
    #[error(transparent)]
    Solution(SolutionError),
    /// Nothing says which program the file answers.
    #[error(
        "nothing says which of the four programs this answers (expected theta1-min, theta1-max, theta2-min or theta2-max in the file's name)"
    )]
    NoTarget,
    /// The name says one program and the content another.
    #[error("the file is named after {} and answers {}", .named.name(), .inside.name())]
    OtherTarget {
        /// The program that the file's name says.
        named: PuiEnd,
        /// The program that its content says.
        inside: PuiEnd,
    },
    /// Two files of one solver for one program.
    #[error("{} is answered by {other} already", .target.name())]
    Twice {
        /// The program.
        target: PuiEnd,
        /// The other file.
        other: Foreign,
    },
}

impl ClaimError {
    /// The limit that was passed, if that is the problem.
    pub fn limit(&self) -> Option<Limit> {
        match self {
            ClaimError::Nesting { .. } => Some(Limit::Nesting),
            ClaimError::Work(_) => Some(Limit::Work),
            ClaimError::Number { error, .. } => Limit::of_number(&error.kind),
            ClaimError::Solution(error) => error.limit(),
            _ => None,
        }
    }
}

/// A claims file that cannot be used, and why.
#[derive(Debug, Error)]
#[error("{file}: {problem}")]
pub struct ClaimFileError {
    /// The file, as it was named.
    pub file: Foreign,
    /// The problem.
    #[source]
    pub problem: ClaimError,
}

impl From<SolutionError> for ClaimError {
    /// A claim of no known kind may be JSON as well.
    fn from(error: SolutionError) -> Self {
        match error {
            SolutionError::UnknownFormat => ClaimError::UnknownFormat,
            other => ClaimError::Solution(other),
        }
    }
}
