//! The errors of a solution file.

use std::borrow::Cow;

use boundfit_exact::english::counted;
use boundfit_exact::{Foreign, Limit, ParseNumberError};
use thiserror::Error;

/// The reason why a solution file cannot be used.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SolutionError {
    /// Content of no known kind.
    #[error(
        "this is no solution (expected JSON, or a solution as GLPK, HiGHS, CBC, CLP, SCIP, Gurobi, MIPLIB or, in XML, CPLEX writes it)"
    )]
    UnknownFormat,
    /// A file of HiGHS that does not say how the solver ended.
    #[error(
        "this is the old style (-1) of HiGHS, without a status and names (expected write_solution_style 0, 1, 2, 3 or 4)"
    )]
    OldHighs,
    /// A line that is not understood.
    #[error("line {line}: {text:?} (expected {expected}, as {format} writes it)")]
    Line {
        /// The program that writes such files.
        format: &'static str,
        /// The line, from 1.
        line: usize,
        /// The line, cut where it is long.
        text: Foreign,
        /// The text that would be accepted.
        expected: Cow<'static, str>,
    },
    /// A number that is none, or beyond a limit.
    #[error("line {line}: {text:?}: {error} (expected a number, as {format} writes it)")]
    NumberAt {
        /// The program that writes such files.
        format: &'static str,
        /// The line, from 1.
        line: usize,
        /// The number, cut where it is long.
        text: Foreign,
        /// The problem.
        error: ParseNumberError,
    },
    /// A file that stops too early.
    #[error("the file stops without {missing}, which {format} writes")]
    End {
        /// The program that writes such files.
        format: &'static str,
        /// The missing part.
        missing: &'static str,
    },
    /// A file that ends before what its writer always ends with.
    #[error("the file stops without {missing}, which {format} writes (was the file cut off?)")]
    CutOff {
        /// The program that writes such files.
        format: &'static str,
        /// The missing part.
        missing: &'static str,
    },
    /// A file that lists more or fewer entries than it announces.
    #[error("line {line}: {text:?}: the file lists {} (was the file cut off?)", counted(*.count, .kind, .kinds))]
    Listed {
        /// The line that announces them, from 1.
        line: usize,
        /// The text of the line, cut where it is long.
        text: Foreign,
        /// The number of entries that follow.
        count: usize,
        /// Column or row.
        kind: &'static str,
        /// Columns or rows.
        kinds: &'static str,
    },
    /// Two lines of which only one can be true.
    #[error("line {line}: {text:?} contradicts line {other}: {other_text:?}")]
    Contradiction {
        /// The line, from 1.
        line: usize,
        /// The text of the line, cut where it is long.
        text: Foreign,
        /// The other line, from 1.
        other: usize,
        /// The text of the other line, cut where it is long.
        other_text: Foreign,
    },
    /// JSON that is none.
    #[error(
        "{} (expected {{\"status\": \"optimal\", \"objective\": 3, \"x\": {{NAME: VALUE}}, \"duals\": {{NAME: VALUE}}}})",
        Foreign::from(.0.to_string())
    )]
    Json(serde_json::Error),
    /// A field of JSON that is not understood.
    #[error("line {line}: \"{field}\": {found} (expected {expected})")]
    Field {
        /// The line, from 1.
        line: usize,
        /// The name.
        field: Foreign,
        /// The text that is there, cut where it is long.
        found: Foreign,
        /// The text that would be accepted.
        expected: &'static str,
    },
    /// A name or a place that the model has not.
    #[error("line {line}: {of} is no {kind} of the model (expected {available})")]
    Unknown {
        /// The line, from 1.
        line: usize,
        /// The name in the file.
        of: Foreign,
        /// Column or row.
        kind: &'static str,
        /// The text that would be accepted.
        available: String,
    },
    /// Two values for one column or row.
    #[error("line {line}: {of} has a value already (line {first})")]
    Twice {
        /// The second one, from 1.
        line: usize,
        /// The name.
        of: Foreign,
        /// The first one.
        first: usize,
    },
    /// A column without a value, of a writer that leaves none out.
    #[error("there is no value of the column {column}, which {format} writes")]
    NoValue {
        /// The program that writes such files.
        format: &'static str,
        /// The name.
        column: Foreign,
    },
    /// A list that belongs to another program.
    #[error("{list} has {} (expected {expected}, one for each {kind} of the program)", counted(*.count, "number", "numbers"))]
    Count {
        /// The list.
        list: &'static str,
        /// The length that it has.
        count: usize,
        /// The length that it should have.
        expected: usize,
        /// Column or row.
        kind: &'static str,
    },
    /// XML that is none.
    #[error("{} (expected a <CPLEXSolution>, as CPLEX writes it)", Foreign::from(.0.to_string()))]
    Xml(#[from] roxmltree::Error),
}

impl SolutionError {
    /// The limit that a number passes, if that is the problem.
    pub fn limit(&self) -> Option<Limit> {
        match self {
            SolutionError::NumberAt { error, .. } => Limit::of_number(&error.kind),
            _ => None,
        }
    }
}

/// A text, cut where it is long.
pub fn quoted(text: &str) -> Foreign {
    const LONGEST: usize = 60;
    let text = text.trim();
    match text.char_indices().nth(LONGEST).and_then(|(end, _)| text.split_at_checked(end)) {
        Some((start, _)) => format!("{start}...").into(),
        None => text.into(),
    }
}
