//! The fewest readings without which some parameters are left, where all together leave none.

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::MOST_WORK;
use boundfit_questions::times::check_outliers;
use boundfit_questions::{OutlierLimits, Outliers};
use serde::Serialize;

/// More ways than this are not offered.
const MOST_WAYS: usize = 12;
/// The limit on crossings, about a tenth of that of a question about outliers alone: the page is about more than
/// this.
const MOST_STEPS: u64 = 2_000_000;

#[derive(Debug, Serialize)]
pub(crate) struct OutliersJson {
    /// The least number of readings to leave out.
    least: usize,
    /// The readings to leave out, for each way that is offered.
    ways: Vec<Vec<usize>>,
    /// `true` if there is no other way.
    complete: bool,
}

/// The fewest readings to leave out; `None` where nothing has to be, where conditions alone contradict each other, and where it
/// takes too long to know. Exact.
pub(crate) fn outliers(problem: &Problem, fit: &Fit) -> Option<OutliersJson> {
    if !fit.is_empty() {
        return None;
    }
    // Long numbers may not take more than their share either.
    check_outliers(problem, MOST_WORK / 10).ok()?;
    let limits = OutlierLimits { sets: MOST_WAYS, steps: MOST_STEPS };
    let found = Outliers::new(problem, &limits).ok()?;
    let ways = found.pieces.into_iter().map(|piece| piece.rows).collect();
    Some(OutliersJson { least: found.least, ways, complete: found.is_complete })
}
