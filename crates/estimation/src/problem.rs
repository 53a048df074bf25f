//! What is to be fitted.

use boundfit_exact::{Limits, Reading};

use crate::condition::{Condition, ParseConditionError};
use crate::fit::{Fit, fit};
use crate::measurements::Measurements;

/// What is to be fitted.
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

    /// Computes everything, as [`fit`](fn@fit) does.
    pub fn fit(&self) -> Fit {
        fit(self)
    }
}
