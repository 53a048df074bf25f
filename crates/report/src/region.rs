//! A region in reports, whatever its half-planes are called.

use boundfit_exact::Rational;
use boundfit_geometry::{Direction, Point, Region, RegionKind, Vertex};
use serde::Serialize;

use crate::style::{Number, Style};
use crate::text::{counted, list, table};

/// A region in JSON; `A` names a half-plane.
#[derive(Debug, Serialize)]
pub(crate) struct RegionJson<A> {
    kind: &'static str,
    vertices: Vec<VertexJson<A>>,
    rays: Vec<[Number; 2]>,
    lines: Vec<[Number; 2]>,
    boundaries: Vec<BoundaryJson<A>>,
    witness: Option<[Number; 2]>,
    area: Option<Number>,
    certificate: Option<CertificateJson>,
}

#[derive(Debug, Serialize)]
struct VertexJson<A> {
    theta: [Number; 2],
    active: Vec<A>,
}

/// A whole line of the boundary of a region without vertices.
#[derive(Debug, Serialize)]
struct BoundaryJson<A> {
    active: Vec<A>,
}

#[derive(Debug, Serialize)]
pub(crate) struct CertificateJson {
    pub(crate) farkas: Vec<TermJson>,
}

/// A multiple of a named half-plane. `row` is null for a condition.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct TermJson {
    pub(crate) row: Option<usize>,
    pub(crate) bound: String,
    pub(crate) multiplier: Number,
}

/// One end of an interval with its proof.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct BoundJson {
    pub(crate) value: Option<Number>,
    pub(crate) active: Vec<TermJson>,
}

/// A parameter interval with its proofs.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct IntervalJson {
    pub(crate) lower: BoundJson,
    pub(crate) upper: BoundJson,
}

impl<A> RegionJson<A> {
    /// A region; `name` gives the names of the half-planes active at a vertex or boundary, `farkas` the certificate.
    pub(crate) fn new(
        region: &Region,
        style: &Style,
        name: impl Fn(&[usize]) -> Vec<A>,
        farkas: Option<Vec<TermJson>>,
    ) -> Self {
        let direction = |d: &Direction| [d.dx(), d.dy()].map(|c| style.number(&Rational::from(c)));
        let vertex =
            |v: &Vertex| VertexJson { theta: point_json(v.point(), style), active: name(v.active()) };
        RegionJson {
            kind: region.kind().name(),
            vertices: region.vertices().iter().map(vertex).collect(),
            rays: region.rays().iter().map(direction).collect(),
            lines: region.lines().iter().map(direction).collect(),
            boundaries: region
                .boundaries()
                .iter()
                .map(|b| BoundaryJson { active: name(b.active()) })
                .collect(),
            witness: region.witness().map(|point| point_json(&point, style)),
            area: region.area().filter(|_| !region.is_empty()).map(|area| style.number(&area)),
            certificate: farkas.map(|farkas| CertificateJson { farkas }),
        }
    }
}

fn point_json(point: &Point, style: &Style) -> [Number; 2] {
    point.coordinates().map(|coordinate| style.number(&coordinate))
}

/// A point as text.
pub(crate) fn point_text(coordinates: &[Rational; 2], styles: &[Style; 2]) -> String {
    format!("({}, {})", styles[0].text(&coordinates[0]), styles[1].text(&coordinates[1]))
}

/// A direction as text; always exact.
pub(crate) fn direction_text(direction: &Direction) -> String {
    format!("({}, {})", direction.dx(), direction.dy())
}

/// The header of a table of vertices.
pub(crate) const VERTEX_HEADER: [&str; 4] = ["vertex", "theta1", "theta2", "active"];

/// The kind of a region, with the number of vertices where that varies.
pub(crate) fn region_title(region: &Region) -> String {
    match region.kind() {
        RegionKind::Polygon | RegionKind::UnboundedPolygon => {
            let count = counted(region.vertices().len(), "vertex", "vertices");
            format!("{} with {count}", region.kind().name())
        }
        kind => kind.name().to_owned(),
    }
}

/// The table of vertices. `styles` are those of the two coordinates; `name` gives the names of active half-planes.
pub(crate) fn vertex_rows(
    region: &Region,
    [style1, style2]: &[Style; 2],
    name: impl Fn(&[usize]) -> Vec<String>,
) -> Vec<Vec<String>> {
    let row = |(number, vertex): (usize, &Vertex)| {
        let [theta1, theta2] = vertex.point().coordinates();
        let active = list(name(vertex.active()).into_iter());
        vec![number.to_string(), style1.text(&theta1), style2.text(&theta2), active]
    };
    (1..).zip(region.vertices()).map(row).collect()
}

/// Where a region goes on for ever, and which lines bound it.
pub(crate) fn region_lines(region: &Region, name: impl Fn(&[usize]) -> Vec<String>) -> Vec<String> {
    let rays = region.rays();
    let rays = rays.iter().map(|ray| format!("goes on for ever in direction {}", direction_text(ray)));
    let lines = region.lines();
    let lines =
        lines.iter().map(|line| format!("goes on for ever in both directions of {}", direction_text(line)));
    let boundaries = region.boundaries().iter();
    let boundaries =
        boundaries.map(|boundary| format!("bounded by {}", list(name(boundary.active()).into_iter())));
    rays.chain(lines).chain(boundaries).collect()
}

/// The region in a line, then its vertices, rays and lines. `styles` are those of the two coordinates; `name` gives the
/// names of active half-planes.
pub(crate) fn region_text(
    region: &Region,
    styles: &[Style; 2],
    name: impl Fn(&[usize]) -> Vec<String>,
) -> String {
    let vertices = table(&VERTEX_HEADER, vertex_rows(region, styles, &name));
    let lines = region_lines(region, &name);
    let lines: String = lines.iter().map(|line| format!("  {line}\n")).collect();
    format!("{}\n{vertices}{lines}", region_title(region))
}
