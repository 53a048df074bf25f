//! The area of a family's sets between two breakpoints.

use std::borrow::Cow;
use std::collections::HashSet;
use std::sync::Arc;

use boundfit_exact::{Fraction, Integer, LongSum, Rational};
use boundfit_geometry::{Measure, Measures, Point, RegionKind};

use super::piece::Piece;
use super::{Breakpoint, Family};

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
    slope: LongSum,
    quadratic: LongSum,
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

/// The areas of the polygons of a family whose corners share a short denominator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShortAreas {
    /// The constant, the coefficient of s and that of s² for each piece.
    pub pieces: Vec<Option<[Rational; 3]>>,
    /// The area at each breakpoint.
    pub breakpoints: Vec<Option<Rational>>,
}

impl Family {
    /// The areas of the polygons of the family. Areas are continuous in s, so that one sum over corners gives those of all pieces. `None`
    /// where a sum may have a denominator of more than so many digits, and for sets of other kinds. Exact. Cost: a common divisor for each
    /// corner that moves along its own line.
    pub fn short_areas(&self, digits: usize) -> ShortAreas {
        let bits = u32::try_from(digits).map_or(0, Integer::bits_of_power_of_ten);
        let common = common_denominator(self.pieces(), bits / 2);
        // A triangle of two corners has the product of their denominators.
        let is_within = |s: &Rational| {
            common.as_ref().is_some_and(|common| 2 * (common.bits() + s.denominator().bits()) <= bits)
        };
        let is_short = |value: &Rational| value.bits() < bits;
        let mut pieces: Vec<Option<[Rational; 3]>> = Vec::with_capacity(self.pieces().len());
        for piece in self.pieces() {
            let before = pieces.last().and_then(Option::as_ref);
            let own =
                is_within(&Rational::zero()).then(|| coefficients(piece, before, digits, bits)).flatten();
            pieces.push(own.filter(|own| own.iter().all(is_short)));
        }
        let at = |(number, breakpoint): (usize, &Breakpoint)| {
            let s = &breakpoint.s;
            let is_polygon = breakpoint.section.kind == RegionKind::Polygon;
            let mut beside = [Some(number), number.checked_sub(1)].into_iter().flatten();
            let known = beside.find_map(|piece| pieces.get(piece)?.as_ref());
            let [constant, slope, quadratic] = known.filter(|_| is_polygon && is_within(s))?;
            Some(constant + (slope + quadratic * s) * s).filter(is_short)
        };
        let breakpoints = self.breakpoints().iter().enumerate().map(at).collect();
        ShortAreas { pieces, breakpoints }
    }
}

/// The area of a piece, from that of the piece before it where it is known: where one ends and the other starts, they are equal.
fn coefficients(
    piece: &Piece,
    before: Option<&[Rational; 3]>,
    digits: usize,
    bits: u64,
) -> Option<[Rational; 3]> {
    if piece.kind != RegionKind::Polygon {
        return None;
    }
    let AreaGrowth { slope, quadratic } = &piece.growth;
    let [slope, quadratic] = [slope, quadratic].map(|sum| sum.total_within(bits).map(Rational::from));
    let (slope, quadratic) = slope.zip(quadratic)?;
    let constant = match before {
        Some([constant, slope_before, quadratic_before]) => {
            constant + (slope_before - &slope + (quadratic_before - &quadratic) * &piece.from) * &piece.from
        }
        None => piece.area()?.constant().exact_within(digits)?,
    };
    Some([constant, slope, quadratic])
}

/// The common denominator of the coefficients of all corners, where it has at most so many bits.
fn common_denominator(pieces: &[Piece], bits: u64) -> Option<Integer> {
    let (mut seen, mut common) = (HashSet::new(), Integer::one());
    for corner in
        pieces.iter().flat_map(|piece| &piece.vertices).filter(|corner| seen.insert(Arc::as_ptr(corner)))
    {
        for number in corner.theta.iter().flat_map(|own| [&own.constant, &own.slope]) {
            common = common.lcm(&number.denominator());
        }
        if common.bits() > bits {
            return None;
        }
    }
    Some(common)
}
