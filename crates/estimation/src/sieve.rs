//! The readings in memory that can decide something under bounds that are fixed: a filter on floats, which bears their
//! roundings, discards the others. `files/fixed.rs` filters columns so, where readings through one vertex stand for each other.

use boundfit_exact::Rational;
use boundfit_geometry::grid::RoundedStrips;
use boundfit_geometry::touching_an_envelope;

use crate::condition::Condition;
use crate::measurement::Measurement;
use crate::rounded::{float, may_be_tightest, strips_of};
use crate::scale::Scale;

/// Fewer readings are not worth a filter.
const FEWEST: usize = 64;

/// Returns the positions, ascending, of readings that decide the set under their bounds, and of those that the point, if there is
/// one, may miss most. Every half-plane that touches an envelope is one of theirs. Exact. Cost: linear, and that of the exact work
/// for about the square root of all readings.
pub(crate) fn deciding(rows: &[Measurement], point: Option<&[Rational; 2]>) -> Vec<usize> {
    if rows.len() < FEWEST {
        return (0..rows.len()).collect();
    }
    let strips = strips_of(rows, &Scale::AsStated);
    let mut left = may_touch(rows, &strips, &Scale::AsStated, &sample(rows.len()));
    if let Some(theta) = point {
        left.extend(may_be_tightest(&strips, theta.each_ref().map(float)));
        left.sort_unstable();
        left.dedup();
    }
    left
}

/// Returns the positions, ascending, of readings that decide the least factor on the bounds, or the least uniform bound, at which
/// something is left. Exact. Cost: that of [`deciding`] for each attempt, of which two or three suffice in practice.
///
/// The readings that touch at the least factor of some readings decide as soon as that factor leaves a point for all readings. The
/// first attempt takes those at the given positions.
pub(crate) fn deciding_least(
    rows: &[Measurement],
    some: &[usize],
    is_uniform: bool,
    conditions: &[Condition],
) -> Vec<usize> {
    let all = || (0..rows.len()).collect();
    if rows.len() < FEWEST {
        return all();
    }
    let at = |positions: &[usize]| positions.iter().map(|&position| &rows[position]).collect::<Vec<_>>();
    let mut known = some.to_vec();
    loop {
        let Some(scale) = Scale::least(at(&known).into_iter(), is_uniform, conditions) else { return all() };
        let few = may_touch(rows, &strips_of(rows, &scale), &scale, &known);
        let (of, constraints) = scale.constraints(at(&few).into_iter());
        let mut touching: Vec<usize> =
            touching_an_envelope(&constraints).into_iter().map(|index| few[of[index]]).collect();
        touching.dedup();
        if scale.is_enough(at(&touching).into_iter(), conditions) {
            return touching;
        }
        known.extend(touching);
        known.sort_unstable();
        known.dedup();
    }
}

/// Positions at equal distances, about the square root of all.
pub(crate) fn sample(count: usize) -> Vec<usize> {
    (0..count).step_by(count.isqrt().max(1)).collect()
}

/// Returns the positions, ascending, of the readings that are not discarded by the readings at some positions, nor then by a sample
/// of what is left. The others are strictly redundant beside them.
fn may_touch(rows: &[Measurement], strips: &RoundedStrips, scale: &Scale, some: &[usize]) -> Vec<usize> {
    let exact = |position: usize| rows[position].regressor.clone();
    let sieve = |some: &[usize]| scale.sieve(some.iter().map(|&position| &rows[position]));
    let mut left = sieve(some).survivors(strips, exact);
    // Another round has a better sample.
    while left.len() >= FEWEST {
        let better = sieve(&sample(left.len()).into_iter().map(|place| left[place]).collect::<Vec<_>>());
        let passes = |place: &usize| !better.discards(&strips.strip(*place), || exact(*place));
        let kept: Vec<usize> = left.iter().copied().filter(passes).collect();
        let is_enough = 2 * kept.len() > left.len();
        left = kept;
        if is_enough {
            break;
        }
    }
    left
}
