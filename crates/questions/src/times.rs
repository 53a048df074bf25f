//! The cost of each question relative to a fit, as far as long numbers are concerned. It is the work for readings of
//! thousands of digits, divided by the work of a fit. [`Problem::work`] times one of these is what is to be refused
//! where it is too much.

use boundfit_estimation::{Measurement, Problem};
use boundfit_exact::TooMuchWork;

/// A fit, or one answer about a linear program.
pub const FIT: u64 = 1;
/// The sets for a range of factors.
pub const SWEEP: u64 = 4;
/// A few products for each value that is asked about.
pub const PREDICT: u64 = 2;
/// The statuses of all readings: the set, that of all readings without those that decide, and the values at each.
pub const STATUS: u64 = 6;
/// The minimax lines of three characteristics, each in general and through a point.
pub const LINEARITY: u64 = 6;
/// The runs that fit, or windows: every reading comes and goes, and what is left is asked for places between.
pub const RANGE: u64 = 8;
/// A fit, and the sums over the corners of the set at three x.
pub const NEXT: u64 = 4;
/// Sets left without some readings; looking at all [crossings](CROSSINGS) of bounds comes on top.
const OUTLIERS: u64 = 8;
/// The cost of all crossings of the bounds of a reading, which are sorted, relative to a fit of all readings but one.
const CROSSINGS: u64 = 4;
/// Both sides of lines under errors in x, and the steps to the least factor.
pub const X_ERRORS: u64 = 16;
/// The bisection of the least factor under errors in x, of every word that is not short.
pub const X_ERROR_STEPS: u64 = 135;

/// Refuses to look for outliers, which is done where any two bounds cross, if that takes more than this limit.
///
/// # Errors
/// When it does.
pub fn check_outliers(problem: &Problem, limit: u64) -> Result<(), TooMuchWork> {
    let readings = problem.measurements.kept().len() as u64;
    let work = problem.work(&[]);
    work.check((OUTLIERS + readings) * problem.looks(), limit)?;
    work.of_leaving_out_each(readings).check(CROSSINGS, limit)
}

/// Returns about how many bits the numbers of a corner of the set have, from which predictions are taken: twice the
/// bits of the longest reading.
pub fn bits_of_corner(problem: &Problem) -> u64 {
    let bits = |reading: &Measurement| {
        let ends = [reading.lower(), reading.upper()].into_iter().flatten();
        ends.map(|end| end.bits()).max().unwrap_or(0) + reading.regressor[0].bits()
    };
    2 * problem.measurements.kept().iter().map(bits).max().unwrap_or(0)
}
