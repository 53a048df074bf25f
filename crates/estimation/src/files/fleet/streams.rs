//! Large groups of a line under one bound. The fleet keeps few of their further rows: those that support a hull, as a fit
//! of one line does. It also keeps every x for the EUI.

use std::sync::{Arc, RwLock};

use boundfit_exact::Column;
use boundfit_formats::{Batch, RowNumbers};
use hashbrown::HashMap;

use crate::files::kept_columns::{KeptColumns, KeptPart};
use crate::files::series::are_fractions;
use crate::summary::{LineSummary, SharedSieve};
use crate::ties::Ties;

/// The number of rows of a group in a batch that are worth a summary.
const FEWEST: usize = 64;

/// The groups that are known to be large, by key. A thread that reads ahead may not know the last one yet, and keeps its rows
/// one by one; no answer depends on that.
#[derive(Default)]
pub(super) struct LargeGroups {
    by_key: RwLock<HashMap<String, Large>>,
}

#[derive(Clone)]
struct Large {
    group: u32,
    sieve: Arc<SharedSieve>,
}

/// A large group, and the places of its rows in a batch.
type Found = (Large, Vec<usize>);

/// The further rows of a large group.
#[derive(Debug)]
pub(super) struct Stream {
    pub(super) summary: LineSummary,
    pub(super) x: KeptColumns,
    pub(super) has_fractions: bool,
}

/// The rows of a large group in one batch.
pub(super) struct Further {
    large: Large,
    summary: LineSummary,
    x: KeptPart,
    has_fractions: bool,
}

impl LargeGroups {
    /// Remembers a group.
    pub(super) fn add(&self, key: &str, group: u32) {
        if let Ok(mut by_key) = self.by_key.write() {
            let large = || Large { group, sieve: Arc::new(SharedSieve::listing(Ties::MOST_LISTED)) };
            by_key.entry_ref(key).or_insert_with(large);
        }
    }

    /// Takes the rows of large groups out of a batch.
    pub(super) fn take(&self, batch: &mut Batch) -> Vec<Further> {
        let Some((found, rest)) = self.places(batch) else { return Vec::new() };
        let further = found.into_iter().map(|(large, places)| {
            let [x, y] = [0, 1].map(|column| at(&batch.columns, column, &places));
            let row = |position: usize| batch.rows.get(places[position]);
            let summary = LineSummary::of_columns([&x, &y], None, &row, &large.sieve);
            let has_fractions = [&x, &y].into_iter().any(are_fractions);
            Further { large, summary, x: KeptPart::new(&[x], RowNumbers::default()), has_fractions }
        });
        let further = further.collect();
        batch.columns = (0..batch.columns.len()).map(|column| at(&batch.columns, column, &rest)).collect();
        batch.rows = rest.iter().map(|&place| batch.rows.get(place)).map(|row| row..row + 1).collect();
        batch.keys = batch.keys.take().map(|keys| keys.at(&rest));
        further
    }

    /// The places of the rows of large groups in a batch, and those of its other rows; `None` if there are no large groups.
    fn places(&self, batch: &Batch) -> Option<(Vec<Found>, Vec<usize>)> {
        let (by_key, keys) = (self.by_key.read().ok()?, batch.keys.as_ref()?);
        if by_key.is_empty() {
            return None;
        }
        let mut found: Vec<Found> = Vec::new();
        let of_text = |key: &str| {
            let large = by_key.get(key)?;
            let known = found.iter().position(|(own, _)| own.group == large.group);
            Some(known.unwrap_or_else(|| {
                found.push((large.clone(), Vec::new()));
                found.len() - 1
            }))
        };
        let lists: Vec<Option<usize>> = keys.texts().map(of_text).collect();
        let mut rest = Vec::new();
        for (row, &text) in keys.text_of().iter().enumerate() {
            lists[text as usize].map_or(&mut rest, |list| &mut found[list].1).push(row);
        }
        let is_few = |(_, places): &mut Found| places.len() < FEWEST;
        rest.extend(found.extract_if(.., is_few).flat_map(|(_, places)| places));
        rest.sort_unstable();
        (!found.is_empty()).then_some((found, rest))
    }
}

fn at(columns: &[Column], column: usize, places: &[usize]) -> Column {
    columns[column].at(places.iter().copied())
}

impl Further {
    /// The number of the group.
    pub(super) fn group(&self) -> u32 {
        self.large.group
    }

    /// The number of rows, and the bytes that are kept of them.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.summary.sums.count, self.x.bytes())
    }
}

impl Default for Stream {
    fn default() -> Self {
        Stream { summary: LineSummary::default(), x: KeptColumns::new(usize::MAX), has_fractions: false }
    }
}

impl Stream {
    pub(super) fn push(&mut self, Further { large, summary, x, has_fractions }: Further) {
        self.summary.merge(summary, &large.sieve);
        self.x.push(x);
        self.has_fractions |= has_fractions;
    }

    /// The number of rows.
    pub(super) fn rows(&self) -> usize {
        self.summary.sums.count
    }
}
