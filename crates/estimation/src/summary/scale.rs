//! The bounds of readings at a factor.

use boundfit_exact::Rational;
use boundfit_geometry::{Constraint, Inequality};

use crate::measurement::Measurement;

/// Which bounds of readings are meant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Scale {
    /// Those that they have.
    AsStated,
    /// About the middle, at a multiple of their half width; as stated where that has no meaning.
    Times(Rational),
    /// All at this distance from the middle.
    Within(Rational),
}

impl Scale {
    /// The lower and the upper bound of a reading. Exact.
    pub(crate) fn bounds(&self, reading: &Measurement) -> [Option<Rational>; 2] {
        let stated = || [reading.lower(), reading.upper()];
        let (Some(middle), Some(half_width)) = (reading.middle(), reading.half_width()) else {
            return stated();
        };
        let reach = match self {
            _ if half_width.is_negative() => return stated(),
            Scale::AsStated => return stated(),
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
    pub(super) fn constraints<'a>(
        &self,
        readings: impl Iterator<Item = &'a Measurement>,
    ) -> (Vec<usize>, Vec<Constraint>) {
        let both = |(position, reading)| {
            self.half_planes(reading).map(move |inequality| (position, inequality.constraint()))
        };
        readings.enumerate().flat_map(both).unzip()
    }
}
