//! The first layers of half-planes: those that decide where at most so many of them are violated.
//!
//! In the dual plane, where `a1·θ1 + a2·θ2 ≤ b` is the point `(a1/a2, b/a2)`, the half-planes that bound θ2 from above are
//! points of which the lower hull decides the intersection. Taken away, the next hull decides the next one: convex layers
//! (onion peeling). Source: Chazelle, "On the convex layers of a planar set", *IEEE Trans. Inf. Theory* 31 (1985).

use crate::half_plane::{Constraint, HalfPlane};
use crate::hull::HullSide;
use crate::predicates::by_tightness;
use crate::touching::{Family, is_vertical};

/// The part of a hull that is a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayerOf {
    /// The corners of the hull, one of those that coincide.
    Corners,
    /// Everything on it: points within edges and repetitions as well.
    Touching,
}

/// The layers of half-planes, taken away one after the other. Half-planes that bound θ2 from above, θ2 from below, θ1
/// from the right and θ1 from the left have layers of their own. One layer here is the next of each of the four.
///
/// A point that violates a half-plane outside the first k layers violates at least one of its kind in each of these k
/// layers. So with [`LayerOf::Corners`] they decide where fewer than k + 1 half-planes are violated. With
/// [`LayerOf::Touching`] also every boundary through such a point is one of theirs, since a boundary that does not
/// touch the intersection of a layer lies outside it.
#[derive(Debug)]
pub struct Layers {
    of: LayerOf,
    families: [Family; 2],
    /// The half-planes that bound θ1 from the right and from the left, the tightest last.
    vertical: [Vec<(usize, HalfPlane)>; 2],
}

impl Layers {
    /// Returns the layers of constraints; one that holds always or never has no boundary and is in no layer. Exact.
    /// Cost: O(n log n).
    pub fn new(of: LayerOf, constraints: &[Constraint]) -> Self {
        let half_planes = || {
            constraints.iter().enumerate().filter_map(|(position, constraint)| match constraint {
                Constraint::HalfPlane(half_plane) => Some((position, half_plane)),
                Constraint::Always | Constraint::Never => None,
            })
        };
        let vertical = |faces_right: bool| {
            let own = half_planes().filter(|(_, own)| is_vertical(own, faces_right));
            let mut own: Vec<(usize, HalfPlane)> =
                own.map(|(position, own)| (position, own.clone())).collect();
            own.sort_by(|(one, f), (other, g)| by_tightness(g, f).then(other.cmp(one)));
            own
        };
        Layers {
            of,
            families: [HullSide::Lower, HullSide::Upper].map(|side| Family::new(side, half_planes())),
            vertical: [true, false].map(vertical),
        }
    }

    /// Takes the next layer away: its positions, ascending; none when all layers are taken. Exact. Cost: linear in what is left.
    pub fn take_next(&mut self) -> Vec<usize> {
        let mut taken = Vec::new();
        for family in &mut self.families {
            taken.extend(family.take_hull(self.of == LayerOf::Touching));
        }
        for vertical in &mut self.vertical {
            let Some((position, tightest)) = vertical.pop() else { continue };
            taken.push(position);
            while self.of == LayerOf::Touching && vertical.last().is_some_and(|(_, own)| *own == tightest) {
                taken.extend(vertical.pop().map(|(position, _)| position));
            }
        }
        taken.sort_unstable();
        taken
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::half_plane::Inequality;
    use crate::system::System;
    use crate::touching::touching_an_envelope;

    fn system(seed: &mut u64, count: usize, size: i64) -> System {
        let mut next = || {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((*seed >> 33) as i64 % (2 * size + 1) - size).into()
        };
        (0..count).map(|_| Inequality::new(next(), next(), next())).collect()
    }

    #[test]
    fn layers_are_what_touches_when_those_before_are_gone() {
        let mut seed = 5;
        for round in 0..300 {
            let system = system(&mut seed, round % 17, [1, 2, 6][round % 3]);
            let has_boundary = |place: &usize| system.half_plane(*place).is_some();
            let mut left: Vec<usize> = (0..system.len()).filter(has_boundary).collect();
            let mut layers = Layers::new(LayerOf::Touching, system.constraints());
            let mut corners = Layers::new(LayerOf::Corners, system.constraints());
            let mut first = true;
            while !left.is_empty() {
                let own: Vec<Constraint> =
                    left.iter().map(|&place| system.constraints()[place].clone()).collect();
                let touching: Vec<usize> = touching_an_envelope(&own).into_iter().map(|k| left[k]).collect();
                assert_eq!(layers.take_next(), touching);
                let corner = corners.take_next();
                assert!(!first || corner.iter().all(|place| touching.contains(place)));
                assert!(!first || !corner.is_empty());
                left.retain(|place| !touching.contains(place));
                first = false;
            }
            assert_eq!(layers.take_next(), Vec::<usize>::new());
        }
    }
}
