//! The readings among which outliers are looked for, and which of them matter.

use std::borrow::Cow;

use boundfit_estimation::{BoundName, Condition, Measurement, Ties, conditions_by_name, half_planes};
use boundfit_geometry::{Constraint, HalfPlane, Inequality, LayerOf, Layers};

use super::near::Near;

/// The readings that can be met or missed, and the conditions.
pub(super) struct Kept<'a> {
    /// Readings that some θ meet and some miss.
    pub(super) rows: Vec<KeptRow<'a>>,
    /// The readings that the rows stand for.
    pub(super) ties: Cow<'a, Ties>,
    /// Rows that no θ meets: a lower bound above the upper one, or no regressor and bounds without 0.
    pub(super) never: Vec<usize>,
    /// The half-planes of the conditions, and of walls within which everything lies that is looked for.
    pub(super) conditions: Vec<Inequality>,
    /// A number of these rows that is enough to leave out, if known. All rows decide then.
    pub(super) enough: Option<usize>,
}

/// A reading that some θ meet and some miss.
pub(super) struct KeptRow<'a> {
    pub(super) measurement: &'a Measurement,
    /// The number of readings that the row stands for.
    pub(super) weight: u64,
    /// The bounds of the row as they were given, one or both.
    pub(super) inequalities: Vec<Inequality>,
    /// The half-planes that they stand for.
    pub(super) half_planes: Vec<HalfPlane>,
}

impl<'a> Kept<'a> {
    /// Collects readings and conditions.
    pub(super) fn new(
        measurements: &'a [Measurement],
        ties: Cow<'a, Ties>,
        conditions: &[Condition],
    ) -> Self {
        let all = measurements.iter().map(|own| (own, [true; 2]));
        Kept::of_bounds(all, ties, conditions)
    }

    /// Collects the readings and bounds that decide about the fewest to leave out, and conditions.
    pub(super) fn near_the_fewest(
        measurements: &'a [Measurement],
        ties: Cow<'a, Ties>,
        conditions: &[Condition],
    ) -> Self {
        let Some(near) = Near::new(measurements, &ties, conditions) else {
            return Kept::new(measurements, ties, conditions);
        };
        let rows = near.rows.iter().filter_map(|&(own, decides)| Some((measurements.get(own)?, decides)));
        let mut kept = Kept::of_bounds(rows, ties, conditions);
        kept.conditions.extend(near.walls);
        kept.enough = Some(near.enough as usize);
        kept
    }

    /// Collects readings with their upper and lower bounds, as far as these decide, and conditions.
    fn of_bounds(
        measurements: impl Iterator<Item = (&'a Measurement, [bool; 2])>,
        ties: Cow<'a, Ties>,
        conditions: &[Condition],
    ) -> Self {
        let (mut rows, mut never) = (Vec::new(), Vec::new());
        for (measurement, [upper, lower]) in measurements {
            let decides = |name: BoundName| if matches!(name, BoundName::Upper(_)) { upper } else { lower };
            let own = half_planes(measurement).filter(|(name, _)| decides(*name));
            let inequalities: Vec<Inequality> = own.map(|(_, own)| own).collect();
            let constraints: Vec<Constraint> = inequalities.iter().map(Inequality::constraint).collect();
            let crosses = measurement.half_width().is_some_and(|half_width| half_width.is_negative());
            if crosses || constraints.contains(&Constraint::Never) {
                never.extend(ties.rows(measurement.row));
                continue;
            }
            let boundary = |constraint: Constraint| match constraint {
                Constraint::HalfPlane(half_plane) => Some(half_plane),
                Constraint::Always | Constraint::Never => None,
            };
            let half_planes: Vec<HalfPlane> = constraints.into_iter().filter_map(boundary).collect();
            if !half_planes.is_empty() {
                let weight = ties.count(measurement.row) as u64;
                rows.push(KeptRow { measurement, weight, inequalities, half_planes });
            }
        }
        let conditions = conditions_by_name(conditions).map(|(_, inequality)| inequality).collect();
        Kept { rows, ties, never, conditions, enough: None }
    }

    /// The layers of the rows.
    pub(super) fn layers(&self, of: LayerOf) -> RowLayers {
        let half_planes =
            self.rows.iter().flat_map(|row| &row.half_planes).map(|own| Constraint::HalfPlane(own.clone()));
        let constraints: Vec<Constraint> = half_planes.collect();
        let owners = (0..).zip(&self.rows).flat_map(|(own, row)| row.half_planes.iter().map(move |_| own));
        RowLayers {
            layers: Layers::new(of, &constraints),
            owners: owners.collect(),
            is_taken: vec![false; self.rows.len()],
            rows: Vec::new(),
        }
    }

    /// Returns the number of readings that some rows stand for.
    pub(super) fn weight(&self, rows: &[u32]) -> u64 {
        rows.iter().map(|&row| self.rows[row as usize].weight).sum()
    }

    /// The data rows that some rows stand for, with those that no θ meets; ascending.
    pub(super) fn data_rows(&self, rows: &[u32]) -> Vec<usize> {
        let own = rows.iter().flat_map(|&row| self.ties.rows(self.rows[row as usize].measurement.row));
        let mut all: Vec<usize> = own.chain(self.never.iter().copied()).collect();
        all.sort_unstable();
        all
    }

    /// The rows with a bound in the first `most + 1` layers: they decide where at most so many are missed. Ascending.
    pub(super) fn in_layers(&self, of: LayerOf, most: usize) -> Vec<u32> {
        let mut layers = self.layers(of);
        for _ in 0..=most {
            if !layers.take_next() {
                break;
            }
        }
        layers.rows.sort_unstable();
        layers.rows
    }
}

/// Layers of rows, taken one after the other.
pub(super) struct RowLayers {
    layers: Layers,
    /// The row of each half-plane.
    owners: Vec<u32>,
    is_taken: Vec<bool>,
    /// The rows with a bound in the layers that are taken.
    pub(super) rows: Vec<u32>,
}

impl RowLayers {
    /// Takes the next layer, and tells whether there was one.
    pub(super) fn take_next(&mut self) -> bool {
        let taken = self.layers.take_next();
        for position in &taken {
            let own = self.owners[*position];
            if !std::mem::replace(&mut self.is_taken[own as usize], true) {
                self.rows.push(own);
            }
        }
        !taken.is_empty()
    }
}
