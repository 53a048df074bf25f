//! One reading against a set.

use std::cmp::Ordering;

use boundfit_estimation::Measurement;
use boundfit_exact::{Interval, Rational};
use boundfit_geometry::Polyhedron;

/// The position of a reading with respect to a set that is not empty: the effect of adding it to the set.
///
/// With Υ the values of φ·θ over the set and both bounds of the reading, these follow from [leverage](Standing::leverage) ℓ
/// and [residual](Standing::residual) r. A reading without width, with one bound, or where Υ has no end, is judged by the two
/// intervals alone, in the same words.
///
/// Source: A. N. Bazhenov, *DataStatus* (2022); the object status plot of O. Ye. Rodionova, K. H. Esbensen and
/// A. L. Pomerantsev (2004), simple interval calculation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Status {
    /// |r| < 1 - ℓ: adding it changes nothing, and it has room to spare.
    Inner,
    /// |r| = 1 - ℓ: adding it changes nothing, and a bound of it is met with equality somewhere in the set.
    Boundary,
    /// 1 - ℓ < |r| ≤ 1 + ℓ: adding it cuts the set.
    Outer,
    /// Outer with ℓ > 1: a reading with such a bound would cut wherever it fell.
    StrictlyOuter,
    /// |r| > 1 + ℓ: adding it leaves nothing.
    Outlier,
}

impl Status {
    /// All of them, from the one that matters least.
    pub const ALL: [Status; 5] =
        [Status::Inner, Status::Boundary, Status::Outer, Status::StrictlyOuter, Status::Outlier];

    /// The name used in reports: `strictly outer` and so on.
    pub fn name(self) -> &'static str {
        match self {
            Status::Inner => "inner",
            Status::Boundary => "boundary",
            Status::Outer => "outer",
            Status::StrictlyOuter => "strictly outer",
            Status::Outlier => "outlier",
        }
    }
}

/// A reading against a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Standing {
    /// ℓ = rad Υ / rad y, how uncertain the prediction is beside the reading; `None` unless both are finite and the reading has
    /// a width.
    pub leverage: Option<Rational>,
    /// r = (mid y - mid Υ) / rad y; `None` where ℓ is.
    pub residual: Option<Rational>,
    /// The effect of adding the reading.
    pub status: Status,
}

impl Standing {
    /// A reading against a set; `None` when that is empty. Exact. Cost: logarithmic in the number of the set's vertices.
    pub fn against(reading: &Measurement, set: &Polyhedron) -> Option<Self> {
        Some(Standing::within(reading, &set.range(&reading.regressor)?))
    }

    /// A reading against the values that φ·θ takes over a set. Exact.
    ///
    /// ```
    /// use boundfit_estimation::Measurement;
    /// use boundfit_exact::{Interval, Rational};
    /// use boundfit_questions::{Standing, Status};
    ///
    /// let values = Interval::around(&Rational::from(10), &Rational::one()).unwrap();
    /// let reading = Measurement::around(1, [Rational::from(3), Rational::one()], 12.into(), 2.into());
    /// let standing = Standing::within(&reading, &values);
    /// assert_eq!(standing.leverage, Some(Rational::ratio(1, 2)));
    /// assert_eq!(standing.residual, Some(Rational::one()));
    /// assert_eq!(standing.status, Status::Outer);
    /// ```
    pub fn within(reading: &Measurement, values: &Interval) -> Self {
        let (lower, upper) = (reading.lower(), reading.upper());
        let ends = values.ends();
        let ratios = || {
            let half_width = reading.half_width().filter(|half_width| half_width.is_positive())?;
            let (least, most) = ends?;
            let leverage = (most - least).half().checked_div(&half_width)?;
            let middle = (most + least).half();
            let residual = (reading.middle()?.as_ref() - middle).checked_div(&half_width)?;
            Some((leverage, residual))
        };
        let (leverage, residual) = ratios().unzip();
        let status = by_intervals([lower.as_ref(), upper.as_ref()], values);
        Standing { leverage, residual, status }
    }

    /// 1 - ℓ - |r|: by how much, in half widths of the reading, it keeps clear of the set's bounds; negative where it cuts.
    /// `None` where there is no leverage.
    pub fn margin(&self) -> Option<Rational> {
        Some(Rational::one() - self.leverage.as_ref()? - self.residual.as_ref()?.abs())
    }
}

/// The relation of two intervals: the bounds of a reading, one of which may be missing, and the values over the set.
///
/// With both bounds and their distance positive, `lower < min Υ` and `max Υ < upper` is |r| < 1 - ℓ, and so on.
fn by_intervals([lower, upper]: [Option<&Rational>; 2], values: &Interval) -> Status {
    let (least, most) = (values.lower().value(), values.upper().value());
    let are_apart = |below: Option<&Rational>, above: Option<&Rational>| {
        below.zip(above).is_some_and(|(below, above)| below < above)
    };
    let is_impossible = are_apart(upper, lower);
    if is_impossible || are_apart(upper, least) || are_apart(most, lower) {
        return Status::Outlier;
    }
    // The room of the values within each bound: `Less` where they go beyond it.
    let room = |bound: Option<&Rational>, end: Option<&Rational>, is_upper: bool| match (bound, end) {
        (None, _) => Ordering::Greater,
        (Some(_), None) => Ordering::Less,
        (Some(bound), Some(end)) if is_upper => bound.cmp(end),
        (Some(bound), Some(end)) => end.cmp(bound),
    };
    match room(lower, least, false).min(room(upper, most, true)) {
        Ordering::Greater => Status::Inner,
        Ordering::Equal => Status::Boundary,
        Ordering::Less => {
            let width = lower.zip(upper).map(|(lower, upper)| upper - lower);
            let is_wider =
                width.is_some_and(|width| values.ends().is_none_or(|(least, most)| most - least > width));
            if is_wider { Status::StrictlyOuter } else { Status::Outer }
        }
    }
}
