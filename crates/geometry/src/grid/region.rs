//! The region of a line from points on an integer grid.

use boundfit_exact::{Integer, Rational};

use super::chain::Hull;
use super::envelopes::{At, End, Envelope, Envelopes, Slope};
use super::{GridPoint, difference};
use crate::point::Point;
use crate::region::{PolygonRegion, Region, Vertex};

/// What the integers of grid points mean, and how far readings may be off.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GridLine {
    /// One step of x; positive.
    pub x_unit: Rational,
    /// One step of y; positive.
    pub y_unit: Rational,
    /// The error bound of every reading.
    pub epsilon: Rational,
}

/// The region of (θ1, θ2) with |y - θ1·x - θ2| ≤ ε for all of the points, if it is a polygon; otherwise `None`, which
/// says no more than that the general way must be taken.
///
/// The points must be sorted, as [`touching`](super::touching) leaves them; points that touch no hull do no harm. In the order of their ids,
/// point k stands for the half-planes 2k, `θ1·x + θ2 ≤ y + ε`, and 2k + 1, `-θ1·x - θ2 ≤ ε - y`. The region equals that of
/// [`envelope::intersect`](crate::envelope::intersect) for these in every part. Exact for all numbers. Cost: O(n log n) for
/// the order of the ids, otherwise linear.
pub fn line_region(touching: &[GridPoint], line: &GridLine) -> Option<Region> {
    let units_are_positive = line.x_unit.is_positive() && line.y_unit.is_positive();
    let has_width = touching.first()?.x < touching.last()?.x;
    if !units_are_positive || !has_width || !touching.is_sorted() {
        return None;
    }
    let envelopes = Envelopes {
        upper: Envelope::new(touching, Hull::Lower),
        lower: Envelope::new(touching, Hull::Upper),
        points: touching,
        line,
    };
    let (open, close) = (envelopes.opening()?, envelopes.closing()?);
    Some(Region::Polygon(PolygonRegion { vertices: Outline::new(&envelopes).vertices(&open, &close) }))
}

/// Makes the vertices. In units of y and x, the bounds of two points at a distance (dx, dy) on one hull meet at
/// θ1 = dy/dx, θ2 = (y·dx - x·dy)/dx ± ε.
struct Outline<'a> {
    envelopes: &'a Envelopes<'a>,
    /// The place of each point in the order of the ids.
    ranks: Vec<usize>,
    /// Homogeneous coordinates of (θ1, θ2): dy times the first of these,
    slope_factor: Integer,
    /// y·dx - x·dy times this,
    height_factor: Integer,
    /// plus or minus dx times this,
    epsilon_factor: Integer,
    /// over dx times this.
    divisor: Integer,
}

impl<'a> Outline<'a> {
    fn new(envelopes: &'a Envelopes<'a>) -> Self {
        let GridLine { x_unit, y_unit, epsilon } = envelopes.line;
        let slope_unit = y_unit.checked_div(x_unit).unwrap_or_default();
        let divisor = slope_unit.denominator().lcm(&y_unit.denominator()).lcm(&epsilon.denominator());
        let times_divisor =
            |value: &Rational| value.numerator() * divisor.div_rem_floor(&value.denominator()).0;
        let ids = envelopes.points.iter().map(|point| point.id);
        let mut by_id: Vec<(u64, usize)> = ids.zip(0..).collect();
        by_id.sort_unstable();
        let mut ranks = vec![0; by_id.len()];
        for (rank, (_, position)) in by_id.into_iter().enumerate() {
            ranks[position] = rank;
        }
        Outline {
            envelopes,
            ranks,
            slope_factor: times_divisor(&slope_unit),
            height_factor: times_divisor(y_unit),
            epsilon_factor: times_divisor(epsilon),
            divisor,
        }
    }

    /// Counter-clockwise from the left end, which is the lexicographically smallest.
    fn vertices(&self, open: &End, close: &End) -> Vec<Vertex> {
        let Envelopes { upper, lower, .. } = self.envelopes;
        let along_lower = open.right.lower..close.left.lower;
        let along_upper = open.right.upper..close.left.upper;
        let mut vertices = Vec::with_capacity(along_lower.len() + along_upper.len() + 2);
        let at_break = |envelope: &Envelope, piece: usize, side: Side| {
            let pieces = [piece, piece + 1];
            Vertex {
                point: self.meeting(envelope, pieces, side),
                active: self.indices(envelope.active(pieces), side),
            }
        };
        let at_end = |end: &End, crossing: At| {
            let mut active = self.indices(upper.active([end.left.upper, end.right.upper]), Side::Upper);
            active.extend(self.indices(lower.active([end.left.lower, end.right.lower]), Side::Lower));
            active.sort_unstable();
            Vertex { point: self.crossing(crossing), active }
        };
        vertices.push(at_end(open, open.left));
        vertices.extend(along_lower.map(|piece| at_break(lower, piece, Side::Lower)));
        vertices.push(at_end(close, close.right));
        vertices.extend(along_upper.rev().map(|piece| at_break(upper, piece, Side::Upper)));
        vertices
    }

    /// Where the bounds of two corners of one hull meet.
    fn meeting(&self, envelope: &Envelope, pieces: [usize; 2], side: Side) -> Point {
        let [p, q] = pieces.map(|piece| &self.envelopes.points[envelope.corner(piece)]);
        let slope = Slope::between(p, q);
        let (dx, dy) = (Integer::from(slope.dx), Integer::from(slope.dy));
        let height = Integer::from(p.y) * &dx - Integer::from(p.x) * &dy;
        let epsilon = &self.epsilon_factor * &dx;
        let height = height * &self.height_factor;
        let height = match side {
            Side::Upper => height + epsilon,
            Side::Lower => height - epsilon,
        };
        let point = Point::from_homogeneous(dy * &self.slope_factor, height, dx * &self.divisor);
        point.expect("corners of a hull have different x and the divisor is a common multiple")
    }

    /// Where the upper bound of one piece meets the lower bound of another.
    fn crossing(&self, at: At) -> Point {
        let [upper, lower] = self.envelopes.at(at);
        let GridLine { x_unit, y_unit, epsilon } = self.envelopes.line;
        let times = |steps: i128, unit: &Rational| Rational::from(steps) * unit;
        let rise = times(difference(upper.y, lower.y), y_unit) + epsilon + epsilon;
        let run = times(difference(upper.x, lower.x), x_unit);
        let theta1 = rise.checked_div(&run).expect("the gap changes its sign between these pieces");
        let theta2 = times(upper.y.into(), y_unit) + epsilon - &theta1 * times(upper.x.into(), x_unit);
        Point::new(&theta1, &theta2)
    }

    /// Indices of the upper or lower half-planes of points, ascending.
    fn indices(&self, positions: &[usize], side: Side) -> Vec<usize> {
        let offset = match side {
            Side::Upper => 0,
            Side::Lower => 1,
        };
        let mut indices: Vec<usize> =
            positions.iter().map(|&position| 2 * self.ranks[position] + offset).collect();
        indices.sort_unstable();
        indices
    }
}

/// Which bounds of θ2.
#[derive(Debug, Clone, Copy)]
enum Side {
    Upper,
    Lower,
}
