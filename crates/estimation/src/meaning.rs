//! The meaning of the numbers of a row: the model, and the source of the error bounds.

use boundfit_exact::{Foreign, Rational};

use crate::law::Law;
use crate::line_form::LineForm;
use crate::measurement::{Bounds, Measurement};

/// The way from the columns to the regressors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Model {
    /// y = θ1·x + θ2 + e.
    Line {
        /// The column of x.
        x: Foreign,
    },
    /// y = φ1·θ1 + φ2·θ2 + e.
    TwoRegressors {
        /// The columns of φ1 and φ2.
        regressors: [Foreign; 2],
    },
}

impl Model {
    /// The columns of the regressors, the intercept left out.
    pub(crate) fn regressors(&self) -> &[Foreign] {
        match self {
            Model::Line { x } => std::slice::from_ref(x),
            Model::TwoRegressors { regressors } => regressors,
        }
    }
}

/// The source of the error bounds, with columns by name or, in a question, by selector.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(clippy::large_enum_variant, reason = "one per fit")]
pub enum ErrorBound<C = Foreign> {
    /// One for all readings; not negative.
    Uniform(Rational),
    /// One per reading, from this column.
    Column(C),
    /// The values between which φ·θ lies, instead of a distance from y; cells may be empty, but not both of a row.
    Interval {
        /// The column of lower bounds.
        lower: Option<C>,
        /// The column of upper bounds.
        upper: Option<C>,
    },
    /// A law, which gives each reading its own bound.
    Law(Law),
}

impl<C> ErrorBound<C> {
    /// The bound on all errors, if there is one.
    pub fn uniform(&self) -> Option<&Rational> {
        match self {
            ErrorBound::Uniform(epsilon) => Some(epsilon),
            ErrorBound::Column(_) | ErrorBound::Interval { .. } | ErrorBound::Law(_) => None,
        }
    }

    /// Returns whether all errors have one bound.
    pub fn is_uniform(&self) -> bool {
        self.uniform().is_some()
    }

    /// Returns whether the readings have intervals about middles that need not be y: bounds of columns, or a law that allows
    /// another error above than below. A factor on the bounds, as ε_min then is, multiplies their widths about these middles.
    pub fn has_middles(&self) -> bool {
        match self {
            ErrorBound::Interval { .. } => true,
            ErrorBound::Law(law) => law.is_asymmetric(),
            ErrorBound::Uniform(_) | ErrorBound::Column(_) => false,
        }
    }
}

/// The meaning of the numbers of a row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Meaning {
    pub(crate) model: Model,
    pub(crate) response: Foreign,
    /// True if there is a column of the response.
    pub(crate) has_response: bool,
    pub(crate) error_bound: ErrorBound,
    /// The law by which the bound on all errors was stated.
    pub(crate) uniform_law: Option<Law>,
    pub(crate) form: LineForm,
    pub(crate) multiple_of_least: Option<MultipleOfLeast>,
}

/// An error bound that was not known but taken from the readings themselves: a multiple of the least one that leaves anything.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MultipleOfLeast {
    /// The multiple of ε_min that the bound is.
    pub factor: Rational,
    /// ε_min of the readings under the conditions.
    pub least: Rational,
}

impl MultipleOfLeast {
    /// The bound. Exact.
    pub fn bound(&self) -> Rational {
        &self.factor * &self.least
    }
}

impl Meaning {
    /// Returns the meaning of numbers that are taken as they are.
    pub(crate) fn new(model: Model, response: Foreign, error_bound: ErrorBound) -> Self {
        Meaning {
            model,
            response,
            has_response: true,
            error_bound,
            uniform_law: None,
            form: LineForm::default(),
            multiple_of_least: None,
        }
    }

    /// Returns how many regressors are columns.
    pub(crate) fn regressors(&self) -> usize {
        if matches!(self.model, Model::Line { .. }) { 1 } else { 2 }
    }

    /// The reading with these numbers: the regressors that are columns, the response, and the error bound if it is a
    /// column.
    pub(crate) fn measurement(&self, row: usize, mut numbers: impl Iterator<Item = Rational>) -> Measurement {
        let mut next = || numbers.next().unwrap_or_default();
        let regressor = match self.model {
            Model::Line { .. } => [next(), Rational::one()],
            Model::TwoRegressors { .. } => [next(), next()],
        };
        let response = self.has_response.then(&mut next);
        let mut side = |column: &Option<Foreign>| {
            column.as_ref()?;
            let value = next();
            // Behind each bound stands whether it is there.
            (!next().is_zero()).then_some(value)
        };
        let bounds = match &self.error_bound {
            ErrorBound::Interval { lower, upper } => {
                Bounds::Between { lower: side(lower), upper: side(upper), response }
            }
            ErrorBound::Law(law) => {
                let written = if law.needs_written() { next() } else { Rational::zero() };
                law.bounds(&regressor[0], response.unwrap_or_default(), &written)
            }
            ErrorBound::Column(_) => {
                Bounds::Around { response: response.unwrap_or_default(), epsilon: next() }
            }
            ErrorBound::Uniform(epsilon) => {
                Bounds::Around { response: response.unwrap_or_default(), epsilon: epsilon.clone() }
            }
        };
        // A law is about x as it is.
        let [first, second] = regressor;
        let first = if matches!(self.model, Model::Line { .. }) { self.form.counted(first) } else { first };
        Measurement { row, regressor: [first, second], bounds }
    }
}
