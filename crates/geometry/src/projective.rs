//! The inverse line: what the region of (θ1, θ2) looks like in terms of gain 1/θ1 and offset -θ2/θ1.

use boundfit_exact::{Endpoint, Rational};

use crate::half_plane::Inequality;
use crate::polyhedron::Polyhedron;
use crate::system::System;

/// A sign of θ1. The inverse line does not exist at θ1 = 0, so each side has an image of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// θ1 > 0, gain > 0.
    Positive,
    /// θ1 < 0, gain < 0.
    Negative,
}

/// The image of the part of a region with the given sign of θ1 under (θ1, θ2) → (1/θ1, -θ2/θ1), or `None` when the
/// region has no such part.
///
/// The map is projective, so the image of a polygon is a polygon: `a1·θ1 + a2·θ2 ≤ b` becomes
/// `-b·gain - a2·offset ≤ -a1` for positive gain and the reverse for negative gain. Exact. The result is closed: when
/// θ1 is unbounded it contains limit points with gain 0 that no θ attains. Its inequalities are the irredundant ones of
/// the region and the sign of the gain. Cost: O(h log h) for h irredundant half-planes.
pub fn inverse_line_image(polyhedron: &Polyhedron, branch: Branch) -> Option<Polyhedron> {
    let [theta1, _] = polyhedron.bounding_box()?;
    let (reaches, sign) = match branch {
        Branch::Positive => (is_positive(theta1.upper()), Rational::one()),
        Branch::Negative => (is_negative(theta1.lower()), -Rational::one()),
    };
    if !reaches {
        return None;
    }
    let inequalities = polyhedron.system().inequalities();
    let mut image: System = polyhedron
        .irredundant()
        .into_iter()
        .map(|index| {
            let Inequality { a: [a1, a2], b } = &inequalities[index];
            Inequality::new(-(b * &sign), -(a2 * &sign), -(a1 * &sign))
        })
        .collect();
    image.push(Inequality::new(-sign, Rational::zero(), Rational::zero()));
    Some(Polyhedron::intersect(image))
}

fn is_positive(end: &Endpoint) -> bool {
    end.value().is_none_or(Rational::is_positive)
}

fn is_negative(end: &Endpoint) -> bool {
    end.value().is_none_or(Rational::is_negative)
}
