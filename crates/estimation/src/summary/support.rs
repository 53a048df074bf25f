//! The readings of a line that touch a hull, found part by part.

use boundfit_exact::{Column, Rational, Unit};
use boundfit_geometry::Tally;
use boundfit_geometry::grid::{
    GridPoint, Place, candidates_of_columns, candidates_of_rounded, touching, touching_doubles,
    touching_of_columns,
};

use crate::deciding::DecidingRows;
use crate::hulls::touching_a_hull;
use crate::ties::{TiedReading, Ties};

/// The number of new readings and row numbers that merging waits for, so that small parts do not each pay for the
/// whole. Measured: from a few thousand on, merging costs next to nothing beside reading.
const LEAST_TO_MERGE: usize = 4096;

/// The readings seen so far that are on the lower or the upper hull of (x, y), with how many each stands for. Each
/// corner appears once; the first reading represents those strictly within an edge. They depend on the readings
/// alone, not on how these were split or in which order the parts came.
#[derive(Debug, Clone, Default)]
pub(super) struct SupportRows {
    merged: Vec<Rows>,
    /// True if none of the merged readings is strictly between the hulls of these, or stands beside one that represents it.
    is_settled: bool,
    pending: Vec<Rows>,
    pending_size: usize,
}

/// Some readings.
#[derive(Debug, Clone)]
enum Rows {
    /// Readings on a grid with a unit for each axis.
    Grid { units: [Unit; 2], points: Vec<GridPoint> },
    /// Readings that no grid of machine integers holds.
    General(Vec<TiedReading>),
    /// General readings, with each place within an edge. Where readings of other bounds are beside these, the places
    /// show which readings contradict each other first.
    Places(Vec<TiedReading>),
}

impl SupportRows {
    /// Returns the support of two columns of equal length; `row` returns the number of the row at a position, and
    /// ascends. At most so many numbers are listed of each. Exact. Cost: linear in almost all cases, O(n log n) in
    /// all.
    pub(super) fn of_columns(x: &Column, y: &Column, row: &dyn Fn(usize) -> u64, most: usize) -> Self {
        let rows = match (x, y) {
            (Column::Narrow(x), Column::Narrow(y)) => Rows::Grid {
                units: [x.unit(), y.unit()],
                points: touching_of_columns(x.counts(), y.counts(), row, most),
            },
            (Column::Doubles(doubles_x), Column::Doubles(doubles_y)) => {
                let places = touching_doubles(doubles_x, doubles_y, row, most).into_iter();
                let exact = |double: f64| Rational::from_f64(double).unwrap_or_default();
                let reading =
                    |Place { x, y, rows }: Place<f64>| TiedReading::of_line(rows, exact(x), exact(y));
                Rows::General(places.map(reading).collect())
            }
            _ => {
                let read = |k: usize| TiedReading::of_line(Tally::one(row(k)), x.get(k), y.get(k));
                let candidates = match (x.wide(), y.wide(), x.rounded().zip(y.rounded())) {
                    (Some(x), Some(y), _) => {
                        let [x_unit, y_unit] = [x.unit(), y.unit()];
                        let places = candidates_of_columns(x.counts(), y.counts(), row, most).into_iter();
                        let reading = |Place { x, y, rows }: Place<i128>| {
                            TiedReading::of_line(rows, x_unit.times(x), y_unit.times(y))
                        };
                        places.map(reading).collect()
                    }
                    (.., Some((x, y))) => candidates_of_rounded(&x, &y).into_iter().map(read).collect(),
                    _ => (0..x.len().min(y.len())).map(read).collect(),
                };
                Rows::General(candidates).reduced(most)
            }
        };
        SupportRows { merged: vec![rows], is_settled: true, ..SupportRows::default() }
    }

    /// Returns the support among some positions of two columns, of which most support a hull.
    pub(super) fn of_positions(
        x: &Column,
        y: &Column,
        positions: Vec<usize>,
        row: &dyn Fn(usize) -> u64,
    ) -> Self {
        let positions = positions.into_iter();
        let rows = |k: usize| Tally::one(row(k));
        let rows = match (x, y) {
            (Column::Narrow(x), Column::Narrow(y)) => {
                let point = |k: usize| GridPoint { x: x.counts()[k], y: y.counts()[k], rows: rows(k) };
                Rows::Grid { units: [x.unit(), y.unit()], points: positions.map(point).collect() }
            }
            _ => {
                let reading = |k: usize| TiedReading::of_line(rows(k), x.get(k), y.get(k));
                Rows::General(positions.map(reading).collect())
            }
        };
        SupportRows { merged: vec![rows], ..SupportRows::default() }
    }

    /// Points on a grid with these units that touch their hulls.
    pub(super) fn of_grid(units: [Unit; 2], points: Vec<GridPoint>) -> Self {
        SupportRows { merged: vec![Rows::Grid { units, points }], is_settled: true, ..SupportRows::default() }
    }

    /// The rounded coordinates of all points that may turn out to be extreme; `None` where binary64 has no such numbers.
    pub(super) fn rounded(&self) -> Option<[Vec<f64>; 2]> {
        let parts = || self.merged.iter().chain(&self.pending);
        let [mut x, mut y] = [Vec::new(), Vec::new()];
        for part in parts() {
            let [xs, ys] = part.columns();
            x.extend(xs.rounded()?);
            y.extend(ys.rounded()?);
        }
        Some([x, y])
    }

    /// All points that may turn out to be extreme, on the finest of their grids; `None` when some are on none.
    pub(super) fn grid_points(&self) -> Option<([Unit; 2], Vec<GridPoint>)> {
        if self.merged.iter().chain(&self.pending).any(|part| !matches!(part, Rows::Grid { .. })) {
            return None;
        }
        match united(self.merged.iter().chain(&self.pending).cloned().collect()) {
            Rows::Grid { units, points } => Some((units, points)),
            Rows::General(_) | Rows::Places(_) => None,
        }
    }

    /// The extreme ones of readings that are given by number of their row, x and y. Exact.
    pub(super) fn of_readings(
        readings: impl Iterator<Item = (usize, Rational, Rational)>,
        most: usize,
    ) -> Self {
        let rows = readings.map(|(row, x, y)| TiedReading::of_line(Tally::one(row as u64), x, y)).collect();
        SupportRows { merged: vec![Rows::Places(rows).reduced(most)], ..SupportRows::default() }
    }

    /// Returns the number of places at which there are readings.
    pub(super) fn places(&self) -> usize {
        let places = |part: &Rows| match part {
            Rows::Grid { points, .. } => points.len(),
            Rows::General(rows) | Rows::Places(rows) => rows.len(),
        };
        self.merged.iter().chain(&self.pending).map(places).sum()
    }

    /// The rows of all readings that may turn out to be kept, in no order.
    #[cfg(feature = "files")]
    pub(super) fn row_numbers(&self) -> impl Iterator<Item = usize> + '_ {
        self.merged.iter().chain(&self.pending).flat_map(Rows::row_numbers)
    }

    /// Adds the readings of another part. Exact. Cost: amortised O(log n) per reading that is kept.
    pub(super) fn merge(&mut self, other: SupportRows, most: usize) {
        /// The share of the readings that wait beside those that are merged: where every reading is extreme, each merging
        /// looks at all of them for nothing.
        const PATIENCE: usize = 3;
        if self.merged.is_empty() && self.pending.is_empty() {
            *self = other;
            return;
        }
        for part in other.merged.into_iter().chain(other.pending) {
            self.pending_size += part.size();
            self.pending.push(part);
        }
        let merged: usize = self.merged.iter().map(Rows::size).sum();
        if self.pending_size >= (PATIENCE * merged).max(LEAST_TO_MERGE) {
            self.settle(most);
        }
    }

    /// The readings within this error bound, and what they stand for, where they are on a grid of machine integers; the
    /// others stay.
    pub(super) fn take_grid(&mut self, epsilon: &Rational, most: usize) -> Option<(DecidingRows, Ties)> {
        self.settle(most);
        let [Rows::Grid { units, points }] = self.merged.as_slice() else { return None };
        let rows = DecidingRows::of_points(*units, points, epsilon)?;
        let mut ties = Ties::default();
        for GridPoint { rows, .. } in points.iter().filter(|point| point.rows.count() > 1) {
            ties.insert(rows.first() as usize, rows.clone());
        }
        Some((rows, ties))
    }

    /// The readings, in no order, with an error bound of 0.
    pub(super) fn into_rows(mut self, most: usize) -> Vec<TiedReading> {
        self.settle(most);
        // The one part of settled readings is taken as it is: a copy of many readings takes as long as making them.
        let mut parts = self.merged.into_iter().map(Rows::into_rows);
        let mut rows = parts.next().unwrap_or_default();
        rows.extend(parts.flatten());
        rows
    }

    fn settle(&mut self, most: usize) {
        if self.is_settled && self.pending.is_empty() {
            return;
        }
        let mut parts = std::mem::take(&mut self.merged);
        parts.append(&mut self.pending);
        self.pending_size = 0;
        self.merged = vec![united(parts).reduced(most)];
        self.is_settled = true;
    }
}

/// The x and y of readings.
fn columns_of(rows: &[TiedReading]) -> [Column; 2] {
    let [x, y]: [fn(&TiedReading) -> &Rational; 2] =
        [|own| &own.reading.regressor[0], |own| own.reading.y_and_epsilon().0];
    [x, y].map(|of| Column::Fractions(rows.iter().map(|own| of(own).clone()).collect()))
}

/// All readings of all parts, on one grid if there is one.
fn united(parts: Vec<Rows>) -> Rows {
    if let Some(Rows::Grid { units, .. }) = parts.first()
        && parts.iter().all(|part| matches!(part, Rows::Grid { units: own, .. } if own == units))
    {
        let units = *units;
        let mut lists = parts.into_iter().filter_map(|part| match part {
            Rows::Grid { points, .. } => Some(points),
            Rows::General(_) | Rows::Places(_) => None,
        });
        let mut points = lists.next().unwrap_or_default();
        lists.for_each(|list| points.extend(list));
        return Rows::Grid { units, points };
    }
    let on_grid = || {
        let finest = parts.iter().try_fold([Unit::Any; 2], |[x, y], part| match part {
            Rows::Grid { units: [own_x, own_y], .. } => Some([x.common(*own_x)?, y.common(*own_y)?]),
            Rows::General(_) | Rows::Places(_) => None,
        })?;
        let points = parts.iter().map(|part| part.on_grid(finest)).collect::<Option<Vec<_>>>()?;
        Some(Rows::Grid { units: finest, points: points.concat() })
    };
    on_grid().unwrap_or_else(|| {
        let of_places = parts.iter().any(|part| matches!(part, Rows::Places(_)));
        let rows = parts.into_iter().flat_map(Rows::into_rows).collect();
        if of_places { Rows::Places(rows) } else { Rows::General(rows) }
    })
}

impl Rows {
    /// Returns how many readings and numbers of rows there are.
    fn size(&self) -> usize {
        match self {
            Rows::Grid { points, .. } => points.iter().map(|point| point.rows.listed()).sum(),
            Rows::General(rows) | Rows::Places(rows) => rows.iter().map(|own| own.rows.listed()).sum(),
        }
    }

    /// The numbers of all.
    fn columns(&self) -> [Column; 2] {
        match self {
            Rows::Grid { units: [x, y], points } => [
                Column::of_counts(points.iter().map(|point| point.x.into()), *x),
                Column::of_counts(points.iter().map(|point| point.y.into()), *y),
            ],
            Rows::General(rows) | Rows::Places(rows) => columns_of(rows),
        }
    }

    #[cfg(feature = "files")]
    fn row_numbers(&self) -> Vec<usize> {
        match self {
            Rows::Grid { points, .. } => points.iter().map(|point| point.rows.first() as usize).collect(),
            Rows::General(rows) | Rows::Places(rows) => rows.iter().map(|own| own.reading.row).collect(),
        }
    }

    /// Removes most of the readings strictly between the hulls, as leading digits tell. The hulls of few readings are found sooner.
    fn near_a_hull(rows: Vec<TiedReading>) -> Vec<TiedReading> {
        const FEW: usize = 100;
        if rows.len() <= FEW {
            return rows;
        }
        let [x, y] = columns_of(&rows);
        let (Some(x), Some(y)) = (x.rounded(), y.rounded()) else { return rows };
        let mut near = candidates_of_rounded(&x, &y).into_iter().peekable();
        let is_near = |(position, own)| near.next_if_eq(&position).is_some().then_some(own);
        rows.into_iter().enumerate().filter_map(is_near).collect()
    }

    /// Removes the readings strictly between the hulls, and the readings that others represent.
    fn reduced(self, most: usize) -> Self {
        match self {
            Rows::Grid { units, points } => Rows::Grid { units, points: touching(points, most) },
            Rows::General(rows) => Rows::General(touching_a_hull(Rows::near_a_hull(rows), most, true)),
            Rows::Places(rows) => Rows::Places(touching_a_hull(Rows::near_a_hull(rows), most, false)),
        }
    }

    /// The points on a grid that is not coarser; `None` where machine integers do not reach.
    fn on_grid(&self, finest: [Unit; 2]) -> Option<Vec<GridPoint>> {
        let Rows::Grid { units, points } = self else { return None };
        let factor = |axis: usize| i64::try_from(units[axis].counted_in(finest[axis])?).ok();
        let (x_factor, y_factor) = (factor(0)?, factor(1)?);
        let moved = |point: &GridPoint| {
            let (x, y) = (point.x.checked_mul(x_factor)?, point.y.checked_mul(y_factor)?);
            Some(GridPoint { x, y, rows: point.rows.clone() })
        };
        points.iter().map(moved).collect()
    }

    fn into_rows(self) -> Vec<TiedReading> {
        match self {
            Rows::Grid { units: [x_unit, y_unit], points } => {
                let row = |GridPoint { x, y, rows }: GridPoint| {
                    TiedReading::of_line(rows, x_unit.times(x.into()), y_unit.times(y.into()))
                };
                points.into_iter().map(row).collect()
            }
            Rows::General(rows) | Rows::Places(rows) => rows,
        }
    }
}
