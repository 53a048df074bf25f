//! A float filter for readings whose two half-planes certainly touch no envelope.
//!
//! Known half-planes that bound θ2 from above leave a set with corners and two unbounded edges. Another half-plane of
//! that kind is strictly redundant where it holds strictly in every corner and turns away from neither edge.
//! Half-planes that bound θ2 from below are the same in the mirror θ2 → -θ2.
//!
//! # The margin
//!
//! All numbers are 0 or between 2⁻⁵⁰⁰ and 2⁵⁰⁰ in absolute value, so that no product overflows or underflows. Numbers
//! of readings are within a relative error of 2⁻⁵⁰ of the true ones, numbers of corners and edges within 2⁻⁵². Then
//! a1·v1 + a2·v2 is found within 2⁻⁴⁹ of |a1·v1| + |a2·v2|: a product is off by 2⁻⁵⁰ + 2⁻⁵² + 2⁻⁵³ of itself and the
//! sum by 2⁻⁵³ more. Twice as much is left between it and the right-hand side, of which the caller says what it is
//! certainly not below.

use std::sync::OnceLock;

use boundfit_exact::{Rational, Sign};

use super::slopes::Slopes;
use crate::constructions::{foot, meet};
use crate::half_plane::HalfPlane;
use crate::hull::HullSide;
use crate::predicates::by_tightness;
use crate::touching::{Family, is_vertical};

/// 2⁻⁴⁸.
pub(super) const MARGIN: f64 = 1.0 / (1_u64 << 48) as f64;
/// 2⁻⁵⁰⁰ and 2⁵⁰⁰.
const RANGE: [f64; 2] = [f64::from_bits((1023 - 500) << 52), f64::from_bits((1023 + 500) << 52)];
/// More corners than these would take longer to look at than they are worth.
const MOST_CORNERS: usize = 64;

/// The number of rows that are tested together. Compilers turn loops over fewer numbers into single steps before they see that vector
/// registers would do.
pub(super) const LANES: usize = 32;

/// A number that a filter may compute with: NaN, with which every comparison fails, where it is beyond the range.
#[inline]
pub fn in_range(number: f64) -> f64 {
    let size = number.abs();
    // Without a branch, which would keep columns from being looked at many numbers at a time.
    if (size == 0.0) | (RANGE[0]..=RANGE[1]).contains(&size) { number } else { f64::NAN }
}

/// The known half-planes of the whole, by which readings are discarded.
#[derive(Debug, Clone)]
pub struct EnvelopeSieve {
    /// Bounds of θ2 from above, and those from below in the mirror.
    above: Option<Corners>,
    below: Option<Corners>,
    /// The same in cells of slopes, which decide about almost all readings of a column; `None` where there are no such cells.
    slopes: OnceLock<Option<Slopes>>,
    /// The tightest bounds of θ1 from the right, and from the left in the mirror.
    right: Option<f64>,
    left: Option<f64>,
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

#[derive(Debug, Clone)]
struct Edge {
    exact: [Rational; 2],
    rounded: [f64; 2],
}

/// A reading lower ≤ φ·θ ≤ upper, rounded.
#[derive(Debug, Clone, Copy)]
pub struct RoundedStrip {
    /// φ, each within a relative error of 2⁻⁵⁰, and [`in_range`].
    pub phi: [f64; 2],
    /// Certainly not below the lower bound; -∞ without one.
    pub lower: f64,
    /// Certainly not above the upper bound; ∞ without one.
    pub upper: f64,
}

/// Such readings in columns of equal length.
#[derive(Debug, Clone, Default)]
pub struct RoundedStrips {
    /// φ of each.
    pub phi: [Vec<f64>; 2],
    /// The lower bounds.
    pub lower: Vec<f64>,
    /// The upper bounds.
    pub upper: Vec<f64>,
}

impl RoundedStrips {
    /// Returns how many there are.
    pub fn len(&self) -> usize {
        self.lower.len()
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.lower.is_empty()
    }

    /// The reading of a row.
    ///
    /// # Panics
    /// When there are not that many.
    #[inline]
    pub fn strip(&self, row: usize) -> RoundedStrip {
        let phi = [self.phi[0][row], self.phi[1][row]];
        RoundedStrip { phi, lower: self.lower[row], upper: self.upper[row] }
    }

    /// Some rows that follow one another, as those that bound θ2 from above and from below; `None` where there are not that many.
    #[inline]
    fn lanes(&self, start: usize) -> Option<Lanes> {
        let of = |column: &Vec<f64>| column.get(start..)?.first_chunk::<LANES>().copied();
        let ([phi1, phi2], [lower, upper]) =
            ([of(&self.phi[0])?, of(&self.phi[1])?], [of(&self.lower)?, of(&self.upper)?]);
        let mut lanes = Lanes { slope: phi1, height: phi2, from_above: upper, from_below: lower };
        let bounds = lanes.from_above.iter_mut().zip(&mut lanes.from_below);
        for ((slope, height), (above, below)) in lanes.slope.iter_mut().zip(&mut lanes.height).zip(bounds) {
            let is_upright = *height > 0.0;
            (*above, *below) = if is_upright { (*above, -*below) } else { (-*below, *above) };
            *slope = if is_upright { *slope } else { -*slope };
            *height = height.abs();
        }
        Some(lanes)
    }
}

/// Rows turned so that φ2 is not negative: slope·θ1 + height·θ2 ≤ `from_above` and -slope·θ1 - height·θ2 ≤ `from_below`.
pub(super) struct Lanes {
    pub(super) slope: [f64; LANES],
    pub(super) height: [f64; LANES],
    pub(super) from_above: [f64; LANES],
    pub(super) from_below: [f64; LANES],
}

impl EnvelopeSieve {
    /// Returns a sieve from half-planes of the whole, best those that [touch an
    /// envelope](crate::touching_an_envelope) so far. Cost: O(n log n).
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
            slopes: OnceLock::new(),
            right: vertical(true, 1.0),
            left: vertical(false, -1.0),
        }
    }

    /// Positions, ascending, of the readings that are not [discarded](Self::discards). Cost: linear, and little for each of those
    /// far from all envelopes.
    pub fn survivors(&self, strips: &RoundedStrips, exact: impl Fn(usize) -> [Rational; 2]) -> Vec<usize> {
        /// Fewer readings are not worth cells.
        const FEW: usize = 8 * LANES;
        let slopes = || self.slopes.get_or_init(|| Slopes::new(self.above.as_ref(), self.below.as_ref()));
        let slopes = if strips.len() < FEW { None } else { slopes().as_ref() };
        let mut left = Vec::new();
        for start in (0..strips.len()).step_by(LANES) {
            let lanes = slopes.zip(strips.lanes(start));
            let certain = lanes.map_or([false; LANES], |(slopes, lanes)| slopes.discard(&lanes));
            let uncertain = certain.into_iter().enumerate().filter(|(_, is_certain)| !is_certain);
            let rows = uncertain.map(|(lane, _)| start + lane).take_while(|&row| row < strips.len());
            left.extend(rows.filter(|&row| !self.discards(&strips.strip(row), || exact(row))));
        }
        left
    }

    /// Returns whether both half-planes of a reading certainly touch no envelope of the whole. `exact` gives its φ, and is asked only
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

/// Returns whether size·θ1 ≤ bound is certainly strictly redundant beside θ1 ≤ known.
fn is_left_of(size: f64, known: Option<f64>, bound: f64) -> bool {
    let within = |known: f64| {
        let value = size * known;
        value + MARGIN * value.abs() < bound
    };
    bound == f64::INFINITY || known.is_some_and(within)
}

impl Corners {
    /// Returns a chain of half-planes that all make a corner, by ascending a1/a2; in the mirror for -1. `None`
    /// without any, and where numbers are out of range.
    fn new(half_planes: &[&HalfPlane], mirror: f64) -> Option<Self> {
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
    fn are_within(&self, [a1, a2]: [f64; 2], bound: f64) -> bool {
        self.corners.iter().all(|[v1, v2]| {
            let (p, q) = (a1 * v1, a2 * v2);
            p + q + MARGIN * (p.abs() + q.abs()) < bound
        })
    }

    /// Returns whether a1/a2 is between those of the edges, or the same as one of them.
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
                let number = |place: usize| readings.iter().map(|own| own[place] as f64).collect::<Vec<_>>();
                let strips =
                    RoundedStrips { phi: [number(0), number(1)], lower: number(2), upper: number(3) };
                let exact = |row: usize| [Rational::from(readings[row][0]), Rational::from(readings[row][1])];
                let survivors = sieve.survivors(&strips, exact);
                for (index, reading) in readings.iter().enumerate() {
                    let [phi1, phi2, lower, upper] = reading.map(|number| number as f64);
                    let rounded = RoundedStrip { phi: [phi1, phi2], lower, upper };
                    let exact = || [Rational::from(reading[0]), Rational::from(reading[1])];
                    let is_discarded = sieve.discards(&rounded, exact);
                    assert_eq!(
                        is_discarded,
                        survivors.binary_search(&index).is_err(),
                        "{readings:?} {index}"
                    );
                    if is_discarded {
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
