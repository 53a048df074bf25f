//! The readings that decide a fit under bounds that are fixed, found part by part.

use std::collections::BTreeMap;
use std::hash::BuildHasher;
use std::sync::{Arc, RwLock};

use boundfit_exact::{Column, Rational};
use boundfit_geometry::grid::{EnvelopeSieve, in_range};
use boundfit_geometry::{Constraint, HalfPlane, Inequality, Tally, touching_an_envelope};
use hashbrown::{DefaultHashBuilder, HashTable};

use super::rounded::{may_be_tightest, rounded_strips};
use super::scale::Scale;
use super::sums::Sums;
use crate::least_squares::NoLeastSquares;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::ties::{TiedReading, Ties};

/// Merging waits for at least this many new rows, so that small parts do not each pay for the whole.
const LEAST_TO_MERGE: usize = 1024;
/// From so many rows on that no sieve has discarded, another one is made from some of these.
const LEAST_TO_SIEVE: usize = 128;

/// Of readings, those with a bound that touches an envelope, by row, and of several that say the same only the first: they decide
/// the feasible set, whatever other readings and conditions there are. They depend on the readings alone, not on how these
/// are split. At most so many numbers are listed of those that say the same. Exact. Cost: O(n log n).
pub(crate) fn touching(readings: Vec<TiedReading>, scale: &Scale, most: usize) -> Vec<TiedReading> {
    let mut readings = told_once(readings, most);
    let (of, constraints) = scale.constraints(readings.iter().map(|own| &own.reading));
    let mut touches = vec![false; readings.len()];
    touching_an_envelope(&constraints).into_iter().for_each(|index| touches[of[index]] = true);
    if *scale != Scale::AsStated {
        // Without regressors a reading asks for a factor all the same.
        let is_tight = |own: Inequality| own.b.is_zero() && own.a.iter().all(Rational::is_zero);
        let without = readings
            .iter()
            .zip(&mut touches)
            .map(|(own, touches)| (&own.reading, touches))
            .filter(|(own, _)| own.regressor.iter().all(Rational::is_zero));
        without.for_each(|(own, touches)| *touches |= scale.half_planes(own).any(is_tight));
    }
    let mut touches = touches.into_iter();
    readings.retain(|_| touches.next().unwrap_or(false));
    readings
}

/// The readings by row, of several that say the same the first with the numbers of all. Exact. Cost: O(n log n).
fn told_once(mut readings: Vec<TiedReading>, most: usize) -> Vec<TiedReading> {
    readings.sort_by_key(|own| own.reading.row);
    let hasher = DefaultHashBuilder::default();
    let hash = |own: &Measurement| hasher.hash_one((&own.regressor, &own.bounds));
    let mut of: HashTable<usize> = HashTable::new();
    let mut others: BTreeMap<usize, Vec<Tally>> = BTreeMap::new();
    let mut once: Vec<TiedReading> = Vec::new();
    for TiedReading { reading, rows } in readings {
        let own = hash(&reading);
        let says_the_same = |&place: &usize| {
            let other = &once[place].reading;
            reading.regressor == other.regressor && reading.bounds == other.bounds
        };
        match of.find(own, says_the_same).copied() {
            // Without regressors none is ever active: of those only the first counts, whatever else was in its part.
            Some(_) if reading.regressor.iter().all(Rational::is_zero) => {}
            Some(first) => others.entry(first).or_default().push(rows),
            None => {
                of.insert_unique(own, once.len(), |&place| hash(&once[place].reading));
                once.push(TiedReading { reading, rows });
            }
        }
    }
    for (position, tallies) in others {
        let all = [once[position].rows.clone()].into_iter().chain(tallies);
        once[position].rows = Tally::merged(all, most);
    }
    once
}

/// What is known of all readings, for those to come; all threads use it.
#[derive(Default)]
pub(crate) struct SharedEnvelopeSieve(RwLock<Option<(Arc<EnvelopeSieve>, usize)>>);

impl SharedEnvelopeSieve {
    fn get(&self) -> Option<Arc<EnvelopeSieve>> {
        self.0.read().ok()?.as_ref().map(|(sieve, _)| Arc::clone(sieve))
    }
}

/// What is to be kept of which readings.
pub(crate) struct FixedBounds<'a> {
    pub(crate) meaning: &'a Meaning,
    pub(crate) scale: &'a Scale,
    pub(crate) sieve: SharedEnvelopeSieve,
    /// How many numbers of rows are listed of readings that say the same.
    most_listed: usize,
}

impl<'a> FixedBounds<'a> {
    pub(crate) fn new(meaning: &'a Meaning, scale: &'a Scale, most_listed: usize) -> Self {
        FixedBounds { meaning, scale, sieve: SharedEnvelopeSieve::default(), most_listed }
    }

    /// Lets the sieve start with what some of the readings say at this scale.
    #[cfg(feature = "files")]
    pub(crate) fn knowing(self, some: &[Measurement]) -> Self {
        /// So many that no part is more than twice as many: what is known is better than what a part says.
        const MANY: usize = usize::MAX / 2;
        /// More would take longer to look at than they are worth.
        const ENOUGH: usize = 1024;
        let distance = some.len().div_ceil(ENOUGH).max(1);
        let some = some.iter().step_by(distance).cloned().map(TiedReading::alone).collect();
        let sieve = Arc::new(self.sieve_of(&touching(some, self.scale, 1)));
        FixedBounds { sieve: SharedEnvelopeSieve(RwLock::new(Some((sieve, MANY)))), ..self }
    }

    /// What is to be kept of readings in columns, as far as the readings before leave it open. Exact.
    pub(crate) fn part(&self, columns: &[Column], number: &dyn Fn(usize) -> usize) -> FixedPart {
        FixedPart {
            touching: self.of_columns(columns, number),
            sums: self.meaning.sums(columns),
            has_widths: self.meaning.have_widths(columns),
        }
    }

    /// The readings in columns that touch an envelope, as far as the readings before leave it open. Exact.
    pub(crate) fn of_columns(&self, columns: &[Column], number: &dyn Fn(usize) -> usize) -> Vec<TiedReading> {
        let count = columns.first().map_or(0, Column::len);
        let reading = |row: usize| self.meaning.of_columns(columns, row, number(row));
        let tied = |row: usize| TiedReading::alone(reading(row));
        let sieve = self.sieve.get();
        if sieve.is_none() && count < LEAST_TO_SIEVE {
            return touching((0..count).map(tied).collect(), self.scale, self.most_listed);
        }
        let strips = rounded_strips(self.meaning, self.scale, columns, reading);
        let exact = |row: usize| reading(row).regressor;
        let mut left = sieve.map_or_else(|| (0..count).collect(), |sieve| sieve.survivors(&strips, exact));
        // Another round has a better sample.
        while left.len() >= LEAST_TO_SIEVE {
            // About the square root of all rows, at equal distances.
            let some = left.iter().step_by(left.len().isqrt()).map(|&row| tied(row)).collect();
            let sieve = self.sieve_of(&touching(some, self.scale, 1));
            let kept: Vec<usize> = match left.len() == count {
                true => sieve.survivors(&strips, exact),
                false => {
                    let passes = |row: &usize| !sieve.discards(&strips.strip(*row), || exact(*row));
                    left.iter().copied().filter(passes).collect()
                }
            };
            let is_enough = 2 * kept.len() > left.len();
            left = kept;
            if is_enough {
                break;
            }
        }
        touching(left.into_iter().map(tied).collect(), self.scale, self.most_listed)
    }

    /// Of the readings in columns the first with the least slack at a point, with that slack. Exact. Cost: linear.
    #[cfg(feature = "files")]
    pub(crate) fn tightest(
        &self,
        columns: &[Column],
        number: &dyn Fn(usize) -> usize,
        theta: &[Rational; 2],
    ) -> Option<(Rational, Measurement)> {
        let reading = |row: usize| self.meaning.of_columns(columns, row, number(row));
        let strips = rounded_strips(self.meaning, self.scale, columns, reading);
        let point = theta.each_ref().map(|number| in_range(number.to_f64()));
        let with_slack = |row: usize| {
            let reading = reading(row);
            let slack = self.scale.half_planes(&reading).map(|own| own.slack(theta)).min()?;
            Some((slack, reading))
        };
        let candidates = may_be_tightest(&strips, point).into_iter().filter_map(with_slack);
        candidates.reduce(|best, next| if next.0 < best.0 { next } else { best })
    }

    fn sieve_of(&self, readings: &[TiedReading]) -> EnvelopeSieve {
        let half_plane = |constraint: Constraint| match constraint {
            Constraint::HalfPlane(half_plane) => Some(half_plane),
            Constraint::Always | Constraint::Never => None,
        };
        let (_, constraints) = self.scale.constraints(readings.iter().map(|own| &own.reading));
        let half_planes: Vec<HalfPlane> = constraints.into_iter().filter_map(half_plane).collect();
        EnvelopeSieve::new(&half_planes)
    }

    /// Learns from all readings so far, whenever these have doubled.
    fn learn(&self, support: &mut FixedSupport) {
        let is_fresh = self.sieve.0.read().is_ok_and(|current| {
            current.as_ref().is_some_and(|(_, learned_from)| support.rows < 2 * learned_from)
        });
        if !is_fresh {
            support.settle(self);
            let sieve = self.sieve_of(&support.merged);
            if let Ok(mut current) = self.sieve.0.write() {
                *current = Some((Arc::new(sieve), support.rows));
            }
        }
    }
}

/// What is kept of the readings of one batch.
pub(crate) struct FixedPart {
    pub(crate) touching: Vec<TiedReading>,
    sums: Result<Sums, NoLeastSquares>,
    has_widths: bool,
}

/// What is kept of all readings so far.
pub(crate) struct FixedSummary {
    pub(crate) support: FixedSupport,
    pub(crate) sums: Result<Sums, NoLeastSquares>,
    pub(crate) has_widths: bool,
}

impl Default for FixedSummary {
    fn default() -> Self {
        FixedSummary { support: FixedSupport::default(), sums: Ok(Sums::default()), has_widths: false }
    }
}

impl FixedSummary {
    /// Adds what was kept of so many other readings. Exact.
    pub(crate) fn merge(&mut self, part: FixedPart, rows: usize, bounds: &FixedBounds) {
        let FixedPart { touching, sums, has_widths } = part;
        self.has_widths |= has_widths;
        self.support.merge(touching, rows, bounds);
        self.sums = self.sums.clone().and_then(|own| Ok(own.merged(&sums?)));
    }
}

/// The readings that touch an envelope of all readings so far.
#[derive(Debug, Default)]
pub(crate) struct FixedSupport {
    merged: Vec<TiedReading>,
    pending: Vec<TiedReading>,
    rows: usize,
}

impl FixedSupport {
    /// Adds what was kept of so many other readings. Exact. Cost: amortised O(log n) per reading that is kept.
    pub(crate) fn merge(&mut self, readings: Vec<TiedReading>, rows: usize, bounds: &FixedBounds) {
        self.rows += rows;
        self.pending.extend(readings);
        let size = |readings: &[TiedReading]| readings.iter().map(|own| own.rows.listed()).sum::<usize>();
        if size(&self.pending) >= size(&self.merged).max(LEAST_TO_MERGE) {
            self.settle(bounds);
        }
        bounds.learn(self);
    }

    /// How many readings there are.
    pub(crate) fn count(&self) -> usize {
        self.rows
    }

    /// The rows of all readings that may turn out to be kept, in no order.
    pub(crate) fn row_numbers(&self) -> impl Iterator<Item = usize> + '_ {
        self.merged.iter().chain(&self.pending).map(|own| own.reading.row)
    }

    /// The readings, by row, and what they stand for.
    pub(crate) fn into_rows(mut self, bounds: &FixedBounds) -> (Vec<Measurement>, Ties) {
        self.settle(bounds);
        TiedReading::by_row(self.merged)
    }

    fn settle(&mut self, bounds: &FixedBounds) {
        let mut all = std::mem::take(&mut self.merged);
        all.append(&mut self.pending);
        self.merged = touching(all, bounds.scale, bounds.most_listed);
    }
}
