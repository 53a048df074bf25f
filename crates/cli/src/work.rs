//! Refusing what would take too much exact arithmetic, before it is done.

use boundfit_estimation::{Model, Problem};
use boundfit_exact::{Foreign, Limit, Rational, Work};

use crate::arguments::LimitArguments;
use crate::exit::Failure;

/// How often a command does what a fit does, as far as long numbers are concerned: what it takes for readings of thousands of
/// digits, divided by what `fit` takes.
pub(crate) mod times {
    /// A fit, or one answer about a linear program.
    pub(crate) const FIT: u64 = 1;
    /// Rows on a common denominator, written with all their digits.
    pub(crate) const CONVERT: u64 = 2;
    /// A region with its redundant rows; a model with judged solutions.
    pub(crate) const POLYGON: u64 = 2;
    /// The sets for a range of factors.
    pub(crate) const SWEEP: u64 = 4;
    /// Linear programs, and the exact simplex that judges their answers.
    pub(crate) const CHECK: u64 = 4;
    /// A few products for each value.
    pub(crate) const PREDICT: u64 = 2;
    /// The minimax lines of three characteristics, each in general and through a point.
    pub(crate) const LINEARITY: u64 = 6;
    /// The runs that fit, or windows: every reading comes and goes, and what is left is asked for places between.
    pub(crate) const RANGE: u64 = 8;
    /// Sets left without some readings; looking at all crossings of bounds comes on top.
    pub(crate) const OUTLIERS: u64 = 8;
    /// Both sides of lines under errors in x, and the steps to the least factor.
    pub(crate) const X_ERRORS: u64 = 16;
    /// The steps to the least factor under errors in x, in numbers with a square root, of every word that is not short.
    pub(crate) const X_ERROR_STEPS: u64 = 135;
    /// A figure; all of them are six.
    pub(crate) const PLOT: u64 = 8;
    /// The statuses of all readings: the set, that of all readings without those that decide, and the values at each.
    pub(crate) const STATUS: u64 = 6;
    /// A page; leaving out each reading comes on top.
    pub(crate) const LESSON: u64 = 24;
}

/// Refuses a problem.
pub(crate) fn refuse_long_problem(
    file: Foreign<&str>,
    problem: &Problem,
    times: u64,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    refuse_long(file, &problem.work(&[]), times * looks(problem), limits)
}

/// Refuses a lesson about a problem, which leaves out each reading in turn.
pub(crate) fn refuse_long_lesson(
    file: Foreign<&str>,
    problem: &Problem,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    let readings = problem.measurements.kept().len() as u64;
    refuse_long_problem(file, problem, times::LESSON + readings, limits)?;
    refuse_long(file, &problem.work(&[]).of_leaving_out_each(readings), 1, limits)
}

/// Refuses the proof of the statuses of a problem, which has the set without each reading that decides.
pub(crate) fn refuse_long_status_proof(
    file: Foreign<&str>,
    problem: &Problem,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    let readings = problem.measurements.kept().len() as u64;
    refuse_long(file, &problem.work(&[]).of_leaving_out_each(readings), 1, limits)
}

/// How much more than of a line under one bound the least bound of a problem takes, which comes from cutting planes then.
fn looks(problem: &Problem) -> u64 {
    let is_line = matches!(problem.measurements.model(), Model::Line { .. });
    if is_line && problem.measurements.error_bound().is_uniform() { 1 } else { 4 }
}

/// How much more than a fit of all readings but one takes it is to look at all crossings of the bounds of a reading, which are put
/// in order.
const CROSSINGS: u64 = 4;

/// Refuses outliers of a problem, which are looked for where any two bounds cross.
pub(crate) fn refuse_long_outliers(
    file: Foreign<&str>,
    problem: &Problem,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    let readings = problem.measurements.kept().len() as u64;
    refuse_long_problem(file, problem, times::OUTLIERS + readings, limits)?;
    refuse_long(file, &problem.work(&[]).of_leaving_out_each(readings), CROSSINGS, limits)
}

/// Refuses the sets of a problem for factors up to this one.
pub(crate) fn refuse_long_sweep(
    file: Foreign<&str>,
    problem: &Problem,
    most: &Rational,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    refuse_long(file, &problem.work(&[most]), times::SWEEP * looks(problem), limits)
}

/// Refuses so many times this work.
pub(crate) fn refuse_long(
    file: Foreign<&str>,
    work: &Work,
    times: u64,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    let refused = work.check(times, limits.sizes().work);
    refused
        .map_err(|problem| Failure::data(format_args!("{file}: {problem}; {} raises it", Limit::Work.flag())))
}

/// Refuses a text that has more, or longer, numbers with exponents than can be computed with.
pub(crate) fn refuse_long_text(
    file: Foreign<&str>,
    text: &str,
    limits: &LimitArguments,
) -> Result<(), Failure> {
    refuse_long(file, &Work::of_text(text, limits.number().exponent), times::FIT, limits)
}
