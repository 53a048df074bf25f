//! The worst of many errors.

use boundfit_exact::Rational;
use boundfit_lp::{MOST_ULPS, Printed, is_below_binary64, ulp};

use super::finding::{Aspect, Excuse, Fault, Finding, Tolerances, Worth};

/// One error.
pub(super) struct Measured {
    /// The size of the error; 0 where nothing is wrong.
    pub(super) error: Rational,
    /// The part of the error that rounding explains.
    pub(super) rounding: Rational,
    /// The measure of the error; positive.
    pub(super) scale: Rational,
    /// The line to blame.
    pub(super) line: usize,
    pub(super) fault: Fault,
    pub(super) excuse: Option<Excuse>,
}

/// The worst of the errors met, and what excuses all of them.
pub(super) struct Measure<'a> {
    tolerances: &'a Tolerances,
    worth: Worth,
    error: Rational,
    relative: Rational,
    worst: Option<(usize, Fault)>,
    excuse: Option<Excuse>,
}

impl<'a> Measure<'a> {
    pub(super) fn new(tolerances: &'a Tolerances) -> Self {
        Measure {
            tolerances,
            worth: Worth::Exact,
            error: Rational::zero(),
            relative: Rational::zero(),
            worst: None,
            excuse: None,
        }
    }

    pub(super) fn take(&mut self, measured: Measured) {
        let Measured { error, rounding, scale, line, fault, excuse } = measured;
        if error.is_zero() {
            return;
        }
        let relative = error.checked_div(&scale).unwrap_or_else(Rational::one);
        let worth = if error <= rounding {
            Worth::Rounded
        } else if relative <= self.tolerances.relative {
            Worth::WithinTolerance
        } else {
            Worth::Refuted
        };
        if let Some(excuse) = excuse {
            self.excuse = Some(self.excuse.take().unwrap_or_default().or(excuse));
        }
        if self.worst.is_none() || (worth, &relative) > (self.worth, &self.relative) {
            (self.worth, self.error, self.relative) = (worth, error, relative);
            self.worst = Some((line, fault));
        }
    }

    /// Returns what was found. `line` is to blame where nothing is wrong.
    pub(super) fn finding(self, aspect: Aspect, line: usize) -> Finding {
        let (line, fault) = self.worst.map_or((line, None), |(line, fault)| (line, Some(fault)));
        Finding {
            aspect,
            worth: self.worth,
            line,
            error: Some(self.error),
            relative: Some(self.relative),
            fault,
            is_negated: false,
            excuse: self.excuse,
        }
    }
}

/// Returns how far the number that was meant may be from the one that is given.
pub(super) fn rounding(printed: &Printed, tolerances: &Tolerances) -> Rational {
    let reach = if tolerances.digits_as_printed { printed.reach() } else { Rational::zero() };
    // Binary64 has no number that small: nothing was rounded to it.
    let ulps = ulp(&printed.value).filter(|_| !is_below_binary64(&printed.value));
    let ulps = ulps.map(|ulp| ulp * Rational::from(MOST_ULPS));
    reach.max(ulps.unwrap_or_default())
}
