//! Fleets: the readings of many sensors in one table, each sensor fitted on its own.
//!
//! The table is read once. A number takes eight bytes where the text allows it. A row takes one number in each column
//! and the number of its group. The rows of a group need not be neighbours: counting gathers them. Most of the later rows of
//! a large group are not kept (`streams.rs`).

mod chains;
mod groups;
mod keys;
mod lane;
mod plain;
mod store;
mod streams;

use std::collections::HashMap;
use std::io;
use std::ops::Range;
use std::sync::Arc;

use boundfit_exact::{Column, Foreign};
use boundfit_formats::{
    Batch, ColumnSelector, HeldRows, InputError, RowNumbers, ScanOptions, Source, TableNotes, scan, threads,
};
use boundfit_geometry::Tally;

use crate::files::Columns;
use crate::files::counted::CountedRows;
use crate::files::series::Series;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::measurements::{Measurements, Readings};
use crate::reduction::{DecidingMinimax, Reach, Reduction};
use crate::summary::{Keep, LineSummary, SharedSieve, Thresholds};
use crate::ties::Ties;
use groups::Groups;
use keys::Keys;
use store::{Digest, Store};
use streams::{LargeGroups, Stream};

/// The number of groups in one piece of work.
const GROUPS_PER_PIECE: usize = 64;
/// The number of pieces that are computed ahead: enough for many threads, few enough to hold in memory.
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
    /// The numbers of these rows in the file.
    rows: RowNumbers,
    /// Other rows, of which many are equal: the number of the group, and then as the columns.
    counted: CountedRows,
    counted_groups: Groups,
    /// The further rows of groups that have more than [`Keep::MOST_ROWS`].
    streams: HashMap<u32, Arc<Stream>>,
    rows_missing: usize,
    /// The keys of rows that were left out which no other row has.
    empty: Vec<String>,
    table: Option<TableNotes>,
}

impl Fleet {
    /// Reads the columns of a table. Rows with the same text in the column `by`, spaces and tabs around it aside, are
    /// a group. Ignores the option of `options` about keys. Exact. Cost: one pass, on the threads of the current
    /// rayon pool; 8 bytes of memory per number and 4 to 8 per row. A line under one bound for all readings takes 4
    /// bytes for most rows of a group beyond the first [`Keep::MOST_ROWS`].
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included; more than 2³² - 1 rows that are kept.
    pub fn read(
        source: Source,
        columns: &Columns,
        by: &ColumnSelector,
        options: ScanOptions,
    ) -> Result<Self, InputError> {
        Fleet::read_with(source, columns, by, options, columns.are_open().then(LargeGroups::default))
    }

    /// Reads as [`Fleet::read`] does, and keeps every reading for [`Fleet::each`].
    ///
    /// # Errors
    /// The errors of [`Fleet::read`].
    pub fn read_every(
        source: Source,
        columns: &Columns,
        by: &ColumnSelector,
        options: ScanOptions,
    ) -> Result<Self, InputError> {
        Fleet::read_with(source, columns, by, options, None)
    }

    /// Keeps every reading unless there may be large groups.
    fn read_with(
        source: Source,
        columns: &Columns,
        by: &ColumnSelector,
        options: ScanOptions,
        large: Option<LargeGroups>,
    ) -> Result<Self, InputError> {
        let selectors = columns.selectors();
        let options = ScanOptions { key: Some(by.clone()), ..options };
        let file = source.name().to_owned();
        let mut options = options;
        let held = HeldRows::limiting(&mut options);
        let mut store = Store::new(selectors.len());
        let mut unbounded = None;
        let mut lacking = Keys::default();
        let digest = |batch: Batch| {
            let unbounded = columns.first_unbounded(&batch);
            Digest::of(batch, unbounded, large.as_ref())
        };
        let scanned = scan(source, &selectors, &options, digest, |digest| {
            unbounded = unbounded.or(digest.unbounded);
            for key in &digest.keys_missing {
                let _ = lacking.number_of(key);
            }
            store.push(digest, large.as_ref(), &held);
        });
        held.check(file.raw())?;
        let scanned = scanned?;
        columns.refuse_unbounded(&file, unbounded)?;
        if store.is_full {
            let error = io::Error::other(format!("more than {} rows", u32::MAX));
            return Err(InputError::of_file(&file, error));
        }
        let meaning = columns.meaning(&scanned.names);
        let groups = Groups::new(&store.group_of, store.keys.len());
        drop(std::mem::take(&mut store.group_of));
        let counted_groups = Groups::new(&store.counted_group_of, store.keys.len());
        let (rows_missing, table) = (scanned.rows_missing, scanned.table);
        let Store { keys, columns, rows, counted, streams, .. } = store;
        let streams = streams.into_iter().map(|(group, stream)| (group, Arc::new(stream))).collect();
        let lacking = (0..lacking.len()).map(|number| lacking.get(number)).filter(|key| !keys.has(key));
        let empty = lacking.map(str::to_owned).collect();
        Ok(Fleet {
            meaning,
            keys,
            groups,
            columns,
            rows,
            counted,
            counted_groups,
            streams,
            rows_missing,
            empty,
            table,
        })
    }

    /// The number of groups there are.
    pub fn len(&self) -> usize {
        self.groups.len()
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The number of readings there are.
    pub fn readings(&self) -> usize {
        self.rows.len() + self.counted.rows() + self.streams.values().map(|own| own.rows()).sum::<usize>()
    }

    /// Returns how many rows that were asked for were left out since they lack a number.
    pub fn rows_missing(&self) -> usize {
        self.rows_missing
    }

    /// The texts that only rows have which were left out since they lack a number: no group.
    pub fn without_readings(&self) -> impl ExactSizeIterator<Item = Foreign<&str>> {
        self.empty.iter().map(|key| Foreign::of(key.as_str()))
    }

    /// Returns what the table was taken for; nothing unless it is text or a sheet.
    pub fn table(&self) -> Option<&TableNotes> {
        self.table.as_ref()
    }

    /// Returns whether every reading has its own error bound.
    pub fn is_bounded_per_row(&self) -> bool {
        !self.meaning.error_bound.is_uniform()
    }

    /// Returns whether numbers may be long: some did not fit into machine words.
    pub fn has_fractions(&self) -> bool {
        self.columns.iter().chain(self.counted.columns()).any(Series::has_fractions)
            || self.streams.values().any(|own| own.has_fractions)
    }

    /// The text that the rows of a group have in common.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn key(&self, group: usize) -> Foreign<&str> {
        Foreign::of(self.keys.get(group))
    }

    /// Returns the readings of a group in the order of the file. A group of more than [`Keep::MOST_ROWS`] readings
    /// keeps equal readings once where many are equal. Otherwise a line under one bound keeps the readings that
    /// support a hull.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn measurements(&self, group: usize) -> Measurements {
        let kinds = self.counted_groups.rows(group);
        let count = |kind: usize| self.counted.tally(kind).count() as usize;
        let is_large =
            self.groups.rows(group).len() + kinds.clone().map(count).sum::<usize>() > Keep::MOST_ROWS;
        match (is_large, kinds.len() > 0) {
            _ if self.stream(group).is_some() => return self.supporting(group),
            (true, false) if self.meaning.is_open() => return self.supporting(group),
            (true, true) => {}
            _ => return self.each(group),
        }
        let mut rows = self.kinds_of(group);
        rows.sort_by_key(|(reading, _)| reading.row);
        let mut ties = Ties::default();
        for (reading, tally) in &rows {
            tally.iter().for_each(|tally| ties.insert(reading.row, (*tally).clone()));
        }
        let mut rows: Vec<Measurement> = rows.into_iter().map(|(reading, _)| reading).collect();
        let mut meaning = self.meaning.clone();
        meaning.settle(&mut rows);
        Measurements::of_counted(meaning, rows, ties)
    }

    /// Every reading of a group by itself, in the order of the file. Only [`Fleet::read_every`] keeps all
    /// readings of a large group. Otherwise they are the [`Fleet::measurements`].
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn each(&self, group: usize) -> Measurements {
        if self.stream(group).is_some() {
            return self.supporting(group);
        }
        let mut rows: Vec<Measurement> = self.rows_of(group).collect();
        let kinds = self.counted_groups.rows(group);
        if kinds.len() > 0 {
            let each = |kind: usize| {
                let (reading, tally) = self.kind(kind);
                tally.rows().map(move |row| Measurement { row: row as usize, ..reading.clone() })
            };
            rows.extend(kinds.flat_map(each));
            rows.sort_by_key(|reading| reading.row);
        }
        let mut meaning = self.meaning.clone();
        meaning.settle(&mut rows);
        Measurements::of_meaning(meaning, rows)
    }

    /// The readings of a group that are kept by themselves, and behind them those that are counted.
    fn kinds_of(&self, group: usize) -> Vec<(Measurement, Option<&Tally>)> {
        let of_kind = |kind: usize| {
            let (reading, tally) = self.kind(kind);
            (reading, Some(tally))
        };
        let kinds = self.counted_groups.rows(group).map(of_kind);
        self.rows_of(group).map(|reading| (reading, None)).chain(kinds).collect()
    }

    /// The readings of a group that are kept by themselves.
    fn rows_of(&self, group: usize) -> impl ExactSizeIterator<Item = Measurement> + '_ {
        self.groups.rows(group).map(|index| {
            let numbers = self.columns.iter().map(|column| column.get(index));
            self.meaning.measurement(self.rows.get(index), numbers)
        })
    }

    /// A reading that is counted, and its rows.
    fn kind(&self, kind: usize) -> (Measurement, &Tally) {
        let tally = self.counted.tally(kind);
        // The first column has the group.
        let numbers = self.counted.numbers(kind).skip(1);
        (self.meaning.measurement(tally.first() as usize, numbers), tally)
    }

    /// The further readings of a large group.
    fn stream(&self, group: usize) -> Option<&Stream> {
        self.streams.get(&u32::try_from(group).ok()?).map(Arc::as_ref)
    }

    /// The readings of a group of a line under one bound that support a hull, with what is known of all.
    fn supporting(&self, group: usize) -> Measurements {
        let mut meaning = self.meaning.clone();
        let (stream, sieve) = (self.stream(group), SharedSieve::listing(Ties::MOST_LISTED));
        let mut summary = stream.map(|own| own.summary.clone()).unwrap_or_default();
        self.parts(group).for_each(|(numbers, [x, y])| {
            let own = LineSummary::of_columns([&x, &y], None, &|row| numbers[row], &sieve);
            summary.merge(own, &sieve);
        });
        let epsilon = meaning.error_bound.uniform().cloned().unwrap_or_default();
        let (sums, rows, ties) = summary.into_parts(&epsilon, &sieve);
        let form = meaning.form.clone();
        let rows = meaning.settled(rows);
        let (count, sums) = (sums.count, sums.counted_from(&form.x_origin));
        let thresholds = Thresholds::of_form(&form, &sums);
        let further = stream.and_then(|own| own.x.spread(&thresholds)).unwrap_or_default();
        let spreads = self.parts(group).map(|(_, [x, _])| thresholds.of_column(&x));
        let spread = spreads.fold(further, |spread, own| spread.merged(&own)).counted_from(&form.x_origin);
        let (radii, absolute) = (spread.absolute_weights(&sums), spread.absolute_x(&sums));
        let reach = Ok(Reach { radii, absolute, middles: None });
        let (minimax, has_widths) = (DecidingMinimax::Kept, true);
        let reduction = Reduction { count, sums: Ok(sums), reach, minimax, has_widths };
        Measurements::of_readings(meaning, Readings::Supporting { rows, ties, reduction })
    }

    /// The readings of a group of a line that are kept, as the numbers of their rows, x and y.
    fn parts(&self, group: usize) -> impl Iterator<Item = (Vec<usize>, [Column; 2])> + '_ {
        const ROWS: usize = 1 << 16;
        let starts = (0..self.groups.rows(group).len()).step_by(ROWS);
        let by_themselves = starts.map(move |start| {
            let rows = self.groups.rows_at(group, start..start + ROWS);
            let numbers = rows.clone().map(|row| self.rows.get(row)).collect();
            let column = |column: usize| match self.groups.run(group) {
                Some(run) => {
                    let first = run.start + start;
                    self.columns[column].column_of_run(first..first + rows.len())
                }
                None => self.columns[column].column(rows.clone()),
            };
            (numbers, [column(0), column(1)])
        });
        let kinds = self.counted_groups.rows(group);
        let rows_of = |kind: usize| self.counted.tally(kind).rows().map(move |row| (row as usize, kind));
        let mut counted: Vec<(usize, usize)> = kinds.flat_map(rows_of).collect();
        counted.sort_unstable();
        let counted = (!counted.is_empty()).then(|| {
            let kinds = || counted.iter().map(|(_, kind)| *kind);
            // The first column has the group.
            let columns = [1, 2].map(|column| self.counted.columns()[column].column(kinds()));
            (counted.iter().map(|(row, _)| *row).collect(), columns)
        });
        by_themselves.chain(counted)
    }

    /// Calls `work` for consecutive groups, on the threads of the current rayon pool and in any order, and `take`
    /// with what it made of them, in order. The partition into pieces is the same for any number of threads. Holds
    /// what a few thousand groups make.
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
