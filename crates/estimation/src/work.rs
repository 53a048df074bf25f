//! How much work the long numbers of a problem make.

use boundfit_exact::{Rational, TooMuchWork, Work};

use crate::meaning::Model;
use crate::measurement::Bounds;
use crate::problem::Problem;

impl Problem {
    /// The work that computing a fit takes as far as numbers are long, estimated from their lengths: each reading's regressors,
    /// response and bounds, the conditions, and in each of these rows some other numbers that meet all of them. Cost: linear.
    pub fn work(&self, others: &[&Rational]) -> Work {
        let mut work = Work::default();
        let of_others: u64 = others.iter().map(|number| number.bits()).sum();
        let of_some = |number: &Option<Rational>| number.as_ref().map_or(0, Rational::bits);
        for reading in self.measurements.kept() {
            let [first, second] = &reading.regressor;
            let of_bounds = match &reading.bounds {
                Bounds::Around { response, epsilon } => response.bits() + epsilon.bits(),
                Bounds::Between { lower, upper, response } => {
                    of_some(lower) + of_some(upper) + of_some(response)
                }
            };
            work.add_bits(reading.row, first.bits() + second.bits() + of_bounds + of_others);
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
