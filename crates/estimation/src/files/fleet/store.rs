//! The rows of a fleet while it is read, batch by batch.

use std::collections::HashMap;

use boundfit_exact::{Column, Unit};
use boundfit_formats::{Batch, HeldRows, RowKeys, RowNumbers};

use super::keys::Keys;
use super::streams::{Further, LargeGroups, Stream};
use crate::files::counted::{CountedBatch, CountedRows};
use crate::files::series::Series;
use crate::summary::Keep;

/// The rows read so far.
#[derive(Default)]
pub(super) struct Store {
    pub(super) columns: Vec<Series>,
    pub(super) group_of: Vec<u32>,
    pub(super) keys: Keys,
    pub(super) rows: RowNumbers,
    pub(super) counted: CountedRows,
    pub(super) counted_group_of: Vec<u32>,
    /// The further rows of large groups.
    pub(super) streams: HashMap<u32, Stream>,
    /// The number of rows of each group that are kept by themselves, unless all are.
    sizes: Vec<usize>,
    /// True if there are more rows than can be numbered.
    pub(super) is_full: bool,
}

impl Store {
    /// A store for a number of columns, without rows.
    pub(super) fn new(columns: usize) -> Self {
        Store { columns: vec![Series::default(); columns], ..Store::default() }
    }

    /// Adds what a batch came to. `large` learns of the groups whose further rows need not be kept, if there may be some.
    pub(super) fn push(
        &mut self,
        Digest { further, rest, .. }: Digest,
        large: Option<&LargeGroups>,
        held: &HeldRows,
    ) {
        for further in further {
            let (rows, bytes) = further.size();
            held.add_bytes(rows, 0, bytes as u64);
            self.streams.entry(further.group()).or_default().push(further);
        }
        self.push_part(rest, large, held);
    }

    fn push_part(&mut self, part: Part, large: Option<&LargeGroups>, held: &HeldRows) {
        match part {
            Part::Each(batch) => {
                // Its numbers, its group, and its place in the order of groups.
                let bytes = 8 * (self.columns.len() as u64 + 1);
                held.add_bytes(batch.rows.len(), batch.rows.len(), bytes * batch.rows.len() as u64);
                self.push_each(&batch, large);
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

    fn push_each(&mut self, batch: &Batch, large: Option<&LargeGroups>) {
        let Some(keys) = &batch.keys else { return };
        self.is_full |= u32::try_from(self.group_of.len() + batch.rows.len()).is_err();
        // There are no more groups than rows.
        let groups: Option<Vec<u32>> = keys.texts().map(|key| self.keys.number_of(key)).collect();
        let Some(groups) = groups.filter(|_| !self.is_full) else { return };
        self.rows.append(&batch.rows);
        for (series, column) in self.columns.iter_mut().zip(&batch.columns) {
            series.push(column);
        }
        self.group_of.extend(keys.text_of().iter().map(|&text| groups[text as usize]));
        if let Some(large) = large {
            self.find_large(keys, &groups, large);
        }
    }

    /// Tells of the groups that have become large with the last rows.
    fn find_large(&mut self, keys: &RowKeys, groups: &[u32], large: &LargeGroups) {
        let mut more = vec![0; groups.len()];
        keys.text_of().iter().for_each(|&text| more[text as usize] += 1);
        self.sizes.resize(self.keys.len(), 0);
        for ((key, &group), more) in keys.texts().zip(groups).zip(more) {
            let size = &mut self.sizes[group as usize];
            let was_large = *size > Keep::MOST_ROWS;
            *size += more;
            if !was_large && *size > Keep::MOST_ROWS {
                large.add(key, group);
            }
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

/// A batch.
pub(super) struct Digest {
    /// The first row without bounds.
    pub(super) unbounded: Option<usize>,
    /// The keys of rows that lack a number.
    pub(super) keys_missing: Vec<String>,
    /// The rows of large groups.
    further: Vec<Further>,
    /// The other rows.
    rest: Part,
}

impl Digest {
    /// Sums up the rows of groups that are known to be large.
    pub(super) fn of(mut batch: Batch, unbounded: Option<usize>, large: Option<&LargeGroups>) -> Self {
        let keys_missing = std::mem::take(&mut batch.keys_missing);
        let further = large.map(|large| large.take(&mut batch)).unwrap_or_default();
        Digest { unbounded, keys_missing, further, rest: Part::of(batch) }
    }
}

/// The rows of a batch that are kept.
enum Part {
    /// Each.
    Each(Batch),
    /// Equal ones once, each kind with the number of its key.
    Counted { rows: CountedBatch, keys: Vec<String>, key_of: Vec<usize> },
}

impl Part {
    fn of(mut batch: Batch) -> Self {
        let Some(texts) = &batch.keys else { return Part::Each(batch) };
        if !CountedBatch::are_few(&batch.columns, FEWEST_EQUAL) {
            return Part::Each(batch);
        }
        let (keys, numbers) = Part::distinct(texts);
        let number = |row: usize| texts.text_of().get(row).map(|&text| numbers[text as usize]);
        let columns = std::mem::take(&mut batch.columns);
        let key = |row: usize| number(row).map(|number| number as u32);
        let rows = CountedBatch::new(columns, &batch.rows, key, FEWEST_EQUAL);
        if rows.kinds() * FEWEST_EQUAL > rows.rows() {
            let columns = rows.into_columns();
            return Part::Each(Batch { columns, ..batch });
        }
        let key_of = rows.positions().filter_map(number).collect();
        Part::Counted { rows, keys, key_of }
    }

    /// The different keys in the order in which they come, and the number of that of each text.
    fn distinct(texts: &RowKeys) -> (Vec<String>, Vec<usize>) {
        let mut keys: Vec<String> = Vec::new();
        let mut numbers: HashMap<&str, usize> = HashMap::new();
        let number = |key| {
            *numbers.entry(key).or_insert_with(|| {
                keys.push(key.to_owned());
                keys.len() - 1
            })
        };
        let number_of = texts.texts().map(number).collect();
        (keys, number_of)
    }
}
