//! The readings as machine integers.

use boundfit_exact::{Rational, Scaled};

use crate::meaning::{ErrorBound, Model};
use crate::measurement::Measurement;
use crate::measurements::Measurements;

/// The columns of the readings in memory, each on a unit of its own. Numbers that are the same for every reading,
/// such as φ2 of a line and a uniform ε, have no column.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub(crate) phi1: Scaled<i64>,
    pub(crate) phi2: Option<Scaled<i64>>,
    pub(crate) response: Scaled<i64>,
    pub(crate) epsilon: Option<Scaled<i64>>,
}

impl Grid {
    /// The readings as integers; `None` when a column does not fit, or a reading does not say how far from y it may be.
    /// Cost: linear.
    pub(crate) fn new(measurements: &Measurements) -> Option<Self> {
        let rows = measurements.kept();
        let of = |number: fn(&Measurement) -> &Rational| Scaled::of_numbers(rows.iter().map(number));
        if !measurements.is_around_y() {
            return None;
        }
        let phi2 = match measurements.model() {
            Model::Line { .. } => None,
            Model::TwoRegressors { .. } => Some(of(|row| &row.regressor[1])?),
        };
        let epsilon = match measurements.error_bound() {
            ErrorBound::Uniform(_) => None,
            ErrorBound::Column(_) | ErrorBound::Interval { .. } | ErrorBound::Law(_) => {
                Some(of(|row| row.y_and_epsilon().1)?)
            }
        };
        let response = of(|row| row.y_and_epsilon().0)?;
        Some(Grid { phi1: of(|row| &row.regressor[0])?, phi2, response, epsilon })
    }
}
