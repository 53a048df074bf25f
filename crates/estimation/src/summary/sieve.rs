//! The consequences of the readings seen so far for the readings to come: most of these lie strictly between the
//! hulls of the former.

use std::sync::RwLock;

use boundfit_exact::{Column, Unit};
use boundfit_geometry::grid::{RoundedSieve, Sieve};

use super::support::SupportRows;

/// A sieve that all threads use, and that becomes finer while readings are taken.
pub(crate) struct SharedSieve {
    /// The largest number of rows that are listed for one reading that stands for others.
    pub(super) most_listed: usize,
    current: RwLock<Option<Current>>,
}

struct Current {
    /// The sieve with the grid that it is for; `None` where there is none.
    on_grid: Option<([Unit; 2], Sieve)>,
    /// The sieve for readings on other grids, or on none.
    rounded: Option<RoundedSieve>,
    /// The number of readings that the sieves were made from.
    rows: usize,
}

impl SharedSieve {
    /// One that lists at most so many numbers of the rows that one reading stands for.
    pub(crate) fn listing(most_listed: usize) -> Self {
        SharedSieve { most_listed, current: RwLock::default() }
    }

    /// Returns the readings of two columns that may support a hull of all readings; see [`SupportRows::of_columns`].
    pub(super) fn support(&self, x: &Column, y: &Column, row: &dyn Fn(usize) -> usize) -> SupportRows {
        let row = |position: usize| row(position) as u64;
        if let (Column::Narrow(x), Column::Narrow(y)) = (x, y)
            && let Ok(current) = self.current.read()
            && let Some(Current { on_grid: Some((units, sieve)), .. }) = current.as_ref()
            && *units == [x.unit(), y.unit()]
        {
            let points = sieve.touching_of_columns(x.counts(), y.counts(), &row, self.most_listed);
            return SupportRows::of_grid(*units, points);
        }
        match self.by_leading_digits(x, y) {
            Some(positions) => SupportRows::of_positions(x, y, positions, &row),
            None => SupportRows::of_columns(x, y, &row, self.most_listed),
        }
    }

    /// The positions of the readings that may support a hull, by what binary64 tells of them; `None` where that leaves many.
    fn by_leading_digits(&self, x: &Column, y: &Column) -> Option<Vec<usize>> {
        /// The number of readings of which at most one may remain.
        const RARE: usize = 16;
        let current = self.current.read().ok()?;
        let sieve = current.as_ref()?.rounded.as_ref()?;
        let x = x.rounded()?;
        if sieve.is_beside(&x) {
            return None;
        }
        let survivors = sieve.survivors(&x, &y.rounded()?);
        (survivors.len() * RARE <= x.len()).then_some(survivors)
    }

    /// Makes the sieves anew from the support rows, whenever the number of readings, `rows`, has doubled. It makes none where many
    /// readings support a hull: a sieve would cost more than it spares.
    pub(super) fn learn(&self, support: &SupportRows, rows: usize) {
        /// The number of readings of which at most one may support a hull.
        const RARE: usize = 4;
        if support.places() * RARE > rows {
            return;
        }
        let is_fresh =
            |current: &Option<Current>| current.as_ref().is_some_and(|current| rows < 2 * current.rows);
        if self.current.read().is_ok_and(|current| is_fresh(&current)) {
            return;
        }
        let on_grid = support.grid_points().and_then(|(units, points)| Some((units, Sieve::new(&points)?)));
        let rounded = support.rounded().and_then(|[x, y]| RoundedSieve::new(&x, &y));
        if let Ok(mut current) = self.current.write() {
            *current = Some(Current { on_grid, rounded, rows });
        }
    }
}
