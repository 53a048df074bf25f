//! The readings of a line that touch a hull, found part by part.

use boundfit_exact::Rational;
use boundfit_formats::Column;
use boundfit_geometry::grid::{
    GridPoint, candidates_of_columns, touching, touching_doubles, touching_of_columns,
};

use super::columns::LineColumns;
use super::sums::power_of_ten;
use crate::hulls::touching_a_hull;
use crate::measurements::Measurement;

/// Merging waits for at least this many new rows, so that small parts do not each pay for the whole; measured: the
/// cost of merging vanishes beside that of reading from a few thousand on.
const LEAST_TO_MERGE: usize = 4096;

/// Of the readings seen so far, those on the lower or the upper hull of (x, y), repeated ones and those within edges
/// included. They depend on the readings alone, not on how these were split or in which order the parts came.
#[derive(Debug, Clone, Default)]
pub(super) struct Extremes {
    merged: Vec<Part>,
    pending: Vec<Part>,
    pending_rows: usize,
}

/// Some readings.
#[derive(Debug, Clone)]
enum Part {
    /// On a grid whose units are powers of ten; a point's id is the number of its row.
    Grid { exponents: [i32; 2], points: Vec<GridPoint> },
    /// Where no grid of machine integers holds them all.
    General(Vec<Measurement>),
}

impl Extremes {
    /// The extreme ones of two columns of equal length whose rows are numbered from `first_row`. Exact. Cost: linear
    /// in almost all cases, O(n log n) in all.
    pub(super) fn of_columns(columns: &LineColumns, first_row: usize) -> Self {
        let LineColumns { x, y, wide } = columns;
        let read = |k: usize| reading(first_row + k, x.get(k), y.get(k));
        let part = match (x, y) {
            (Column::Scaled(x), Column::Scaled(y)) => Part::Grid {
                exponents: [x.exponent, y.exponent],
                points: touching_of_columns(&x.mantissas, &y.mantissas, first_row as u64),
            },
            (Column::Doubles(doubles_x), Column::Doubles(doubles_y)) => {
                Part::General(touching_doubles(doubles_x, doubles_y).into_iter().map(read).collect())
            }
            _ => {
                let candidates = match wide {
                    Some([x, y]) => candidates_of_columns(&x.mantissas, &y.mantissas),
                    None => (0..x.len().min(y.len())).collect(),
                };
                Part::General(candidates.into_iter().map(read).collect()).reduced()
            }
        };
        Extremes { merged: vec![part], ..Extremes::default() }
    }

    /// Points on a grid whose units have these exponents; ids are numbers of rows.
    pub(super) fn of_grid(exponents: [i32; 2], points: Vec<GridPoint>) -> Self {
        Extremes { merged: vec![Part::Grid { exponents, points }], ..Extremes::default() }
    }

    /// All points that may turn out to be extreme, on the finest of their grids; `None` when some are on none.
    pub(super) fn grid_points(&self) -> Option<([i32; 2], Vec<GridPoint>)> {
        match united(self.merged.iter().chain(&self.pending).cloned().collect()) {
            Part::Grid { exponents, points } => Some((exponents, points)),
            Part::General(_) => None,
        }
    }

    /// The extreme ones of readings that are given by number of their row, x and y. Exact.
    pub(super) fn of_readings(readings: impl Iterator<Item = (usize, Rational, Rational)>) -> Self {
        let rows = readings.map(|(row, x, y)| reading(row, x, y)).collect();
        Extremes { merged: vec![Part::General(rows).reduced()], ..Extremes::default() }
    }

    /// The rows of all readings that may turn out to be extreme, in no order.
    pub(super) fn row_numbers(&self) -> impl Iterator<Item = usize> + '_ {
        self.merged.iter().chain(&self.pending).flat_map(Part::row_numbers)
    }

    /// Adds the readings of another part. Exact. Cost: amortised O(log n) per reading that is kept.
    pub(super) fn merge(&mut self, other: Extremes) {
        for part in other.merged.into_iter().chain(other.pending) {
            self.pending_rows += part.len();
            self.pending.push(part);
        }
        let merged: usize = self.merged.iter().map(Part::len).sum();
        if self.pending_rows >= merged.max(LEAST_TO_MERGE) {
            self.settle();
        }
    }

    /// The readings, by row, with an error bound of 0.
    pub(super) fn into_rows(mut self) -> Vec<Measurement> {
        self.settle();
        let mut rows: Vec<Measurement> = self.merged.into_iter().flat_map(Part::into_rows).collect();
        rows.sort_by_key(|reading| reading.row);
        rows
    }

    fn settle(&mut self) {
        let mut parts = std::mem::take(&mut self.merged);
        parts.append(&mut self.pending);
        self.pending_rows = 0;
        self.merged = vec![united(parts).reduced()];
    }
}

/// All readings of all parts, on one grid if there is one.
fn united(parts: Vec<Part>) -> Part {
    let exponents = parts.iter().filter_map(|part| match part {
        Part::Grid { exponents, .. } => Some(*exponents),
        Part::General(_) => None,
    });
    let finest = exponents.reduce(|[x, y], [other_x, other_y]| [x.min(other_x), y.min(other_y)]);
    let on_grid = finest.and_then(|finest| {
        let points = parts.iter().map(|part| part.on_grid(finest)).collect::<Option<Vec<_>>>()?;
        Some(Part::Grid { exponents: finest, points: points.concat() })
    });
    on_grid.unwrap_or_else(|| Part::General(parts.into_iter().flat_map(Part::into_rows).collect()))
}

impl Part {
    fn len(&self) -> usize {
        match self {
            Part::Grid { points, .. } => points.len(),
            Part::General(rows) => rows.len(),
        }
    }

    fn row_numbers(&self) -> Vec<usize> {
        match self {
            Part::Grid { points, .. } => points.iter().map(|point| point.id as usize).collect(),
            Part::General(rows) => rows.iter().map(|reading| reading.row).collect(),
        }
    }

    /// Without the readings strictly between the hulls.
    fn reduced(self) -> Self {
        match self {
            Part::Grid { exponents, points } => Part::Grid { exponents, points: touching(points) },
            Part::General(rows) => {
                let kept = touching_a_hull(&rows);
                Part::General(kept.into_iter().map(|position| rows[position].clone()).collect())
            }
        }
    }

    /// The points on a grid that is not coarser; `None` where machine integers do not reach.
    fn on_grid(&self, finest: [i32; 2]) -> Option<Vec<GridPoint>> {
        let Part::Grid { exponents, points } = self else { return None };
        let [x_factor, y_factor] =
            [0, 1].map(|axis| 10_i64.checked_pow(exponents[axis].abs_diff(finest[axis])));
        let (x_factor, y_factor) = (x_factor?, y_factor?);
        let moved = |point: &GridPoint| {
            let (x, y) = (point.x.checked_mul(x_factor)?, point.y.checked_mul(y_factor)?);
            Some(GridPoint { x, y, id: point.id })
        };
        points.iter().map(moved).collect()
    }

    fn into_rows(self) -> Vec<Measurement> {
        match self {
            Part::Grid { exponents, points } => {
                let [x_unit, y_unit] = exponents.map(power_of_ten);
                let row = |point: GridPoint| {
                    let (x, y) = (Rational::from(point.x) * &x_unit, Rational::from(point.y) * &y_unit);
                    reading(point.id as usize, x, y)
                };
                points.into_iter().map(row).collect()
            }
            Part::General(rows) => rows,
        }
    }
}

fn reading(row: usize, x: Rational, y: Rational) -> Measurement {
    Measurement { row, regressor: [x, Rational::one()], response: y, epsilon: Rational::zero() }
}
