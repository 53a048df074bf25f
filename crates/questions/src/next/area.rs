//! The largest area that a slab of a given direction cuts out of a polygon.

use std::borrow::Cow;

use boundfit_exact::Rational;
use boundfit_geometry::{Measures, Point, Region, RegionKind};

/// The largest area of a bounded region between two parallels θ1·x + θ2 = y ± ε, whatever y is; they are nearer to each other than
/// the region is wide. Exact. Cost: O(n log n) for n vertices, and the area's fraction.
pub(super) fn worst_area(region: &Region, x: &Rational, epsilon: &Rational) -> Rational {
    if region.kind() != RegionKind::Polygon {
        return Rational::zero();
    }
    let corner = |[theta1, theta2]: [Rational; 2]| Corner { value: &theta1 * x + theta2, theta1 };
    let corners: Vec<Corner> =
        region.vertices().iter().map(|vertex| corner(vertex.point().coordinates())).collect();
    let middle = middle(&corners, epsilon);
    let above = clipped(&corners, &(&middle - epsilon), false);
    let between = clipped(&above, &(middle + epsilon), true);
    // Points (θ1, θ1·x + θ2) have the area of (θ1, θ2).
    let points = between.iter().map(|Corner { value, theta1 }| Cow::Owned(Point::new(theta1, value)));
    Measures::of(RegionKind::Polygon, points.collect()).polygon_area().exact()
}

/// A point of the region in coordinates in which the parallels are level.
#[derive(Debug, Clone)]
struct Corner {
    /// θ1·x + θ2.
    value: Rational,
    theta1: Rational,
}

/// The y of the slab with the largest area: where the chord that comes in is as long as the one that leaves.
fn middle(corners: &[Corner], epsilon: &Rational) -> Rational {
    let values = || corners.iter().map(|corner| &corner.value);
    let [least, most] = [values().min(), values().max()].map(|end| end.cloned().unwrap_or_default());
    let [first, last] = [least + epsilon, most - epsilon];
    let mut places: Vec<Rational> = values().flat_map(|value| [value - epsilon, value + epsilon]).collect();
    places.retain(|place| first <= *place && *place <= last);
    places.sort();
    places.dedup();
    let growth = |y: &Rational| chord(corners, &(y + epsilon)) - chord(corners, &(y - epsilon));
    let falling = places.partition_point(|y| growth(y).is_positive());
    match (falling.checked_sub(1).and_then(|before| places.get(before)), places.get(falling)) {
        (Some(before), Some(after)) => {
            let [rises, falls] = [growth(before), growth(after)];
            // It does not divide by zero: one of them is positive, and the other is not.
            let share = rises.checked_div(&(&rises - falls)).unwrap_or_default();
            before + share * (after - before)
        }
        (Some(only), None) | (None, Some(only)) => only.clone(),
        (None, None) => first,
    }
}

/// Returns the length of the region, in θ1, at a value that it takes.
fn chord(corners: &[Corner], value: &Rational) -> Rational {
    let mut ends: Option<[Rational; 2]> = None;
    for (one, other) in sides(corners) {
        let met = crossing(one, other, value).or_else(|| (one.value == *value).then(|| one.theta1.clone()));
        let Some(theta1) = met else { continue };
        ends = Some(match ends {
            None => [theta1.clone(), theta1],
            Some([least, most]) => [least.min(theta1.clone()), most.max(theta1)],
        });
    }
    ends.map_or_else(Rational::zero, |[least, most]| most - least)
}

/// The corners of what is at least or at most at a value.
fn clipped(corners: &[Corner], value: &Rational, is_below: bool) -> Vec<Corner> {
    let mut left = Vec::new();
    for (one, other) in sides(corners) {
        if one.value == *value || (one.value < *value) == is_below {
            left.push(one.clone());
        }
        let met = crossing(one, other, value);
        left.extend(met.map(|theta1| Corner { value: value.clone(), theta1 }));
    }
    left
}

fn sides(corners: &[Corner]) -> impl Iterator<Item = (&Corner, &Corner)> {
    corners.iter().zip(corners.iter().cycle().skip(1))
}

/// θ1 where a side passes a value strictly between its ends.
fn crossing(one: &Corner, other: &Corner, value: &Rational) -> Option<Rational> {
    let share = (value - &one.value).checked_div(&(&other.value - &one.value))?;
    let is_between = share.is_positive() && share < Rational::one();
    is_between.then(|| &one.theta1 + share * (&other.theta1 - &one.theta1))
}
