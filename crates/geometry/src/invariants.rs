//! The public checker of what construction guarantees.

use boundfit_exact::Sign;
use thiserror::Error;

use crate::fan::NormalFan;
use crate::point::Direction;
use crate::predicates::{Side, Turn, approach, lexicographic, orientation, side, turn};
use crate::proof::ProofError;
use crate::region::{Region, RegionKind};
use crate::system::System;

/// A promise of [`Region`] that does not hold.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum InvariantViolation {
    /// The certificate of emptiness proves nothing.
    #[error("certificate: {0}")]
    Certificate(#[from] ProofError),
    /// A vertex violates a half-plane.
    #[error("vertex {vertex} violates inequality {index}")]
    VertexOutside {
        /// Position of the vertex.
        vertex: usize,
        /// The inequality.
        index: usize,
    },
    /// The active set of a vertex or boundary is not the set of half-planes that pass through it.
    #[error("the active set of vertex or boundary {0} is wrong")]
    ActiveSet(usize),
    /// The vertices do not turn left at every corner, starting at the smallest.
    #[error("the vertices are not in counter-clockwise order from the smallest at {0}")]
    Order(usize),
    /// A recession direction leaves the region.
    #[error("recession direction {direction} leaves inequality {index}")]
    RecessionDirection {
        /// Position of the direction, rays first.
        direction: usize,
        /// The inequality.
        index: usize,
    },
    /// The active half-planes do not bound the region on every side.
    #[error("{found} half-planes bound the region, expected {expected}")]
    NotBounded {
        /// The number that was found.
        found: usize,
        /// The number of sides the region has.
        expected: usize,
    },
}

impl Region {
    /// Checks every promise of the type against the system that the region came from.
    /// - The order of the vertices, the active sets, and the recession directions.
    /// - A half-plane of the system bounds each side.
    /// - The certificate of emptiness.
    ///
    /// Exact. Cost: inequalities times vertices.
    ///
    /// # Errors
    /// The first promise that does not hold.
    pub fn check_invariants(&self, system: &System) -> Result<(), InvariantViolation> {
        if let Some(certificate) = self.certificate() {
            return Ok(certificate.verify(system)?);
        }
        self.check_active_sets(system)?;
        self.check_order()?;
        self.check_recession(system)?;
        let found = NormalFan::of(system, self).indices().len();
        let vertices = self.vertices().len();
        let expected = match self.kind() {
            RegionKind::Empty | RegionKind::Plane => 0,
            RegionKind::HalfPlane => 1,
            RegionKind::Line | RegionKind::Strip => 2,
            RegionKind::Ray => 3,
            RegionKind::Segment => 4,
            RegionKind::Polygon => vertices,
            RegionKind::UnboundedPolygon => vertices + 1,
            // Three directions span the plane positively, or two opposite pairs.
            RegionKind::Point => found.clamp(3, 4),
        };
        if found == expected { Ok(()) } else { Err(InvariantViolation::NotBounded { found, expected }) }
    }

    fn check_active_sets(&self, system: &System) -> Result<(), InvariantViolation> {
        for (position, vertex) in self.vertices().iter().enumerate() {
            let mut active = Vec::new();
            for (index, half_plane) in system.half_planes() {
                match side(half_plane, vertex.point()) {
                    Side::Inside => {}
                    Side::Boundary => active.push(index),
                    Side::Outside => {
                        return Err(InvariantViolation::VertexOutside { vertex: position, index });
                    }
                }
            }
            if active != vertex.active() {
                return Err(InvariantViolation::ActiveSet(position));
            }
        }
        for (position, boundary) in self.boundaries().iter().enumerate() {
            let line = boundary.half_plane();
            let either_side = self.kind() == RegionKind::Line;
            let coincides = |index: &usize| {
                system
                    .half_plane(*index)
                    .is_some_and(|other| other == line || (either_side && *other == line.opposite()))
            };
            let active: Vec<usize> = (0..system.len()).filter(coincides).collect();
            if active != boundary.active() {
                return Err(InvariantViolation::ActiveSet(position));
            }
        }
        Ok(())
    }

    fn check_order(&self) -> Result<(), InvariantViolation> {
        let vertices = self.vertices();
        let count = vertices.len();
        for position in 1..count {
            if lexicographic(vertices[0].point(), vertices[position].point()).is_ge() {
                return Err(InvariantViolation::Order(position));
            }
        }
        for position in 0..if count > 2 { count } else { 0 } {
            let corner = [0, 1, 2].map(|step| vertices[(position + step) % count].point());
            if orientation(corner[0], corner[1], corner[2]) != Sign::Positive {
                return Err(InvariantViolation::Order(position));
            }
        }
        Ok(())
    }

    fn check_recession(&self, system: &System) -> Result<(), InvariantViolation> {
        let (rays, lines) = (self.rays(), self.lines());
        let opposite: Vec<Direction> = lines.iter().map(Direction::reversed).collect();
        if let [outgoing, incoming] = rays.as_slice()
            && turn(outgoing, incoming) != Turn::Left
        {
            return Err(InvariantViolation::Order(0));
        }
        for (position, direction) in rays.iter().chain(&lines).chain(&opposite).enumerate() {
            let mut half_planes = system.half_planes();
            if let Some((index, _)) = half_planes.find(|(_, h)| approach(h, direction) == Sign::Positive) {
                return Err(InvariantViolation::RecessionDirection { direction: position, index });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Rational;

    use super::*;
    use crate::half_plane::Inequality;
    use crate::proof::{Farkas, Multiplier};
    use crate::region::EmptyRegion;
    use crate::{clipping, region};

    fn system(rows: &[[i64; 3]]) -> System {
        rows.iter().map(|&[a1, a2, b]| Inequality::new(a1.into(), a2.into(), b.into())).collect()
    }

    const SQUARE: [[i64; 3]; 4] = [[1, 0, 1], [0, 1, 1], [-1, 0, 0], [0, -1, 0]];
    const QUADRANT: [[i64; 3]; 2] = [[-1, 0, 0], [0, -1, 0]];

    /// Returns what is wrong with the region of some rows, seen as that of others.
    fn taken_for(rows: &[[i64; 3]], others: &[[i64; 3]]) -> Result<(), InvariantViolation> {
        let region = clipping::intersect(&system(rows));
        assert_eq!(region.check_invariants(&system(rows)), Ok(()));
        region.check_invariants(&system(others))
    }

    #[test]
    fn a_region_is_not_that_of_other_half_planes() {
        let [right, top, left, bottom] = SQUARE;
        let outside = |vertex, index| Err(InvariantViolation::VertexOutside { vertex, index });
        let active_set = |position| Err(InvariantViolation::ActiveSet(position));
        let leaves = |direction, index| Err(InvariantViolation::RecessionDirection { direction, index });
        // The vertices are (0, 0), (1, 0), (1, 1) and (0, 1).
        assert_eq!(taken_for(&SQUARE, &[[2, 0, 1], top, left, bottom]), outside(1, 0));
        assert_eq!(taken_for(&SQUARE, &[right, [0, 2, 1], left, bottom]), outside(2, 1));
        assert_eq!(taken_for(&SQUARE, &[[1, 0, 2], top, left, bottom]), active_set(1));
        assert_eq!(taken_for(&SQUARE, &[right, top, left, bottom, [1, 1, 2]]), active_set(2));
        // Half-plane, line and strip.
        assert_eq!(taken_for(&[right], &[right, right]), active_set(0));
        assert_eq!(taken_for(&[right], &[[1, 0, 2]]), active_set(0));
        assert_eq!(taken_for(&[left, [1, 0, 0]], &[left, [1, 0, 1]]), active_set(0));
        assert_eq!(taken_for(&[left, right], &[left, right, [2, 0, 2]]), active_set(0));
        assert_eq!(taken_for(&[left, right], &[left, right, [-2, 0, 0]]), active_set(1));
        // The plane goes on along (1, 0), (0, 1) and the opposites of both.
        for (direction, row) in [right, top, left, bottom].into_iter().enumerate() {
            assert_eq!(taken_for(&[], &[row]), leaves(direction, 0));
        }
        assert_eq!(taken_for(&QUADRANT, &[left, bottom, [1, 0, 9]]), leaves(0, 2));
        assert_eq!(taken_for(&QUADRANT, &[left, bottom, [0, 1, 9]]), leaves(1, 2));
        assert_eq!(taken_for(&[left], &[left, top]), leaves(1, 1));
    }

    #[test]
    fn vertices_go_counter_clockwise_from_the_smallest() {
        let square = system(&SQUARE);
        let Region::Polygon(polygon) = clipping::intersect(&square) else { panic!("no polygon") };
        let changed = |change: fn(&mut Vec<region::Vertex>)| {
            let mut polygon = polygon.clone();
            change(&mut polygon.vertices);
            Region::Polygon(polygon).check_invariants(&square)
        };
        assert_eq!(changed(|_| ()), Ok(()));
        assert_eq!(changed(|vertices| vertices.rotate_left(1)), Err(InvariantViolation::Order(2)));
        assert_eq!(changed(|vertices| vertices[1..].reverse()), Err(InvariantViolation::Order(0)));
        assert_eq!(changed(|vertices| vertices.swap(2, 3)), Err(InvariantViolation::Order(1)));
        assert_eq!(
            changed(|vertices| drop(vertices.remove(2))),
            Err(InvariantViolation::NotBounded { found: 2, expected: 3 })
        );
        let segment = system(&[[0, 1, 0], [0, -1, 0], [1, 0, 1], [-1, 0, 0]]);
        let Region::Segment(mut ends) = clipping::intersect(&segment) else { panic!("no segment") };
        ends.ends.reverse();
        assert_eq!(Region::Segment(ends).check_invariants(&segment), Err(InvariantViolation::Order(1)));
    }

    #[test]
    fn the_rays_of_an_unbounded_polygon_turn_left() {
        let quadrant = system(&QUADRANT);
        let Region::UnboundedPolygon(mut region) = clipping::intersect(&quadrant) else {
            panic!("no unbounded polygon")
        };
        std::mem::swap(&mut region.outgoing, &mut region.incoming);
        let turned = Region::UnboundedPolygon(region).check_invariants(&quadrant);
        assert_eq!(turned, Err(InvariantViolation::Order(0)));
    }

    #[test]
    fn a_certificate_must_prove_emptiness() {
        let empty = system(&[[1, 0, 0], [-1, 0, -1]]);
        let claimed = |values: [i64; 2]| {
            let multiplier =
                |(index, value): (usize, i64)| Multiplier { index, value: Rational::from(value) };
            let certificate = Farkas::new(values.into_iter().enumerate().map(multiplier).collect());
            Region::Empty(EmptyRegion { certificate }).check_invariants(&empty)
        };
        assert_eq!(claimed([2, 2]), Ok(()));
        assert_eq!(claimed([1, 2]), Err(ProofError::WrongForm.into()));
        assert_eq!(claimed([0, 1]), Err(ProofError::NotPositive(0).into()));
    }
}
