//! One reading, and what it says of the parameters.

use std::borrow::Cow;

use boundfit_exact::Rational;

/// One reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measurement {
    /// Number of the data row in the file, from 1.
    pub row: usize,
    /// φ = (φ1, φ2); (x, 1) for the line model.
    pub regressor: [Rational; 2],
    /// The bounds on φ·θ.
    pub bounds: Bounds,
}

/// The bounds of a reading on φ·θ.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Bounds {
    /// The value φ·θ lies within ε of y.
    Around {
        /// y.
        response: Rational,
        /// ε; not negative.
        epsilon: Rational,
    },
    /// The value φ·θ lies between two values, of which one may be missing. The lower one may be above the upper one:
    /// no θ agrees then.
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
    #[allow(
        clippy::panic,
        reason = "a mistake of the caller, which asks for what kind of bound there is first"
    )]
    pub(crate) fn y_and_epsilon(&self) -> (&Rational, &Rational) {
        match &self.bounds {
            Bounds::Around { response, epsilon } => (response, epsilon),
            Bounds::Between { .. } => panic!("bounds that do not come from y"),
        }
    }

    /// Returns what least squares takes for y: y if there is one, else the middle of both bounds. Exact.
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

    /// Returns whether there are a lower and an upper bound.
    pub fn is_two_sided(&self) -> bool {
        match &self.bounds {
            Bounds::Around { .. } => true,
            Bounds::Between { lower, upper, .. } => lower.is_some() && upper.is_some(),
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
