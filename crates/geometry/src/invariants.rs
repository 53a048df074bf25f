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
        /// How many were found.
        found: usize,
        /// How many sides the region has.
        expected: usize,
    },
}

impl Region {
    /// Checks every promise of the type against the system that the region came from: the order of the vertices, the
    /// active sets, the recession directions, that each side is bounded by a half-plane of the system, and the
    /// certificate of emptiness. Exact. Cost: inequalities times vertices.
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
