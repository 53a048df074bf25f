//! Refusing what would take too much exact arithmetic, before it is done.

use boundfit_estimation::Problem;
use boundfit_exact::{Foreign, Limit, TooMuchWork, Work};
use boundfit_lesson::check_work;
use boundfit_questions::times::check_outliers;

use crate::exit::{Failure, raises};
use crate::options::LimitArguments;

/// The cost of each command relative to a fit, as far as long numbers are concerned. It is the work for readings of
/// thousands of digits, divided by the work of `fit`.
pub(crate) mod times {
    pub(crate) use boundfit_questions::times::FIT;

    /// Rows on a common denominator, written with all their digits.
    pub(crate) const CONVERT: u64 = 2;
    /// A figure; all of them are six.
    pub(crate) const PLOT: u64 = 8;
}

/// Refuses a problem.
pub(crate) fn refuse_long_problem(
    file: Foreign<&str>,
    problem: &Problem,
    times: u64,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    refused(file, problem.check_work(times, limits.sizes().work))
}

/// Refuses a lesson about a problem.
pub(crate) fn refuse_long_lesson(
    file: Foreign<&str>,
    problem: &Problem,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    refused(file, check_work(problem, limits.sizes().work))
}

/// Refuses outliers of a problem, which are looked for where any two bounds cross.
pub(crate) fn refuse_long_outliers(
    file: Foreign<&str>,
    problem: &Problem,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    refused(file, check_outliers(problem, limits.sizes().work))
}

/// Refuses so many times this work.
pub(crate) fn refuse_long(
    file: Foreign<&str>,
    work: &Work,
    times: u64,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    refused(file, work.check(times, limits.sizes().work))
}

fn refused(file: Foreign<&str>, checked: Result<(), TooMuchWork>) -> Result<(), Failure> {
    checked.map_err(|problem| Failure::data(format_args!("{file}: {problem}; {}", raises(Limit::Work))))
}
