//! The single rows whose removal mends an empty set.

use crate::{BoundName, Fit, Fps, Measurements, Minimax, Problem};

/// Returns every row of an empty FPS whose removal alone, with both of its bounds, leaves some parameter feasible, in
/// ascending order. Returns `None` when the set is not empty, or when not every reading is in memory. A reading that
/// is not in memory could take the place of the removed one. Exact.
///
/// Whoever takes one inequality out of a contradictory system and makes it consistent has taken it out of every
/// contradiction, so that only the rows of one need be tried. Cost: that of at most three feasible sets.
pub fn mending_rows(problem: &Problem, fit: &Fit) -> Option<Vec<usize>> {
    let Problem { measurements, conditions } = problem;
    let contradiction = fit.contradiction(measurements.error_bound())?;
    let whole = measurements.whole();
    let all = whole.as_ref().unwrap_or(measurements).all()?;
    let mut rows: Vec<usize> = contradiction
        .iter()
        .filter_map(|(name, _)| match name {
            BoundName::Upper(row) | BoundName::Lower(row) => Some(*row),
            BoundName::Where(_) | BoundName::WhereUpper(_) | BoundName::WhereLower(_) => None,
        })
        .collect();
    rows.sort_unstable();
    rows.dedup();
    rows.retain(|row| {
        let rest = all.iter().filter(|measurement| measurement.row != *row).cloned().collect();
        let (model, bound) = (measurements.model().clone(), measurements.error_bound().clone());
        let rest = Measurements::new(model, measurements.response().to_owned(), bound, rest);
        match rest.error_bound().uniform().filter(|_| rest.has_hulls()) {
            // Two hulls and no polygon.
            Some(bound) => Minimax::new(&rest, conditions).is_some_and(|minimax| minimax.least <= *bound),
            None => !Fps::new(&rest, conditions).polyhedron().is_empty(),
        }
    });
    Some(rows)
}
