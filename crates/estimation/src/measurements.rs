//! Readings: what was measured, under which model, with which error bound.

use std::borrow::Cow;

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
    /// What it says of φ·θ.
    pub bounds: Bounds,
}

/// What a reading says of φ·θ.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Bounds {
    /// It lies within ε of y.
    Around {
        /// y.
        response: Rational,
        /// ε; not negative.
        epsilon: Rational,
    },
    /// It lies between two values, of which one may be missing. The lower one may be above the upper one: no θ agrees then.
    Between {
        /// φ·θ is at least this.
        lower: Option<Rational>,
        /// φ·θ is at most this.
        upper: Option<Rational>,
        /// y, if there is one. It bounds nothing: least squares takes it.
        response: Option<Rational>,
    },
}

impl Measurement {
    /// A reading y with |y - φ·θ| ≤ ε.
    pub fn around(row: usize, regressor: [Rational; 2], response: Rational, epsilon: Rational) -> Self {
        Measurement { row, regressor, bounds: Bounds::Around { response, epsilon } }
    }

    /// A reading that says lower ≤ φ·θ ≤ upper, as far as the bounds are there, and nothing else.
    pub fn between(
        row: usize,
        regressor: [Rational; 2],
        lower: Option<Rational>,
        upper: Option<Rational>,
    ) -> Self {
        Measurement { row, regressor, bounds: Bounds::Between { lower, upper, response: None } }
    }

    /// y, if there is one.
    pub fn response(&self) -> Option<&Rational> {
        match &self.bounds {
            Bounds::Around { response, .. } => Some(response),
            Bounds::Between { response, .. } => response.as_ref(),
        }
    }

    /// y and ε of a reading that is bounded by them.
    ///
    /// # Panics
    /// When it has other bounds.
    pub(crate) fn y_and_epsilon(&self) -> (&Rational, &Rational) {
        match &self.bounds {
            Bounds::Around { response, epsilon } => (response, epsilon),
            Bounds::Between { .. } => panic!("bounds that do not come from y"),
        }
    }

    /// What least squares takes for y: y if there is one, else the middle of both bounds. Exact.
    pub fn value(&self) -> Option<Cow<'_, Rational>> {
        self.response().map(Cow::Borrowed).or_else(|| self.middle())
    }

    /// The least value that φ·θ may have. Exact.
    pub fn lower(&self) -> Option<Rational> {
        match &self.bounds {
            Bounds::Around { response, epsilon } => Some(response - epsilon),
            Bounds::Between { lower, .. } => lower.clone(),
        }
    }

    /// The largest value that φ·θ may have. Exact.
    pub fn upper(&self) -> Option<Rational> {
        match &self.bounds {
            Bounds::Around { response, epsilon } => Some(response + epsilon),
            Bounds::Between { upper, .. } => upper.clone(),
        }
    }

    /// The middle between both bounds; `None` unless there are both. Exact.
    pub fn middle(&self) -> Option<Cow<'_, Rational>> {
        match &self.bounds {
            Bounds::Around { response, .. } => Some(Cow::Borrowed(response)),
            Bounds::Between { lower, upper, .. } => {
                Some(Cow::Owned((lower.as_ref()? + upper.as_ref()?).half()))
            }
        }
    }

    /// Half of the distance from the lower to the upper bound, negative where they cross; `None` unless there are both.
    /// Exact.
    pub fn half_width(&self) -> Option<Cow<'_, Rational>> {
        match &self.bounds {
            Bounds::Around { epsilon, .. } => Some(Cow::Borrowed(epsilon)),
            Bounds::Between { lower, upper, .. } => {
                Some(Cow::Owned((upper.as_ref()? - lower.as_ref()?).half()))
            }
        }
    }

    /// This reading within another distance of y; one with bounds that do not come from y stays as it is.
    pub fn within(mut self, bound: Rational) -> Self {
        if let Bounds::Around { epsilon, .. } = &mut self.bounds {
            *epsilon = bound;
        }
        self
    }
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
    /// The values between which φ·θ lies, from columns of these names, of which one may be left out.
    Interval {
        /// The column of lower bounds.
        lower: Option<String>,
        /// The column of upper bounds.
        upper: Option<String>,
    },
}

impl ErrorBound {
    /// The bound on all errors, if there is one.
    pub fn uniform(&self) -> Option<&Rational> {
        match self {
            ErrorBound::Uniform(epsilon) => Some(epsilon),
            ErrorBound::PerRow(_) | ErrorBound::Interval { .. } => None,
        }
    }

    /// Whether all errors have one bound.
    pub fn is_uniform(&self) -> bool {
        self.uniform().is_some()
    }
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
        let epsilon = self.error_bound.uniform().cloned().unwrap_or_else(next);
        Measurement::around(row, regressor, response, epsilon)
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

    /// Whether every reading in memory lies within an ε of its y.
    pub(crate) fn is_around_y(&self) -> bool {
        self.kept().iter().all(|row| matches!(row.bounds, Bounds::Around { .. }))
    }

    /// Whether the two hulls of the readings tell which of them can bound anything.
    pub(crate) fn has_hulls(&self) -> bool {
        matches!(self.model(), Model::Line { .. }) && self.error_bound().is_uniform() && self.is_around_y()
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
