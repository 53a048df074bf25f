//! The readings as machine integers.

use boundfit_exact::{Column, Rational, Scaled};

use crate::halves::Halves;
use crate::meaning::{ErrorBound, Model};
use crate::measurement::{Bounds, Measurement};
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
    /// The readings as integers: y and the error bound, or the middles and half widths of intervals. `None` when a column does not
    /// fit, or a reading has neither. Cost: linear.
    pub(crate) fn new(measurements: &Measurements) -> Option<Self> {
        let rows = measurements.kept();
        let of = |number: fn(&Measurement) -> &Rational| Scaled::of_numbers(rows.iter().map(number));
        let phi2 = || match measurements.model() {
            Model::Line { .. } => Some(None),
            Model::TwoRegressors { .. } => of(|row| &row.regressor[1]).map(Some),
        };
        let (response, epsilon) = match measurements.error_bound() {
            ErrorBound::Interval { .. } if !measurements.is_around_y() => {
                let [middles, half_widths] = middles_and_half_widths(rows)?;
                (middles, Some(half_widths))
            }
            _ if !measurements.is_around_y() => return None,
            ErrorBound::Uniform(_) => (of(|row| row.y_and_epsilon().0)?, None),
            ErrorBound::Column(_) | ErrorBound::Interval { .. } | ErrorBound::Law(_) => {
                (of(|row| row.y_and_epsilon().0)?, Some(of(|row| row.y_and_epsilon().1)?))
            }
        };
        Some(Grid { phi1: of(|row| &row.regressor[0])?, phi2: phi2()?, response, epsilon })
    }
}

/// The middles and half widths of intervals without y; `None` unless each has two ends that do not cross, and machine integers hold
/// these.
fn middles_and_half_widths(rows: &[Measurement]) -> Option<[Scaled<i64>; 2]> {
    let mut lower = Vec::with_capacity(rows.len());
    let mut upper = Vec::with_capacity(rows.len());
    for row in rows {
        let Bounds::Between { lower: Some(low), upper: Some(high), response: None } = &row.bounds else {
            return None;
        };
        lower.push(low);
        upper.push(high);
    }
    let column = |ends: Vec<&Rational>| Scaled::of_numbers(ends.into_iter()).map(Column::Narrow);
    let (lower, upper) = (column(lower)?, column(upper)?);
    let halves = Halves::between(&lower, &upper)?;
    match (halves.middles()?, halves.widths()?) {
        (Column::Narrow(middles), Column::Narrow(widths)) if widths.counts().iter().all(|own| *own >= 0) => {
            Some([middles, widths])
        }
        _ => None,
    }
}
