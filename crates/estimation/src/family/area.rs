//! The area of a family's sets between two breakpoints.

use std::borrow::Cow;

use boundfit_exact::{Fraction, LongSum, Rational};
use boundfit_geometry::{Measure, Measures, Point, RegionKind};

/// The area of a polygon whose corners move along lines, as `constant + slope·s + quadratic·s²`. Each coefficient is a sum over
/// corners, which is added up only as far as it is asked for.
#[derive(Debug)]
pub struct MovingArea<'a> {
    at_zero: Measures<'static>,
    growth: &'a AreaGrowth,
}

/// The growth of an area with s: `slope + 2·quadratic·s`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct AreaGrowth {
    pub(super) slope: LongSum,
    pub(super) quadratic: LongSum,
}

impl AreaGrowth {
    /// The sum of multiples of coordinates, each given with their value at s = 0 and their growth per unit of s.
    pub(super) fn sum(terms: &[(Rational, Rational)]) -> Self {
        AreaGrowth {
            slope: terms.iter().map(|(constant, _)| Fraction::from(constant)).collect(),
            quadratic: terms.iter().map(|(_, slope)| Fraction::from(&slope.half())).collect(),
        }
    }
}

impl<'a> MovingArea<'a> {
    /// Returns the area with the corners at s = 0, which go around a polygon.
    pub(super) fn new(at_zero: Vec<Point>, growth: &'a AreaGrowth) -> Self {
        let corners = at_zero.into_iter().map(Cow::Owned).collect();
        MovingArea { at_zero: Measures::of(RegionKind::Polygon, corners), growth }
    }

    /// The value at s = 0.
    pub fn constant(&self) -> Measure<'_> {
        self.at_zero.polygon_area()
    }

    /// The coefficient of s.
    pub fn slope(&self) -> Measure<'_> {
        Measure::of(&self.growth.slope)
    }

    /// The coefficient of s².
    pub fn quadratic(&self) -> Measure<'_> {
        Measure::of(&self.growth.quadratic)
    }
}
