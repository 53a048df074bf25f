//! The family of sets under a common factor on all error bounds.

use boundfit_estimation::{Family, Fit, Problem};
use boundfit_exact::Rational;
use boundfit_report::SweepJson;

use crate::number::STYLE;

/// The sets from factor 0 up to 2, or to twice the factor at which the set is born when that is more.
pub(crate) fn sweep(problem: &Problem, fit: &Fit) -> SweepJson {
    let two = Rational::from(2);
    let error_bound = problem.measurements.error_bound();
    let least = fit.minimax.as_ref().and_then(|minimax| minimax.least_factor(error_bound));
    let to = two.clone().max(least.unwrap_or_default() * &two);
    SweepJson::new(problem, &Family::new(problem, Rational::zero(), to), &STYLE)
}
