//! The readings of a line that touch a hull, found part by part.

use boundfit_exact::{Column, Rational, Unit};
use boundfit_geometry::grid::{
    GridPoint, candidates_of_columns, touching, touching_doubles, touching_of_columns,
};

use crate::hulls::touching_a_hull;
use crate::measurement::Measurement;

/// Merging waits for at least this many new rows, so that small parts do not each pay for the whole; measured: the
/// cost of merging vanishes beside that of reading from a few thousand on.
const LEAST_TO_MERGE: usize = 4096;

/// Of the readings seen so far, those on the lower or the upper hull of (x, y), repeated ones and those within edges
/// included. They depend on the readings alone, not on how these were split or in which order the parts came.
#[derive(Debug, Clone, Default)]
pub(super) struct SupportRows {
    merged: Vec<Rows>,
    pending: Vec<Rows>,
    pending_rows: usize,
}

/// Some readings.
#[derive(Debug, Clone)]
enum Rows {
    /// On a grid with a unit for each axis; a point's id is the number of its row.
    Grid { units: [Unit; 2], points: Vec<GridPoint> },
    /// Where no grid of machine integers holds them all.
    General(Vec<Measurement>),
}

impl SupportRows {
    /// Those of two columns of equal length; `row` tells the number of the row at a position, and ascends. Exact. Cost: linear
    /// in almost all cases, O(n log n) in all.
    pub(super) fn of_columns(x: &Column, y: &Column, row: &dyn Fn(usize) -> usize) -> Self {
        let read = |k: usize| reading(row(k), x.get(k), y.get(k));
        let rows = match (x, y) {
            (Column::Narrow(x), Column::Narrow(y)) => Rows::Grid {
                units: [x.unit(), y.unit()],
                points: numbered(touching_of_columns(x.counts(), y.counts(), 0), row),
            },
            (Column::Doubles(doubles_x), Column::Doubles(doubles_y)) => {
                Rows::General(touching_doubles(doubles_x, doubles_y).into_iter().map(read).collect())
            }
            _ => {
                let candidates = match (x.wide(), y.wide()) {
                    (Some(x), Some(y)) => candidates_of_columns(x.counts(), y.counts()),
                    _ => (0..x.len().min(y.len())).collect(),
                };
                Rows::General(candidates.into_iter().map(read).collect()).reduced()
            }
        };
        SupportRows { merged: vec![rows], ..SupportRows::default() }
    }

    /// Points on a grid with these units; ids are numbers of rows.
    pub(super) fn of_grid(units: [Unit; 2], points: Vec<GridPoint>) -> Self {
        SupportRows { merged: vec![Rows::Grid { units, points }], ..SupportRows::default() }
    }

    /// All points that may turn out to be extreme, on the finest of their grids; `None` when some are on none.
    pub(super) fn grid_points(&self) -> Option<([Unit; 2], Vec<GridPoint>)> {
        match united(self.merged.iter().chain(&self.pending).cloned().collect()) {
            Rows::Grid { units, points } => Some((units, points)),
            Rows::General(_) => None,
        }
    }

    /// The extreme ones of readings that are given by number of their row, x and y. Exact.
    pub(super) fn of_readings(readings: impl Iterator<Item = (usize, Rational, Rational)>) -> Self {
        let rows = readings.map(|(row, x, y)| reading(row, x, y)).collect();
        SupportRows { merged: vec![Rows::General(rows).reduced()], ..SupportRows::default() }
    }

    /// The rows of all readings that may turn out to be extreme, in no order.
    #[cfg(feature = "files")]
    pub(super) fn row_numbers(&self) -> impl Iterator<Item = usize> + '_ {
        self.merged.iter().chain(&self.pending).flat_map(Rows::row_numbers)
    }

    /// Adds the readings of another part. Exact. Cost: amortised O(log n) per reading that is kept.
    pub(super) fn merge(&mut self, other: SupportRows) {
        for part in other.merged.into_iter().chain(other.pending) {
            self.pending_rows += part.len();
            self.pending.push(part);
        }
        let merged: usize = self.merged.iter().map(Rows::len).sum();
        if self.pending_rows >= merged.max(LEAST_TO_MERGE) {
            self.settle();
        }
    }

    /// The readings, in no order, with an error bound of 0.
    pub(super) fn into_rows(mut self) -> Vec<Measurement> {
        self.settle();
        self.merged.into_iter().flat_map(Rows::into_rows).collect()
    }

    fn settle(&mut self) {
        let mut parts = std::mem::take(&mut self.merged);
        parts.append(&mut self.pending);
        self.pending_rows = 0;
        self.merged = vec![united(parts).reduced()];
    }
}

/// Points whose ids are positions, with the numbers of their rows in place of these.
pub(super) fn numbered(mut points: Vec<GridPoint>, row: &dyn Fn(usize) -> usize) -> Vec<GridPoint> {
    points.iter_mut().for_each(|point| point.id = row(point.id as usize) as u64);
    points
}

/// All readings of all parts, on one grid if there is one.
fn united(parts: Vec<Rows>) -> Rows {
    let on_grid = || {
        let finest = parts.iter().try_fold([Unit::Any; 2], |[x, y], part| match part {
            Rows::Grid { units: [own_x, own_y], .. } => Some([x.common(*own_x)?, y.common(*own_y)?]),
            Rows::General(_) => None,
        })?;
        let points = parts.iter().map(|part| part.on_grid(finest)).collect::<Option<Vec<_>>>()?;
        Some(Rows::Grid { units: finest, points: points.concat() })
    };
    on_grid().unwrap_or_else(|| Rows::General(parts.into_iter().flat_map(Rows::into_rows).collect()))
}

impl Rows {
    fn len(&self) -> usize {
        match self {
            Rows::Grid { points, .. } => points.len(),
            Rows::General(rows) => rows.len(),
        }
    }

    #[cfg(feature = "files")]
    fn row_numbers(&self) -> Vec<usize> {
        match self {
            Rows::Grid { points, .. } => points.iter().map(|point| point.id as usize).collect(),
            Rows::General(rows) => rows.iter().map(|reading| reading.row).collect(),
        }
    }

    /// Without the readings strictly between the hulls.
    fn reduced(self) -> Self {
        match self {
            Rows::Grid { units, points } => Rows::Grid { units, points: touching(points) },
            Rows::General(rows) => {
                let kept = touching_a_hull(&rows);
                Rows::General(kept.into_iter().map(|position| rows[position].clone()).collect())
            }
        }
    }

    /// The points on a grid that is not coarser; `None` where machine integers do not reach.
    fn on_grid(&self, finest: [Unit; 2]) -> Option<Vec<GridPoint>> {
        let Rows::Grid { units, points } = self else { return None };
        let factor = |axis: usize| i64::try_from(units[axis].counted_in(finest[axis])?).ok();
        let (x_factor, y_factor) = (factor(0)?, factor(1)?);
        let moved = |point: &GridPoint| {
            let (x, y) = (point.x.checked_mul(x_factor)?, point.y.checked_mul(y_factor)?);
            Some(GridPoint { x, y, id: point.id })
        };
        points.iter().map(moved).collect()
    }

    fn into_rows(self) -> Vec<Measurement> {
        match self {
            Rows::Grid { units: [x, y], points } => {
                let row = |GridPoint { x: own_x, y: own_y, id }: GridPoint| {
                    reading(id as usize, x.times(own_x.into()), y.times(own_y.into()))
                };
                points.into_iter().map(row).collect()
            }
            Rows::General(rows) => rows,
        }
    }
}

fn reading(row: usize, x: Rational, y: Rational) -> Measurement {
    Measurement::around(row, [x, Rational::one()], y, Rational::zero())
}
