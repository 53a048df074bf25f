//! A float filter for readings whose two half-planes certainly touch no envelope.
//!
//! Known half-planes that bound θ2 from above leave a set with corners and two unbounded edges. Another half-plane of
//! that kind is strictly redundant where it holds strictly in every corner and turns away from neither edge.
//! Half-planes that bound θ2 from below are the same in the mirror θ2 → -θ2. The file `corners` proves the margin.

use std::sync::OnceLock;

use boundfit_exact::Rational;

use super::corners::{Corners, MARGIN, in_range};
use super::filter::holds_of_most;
use super::rounded_strips::{LANES, RoundedStrip, RoundedStrips};
use super::slopes::Slopes;
use crate::constructions::foot;
use crate::half_plane::HalfPlane;
use crate::hull::HullSide;
use crate::predicates::by_tightness;
use crate::touching::{Family, is_vertical};

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
            let certain = match (slopes, strips.lanes(start)) {
                (Some(slopes), Some(lanes)) => slopes.discard(&lanes),
                _ => [false; LANES],
            };
            if certain == [true; LANES] {
                continue;
            }
            let uncertain = certain.into_iter().enumerate().filter(|(_, is_certain)| !is_certain);
            let rows = uncertain.map(|(lane, _)| start + lane).take_while(|&row| row < strips.len());
            left.extend(rows.filter(|&row| !self.discards(&strips.strip(row), || exact(row))));
        }
        left
    }

    /// Returns whether most of some readings, taken at equal distances, are steeper or flatter than an unbounded edge. The sieve
    /// discards none of these. Where x ascend, all readings are steeper than those before.
    pub fn is_beside(&self, strips: &RoundedStrips) -> bool {
        let is_beside = |corners: &Option<Corners>, normal: [f64; 2]| {
            corners.as_ref().is_some_and(|corners| corners.is_beside_edges(normal))
        };
        holds_of_most(strips.len(), |row| {
            let [a1, a2] = strips.strip(row).phi;
            let slope = if a2 < 0.0 { -a1 } else { a1 };
            is_beside(&self.above, [slope, a2.abs()]) || is_beside(&self.below, [-slope, a2.abs()])
        })
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

    #[test]
    fn readings_of_which_most_are_steeper_or_flatter_are_noticed() {
        let reading = |x: i64| [x, 1, 2 * x - 5 - x * x % 3, 2 * x + 5 + x * x % 4];
        let system = System::new((0..30).map(reading).flat_map(strip));
        let half_planes: Vec<HalfPlane> = system
            .constraints()
            .iter()
            .filter_map(|own| if let Constraint::HalfPlane(own) = own { Some(own.clone()) } else { None })
            .collect();
        let sieve = EnvelopeSieve::new(&half_planes);
        for (x, expected) in [(0..30, false), (30..70, true), (-40..0, true), (10..40, false), (10..60, true)]
        {
            for sign in [1.0, -1.0] {
                let numbers =
                    |place: usize| x.clone().map(move |x| reading(x)[place] as f64 * sign).collect();
                let [lower, upper] = if sign > 0.0 { [2, 3] } else { [3, 2] };
                let phi = [numbers(0), numbers(1)];
                let strips = RoundedStrips { phi, lower: numbers(lower), upper: numbers(upper) };
                assert_eq!(sieve.is_beside(&strips), expected, "{x:?} {sign}");
                let exact = |row: usize| {
                    [x.start + row as i64, 1].map(|own| Rational::from(own) * Rational::from(sign as i64))
                };
                let survivors = sieve.survivors(&strips, exact);
                assert!(!expected || 2 * survivors.len() > strips.len(), "{x:?} {survivors:?}");
            }
        }
        assert!(!sieve.is_beside(&RoundedStrips::default()));
    }
}
