//! What the readings seen so far say about those to come: most of them lie strictly between the hulls of these.

use std::sync::RwLock;

use boundfit_formats::Column;
use boundfit_geometry::grid::Sieve;

use super::columns::LineColumns;
use super::extremes::Extremes;

/// A sieve that all threads use, and that becomes finer while readings are taken.
#[derive(Default)]
pub(super) struct SharedSieve {
    current: RwLock<Option<Current>>,
}

struct Current {
    /// Of the grid that it is for.
    exponents: [i32; 2],
    sieve: Sieve,
    /// How many readings it was made from.
    rows: usize,
}

impl SharedSieve {
    /// Of two columns, those that may be extreme among all readings; see [`Extremes::of_columns`].
    pub(super) fn extremes(&self, columns: &LineColumns, first_row: usize) -> Extremes {
        if let (Column::Scaled(x), Column::Scaled(y)) = (columns.x, columns.y)
            && let Ok(current) = self.current.read()
            && let Some(Current { exponents, sieve, .. }) = current.as_ref()
            && *exponents == [x.exponent, y.exponent]
        {
            let points = sieve.touching_of_columns(&x.mantissas, &y.mantissas, first_row as u64);
            return Extremes::of_grid(*exponents, points);
        }
        Extremes::of_columns(columns, first_row)
    }

    /// Learns from the extremes of so many readings, whenever these have doubled.
    pub(super) fn learn(&self, extremes: &Extremes, rows: usize) {
        let is_fresh =
            |current: &Option<Current>| current.as_ref().is_some_and(|current| rows < 2 * current.rows);
        if self.current.read().is_ok_and(|current| is_fresh(&current)) {
            return;
        }
        if let Some((exponents, points)) = extremes.grid_points()
            && let Some(sieve) = Sieve::new(&points)
            && let Ok(mut current) = self.current.write()
        {
            *current = Some(Current { exponents, sieve, rows });
        }
    }
}
