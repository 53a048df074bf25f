//! The corners that known half-planes leave, rounded, and whether another half-plane certainly holds in all of them.
//!
//! # The margin
//!
//! All numbers are 0 or between 2⁻⁵⁰⁰ and 2⁵⁰⁰ in absolute value, so that no product overflows or underflows. Numbers
//! of readings are within a relative error of 2⁻⁵⁰ of the true ones, numbers of corners and edges within 2⁻⁵². Then
//! a1·v1 + a2·v2 is found within 2⁻⁴⁹ of |a1·v1| + |a2·v2|: a product is off by 2⁻⁵⁰ + 2⁻⁵² + 2⁻⁵³ of itself and the
//! sum by 2⁻⁵³ more. Twice as much is left between it and the right-hand side, of which the caller says what it is
//! certainly not below.

use boundfit_exact::{Rational, Sign};

use crate::constructions::{foot, meet};
use crate::half_plane::HalfPlane;

/// 2⁻⁴⁸.
pub(super) const MARGIN: f64 = 1.0 / (1_u64 << 48) as f64;
/// 2⁻⁵⁰⁰ and 2⁵⁰⁰.
const RANGE: [f64; 2] = [f64::from_bits((1023 - 500) << 52), f64::from_bits((1023 + 500) << 52)];
/// More corners than these would take longer to look at than they are worth.
const MOST_CORNERS: usize = 64;

/// A number that a filter may compute with: NaN, with which every comparison fails, where it is beyond the range.
#[inline]
pub fn in_range(number: f64) -> f64 {
    let size = number.abs();
    // Without a branch, which would keep columns from being looked at many numbers at a time.
    if (size == 0.0) | (RANGE[0]..=RANGE[1]).contains(&size) { number } else { f64::NAN }
}

/// The set that is left by half-planes with `a2 > 0`.
#[derive(Debug, Clone)]
pub(super) struct Corners {
    /// The corners, by ascending a1/a2 of the half-planes that meet there.
    pub(super) corners: Vec<[f64; 2]>,
    /// a1/a2 of the half-planes, ascending: each corner is between two of them, but for that of a single one.
    pub(super) slopes: Vec<f64>,
    /// The normals of both unbounded edges, the one with the least a1/a2 first.
    edges: [Edge; 2],
}

/// A normal of an unbounded edge.
#[derive(Debug, Clone)]
struct Edge {
    exact: [Rational; 2],
    rounded: [f64; 2],
}

impl Corners {
    /// Returns a chain of half-planes that all make a corner, by ascending a1/a2; in the mirror for -1. `None`
    /// without any, and where numbers are out of range.
    pub(super) fn new(half_planes: &[&HalfPlane], mirror: f64) -> Option<Self> {
        let last = half_planes.len().checked_sub(1)?;
        // A set that is larger discards less, and nothing wrongly.
        let count = half_planes.len().min(MOST_CORNERS + 1);
        let mut chosen: Vec<&HalfPlane> =
            (0..count).map(|k| half_planes[k * last / (count - 1).max(1)]).collect();
        if mirror < 0.0 {
            chosen.reverse();
        }
        let corner = |[f, g]: [&HalfPlane; 2]| {
            let [theta1, theta2] = meet(f, g).unwrap_or_else(|| foot(f)).coordinates();
            [in_range(theta1.to_f64()), in_range(theta2.to_f64()) * mirror]
        };
        let pairs = chosen.windows(2).map(|pair| [pair[0], pair[1]]);
        let mut corners: Vec<[f64; 2]> = pairs.map(corner).collect();
        if corners.is_empty() {
            corners.push(corner([chosen[0], chosen[0]]));
        }
        let edge = |half_plane: &HalfPlane| {
            let [a1, a2] = [half_plane.a1(), half_plane.a2()].map(Rational::from);
            let exact = [a1, if mirror < 0.0 { -a2 } else { a2 }];
            let rounded = exact.each_ref().map(|number| in_range(number.to_f64()));
            Edge { exact, rounded }
        };
        let slope = |half_plane: &&HalfPlane| {
            let [a1, a2] =
                [half_plane.a1(), half_plane.a2()].map(|own| in_range(Rational::from(own).to_f64()));
            a1 / (a2 * mirror)
        };
        let mut slopes: Vec<f64> = chosen.iter().map(slope).collect();
        // Rounded, neighbours may have changed places.
        slopes.sort_unstable_by(f64::total_cmp);
        let edges = [edge(chosen[0]), edge(chosen[chosen.len() - 1])];
        let numbers = corners.iter().chain(edges.iter().map(|edge| &edge.rounded)).flatten();
        let is_known = numbers.chain(&slopes).copied().all(f64::is_finite);
        is_known.then_some(Corners { corners, slopes, edges })
    }

    /// Returns whether a·θ < bound certainly holds in every corner.
    #[inline]
    pub(super) fn are_within(&self, [a1, a2]: [f64; 2], bound: f64) -> bool {
        self.corners.iter().all(|[v1, v2]| {
            let (p, q) = (a1 * v1, a2 * v2);
            p + q + MARGIN * (p.abs() + q.abs()) < bound
        })
    }

    /// Returns whether a1/a2 is between those of the edges, or the same as one of them.
    #[inline]
    pub(super) fn is_between_edges(&self, normal: [f64; 2], exact: impl Fn() -> [Rational; 2]) -> bool {
        let is_turned = |edge: &Edge, sign: f64| {
            let (turn, margin) = edge.turn_to(normal);
            let turn = turn * sign;
            if turn > margin {
                return true;
            }
            if turn < -margin {
                return false;
            }
            let [a1, a2] = exact();
            let turn = a1 * &edge.exact[1] - a2 * &edge.exact[0];
            turn.is_zero() || (turn.sign() == Sign::Positive) == (sign > 0.0)
        };
        is_turned(&self.edges[0], 1.0) && is_turned(&self.edges[1], -1.0)
    }

    /// Returns whether a1/a2 is certainly not between those of the edges.
    pub(super) fn is_beside_edges(&self, normal: [f64; 2]) -> bool {
        let [first, last] = self.edges.each_ref().map(|edge| edge.turn_to(normal));
        first.0 < -first.1 || last.0 > last.1
    }
}

impl Edge {
    /// Returns a number with the sign of the turn to another normal, and the margin from which on the sign is certain.
    #[inline]
    fn turn_to(&self, [a1, a2]: [f64; 2]) -> (f64, f64) {
        let (p, q) = (a1 * self.rounded[1], a2 * self.rounded[0]);
        (p - q, MARGIN * (p.abs() + q.abs()))
    }
}
