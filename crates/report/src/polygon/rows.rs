//! The rows of a file of half-planes or generators, as reports name them.

use std::collections::{HashMap, HashSet};

use boundfit_formats::HalfPlaneFile;
use boundfit_geometry::{Constraint, Polyhedron};

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
            let mut irredundant = polyhedron.irredundant();
            let within = within_equations(file, polyhedron);
            irredundant.retain(|index| !within.contains_key(index));
            (rows_of(file, &irredundant), rows_of(file, &every))
        }
    };
    all.into_iter().filter(|row| needed.binary_search(row).is_err()).collect()
}

/// The irredundant half-planes that a needed equation behind them has too, each with the half-plane of the equation. The first
/// of equal half-planes is irredundant, but the row of the equation says what both rows say.
pub(super) fn within_equations(file: &HalfPlaneFile, polyhedron: &Polyhedron) -> HashMap<usize, usize> {
    let row = |index: usize| file.origins.get(index).map(|origin| origin.row);
    let mut equations: HashSet<usize> =
        file.origins.iter().filter(|origin| origin.reversed).map(|origin| origin.row).collect();
    if equations.is_empty() {
        return HashMap::new();
    }
    let irredundant = polyhedron.irredundant();
    let needed: HashSet<usize> = irredundant.iter().filter_map(|&index| row(index)).collect();
    equations.retain(|equation| needed.contains(equation));
    let constraints = polyhedron.system().constraints();
    let is_of_equation = |index: usize| row(index).is_some_and(|row| equations.contains(&row));
    let of_equations: HashMap<&Constraint, usize> = (0..constraints.len())
        .filter(|&index| is_of_equation(index))
        .map(|index| (&constraints[index], index))
        .collect();
    let others = irredundant.into_iter().filter(|&index| !is_of_equation(index));
    others.filter_map(|index| Some((index, *of_equations.get(&constraints[index])?))).collect()
}
