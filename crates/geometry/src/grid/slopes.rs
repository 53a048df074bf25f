//! Two envelopes over slopes in cells: one product with a point for each tells that a reading touches neither.
//!
//! A half-plane slope·θ1 + height·θ2 ≤ bound with a positive height is strictly redundant where its bound is above the
//! maximum of its left side over the corners. Divided by the height, this maximum is a convex function of s =
//! slope/height. For all s of a cell it is not above a linear function, s·p + q. If one corner alone has the maximum
//! there, this is the function of the corner, and otherwise that of a chord. So slope·p + height·q < bound is enough.
//!
//! # The cells
//!
//! Slopes have no bounds, and may be close to each other far from 0. With a center c and a reach k, cells divide t =
//! n/(|n| + k·height) equally, where n = slope - c·height; t is between -1 and 1, and ascends with s. The numbers of a
//! reading are within 2⁻⁵⁰, so that n is off by 2⁻⁴⁹·(|n| + 2·|c|·height) at most, and t by 2⁻⁴⁷·(1 + |c|/k). Each cell
//! is 2⁻⁴³·(1 + |c|/k) longer on both sides. That also covers the rounding of its ends: back in slopes it is at least
//! 2⁻⁴³·(k + |c| + |s|).

use super::corners::{Corners, MARGIN, in_range};
use super::rounded_strips::{LANES, Lanes};

/// Cells from t = -1 to t = 1, of which the first and the last are half as long.
const CELLS: usize = 2 * HALF + 1;
const HALF: usize = 127;
/// The cells and one more, so that any bits lead to one.
const PLACES: usize = CELLS + 1;
/// Added to a number from 0 to 2⁵¹, it leaves the nearest integer in the last bits of the sum.
const ROUNDING: f64 = (1_u64 << 52) as f64;
/// 2⁻⁴³.
const BLUR: f64 = 1.0 / (1_u64 << 43) as f64;
/// A point that is not a number, with which every comparison fails.
const UNKNOWN: [f64; 2] = [f64::NAN; 2];

/// Both envelopes in cells of slopes.
#[derive(Debug, Clone)]
pub(super) struct Slopes {
    center: f64,
    reach: f64,
    cells: Box<[Cell; PLACES]>,
    /// The margin for a slope and a height of 1.
    margin: [f64; 2],
}

/// (p, q) for the upper bounds and for the lower ones.
#[derive(Debug, Clone, Copy)]
struct Cell {
    above: [f64; 2],
    below: [f64; 2],
}

impl Slopes {
    /// Returns the cells of envelopes, the second one in the mirror θ2 → -θ2; `None` where all slopes are the same or too
    /// close to each other. Cost: linear.
    pub(super) fn new(above: Option<&Corners>, below: Option<&Corners>) -> Option<Self> {
        let own = above.into_iter().flat_map(|own| own.slopes.iter().copied());
        let mirrored = below.into_iter().flat_map(|own| own.slopes.iter().map(|slope| -slope));
        let mut slopes: Vec<f64> = own.chain(mirrored).collect();
        slopes.sort_unstable_by(f64::total_cmp);
        let last = slopes.len().checked_sub(1)?;
        let at = |quarter: usize| slopes[last * quarter / 4];
        let center = in_range(at(2));
        // Half of all slopes are within the reach; or all, where many are the same.
        let reaches = [(1, 3), (0, 4)].map(|(low, high)| in_range((at(high) - at(low)) / 2.0));
        let reach = reaches.into_iter().find(|&reach| reach > 0.0)?;
        let blur = BLUR * (1.0 + center.abs() / reach);
        let is_fine = blur * HALF as f64 <= 1.0 / 64.0;
        if !is_fine {
            return None;
        }
        let slope = |end: f64| center + reach * end / (1.0 - end.abs());
        let mut cells = Box::new([Cell { above: UNKNOWN, below: UNKNOWN }; PLACES]);
        for (place, cell) in cells.iter_mut().enumerate().take(CELLS - 1).skip(1) {
            let end = |half: f64| (place as f64 - HALF as f64 + half) / HALF as f64;
            let [low, high] = [slope(end(-0.5) - blur), slope(end(0.5) + blur)].map(in_range);
            *cell = Cell {
                above: above.map_or(UNKNOWN, |own| own.not_below([low, high])),
                below: below.map_or(UNKNOWN, |own| {
                    let [p, q] = own.not_below([-high, -low]);
                    [-p, q]
                }),
            };
        }
        let corners = above.into_iter().chain(below).flat_map(|own| own.corners.iter().copied());
        let all = corners.chain(cells.iter().flat_map(|cell| [cell.above, cell.below]));
        // `max` passes over what is not a number.
        let farthest = all.fold([0.0; 2], |[p, q]: [f64; 2], own| [p.max(own[0].abs()), q.max(own[1].abs())]);
        Some(Slopes { center, reach, cells, margin: farthest.map(|far| MARGIN * far) })
    }

    /// Returns which of some rows are certainly strictly redundant on both sides.
    #[inline]
    pub(super) fn discard(&self, Lanes { slope, height, from_above, from_below }: &Lanes) -> [bool; LANES] {
        let mut places = [0; LANES];
        for (place, (slope, height)) in places.iter_mut().zip(slope.iter().zip(height)) {
            let turn = slope - self.center * height;
            let part = turn / (turn.abs() + self.reach * height);
            *place = (part * HALF as f64 + (ROUNDING + HALF as f64)).to_bits();
        }
        let mut certain = [false; LANES];
        let bounds = from_above.iter().zip(from_below);
        let rows = slope.iter().zip(height).zip(bounds).zip(places);
        for (certain, (((slope, height), (from_above, from_below)), place)) in certain.iter_mut().zip(rows) {
            let Cell { above, below } = &self.cells[place as usize % PLACES];
            let margin = slope.abs() * self.margin[0] + height * self.margin[1];
            let is_within = |[p, q]: &[f64; 2], bound: f64| {
                (slope * p + height * q + margin < bound) | (bound == f64::INFINITY)
            };
            // Half-planes that bound θ1 alone are another kind.
            *certain = (*height > 0.0) & is_within(above, *from_above) & is_within(below, *from_below);
        }
        certain
    }
}

impl Corners {
    /// Returns (p, q) such that s·p + q is not below s·v1 + v2 of any corner for any slope s between two ends. Returns
    /// [`UNKNOWN`] where these are not strictly between the slopes of the unbounded edges.
    fn not_below(&self, ends: [f64; 2]) -> [f64; 2] {
        let [low, high] = ends;
        let is_between = |(first, last): (&f64, &f64)| *first < low && low < high && high < *last;
        if !self.slopes.first().zip(self.slopes.last()).is_some_and(is_between) {
            return UNKNOWN;
        }
        // The corners that have the maximum for some slope: from the first one that ends behind `low` on.
        let behind = self.slopes.partition_point(|&slope| slope <= high) - 1;
        let before = self.slopes.partition_point(|&slope| slope < low) - 1;
        let corners = &self.corners[before..=behind];
        let (first, last) = (corners[0], corners[corners.len() - 1]);
        if corners.len() == 1 {
            return first;
        }
        let at = |slope: f64, [p, q]: [f64; 2]| slope * p + q;
        let p = in_range((at(high, last) - at(low, first)) / (high - low));
        let q = in_range(at(low, first) - low * p);
        // The chord is raised until it is certainly not below any of them, however it was rounded.
        let missing = |corner: &[f64; 2]| {
            let at_end = |end: f64| {
                let size = |[p, q]: [f64; 2]| (end * p).abs() + q.abs();
                at(end, *corner) - at(end, [p, q]) + MARGIN * (size(*corner) + size([p, q]))
            };
            at_end(low).max(at_end(high))
        };
        let raise = corners.iter().map(missing).fold(0.0, f64::max);
        [p, q + raise].map(in_range)
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Rational;

    use super::super::{EnvelopeSieve, RoundedStrips};
    use crate::half_plane::{Constraint, HalfPlane, Inequality};
    use crate::touching::touching_an_envelope;

    /// The half-planes of a reading, upper bound first; the one that is missing holds everywhere.
    fn strip([phi1, phi2, lower, upper]: [i64; 4], missing: Option<usize>) -> [Constraint; 2] {
        let mut own = [[phi1, phi2, upper], [-phi1, -phi2, -lower]];
        missing.into_iter().for_each(|side| own[side] = [0; 3]);
        own.map(|[a1, a2, b]| Inequality::new(a1.into(), a2.into(), b.into()).constraint())
    }

    /// Slopes near to each other and far from 0, of all sizes, upright, of readings that lack a bound.
    #[test]
    fn nothing_that_touches_is_discarded_by_its_slope() {
        let mut seed = 3_u64;
        let mut below = |size: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 20) as i64 % size
        };
        let (mut discarded, mut all) = ([0; 6], 0);
        for round in 0..240 {
            let kind = round % 6;
            let count = 257 + below(300) as usize;
            let readings: Vec<[i64; 4]> = (0..count)
                .map(|_| {
                    let phi = match kind {
                        0 => [below(2001) - 1000, 1],
                        1 => [(1 << 40) + below(1000), 1],
                        2 => [below(7) - 3, below(7) - 3],
                        3 => [below(2001) - 1000, below(2001) - 1000],
                        4 => [below(1 << 30) >> below(30), (below(1 << 20) >> below(20)) - (1 << below(19))],
                        _ => [5 + below(2), 1 + below(3) / 2],
                    };
                    let middle = 3 * phi[0] - 2 * phi[1] + below(201) - 100;
                    [phi[0], phi[1], middle - 100 - below(9), middle + 100 + below(9)]
                })
                .collect();
            let missing: Vec<Option<usize>> =
                (0..count).map(|_| (round % 4 == 3).then(|| below(2) as usize)).collect();
            let constraints: Vec<Constraint> =
                readings.iter().zip(&missing).flat_map(|(own, missing)| strip(*own, *missing)).collect();
            let known: Vec<HalfPlane> = constraints[..120]
                .iter()
                .filter_map(|own| if let Constraint::HalfPlane(own) = own { Some(own.clone()) } else { None })
                .collect();
            let mut near = |number: i64| number as f64 * (1.0 + f64::EPSILON * 1.5 * (below(3) - 1) as f64);
            let phi = [0, 1].map(|axis| readings.iter().map(|own| near(own[axis])).collect());
            let bound = |place: usize, side: usize| {
                let infinite = [f64::INFINITY, f64::NEG_INFINITY][side];
                let bounds = readings.iter().zip(&missing);
                let of = |(own, missing): (&[i64; 4], &Option<usize>)| {
                    if *missing == Some(side) { infinite } else { own[place] as f64 }
                };
                bounds.map(of).collect()
            };
            let strips = RoundedStrips { phi, lower: bound(2, 1), upper: bound(3, 0) };
            let exact = |row: usize| [0, 1].map(|axis| Rational::from(readings[row][axis]));
            let survivors = EnvelopeSieve::new(&known).survivors(&strips, exact);
            for touching in touching_an_envelope(&constraints) {
                let is_half_plane = matches!(constraints[touching], Constraint::HalfPlane(_));
                let is_left = survivors.binary_search(&(touching / 2)).is_ok();
                assert!(is_left || !is_half_plane, "{round}: {:?}", readings[touching / 2]);
            }
            discarded[kind] += count - survivors.len();
            all += count;
        }
        assert!(discarded.iter().all(|&own| 10 * own > all), "{discarded:?} of {all}");
    }
}
