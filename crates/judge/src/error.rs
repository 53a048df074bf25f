//! The reasons why a model is not answered.

use boundfit_exact::Foreign;
use boundfit_exact::english::listed;
use thiserror::Error;

/// The reason why a model has no [`Answer`](crate::Answer) here.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SolveError {
    /// More columns than a plane has.
    #[error("{count} columns are not fixed by their bounds, first {} (expected at most two)", listed(&first.iter().map(Foreign::to_string).collect::<Vec<_>>()))]
    TooManyColumns {
        /// The number of columns that bounds do not fix.
        count: usize,
        /// The names of the first three.
        first: Vec<Foreign>,
    },
    /// A row speaks of a column that the model has not.
    #[error("row {row} has a coefficient for a column that is not there")]
    NoSuchColumn {
        /// The name of the row.
        row: Foreign,
    },
    /// Polygon, exact simplex and the proof of the answer do not fit together. It means a bug; no answer is given.
    #[error("the two exact solvers do not agree: {0} (please report this as a bug, with the file)")]
    Disagreement(String),
}
