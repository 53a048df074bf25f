//! The readings that may touch an envelope at some scale of a stretch, so that one look serves all scales of it.

use std::sync::atomic::{AtomicUsize, Ordering};

use boundfit_exact::{Column, Rational};
use boundfit_formats::RowNumbers;
use boundfit_geometry::grid::EnvelopeSieve;

use super::rounded::rounded_strips;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::scale::Scale;

/// The number of readings that a stretch is meant to hold where readings are spread evenly.
const MEANT: usize = 1 << 11;
/// More readings than these are not kept.
const MOST: usize = 1 << 13;
/// More known readings would take longer to look at than they are worth.
const MOST_KNOWN: usize = 1 << 10;

/// Scales from one to a somewhat larger one.
///
/// Bounds only grow with the scale. A bound that holds strictly at the least scale wherever known bounds hold at the
/// largest one is therefore strictly redundant at every scale between.
pub(super) struct Nearby {
    least: Scale,
    most: Scale,
    /// The known bounds at the largest scale.
    sieve: EnvelopeSieve,
    /// The number of readings found so far, by all threads.
    found: AtomicUsize,
    /// The readings that may touch an envelope, unless there are too many.
    readings: Vec<Measurement>,
}

impl Nearby {
    /// Prepares a look at so many readings, of which some are known.
    pub(super) fn new(least: Scale, known: &[Measurement], count: usize) -> Self {
        let share = Rational::from(MEANT).checked_div(&count.max(32 * MEANT).into()).unwrap_or_default();
        let most = least.times(&(Rational::one() + share));
        let distance = known.len().div_ceil(MOST_KNOWN).max(1);
        let sieve = most.sieve(known.iter().step_by(distance));
        Nearby { least, most, sieve, found: AtomicUsize::new(0), readings: Vec::new() }
    }

    /// Returns the readings in columns that may touch an envelope, or none once there are too many.
    pub(super) fn of_columns(
        &self,
        meaning: &Meaning,
        columns: &[Column],
        rows: &RowNumbers,
    ) -> Vec<Measurement> {
        if self.is_crowded() {
            return Vec::new();
        }
        let reading = |row: usize| meaning.of_columns(columns, row, rows.get(row));
        let strips = rounded_strips(meaning, &self.least, columns, reading);
        let left = self.sieve.survivors(&strips, |row| reading(row).regressor);
        self.found.fetch_add(left.len(), Ordering::Relaxed);
        if self.is_crowded() { Vec::new() } else { left.into_iter().map(reading).collect() }
    }

    /// Keeps the readings that were found.
    pub(super) fn with(self, readings: Vec<Measurement>) -> Self {
        Nearby { readings, ..self }
    }

    /// Returns whether this says nothing about a scale, but another stretch would.
    pub(super) fn ends_before(&self, scale: &Scale) -> bool {
        !self.is_crowded() && self.most < *scale
    }

    /// The readings that may touch an envelope at a scale that is not beyond this stretch; `None` if there were too many.
    pub(super) fn readings(&self) -> Option<&[Measurement]> {
        (!self.is_crowded()).then_some(&self.readings)
    }

    fn is_crowded(&self) -> bool {
        self.found.load(Ordering::Relaxed) > MOST
    }
}
