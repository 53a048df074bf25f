//! The half-planes that can be active, whatever else is known: those that touch one of four sets that are never
//! empty.
//!
//! The half-planes with `a2 > 0` bound θ2 from above by linear functions of θ1, and their intersection lies below the
//! lower envelope of these. Half-planes with `a2 < 0` bound θ2 from below, and half-planes with `a2 = 0` bound θ1
//! from the right or from the left. A boundary that meets the intersection of all half-planes meets that of its own
//! kind. Each of the four is never empty, so that what touches it can be found part by part, also where the whole has
//! no solution. In the dual plane, where `a1·θ1 + a2·θ2 ≤ b` is the point `(a1/a2, b/a2)`, the envelopes are a lower
//! and an upper hull.

use std::cmp::Ordering;

use crate::half_plane::{Constraint, HalfPlane};
use crate::hull::{Hull, HullSide, Site};
use crate::point::Point;
use crate::predicates::{by_theta1, by_tightness, lexicographic, orientation};

/// An inequality whose boundary touches the intersection of its own kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Touch {
    /// The position among the inequalities.
    pub position: usize,
    /// The two half-planes that meet at the vertex, if one meets its envelope in a vertex alone; their slopes are on
    /// either side of its own. Whatever else is known, all of one vertex touch the whole or none does, but for these
    /// two.
    pub vertex: Option<[usize; 2]>,
}

/// Returns the positions of inequalities whose boundaries touch the intersection of their own kind (above, below,
/// right or left), ascending. Repeated ones count, and so does the first that holds nowhere. The others are strictly
/// redundant.
///
/// Exact. It depends on the inequalities alone, so that parts can be reduced first, in any order: what touches in all touches
/// in its part. Cost: O(n log n).
pub fn touching_an_envelope(constraints: &[Constraint]) -> Vec<usize> {
    touches_of_envelopes(constraints).iter().map(|touch| touch.position).collect()
}

/// [`touching_an_envelope`], and where each of them touches.
pub fn touches_of_envelopes(constraints: &[Constraint]) -> Vec<Touch> {
    let half_planes = || {
        constraints.iter().enumerate().filter_map(|(position, constraint)| match constraint {
            Constraint::HalfPlane(half_plane) => Some((position, half_plane)),
            Constraint::Always | Constraint::Never => None,
        })
    };
    let alone = |position: usize| Touch { position, vertex: None };
    let never = constraints.iter().position(|constraint| *constraint == Constraint::Never);
    let mut touching: Vec<Touch> = never.into_iter().map(alone).collect();
    for side in [HullSide::Lower, HullSide::Upper] {
        let family = Family::new(side, half_planes());
        let hull = family.hull();
        let position = |place: usize| family.sorted[place].position;
        touching.extend(hull.support_by_edge(&family.sorted).map(|(own, edge)| Touch {
            position: position(own),
            vertex: edge.map(|ends| ends.map(position)),
        }));
    }
    for faces_right in [true, false] {
        let vertical = || half_planes().filter(|(_, own)| is_vertical(own, faces_right));
        if let Some((_, tightest)) = vertical().min_by(|(_, f), (_, g)| by_tightness(f, g)) {
            let ties = vertical().filter(|(_, own)| *own == tightest);
            touching.extend(ties.map(|(position, _)| alone(position)));
        }
    }
    touching.sort_unstable_by_key(|touch| touch.position);
    touching
}

pub(crate) fn is_vertical(half_plane: &HalfPlane, faces_right: bool) -> bool {
    half_plane.a2().is_zero() && half_plane.a1().is_positive() == faces_right
}

/// Half-planes that bound θ2 from one side, as points of the dual plane.
#[derive(Debug)]
pub(crate) struct Family {
    side: HullSide,
    /// The dual points by x, then y, then position.
    sorted: Vec<Dual>,
}

/// `(a1/a2, b/a2)`.
#[derive(Debug)]
struct Dual {
    point: Point,
    position: usize,
}

impl Site for Dual {
    fn is_above_or_below(&self, other: &Self) -> bool {
        by_theta1(&self.point, &other.point).is_eq()
    }

    fn coincides(&self, other: &Self) -> bool {
        self.point == other.point
    }
}

impl Family {
    /// Returns the envelope of the half-planes that bound θ2 from above, which the lower hull decides, or from below.
    pub(crate) fn new<'a>(side: HullSide, half_planes: impl Iterator<Item = (usize, &'a HalfPlane)>) -> Self {
        let from_above = side == HullSide::Lower;
        let dual = |(position, own): (usize, &HalfPlane)| {
            let is_own = !own.a2().is_zero() && own.a2().is_positive() == from_above;
            let point = || Point::from_homogeneous(own.a1(), own.b(), own.a2());
            is_own.then(point).flatten().map(|point| Dual { point, position })
        };
        let mut sorted: Vec<Dual> = half_planes.filter_map(dual).collect();
        sorted.sort_unstable_by(Family::compare);
        Family { side, sorted }
    }

    fn compare(one: &Dual, other: &Dual) -> Ordering {
        lexicographic(&one.point, &other.point).then(one.position.cmp(&other.position))
    }

    fn hull(&self) -> Hull {
        Hull::new(self.side, &self.sorted, |p, q, r| orientation(&p.point, &q.point, &r.point))
    }

    /// Positions of the half-planes that make the corners of the hull, by ascending a1/a2.
    pub(crate) fn corners(&self) -> Vec<usize> {
        let mut corners: Vec<usize> =
            self.hull().corners().map(|place| self.sorted[place].position).collect();
        if self.side == HullSide::Upper {
            corners.reverse();
        }
        corners
    }
}

impl Family {
    /// Takes away what makes the corners of the hull, or all that touches it, as positions in no order; what is left keeps its
    /// order. Cost: linear.
    pub(crate) fn take_hull(&mut self, touching: bool) -> Vec<usize> {
        let hull = self.hull();
        let mut is_taken = vec![false; self.sorted.len()];
        if touching {
            hull.support(&self.sorted).for_each(|place| is_taken[place] = true);
        } else {
            hull.corners().for_each(|place| is_taken[place] = true);
        }
        let mut taken = Vec::new();
        let mut places = is_taken.into_iter();
        self.sorted.retain(|dual| {
            let is_own = places.next().unwrap_or(false);
            taken.extend(is_own.then_some(dual.position));
            !is_own
        });
        taken
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Rational;

    use super::*;
    use crate::half_plane::Inequality;
    use crate::polyhedron::{Polyhedron, Support};
    use crate::system::System;

    fn constraints(seed: &mut u64, count: usize, size: i64) -> Vec<Inequality> {
        let mut next = || {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            Rational::from((*seed >> 33) as i64 % (2 * size + 1) - size)
        };
        (0..count).map(|_| Inequality::new(next(), next(), next())).collect()
    }

    /// Finds touching half-planes by support functions of the plane engine: a boundary touches a set that it does not
    /// cut where the form attains its bound.
    fn by_definition(rows: &[Inequality]) -> Vec<usize> {
        let kind = |row: &Inequality| {
            let sign = |number: &Rational| (number.is_positive(), number.is_negative());
            if row.a[1].is_zero() { (sign(&row.a[0]), false) } else { (sign(&row.a[1]), true) }
        };
        let first_never = rows.iter().position(|row| row.constraint() == Constraint::Never);
        let touches = |index: &usize| {
            let row = &rows[*index];
            if row.a.iter().all(Rational::is_zero) {
                return first_never == Some(*index);
            }
            let own = rows
                .iter()
                .filter(|other| kind(other) == kind(row) && !other.a.iter().all(Rational::is_zero));
            let set = Polyhedron::intersect(System::new(own.cloned()));
            matches!(set.support(&row.a), Support::Bounded { proof, .. } if proof.value == row.b)
        };
        (0..rows.len()).filter(touches).collect()
    }

    #[test]
    fn what_touches_is_found_whole_and_part_by_part() {
        let mut seed = 3;
        for round in 0..600 {
            let rows = constraints(&mut seed, round % 13, [1, 2, 6][round % 3]);
            let system = System::new(rows.clone());
            let whole = touching_an_envelope(system.constraints());
            assert_eq!(whole, by_definition(&rows), "{rows:?}");
            let middle = rows.len() / 3;
            let mut left: Vec<usize> = touching_an_envelope(&system.constraints()[..middle]);
            left.extend(touching_an_envelope(&system.constraints()[middle..]).iter().map(|k| k + middle));
            let parts: Vec<Constraint> = left.iter().map(|&k| system.constraints()[k].clone()).collect();
            let again: Vec<usize> = touching_an_envelope(&parts).into_iter().map(|k| left[k]).collect();
            assert_eq!(again, whole, "{rows:?}");
        }
    }
}
