//! A vector as a combination of others with weights between 0 and 1.

use std::cmp::Ordering;

use boundfit_exact::Rational;

/// Weights with which vectors add up to a target: from 0 to 1 for the first ones, from 0 without an end for the others; `None`
/// where there are none. Exact. Cost: O(m log m).
///
/// The sums of the first are a zonotope. If all vectors point to the right, every point of their zonotope lies
/// between two chains. The chains take the vectors by ascending and by descending slope, each as far as the point's
/// first coordinate.
pub(super) fn combination(
    target: &[Rational; 2],
    bounded: &[[Rational; 2]],
    unbounded: &[[Rational; 2]],
) -> Option<Vec<Rational>> {
    let times = long_enough(target, bounded, unbounded);
    let stretched = unbounded.iter().map(|own| own.each_ref().map(|part| part * &times));
    let vectors: Vec<[Rational; 2]> = bounded.iter().cloned().chain(stretched).collect();
    let mut weights = weights(target, &vectors)?;
    for weight in weights.iter_mut().skip(bounded.len()) {
        *weight = &*weight * &times;
    }
    Some(weights)
}

/// A length that no weight of the unbounded vectors need exceed: at a corner two vectors make up, by Cramer's rule, for what the
/// target and the others leave.
fn long_enough(target: &[Rational; 2], bounded: &[[Rational; 2]], unbounded: &[[Rational; 2]]) -> Rational {
    let length = |own: &[Rational; 2]| own[0].abs() + own[1].abs();
    let all = || bounded.iter().chain(unbounded);
    let reach = length(target) + bounded.iter().map(length).sum::<Rational>();
    let longest = all().map(length).max().unwrap_or_default();
    let area = |one: &[Rational; 2], other: &[Rational; 2]| (&one[0] * &other[1] - &one[1] * &other[0]).abs();
    let mut most = Rational::one();
    for own in unbounded {
        let least_area = all().map(|other| area(own, other)).filter(|area| !area.is_zero()).min();
        let across = least_area.and_then(|area| (&reach * &longest).checked_div(&area));
        let straight = reach.checked_div(&own[0].abs().max(own[1].abs()));
        most = [across, straight].into_iter().flatten().fold(most, Rational::max);
    }
    most
}

fn weights(target: &[Rational; 2], vectors: &[[Rational; 2]]) -> Option<Vec<Rational>> {
    let is_backward = |[x, y]: &[Rational; 2]| x.is_negative() || (x.is_zero() && y.is_negative());
    let mut rest = target.clone();
    let mut forward: Vec<[Rational; 2]> = Vec::with_capacity(vectors.len());
    for own in vectors {
        if is_backward(own) {
            rest = [&rest[0] - &own[0], &rest[1] - &own[1]];
            forward.push(own.each_ref().map(|part| -part));
        } else {
            forward.push(own.clone());
        }
    }
    let mut slanted: Vec<usize> = (0..forward.len()).filter(|&index| !forward[index][0].is_zero()).collect();
    let by_slope = |&one: &usize, &other: &usize| -> Ordering {
        let ([x, y], [u, v]) = (&forward[one], &forward[other]);
        (y * u).cmp(&(v * x))
    };
    slanted.sort_by(by_slope);
    let mut low = chain(&forward, slanted.iter().copied(), &rest[0], Rational::zero())?;
    let high = chain(&forward, slanted.iter().rev().copied(), &rest[0], Rational::one())?;
    let height = |weights: &[Rational]| -> Rational {
        weights.iter().zip(&forward).map(|(weight, own)| weight * &own[1]).sum()
    };
    let (bottom, top) = (height(&low), height(&high));
    let share = (&rest[1] - &bottom).checked_div(&(&top - &bottom)).unwrap_or_default();
    if &bottom + &share * (&top - &bottom) != rest[1] || share.is_negative() || share > Rational::one() {
        return None;
    }
    for ((weight, high), own) in low.iter_mut().zip(&high).zip(vectors) {
        let mean = &*weight + &share * (high - &*weight);
        *weight = if is_backward(own) { Rational::one() - mean } else { mean };
    }
    Some(low)
}

/// The weights of a chain as far as a first coordinate; those of vertical vectors are all the same.
fn chain(
    forward: &[[Rational; 2]],
    order: impl Iterator<Item = usize>,
    to: &Rational,
    vertical: Rational,
) -> Option<Vec<Rational>> {
    let mut weights = vec![Rational::zero(); forward.len()];
    for (weight, own) in weights.iter_mut().zip(forward) {
        if own[0].is_zero() {
            *weight = vertical.clone();
        }
    }
    let mut left = to.clone();
    for index in order {
        let part = left.checked_div(&forward[index][0])?.min(Rational::one());
        if !part.is_positive() {
            break;
        }
        left = left - &forward[index][0] * &part;
        weights[index] = part;
    }
    left.is_zero().then_some(weights)
}
