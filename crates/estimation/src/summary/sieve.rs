//! What the readings seen so far say about those to come: most of them lie strictly between the hulls of these.

use std::sync::RwLock;

use boundfit_exact::{Column, Unit};
use boundfit_geometry::grid::Sieve;

use super::support::SupportRows;

/// A sieve that all threads use, and that becomes finer while readings are taken.
pub(crate) struct SharedSieve {
    /// How many numbers of rows are listed of those that one reading stands for.
    pub(super) most_listed: usize,
    current: RwLock<Option<Current>>,
}

struct Current {
    /// Of the grid that it is for.
    units: [Unit; 2],
    sieve: Sieve,
    /// How many readings it was made from.
    rows: usize,
}

impl SharedSieve {
    /// One that lists at most so many numbers of the rows that one reading stands for.
    pub(crate) fn listing(most_listed: usize) -> Self {
        SharedSieve { most_listed, current: RwLock::default() }
    }

    /// Of two columns, those that may support a hull of all readings; see [`SupportRows::of_columns`].
    pub(super) fn support(&self, x: &Column, y: &Column, row: &dyn Fn(usize) -> usize) -> SupportRows {
        let row = |position: usize| row(position) as u64;
        if let (Column::Narrow(x), Column::Narrow(y)) = (x, y)
            && let Ok(current) = self.current.read()
            && let Some(Current { units, sieve, .. }) = current.as_ref()
            && *units == [x.unit(), y.unit()]
        {
            let points = sieve.touching_of_columns(x.counts(), y.counts(), &row, self.most_listed);
            return SupportRows::of_grid(*units, points);
        }
        SupportRows::of_columns(x, y, &row, self.most_listed)
    }

    /// Learns from the support rows of so many readings, whenever these have doubled.
    pub(super) fn learn(&self, support: &SupportRows, rows: usize) {
        let is_fresh =
            |current: &Option<Current>| current.as_ref().is_some_and(|current| rows < 2 * current.rows);
        if self.current.read().is_ok_and(|current| is_fresh(&current)) {
            return;
        }
        if let Some((units, points)) = support.grid_points()
            && let Some(sieve) = Sieve::new(&points)
            && let Ok(mut current) = self.current.write()
        {
            *current = Some(Current { units, sieve, rows });
        }
    }
}
