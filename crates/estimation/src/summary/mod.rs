//! Readings of any number in memory that does not grow with them.
//!
//! Under a uniform error bound a line is decided by the readings that support a hull, least squares by five sums, and
//! both of a whole are found from those of its parts. Only the EUI needs a second look at x, when the sums are known.

mod in_memory;
mod sieve;
mod spread;
mod sums;
mod support;

use std::collections::BTreeMap;

use boundfit_exact::{Column, Rational};
use thiserror::Error;

pub use in_memory::ColumnsError;
pub(crate) use sieve::SharedSieve;
pub use spread::Spread;
pub(crate) use spread::Thresholds;
pub use sums::LineSums;

use crate::measurements::Measurement;
use support::SupportRows;

/// How many readings are kept in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Keep {
    /// Up to this many readings all of them; of more readings of a line under a uniform error bound only those that
    /// touch a hull. Of other models and error bounds all are always kept.
    pub most_rows: usize,
    /// Whether the EUI is wanted of more readings than that.
    pub eui: bool,
    /// How many bytes of x are kept for it. When left out: 48 MiB of a file, which is read a second time when it has
    /// more; 512 MiB of standard input, which cannot be.
    pub most_bytes: Option<usize>,
}

impl Keep {
    /// Above this many readings the LP solvers and binary64 least squares, which need all of them, are left out of
    /// reports. Measured: at this size microlp takes half a second, at ten times as many readings five seconds and
    /// 400 MB.
    pub const MOST_ROWS: usize = 10_000;
}

impl Default for Keep {
    /// All of 10,000 readings, with EUI.
    fn default() -> Self {
        Keep { most_rows: Keep::MOST_ROWS, eui: true, most_bytes: None }
    }
}

/// What is known about the readings of a line of which only those that touch a hull are kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reduction {
    /// The sums over all readings.
    pub sums: LineSums,
    /// Where all x lie.
    pub spread: Result<Spread, NoEui>,
}

/// Why there is no EUI although there is a least-squares estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoEui {
    /// It was not asked for.
    #[error("not asked for")]
    NotAsked,
    /// Readings that cannot be read twice, and more than are kept.
    #[error(
        "standard input has more readings than are kept for a second look at their x; a file can be read twice"
    )]
    TooManyOnce,
    /// A reading has one bound only.
    #[error("a reading has one bound only, so that nothing limits its error on the other side")]
    OneSided,
    /// The bounds of a reading cross.
    #[error("the bounds of a reading cross, so that it has no error that they allow")]
    Crossing,
    /// The data are the result of a reduction.
    #[error("the data are a reduction, which does not have the x of every reading")]
    Reduced,
}

/// What is kept of readings of a line, however many they are.
#[derive(Debug, Default)]
pub(crate) struct LineSummary {
    pub(crate) sums: LineSums,
    /// The readings that support a hull of those with the same error bound; under a uniform one, whatever it is, `None`
    /// stands for it.
    support: BTreeMap<Option<Rational>, SupportRows>,
}

impl LineSummary {
    /// What is kept of columns of equal length, as far as the readings before leave it open; `row` tells the number of the
    /// row at a position, and ascends. Exact.
    pub(crate) fn of_columns(
        [x, y]: [&Column; 2],
        epsilon: Option<&Column>,
        row: &dyn Fn(usize) -> usize,
        sieve: &SharedSieve,
    ) -> Self {
        let support = match epsilon {
            None => BTreeMap::from([(None, sieve.support(x, y, row))]),
            Some(epsilon) => {
                let mut rows: BTreeMap<Rational, Vec<usize>> = BTreeMap::new();
                for k in 0..epsilon.len() {
                    rows.entry(epsilon.get(k)).or_default().push(k);
                }
                let support = |rows: Vec<usize>| {
                    SupportRows::of_readings(rows.into_iter().map(|k| (row(k), x.get(k), y.get(k))))
                };
                rows.into_iter().map(|(bound, rows)| (Some(bound), support(rows))).collect()
            }
        };
        LineSummary { sums: LineSums::of_columns(x, y), support }
    }

    /// Adds what is kept of other readings, and lets the sieve learn from it. Exact.
    pub(crate) fn merge(&mut self, other: LineSummary, sieve: &SharedSieve) {
        self.sums = self.sums.merged(&other.sums);
        for (bound, support) in other.support {
            self.support.entry(bound).or_default().merge(support);
        }
        if let Some(support) = self.support.get(&None) {
            sieve.learn(support, self.sums.count);
        }
    }

    /// The rows of all readings that may turn out to be kept, in no order.
    #[cfg(feature = "files")]
    pub(crate) fn row_numbers(&self) -> impl Iterator<Item = usize> + '_ {
        self.support.values().flat_map(SupportRows::row_numbers)
    }

    /// The sums, and the readings that support a hull, by row, with this error bound.
    pub(crate) fn into_parts(self, epsilon: &Rational) -> (LineSums, Vec<Measurement>) {
        let mut rows: Vec<Measurement> =
            self.support.into_values().flat_map(SupportRows::into_rows).collect();
        rows.sort_by_key(|reading| reading.row);
        (self.sums, rows.into_iter().map(|reading| reading.within(epsilon.clone())).collect())
    }
}
