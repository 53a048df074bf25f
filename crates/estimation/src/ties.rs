//! Readings that stand for others: those that say the same, or bound the same point of the feasible set and nothing else.

use std::collections::BTreeMap;

use boundfit_exact::Rational;
use boundfit_geometry::Tally;

use crate::bound_name::BoundName;
use crate::measurement::Measurement;

/// The readings in memory that stand for more than themselves, by row.
///
/// The bounds of the readings that one stands for are active exactly where its own are.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Ties(BTreeMap<usize, Tally>);

/// Bounds that are met with equality.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ActiveBounds {
    /// The first of them, sorted.
    pub names: Vec<BoundName>,
    /// The number of active bounds beside these.
    pub more: usize,
}

/// A reading with all that it stands for.
#[derive(Debug, Clone)]
pub(crate) struct TiedReading {
    /// The first of them.
    pub(crate) reading: Measurement,
    pub(crate) rows: Tally,
}

impl Ties {
    /// The number of active readings up to which a report lists them; beyond it, the report counts them. If more
    /// readings are active than memory keeps, this many are known by number.
    pub const MOST_LISTED: usize = 1000;

    /// Adds what the reading of a row stands for.
    pub(crate) fn insert(&mut self, row: usize, rows: Tally) {
        if rows.count() > 1 {
            self.0.insert(row, rows);
        }
    }

    /// Tells a reading apart from the one that stands for it.
    #[cfg(feature = "files")]
    pub(crate) fn set_apart(&mut self, row: usize, speaker: usize) {
        if let Some(rows) = self.0.remove(&speaker) {
            self.insert(speaker, rows.without(row as u64));
        }
    }

    /// Returns, for readings from reductions, all that each stands for, where the number of each row says how many
    /// readings it stands for.
    #[cfg(feature = "files")]
    pub(crate) fn weighted(&self, rows: &[Measurement], counts: &[u64]) -> Self {
        let count = |row: u64| (row as usize).checked_sub(1).and_then(|row| counts.get(row)).copied();
        let mut weighted = Ties::default();
        for reading in rows {
            weighted.insert(reading.row, self.of(reading.row).weighted(|row| count(row).unwrap_or(1)));
        }
        weighted
    }

    /// Returns whether every reading stands for itself alone.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns how many readings that of a row stands for, itself included.
    pub fn count(&self, row: usize) -> usize {
        self.0.get(&row).map_or(1, |rows| rows.count() as usize)
    }

    /// The rows that one stands for, as far as they are listed, ascending; itself is the first.
    pub fn rows(&self, row: usize) -> impl Iterator<Item = usize> + '_ {
        let others = self.0.get(&row).into_iter().flat_map(Tally::rows).map(|row| row as usize);
        [row].into_iter().chain(others.skip(1))
    }

    /// Returns what these rows stand for, alone, with at most so many numbers of each.
    pub(crate) fn among(&self, rows: impl Iterator<Item = usize>, most: usize) -> Self {
        let listed = |tally: &Tally| Tally::merged([tally.clone()].into_iter(), most);
        Ties(rows.filter_map(|row| Some((row, listed(self.0.get(&row)?)))).collect())
    }

    /// The readings that one stands for.
    pub(crate) fn of(&self, row: usize) -> Tally {
        self.0.get(&row).cloned().unwrap_or_else(|| Tally::one(row as u64))
    }

    /// Returns the bounds that are active where these are: at most so many names, sorted, and the number of the
    /// others.
    pub(crate) fn active(&self, names: impl Iterator<Item = BoundName>, most: usize) -> ActiveBounds {
        let (mut all, mut count) = (Vec::new(), 0);
        for name in names {
            match name.row().and_then(|row| self.0.get(&row)) {
                Some(rows) => {
                    count += rows.count() as usize;
                    // Names are sorted by row.
                    all.extend(rows.rows().take(most).map(|row| name.of_row(row as usize)));
                }
                None => {
                    count += 1;
                    all.push(name);
                }
            }
        }
        // The names of each reading are a sorted run, and runs are merged.
        all.sort();
        ActiveBounds { more: count - all.len(), names: all }.at_most(most)
    }
}

impl ActiveBounds {
    /// Keeps at most this many bounds by name.
    pub fn at_most(mut self, most: usize) -> Self {
        self.more += self.names.len().saturating_sub(most);
        self.names.truncate(most);
        self
    }
}

impl TiedReading {
    /// A reading that stands for itself.
    #[cfg(feature = "files")]
    pub(crate) fn alone(reading: Measurement) -> Self {
        TiedReading { rows: Tally::one(reading.row as u64), reading }
    }

    /// A point of a plane of regressors, with a number.
    #[cfg(feature = "files")]
    pub(crate) fn of_normal(number: usize, [u, v]: [Rational; 2]) -> Self {
        TiedReading::of_line(Tally::one(number as u64), u, v)
    }

    /// A reading of a line with an error bound of 0.
    pub(crate) fn of_line(rows: Tally, x: Rational, y: Rational) -> Self {
        let row = rows.first() as usize;
        TiedReading { reading: Measurement::around(row, [x, Rational::one()], y, Rational::zero()), rows }
    }

    /// The readings by row, and what they stand for.
    pub(crate) fn by_row(mut readings: Vec<Self>) -> (Vec<Measurement>, Ties) {
        readings.sort_by_key(|own| own.reading.row);
        let mut ties = Ties::default();
        let apart = |TiedReading { reading, rows }: TiedReading| {
            ties.insert(reading.row, rows);
            reading
        };
        (readings.into_iter().map(apart).collect(), ties)
    }
}
