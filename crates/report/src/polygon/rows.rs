//! The rows of a file of half-planes or generators, as reports name them.

use boundfit_formats::HalfPlaneFile;
use boundfit_geometry::Polyhedron;

/// The rows of the file behind inequalities that are active at a vertex or boundary, ascending, each once. For a
/// V-representation these are the rows of the points that equal the vertex or lie on the boundary.
pub(super) fn rows_of(file: &HalfPlaneFile, indices: &[usize]) -> Vec<usize> {
    let mut rows: Vec<usize> = match &file.generators {
        None => {
            indices.iter().filter_map(|&index| file.origins.get(index)).map(|origin| origin.row).collect()
        }
        Some(generators) => {
            let mut spanning = indices.iter().filter_map(|&index| generators.spanning.get(index));
            let first = spanning.next().cloned().unwrap_or_default();
            spanning.fold(first, |mut common, rows| {
                common.retain(|row| rows.binary_search(row).is_ok());
                common
            })
        }
    };
    rows.sort_unstable();
    rows.dedup();
    rows
}

/// The rows that could be left out together; an equation only when both of its directions could.
pub(super) fn redundant_rows(file: &HalfPlaneFile, polyhedron: &Polyhedron) -> Vec<usize> {
    let (needed, all): (Vec<usize>, Vec<usize>) = match &file.generators {
        Some(rows) => {
            let needed = rows.generators.irredundant(polyhedron.region());
            (needed.into_iter().map(|index| index + 1).collect(), (1..=file.rows).collect())
        }
        None => {
            let every: Vec<usize> = (0..file.origins.len()).collect();
            (rows_of(file, &polyhedron.irredundant()), rows_of(file, &every))
        }
    };
    all.into_iter().filter(|row| needed.binary_search(row).is_err()).collect()
}
