//! The readings that may touch an envelope at some scale of a stretch, so that one look serves all scales of it.

use std::sync::atomic::{AtomicUsize, Ordering};

use boundfit_exact::{Column, Rational};
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
    pub(super) least: Scale,
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
        number: &dyn Fn(usize) -> usize,
    ) -> Vec<Measurement> {
        if self.is_crowded() {
            return Vec::new();
        }
        let reading = |row: usize| meaning.of_columns(columns, row, number(row));
        let strips = rounded_strips(meaning, &self.least, columns, reading);
        let left = self.sieve.survivors(&strips, |row| reading(row).regressor);
        self.found.fetch_add(left.len(), Ordering::Relaxed);
        if self.is_crowded() { Vec::new() } else { left.into_iter().map(reading).collect() }
    }

    /// Keeps the readings that were found.
    pub(super) fn set(&mut self, readings: Vec<Measurement>) {
        self.readings = readings;
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use boundfit_exact::Unit;

    use super::*;
    use crate::files::fixed::FixedBounds;
    use crate::meaning::{ErrorBound, Model};

    /// Checks that every reading that touches at a scale of a stretch is found; returns how many readings were left out.
    fn check(meaning: &Meaning, columns: &[Column], some: usize) -> usize {
        let count = columns[0].len();
        let all: Vec<Measurement> = (0..count).map(|row| meaning.of_columns(columns, row, row + 1)).collect();
        let known: Vec<Measurement> = all.iter().step_by(some).cloned().collect();
        let Some(least) = Scale::least(known.iter(), meaning.error_bound.is_uniform(), &[]) else { return 0 };
        let nearby = Nearby::new(least, &known, count);
        let found = nearby.of_columns(meaning, columns, &|row| row + 1);
        let found: BTreeSet<usize> = found.iter().map(|reading| reading.row).collect();
        for part in 0..=4 {
            let share = Rational::ratio(part, 4) * Rational::ratio(1, 32);
            let scale = nearby.least.times(&(Rational::one() + share));
            assert!(scale <= nearby.most && !nearby.ends_before(&scale));
            for reading in FixedBounds::new(meaning, &scale, 1).of_readings(&all) {
                assert!(found.contains(&reading.row), "{scale:?}: {reading:?} of {all:?}");
            }
        }
        count - found.len()
    }

    #[test]
    fn the_readings_of_a_stretch_are_all_that_touch_at_one_of_its_scales() {
        let mut seed = 8_u64;
        let mut below = |size: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as i64 % size
        };
        let mut left_out = 0;
        for round in 0..400 {
            let (size, noise) = ([2, 30, 400][round % 3], [1, 3, 900][round / 3 % 3]);
            let rows: Vec<[i64; 4]> = (0..60)
                .map(|_| {
                    let [u, v] = [0; 2].map(|_| below(2 * size) - size);
                    [u, v, 3 * u - v + below(2 * noise) - noise, below(noise)]
                })
                .collect();
            let column = |place: usize| {
                Column::of_counts(rows.iter().map(|row| i128::from(row[place])), Unit::TenTo(-2))
            };
            let bound = match round % 2 {
                0 => ErrorBound::Uniform(Rational::ratio(noise, 100)),
                _ => ErrorBound::Column("e".into()),
            };
            let meaning = Meaning::new(
                Model::TwoRegressors { regressors: ["u".into(), "v".into()] },
                "y".into(),
                bound,
            );
            let columns: Vec<Column> = (0..4 - usize::from(round % 2 == 0)).map(column).collect();
            left_out += check(&meaning, &columns, 1 + round % 5);
        }
        assert!(left_out > 8_000, "{left_out}");
    }
}
