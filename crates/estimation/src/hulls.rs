//! ε_min of the line model from the two hulls of the readings.
//!
//! A line within ε of every reading passes above the upper hull of (x, y - ε) and below the lower hull of (x, y + ε), so
//! the smallest ε is half of the largest vertical distance between the upper and the lower hull of (x, y). It is found
//! between a vertex of one hull and an edge of the other, and those three readings prove it.

use boundfit_exact::{Rational, Sign};
use boundfit_geometry::predicates::{by_theta1, lexicographic, orientation};
use boundfit_geometry::{Hulls, Point};

use crate::measurements::Measurement;

/// A reading on a hull: its position among the rows.
#[derive(Debug, Clone)]
struct Extreme {
    position: usize,
    point: Point,
}

/// The smallest error bound with what proves it.
#[derive(Debug)]
pub(crate) struct HullMinimum {
    /// ε_min.
    pub(crate) epsilon: Rational,
    /// Positions of the readings whose lower (`true`) or upper bound proves it, with multipliers that sum to 1.
    pub(crate) proof: Vec<(usize, bool, Rational)>,
    /// Positions of the readings on either hull; the others bound nothing, ascending.
    pub(crate) extreme: Vec<usize>,
}

/// ε_min of one or more readings of a line under a uniform error bound; `None` without readings. Exact.
/// Cost: O(N log N).
pub(crate) fn minimum_from_hulls(rows: &[Measurement]) -> Option<HullMinimum> {
    let Extremes { lower, upper, .. } = Extremes::new(rows);
    let above_lower = upper.iter().filter_map(|vertex| gap(vertex, &lower, false));
    let below_upper = lower.iter().filter_map(|vertex| gap(vertex, &upper, true));
    let widest = above_lower
        .chain(below_upper)
        .reduce(|widest, next| if next.epsilon > widest.epsilon { next } else { widest });
    let mut extreme: Vec<usize> = lower.iter().chain(&upper).map(|extreme| extreme.position).collect();
    extreme.sort_unstable();
    extreme.dedup();
    widest.map(|widest| HullMinimum { extreme, ..widest })
}

/// Positions of the readings of a line on either hull of (x, y), those within its edges and repeated ones included,
/// ascending. Under a uniform error bound, however large, no other reading has an active bound. Exact.
/// Cost: O(N log N).
pub(crate) fn touching_a_hull(rows: &[Measurement]) -> Vec<usize> {
    let Extremes { points, lower, upper } = Extremes::new(rows);
    let mut positions: Vec<usize> = points
        .iter()
        .filter(|extreme| [&lower, &upper].into_iter().any(|hull| is_on(&extreme.point, hull)))
        .map(|extreme| extreme.position)
        .collect();
    positions.sort_unstable();
    positions
}

/// Whether a point is on a hull that is sorted by x and reaches as far as the point in both directions.
fn is_on(point: &Point, hull: &[Extreme]) -> bool {
    let after = hull.partition_point(|extreme| by_theta1(&extreme.point, point).is_le());
    let Some(left) = after.checked_sub(1).map(|before| &hull[before].point) else { return false };
    match hull.get(after) {
        Some(right) if by_theta1(left, point).is_lt() => orientation(left, &right.point, point) == Sign::Zero,
        _ => left == point,
    }
}

/// All readings and their two hulls, each sorted by x.
struct Extremes {
    points: Vec<Extreme>,
    lower: Vec<Extreme>,
    upper: Vec<Extreme>,
}

impl Extremes {
    fn new(rows: &[Measurement]) -> Self {
        let mut points: Vec<Extreme> = rows
            .iter()
            .enumerate()
            .map(|(position, row)| Extreme { position, point: Point::new(&row.regressor[0], &row.response) })
            .collect();
        points.sort_by(|p, q| lexicographic(&p.point, &q.point).then(p.position.cmp(&q.position)));
        let Hulls { lower, upper } = Hulls::of_sorted(&points, |extreme| &extreme.point);
        let picked = |positions: Vec<usize>| positions.into_iter().map(|k| points[k].clone()).collect();
        let (lower, upper) = (picked(lower), picked(upper));
        Extremes { points, lower, upper }
    }
}

/// Half of the vertical distance from a vertex of one hull to the other hull, both sorted by x.
fn gap(vertex: &Extreme, other: &[Extreme], vertex_is_lower: bool) -> Option<HullMinimum> {
    let after = other.partition_point(|extreme| by_theta1(&extreme.point, &vertex.point).is_le());
    let before = after.checked_sub(1)?;
    let (left, right) = (&other[before], other.get(after).unwrap_or(&other[before]));
    let [x, y] = vertex.point.coordinates();
    let ([left_x, left_y], [right_x, right_y]) = (left.point.coordinates(), right.point.coordinates());
    let weight = (x - &left_x).checked_div(&(right_x - &left_x)).unwrap_or_default();
    let opposite = Rational::one() - &weight;
    let distance = y - left_y * &opposite - right_y * &weight;
    let half = Rational::ratio(1, 2);
    let side = |multiplier: Rational| multiplier * &half;
    // A reading on the upper hull pushes the line up: its lower bound is the one that counts.
    let proof = vec![
        (vertex.position, !vertex_is_lower, half.clone()),
        (left.position, vertex_is_lower, side(opposite)),
        (right.position, vertex_is_lower, side(weight)),
    ];
    let epsilon = if vertex_is_lower { -distance } else { distance } * &half;
    let proof = proof.into_iter().filter(|(_, _, multiplier)| !multiplier.is_zero()).collect();
    Some(HullMinimum { epsilon, proof, extreme: Vec::new() })
}
