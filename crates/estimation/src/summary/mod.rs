//! Readings of any number in memory that does not grow with them.
//!
//! Under a uniform error bound, whatever it is, the readings that support a hull decide a line. Under fixed bounds
//! the readings that touch an envelope decide any model. Least squares needs six sums. All of these follow from those
//! of parts. The EUI needs a second look, when the sums are known, and so does the least factor on bounds that are
//! fixed.

mod in_memory;
mod sieve;
mod spread;
mod support;

use std::collections::BTreeMap;

use boundfit_exact::{Column, Rational, Sum};

pub use in_memory::ColumnsError;
pub(crate) use sieve::SharedSieve;
#[cfg(feature = "files")]
pub(crate) use spread::Spread;
pub(crate) use spread::Thresholds;

use crate::deciding::DecidingRows;
use crate::moments::Sums;
use crate::ties::{TiedReading, Ties};
use support::SupportRows;

/// The number of readings that are kept in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Keep {
    /// The largest number of readings of which all are kept; beyond it only the readings that decide the feasible set
    /// are kept.
    pub most_rows: usize,
    /// The largest number of readings of which all are kept as numbers. More, up to `most_rows`, stay in their columns, for what is
    /// asked of them once, if they are of a line under a uniform error bound. Readings of other models do so if `eui` is true,
    /// bounds are known row by row, and each number has at most 62 bits on its column's unit.
    pub most_plain: usize,
    /// True if what takes a second look is wanted of more readings than that: the EUI and, unless the model is a line under
    /// a uniform error bound, ε_min.
    pub eui: bool,
    /// The most bytes of numbers that are kept for that. Default: 192 MiB of a file, 512 MiB of standard input. A file with more
    /// is read again. Standard input with more cannot be read again: the results are unknown.
    pub most_bytes: Option<usize>,
}

impl Keep {
    /// The number of readings above which reports omit the LP solvers and binary64 least squares, which need all
    /// readings. Measured: at this size microlp takes half a second, at ten times as many readings five seconds and
    /// 400 MB.
    pub const MOST_ROWS: usize = 10_000;
    /// All readings.
    pub const EVERY: Keep =
        Keep { most_rows: usize::MAX, most_plain: usize::MAX, eui: true, most_bytes: None };
    /// The default for reports that list no reading but those that decide: only some dozen readings are numbers.
    pub const DECIDING: Keep =
        Keep { most_rows: Keep::MOST_ROWS, most_plain: 64, eui: true, most_bytes: None };
}

impl Default for Keep {
    /// All of 10,000 readings, with EUI.
    fn default() -> Self {
        Keep { most_plain: usize::MAX, ..Keep::DECIDING }
    }
}

/// The summary that is kept of readings of a line, however many there are.
#[derive(Debug, Clone, Default)]
pub(crate) struct LineSummary {
    pub(crate) sums: Sums<Sum>,
    /// The readings that support a hull of those with the same error bound; under a uniform one, whatever it is, `None`
    /// stands for it.
    support: BTreeMap<Option<Rational>, SupportRows>,
}

impl LineSummary {
    /// Summarises columns of equal length, as far as earlier readings leave it open; `row` returns the number of the
    /// row at a position, and ascends. Exact.
    pub(crate) fn of_columns(
        [x, y]: [&Column; 2],
        epsilon: Option<&Column>,
        row: &dyn Fn(usize) -> usize,
        sieve: &SharedSieve,
    ) -> Self {
        // Ties of integers are found in less time than those of doubles.
        let integers = y.integers().and_then(|y| Some((x.integers()?, y)));
        let [x, y] = integers.as_ref().map_or([x, y], |(x, y)| [x, y]);
        let support = match epsilon {
            None => BTreeMap::from([(None, sieve.support(x, y, row))]),
            Some(epsilon) => {
                let mut rows: BTreeMap<Rational, Vec<usize>> = BTreeMap::new();
                for k in 0..epsilon.len() {
                    rows.entry(epsilon.get(k)).or_default().push(k);
                }
                let support = |rows: Vec<usize>| {
                    let readings = rows.into_iter().map(|k| (row(k), x.get(k), y.get(k)));
                    SupportRows::of_readings(readings, sieve.most_listed)
                };
                rows.into_iter().map(|(bound, rows)| (Some(bound), support(rows))).collect()
            }
        };
        LineSummary { sums: Sums::of_line(x, y), support }
    }

    /// Adds what is kept of other readings, and lets the sieve learn from it. Exact.
    pub(crate) fn merge(&mut self, other: LineSummary, sieve: &SharedSieve) {
        /// The number of readings at once below which no sieve is made, since most likely no more readings come.
        const FEW: usize = 1000;
        let is_all = self.sums.count == 0 && other.sums.count < FEW;
        self.sums = std::mem::take(&mut self.sums).and(other.sums);
        for (bound, support) in other.support {
            self.support.entry(bound).or_default().merge(support, sieve.most_listed);
        }
        if !is_all && let Some(support) = self.support.get(&None) {
            sieve.learn(support, self.sums.count);
        }
    }

    /// The rows of all readings that may turn out to be kept, in no order.
    #[cfg(feature = "files")]
    pub(crate) fn row_numbers(&self) -> impl Iterator<Item = usize> + '_ {
        self.support.values().flat_map(SupportRows::row_numbers)
    }

    /// The sums, and the readings that support a hull, by row, with this error bound and what they stand for.
    pub(crate) fn into_parts(self, epsilon: &Rational, sieve: &SharedSieve) -> (Sums, DecidingRows, Ties) {
        let mut support: Vec<SupportRows> = self.support.into_values().collect();
        if let [alone] = support.as_mut_slice()
            && let Some((rows, ties)) = alone.take_grid(epsilon, sieve.most_listed)
        {
            return (self.sums.total(), rows, ties);
        }
        let mut support = support.into_iter().map(|own| own.into_rows(sieve.most_listed));
        let mut readings = support.next().unwrap_or_default();
        readings.extend(support.flatten());
        let (rows, ties) = TiedReading::by_row(readings);
        let rows = Vec::from_iter(rows.into_iter().map(|reading| reading.within(epsilon.clone())));
        (self.sums.total(), rows.into(), ties)
    }
}
