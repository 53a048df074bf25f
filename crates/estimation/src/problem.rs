//! A problem: readings and conditions that are fitted.

use boundfit_exact::{Limits, Rational, Reading};

use crate::condition::{Condition, ParseConditionError};
use crate::line_form::LineForm;
use crate::meaning::{Model, MultipleOfLeast};
use crate::measurements::Measurements;
use crate::minimax::Minimax;

/// A problem: readings and conditions that are fitted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The readings.
    pub measurements: Measurements,
    /// Prior knowledge about θ.
    pub conditions: Vec<Condition>,
}

impl Problem {
    /// The readings, and nothing known beside them.
    pub fn new(measurements: Measurements) -> Self {
        Problem { measurements, conditions: Vec::new() }
    }

    /// Adds a linear inequality or equation that the parameters are known to satisfy, such as `2*theta1 - theta2 <= 1/3` or
    /// `theta2 = 0`, with its numbers taken exactly as written. [`Condition::parse`] says what is understood.
    ///
    /// # Errors
    /// With the place where the text stops making sense.
    pub fn condition(mut self, text: &str) -> Result<Self, ParseConditionError> {
        self.conditions.push(Condition::parse(text, Reading::Decimal, &Limits::default())?);
        Ok(self)
    }

    /// The problem of lines through the origin, y = θ1·x + e: `theta2 = 0` becomes its last condition, unless it is one already,
    /// and least squares has one parameter. Nothing changes for a model with two regressors, which has no constant.
    pub fn through_origin(mut self) -> Self {
        if matches!(self.measurements.model(), Model::TwoRegressors { .. }) {
            return self;
        }
        let form = self.measurements.line_form().clone();
        self.measurements = self.measurements.with_form(LineForm { through_origin: true, ..form });
        let no_intercept = Condition::no_intercept();
        if !self.conditions.contains(&no_intercept) {
            self.conditions.push(no_intercept);
        }
        self
    }

    /// The problem with so many times its least error bound ε_min as the bound on every error, in the place of the bound that
    /// it has. Nothing changes where no bound, however large, leaves anything, since the conditions contradict each other, or
    /// where the readings have no uniform bound. Exact. Cost: that of ε_min, O(N log N).
    ///
    /// Nothing is guaranteed by such a bound unless errors truly are no larger: it comes from the readings themselves.
    pub fn with_multiple_of_least(self, factor: &Rational) -> Self {
        let Problem { measurements, conditions } = self;
        let measurements = match Minimax::new(&measurements, &conditions) {
            Some(Minimax { least, .. }) if measurements.error_bound().is_uniform() => {
                measurements.within_multiple(MultipleOfLeast { factor: factor.clone(), least })
            }
            _ => measurements,
        };
        Problem { measurements, conditions }
    }
}
