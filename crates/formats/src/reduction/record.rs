//! The line in front of a reduction, and what can be wrong with it.

use boundfit_exact::{Limits, ParseNumberError, Rational, Reading};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// How the line in front begins.
pub const REDUCTION_MARK: &str = "# boundfit/reduced/1 ";

/// The line in front of a reduction.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReductionRecord {
    /// How many readings there were.
    pub rows: usize,
    /// How many lines of them follow.
    pub kept: usize,
    /// Whether the first line that follows is a header.
    pub header: bool,
    /// `decimal` or `binary64`: how numbers were read.
    pub reading: String,
    /// The name of the column of x.
    pub x: String,
    /// The name of the column of y.
    pub y: String,
    /// The name of the column of the error bounds, when readings were compared only with those of the same bound.
    pub epsilon: Option<String>,
    /// Σx, Σy, Σx² and Σxy over all readings, each as `p/q` or `n`.
    pub sums: [String; 4],
}

/// What is wrong with a reduction.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ReductionError {
    /// A line that begins as it should and goes on otherwise.
    #[error("the line in front of a reduction is not understood: {0}")]
    BadRecord(String),
    /// A sum that is not a number, or one beyond a limit.
    #[error("a sum in the line in front of a reduction: {0}")]
    BadSum(#[from] ParseNumberError),
    /// More readings than can be counted.
    #[error("the reductions stand for more than {} readings", usize::MAX)]
    TooManyRows,
    /// More or fewer lines than announced.
    #[error("the reduction from line {line} on announces {announced} lines of readings, but {found} follow")]
    CountMismatch {
        /// The line in front.
        line: u64,
        /// Lines announced.
        announced: usize,
        /// Lines found.
        found: usize,
    },
    /// A reduction where a table belongs.
    #[error("this is a reduction, and here every reading is wanted: name the table that it was made from")]
    NotHere,
    /// A range of rows of a reduction.
    #[error("no rows of a reduction can be picked: it does not have the numbers that they had")]
    NoRowNumbers,
    /// A reduction of something else than what is asked for.
    #[error("the reduction is about {what} {has}, not {asked}")]
    NotAsked {
        /// What is meant.
        what: &'static str,
        /// What the reduction says.
        has: String,
        /// What is asked for.
        asked: String,
    },
    /// Reductions of different tables.
    #[error("the reduction from line {line} on differs from the first one in {what}")]
    Different {
        /// The line in front.
        line: u64,
        /// What differs.
        what: &'static str,
    },
}

impl ReductionRecord {
    /// The sums as numbers.
    ///
    /// # Errors
    /// When one of them is not a number within the limits.
    pub fn sums(&self, limits: &Limits) -> Result<[Rational; 4], ReductionError> {
        let mut numbers = [const { None }; 4];
        for (number, text) in numbers.iter_mut().zip(&self.sums) {
            *number = Some(Reading::Decimal.read(text, limits)?);
        }
        Ok(numbers.map(Option::unwrap_or_default))
    }

    /// Whether the reduction is about these columns (x, y, and perhaps ε) and this reading of numbers.
    ///
    /// # Errors
    /// The first thing that differs.
    pub fn check(&self, names: &[String], reading: Reading) -> Result<(), ReductionError> {
        let none = || "one bound for all readings".to_owned();
        let asked = |position: usize| names.get(position).cloned();
        let epsilon = asked(2).map(|asked| (self.epsilon.clone().unwrap_or_else(none), asked));
        let compared = [
            ("the column of x", Some((self.x.clone(), asked(0).unwrap_or_default()))),
            ("the column of y", Some((self.y.clone(), asked(1).unwrap_or_default()))),
            ("error bounds from", epsilon),
            ("the reading", Some((self.reading.clone(), reading.name().to_owned()))),
        ];
        for (what, pair) in compared {
            if let Some((has, asked)) = pair.filter(|(has, asked)| has != asked) {
                return Err(ReductionError::NotAsked { what, has, asked });
            }
        }
        Ok(())
    }

    /// The line in front, without line end.
    pub fn line(&self) -> String {
        // Strings, numbers and truth values only: there is nothing in it that cannot be written.
        let json = serde_json::to_string(self).unwrap_or_default();
        format!("{REDUCTION_MARK}{json}")
    }

    pub(super) fn parse(line: &[u8]) -> Result<Self, ReductionError> {
        let json = line.strip_prefix(REDUCTION_MARK.as_bytes()).unwrap_or_default();
        serde_json::from_slice(json).map_err(|error| ReductionError::BadRecord(error.to_string()))
    }

    /// What makes two reductions parts of different wholes.
    pub(super) fn difference(&self, other: &Self) -> Option<&'static str> {
        [
            (self.x != other.x, "the column of x"),
            (self.y != other.y, "the column of y"),
            (self.epsilon != other.epsilon, "the column of error bounds"),
            (self.reading != other.reading, "the reading of numbers"),
            (self.header != other.header, "whether there is a header"),
        ]
        .into_iter()
        .find_map(|(differs, what)| differs.then_some(what))
    }
}
