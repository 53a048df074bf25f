//! Which columns of a table are what.

use boundfit_exact::Rational;
use boundfit_formats::ColumnSelector;

use crate::measurements::{ErrorBound, Meaning, Model};

/// The error bound as it is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum EpsilonColumn {
    /// One number for all readings; not negative.
    Uniform(Rational),
    /// A column.
    Column(ColumnSelector),
}

/// Which columns of a table are what.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns {
    /// x, or φ1.
    pub first: ColumnSelector,
    /// φ2; `None` for the line model.
    pub second: Option<ColumnSelector>,
    /// y.
    pub response: ColumnSelector,
    /// ε.
    pub epsilon: EpsilonColumn,
}

impl Columns {
    /// The columns in the order in which they are read: regressors, response, error bound.
    pub(crate) fn selectors(&self) -> Vec<ColumnSelector> {
        let mut selectors = vec![self.first.clone()];
        selectors.extend(self.second.clone());
        selectors.push(self.response.clone());
        if let EpsilonColumn::Column(epsilon) = &self.epsilon {
            selectors.push(epsilon.clone().non_negative());
        }
        selectors
    }

    /// What the numbers in those columns mean, whose names are given.
    pub(crate) fn meaning(&self, names: &[String]) -> Meaning {
        let mut names = names.iter().cloned();
        let mut name = || names.next().unwrap_or_default();
        let first = name();
        let model = match self.second {
            None => Model::Line { x: first },
            Some(_) => Model::TwoRegressors { regressors: [first, name()] },
        };
        let response = name();
        let error_bound = match &self.epsilon {
            EpsilonColumn::Uniform(epsilon) => ErrorBound::Uniform(epsilon.clone()),
            EpsilonColumn::Column(_) => ErrorBound::PerRow(name()),
        };
        Meaning { model, response, error_bound }
    }
}
