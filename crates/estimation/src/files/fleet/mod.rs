//! Fleets: the readings of many sensors in one table, each sensor fitted on its own.
//!
//! The table is read once. A number takes eight bytes where the text allows it, a row one column of numbers each and the
//! number of its group; the rows of a group need not be neighbours and are gathered by counting.

mod chains;
mod groups;
mod keys;
mod lane;
mod series;

use std::io;
use std::ops::Range;

use boundfit_exact::Foreign;
use boundfit_formats::{Batch, ColumnSelector, InputError, RowNumbers, ScanOptions, Source, scan, threads};

use crate::files::Columns;
use crate::group_fit::GroupFit;
use crate::meaning::{ErrorBound, Meaning, Model};
use crate::measurement::Measurement;
use crate::measurements::Measurements;
use groups::Groups;
use keys::Keys;
use series::Series;

/// How many groups one piece of work has.
const GROUPS_PER_PIECE: usize = 64;
/// How many pieces are computed while those before are taken: enough for many threads, few enough to hold.
const PIECES_PER_BLOCK: usize = 32;

/// Readings with a text that says to which group each belongs. Groups are numbered from 0 in the order in which they
/// first occur.
#[derive(Debug, Clone)]
pub struct Fleet {
    meaning: Meaning,
    keys: Keys,
    groups: Groups,
    /// x or φ1 and φ2, then y, then the error bounds that are a column.
    columns: Vec<Series>,
    /// Which rows of the file these are.
    rows: RowNumbers,
    rows_missing: usize,
}

impl Fleet {
    /// Reads the columns of a table. Rows with the same text in the column `by`, spaces and tabs around it aside, are a
    /// group. What `options` say about keys is not looked at. Exact. Cost: one pass, on the threads of the current rayon
    /// pool; 8 bytes of memory per number and 4 to 8 per row.
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included; more than 2³² - 1 rows.
    pub fn read(
        source: Source,
        columns: &Columns,
        by: &ColumnSelector,
        options: ScanOptions,
    ) -> Result<Self, InputError> {
        let selectors = columns.selectors();
        let options = ScanOptions { key: Some(by.clone()), ..options };
        let file = source.name().to_owned();
        let mut store = Store { columns: vec![Series::default(); selectors.len()], ..Store::default() };
        let mut unbounded = None;
        let runs = |batch: Batch| (columns.first_unbounded(&batch), Runs::new(batch));
        let scanned = scan(source, &selectors, &options, runs, |(row, runs)| {
            unbounded = unbounded.or(row);
            store.push(&runs);
        })?;
        columns.refuse_unbounded(&file, unbounded)?;
        if store.is_full {
            let error = io::Error::other(format!("more than {} rows", u32::MAX));
            return Err(InputError::of_file(&file, error));
        }
        let meaning = columns.meaning(&scanned.names);
        let groups = Groups::new(&store.group_of, store.keys.len());
        let rows_missing = scanned.rows_missing;
        Ok(Fleet {
            meaning,
            keys: store.keys,
            groups,
            columns: store.columns,
            rows: store.rows,
            rows_missing,
        })
    }

    /// How many groups there are.
    pub fn len(&self) -> usize {
        self.groups.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many readings there are.
    pub fn readings(&self) -> usize {
        self.rows.len()
    }

    /// How many rows that were asked for were left out since they lack a number.
    pub fn rows_missing(&self) -> usize {
        self.rows_missing
    }

    /// Whether every reading has its own error bound.
    pub fn is_bounded_per_row(&self) -> bool {
        !self.meaning.error_bound.is_uniform()
    }

    /// Whether numbers may be long: some did not fit into machine words.
    pub fn has_fractions(&self) -> bool {
        self.columns.iter().any(Series::has_fractions)
    }

    /// The text that the rows of a group have in common.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn key(&self, group: usize) -> Foreign<&str> {
        Foreign::of(self.keys.get(group))
    }

    /// The readings of a group in the order of the file.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn measurements(&self, group: usize) -> Measurements {
        let measurement = |index: usize| {
            let numbers = self.columns.iter().map(|column| column.get(index));
            self.meaning.measurement(self.rows.get(index), numbers)
        };
        let mut rows: Vec<Measurement> = self.groups.rows(group).map(measurement).collect();
        let mut meaning = self.meaning.clone();
        meaning.settle(&mut rows);
        Measurements::of_meaning(meaning, rows)
    }

    /// What a line says of a group under no conditions: [`GroupFit::of`] its fit. `None` where only the fit tells: unless the model
    /// is a line with an intercept, the numbers are decimals of usual lengths, the error bound is one for all readings and their
    /// FPS is a polygon. Exact. Cost: O(N log N), a tenth of that of the fit.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn group_fit(&self, group: usize) -> Option<GroupFit> {
        let Meaning { model, has_response, error_bound, uniform_law, form, multiple_of_least, .. } =
            &self.meaning;
        let (Model::Line { .. }, ErrorBound::Uniform(epsilon), [x, y]) =
            (model, error_bound, self.columns.as_slice())
        else {
            return None;
        };
        let is_plain = *has_response
            && uniform_law.is_none()
            && multiple_of_least.is_none()
            && !form.through_origin
            && form.x_origin.is_zero();
        if !is_plain {
            return None;
        }
        let rows = self.groups.rows(group);
        let line = lane::group_fit(&x.counts(rows.clone())?, &y.counts(rows.clone())?, epsilon)?;
        Some(GroupFit { first_row: rows.map(|row| self.rows.get(row)).next(), ..line })
    }

    /// Calls `work` for consecutive groups, on the threads of the current rayon pool and in any order, and `take` with
    /// what it made of them, in order. Which groups go together is the same for any number of threads. Holds what a few
    /// thousand groups make.
    ///
    /// # Errors
    /// The first error of `take`, after which nothing more is computed.
    pub fn in_order<T: Send, E: Send>(
        &self,
        work: impl Fn(Range<usize>) -> T + Sync,
        mut take: impl FnMut(T) -> Result<(), E> + Send,
    ) -> Result<(), E> {
        let pieces = self.len().div_ceil(GROUPS_PER_PIECE);
        let piece =
            |index: usize| work(index * GROUPS_PER_PIECE..self.len().min((index + 1) * GROUPS_PER_PIECE));
        let mut ready: Vec<T> = Vec::new();
        for start in (0..pieces).step_by(PIECES_PER_BLOCK) {
            let block = start..pieces.min(start + PIECES_PER_BLOCK);
            let (next, taken) = threads::beside(
                || threads::map(block.collect(), piece),
                || ready.drain(..).try_for_each(&mut take),
            );
            taken?;
            ready = next;
        }
        ready.into_iter().try_for_each(take)
    }
}

/// The rows read so far.
#[derive(Default)]
struct Store {
    columns: Vec<Series>,
    group_of: Vec<u32>,
    keys: Keys,
    rows: RowNumbers,
    /// Whether there are more rows than can be numbered.
    is_full: bool,
}

impl Store {
    fn push(&mut self, Runs { batch, starts }: &Runs) {
        let Some(keys) = &batch.keys else { return };
        self.is_full |= u32::try_from(self.group_of.len() + batch.rows.len()).is_err();
        if self.is_full {
            return;
        }
        self.rows.append(&batch.rows);
        for (series, column) in self.columns.iter_mut().zip(&batch.columns) {
            series.push(column);
        }
        let ends = starts.iter().skip(1).copied().chain([batch.rows.len()]);
        for (&start, end) in starts.iter().zip(ends) {
            // There are no more groups than rows.
            let Some(group) = self.keys.number_of(keys.get(start)) else { return };
            self.group_of.extend(std::iter::repeat_n(group, end - start));
        }
    }
}

/// Rows with the places where a new key begins: a sorted table needs one look-up per group then.
struct Runs {
    batch: Batch,
    starts: Vec<usize>,
}

impl Runs {
    fn new(batch: Batch) -> Self {
        let begins = |&row: &usize| {
            batch.keys.as_ref().is_some_and(|keys| row == 0 || keys.get(row) != keys.get(row - 1))
        };
        let starts = (0..batch.rows.len()).filter(begins).collect();
        Runs { batch, starts }
    }
}
