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

/// The region in a line, then its vertices, rays and lines. `styles` are those of the two coordinates; `name` gives the
/// names of active half-planes.
pub(crate) fn region_text(
    region: &Region,
    styles: &[Style; 2],
    name: impl Fn(&[usize]) -> Vec<String>,
) -> String {
    let vertices = region.vertices();
    let mut text = match region.kind() {
        RegionKind::Polygon | RegionKind::UnboundedPolygon => {
            let count = counted(vertices.len(), "vertex", "vertices");
            format!("{} with {count}", region.kind().name())
        }
        kind => kind.name().to_owned(),
    };
    text.push('\n');
    if !vertices.is_empty() {
        let row = |(number, vertex): (usize, &Vertex)| {
            let [theta1, theta2] = vertex.point().coordinates();
            let active = list(name(vertex.active()).into_iter());
            vec![number.to_string(), styles[0].text(&theta1), styles[1].text(&theta2), active]
        };
        let rows = (1..).zip(vertices).map(row).collect();
        text.push_str(&table(&["vertex", "theta1", "theta2", "active"], rows));
    }
    for ray in region.rays() {
        text.push_str(&format!("  goes on for ever in direction {}\n", direction_text(&ray)));
    }
    for line in region.lines() {
        text.push_str(&format!("  goes on for ever in both directions of {}\n", direction_text(&line)));
    }
    for boundary in region.boundaries() {
        text.push_str(&format!("  bounded by {}\n", list(name(boundary.active()).into_iter())));
    }
    text
}
