//! The bounds of readings at a factor.

use boundfit_exact::Rational;
use boundfit_geometry::grid::EnvelopeSieve;
use boundfit_geometry::{Constraint, HalfPlane, Inequality, System, envelope};

use crate::condition::Condition;
use crate::fps::conditions_by_name;
use crate::growing::Growing;
use crate::least_growth::{LeastGrowth, least_growth};
use crate::measurement::Measurement;

/// The choice of the bounds of readings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Scale {
    /// The bounds as the readings state them.
    AsStated,
    /// A multiple of the half width about the middle; as stated where a reading has no middle.
    Times(Rational),
    /// All at this distance from the middle.
    Within(Rational),
}

impl Scale {
    /// The least factor on the bounds of some readings, and what it makes of them; `None` when none leaves anything. Exact.
    pub(crate) fn least<'a>(
        rows: impl Iterator<Item = &'a Measurement>,
        is_uniform: bool,
        conditions: &[Condition],
    ) -> Option<Self> {
        Scale::least_at(rows, is_uniform, conditions).map(|(scale, _)| scale)
    }

    /// [`Scale::least`], and a point that is left. Exact.
    pub(crate) fn least_at<'a>(
        rows: impl Iterator<Item = &'a Measurement>,
        is_uniform: bool,
        conditions: &[Condition],
    ) -> Option<(Self, [Rational; 2])> {
        match least_growth(&Growing::of_rows(rows, is_uniform).with(conditions).inequalities) {
            LeastGrowth::From { t, theta, .. } if is_uniform => Some((Scale::Within(t), theta)),
            LeastGrowth::From { t, theta, .. } => Some((Scale::Times(t), theta)),
            LeastGrowth::Never => None,
        }
    }

    /// Returns whether the bounds of these readings at this scale leave something. Exact.
    pub(crate) fn is_enough<'a>(
        &self,
        rows: impl Iterator<Item = &'a Measurement>,
        conditions: &[Condition],
    ) -> bool {
        let bounds = rows.flat_map(|row| self.half_planes(row));
        let system: System = bounds.chain(conditions_by_name(conditions).map(|(_, own)| own)).collect();
        !envelope::intersect(&system).is_empty()
    }

    /// The lower and the upper bound of a reading. Exact.
    pub(crate) fn bounds(&self, reading: &Measurement) -> [Option<Rational>; 2] {
        let stated = || [reading.lower(), reading.upper()];
        if matches!(self, Scale::AsStated) {
            return stated();
        }
        let both = reading.middle().zip(reading.half_width());
        let Some((middle, half_width)) = both.filter(|(_, own)| !own.is_negative()) else { return stated() };
        let reach = match self {
            Scale::AsStated => half_width.into_owned(),
            Scale::Times(factor) => half_width.as_ref() * factor,
            Scale::Within(epsilon) => epsilon.clone(),
        };
        [Some(middle.as_ref() - &reach), Some(middle.as_ref() + reach)]
    }

    /// The half-planes of a reading, its upper bound first. Exact.
    pub(crate) fn half_planes(&self, reading: &Measurement) -> impl Iterator<Item = Inequality> + use<> {
        let [lower, upper] = self.bounds(reading);
        let [phi1, phi2] = reading.regressor.clone();
        let below = lower.map(|bound| Inequality::new(-&phi1, -&phi2, -bound));
        let above = upper.map(|bound| Inequality::new(phi1, phi2, bound));
        above.into_iter().chain(below)
    }

    /// Returns what the bounds of readings say about the plane, and for each which reading it is of, by position. Exact.
    pub(crate) fn constraints<'a>(
        &self,
        readings: impl Iterator<Item = &'a Measurement>,
    ) -> (Vec<usize>, Vec<Constraint>) {
        let both = |(position, reading)| {
            self.half_planes(reading).map(move |inequality| (position, inequality.constraint()))
        };
        readings.enumerate().flat_map(both).unzip()
    }

    /// Returns the filter that these readings make. Cost: O(n log n).
    pub(crate) fn sieve<'a>(&self, readings: impl Iterator<Item = &'a Measurement>) -> EnvelopeSieve {
        let half_plane = |constraint: Constraint| match constraint {
            Constraint::HalfPlane(half_plane) => Some(half_plane),
            Constraint::Always | Constraint::Never => None,
        };
        let (_, constraints) = self.constraints(readings);
        EnvelopeSieve::new(&constraints.into_iter().filter_map(half_plane).collect::<Vec<HalfPlane>>())
    }
}
