//! The two envelopes of a line's bounds, and where the gap between them opens and closes.
//!
//! A reading at (x, y) bounds θ2 from above by y + ε - θ1·x and from below by y - ε - θ1·x. The lower envelope of the upper
//! bounds has a piece for each corner of the lower hull of the points, from left to right, and a break at the slope of
//! each of its edges; the upper envelope of the lower bounds has a piece for each corner of the upper hull, from right
//! to left. (De Berg et al., *Computational Geometry*, sections 8.2 and 11.4.)

use std::cmp::Ordering;
use std::ops::Range;

use boundfit_exact::{Integer, Rational, Sign};

use super::chain::Hull;
use super::region::GridLine;
use super::{GridPoint, compare_products, difference, is_narrow, narrow_orientation, wide_orientation};

/// A bound of θ2 that is piecewise linear in θ1.
pub(super) struct Envelope {
    /// Positions of the points on the hull, in the order of the pieces.
    touching: Vec<usize>,
    /// For each corner of the hull, where it and its repetitions are among `touching`.
    corners: Vec<Range<usize>>,
}

impl Envelope {
    pub(super) fn new(points: &[GridPoint], hull: Hull) -> Self {
        if is_narrow(points) {
            Envelope::with(points, hull, narrow_orientation)
        } else {
            Envelope::with(points, hull, wide_orientation)
        }
    }

    fn with(
        points: &[GridPoint],
        hull: Hull,
        orientation: fn(&GridPoint, &GridPoint, &GridPoint) -> Ordering,
    ) -> Self {
        let chain = hull.chain(points, orientation);
        let mut touching = Vec::with_capacity(chain.len());
        let mut corners = Vec::with_capacity(chain.len());
        for (place, &position) in chain.iter().enumerate() {
            let start = touching.len();
            touching.extend(hull.repetitions(points, position));
            let neighbours = (place.checked_sub(1).map(|before| chain[before]), chain.get(place + 1));
            let is_within_edge = matches!(neighbours, (Some(before), Some(&after))
                if orientation(&points[before], &points[position], &points[after]).is_eq());
            if !is_within_edge {
                corners.push(start..touching.len());
            }
        }
        Envelope { touching, corners }
    }

    /// Position of the point of a piece.
    pub(super) fn corner(&self, piece: usize) -> usize {
        self.touching[self.corners[piece].start]
    }

    /// Positions of the points with a bound at the end of the first piece that is the beginning of the last: those of an
    /// edge, or of one corner.
    pub(super) fn active(&self, pieces: [usize; 2]) -> &[usize] {
        let [first, last] = pieces;
        &self.touching[self.corners[first].start..self.corners[last].end]
    }

    fn last(&self) -> usize {
        self.corners.len() - 1
    }
}

/// The slope of an edge: a value of θ1, but for the units. `dx > 0`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slope {
    pub(super) dx: i128,
    pub(super) dy: i128,
}

impl Slope {
    pub(super) fn between(p: &GridPoint, q: &GridPoint) -> Self {
        let (dx, dy) = (difference(q.x, p.x), difference(q.y, p.y));
        if dx < 0 { Slope { dx: -dx, dy: -dy } } else { Slope { dx, dy } }
    }

    fn compare(&self, other: &Slope) -> Ordering {
        compare_products([self.dy, other.dx], [other.dy, self.dx])
    }
}

/// A piece of each envelope.
#[derive(Debug, Clone, Copy)]
pub(super) struct At {
    pub(super) upper: usize,
    pub(super) lower: usize,
}

/// An end of the region: the pieces in force just left and just right of it.
pub(super) struct End {
    pub(super) left: At,
    pub(super) right: At,
}

/// Both envelopes of the points.
pub(super) struct Envelopes<'a> {
    pub(super) upper: Envelope,
    pub(super) lower: Envelope,
    pub(super) points: &'a [GridPoint],
    pub(super) line: &'a GridLine,
}

impl Envelopes<'_> {
    /// Where the gap between the envelopes opens, unless it is never positive.
    pub(super) fn opening(&self) -> Option<End> {
        let mut left = At { upper: 0, lower: 0 };
        loop {
            // Right of the last break the gap becomes narrower: between the bounds of the rightmost and the leftmost point.
            let (right, theta1) = self.next(left)?;
            match self.gap(left, &theta1) {
                Sign::Negative => left = right,
                Sign::Positive => return Some(End { left, right: left }),
                Sign::Zero => {
                    let [upper, lower] = self.at(right);
                    return (lower.x > upper.x).then_some(End { left, right });
                }
            }
        }
    }

    /// Where the gap closes, likewise.
    pub(super) fn closing(&self) -> Option<End> {
        let mut right = At { upper: self.upper.last(), lower: self.lower.last() };
        loop {
            let (left, theta1) = self.previous(right)?;
            match self.gap(right, &theta1) {
                Sign::Negative => right = left,
                Sign::Positive => return Some(End { left: right, right }),
                Sign::Zero => return Some(End { left, right }),
            }
        }
    }

    /// The points of two pieces.
    pub(super) fn at(&self, at: At) -> [&GridPoint; 2] {
        [&self.points[self.upper.corner(at.upper)], &self.points[self.lower.corner(at.lower)]]
    }

    /// The slope of the edge from one corner of a hull to the next.
    fn slope(&self, envelope: &Envelope, piece: usize) -> Option<Slope> {
        let next = (piece < envelope.last()).then(|| envelope.corner(piece + 1))?;
        Some(Slope::between(&self.points[envelope.corner(piece)], &self.points[next]))
    }

    /// The pieces after the next break, and where it is.
    fn next(&self, at: At) -> Option<(At, Slope)> {
        let slopes = (self.slope(&self.upper, at.upper), self.slope(&self.lower, at.lower));
        let (order, first) = match slopes {
            (Some(upper), Some(lower)) => {
                let order = upper.compare(&lower);
                (order, if order.is_le() { upper } else { lower })
            }
            (Some(upper), None) => (Ordering::Less, upper),
            (None, Some(lower)) => (Ordering::Greater, lower),
            (None, None) => return None,
        };
        let after =
            At { upper: at.upper + usize::from(order.is_le()), lower: at.lower + usize::from(order.is_ge()) };
        Some((after, first))
    }

    /// The pieces before the previous break, and where it is.
    fn previous(&self, at: At) -> Option<(At, Slope)> {
        let before = |envelope: &Envelope, piece: usize| self.slope(envelope, piece.checked_sub(1)?);
        let slopes = (before(&self.upper, at.upper), before(&self.lower, at.lower));
        let (order, last) = match slopes {
            (Some(upper), Some(lower)) => {
                let order = upper.compare(&lower);
                (order, if order.is_ge() { upper } else { lower })
            }
            (Some(upper), None) => (Ordering::Greater, upper),
            (None, Some(lower)) => (Ordering::Less, lower),
            (None, None) => return None,
        };
        let before =
            At { upper: at.upper - usize::from(order.is_ge()), lower: at.lower - usize::from(order.is_le()) };
        Some((before, last))
    }

    /// The sign of the upper bound less the lower one of two pieces, at a slope.
    fn gap(&self, at: At, theta1: &Slope) -> Sign {
        let [upper, lower] = self.at(at);
        let (dx, dy) = (Integer::from(theta1.dx), Integer::from(theta1.dy));
        let height = Integer::from(difference(upper.y, lower.y));
        let width = Integer::from(difference(upper.x, lower.x));
        let steps = Rational::from(height * &dx - width * dy) * &self.line.y_unit;
        let epsilon = &self.line.epsilon * Rational::from(dx);
        (steps + &epsilon + &epsilon).sign()
    }
}
