//! Least squares from sums.

use boundfit_exact::{Interval, Rational};

use super::{NoEui, Reduction};
use crate::least_squares::{LeastSquares, SingularRegressors};
use crate::measurements::ErrorBound;

impl LeastSquares {
    /// The estimate for a line from the sums over its readings. Exact. Cost: constant.
    ///
    /// # Errors
    /// With fewer than two distinct x.
    pub fn of_reduction(reduction: &Reduction, error_bound: &ErrorBound) -> Result<Self, SingularRegressors> {
        let sums = &reduction.sums;
        let count = Rational::from(sums.count);
        let determinant = &count * &sums.xx - &sums.x * &sums.x;
        let solved = |numerator: Rational| numerator.checked_div(&determinant).ok_or(SingularRegressors);
        let theta = [
            solved(&count * &sums.xy - &sums.x * &sums.y)?,
            solved(&sums.xx * &sums.y - &sums.x * &sums.xy)?,
        ];
        let eui = match (&reduction.spread, error_bound) {
            (Err(reason), _) => Err(*reason),
            // Bounds that differ from reading to reading have no spread.
            (Ok(_), ErrorBound::PerRow(_)) => Err(NoEui::Reduced),
            (Ok(spread), ErrorBound::Uniform(epsilon)) => {
                let weights = spread.absolute_weights(sums);
                let interval = |j: usize| {
                    let radius = solved(&weights[j] * epsilon)?;
                    Interval::around(&theta[j], &radius).ok_or(SingularRegressors)
                };
                Ok([interval(0)?, interval(1)?])
            }
        };
        Ok(LeastSquares { theta, eui })
    }
}
