//! The questions that a reduction serves, and those that it is asked.

use boundfit_exact::Foreign;
use serde::{Deserialize, Serialize};

use super::error::ReductionError;

/// The model of a reduction: the columns, and the bounds under which the rows that are kept decide.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReducedModel {
    /// The name of the column of x, or of both regressors.
    pub regressors: Vec<Foreign>,
    /// The name of the column of y, if there is one.
    pub response: Option<Foreign>,
    /// The bounds.
    pub bounds: ReducedBounds,
}

/// The bounds under which the rows that are kept decide.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ReducedBounds {
    /// One for all readings of a line, whatever it is.
    #[serde(skip)]
    Any,
    /// Any multiple of the bounds in a column of this name, for a line.
    #[serde(skip)]
    Multiples(Foreign),
    /// This one for all readings, as `p/q` or `n`.
    Uniform(Foreign),
    /// The bounds in a column of this name.
    Column(Foreign),
    /// The bounds of a law, in the only way in which [`AskedReduction`] writes it.
    Law(Foreign),
    /// Intervals between the columns of these names, of which one may be left out.
    Interval {
        /// The column of lower bounds.
        lower: Option<Foreign>,
        /// The column of upper bounds.
        upper: Option<Foreign>,
    },
}

/// The question about a reduction.
#[derive(Debug, Clone)]
pub struct AskedReduction {
    /// The columns and bounds asked for; of these [`ReducedBounds::Any`] and [`ReducedBounds::Multiples`] ask for all, and the
    /// others for one.
    pub model: ReducedModel,
    /// The bounds as they were asked for, where they are written otherwise in a reduction.
    pub bounds: Option<Foreign>,
}

impl ReducedModel {
    fn name(&self) -> &'static str {
        if self.regressors.len() == 1 { "a line" } else { "two regressors" }
    }

    /// Returns whether what was reduced serves what is asked for.
    pub(super) fn check(&self, asked: &AskedReduction) -> Result<(), ReductionError> {
        let AskedReduction { model, bounds } = asked;
        let differ = |what, has: String, asked: String| Err(ReductionError::NotAsked { what, has, asked });
        if self.regressors.len() != model.regressors.len() {
            return differ("the model of the reduction is", self.name().to_owned(), model.name().to_owned());
        }
        let whats = match self.regressors.len() {
            1 => ["the column of x in the reduction is", ""],
            _ => ["the first regressor of the reduction is", "the second regressor of the reduction is"],
        };
        for (what, (has, asked)) in whats.into_iter().zip(self.regressors.iter().zip(&model.regressors)) {
            if has != asked {
                return differ(what, has.quoted(), asked.quoted());
            }
        }
        if !self.bounds.serve(&model.bounds) {
            let asked = bounds.as_ref().map_or_else(|| model.bounds.words(), Foreign::quoted);
            return differ("the reduction is about error bounds from", self.bounds.words(), asked);
        }
        if self.response != model.response {
            let name = |response: &Option<Foreign>| {
                response.as_ref().map_or_else(|| "none".to_owned(), Foreign::quoted)
            };
            return differ(
                "the column of y in the reduction is",
                name(&self.response),
                name(&model.response),
            );
        }
        Ok(())
    }

    /// Returns the difference that makes reductions of two models parts of different wholes.
    pub(super) fn difference(&self, other: &Self) -> Option<&'static str> {
        if self.regressors.len() != other.regressors.len() {
            return Some("the number of regressors");
        }
        if self.regressors != other.regressors {
            return Some(if self.regressors.len() == 1 { "the column of x" } else { "the regressors" });
        }
        if self.response != other.response {
            return Some("the column of y");
        }
        (self.bounds != other.bounds).then(|| self.bounds.difference(&other.bounds))
    }
}

impl ReducedBounds {
    /// Returns whether rows that decide under these bounds decide under others.
    fn serve(&self, asked: &Self) -> bool {
        match (self, asked) {
            // Rows that decide among readings of each bound decide among all of them, too.
            (ReducedBounds::Any | ReducedBounds::Multiples(_), ReducedBounds::Uniform(_)) => true,
            (ReducedBounds::Multiples(_), ReducedBounds::Any) => true,
            (ReducedBounds::Multiples(own), ReducedBounds::Column(asked)) => own == asked,
            _ => self == asked,
        }
    }

    fn words(&self) -> String {
        match self {
            ReducedBounds::Any => "one bound for all readings".to_owned(),
            ReducedBounds::Multiples(text)
            | ReducedBounds::Uniform(text)
            | ReducedBounds::Column(text)
            | ReducedBounds::Law(text) => text.to_string(),
            ReducedBounds::Interval { lower: Some(lower), upper: Some(upper) } => {
                format!("the columns {lower} and {upper}")
            }
            ReducedBounds::Interval { lower: Some(lower), .. } => format!("the lower bounds {lower} alone"),
            ReducedBounds::Interval { upper, .. } => {
                let upper = upper.as_ref().map(Foreign::to_string).unwrap_or_default();
                format!("the upper bounds {upper} alone")
            }
        }
    }

    /// The difference between bounds.
    fn difference(&self, other: &Self) -> &'static str {
        match (self, other) {
            (ReducedBounds::Uniform(_), ReducedBounds::Uniform(_)) => "the error bound",
            (ReducedBounds::Law(_), ReducedBounds::Law(_)) => "the law of error bounds",
            (ReducedBounds::Interval { .. }, ReducedBounds::Interval { .. }) => {
                "the columns of lower and upper bounds"
            }
            (
                ReducedBounds::Any | ReducedBounds::Multiples(_) | ReducedBounds::Column(_),
                ReducedBounds::Any | ReducedBounds::Multiples(_) | ReducedBounds::Column(_),
            ) => "the column of error bounds",
            _ => "where error bounds come from",
        }
    }
}
