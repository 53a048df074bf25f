//! The path of the simplex method over a set.

use boundfit_exact::Rational;
use boundfit_geometry::constructions::value_of;
use boundfit_geometry::{Inequality, Polyhedron, System, Vertex};
use boundfit_lp::{Basis, Pivot, Row, simplex_path};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(super) struct PathJson {
    /// The vertex that it starts from.
    start: usize,
    outcome: &'static str,
    bases: Vec<BasisJson>,
}

#[derive(Debug, Serialize)]
struct BasisJson {
    half_planes: [usize; 2],
    /// The index of the vertex.
    vertex: Option<usize>,
    theta: [String; 2],
    value: String,
    multipliers: [String; 2],
    pivot: Option<PivotJson>,
}

#[derive(Debug, Serialize)]
struct PivotJson {
    leaving: usize,
    direction: [String; 2],
    /// Null where nothing stops the way.
    entering: Option<usize>,
    length: Option<String>,
    degenerate: bool,
}

impl PathJson {
    /// The path to the maximum of a form from a vertex, by its number, or from one where the form is least; `None` where the set
    /// has no vertex.
    pub(super) fn new(polyhedron: &Polyhedron, form: &[Rational; 2], start: Option<usize>) -> Option<Self> {
        let (system, vertices) = (polyhedron.system(), polyhedron.region().vertices());
        let value = |index: &usize| vertices.get(*index).map(|vertex| value_of(form, vertex.point()));
        let start = start.or_else(|| (0..vertices.len()).min_by_key(value))?;
        let row = |inequality: &Inequality| Row { a: inequality.a.clone(), b: inequality.b.clone() };
        let rows: Vec<Row> = system.inequalities().iter().map(row).collect();
        let path = simplex_path(&rows, form, first_basis(system, vertices.get(start)?)?)?;
        let is_bounded = path.last().is_some_and(|basis| basis.pivot.is_none());
        Some(PathJson {
            start,
            outcome: if is_bounded { "optimal" } else { "unbounded" },
            bases: path.iter().map(|basis| basis_json(basis, vertices)).collect(),
        })
    }
}

/// The first two half-planes active at a vertex whose boundaries cross there.
fn first_basis(system: &System, vertex: &Vertex) -> Option<[usize; 2]> {
    let (&first, others) = vertex.active().split_first()?;
    let normal = |index| Some(system.half_plane(index)?.normal().of_line());
    let second = others.iter().copied().find(|&other| normal(other) != normal(first))?;
    Some([first, second])
}

fn basis_json(basis: &Basis, vertices: &[Vertex]) -> BasisJson {
    let texts = |values: &[Rational; 2]| values.each_ref().map(ToString::to_string);
    BasisJson {
        half_planes: basis.rows,
        vertex: vertices.iter().position(|vertex| vertex.point().coordinates() == basis.theta),
        theta: texts(&basis.theta),
        value: basis.value.to_string(),
        multipliers: texts(&basis.multipliers),
        pivot: basis.pivot.as_ref().map(|Pivot { leaving, direction, stop }| PivotJson {
            leaving: *leaving,
            direction: texts(direction),
            entering: stop.as_ref().map(|(entering, _)| *entering),
            length: stop.as_ref().map(|(_, length)| length.to_string()),
            degenerate: stop.as_ref().is_some_and(|(_, length)| length.is_zero()),
        }),
    }
}
