//! A strip between two parallel lines in which every integer point is certainly strictly between the hulls: a test of two
//! comparisons and a product, before that of the cells.
//!
//! # Why it is certain
//!
//! Let p and q be points of the sample with p.x ≤ x0 and x1 ≤ q.x. Between x0 and x1 the lower hull of all points is
//! nowhere above the chord from p to q. Let d = x - x0, s = S/2^k and f = ⌊d·S/2^k⌋ ≤ s·d < f + 1. The chord less s·d
//! is linear in x and has its maximum M at x0 or x1. So the chord less f is below M + 1: a y with y - f ≥ M + 1 is
//! above the chord. Likewise one with y - f ≤ m - 1 is below a chord of the upper hull that has the minimum m. All of
//! it is on integers.

use super::coordinate::Coordinate;
use super::sample::{Sample, Sampled};

/// x0 ≤ x ≤ x0 + width and `least` ≤ y - ⌊(x - x0)·slope/2^shift⌋ ≤ `least + height`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strip {
    x0: i64,
    width: u64,
    slope: i64,
    shift: u32,
    least: i64,
    height: u64,
}

/// One of so many points of the sample lies left, and one right, of the strip.
const OUTSIDE: usize = 64;
/// Bits of the slope behind the point, if there is room.
const MOST_SHIFT: u32 = 20;
/// Products and sums below this do not wrap.
const ROOM: i128 = 1 << 62;

impl Strip {
    /// A strip within the hulls of a sample; `None` where there is none, and for coordinates that are no words.
    pub(super) fn of<C: Coordinate>(sample: &Sample<C>) -> Option<Self> {
        let beyond = sample.points.len() / OUTSIDE;
        let at = |position: usize| sample.points.get(position)?.x.word();
        let (x0, x1) = (at(beyond)?, at(sample.points.len().checked_sub(beyond + 1)?)?);
        let span = i128::from(x1) - i128::from(x0);
        if span <= 0 {
            return None;
        }
        let lower = Line::above(sample.lower_hull(), [x0, x1])?;
        // The mirror image of the upper hull.
        let upper = Line::above(sample.mirrored_upper_hull(), [x0, x1])?;
        let ends = [lower.0, lower.1, upper.0, upper.1].map(|value| value as f64);
        let rise = (ends[1] - ends[3] - ends[0] + ends[2]) / 2.0 / span as f64;
        let (slope, shift) = (0..=MOST_SHIFT).rev().find_map(|shift| {
            let slope = rise * f64::from(1_u32 << shift);
            let fits = slope.abs() < ROOM as f64 && (slope as i128 * span).abs() < ROOM;
            fits.then_some((slope as i64, shift))
        })?;
        let moved = i128::from(slope) * span;
        let (floor, ceiling) = (moved >> shift, -(-moved >> shift));
        let least = lower.0.max(lower.1 - floor) + 1;
        let most = (-upper.0).min(-upper.1 - ceiling) - 1;
        let height = u64::try_from(most.checked_sub(least)?).ok()?;
        Some(Strip {
            x0,
            width: x1.wrapping_sub(x0) as u64,
            slope,
            shift,
            least: least.try_into().ok()?,
            height,
        })
    }

    /// Returns whether a point is certainly strictly between the hulls.
    #[inline]
    pub(super) fn contains(&self, x: i64, y: i64) -> bool {
        let offset = x.wrapping_sub(self.x0);
        // Beyond the width the product may wrap, and the first comparison fails.
        let moved = offset.wrapping_mul(self.slope) >> self.shift;
        let above = y.wrapping_sub(moved).wrapping_sub(self.least) as u64;
        // A difference that wraps is at least 2⁶⁴ less 2⁶³ and 2⁶² and small numbers: more than any height.
        (offset as u64 <= self.width) & (above <= self.height)
    }
}

/// Integers not below a chord at two x.
struct Line(i128, i128);

impl Line {
    /// The chord between the last corner not right of the first x and the first one not left of the second.
    fn above<C: Coordinate>(hull: &[Sampled<C>], [x0, x1]: [i64; 2]) -> Option<Self> {
        /// The number up to which all integers are numbers of binary64.
        const EXACT: f64 = (1_u64 << 53) as f64;
        let word = |point: &Sampled<C>| {
            let is_exact = point.y.abs() <= EXACT;
            Some((i128::from(point.x.word()?), is_exact.then_some(point.y as i128)?))
        };
        let (p_x, p_y) = word(hull.iter().rev().find(|point| point.x.word().is_some_and(|x| x <= x0))?)?;
        let (q_x, q_y) = word(hull.iter().find(|point| point.x.word().is_some_and(|x| x >= x1))?)?;
        // Rounded up: -⌊-a/b⌋ for positive b.
        let at = |x: i64| p_y - (-((q_y - p_y) * (i128::from(x) - p_x))).div_euclid(q_x - p_x);
        Some(Line(at(x0), at(x1)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{GridPoint, touching};
    use super::*;

    /// A strip of a part of the points never holds a point that touches a hull of all points, however steep and high
    /// they are.
    #[test]
    fn nothing_that_touches_is_within() {
        let mut seed = 5_u64;
        let mut below = |size: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 2) as i64 % size
        };
        let (mut strips, mut within, mut all) = (0, 0, 0);
        for round in 0..3_000_u32 {
            let width = [3, 40, 1 << 20, 1 << 40, 1 << 61][round as usize % 5];
            let slope =
                [0, 1, -7, 1 << 10][below(4) as usize].min(i64::MAX / 4 / width).max(-(i64::MAX / 4 / width));
            let noise = [2, 9, 1000, 1 << 30][below(4) as usize];
            let (x, y): (Vec<i64>, Vec<i64>) = (0..200)
                .map(|_| {
                    let x = below(width) - width / 2;
                    (x, (slope * x + below(noise)).clamp(-(1 << 53), 1 << 53))
                })
                .unzip();
            let Some(sample) = Sample::of(&x, &y, [200, 60, 15][below(3) as usize]) else { continue };
            let Some(strip) = Strip::of(&sample) else { continue };
            strips += 1;
            let points = x.iter().zip(&y).map(|(&x, &y)| GridPoint::of_row(x, y, 0)).collect();
            for point in touching(points, 1) {
                assert!(!strip.contains(point.x, point.y), "{round} {point:?} {strip:?} {x:?} {y:?}");
            }
            within += x.iter().zip(&y).filter(|(x, y)| strip.contains(**x, **y)).count();
            all += x.len();
            // Far above and below, where differences wrap.
            for x in [i64::MIN, strip.x0, strip.x0.wrapping_add(strip.width as i64), i64::MAX] {
                assert!(!strip.contains(x, i64::MIN) && !strip.contains(x, i64::MAX), "{round} {strip:?}");
            }
        }
        assert!(strips > 1000 && 3 * within > all, "{strips} strips, {within} of {all}");
    }
}
