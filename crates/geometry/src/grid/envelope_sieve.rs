//! A float filter for readings whose two half-planes certainly touch no envelope.
//!
//! Known half-planes that bound θ2 from above leave a set with corners and two unbounded edges. Another half-plane of that
//! kind is strictly redundant where it holds strictly in every corner and turns away from neither edge. Those that bound θ2
//! from below are the same in the mirror θ2 → -θ2.
//!
//! # The margin
//!
//! All numbers are 0 or between 2⁻⁵⁰⁰ and 2⁵⁰⁰ in absolute value, so that no product overflows or underflows, and within a
//! relative error of 2⁻⁵¹ of the true ones. Then a1·v1 + a2·v2 is found within 2⁻⁴⁹ of |a1·v1| + |a2·v2|, and twice as much
//! is left between it and the right-hand side, of which the caller says what it is certainly not below.

use boundfit_exact::{Rational, Sign};

use crate::constructions::{foot, meet};
use crate::half_plane::HalfPlane;
use crate::hull::HullSide;
use crate::predicates::by_tightness;
use crate::touching::{Family, is_vertical};

/// 2⁻⁴⁸.
const MARGIN: f64 = 1.0 / (1_u64 << 48) as f64;
/// 2⁻⁵⁰⁰ and 2⁵⁰⁰.
const RANGE: [f64; 2] = [f64::from_bits((1023 - 500) << 52), f64::from_bits((1023 + 500) << 52)];
/// More corners than these would take longer to look at than they are worth.
const MOST_CORNERS: usize = 16;

/// A number that a filter may compute with: NaN, with which every comparison fails, where it is beyond the range.
pub fn in_range(number: f64) -> f64 {
    let size = number.abs();
    if size == 0.0 || (RANGE[0]..=RANGE[1]).contains(&size) { number } else { f64::NAN }
}

/// What is known about the half-planes of the whole, to discard readings by.
#[derive(Debug, Clone)]
pub struct EnvelopeSieve {
    /// Bounds of θ2 from above, and those from below in the mirror.
    above: Option<Corners>,
    below: Option<Corners>,
    /// The tightest bounds of θ1 from the right, and from the left in the mirror.
    right: Option<f64>,
    left: Option<f64>,
}

/// The set that is left by half-planes with `a2 > 0`.
#[derive(Debug, Clone)]
struct Corners {
    corners: Vec<[f64; 2]>,
    /// The normals of both unbounded edges, the one with the least a1/a2 first.
    edges: [Edge; 2],
}

#[derive(Debug, Clone)]
struct Edge {
    exact: [Rational; 2],
    rounded: [f64; 2],
}

/// A reading lower ≤ φ·θ ≤ upper, rounded.
#[derive(Debug, Clone, Copy)]
pub struct RoundedStrip {
    /// φ, each within a relative error of 2⁻⁵¹, and [`in_range`].
    pub phi: [f64; 2],
    /// Certainly not below the lower bound; -∞ without one.
    pub lower: f64,
    /// Certainly not above the upper bound; ∞ without one.
    pub upper: f64,
}

impl EnvelopeSieve {
    /// From half-planes of the whole, best those that [touch an envelope](crate::touching_an_envelope) so far.
    /// Cost: O(n log n).
    pub fn new(half_planes: &[HalfPlane]) -> Self {
        let corners = |side: HullSide, mirror: f64| {
            let places = Family::new(side, half_planes.iter().enumerate()).corners();
            Corners::new(&places.iter().map(|&place| &half_planes[place]).collect::<Vec<_>>(), mirror)
        };
        let vertical = |faces_right: bool, mirror: f64| {
            let own = half_planes.iter().filter(|own| is_vertical(own, faces_right));
            let tightest = own.min_by(|f, g| by_tightness(f, g))?;
            Some(in_range(foot(tightest).theta1().to_f64()) * mirror)
        };
        EnvelopeSieve {
            above: corners(HullSide::Lower, 1.0),
            below: corners(HullSide::Upper, -1.0),
            right: vertical(true, 1.0),
            left: vertical(false, -1.0),
        }
    }

    /// Whether both half-planes of a reading certainly touch no envelope of the whole. `exact` gives its φ, and is asked only
    /// where this is not much steeper or flatter than an unbounded edge.
    #[inline]
    pub fn discards(&self, strip: &RoundedStrip, exact: impl Fn() -> [Rational; 2]) -> bool {
        let RoundedStrip { phi: [a1, a2], lower, upper } = *strip;
        if a2 == 0.0 {
            let [from_above, from_below] = if a1 > 0.0 { [upper, -lower] } else { [-lower, upper] };
            return is_left_of(a1.abs(), self.right, from_above)
                && is_left_of(a1.abs(), self.left, from_below);
        }
        // Whichever of its bounds is the one from above, its normal is (a1, a2) or the opposite with a positive a2.
        let (slope, [from_above, from_below]) =
            if a2 > 0.0 { (a1, [upper, -lower]) } else { (-a1, [-lower, upper]) };
        let normal = [slope, a2.abs()];
        let allows = |corners: &Option<Corners>, normal: [f64; 2], bound: f64, mirrored: bool| {
            bound == f64::INFINITY
                || corners.as_ref().is_some_and(|corners| {
                    corners.are_within(normal, bound)
                        && corners.is_between_edges(normal, || {
                            let [a1, a2] = exact();
                            let opposite = a2.is_negative();
                            let a1 = if opposite == mirrored { a1 } else { -a1 };
                            [a1, a2.abs()]
                        })
                })
        };
        allows(&self.above, normal, from_above, false)
            && allows(&self.below, [-normal[0], normal[1]], from_below, true)
    }
}

/// Whether size·θ1 ≤ bound is certainly strictly redundant beside θ1 ≤ known.
fn is_left_of(size: f64, known: Option<f64>, bound: f64) -> bool {
    let within = |known: f64| {
        let value = size * known;
        value + MARGIN * value.abs() < bound
    };
    bound == f64::INFINITY || known.is_some_and(within)
}

impl Corners {
    /// Of half-planes that all make a corner, by ascending a1/a2; in the mirror for -1. `None` without any, and where numbers are
    /// out of range.
    fn new(half_planes: &[&HalfPlane], mirror: f64) -> Option<Self> {
        let last = half_planes.len().checked_sub(1)?;
        // A set that is larger discards less, and nothing wrongly.
        let count = half_planes.len().min(MOST_CORNERS + 1);
        let chosen: Vec<&HalfPlane> =
            (0..count).map(|k| half_planes[k * last / (count - 1).max(1)]).collect();
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
        let mut edges = [edge(chosen[0]), edge(chosen[chosen.len() - 1])];
        if mirror < 0.0 {
            edges.reverse();
        }
        let numbers = corners.iter().chain(edges.iter().map(|edge| &edge.rounded)).flatten();
        numbers.copied().all(f64::is_finite).then_some(Corners { corners, edges })
    }

    /// Whether a·θ < bound certainly holds in every corner.
    #[inline]
    fn are_within(&self, [a1, a2]: [f64; 2], bound: f64) -> bool {
        self.corners.iter().all(|[v1, v2]| {
            let (p, q) = (a1 * v1, a2 * v2);
            p + q + MARGIN * (p.abs() + q.abs()) < bound
        })
    }

    /// Whether a1/a2 is between those of the edges, or the same as one of them.
    #[inline]
    fn is_between_edges(&self, [a1, a2]: [f64; 2], exact: impl Fn() -> [Rational; 2]) -> bool {
        let is_turned = |edge: &Edge, sign: f64| {
            let (p, q) = (a1 * edge.rounded[1], a2 * edge.rounded[0]);
            let turn = (p - q) * sign;
            let margin = MARGIN * (p.abs() + q.abs());
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::half_plane::{Constraint, Inequality};
    use crate::system::System;
    use crate::touching::touching_an_envelope;

    /// The half-planes of a reading, upper bound first.
    fn strip([phi1, phi2, lower, upper]: [i64; 4]) -> [Inequality; 2] {
        [[phi1, phi2, upper], [-phi1, -phi2, -lower]]
            .map(|[a1, a2, b]| Inequality::new(a1.into(), a2.into(), b.into()))
    }

    #[test]
    fn nothing_that_touches_is_discarded_and_what_is_far_off_is() {
        let mut seed = 8_u64;
        let mut below = |size: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as i64 % size
        };
        let mut discarded = [0; 2];
        for round in 0..400_usize {
            let size = [2, 5, 1000][round % 3];
            let readings: Vec<[i64; 4]> = (0..30)
                .map(|_| {
                    let line = round % 2 == 0;
                    let phi = [below(2 * size + 1) - size, if line { 1 } else { below(2 * size + 1) - size }];
                    let middle = 3 * phi[0] - 2 * phi[1] + below(5) - 2;
                    [phi[0], phi[1], middle - below(9), middle + below(9)]
                })
                .collect();
            let system = System::new(readings.iter().copied().flat_map(strip));
            let touching = touching_an_envelope(system.constraints());
            for known in [7, 30] {
                let half_planes: Vec<HalfPlane> = system.constraints()[..2 * known]
                    .iter()
                    .filter_map(|constraint| match constraint {
                        Constraint::HalfPlane(half_plane) => Some(half_plane.clone()),
                        _ => None,
                    })
                    .collect();
                let sieve = EnvelopeSieve::new(&half_planes);
                for (index, reading) in readings.iter().enumerate() {
                    let [phi1, phi2, lower, upper] = reading.map(|number| number as f64);
                    let rounded = RoundedStrip { phi: [phi1, phi2], lower, upper };
                    let exact = || [Rational::from(reading[0]), Rational::from(reading[1])];
                    if sieve.discards(&rounded, exact) {
                        discarded[round % 2] += 1;
                        let own = [2 * index, 2 * index + 1];
                        assert!(
                            own.iter().all(|k| touching.binary_search(k).is_err()),
                            "{readings:?} {index}"
                        );
                    }
                }
            }
        }
        assert!(discarded.iter().all(|&count| count > 5_000), "{discarded:?}");
    }
}
