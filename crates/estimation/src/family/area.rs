//! The area of a family's sets between two breakpoints.

use std::borrow::Cow;

use boundfit_exact::{Rational, Sign};
use boundfit_geometry::{Measure, Measures, Point, RegionKind};

/// The area of a polygon whose corners move along lines, as `constant + slope·s + quadratic·s²`. Each coefficient is a sum over
/// all corners, which is added up only as far as it is asked for.
///
/// That of s² is the area that the slopes of the corners go around, the constant that of the corners at s = 0; and all three add
/// up to that of the corners at s = 1.
#[derive(Debug)]
pub struct MovingArea {
    at_zero: Measures<'static>,
    at_one: Measures<'static>,
    of_slopes: Measures<'static>,
}

impl MovingArea {
    pub(super) fn new(at_zero: Vec<Point>, at_one: Vec<Point>, slopes: Vec<Point>) -> Self {
        let [at_zero, at_one, of_slopes] = [at_zero, at_one, slopes]
            .map(|corners| Measures::of(RegionKind::Polygon, corners.into_iter().map(Cow::Owned).collect()));
        MovingArea { at_zero, at_one, of_slopes }
    }

    /// The value at s = 0.
    pub fn constant(&self) -> Measure<'_> {
        Measure::sum_of_areas(vec![(&self.at_zero, Sign::Positive)])
    }

    /// The coefficient of s.
    pub fn slope(&self) -> Measure<'_> {
        let others = [&self.at_zero, &self.of_slopes].map(|measures| (measures, Sign::Negative));
        Measure::sum_of_areas([(&self.at_one, Sign::Positive)].into_iter().chain(others).collect())
    }

    /// The coefficient of s².
    pub fn quadratic(&self) -> Measure<'_> {
        Measure::sum_of_areas(vec![(&self.of_slopes, Sign::Positive)])
    }

    /// The area at s. Exact.
    pub fn at(&self, s: &Rational) -> Rational {
        self.constant().exact() + (self.slope().exact() + self.quadratic().exact() * s) * s
    }
}
