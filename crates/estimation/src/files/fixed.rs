//! The readings that decide a fit under bounds that are fixed, found part by part.

use std::collections::{BTreeMap, BTreeSet};
use std::hash::BuildHasher;
use std::sync::{Arc, RwLock};

use boundfit_exact::{Column, Rational};
use boundfit_geometry::grid::{EnvelopeSieve, RoundedStrip, RoundedStrips};
use boundfit_geometry::{Inequality, Tally, Touch, touches_of_envelopes};
use hashbrown::{DefaultHashBuilder, HashTable};

use super::rounded::rounded_strips;
use super::vertices::{AtVertices, Vertex, counts_at, told_at_vertices, with_others};
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::moments::Sums;
use crate::reduction::NoLeastSquares;
use crate::scale::Scale;
use crate::ties::{TiedReading, Ties};

/// Merging waits for at least this many new rows, so that small parts do not each pay for the whole.
const LEAST_TO_MERGE: usize = 1024;
/// The number of readings that no sieve discarded from which on a new sieve is made.
const LEAST_TO_SIEVE: usize = 128;

/// Returns the readings with a bound that touches an envelope, by row. They decide the feasible set, whatever other
/// readings and conditions there are. Readings that say the same are represented by the first. They depend on the
/// readings alone, not on how these are split. At most so many numbers are listed of those that say the same. Exact.
/// Cost: O(n log n).
fn touching(readings: Vec<TiedReading>, scale: &Scale, most: usize, keep: &AtVertices) -> Vec<TiedReading> {
    let readings = told_once(readings, most);
    let (of, constraints) = scale.constraints(readings.iter().map(|own| &own.reading));
    let touches = touches_of_envelopes(&constraints).into_iter();
    let mut touches: Vec<(usize, Touch)> = touches.map(|touch| (of[touch.position], touch)).collect();
    if *scale != Scale::AsStated {
        // Without regressors a reading asks for a factor all the same.
        let is_tight = |own: Inequality| own.b.is_zero() && own.a.iter().all(Rational::is_zero);
        let without = readings.iter().enumerate().filter(|(_, own)| is_without_regressors(&own.reading));
        let tight = without.filter(|(_, own)| scale.half_planes(&own.reading).any(is_tight));
        touches.extend(tight.map(|(own, _)| (own, Touch { position: 0, vertex: None })));
    }
    told_at_vertices(readings, &touches, keep, most)
}

fn is_without_regressors(reading: &Measurement) -> bool {
    reading.regressor.iter().all(Rational::is_zero)
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
            Some(_) if is_without_regressors(&reading) => {}
            Some(first) => others.entry(first).or_default().push(rows),
            None => {
                of.insert_unique(own, once.len(), |&place| hash(&once[place].reading));
                once.push(TiedReading { reading, rows });
            }
        }
    }
    with_others(&mut once, others, most);
    once
}

/// The facts about all readings so far.
struct Known {
    sieve: EnvelopeSieve,
    /// The vertices at which one reading may stand for the readings to come.
    vertices: Vec<Vertex>,
}

/// The facts about all readings so far, for the readings to come; all threads use it.
#[derive(Default)]
pub(crate) struct SharedEnvelopeSieve(RwLock<Option<(Arc<Known>, usize)>>);

impl SharedEnvelopeSieve {
    fn get(&self) -> Option<Arc<Known>> {
        self.0.read().ok()?.as_ref().map(|(sieve, _)| Arc::clone(sieve))
    }
}

/// The choice of the readings that are kept.
pub(crate) struct FixedBounds<'a> {
    pub(crate) meaning: &'a Meaning,
    pub(crate) scale: &'a Scale,
    pub(crate) sieve: SharedEnvelopeSieve,
    /// The largest number of rows that are listed for readings that say the same.
    most_listed: usize,
    /// The choice of readings that are kept at one vertex.
    at_vertices: AtVertices,
}

impl<'a> FixedBounds<'a> {
    pub(crate) fn new(meaning: &'a Meaning, scale: &'a Scale, most_listed: usize) -> Self {
        let at_vertices = AtVertices::Each;
        FixedBounds { meaning, scale, sieve: SharedEnvelopeSieve::default(), most_listed, at_vertices }
    }

    /// Lets one reading under a uniform bound stand for all readings through the same vertex of an envelope. The set,
    /// whatever the conditions, is the same; of a set that is a point or empty the proof may take readings that are
    /// not kept.
    pub(crate) fn telling_vertices_as_one(self) -> Self {
        let at_vertices = match self.scale {
            Scale::AsStated => AtVertices::First,
            Scale::Within(_) | Scale::Times(_) => AtVertices::Extreme,
        };
        if self.meaning.error_bound.is_uniform() { self.keeping(at_vertices) } else { self }
    }

    /// Keeping these of the readings that go through one vertex.
    pub(crate) fn keeping(self, at_vertices: AtVertices) -> Self {
        FixedBounds { at_vertices, ..self }
    }

    /// These bounds with other readings kept of those that go through one vertex; `None` where each is kept.
    pub(crate) fn again(&self, at_vertices: AtVertices) -> Option<Self> {
        let again = FixedBounds::new(self.meaning, self.scale, self.most_listed).keeping(at_vertices);
        (self.at_vertices != AtVertices::Each).then_some(again)
    }

    /// Lets the sieve start with what some of the readings say at this scale.
    pub(crate) fn knowing(self, some: &[Measurement]) -> Self {
        /// A count that no part exceeds twofold, since the known facts are better than the facts of a part.
        const MANY: usize = usize::MAX / 2;
        /// More would take longer to look at than they are worth.
        const ENOUGH: usize = 1024;
        let distance = some.len().div_ceil(ENOUGH).max(1);
        let some = some.iter().step_by(distance).cloned().map(TiedReading::alone).collect();
        let known = Arc::new(self.known_by(some));
        FixedBounds { sieve: SharedEnvelopeSieve(RwLock::new(Some((known, MANY)))), ..self }
    }

    /// Returns what is to be kept of readings in columns, as far as the readings before leave it open. Exact.
    pub(crate) fn part(&self, columns: &[Column], number: &dyn Fn(usize) -> usize) -> FixedPart {
        FixedPart {
            touching: self.of_columns(columns, number),
            sums: Sums::of_readings(self.meaning, columns),
            has_widths: self.meaning.have_widths(columns),
        }
    }

    /// The readings in columns that touch an envelope, as far as the readings before leave it open, and perhaps a few others. Exact.
    pub(crate) fn of_columns(&self, columns: &[Column], number: &dyn Fn(usize) -> usize) -> Vec<TiedReading> {
        let count = columns.first().map_or(0, Column::len);
        let reading = |row: usize| self.meaning.of_columns(columns, row, number(row));
        let tied = |row: usize| TiedReading::alone(reading(row));
        let strips = self.strips(columns, number);
        let known = self.sieve.get().filter(|known| !known.sieve.is_beside(&strips));
        let exact = |row: usize| reading(row).regressor;
        let mut through = Vec::new();
        let mut left = match known {
            Some(known) => {
                let mut left = known.sieve.survivors(&strips, exact);
                through.extend(self.through_vertices(&known, columns, &strips, number, &mut left));
                left
            }
            None => (0..count).collect(),
        };
        // Another round has a better sample.
        while left.len() >= LEAST_TO_SIEVE {
            // About the square root of all rows, at equal distances.
            let some = left.iter().step_by(left.len().isqrt()).map(|&row| tied(row)).collect();
            let known = self.known_by(some);
            let mut kept: Vec<usize> = match left.len() == count {
                true => known.sieve.survivors(&strips, exact),
                false => {
                    let passes = |row: &usize| !known.sieve.discards(&strips.strip(*row), || exact(*row));
                    left.iter().copied().filter(passes).collect()
                }
            };
            through.extend(self.through_vertices(&known, columns, &strips, number, &mut kept));
            let is_enough = 2 * kept.len() > left.len();
            left = kept;
            if is_enough {
                break;
            }
        }
        let left: Vec<TiedReading> = left.into_iter().map(tied).chain(through).collect();
        // Few are cheaper to look at together with those of other parts.
        if left.len() < LEAST_TO_SIEVE { left } else { self.touching(left) }
    }

    fn touching(&self, readings: Vec<TiedReading>) -> Vec<TiedReading> {
        touching(readings, self.scale, self.most_listed, &self.at_vertices)
    }

    /// Takes the rows out that go through vertices and touch nothing else: one reading for all of each, and those that must be kept.
    fn through_vertices(
        &self,
        known: &Known,
        columns: &[Column],
        strips: &RoundedStrips,
        number: &dyn Fn(usize) -> usize,
        rows: &mut Vec<usize>,
    ) -> Vec<TiedReading> {
        let epsilon = match self.scale {
            Scale::Within(epsilon) => Some(epsilon),
            Scale::AsStated | Scale::Times(_) => self.meaning.error_bound.uniform(),
        };
        let (Some(epsilon), [Column::Narrow(u), Column::Narrow(v), Column::Narrow(y)]) = (epsilon, columns)
        else {
            return Vec::new();
        };
        let in_units = |vertex: &Vertex| vertex.in_units([u.unit(), v.unit(), y.unit()], epsilon);
        let vertices: Vec<_> = known.vertices.iter().filter_map(in_units).collect();
        if vertices.is_empty() {
            return Vec::new();
        }
        let reading = |row: usize| self.meaning.of_columns(columns, row, number(row));
        let mut told: BTreeMap<[Option<usize>; 2], Vec<usize>> = BTreeMap::new();
        rows.retain(|&row| {
            let mut at = [None; 2];
            for (place, vertex) in vertices.iter().enumerate() {
                if let Some(side) = vertex.side_through(counts_at([u, v, y], row)) {
                    at[side] = Some(place);
                }
            }
            let strip = strips.strip(row);
            let others = match at {
                [None, None] => return true,
                [Some(_), None] => RoundedStrip { upper: f64::INFINITY, ..strip },
                [None, Some(_)] => RoundedStrip { lower: f64::NEG_INFINITY, ..strip },
                [Some(_), Some(_)] => {
                    RoundedStrip { lower: f64::NEG_INFINITY, upper: f64::INFINITY, ..strip }
                }
            };
            let is_told = known.sieve.discards(&others, || reading(row).regressor);
            if is_told {
                told.entry(at).or_default().push(row);
            }
            !is_told
        });
        let mut readings = Vec::new();
        for (at, mut told) in told {
            let sides = [false, true].into_iter().zip(at).filter(|(_, at)| at.is_some());
            let decisive =
                sides.map(|(is_lower, _)| self.at_vertices.decisive_in_units([u, v], &told, is_lower));
            let Some(decisive) = decisive.collect::<Option<Vec<_>>>() else {
                rows.extend(told);
                continue;
            };
            let decisive: BTreeSet<usize> = decisive.into_iter().flatten().collect();
            readings.extend(decisive.iter().map(|&row| TiedReading::alone(reading(row))));
            told.retain(|row| !decisive.contains(row));
            let mut others = told.into_iter();
            if let Some(first) = others.next() {
                let mut first = TiedReading::alone(reading(first));
                others.for_each(|row| first.rows.push(|| number(row) as u64, self.most_listed));
                readings.push(first);
            }
        }
        readings
    }

    /// Readings in columns as the filter sees them.
    pub(crate) fn strips(&self, columns: &[Column], number: &dyn Fn(usize) -> usize) -> RoundedStrips {
        let reading = |row: usize| self.meaning.of_columns(columns, row, number(row));
        rounded_strips(self.meaning, self.scale, columns, reading)
    }

    /// The row of the reading that stands for another one, if one of those that are kept does.
    pub(crate) fn speaker(&self, kept: &[Measurement], other: &Measurement) -> Option<usize> {
        if self.at_vertices == AtVertices::Each {
            return None;
        }
        let all = kept.iter().chain([other]).cloned().map(TiedReading::alone).collect();
        let stands_for = |own: &TiedReading| own.rows.rows().skip(1).any(|row| row == other.row as u64);
        let told = touching(all, self.scale, usize::MAX, &self.at_vertices);
        told.into_iter().find(stands_for).map(|own| own.reading.row)
    }

    /// Returns what some readings say.
    fn known_by(&self, some: Vec<TiedReading>) -> Known {
        self.known_of(&touching(some, self.scale, 1, &AtVertices::Each))
    }

    fn known_of(&self, readings: &[TiedReading]) -> Known {
        let vertices = match self.at_vertices {
            AtVertices::Each => Vec::new(),
            _ => Vertex::busiest(readings, self.scale),
        };
        Known { sieve: self.scale.sieve(readings.iter().map(|own| &own.reading)), vertices }
    }

    /// Learns from all readings so far, whenever these have doubled.
    fn learn(&self, support: &mut FixedSupport) {
        let is_fresh = self.sieve.0.read().is_ok_and(|current| {
            current.as_ref().is_some_and(|(_, learned_from)| support.rows < 2 * learned_from)
        });
        if !is_fresh {
            support.settle(self);
            let known = self.known_of(&support.merged);
            if let Ok(mut current) = self.sieve.0.write() {
                *current = Some((Arc::new(known), support.rows));
            }
        }
    }
}

/// The readings that may be kept of one batch.
pub(crate) struct FixedPart {
    pub(crate) touching: Vec<TiedReading>,
    sums: Result<Sums, NoLeastSquares>,
    has_widths: bool,
}

/// The readings that are kept of all readings so far.
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

    /// The number of readings there are.
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
        self.merged = bounds.touching(all);
    }
}
