//! Fleets: the readings of many sensors in one table, each sensor fitted on its own.
//!
//! The table is read once. A number takes eight bytes where the text allows it. A row takes one number in each column
//! and the number of its group. The rows of a group need not be neighbours: counting gathers them.

mod chains;
mod groups;
mod keys;
mod lane;
mod plain;

use std::collections::HashMap;
use std::io;
use std::ops::Range;

use boundfit_exact::{Column, Foreign, Unit};
use boundfit_formats::{
    Batch, ColumnSelector, HeldRows, InputError, RowNumbers, ScanOptions, Source, TableNotes, scan, threads,
};
use boundfit_geometry::Tally;

use crate::files::Columns;
use crate::files::counted::{CountedBatch, CountedRows};
use crate::files::series::Series;
use crate::meaning::Meaning;
use crate::measurement::Measurement;
use crate::measurements::{Measurements, Readings};
use crate::reduction::{DecidingMinimax, Reach, Reduction};
use crate::summary::{Keep, LineSummary, SharedSieve, Spread, Thresholds};
use crate::ties::Ties;
use groups::Groups;
use keys::Keys;
pub(super) use lane::Counts;

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
    rows_missing: usize,
    /// The keys of rows that were left out which no other row has.
    empty: Vec<String>,
    table: Option<TableNotes>,
}

impl Fleet {
    /// Reads the columns of a table. Rows with the same text in the column `by`, spaces and tabs around it aside, are
    /// a group. Ignores the option of `options` about keys. Exact. Cost: one pass, on the threads of the current
    /// rayon pool; 8 bytes of memory per number and 4 to 8 per row.
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
        let mut options = options;
        let held = HeldRows::limiting(&mut options);
        let mut store = Store { columns: vec![Series::default(); selectors.len()], ..Store::default() };
        let mut unbounded = None;
        let mut lacking = Keys::default();
        let part = |mut batch: Batch| {
            let keys_missing = std::mem::take(&mut batch.keys_missing);
            (columns.first_unbounded(&batch), keys_missing, Part::of(batch))
        };
        let scanned = scan(source, &selectors, &options, part, |(row, keys_missing, part)| {
            unbounded = unbounded.or(row);
            for key in &keys_missing {
                let _ = lacking.number_of(key);
            }
            store.push(part, &held);
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
        let Store { keys, columns, rows, counted, .. } = store;
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
        self.rows.len() + self.counted.rows()
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

    /// Every reading of a group by itself, in the order of the file.
    ///
    /// # Panics
    /// When there are not that many groups.
    pub fn each(&self, group: usize) -> Measurements {
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

    /// The readings of a group of a line under one bound that support a hull, with what is known of all.
    fn supporting(&self, group: usize) -> Measurements {
        const ROWS: usize = 1 << 16;
        let mut meaning = self.meaning.clone();
        let count = self.groups.rows(group).len();
        let part = |column: usize, start: usize| {
            let rows = self.groups.rows_at(group, start..start + ROWS);
            let part = |series: &Series| match self.groups.run(group) {
                Some(run) => {
                    let first = run.start + start;
                    series.column_of_run(first..first + rows.len())
                }
                None => series.column(rows),
            };
            self.columns.get(column).map(part).unwrap_or_default()
        };
        let (mut summary, sieve) = (LineSummary::default(), SharedSieve::listing(Ties::MOST_LISTED));
        for start in (0..count).step_by(ROWS) {
            let rows = self.groups.rows_at(group, start..start + ROWS);
            let numbers: Vec<usize> = rows.map(|row| self.rows.get(row)).collect();
            let [x, y] = [part(0, start), part(1, start)];
            let own = LineSummary::of_columns([&x, &y], None, &|row| numbers[row], &sieve);
            summary.merge(own, &sieve);
        }
        let epsilon = meaning.error_bound.uniform().cloned().unwrap_or_default();
        let (sums, rows, ties) = summary.into_parts(&epsilon, &sieve);
        let form = meaning.form.clone();
        let rows = meaning.settled(rows);
        let sums = sums.counted_from(&form.x_origin);
        let thresholds = Thresholds::of_form(&form, &sums);
        let mut spread = Spread::default();
        for start in (0..count).step_by(ROWS) {
            spread = spread.merged(&thresholds.of_column(&part(0, start)));
        }
        let spread = spread.counted_from(&form.x_origin);
        let (radii, absolute) = (spread.absolute_weights(&sums), spread.absolute_x(&sums));
        let reach = Ok(Reach { radii, absolute, middles: None });
        let (minimax, has_widths) = (DecidingMinimax::Kept, true);
        let reduction = Reduction { count, sums: Ok(sums), reach, minimax, has_widths };
        Measurements::of_readings(meaning, Readings::Supporting { rows, ties, reduction })
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

/// The rows read so far.
#[derive(Default)]
struct Store {
    columns: Vec<Series>,
    group_of: Vec<u32>,
    keys: Keys,
    rows: RowNumbers,
    counted: CountedRows,
    counted_group_of: Vec<u32>,
    /// True if there are more rows than can be numbered.
    is_full: bool,
}

impl Store {
    fn push(&mut self, part: Part, held: &HeldRows) {
        match part {
            Part::Each { batch, starts } => {
                // Its numbers, its group, and its place in the order of groups.
                let bytes = 8 * (self.columns.len() as u64 + 1);
                held.add_bytes(batch.rows.len(), batch.rows.len(), bytes * batch.rows.len() as u64);
                self.push_each(&batch, &starts);
            }
            Part::Counted { rows, keys, key_of } => {
                let before = (self.counted.kinds(), self.counted.bytes());
                let met = rows.rows();
                self.push_counted(rows, &keys, &key_of);
                let more = self.counted.bytes().saturating_sub(before.1);
                held.add_counted(met, self.counted.kinds() - before.0, more);
            }
        }
    }

    fn push_each(&mut self, batch: &Batch, starts: &[usize]) {
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

    fn push_counted(&mut self, rows: CountedBatch, keys: &[String], key_of: &[usize]) {
        let numbers: Option<Vec<u32>> = keys.iter().map(|key| self.keys.number_of(key)).collect();
        let Some(numbers) = numbers else { return };
        let groups = key_of.iter().filter_map(|&key| numbers.get(key).copied());
        let groups = Column::of_counts(groups.map(i128::from), Unit::TenTo(0));
        let before = self.counted.kinds();
        self.counted.push(rows, Some(&groups));
        let group = |kind: usize| self.counted.numbers(kind).next()?.numerator().to_i128();
        let new =
            (before..self.counted.kinds()).map(|kind| group(kind).and_then(|own| u32::try_from(own).ok()));
        self.counted_group_of.extend(new.map(Option::unwrap_or_default));
    }
}

/// The divisor of the number of rows: counting equal rows pays if there are at most this part of different rows.
const FEWEST_EQUAL: usize = 4;

/// The rows of a batch.
enum Part {
    /// Each, with the places where a new key begins: a sorted table needs one look-up per group then.
    Each { batch: Batch, starts: Vec<usize> },
    /// Equal ones once, each kind with the number of its key.
    Counted { rows: CountedBatch, keys: Vec<String>, key_of: Vec<usize> },
}

impl Part {
    fn of(mut batch: Batch) -> Self {
        let mut last = None;
        let begins = |&row: &usize| {
            let key = batch.keys.as_ref().map(|keys| keys.get(row));
            key.is_some() && last.replace(key) != Some(key)
        };
        let starts: Vec<usize> = (0..batch.rows.len()).filter(begins).collect();
        if starts.is_empty() || !CountedBatch::are_few(&batch.columns, FEWEST_EQUAL) {
            return Part::Each { batch, starts };
        }
        let (keys, number_of) = Part::keys(&batch, &starts);
        let key = |row: usize| number_of.get(row).map(|&number| number as u32);
        let columns = std::mem::take(&mut batch.columns);
        let rows = CountedBatch::new(columns, &batch.rows, key, FEWEST_EQUAL);
        if rows.kinds() * FEWEST_EQUAL > rows.rows() {
            let columns = rows.into_columns();
            return Part::Each { batch: Batch { columns, ..batch }, starts };
        }
        let key_of = rows.positions().filter_map(|row| number_of.get(row).copied()).collect();
        Part::Counted { rows, keys, key_of }
    }

    /// The different keys in the order in which they come, and the number of that of each row.
    fn keys(batch: &Batch, starts: &[usize]) -> (Vec<String>, Vec<usize>) {
        let Some(texts) = &batch.keys else { return <(Vec<String>, Vec<usize>)>::default() };
        let mut keys: Vec<String> = Vec::new();
        let mut numbers: HashMap<&str, usize> = HashMap::new();
        let mut number_of = Vec::with_capacity(batch.rows.len());
        let ends = starts.iter().skip(1).copied().chain([batch.rows.len()]);
        for (&start, end) in starts.iter().zip(ends) {
            let key = texts.get(start);
            let number = *numbers.entry(key).or_insert_with(|| {
                keys.push(key.to_owned());
                keys.len() - 1
            });
            number_of.extend(std::iter::repeat_n(number, end - start));
        }
        (keys, number_of)
    }
}
