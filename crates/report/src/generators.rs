//! A region as points, rays and lines: it is the convex hull of the points, plus the cone of the rays, plus the span of
//! the lines.

use boundfit_exact::Rational;
use boundfit_geometry::constructions::foot;
use boundfit_geometry::{Direction, Point, Region};

/// The kind of a generator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum GeneratorKind {
    /// A vertex.
    Vertex,
    /// A point on a boundary without vertices, or any point of the plane.
    Point,
    /// A direction in which the region goes on.
    Ray,
    /// A direction in which it goes on both ways.
    Line,
}

impl GeneratorKind {
    /// The name in files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            GeneratorKind::Vertex => "vertex",
            GeneratorKind::Point => "point",
            GeneratorKind::Ray => "ray",
            GeneratorKind::Line => "line",
        }
    }
}

/// A point or direction.
pub(crate) struct Generator<'a> {
    pub(crate) kind: GeneratorKind,
    pub(crate) coordinates: [Rational; 2],
    /// The half-planes whose boundary passes through a point.
    pub(crate) active: &'a [usize],
}

/// The names of the first of the half-planes with some indices, and how many there are beside them.
pub type ActiveNames<'a> = dyn Fn(&[usize]) -> (Vec<String>, usize) + 'a;

impl Generator<'_> {
    /// The names of the active half-planes, separated by `; `; one that is there for both directions of a row is
    /// named once. If there are more names than are listed, `and 17 more` comes last.
    pub(crate) fn active_names(&self, names: &ActiveNames<'_>) -> String {
        let (mut names, more) = names(self.active);
        names.dedup();
        names.extend((more > 0).then(|| format!("and {more} more")));
        names.join("; ")
    }
}

/// The generators of a region: vertices counter-clockwise or else points, then rays, then lines; none when it is empty.
pub(crate) fn generators(region: &Region) -> Vec<Generator<'_>> {
    let vertices = region.vertices().iter().map(|vertex| Generator {
        kind: GeneratorKind::Vertex,
        coordinates: vertex.point().coordinates(),
        active: vertex.active(),
    });
    let boundaries = region.boundaries().iter().map(|boundary| Generator {
        kind: GeneratorKind::Point,
        coordinates: foot(boundary.half_plane()).coordinates(),
        active: boundary.active(),
    });
    let origin = matches!(region, Region::Plane).then(|| Generator {
        kind: GeneratorKind::Point,
        coordinates: Point::origin().coordinates(),
        active: &[],
    });
    let directions = |kind| {
        move |direction: Direction| {
            let coordinates = [direction.dx(), direction.dy()].map(Rational::from);
            Generator { kind, coordinates, active: &[] }
        }
    };
    let rays = region.rays().into_iter().map(directions(GeneratorKind::Ray));
    let lines = region.lines().into_iter().map(directions(GeneratorKind::Line));
    vertices.chain(boundaries).chain(origin).chain(rays).chain(lines).collect()
}
