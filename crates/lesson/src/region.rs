//! A region by the indices of its points and half-planes.

use std::ops::Range;

use boundfit_geometry::{Boundary, Direction, HalfPlane, Point, Region, Vertex};
use serde::Serialize;

use crate::points::Points;

/// A region. Vertices are indices of points, counter-clockwise; rays and lines are exact integer directions; boundaries
/// are half-planes, one for each whole line that bounds a region without vertices.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct IndexedRegion {
    kind: &'static str,
    vertices: Vec<usize>,
    rays: Vec<[String; 2]>,
    lines: Vec<[String; 2]>,
    boundaries: Vec<usize>,
}

impl IndexedRegion {
    pub(crate) fn new(region: &Region, points: &mut Points) -> Self {
        let direction = |direction: &Direction| [direction.dx().to_string(), direction.dy().to_string()];
        let first_active = |boundary: &Boundary| boundary.active().first().copied();
        IndexedRegion {
            kind: region.kind().name(),
            vertices: region.vertices().iter().map(|vertex| points.index(vertex.point())).collect(),
            rays: region.rays().iter().map(direction).collect(),
            lines: region.lines().iter().map(direction).collect(),
            boundaries: region.boundaries().iter().filter_map(first_active).collect(),
        }
    }

    /// Returns whether no whole line bounds the region.
    pub(crate) fn has_no_boundaries(&self) -> bool {
        self.boundaries.is_empty()
    }

    /// This region of a system that lacks these half-planes, by the indices of the whole one.
    pub(crate) fn skipping(mut self, lacking: Range<usize>) -> Self {
        let count = lacking.len();
        self.boundaries.iter_mut().filter(|index| **index >= lacking.start).for_each(|index| *index += count);
        self
    }
}

/// Returns whether two regions are the same set, whatever half-planes describe them.
pub(crate) fn same_set(one: &Region, other: &Region) -> bool {
    fn points(region: &Region) -> impl Iterator<Item = &Point> {
        region.vertices().iter().map(Vertex::point)
    }
    fn sides(region: &Region) -> impl Iterator<Item = &HalfPlane> {
        region.boundaries().iter().map(Boundary::half_plane)
    }
    one.kind() == other.kind()
        && points(one).eq(points(other))
        && one.rays() == other.rays()
        && one.lines() == other.lines()
        && sides(one).eq(sides(other))
}
