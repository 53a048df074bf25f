//! The hints that the checker gets about a set: its generators, and the half-planes that are its sides.

use boundfit_exact::Rational;
use boundfit_geometry::{
    Direction, HalfPlane, HalfPlaneRegion, LineRegion, Point, Polyhedron, RayRegion, Region, StripRegion,
    System, UnboundedPolygonRegion, Vertex,
};

use super::numbers::{column, pieces};
use crate::statements::corners;

/// A set that is not empty.
pub(super) struct Evidence {
    /// The vertices in order; of a set without any, points on its boundary lines.
    pub(super) vertices: Vec<[Rational; 2]>,
    /// The directions in which it goes on.
    pub(super) rays: Vec<Direction>,
    /// A term of the type `certificate`.
    pub(super) certificate: String,
}

/// Numbers of half-planes by their places in the system.
pub(super) type Number<'a> = &'a dyn Fn(usize) -> Option<usize>;

/// The numbers of half-planes that have them by their places, from 1.
#[expect(clippy::unnecessary_wraps, reason = "other theorems have half-planes without numbers")]
pub(super) fn by_place(index: usize) -> Option<usize> {
    Some(index + 1)
}

impl Evidence {
    /// `None` for an empty set, or when a half-plane has no number.
    pub(super) fn new(polyhedron: &Polyhedron, number: Number) -> Option<Self> {
        let region = polyhedron.region();
        match region {
            Region::Empty(_) => None,
            Region::Polygon(_) => {
                let sides = sides_by_vertex(polyhedron, number)?;
                Some(Evidence::bounded(region.vertices(), format!("Polygon {}", listed(&sides))))
            }
            Region::Point(_) => {
                let sides = polyhedron.irredundant_by_angle().iter().map(|&index| number(index));
                let sides: Vec<usize> = sides.collect::<Option<_>>()?;
                Some(Evidence::bounded(region.vertices(), format!("Pinned {}", listed(&sides))))
            }
            Region::Segment(_) => segment(polyhedron, number),
            Region::UnboundedPolygon(own) => unbounded(polyhedron, own, number),
            Region::Ray(own) => ray(polyhedron, own, number),
            Region::Strip(own) => strip(own, number),
            Region::HalfPlane(own) => half_plane(own, number),
            Region::Line(own) => whole_line(polyhedron.system(), own, number),
            Region::Plane => plane(),
        }
    }

    /// The definitions of vertices, rays and certificate by these names.
    pub(super) fn definitions(&self, [vertices, rays, certificate]: [&str; 3]) -> String {
        let ray_list: Vec<String> =
            self.rays.iter().map(|own| format!("({}, {})", own.dx(), own.dy())).collect();
        format!(
            "Definition {vertices} : list (Q * Q) := map point (read {}).\n\
             Definition {rays} : list (Q * Q) := [{}].\n\
             Definition {certificate} : certificate := {}.\n",
            pieces(vertex_rows(&self.vertices)),
            ray_list.join("; "),
            self.certificate
        )
    }

    /// A point is in the set, over the rational and over the real numbers, where vertices and rays have these names.
    pub(super) fn hull(&self, [vertices, rays]: [&str; 2]) -> [String; 2] {
        let own = |real: &str| match self.rays.is_empty() {
            true => format!("hull{real} {vertices} p"),
            false => format!("hull_and_cone{real} {vertices} {rays} p"),
        };
        ["", "R"].map(own)
    }

    fn bounded<'a>(vertices: impl IntoIterator<Item = &'a Vertex>, certificate: String) -> Self {
        Evidence { vertices: points(vertices), rays: Vec::new(), certificate }
    }
}

fn unbounded(polyhedron: &Polyhedron, region: &UnboundedPolygonRegion, number: Number) -> Option<Evidence> {
    let (incoming, outgoing) = (region.incoming(), region.outgoing());
    let mut sides = sides_from_gap(polyhedron, number)?;
    let mut rays = vec![incoming.clone()];
    if outgoing != incoming {
        rays.push(outgoing.clone());
        // Between two directions lies the line at infinity.
        sides.push(0);
    }
    Some(Evidence {
        vertices: points(region.chain()),
        rays,
        certificate: format!("Polygon {}", listed(&sides)),
    })
}

fn segment(polyhedron: &Polyhedron, number: Number) -> Option<Evidence> {
    let vertices = polyhedron.region().vertices();
    let [v, w] = vertices else { return None };
    let [h, other] = line(polyhedron.system(), number, v.active(), &between(v.point(), w.point())?)?;
    let end = |own: &Vertex, far: &Vertex| {
        let mut only = own.active().iter().filter(|index| !far.active().contains(index));
        number(*only.next()?)
    };
    Some(Evidence::bounded(vertices, format!("Segment {h} {other} {} {}", end(v, w)?, end(w, v)?)))
}

fn ray(polyhedron: &Polyhedron, region: &RayRegion, number: Number) -> Option<Evidence> {
    let (system, vertices) = (polyhedron.system(), polyhedron.region().vertices());
    let [apex] = vertices else { return None };
    let along = region.direction();
    let [h, other] = line(system, number, apex.active(), along)?;
    let ends = |own: &HalfPlane| !(own.a1() * along.dx() + own.a2() * along.dy()).is_zero();
    let end = apex.active().iter().find(|&&index| system.half_plane(index).is_some_and(ends));
    let certificate = format!("Ray {h} {other} {}", number(*end?)?);
    Some(Evidence { vertices: points(vertices), rays: vec![along.clone()], certificate })
}

fn strip(region: &StripRegion, number: Number) -> Option<Evidence> {
    let [one, other] = region.sides();
    let along = one.half_plane().normal().turned_left();
    let [a, b] = [number(*one.active().first()?)?, number(*other.active().first()?)?];
    Some(Evidence {
        vertices: vec![foot(one.half_plane())?, foot(other.half_plane())?],
        rays: vec![along.clone(), along.reversed()],
        certificate: format!("Strip {}", listed(&[a, b, b, a])),
    })
}

fn half_plane(region: &HalfPlaneRegion, number: Number) -> Option<Evidence> {
    let side = region.boundary();
    let normal = side.half_plane().normal();
    let along = normal.turned_left();
    Some(Evidence {
        vertices: vec![foot(side.half_plane())?],
        rays: vec![along.clone(), normal.reversed(), along.reversed()],
        certificate: format!("HalfPlane {}", number(*side.active().first()?)?),
    })
}

fn whole_line(system: &System, region: &LineRegion, number: Number) -> Option<Evidence> {
    let side = region.boundary();
    let along = side.half_plane().normal().turned_left();
    let [h, other] = line(system, number, side.active(), &along)?;
    Some(Evidence {
        vertices: vec![foot(side.half_plane())?],
        rays: vec![along.clone(), along.reversed()],
        certificate: format!("Line {h} {other}"),
    })
}

fn plane() -> Option<Evidence> {
    let ray = |(x, y): (i64, i64)| Direction::new(x.into(), y.into());
    Some(Evidence {
        vertices: vec![[Rational::zero(), Rational::zero()]],
        rays: [(1, 0), (-1, 0), (0, 1), (0, -1)].into_iter().map(ray).collect::<Option<_>>()?,
        certificate: "Everything".to_owned(),
    })
}

/// The number of vertices beyond which both coordinates of each have one denominator: they are longer to read, and shorter to compute with.
const MANY_VERTICES: usize = 100;

/// The vertices as rows of text.
fn vertex_rows(vertices: &[[Rational; 2]]) -> Vec<String> {
    if vertices.len() > MANY_VERTICES {
        let row = |[x, y]: &[Rational; 2]| {
            let ([x, y], w) = Rational::over_common_denominator([x, y]);
            format!("{x}/{w},{y}/{w}")
        };
        return vertices.iter().map(row).collect();
    }
    let coordinate = |index: usize| {
        let values: Vec<_> = vertices.iter().map(|own| own.get(index).cloned()).collect();
        column(&values)
    };
    coordinate(0).into_iter().zip(coordinate(1)).map(|(x, y)| format!("{x},{y}")).collect()
}

/// Lists the half-planes of [`contradicting`] as text that the theory reads.
pub(super) fn contradiction(polyhedron: &Polyhedron, number: Number) -> Option<String> {
    Some(listed(&contradicting(polyhedron, number)?))
}

/// The half-planes of an empty set, at most three, that contradict each other, by angle; `None` if it is not empty.
pub(super) fn contradicting(polyhedron: &Polyhedron, number: Number) -> Option<Vec<usize>> {
    let multipliers = polyhedron.region().certificate()?.multipliers();
    let mut indices: Vec<usize> = multipliers.iter().map(|own| own.index).collect();
    if let [a, b, _] = indices[..] {
        let system = polyhedron.system();
        let [a, b] = [system.half_plane(a)?, system.half_plane(b)?];
        if (a.a1() * b.a2() - a.a2() * b.a1()).is_negative() {
            indices.reverse();
        }
    }
    indices.into_iter().map(number).collect()
}

/// Numbers as text that the theory reads.
fn listed(numbers: &[usize]) -> String {
    format!("(map number_of (read {}))", pieces(numbers.iter().map(ToString::to_string)))
}

fn points<'a>(vertices: impl IntoIterator<Item = &'a Vertex>) -> Vec<[Rational; 2]> {
    vertices.into_iter().map(|vertex| vertex.point().coordinates()).collect()
}

/// Returns the side of a polygon that leaves each vertex, counter-clockwise.
fn sides_by_vertex(polyhedron: &Polyhedron, number: Number) -> Option<Vec<usize>> {
    let sides = polyhedron.irredundant_by_angle();
    let mut found = vec![0; polyhedron.region().vertices().len()];
    for (corner, &next) in corners(polyhedron).into_iter().zip(sides.iter().cycle().skip(1)) {
        *found.get_mut(corner?)? = number(next)?;
    }
    found.iter().all(|&side| side > 0).then_some(found)
}

/// The sides of an unbounded polygon by angle, after the gap.
fn sides_from_gap(polyhedron: &Polyhedron, number: Number) -> Option<Vec<usize>> {
    let sides = polyhedron.irredundant_by_angle();
    let gap = corners(polyhedron).iter().position(Option::is_none)?;
    sides.iter().cycle().skip(gap + 1).take(sides.len()).map(|&index| number(index)).collect()
}

/// The half-planes of a line with the set on the left of a direction along it, and on its right.
fn line(system: &System, number: Number, active: &[usize], along: &Direction) -> Option<[usize; 2]> {
    let outward = |side: &Direction| {
        let own =
            active.iter().find(|&&index| system.half_plane(index).is_some_and(|own| own.normal() == *side));
        number(*own?)
    };
    Some([outward(&along.turned_right())?, outward(&along.turned_left())?])
}

/// The direction from one point to another.
fn between(from: &Point, to: &Point) -> Option<Direction> {
    let ([x, y], [to_x, to_y]) = (from.coordinates(), to.coordinates());
    Direction::from_rational(&[&to_x - &x, &to_y - &y])
}

/// The point of a boundary line that is nearest to the origin: a·b/|a|².
fn foot(half_plane: &HalfPlane) -> Option<[Rational; 2]> {
    let (a1, a2, b) = (half_plane.a1(), half_plane.a2(), half_plane.b());
    let size = &a1 * &a1 + &a2 * &a2;
    Some([Rational::new(a1 * &b, size.clone())?, Rational::new(a2 * b, size)?])
}
