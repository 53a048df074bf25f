//! Rows of numbers, equal ones once: a sensor that is stuck, or gives few different numbers, has any number of them.

use std::hash::{BuildHasher, Hash, Hasher};

use boundfit_exact::{Column, Rational};
use boundfit_formats::{Batch, ColumnSelector, HeldRows, InputError, RowNumbers, ScanOptions, Source, scan};
use boundfit_geometry::Tally;
use hashbrown::{DefaultHashBuilder, HashTable};

use super::columns::Columns;
use super::scan::measurements;
use super::series::Series;
use crate::measurement::Measurement;
use crate::measurements::{Measurements, Readings};
use crate::reduction::Reduction;
use crate::selection::Selection;
use crate::ties::Ties;

/// The number of rows after which the search for equal rows stops if it has found few.
const ENOUGH_TO_TELL: usize = 4096;

/// The rows of a batch, equal ones once.
#[derive(Debug)]
pub struct CountedBatch {
    columns: Vec<Column>,
    /// The place of the first row of each kind, and all rows of that kind.
    kinds: Vec<(usize, Tally)>,
    rows: usize,
}

/// Rows as they come, equal ones once: their numbers, how many they are and which. Exact.
#[derive(Debug, Clone, Default)]
pub struct CountedRows {
    columns: Vec<Series>,
    tallies: Vec<Tally>,
    places: HashTable<u32>,
    hasher: DefaultHashBuilder,
    rows: usize,
    bytes: usize,
}

impl CountedBatch {
    /// The rows of columns of equal length with these numbers; rows with different keys are not equal. Where more than one of
    /// `least` rows is of a kind of its own, each row is. Cost: linear.
    pub fn new(
        columns: Vec<Column>,
        numbers: &RowNumbers,
        key: impl Fn(usize) -> Option<u32>,
        least: usize,
    ) -> Self {
        CountedBatch::up_to(columns, numbers, key, (least, usize::MAX))
    }

    /// The same of the first rows, up to one more kind than `most`.
    fn up_to(
        columns: Vec<Column>,
        numbers: &RowNumbers,
        key: impl Fn(usize) -> Option<u32>,
        (least, most): (usize, usize),
    ) -> Self {
        let hasher = DefaultHashBuilder::default();
        let hash = |row: usize| {
            let mut state = hasher.build_hasher();
            columns.iter().for_each(|column| column.hash_at(row, &mut state));
            key(row).hash(&mut state);
            state.finish()
        };
        let mut kinds: Vec<(usize, Tally)> = Vec::new();
        let mut places: HashTable<u32> = HashTable::new();
        let mut looks = true;
        let numbers = numbers.ranges().flat_map(|[first, last]| first..=last);
        let mut rows = 0;
        for (row, number) in numbers.enumerate() {
            if kinds.len() > most {
                break;
            }
            rows = row + 1;
            let number = number as u64;
            if looks && row == ENOUGH_TO_TELL && kinds.len().saturating_mul(least) > row {
                looks = false;
            }
            if !looks {
                kinds.push((row, Tally::one(number)));
                continue;
            }
            let own = hash(row);
            let is_equal = |&kind: &u32| {
                let other = kinds[kind as usize].0;
                columns.iter().all(|column| column.are_equal(row, other)) && key(row) == key(other)
            };
            match places.find(own, is_equal) {
                Some(&kind) => kinds[kind as usize].1.push(|| number, usize::MAX),
                None => {
                    places.insert_unique(own, kinds.len() as u32, |&kind| hash(kinds[kind as usize].0));
                    kinds.push((row, Tally::one(number)));
                }
            }
        }
        CountedBatch { columns, kinds, rows }
    }

    /// The number of rows there are.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Returns how many different ones.
    pub fn kinds(&self) -> usize {
        self.kinds.len()
    }

    /// The columns of all rows.
    pub(super) fn into_columns(self) -> Vec<Column> {
        self.columns
    }

    /// Returns whether of the first rows, and so maybe of all, at most one of `least` is different from those before it.
    pub fn are_few(columns: &[Column], least: usize) -> bool {
        let rows = columns.first().map_or(0, Column::len).min(ENOUGH_TO_TELL);
        let part: Vec<Column> = columns.iter().map(|column| column.part(0..rows)).collect();
        let numbers = std::iter::once(1..rows + 1).collect();
        // Where most rows differ, a few more than that part of them tell.
        let most = rows / least;
        rows > 0 && CountedBatch::up_to(part, &numbers, |_| None, (least, most)).kinds() <= most
    }

    /// Returns where the first row of each kind stands.
    pub fn positions(&self) -> impl Iterator<Item = usize> + '_ {
        self.kinds.iter().map(|(position, _)| *position)
    }
}

impl CountedRows {
    /// Adds later rows, where a column is given with a number for each kind of the batch before its own. Exact.
    pub fn push(&mut self, batch: CountedBatch, leading: Option<&Column>) {
        let CountedBatch { columns, kinds, rows } = batch;
        self.rows += rows;
        self.columns.resize(columns.len() + usize::from(leading.is_some()), Series::default());
        for (kind, (position, tally)) in kinds.into_iter().enumerate() {
            let leading = leading.map(|column| (column, kind));
            let cells = leading.into_iter().chain(columns.iter().map(|column| (column, position)));
            self.add(&cells.collect::<Vec<_>>(), tally);
        }
    }

    fn add(&mut self, cells: &[(&Column, usize)], tally: Tally) {
        let numbers: Vec<Rational> = cells.iter().map(|(column, position)| column.get(*position)).collect();
        let hash = self.hasher.hash_one(&numbers);
        let CountedRows { columns, tallies, places, hasher, bytes, .. } = self;
        let is_equal = |&kind: &u32| {
            columns.iter().zip(&numbers).all(|(column, number)| column.get(kind as usize) == *number)
        };
        if let Some(&kind) = places.find(hash, is_equal) {
            let own = &mut tallies[kind as usize];
            *bytes -= own.heap_bytes();
            own.append(&tally, usize::MAX);
            *bytes += own.heap_bytes();
            return;
        }
        let again = |&kind: &u32| {
            hasher.hash_one(columns.iter().map(|column| column.get(kind as usize)).collect::<Vec<_>>())
        };
        places.insert_unique(hash, tallies.len() as u32, again);
        for (own, (column, position)) in columns.iter_mut().zip(cells) {
            own.push(&column.part(*position..position + 1));
        }
        *bytes += size_of::<Tally>() + tally.heap_bytes();
        tallies.push(tally);
    }

    /// The number of rows there are.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Returns how many different ones.
    pub fn kinds(&self) -> usize {
        self.tallies.len()
    }

    /// The numbers of all kinds, in columns.
    pub(super) fn columns(&self) -> &[Series] {
        &self.columns
    }

    /// Bytes that the numbers of rows take.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// The numbers of the rows of a kind.
    ///
    /// # Panics
    /// When there are not that many kinds.
    pub fn numbers(&self, kind: usize) -> impl Iterator<Item = Rational> + '_ {
        self.columns.iter().map(move |column| column.get(kind))
    }

    /// The rows of a kind.
    ///
    /// # Panics
    /// When there are not that many kinds.
    pub fn tally(&self, kind: usize) -> &Tally {
        &self.tallies[kind]
    }

    /// The first row of each kind, with the kind; ascending.
    pub fn first_rows(&self) -> Vec<(usize, usize)> {
        let first = |(kind, tally): (usize, &Tally)| (tally.first() as usize, kind);
        self.tallies.iter().enumerate().map(first).collect()
    }

    /// Every row with its kind, ascending.
    pub fn in_order(&self) -> Vec<(usize, usize)> {
        let of_kind =
            |(kind, tally): (usize, &Tally)| tally.rows().map(|row| (row as usize, kind)).collect::<Vec<_>>();
        let mut rows: Vec<(usize, usize)> = self.tallies.iter().enumerate().flat_map(of_kind).collect();
        rows.sort_unstable();
        rows
    }
}

impl Measurements {
    /// Reads as [`Measurements::read_beside`] does for a table that is no reduction, without the unwanted rows. Keeps
    /// equal readings once if there are more than `most_rows` readings and at least half of them equal an earlier
    /// one. Equal readings have equal numbers in the further columns, too, and the further columns list each number
    /// once. Exact. Cost: one pass; memory for the different readings, and about a byte for the number of each row.
    ///
    /// # Errors
    /// The first thing wrong with the file, a negative error bound included; more rows, or more memory for them, than there may be.
    pub fn read_counted(
        source: Source,
        columns: &Columns,
        beside: &[ColumnSelector],
        options: &ScanOptions,
        most_rows: usize,
    ) -> Result<(Self, Vec<Vec<Rational>>), InputError> {
        let file = source.name().to_owned();
        let own = columns.selectors();
        let selectors: Vec<ColumnSelector> = own.iter().chain(beside).cloned().collect();
        let mut options = options.clone();
        let held = HeldRows::limiting(&mut options);
        let mut counted = CountedRows::default();
        let digest = |batch: Batch| CountedBatch::new(batch.columns, &batch.rows, |_| None, 1);
        let scanned = scan(source, &selectors, &options, digest, |batch| {
            let (rows, kinds, bytes) = (counted.rows(), counted.kinds(), counted.bytes());
            counted.push(batch, None);
            let more = counted.bytes().saturating_sub(bytes);
            held.add_counted(counted.rows() - rows, counted.kinds() - kinds, more);
        });
        held.check(file.raw())?;
        let scanned = scanned?;
        columns.refuse_long_in_each(&file, counted.kinds(), options.table.sizes.work)?;
        let mut meaning = columns.meaning(&scanned.names);
        let is_counted = counted.rows() > most_rows && 2 * counted.kinds() <= counted.rows();
        let rows = if is_counted { counted.first_rows() } else { counted.in_order() };
        let further = |position: usize| {
            let number = |(_, kind): &(usize, usize)| counted.numbers(*kind).nth(own.len() + position);
            rows.iter().map(number).map(Option::unwrap_or_default).collect()
        };
        let further: Vec<Vec<Rational>> = (0..beside.len()).map(further).collect();
        let reading =
            |&(row, kind): &(usize, usize)| meaning.measurement(row, counted.numbers(kind).take(own.len()));
        let mut readings: Vec<Measurement> = rows.iter().map(reading).collect();
        let is_bounded = |row: &Measurement| row.lower().or_else(|| row.upper()).is_some();
        let unbounded = readings.iter().find(|row| !is_bounded(row)).map(|row| row.row);
        columns.refuse_unbounded(&file, unbounded)?;
        meaning.settle(&mut readings);
        let readings = if is_counted {
            let mut ties = Ties::default();
            counted.tallies.into_iter().for_each(|tally| ties.insert(tally.first() as usize, tally));
            let reduction = Reduction::of_counted(&meaning, &readings, &ties);
            Readings::Counted { rows: readings, ties, reduction }
        } else {
            Readings::All(readings)
        };
        Ok((measurements(meaning, Selection::of(&options.table), scanned, readings), further))
    }
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Unit;

    use super::*;

    #[test]
    fn equal_rows_are_told_once_whatever_their_units_are() {
        let mut all = CountedRows::default();
        let mut row = 1;
        let mut expected: Vec<(Vec<Rational>, Vec<u64>)> = Vec::new();
        for (exponent, scale) in [(0, 1), (-1, 10), (2, 1), (0, 1)] {
            let counts: Vec<i128> = (0..50).map(|k| k * k % 7 * scale).collect();
            let x = Column::of_counts(counts.iter().copied(), Unit::TenTo(exponent));
            let y = Column::of_counts(counts.iter().map(|count| count % 3), Unit::TenTo(0));
            let numbers: RowNumbers = [row..row + 20, row + 30..row + 60].into_iter().collect();
            for k in 0..50 {
                let own = vec![x.get(k), y.get(k)];
                let number = numbers.get(k) as u64;
                match expected.iter_mut().find(|(known, _)| *known == own) {
                    Some((_, rows)) => rows.push(number),
                    None => expected.push((own, vec![number])),
                }
            }
            row += 70;
            all.push(CountedBatch::new(vec![x, y], &numbers, |_| None, 1), None);
        }
        assert_eq!((all.rows(), all.kinds()), (200, expected.len()));
        for (kind, (numbers, rows)) in expected.iter().enumerate() {
            assert_eq!(all.numbers(kind).collect::<Vec<_>>(), *numbers);
            assert_eq!(all.tally(kind).rows().collect::<Vec<_>>(), *rows);
        }
        let order = all.in_order();
        assert!(order.len() == 200 && order.is_sorted());
        assert!(order.iter().all(|(row, kind)| expected[*kind].1.contains(&(*row as u64))));
    }

    #[test]
    fn rows_with_different_keys_are_not_equal() {
        let column = Column::of_counts((0..40).map(|k| k % 2), Unit::TenTo(0));
        let numbers: RowNumbers = std::iter::once(1..41).collect();
        let batch = CountedBatch::new(vec![column], &numbers, |row| Some(row as u32 / 20), 1);
        assert_eq!(batch.positions().collect::<Vec<_>>(), [0, 1, 20, 21]);
        let mut all = CountedRows::default();
        all.push(batch, Some(&Column::of_counts((0..4).map(|kind| kind / 2), Unit::TenTo(0))));
        let first = all.numbers(2).next();
        assert_eq!((all.kinds(), first), (4, Some(Rational::one())));
    }
}
