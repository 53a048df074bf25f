//! Readings in the order in which they matter.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use boundfit_estimation::Measurement;
use boundfit_exact::Rational;

use super::leave_one_out::RowStatus;
use super::standing::{Standing, Status};

/// A reading with its statuses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Judged {
    /// The reading.
    pub reading: Measurement,
    /// The status of the reading.
    pub status: RowStatus,
}

/// Counts of statuses, and the readings that matter most: in memory that does not grow with how many there are.
///
/// Readings are ranked by the gravest status against the set of the others, then by the least clearance, then by row.
/// Rankings of parts merge in any order.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranking {
    most: usize,
    listed: Vec<Judged>,
    /// The last reading that may still be listed: readings after it need not be kept.
    last: Option<Judged>,
    /// A reading of the set that is inner by a larger margin comes after the last.
    beyond: f64,
    counts: BTreeMap<Option<Status>, usize>,
    counts_of_all: BTreeMap<Option<Status>, usize>,
    /// The first rows that are on the boundary of the set of all, ascending.
    boundary: Vec<usize>,
}

impl Ranking {
    /// A ranking that lists at most so many readings.
    pub fn listing(most: usize) -> Self {
        Ranking {
            most,
            listed: Vec::new(),
            last: None,
            beyond: f64::INFINITY,
            counts: BTreeMap::new(),
            counts_of_all: BTreeMap::new(),
            boundary: Vec::new(),
        }
    }

    /// Adds a reading. Cost: that of sorting, over all readings.
    pub fn add(&mut self, reading: Measurement, status: RowStatus) {
        *self.counts.entry(name(status.without.as_ref())).or_default() += 1;
        let all = name(status.all.as_ref());
        *self.counts_of_all.entry(all).or_default() += 1;
        if all == Some(Status::Boundary) {
            self.boundary.push(status.row);
        }
        let judged = Judged { reading, status };
        if self.last.as_ref().is_none_or(|last| key(&judged) < key(last)) {
            self.listed.push(judged);
        }
        self.shorten(2);
    }

    /// Adds a reading that decides nothing, of which is known that its margin exceeds this one, at least 0, unless it
    /// may be listed. Returns whether it did.
    pub fn add_clear(&mut self, margin: f64) -> bool {
        // Comparisons with what is not a number are false.
        let is_added = margin >= 0.0 && margin > self.beyond;
        if is_added {
            for counts in [&mut self.counts, &mut self.counts_of_all] {
                *counts.entry(Some(Status::Inner)).or_default() += 1;
            }
        }
        is_added
    }

    /// The margin beyond which a reading of the set that is inner comes after all that this ranking lists; never negative.
    #[cfg(feature = "files")]
    pub(super) fn beyond(&self) -> f64 {
        self.beyond
    }

    /// Takes over what another ranking of as many readings found, which will be merged with this one.
    #[cfg(feature = "files")]
    pub(super) fn learn_beyond(&mut self, beyond: f64) {
        self.beyond = self.beyond.min(beyond);
    }

    /// Adds what was ranked apart.
    pub fn merge(&mut self, other: Ranking) {
        for (own, others) in
            [(&mut self.counts, other.counts), (&mut self.counts_of_all, other.counts_of_all)]
        {
            others.into_iter().for_each(|(status, count)| *own.entry(status).or_default() += count);
        }
        self.boundary.extend(other.boundary);
        self.listed.extend(other.listed);
        self.shorten(2);
    }

    /// Forgets what will not be listed, once it is so many times as much.
    fn shorten(&mut self, times: usize) {
        let most = self.most.saturating_mul(times);
        if self.listed.len() > most {
            self.listed.sort_by_cached_key(key);
            self.listed.truncate(self.most);
            self.last = self.listed.last().cloned();
            self.beyond = self.last.as_ref().map_or(self.beyond, |last| inner_beyond(last).min(self.beyond));
        }
        if self.boundary.len() > most {
            self.boundary.sort_unstable();
            self.boundary.truncate(self.most);
        }
    }

    /// The readings that matter most, those first that do more.
    pub fn into_listed(mut self) -> Vec<Judged> {
        self.listed.sort_by_cached_key(key);
        self.listed.truncate(self.most);
        self.listed
    }

    /// The first rows whose readings are on the boundary of the set of all, ascending.
    pub fn boundary(&self) -> Vec<usize> {
        let mut rows = self.boundary.clone();
        rows.sort_unstable();
        rows.truncate(self.most);
        rows
    }

    /// Returns the number of readings.
    pub fn count(&self) -> usize {
        self.counts.values().sum()
    }

    /// Returns the number of readings that have a status against the set of the others; `None` counts readings whose
    /// removal leaves nothing.
    pub fn count_without(&self, status: Option<Status>) -> usize {
        self.counts.get(&status).copied().unwrap_or_default()
    }

    /// Returns the number of readings that have a status against the set of all readings; `None` counts where that
    /// set is empty.
    pub fn count_of_all(&self, status: Option<Status>) -> usize {
        self.counts_of_all.get(&status).copied().unwrap_or_default()
    }
}

/// A margin beyond which readings that are inner come after this one.
fn inner_beyond(last: &Judged) -> f64 {
    /// More than what a number may lose when it is rounded to the nearest double.
    const UPWARDS: f64 = 1.0 + 4.0 * f64::EPSILON;
    match &last.status.without {
        None => f64::INFINITY,
        Some(standing) if standing.status > Status::Inner => 0.0,
        Some(standing) => standing.margin().map_or(0.0, |margin| margin.to_f64() * UPWARDS),
    }
}

fn name(standing: Option<&Standing>) -> Option<Status> {
    standing.map(|standing| standing.status)
}

/// The gravest first; readings that leave nothing either way last.
fn key(own: &Judged) -> (Reverse<Option<Status>>, Option<Rational>, usize) {
    let standing = own.status.without.as_ref();
    (Reverse(name(standing)), standing.and_then(Standing::margin), own.status.row)
}
