//! The amount of work that the long numbers of a problem cause.

use std::borrow::Borrow;

use boundfit_exact::{Rational, TooMuchWork, Work};

use crate::meaning::Model;
use crate::measurement::{Bounds, Measurement};
use crate::problem::Problem;

impl Problem {
    /// Estimates the work of a fit from the lengths of its numbers: each reading's regressors, response and bounds,
    /// and the conditions. Each of these rows also meets some other numbers, given here. Cost: linear.
    pub fn work(&self, others: &[&Rational]) -> Work {
        let of_others: u64 = others.iter().map(|number| number.bits()).sum();
        // Readings on a grid take at most 504 bits: two numbers of 125 bits over 63, a bound of twice 63, and a 1.
        let is_short = self.measurements.on_grid().is_some() && Work::is_short(504 + of_others);
        self.work_of(if is_short { &[] } else { self.measurements.kept() }, of_others)
    }

    /// Estimates the work of a look at each reading that can be shown ([`Measurements::each_shown`](crate::Measurements::each_shown)),
    /// as [`Problem::work`] does. Cost: linear.
    pub fn work_of_shown(&self) -> Work {
        let mut work = self.work_of(self.measurements.each_shown(), 0);
        // A short file of many rows may have one long bound, which stands in each row: none of its words is free then.
        if let Some(bound) = self.measurements.error_bound().uniform()
            && !Work::is_short(bound.bits())
        {
            let mut of_bound = Work::default();
            (1..=self.measurements.shown()).for_each(|row| of_bound.add_bits(row, bound.bits()));
            work.append(of_bound.of_every_word());
        }
        work
    }

    fn work_of<R: Borrow<Measurement>>(&self, readings: impl IntoIterator<Item = R>, of_others: u64) -> Work {
        let mut work = Work::default();
        let of_some = |number: &Option<Rational>| number.as_ref().map_or(0, Rational::bits);
        for reading in readings {
            let Measurement { row, regressor: [first, second], bounds } = reading.borrow();
            let of_bounds = match bounds {
                Bounds::Around { response, epsilon } => response.bits() + epsilon.bits(),
                Bounds::Between { lower, upper, response } => {
                    of_some(lower) + of_some(upper) + of_some(response)
                }
            };
            work.add_bits(*row, first.bits() + second.bits() + of_bounds + of_others);
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
