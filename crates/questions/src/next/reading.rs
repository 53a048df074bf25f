//! The next reading after those of a fit.

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::{Endpoint, Interval, Rational};

use super::{Best, Goal, Next};

/// The reliable effect of the next reading, with x as the data have it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NextReading {
    /// The error bound of the reading.
    pub epsilon: Rational,
    /// The range of x where the reading may leave the set as it is ([`Next::unsure`]).
    pub unsure: Option<Interval>,
    /// The range in which it is looked for, the lower end first: the one asked for, or that of the readings; `None` where that is
    /// not known.
    pub within: Option<[Rational; 2]>,
    /// The best x of the range for each goal; none without a range.
    pub best: Vec<Best>,
    /// The goals that are left out, since a number of theirs would be too long ([`Next::is_too_long`]).
    pub too_long: Vec<Goal>,
}

impl NextReading {
    /// Returns the reliable effect of the next reading of a line, within a range of x if one is asked for; `None`
    /// where the set is empty. Exact. Cost: O(n log n) for n vertices of the set.
    pub fn of(
        problem: &Problem,
        fit: &Fit,
        epsilon: &Rational,
        within: Option<&[Rational; 2]>,
        goals: &[Goal],
    ) -> Option<Self> {
        let next = Next::new(fit.fps.polyhedron(), epsilon.clone())?;
        let origin = &problem.measurements.line_form().x_origin;
        let counted = match within {
            Some(asked) => Some(asked.each_ref().map(|x| x - origin)),
            None => problem.measurements.range_of_x(),
        };
        let (too_long, goals): (Vec<Goal>, Vec<Goal>) =
            goals.iter().partition(|goal| next.is_too_long(**goal));
        let best = |[lower, upper]: &[Rational; 2]| -> Vec<Best> {
            goals.iter().map(|goal| moved(next.best(*goal, [lower, upper]), origin)).collect()
        };
        Some(NextReading {
            epsilon: epsilon.clone(),
            unsure: next.unsure().and_then(|unsure| {
                let end = |end: &Endpoint| end.value().map(|x| x + origin);
                Interval::new(end(unsure.lower()).into(), end(unsure.upper()).into())
            }),
            best: counted.as_ref().map(best).unwrap_or_default(),
            within: counted.map(|ends| ends.map(|x| x + origin)),
            too_long,
        })
    }

    /// The open intervals of x where it certainly makes the set smaller, ascending; an end without a number goes on.
    pub fn certain(&self) -> Vec<[Option<&Rational>; 2]> {
        let Some(unsure) = &self.unsure else { return vec![[None, None]] };
        let below = unsure.lower().value().map(|end| [None, Some(end)]);
        let above = unsure.upper().value().map(|end| [Some(end), None]);
        below.into_iter().chain(above).collect()
    }

    /// Returns whether the reading certainly makes the set smaller somewhere within the range.
    pub fn is_certain_within(&self) -> Option<bool> {
        let [lower, upper] = self.within.as_ref()?;
        let is_unsure = |x| self.unsure.as_ref().is_some_and(|unsure| unsure.contains(x));
        // Where it may leave the set as it is has no gaps.
        Some(!(is_unsure(lower) && is_unsure(upper)))
    }
}

/// The best x, counted from 0.
fn moved(best: Best, origin: &Rational) -> Best {
    Best { at: best.at.into_iter().map(|x| x + origin).collect(), ..best }
}
