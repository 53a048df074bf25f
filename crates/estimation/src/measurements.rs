//! Readings: what was measured, under which model, with which error bound.

use boundfit_exact::Rational;
#[cfg(feature = "files")]
use boundfit_formats::TextLayout;

use crate::summary::{NoEui, Reduction};

/// One reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measurement {
    /// Number of the data row in the file, from 1.
    pub row: usize,
    /// φ = (φ1, φ2); (x, 1) for the line model.
    pub regressor: [Rational; 2],
    /// y.
    pub response: Rational,
    /// The bound on the error of this reading; not negative.
    pub epsilon: Rational,
}

/// How the regressors come from the columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Model {
    /// y = θ1·x + θ2 + e.
    Line {
        /// The column of x.
        x: String,
    },
    /// y = φ1·θ1 + φ2·θ2 + e.
    TwoRegressors {
        /// The columns of φ1 and φ2.
        regressors: [String; 2],
    },
}

/// Where the error bounds come from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ErrorBound {
    /// One for all readings.
    Uniform(Rational),
    /// One per reading, from a column of this name.
    PerRow(String),
}

/// What the numbers of a row mean.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Meaning {
    pub(crate) model: Model,
    pub(crate) response: String,
    pub(crate) error_bound: ErrorBound,
}

impl Meaning {
    /// The reading with these numbers: the regressors that are columns, the response, and the error bound if it is a
    /// column.
    pub(crate) fn measurement(&self, row: usize, mut numbers: impl Iterator<Item = Rational>) -> Measurement {
        let mut next = || numbers.next().unwrap_or_default();
        let regressor = match self.model {
            Model::Line { .. } => [next(), Rational::one()],
            Model::TwoRegressors { .. } => [next(), next()],
        };
        let response = next();
        let epsilon = match &self.error_bound {
            ErrorBound::Uniform(epsilon) => epsilon.clone(),
            ErrorBound::PerRow(_) => next(),
        };
        Measurement { row, regressor, response, epsilon }
    }
}

/// The readings that are fitted, as far as they are in memory.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "one per fit")]
pub enum Readings {
    /// Every one of them.
    All(Vec<Measurement>),
    /// Those of a line that support a hull: they decide everything but least squares.
    Supporting {
        /// The readings on the lower or the upper hull of (x, y), ascending by row; where each has its own error bound,
        /// those on a hull of the readings with the same one.
        rows: Vec<Measurement>,
        /// What least squares needs to know about all readings.
        reduction: Reduction,
    },
}

/// Where readings come from.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Origin {
    /// How many data rows there are, fitted or not.
    pub(crate) rows_total: usize,
    #[cfg(feature = "files")]
    pub(crate) layout: Option<TextLayout>,
    pub(crate) sha256: Option<String>,
}

/// The readings of a fit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measurements {
    pub(crate) meaning: Meaning,
    pub(crate) readings: Readings,
    /// Readings that are not fitted, to be shown.
    pub(crate) others: Vec<Measurement>,
    pub(crate) origin: Origin,
}

impl Measurements {
    /// Readings that do not come from a file.
    pub fn new(model: Model, response: String, error_bound: ErrorBound, rows: Vec<Measurement>) -> Self {
        let meaning = Meaning { model, response, error_bound };
        let origin = Origin { rows_total: rows.len(), ..Origin::default() };
        Measurements { meaning, readings: Readings::All(rows), others: Vec::new(), origin }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.meaning.model
    }

    /// The name of the response.
    pub fn response(&self) -> &str {
        &self.meaning.response
    }

    /// Where the error bounds come from.
    pub fn error_bound(&self) -> &ErrorBound {
        &self.meaning.error_bound
    }

    /// Whether the two hulls of the readings tell which of them can bound anything.
    pub(crate) fn has_hulls(&self) -> bool {
        matches!(self.model(), Model::Line { .. }) && matches!(self.error_bound(), ErrorBound::Uniform(_))
    }

    /// The readings that are fitted, and whether all of them are in memory.
    pub fn readings(&self) -> &Readings {
        &self.readings
    }

    /// Every reading that is fitted; `None` when only those that support a hull are in memory.
    pub fn all(&self) -> Option<&[Measurement]> {
        match &self.readings {
            Readings::All(rows) => Some(rows),
            Readings::Supporting { .. } => None,
        }
    }

    /// The readings in memory: all of them, or those that support a hull. Both decide the feasible set and everything
    /// else but least squares.
    pub fn kept(&self) -> &[Measurement] {
        match &self.readings {
            Readings::All(rows) | Readings::Supporting { rows, .. } => rows,
        }
    }

    /// Whether the rows were read from reductions, which number them anew.
    pub fn is_of_reductions(&self) -> bool {
        matches!(
            self.readings,
            Readings::Supporting { reduction: Reduction { spread: Err(NoEui::Reduced), .. }, .. }
        )
    }

    /// How many readings are fitted, kept or not.
    pub fn fitted(&self) -> usize {
        match &self.readings {
            Readings::All(rows) => rows.len(),
            Readings::Supporting { reduction, .. } => reduction.sums.count,
        }
    }

    /// Readings of the file that are not fitted, kept where the table was read with
    /// [`TableOptions::keep_others`](boundfit_formats::TableOptions::keep_others).
    pub fn others(&self) -> &[Measurement] {
        &self.others
    }

    /// How many data rows the file has.
    pub fn rows_total(&self) -> usize {
        self.origin.rows_total
    }

    /// Where in the file the numbers stand: regressors, response and, with one per row, error bound; `None` unless the
    /// readings come from delimited text that has a row for each of them.
    #[cfg(feature = "files")]
    pub fn layout(&self) -> Option<&TextLayout> {
        self.origin.layout.as_ref()
    }

    /// SHA-256 of the file's bytes in hexadecimal, when the readings come from a file.
    pub fn sha256(&self) -> Option<&str> {
        self.origin.sha256.as_deref()
    }
}
