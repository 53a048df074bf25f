//! The amount of work that the long numbers of a problem cause.

use boundfit_exact::{Rational, TooMuchWork, Work};

use crate::meaning::Model;
use crate::measurement::Bounds;
use crate::problem::Problem;

impl Problem {
    /// Estimates the work of a fit from the lengths of its numbers: each reading's regressors, response and bounds,
    /// and the conditions. Each of these rows also meets some other numbers, given here. Cost: linear.
    pub fn work(&self, others: &[&Rational]) -> Work {
        let mut work = Work::default();
        for reading in self.measurements.kept() {
            let [first, second] = &reading.regressor;
            let bounds: [Option<&Rational>; 3] = match &reading.bounds {
                Bounds::Around { response, epsilon } => [Some(response), Some(epsilon), None],
                Bounds::Between { lower, upper, response } => {
                    [lower.as_ref(), upper.as_ref(), response.as_ref()]
                }
            };
            let numbers = [first, second].into_iter().chain(bounds.into_iter().flatten());
            work.add(reading.row, numbers.chain(others.iter().copied()));
        }
        for condition in &self.conditions {
            let inequality = condition.inequality();
            work.add(0, inequality.a.iter().chain([&inequality.b]));
        }
        work
    }

    /// Refuses what does so many times the work of a fit, if that takes more than this limit. Every answer about a problem is
    /// preceded by this check. Cost: that of [`Problem::work`].
    ///
    /// # Errors
    /// When it does.
    pub fn check_work(&self, times: u64, limit: u64) -> Result<(), TooMuchWork> {
        self.work(&[]).check(times * self.looks(), limit)
    }

    /// Returns how much more work the least bound takes than that of a line under one bound: it comes from cutting planes then.
    pub fn looks(&self) -> u64 {
        let is_line = matches!(self.measurements.model(), Model::Line { .. });
        if is_line && self.measurements.error_bound().is_uniform() { 1 } else { 4 }
    }
}
