//! The normal cone of a vertex: the linear forms that are greatest there.

use boundfit_exact::Integer;

use crate::point::Direction;
use crate::predicates::{Turn, angle_order, turn};
use crate::region::Vertex;
use crate::system::System;

/// All linear forms that attain their maximum over a region at one of its vertices, as directions. They are the cone
/// of the outward normals of the half-planes active there (Rockafellar, *Convex Analysis*, section 23).
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NormalCone {
    /// Less than a half turn, counter-clockwise from the first direction to the second: the region has an interior.
    Wedge([Direction; 2]),
    /// Half a turn, counter-clockwise from the first direction to its opposite: the end of a segment or a ray.
    HalfPlane([Direction; 2]),
    /// Every direction: the region is this point.
    Plane,
}

impl NormalCone {
    /// The normal cone of a vertex of the system's region. Exact. Cost: O(n log n) for n active half-planes.
    pub fn at(system: &System, vertex: &Vertex) -> Self {
        let active = vertex.active().iter().filter_map(|&index| system.half_plane(index));
        let mut normals: Vec<Direction> = active.map(|half_plane| half_plane.normal()).collect();
        normals.sort_by(|u, v| angle_order(components(u), components(v)));
        normals.dedup();
        // Where neighbours are half a turn apart or more, nothing lies between them; no vertex has two such gaps.
        for (one, next) in normals.iter().zip(normals.iter().cycle().skip(1)) {
            match turn(one, next) {
                Turn::Right => return NormalCone::Wedge([next.clone(), one.clone()]),
                Turn::Half => return NormalCone::HalfPlane([next.clone(), one.clone()]),
                Turn::Left | Turn::None => {}
            }
        }
        NormalCone::Plane
    }

    /// The directions that bound the cone, counter-clockwise; none for the whole plane.
    pub fn generators(&self) -> &[Direction] {
        match self {
            NormalCone::Wedge(ends) | NormalCone::HalfPlane(ends) => ends,
            NormalCone::Plane => &[],
        }
    }
}

fn components(direction: &Direction) -> (&Integer, &Integer) {
    (direction.dx(), direction.dy())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Inequality, Polyhedron};

    fn cones(rows: &[[i64; 3]]) -> Vec<NormalCone> {
        let system: System =
            rows.iter().map(|&[a1, a2, b]| Inequality::new(a1.into(), a2.into(), b.into())).collect();
        let set = Polyhedron::intersect(system);
        set.region().vertices().iter().map(|vertex| NormalCone::at(set.system(), vertex)).collect()
    }

    fn ends(ends: [[i64; 2]; 2]) -> [Direction; 2] {
        ends.map(|[x, y]| Direction::new(x.into(), y.into()).unwrap())
    }

    #[test]
    fn a_corner_has_a_wedge_an_end_a_half_plane_and_a_point_everything() {
        // A half-plane that only touches the corner lies within its wedge.
        let corner = cones(&[[-1, 0, 0], [0, -1, 0], [-1, -1, 0]]);
        assert_eq!(corner, [NormalCone::Wedge(ends([[-1, 0], [0, -1]]))]);
        let ray = cones(&[[0, 1, 0], [0, -1, 0], [-2, 0, 0]]);
        assert_eq!(ray, [NormalCone::HalfPlane(ends([[0, 1], [0, -1]]))]);
        let point = cones(&[[0, 1, 0], [0, -1, 0], [-2, 0, 0], [1, 0, 0]]);
        assert_eq!((point.as_slice(), point[0].generators()), (&[NormalCone::Plane][..], &[][..]));
        // Around the positive θ1 axis, where angles start anew.
        let around = cones(&[[2, 1, 0], [2, -1, 0]]);
        assert_eq!(around, [NormalCone::Wedge(ends([[2, -1], [2, 1]]))]);
        assert_eq!(around[0].generators().len(), 2);
    }
}
