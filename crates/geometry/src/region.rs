//! The result of an intersection: one of ten kinds of closed convex set.

use crate::active::Active;
use crate::constructions::{between_parallels, foot, mean, translated};
use crate::half_plane::HalfPlane;
use crate::point::{Direction, Point};
use crate::predicates::{by_angle, lexicographic};
use crate::proof::Farkas;

/// The kind of a [`Region`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RegionKind {
    /// No point.
    Empty,
    /// One point.
    Point,
    /// A bounded piece of a line.
    Segment,
    /// A half-line.
    Ray,
    /// A whole line.
    Line,
    /// Bounded, with an interior.
    Polygon,
    /// An unbounded region with an interior and at least one vertex.
    UnboundedPolygon,
    /// The strip between two parallel lines.
    Strip,
    /// One side of a line.
    HalfPlane,
    /// Everything.
    Plane,
}

impl RegionKind {
    /// All ten kinds.
    pub const ALL: [RegionKind; 10] = [
        RegionKind::Empty,
        RegionKind::Point,
        RegionKind::Segment,
        RegionKind::Ray,
        RegionKind::Line,
        RegionKind::Polygon,
        RegionKind::UnboundedPolygon,
        RegionKind::Strip,
        RegionKind::HalfPlane,
        RegionKind::Plane,
    ];

    /// Returns whether regions of this kind have no recession direction (an empty region counts as bounded).
    pub fn is_bounded(self) -> bool {
        matches!(self, RegionKind::Empty | RegionKind::Point | RegionKind::Segment | RegionKind::Polygon)
    }

    /// The name used in reports: `unbounded-polygon` and so on.
    pub fn name(self) -> &'static str {
        match self {
            RegionKind::Empty => "empty",
            RegionKind::Point => "point",
            RegionKind::Segment => "segment",
            RegionKind::Ray => "ray",
            RegionKind::Line => "line",
            RegionKind::Polygon => "polygon",
            RegionKind::UnboundedPolygon => "unbounded-polygon",
            RegionKind::Strip => "strip",
            RegionKind::HalfPlane => "half-plane",
            RegionKind::Plane => "plane",
        }
    }
}

/// A vertex with every half-plane whose boundary passes through it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Vertex {
    pub(crate) point: Point,
    pub(crate) active: Active,
}

impl Vertex {
    /// Returns the point of the vertex.
    pub fn point(&self) -> &Point {
        &self.point
    }

    /// Indices of the half-planes active here, ascending: those that shape the corner and those that only touch.
    pub fn active(&self) -> &[usize] {
        &self.active
    }
}

/// A whole line of the region's boundary, with every half-plane that it bounds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Boundary {
    pub(crate) half_plane: HalfPlane,
    pub(crate) active: Vec<usize>,
}

impl Boundary {
    /// The half-plane on the region's side of the line.
    pub fn half_plane(&self) -> &HalfPlane {
        &self.half_plane
    }

    /// Indices of the half-planes bounded by this line (from either side, when the region is a line), ascending.
    pub fn active(&self) -> &[usize] {
        &self.active
    }
}

/// No point at all, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EmptyRegion {
    pub(crate) certificate: Farkas,
}

/// A single point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PointRegion {
    pub(crate) vertex: Vertex,
}

/// A bounded piece of a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SegmentRegion {
    pub(crate) ends: [Vertex; 2],
}

/// A half-line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RayRegion {
    pub(crate) apex: Vertex,
    pub(crate) direction: Direction,
}

/// A whole line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LineRegion {
    pub(crate) boundary: Boundary,
}

/// A bounded polygon with at least three vertices.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PolygonRegion {
    pub(crate) vertices: Vec<Vertex>,
}

/// An unbounded polygon with at least one vertex.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnboundedPolygonRegion {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) first: usize,
    pub(crate) outgoing: Direction,
    pub(crate) incoming: Direction,
}

/// The region between two parallel lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StripRegion {
    pub(crate) sides: [Boundary; 2],
}

/// One side of a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HalfPlaneRegion {
    pub(crate) boundary: Boundary,
}

/// A closed convex set in the plane: the intersection of finitely many half-planes.
///
/// Two regions of the same system are equal exactly when they are the same set with the same active
/// half-planes; an empty region also compares its certificate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Region {
    /// No point.
    Empty(EmptyRegion),
    /// One point.
    Point(PointRegion),
    /// A bounded piece of a line.
    Segment(SegmentRegion),
    /// A half-line.
    Ray(RayRegion),
    /// A whole line.
    Line(LineRegion),
    /// A bounded polygon.
    Polygon(PolygonRegion),
    /// An unbounded polygon with a vertex.
    UnboundedPolygon(UnboundedPolygonRegion),
    /// The region between two parallel lines.
    Strip(StripRegion),
    /// One side of a line.
    HalfPlane(HalfPlaneRegion),
    /// Everything.
    Plane,
}

impl EmptyRegion {
    /// The proof that no point satisfies all inequalities.
    pub fn certificate(&self) -> &Farkas {
        &self.certificate
    }
}

impl RayRegion {
    /// The direction in which the half-line goes on.
    pub fn direction(&self) -> &Direction {
        &self.direction
    }
}

impl UnboundedPolygonRegion {
    /// The vertices in the order of the boundary: after the incoming ray, before the outgoing one.
    pub fn chain(&self) -> impl Iterator<Item = &Vertex> {
        self.vertices[self.first..].iter().chain(&self.vertices[..self.first])
    }

    /// The direction of the ray that leaves the last vertex of the chain.
    pub fn outgoing(&self) -> &Direction {
        &self.outgoing
    }

    /// The direction, away from the chain, of the ray on which its first vertex is reached.
    pub fn incoming(&self) -> &Direction {
        &self.incoming
    }
}

impl LineRegion {
    /// The line; its active half-planes are those on either side.
    pub fn boundary(&self) -> &Boundary {
        &self.boundary
    }
}

impl StripRegion {
    /// Both sides, the one whose outward normal has the smaller angle in [0, 2π) first.
    pub fn sides(&self) -> &[Boundary; 2] {
        &self.sides
    }
}

impl HalfPlaneRegion {
    /// The line that bounds the half-plane.
    pub fn boundary(&self) -> &Boundary {
        &self.boundary
    }
}

impl Region {
    /// Returns the kind of the region, one of ten.
    pub fn kind(&self) -> RegionKind {
        match self {
            Region::Empty(_) => RegionKind::Empty,
            Region::Point(_) => RegionKind::Point,
            Region::Segment(_) => RegionKind::Segment,
            Region::Ray(_) => RegionKind::Ray,
            Region::Line(_) => RegionKind::Line,
            Region::Polygon(_) => RegionKind::Polygon,
            Region::UnboundedPolygon(_) => RegionKind::UnboundedPolygon,
            Region::Strip(_) => RegionKind::Strip,
            Region::HalfPlane(_) => RegionKind::HalfPlane,
            Region::Plane => RegionKind::Plane,
        }
    }

    /// Returns whether there is no point in the region.
    pub fn is_empty(&self) -> bool {
        matches!(self, Region::Empty(_))
    }

    /// Returns whether the region has no recession direction (the empty region counts as bounded).
    pub fn is_bounded(&self) -> bool {
        self.kind().is_bounded()
    }

    /// The vertices, counter-clockwise, starting at the lexicographically smallest.
    pub fn vertices(&self) -> &[Vertex] {
        match self {
            Region::Point(region) => std::slice::from_ref(&region.vertex),
            Region::Segment(region) => &region.ends,
            Region::Ray(region) => std::slice::from_ref(&region.apex),
            Region::Polygon(region) => &region.vertices,
            Region::UnboundedPolygon(region) => &region.vertices,
            Region::Empty(_) | Region::Line(_) | Region::Strip(_) | Region::HalfPlane(_) | Region::Plane => {
                &[]
            }
        }
    }

    /// The whole lines that bound the region: one for a line or half-plane, two for a strip.
    pub fn boundaries(&self) -> &[Boundary] {
        match self {
            Region::Line(region) => std::slice::from_ref(&region.boundary),
            Region::HalfPlane(region) => std::slice::from_ref(&region.boundary),
            Region::Strip(region) => &region.sides,
            _ => &[],
        }
    }

    /// The distinct extreme recession directions that are not lines; counter-clockwise when there are two.
    /// A half-plane has its inner normal.
    pub fn rays(&self) -> Vec<Direction> {
        match self {
            Region::Ray(region) => vec![region.direction.clone()],
            Region::UnboundedPolygon(region) if region.outgoing == region.incoming => {
                vec![region.outgoing.clone()]
            }
            Region::UnboundedPolygon(region) => vec![region.outgoing.clone(), region.incoming.clone()],
            Region::HalfPlane(region) => vec![region.boundary.half_plane.normal().reversed()],
            _ => Vec::new(),
        }
    }

    /// A basis of the lineality space: the directions in which the region goes on both ways. The first non-zero
    /// component of each is positive.
    pub fn lines(&self) -> Vec<Direction> {
        let basis = [(1, 0), (0, 1)];
        match self {
            Region::Plane => basis.iter().filter_map(|&(x, y)| Direction::new(x.into(), y.into())).collect(),
            _ => self
                .boundaries()
                .first()
                .map(|boundary| boundary.half_plane.normal().turned_left().of_line())
                .into_iter()
                .collect(),
        }
    }

    /// A point in the relative interior of the region, the same however the region was found; `None` when empty.
    /// Exact; made of at most three vertices, so that its size does not grow with their number.
    pub fn witness(&self) -> Option<Point> {
        match self {
            Region::Empty(_) => None,
            Region::Plane => Some(Point::origin()),
            Region::Line(region) => Some(foot(&region.boundary.half_plane)),
            Region::Strip(region) => {
                let [one, other] = &region.sides;
                Some(between_parallels(&one.half_plane, &other.half_plane))
            }
            Region::HalfPlane(region) => Some(translated(&foot(&region.boundary.half_plane), &self.rays())),
            _ => {
                // Three corners of a strictly convex chain are not on one line: their mean is inside.
                let vertices = self.vertices();
                let spread = vertices.iter().step_by(vertices.len().div_ceil(3).max(1)).map(Vertex::point);
                Some(translated(&mean(spread), &self.rays()))
            }
        }
    }

    /// The proof of emptiness, when the region is empty.
    pub fn certificate(&self) -> Option<&Farkas> {
        match self {
            Region::Empty(region) => Some(&region.certificate),
            _ => None,
        }
    }
}

/// Turns a cyclic list of vertices so that it starts at the lexicographically smallest; returns where the former
/// first one went.
pub(crate) fn start_at_smallest(vertices: &mut [Vertex]) -> usize {
    let smallest = (0..vertices.len())
        .min_by(|&i, &j| lexicographic(&vertices[i].point, &vertices[j].point))
        .unwrap_or(0);
    vertices.rotate_left(smallest);
    if smallest == 0 { 0 } else { vertices.len() - smallest }
}

/// Returns what both algorithms find for a region with vertices: its boundary in counter-clockwise order, and the
/// outgoing and incoming ray when it is open. The kind follows from the counts.
pub(crate) fn from_chain(mut vertices: Vec<Vertex>, rays: Option<(Direction, Direction)>) -> Region {
    let first = start_at_smallest(&mut vertices);
    match (rays, vertices.len()) {
        (None, 1) => Region::Point(PointRegion { vertex: vertices.remove(0) }),
        (None, 2) => {
            let second = vertices.remove(1);
            Region::Segment(SegmentRegion { ends: [vertices.remove(0), second] })
        }
        (None, _) => Region::Polygon(PolygonRegion { vertices }),
        (Some((outgoing, incoming)), 1) if outgoing == incoming => {
            Region::Ray(RayRegion { apex: vertices.remove(0), direction: outgoing })
        }
        (Some((outgoing, incoming)), _) => {
            Region::UnboundedPolygon(UnboundedPolygonRegion { vertices, first, outgoing, incoming })
        }
    }
}

/// The region bounded by two different parallel lines.
pub(crate) fn from_parallels(one: Boundary, other: Boundary) -> Region {
    let ordered = by_angle(&one.half_plane, &other.half_plane).is_lt();
    Region::Strip(StripRegion { sides: if ordered { [one, other] } else { [other, one] } })
}

/// The region that is a whole line, seen from the side whose outward normal has the smaller angle in [0, 2π).
pub(crate) fn from_line(boundary: Boundary) -> Region {
    let Boundary { half_plane, active } = boundary;
    let opposite = half_plane.opposite();
    let half_plane = if by_angle(&half_plane, &opposite).is_lt() { half_plane } else { opposite };
    Region::Line(LineRegion { boundary: Boundary { half_plane, active } })
}
