//! One set of a family.

use std::borrow::Cow;

use boundfit_exact::{Interval, Rational};
use boundfit_geometry::{Boundary, Direction, Measures, Point, Polyhedron, RegionKind, Vertex};

use crate::ties::ActiveBounds;

/// A set FPS(s·ε) at one s, all exact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Section {
    /// The kind of region of the set.
    pub kind: RegionKind,
    /// Counter-clockwise, the lexicographically smallest first.
    pub vertices: Vec<SectionVertex>,
    /// Extreme recession directions.
    pub rays: Vec<Direction>,
    /// Directions of the lines in it.
    pub lines: Vec<Direction>,
    /// The whole lines of the boundary of a set without vertices.
    pub boundaries: Vec<SectionBoundary>,
    /// The parameter uncertainty intervals; `None` when the set is empty.
    pub pui: Option<[Interval; 2]>,
}

/// A vertex with the bounds that are active there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SectionVertex {
    /// The place of the vertex.
    pub theta: [Rational; 2],
    /// The bounds met with equality.
    pub active: ActiveBounds,
}

/// The line normal·θ = offset, on the boundary of normal·θ ≤ offset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SectionBoundary {
    /// The outer normal.
    pub normal: Direction,
    /// The right-hand side.
    pub offset: Rational,
    /// The bounds met with equality.
    pub active: ActiveBounds,
}

impl Section {
    /// Returns the area and the centroid of the set.
    pub fn measures(&self) -> Measures<'static> {
        let corners = self.vertices.iter().map(|vertex| Point::new(&vertex.theta[0], &vertex.theta[1]));
        Measures::of(self.kind, corners.map(Cow::Owned).collect())
    }

    pub(super) fn of(polyhedron: &Polyhedron, named: impl Fn(&[usize]) -> ActiveBounds) -> Self {
        let region = polyhedron.region();
        let vertex = |vertex: &Vertex| SectionVertex {
            theta: vertex.point().coordinates(),
            active: named(vertex.active()),
        };
        let boundary = |boundary: &Boundary| SectionBoundary {
            normal: boundary.half_plane().normal(),
            offset: offset(boundary),
            active: named(boundary.active()),
        };
        Section {
            kind: region.kind(),
            vertices: region.vertices().iter().map(vertex).collect(),
            rays: region.rays(),
            lines: region.lines(),
            boundaries: region.boundaries().iter().map(boundary).collect(),
            pui: polyhedron.bounding_box(),
        }
    }
}

/// The right-hand side of a boundary in units of its primitive normal.
fn offset(boundary: &Boundary) -> Rational {
    let (half_plane, normal) = (boundary.half_plane(), boundary.half_plane().normal());
    let (own, primitive) =
        if normal.dx().is_zero() { (half_plane.a2(), normal.dy()) } else { (half_plane.a1(), normal.dx()) };
    // b / (own / primitive), in which `primitive` is not zero.
    Rational::new(half_plane.b() * primitive, own).unwrap_or_default()
}
