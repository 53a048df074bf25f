//! A region in reports, whatever its half-planes are called.

use boundfit_estimation::ActiveBounds;
use boundfit_exact::english::{counted, list_of};
use boundfit_geometry::{Direction, Measure, Polyhedron, RegionKind};

use crate::document::{Block, Column, LongTable, Rows, THETA, Table, Text};
use crate::formula::pair;
use crate::scale::Scale;

/// The region: its kind behind a word or two, its vertices, and where it goes on for ever. `scales` are those of the two
/// coordinates; `names` lists active half-planes.
pub(crate) fn region_blocks<'a>(
    label: &str,
    set: &'a Polyhedron,
    scales: &[Scale; 2],
    names: impl Fn(&[usize]) -> String + 'a,
) -> Vec<Block<'a>> {
    let kind = kind_text(set.kind(), set.vertex_count());
    let mut blocks = vec![Block::Title(format!("{label}: {kind}").into())];
    let others = match set.kind() {
        // A look at the region of a polygon would make all of its vertices.
        RegionKind::Polygon => Vec::new(),
        _ => {
            let region = set.region();
            let boundary = |active| Text::from(format!("bounded by {}", names(active)));
            let boundaries = region.boundaries().iter().map(|own| boundary(own.active()));
            endless(&region.rays(), &region.lines()).into_iter().chain(boundaries).collect()
        }
    };
    let header = ["vertex".into(), Text::from(THETA[0]), Text::from(THETA[1]), "active".into()];
    let kinds = [Column::Number, Column::Number, Column::Number, Column::Words];
    let (scales, active) = (scales.clone(), set.active_sets());
    let vertices = move |table: &mut Rows<'_>| {
        set.homogeneous_vertices().enumerate().try_for_each(|(position, [x, y, w])| {
            table.push(position + 1);
            table.push_by(|cell| scales[0].quotient(&x, &w).write_to(cell));
            table.push_by(|cell| scales[1].quotient(&y, &w).write_to(cell));
            table.push(names(&active.of(position)));
            table.end()
        })
    };
    blocks.push(Block::LongTable(LongTable::new(header.into_iter().zip(kinds), vertices)));
    blocks.extend(others.into_iter().map(Block::Paragraph));
    blocks
}

/// Active bounds in a table: the first of them by name.
pub(crate) fn names_of(active: &ActiveBounds) -> String {
    list_of(active.names.iter(), active.more)
}

/// The table of vertices: number, both coordinates, active half-planes.
pub(crate) fn vertex_table(rows: Vec<Vec<Text>>) -> Block<'static> {
    let header = ["vertex".into(), Text::from(THETA[0]), Text::from(THETA[1]), "active".into()];
    Block::Table(Table::new(header, rows))
}

/// A kind, with the number of vertices where that varies.
pub(crate) fn kind_text(kind: RegionKind, vertices: usize) -> String {
    match kind {
        RegionKind::Polygon | RegionKind::UnboundedPolygon => {
            format!("{} with {}", kind.name(), counted(vertices, "vertex", "vertices"))
        }
        kind => kind.name().to_owned(),
    }
}

/// Returns the directions in which a set goes on for ever.
pub(crate) fn endless(rays: &[Direction], lines: &[Direction]) -> Vec<Text> {
    let towards = |words: &str, direction: &Direction| {
        Text::from(words).then(pair(direction.dx().to_string(), direction.dy().to_string()))
    };
    let rays = rays.iter().map(|ray| towards("goes on for ever in direction ", ray));
    let lines = lines.iter().map(|line| towards("goes on for ever in both directions of ", line));
    rays.chain(lines).collect()
}

/// A point that is a sum over all vertices.
pub(crate) fn measured_point(coordinates: &[Measure; 2], scales: &[Scale; 2]) -> Text {
    let [theta1, theta2] = [0, 1].map(|axis| scales[axis].measure(&coordinates[axis]));
    Text::new().mark("(").then(theta1).mark(", ").then(theta2).mark(")")
}
