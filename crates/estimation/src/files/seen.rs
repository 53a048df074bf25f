//! Readings that are shown as their table is read.

use boundfit_formats::Batch;
use boundfit_geometry::grid::RoundedStrips;

use super::rounded::rounded_strips;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::scale::Scale;

/// The readings of one part of a table, in its order.
#[derive(Debug, Clone, Copy)]
pub struct Seen<'a> {
    pub(super) meaning: &'a Meaning,
    pub(super) batch: &'a Batch,
}

impl Seen<'_> {
    /// Returns the number of readings.
    pub fn count(&self) -> usize {
        self.batch.rows.len()
    }

    /// The reading in this place, counted from 0. Exact.
    ///
    /// # Panics
    /// When there are not that many.
    pub fn reading(&self, place: usize) -> Measurement {
        self.meaning.of_columns(&self.batch.columns, place, self.batch.rows.get(place))
    }

    /// All readings. Exact.
    pub fn readings(&self) -> impl Iterator<Item = Measurement> {
        (0..self.count()).map(|place| self.reading(place))
    }

    /// All readings on floats that lie within the bounds, for a filter that bears their roundings. Cost: some
    /// nanoseconds each; that of [`Seen::reading`] where a law states the bounds.
    pub fn strips(&self) -> RoundedStrips {
        rounded_strips(self.meaning, &Scale::AsStated, &self.batch.columns, |place| self.reading(place))
    }
}
