//! A filter of numbers of any length by their leading digits.

use super::cells::{Around, Equal};
use super::filter::Filter;
use super::sample::Sample;

/// Discards rows that are certainly strictly between the hulls of some points. It knows all numbers only as binary64
/// within 2^-50, relatively: leading digits decide about almost all rows, on no unit in particular.
pub struct RoundedSieve {
    equal: Filter<f64, Equal>,
    /// A second filter for what the first one leaves: where exponents differ much, one of the equal cells has nearly all numbers.
    corners: Filter<f64, Around>,
}

impl RoundedSieve {
    /// Returns a sieve from the rounded coordinates of points of the whole, best those that [touch](super::touching)
    /// its hulls so far. Returns `None` when their x are too near to each other for numbers so rounded. Cost: O(n log
    /// n).
    pub fn new(x: &[f64], y: &[f64]) -> Option<Self> {
        RoundedSieve::of_sample(x, y, x.len())
    }

    fn of_sample(x: &[f64], y: &[f64], size: usize) -> Option<Self> {
        let sample = Sample::of_rounded(x, y, size)?;
        let equal = Filter::of_rounded(&sample, sample.equal_cells()?);
        Some(RoundedSieve { equal, corners: Filter::of_all_sizes(&sample)? })
    }

    /// Returns whether most of some rounded x, taken at equal distances, are left or right of the points: the sieve discards few rows.
    pub fn is_beside(&self, x: &[f64]) -> bool {
        self.equal.is_beside(x)
    }

    /// Positions, ascending, of the rows of two rounded columns of equal length that are not certainly strictly between the
    /// hulls. Cost: linear.
    pub fn survivors(&self, x: &[f64], y: &[f64]) -> Vec<usize> {
        /// The number of rows of which at most one may be left without a second look.
        const RARE: usize = 16;
        let mut left = self.equal.survivors(x, y);
        if left.len() * RARE > x.len() {
            left.retain(|&row| !self.corners.discards(x[row], y[row]));
        }
        left
    }
}

/// Returns the positions, ascending, of the rows of two rounded columns of equal length that may
/// [touch](super::touching) a hull. Every row that touches is among them; if the data have some width, few others
/// are. Cost: linear.
pub fn candidates_of_rounded(x: &[f64], y: &[f64]) -> Vec<usize> {
    /// The most rows that are not filtered.
    const FEW: usize = 64;
    /// The most rows that are all in the sample: an exact decision about one takes longer than its share of the sample's hull.
    const WHOLE: usize = 512;
    let mut positions: Vec<usize> = (0..x.len().min(y.len())).collect();
    let (mut xs, mut ys) = (x.to_vec(), y.to_vec());
    // Another round has a better sample.
    while positions.len() > FEW {
        let Some(sieve) = RoundedSieve::of_sample(&xs, &ys, WHOLE.max(4 * xs.len().isqrt())) else { break };
        let kept = sieve.survivors(&xs, &ys);
        let is_enough = 2 * kept.len() > xs.len();
        positions = kept.iter().map(|&kept| positions[kept]).collect();
        if is_enough {
            break;
        }
        [xs, ys] = [xs, ys].map(|column| kept.iter().map(|&kept| column[kept]).collect());
    }
    positions
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{GridPoint, touching, touching_doubles};
    use crate::tally::Tally;

    fn word(state: &mut u64) -> u64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        *state >> 33
    }

    /// Whole numbers of up to 62 bits, far from 0 or not, with many near the hulls.
    fn points(state: &mut u64) -> Vec<GridPoint> {
        let shift = word(state) % 40;
        let (far, wide) = (word(state) % 3 * (1 << 40), 1 + ((word(state) % 1000) << shift));
        let curve = word(state) % 3;
        let point = |id: u64, x: u64, noise: u64| {
            let x = x % wide;
            let y = match curve {
                0 => noise % 1000,
                1 => x / 3 + noise % 5,
                _ => (x >> 20) * (x >> 20) + noise % 2,
            };
            GridPoint { x: (x + far) as i64, y: y as i64 - 7, rows: Tally::one(id) }
        };
        let count = 65 + word(state) % 3000;
        (0..count).map(|id| point(id, word(state) << 20 ^ word(state), word(state))).collect()
    }

    #[test]
    fn nothing_that_touches_is_discarded() {
        let mut state = 5;
        let mut discarded = 0;
        for _ in 0..300 {
            let points = points(&mut state);
            let near = |value: i64, state: &mut u64| {
                // The farthest that is allowed, on either side.
                let double = value as f64;
                let error = f64::EPSILON * 3.5 * [-1.0, 0.0, 1.0][word(state) as usize % 3];
                double + double * error
            };
            let x: Vec<f64> = points.iter().map(|point| near(point.x, &mut state)).collect();
            let y: Vec<f64> = points.iter().map(|point| near(point.y, &mut state)).collect();
            let kept = candidates_of_rounded(&x, &y);
            discarded += points.len() - kept.len();
            let expected: Vec<u64> =
                touching(points.clone(), usize::MAX).iter().flat_map(|point| point.rows.rows()).collect();
            assert!(expected.iter().all(|id| kept.binary_search(&(*id as usize)).is_ok()));
            // The points of the first half sieve all.
            let half = points.len() / 2;
            let Some(sieve) = RoundedSieve::new(&x[..half], &y[..half]) else { continue };
            let left = sieve.survivors(&x[half..], &y[half..]);
            let is_left = |id: usize| id < half || left.binary_search(&(id - half)).is_ok();
            assert!(expected.iter().all(|id| is_left(*id as usize)));
        }
        assert!(discarded > 200_000, "only {discarded}");
    }

    /// Numbers of all sizes and both signs: along rays, near curves or hulls, on lines, in clusters, with zeros and ties.
    fn of_all_sizes(state: &mut u64) -> Vec<[f64; 2]> {
        let kind = word(state) % 8;
        let spread = [2, 20, 100, 290][word(state) as usize % 4];
        let (signs, count, ties) = (word(state) % 4, 65 + word(state) % 900, word(state) as usize % 40);
        let far = 10_f64.powi(word(state) as i32 % (2 * spread) - spread);
        let number = |state: &mut u64| {
            let exponent = word(state) as i32 % (2 * spread) - spread;
            (1.0 + word(state) as f64 / (1_u64 << 30) as f64) * 10_f64.powi(exponent)
        };
        let mut point = || -> [f64; 2] {
            let size = number(state);
            let x = match signs {
                0 => size,
                1 => -size,
                _ => size * [-1.0, 1.0][word(state) as usize % 2],
            };
            let unit = word(state) as f64 / (1_u64 << 31) as f64;
            let [x, y] = match kind {
                0 => [x, x * (1.9 + 0.2 * unit)],
                1 => [x, number(state) * [-1.0, 1.0][word(state) as usize % 2]],
                2 => [x, 2.0 * x],
                3 => [x, 2.0 * x + x * unit * f64::EPSILON * 8.0],
                4 => [x, x.abs().sqrt() * (1.0 - unit * 1e-9)],
                5 => [far + x, far * unit],
                6 => [far + far * unit * f64::EPSILON * 1e6, x],
                _ => [[0.0, x][word(state) as usize % 2], [0.0, unit, x][word(state) as usize % 3]],
            };
            [x, y].map(|number| if number.is_normal() { number } else { 0.0 })
        };
        let mut points: Vec<[f64; 2]> = (0..count).map(|_| point()).collect();
        for place in 0..ties {
            points.push(points[place * 3 % points.len()]);
        }
        points
    }

    /// Hulls of doubles, as exact as they are, are the reference.
    #[test]
    fn nothing_of_any_size_that_touches_is_discarded() {
        let (mut state, mut all, mut kept_of_all) = (11, 0, 0);
        for _ in 0..4000 {
            let points = of_all_sizes(&mut state);
            let [x, y] = [0, 1].map(|axis| points.iter().map(|point| point[axis]).collect::<Vec<f64>>());
            let mut near = |column: &[f64]| -> Vec<f64> {
                let error = |state: &mut u64| f64::EPSILON * 3.5 * [-1.0, 0.0, 1.0][word(state) as usize % 3];
                column.iter().map(|number| number + number * error(&mut state)).collect()
            };
            let (rounded_x, rounded_y) = (near(&x), near(&y));
            let kept = candidates_of_rounded(&rounded_x, &rounded_y);
            let touching = touching_doubles(&x, &y, &|row| row as u64, usize::MAX);
            for row in touching.iter().flat_map(|place| place.rows.rows()) {
                assert!(kept.binary_search(&(row as usize)).is_ok(), "{points:?}: {row}");
            }
            let half = points.len() / 2;
            let Some(sieve) = RoundedSieve::new(&rounded_x[..half], &rounded_y[..half]) else { continue };
            let left = sieve.survivors(&rounded_x[half..], &rounded_y[half..]);
            for row in touching.iter().flat_map(|place| place.rows.rows()).filter(|&row| row >= half as u64) {
                assert!(left.binary_search(&(row as usize - half)).is_ok(), "{points:?}: {row}");
            }
            (all, kept_of_all) = (all + points.len(), kept_of_all + kept.len());
        }
        assert!(2 * kept_of_all < all, "{kept_of_all} of {all}");
    }

    /// A margin that is as wide everywhere leaves nearly all of them.
    #[test]
    fn most_numbers_along_a_ray_are_discarded_whatever_their_size() {
        for seed in 0..12 {
            let (mut state, sign) = (seed, [-1.0, 1.0][seed as usize % 2]);
            let mut unit = || word(&mut state) as f64 / (1_u64 << 31) as f64;
            let x: Vec<f64> = (0..5000).map(|_| sign * 10_f64.powf(600.0 * unit() - 300.0)).collect();
            let y: Vec<f64> = x.iter().map(|x| x * (1.9 + 0.2 * unit())).collect();
            let kept = candidates_of_rounded(&x, &y).len();
            assert!(kept < 100, "{kept} of 5,000");
        }
    }

    /// Products of such numbers leave the range of binary64.
    #[test]
    fn most_numbers_of_any_exponent_are_discarded() {
        let mut state = 9;
        let mut number = || {
            let exponent = word(&mut state) as i32 % 600 - 300;
            let significand = 1.0 + word(&mut state) as f64 / (1_u64 << 31) as f64;
            significand * 10_f64.powi(exponent) * [-1.0, 1.0][word(&mut state) as usize % 2]
        };
        let points: Vec<[f64; 2]> = (0..10_000).map(|_| [number(), number()]).collect();
        let [x, y] = [0, 1].map(|axis| points.iter().map(|point| point[axis]).collect::<Vec<f64>>());
        let kept = candidates_of_rounded(&x, &y).len();
        assert!(kept < 500, "{kept} of 10,000");
    }
}
