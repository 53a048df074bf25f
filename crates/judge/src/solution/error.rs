//! What can be wrong with a solution file.

use std::borrow::Cow;

use boundfit_exact::{Limit, ParseNumberError};
use thiserror::Error;

/// Why a solution file cannot be used.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SolutionError {
    /// Content of no known kind.
    #[error(
        "this is no solution (expected JSON, or a solution as GLPK, HiGHS, CBC, CLP, SCIP, Gurobi, MIPLIB or, in XML, CPLEX writes it)"
    )]
    UnknownFormat,
    /// A line that is not understood.
    #[error("line {line}: {text:?} (expected {expected}, as {format} writes it)")]
    Line {
        /// Who writes such files.
        format: &'static str,
        /// From 1.
        line: usize,
        /// The line, cut where it is long.
        text: String,
        /// What would be accepted.
        expected: Cow<'static, str>,
    },
    /// A number that is none, or beyond a limit.
    #[error("line {line}: {text:?}: {error}{} (expected a number, as {format} writes it)", flag(.error))]
    NumberAt {
        /// Who writes such files.
        format: &'static str,
        /// From 1.
        line: usize,
        /// The number, cut where it is long.
        text: String,
        /// What is wrong with it.
        error: ParseNumberError,
    },
    /// A file that stops too early.
    #[error("the file stops without {missing}, which {format} writes")]
    End {
        /// Who writes such files.
        format: &'static str,
        /// What is not there.
        missing: &'static str,
    },
    /// XML that is none.
    #[error("{0} (expected a <CPLEXSolution>, as CPLEX writes it)")]
    Xml(#[from] roxmltree::Error),
}

/// The option that raises the limit that a number passes; nothing where something else is wrong with it.
fn flag(error: &ParseNumberError) -> String {
    Limit::of_number(&error.kind).map(|limit| format!("; {} raises it", limit.flag())).unwrap_or_default()
}

/// A text, cut where it is long.
pub fn quoted(text: &str) -> String {
    const LONGEST: usize = 60;
    let text = text.trim();
    match text.char_indices().nth(LONGEST).and_then(|(end, _)| text.split_at_checked(end)) {
        Some((start, _)) => format!("{start}..."),
        None => text.to_owned(),
    }
}
