//! The areas of a family without a sum over corners for each.

use std::collections::HashSet;
use std::sync::Arc;

use boundfit_exact::{Integer, Rational};
use boundfit_geometry::RegionKind;

use super::area::AreaGrowth;
use super::piece::Piece;

/// The areas of the polygons of a family whose corners share a short denominator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShortAreas {
    /// The constant, the coefficient of s and that of s² for each piece.
    pub pieces: Vec<Option<[Rational; 3]>>,
    /// The area at each breakpoint.
    pub breakpoints: Vec<Option<Rational>>,
}

impl ShortAreas {
    /// The areas of pieces, and at the breakpoints between them: each with its factor, and whether the set there is a polygon.
    pub(super) fn new<'a>(
        pieces: &[Piece],
        breakpoints: impl Iterator<Item = (&'a Rational, bool)>,
        digits: usize,
    ) -> Self {
        let bits = u32::try_from(digits).map_or(0, Integer::bits_of_power_of_ten);
        let common = common_denominator(pieces, bits / 2);
        // A triangle of two corners has the product of their denominators.
        let is_within = |s: &Rational| {
            common.as_ref().is_some_and(|common| 2 * (common.bits() + s.denominator().bits()) <= bits)
        };
        let is_short = |value: &Rational| value.bits() < bits;
        let mut areas: Vec<Option<[Rational; 3]>> = Vec::with_capacity(pieces.len());
        for piece in pieces {
            let before = areas.last().and_then(Option::as_ref);
            let own =
                is_within(&Rational::zero()).then(|| coefficients(piece, before, digits, bits)).flatten();
            areas.push(own.filter(|own| own.iter().all(is_short)));
        }
        let at = |(number, (s, is_polygon)): (usize, (&Rational, bool))| {
            let mut beside = [Some(number), number.checked_sub(1)].into_iter().flatten();
            let known = beside.find_map(|piece| areas.get(piece)?.as_ref());
            let [constant, slope, quadratic] = known.filter(|_| is_polygon && is_within(s))?;
            Some(constant + (slope + quadratic * s) * s).filter(is_short)
        };
        let breakpoints = breakpoints.enumerate().map(at).collect();
        ShortAreas { pieces: areas, breakpoints }
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

/// The common denominator of the coefficients of all corners; `None` where the denominator has more than `bits` bits.
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
