//! Rows of which nothing but numbers is wanted, and a key before one of them: as many as possible in one loop.

use std::ops::Range;

use boundfit_exact::{Column, NarrowCount, NarrowUnit, Others, Scaled, nearest_double, nearest_long_double};

use super::keys::RowKeys;
use super::lane::Lane;
use super::mantissa::{Mantissa, Plain};
use super::route::{Step, What};
use super::row::unquoted_key;
use crate::columns::decode;

/// The way through a row to up to four numbers.
pub(super) struct Straight {
    to: To,
    /// The columns that tell of one of these cells whether it has a number.
    presences: Vec<usize>,
}

enum To {
    One(Way<1>),
    Two(Way<2>),
    Three(Way<3>),
    Four(Way<4>),
}

/// The way to so many numbers, in the order in which they stand in a row.
pub(super) struct Way<const N: usize> {
    cells: [Cell; N],
    key: Option<Key>,
    /// The number of cells after the last of these.
    behind: usize,
}

/// The cell with the key.
#[derive(Clone, Copy)]
struct Key {
    /// The number of separators since the cell before.
    separators: usize,
    /// The index of the number that comes next.
    before: usize,
}

/// The numbers of a chunk that may turn out not to be short before none is taken for short any more.
const MOST_MISSES: usize = 32;

/// The cell of a key, and the position of its text among the keys.
type KnownKey = (Range<usize>, u32);

/// A cell with a number.
#[derive(Clone, Copy)]
struct Cell {
    /// The number of separators since the one before.
    separators: usize,
    column: usize,
    /// The least number that it may have, any or 0: one comparison does not branch on signs, which differ from cell to cell.
    least: i64,
}

impl Straight {
    /// Returns a fast path if every step reads a distinct column (presence checks excepted). `columns` is the number of columns of the
    /// table, `behind` the number of cells after them.
    pub(super) fn of(steps: &[Step], columns: usize, behind: usize) -> Option<Self> {
        let (mut cells, mut presences, mut key) = (Vec::new(), Vec::new(), None);
        for step in steps {
            match *step {
                Step { separators: Some(separators), what: What::Number { column, non_negative } } => {
                    let least = if non_negative { 0 } else { i64::MIN };
                    cells.push(Cell { separators, column, least });
                }
                Step { separators: Some(separators), what: What::Key } => {
                    key = Some(Key { separators, before: cells.len() });
                }
                Step { separators: None, what: What::Presence { column } } => presences.push(column),
                _ => return None,
            }
        }
        let is_last = |key: &Key| key.before == cells.len();
        if cells.len() + presences.len() != columns || key.as_ref().is_some_and(is_last) {
            return None;
        }
        let to = match *cells.as_slice() {
            [a] => To::One(Way { cells: [a], key, behind }),
            [a, b] => To::Two(Way { cells: [a, b], key, behind }),
            [a, b, c] => To::Three(Way { cells: [a, b, c], key, behind }),
            [a, b, c, d] => To::Four(Way { cells: [a, b, c, d], key, behind }),
            _ => return None,
        };
        Some(Straight { to, presences })
    }

    /// Adds the rows from a position on up to one that takes more than this; gives how many, and where that one starts. `None`
    /// when there are keys in quotes.
    pub(super) fn read(&self, lane: &mut Lane, at: usize) -> Option<(usize, usize)> {
        let mut columns = std::mem::take(&mut lane.batch.columns);
        let mut keys = lane.batch.keys.take();
        let mut others = std::mem::take(&mut lane.others);
        let read = match &self.to {
            To::One(way) => way.read(lane, at, &mut columns, keys.as_mut(), &mut others),
            To::Two(way) => way.read(lane, at, &mut columns, keys.as_mut(), &mut others),
            To::Three(way) => way.read(lane, at, &mut columns, keys.as_mut(), &mut others),
            To::Four(way) => way.read(lane, at, &mut columns, keys.as_mut(), &mut others),
        };
        lane.batch.keys = keys;
        lane.others = others;
        if let Some((rows, _)) = read {
            let is_presence = |(column, _): &(usize, &mut Column)| self.presences.contains(column);
            for (_, presence) in columns.iter_mut().enumerate().filter(is_presence) {
                presence.push_repeated(1, 0, rows);
            }
        }
        lane.batch.columns = columns;
        read
    }
}

impl<const N: usize> Way<N> {
    /// Reads like [`Straight::read`].
    fn read(
        &self,
        lane: &Lane,
        start: usize,
        columns: &mut [Column],
        keys: Option<&mut RowKeys>,
        others: &mut Others,
    ) -> Option<(usize, usize)> {
        // The loop without a key must not pay for one.
        match self.key {
            Some(_) if keys.is_none() || lane.is_quoted => None,
            Some(_) => self.read_rows::<true>(lane, start, columns, keys, others),
            None => self.read_rows::<false>(lane, start, columns, None, others),
        }
    }

    #[allow(clippy::indexing_slicing, reason = "there are as many units as cells")]
    fn read_rows<const KEYED: bool>(
        &self,
        lane: &Lane,
        start: usize,
        columns: &mut [Column],
        mut keys: Option<&mut RowKeys>,
        others: &mut Others,
    ) -> Option<(usize, usize)> {
        let mut columns = columns.get_disjoint_mut(self.cells.map(|cell| cell.column)).ok()?;
        if !lane.is_decimal {
            let push = |row: [f64; N]| {
                columns.iter_mut().zip(row).for_each(|(column, double)| column.push_double(double));
            };
            // A long line most likely has long numbers.
            return Some(if lane.next_line(start) - start > 12 * N {
                let read = |index, at| {
                    let ((mantissa, exponent), end) = self.number::<i128>(lane, index, at)?;
                    Some((nearest_long_double(mantissa, exponent)?, end))
                };
                self.rows::<KEYED, _>(lane, start, keys, read, push)
            } else {
                let read = |index, at| {
                    let ((mantissa, exponent), end) = self.number::<i64>(lane, index, at)?;
                    Some((nearest_double(mantissa, exponent)?, end))
                };
                self.rows::<KEYED, _>(lane, start, keys, read, push)
            });
        }
        if columns.iter().all(|column| matches!(column, Column::Narrow(_))) {
            let columns = columns.into_iter().map(Column::as_narrow_mut);
            let columns: Vec<&mut Scaled<i64>> = columns.collect::<Option<_>>()?;
            let mut columns: [_; N] = columns.try_into().ok()?;
            let units: [NarrowUnit; N] = std::array::from_fn(|index| columns[index].narrow_unit());
            let push = |columns: &mut [&mut Scaled<i64>; N], row: [NarrowCount; N]| {
                columns.iter_mut().zip(row).for_each(|(column, count)| column.push_narrow(count));
            };
            let is_allowed = |index: usize, count: NarrowCount| count.get() >= self.cells[index].least;
            let (mut rows, mut at) = (0, start);
            if !lane.is_quoted {
                let mut misses = 0;
                let read = |index: usize, at| {
                    let (count, end) = match lane.short_count(at, &units[index], others) {
                        Some(short) => short,
                        None if misses < MOST_MISSES => {
                            misses += 1;
                            lane.count(at, &units[index])?
                        }
                        None => return None,
                    };
                    is_allowed(index, count).then_some((count, end))
                };
                let keys = keys.as_deref_mut();
                (rows, at) = self.rows::<KEYED, _>(lane, at, keys, read, |row| push(&mut columns, row));
            }
            let read = |index: usize, at| {
                let ((mantissa, exponent), end) = self.number::<i64>(lane, index, at)?;
                Some((units[index].count(mantissa, exponent)?, end))
            };
            let (more, at) = self.rows::<KEYED, _>(lane, at, keys, read, |row| push(&mut columns, row));
            return Some((rows + more, at));
        }
        let push = |row: [(i128, i32); N]| {
            let numbers = columns.iter_mut().zip(row);
            numbers.for_each(|(column, (mantissa, exponent))| column.push_long_decimal(mantissa, exponent));
        };
        // Long columns most likely have long numbers.
        Some(self.rows::<KEYED, _>(lane, start, keys, |index, at| self.number::<i128>(lane, index, at), push))
    }

    /// The number in the cell that starts here, as its mantissa and exponent, and the end of the cell.
    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "as many numbers as cells")]
    fn number<M: Mantissa>(&self, lane: &Lane, index: usize, at: usize) -> Option<((M, i32), usize)> {
        let Plain { mantissa, exponent, end } = lane.plain_number::<M>(at)?;
        (mantissa.high_word() >= self.cells[index].least).then_some(((mantissa, exponent), end))
    }

    /// Adds rows as long as `read` gives each number and the end of its cell, from the index of the number and the start of the cell.
    #[inline(always)]
    fn rows<const KEYED: bool, T: Copy + Default>(
        &self,
        lane: &Lane,
        start: usize,
        mut keys: Option<&mut RowKeys>,
        mut read: impl FnMut(usize, usize) -> Option<(T, usize)>,
        mut push: impl FnMut([T; N]),
    ) -> (usize, usize) {
        let (mut rows, mut at, mut key) = (0, start, None);
        // The last two keys: two groups may take turns.
        let mut recent: [Option<KnownKey>; 2] = [None, None];
        while let Some((numbers, next)) = self.row::<KEYED, T>(lane, at, &recent, &mut key, &mut read) {
            let new_key = match &key {
                Some((cell, None)) if KEYED => match lane.chunk.get(cell.clone()).map(decode) {
                    Some(Ok(text)) => Some(unquoted_key(text)),
                    _ => break,
                },
                _ => None,
            };
            push(numbers);
            if KEYED && let (Some(keys), Some((cell, known))) = (&mut keys, key.take()) {
                let text = known.unwrap_or_else(|| keys.push(new_key.unwrap_or_default()));
                if known.is_some() {
                    keys.push_known(text);
                }
                if recent[0].as_ref().is_none_or(|(_, last)| *last != text) {
                    recent.swap(0, 1);
                    recent[0] = Some((cell, text));
                }
            }
            at = next;
            rows += 1;
        }
        (rows, at)
    }

    /// The numbers of the row that starts here, and the start of the next line. Its key is a recent one if it has the same text.
    #[inline(always)]
    #[allow(
        clippy::indexing_slicing,
        clippy::needless_range_loop,
        reason = "as many numbers as cells; iterators take more instructions"
    )]
    fn row<const KEYED: bool, T: Copy + Default>(
        &self,
        lane: &Lane,
        start: usize,
        recent: &[Option<KnownKey>],
        key: &mut Option<(Range<usize>, Option<u32>)>,
        read: &mut impl FnMut(usize, usize) -> Option<(T, usize)>,
    ) -> Option<([T; N], usize)> {
        // A line that starts with white space may be blank.
        if lane.chunk.get(start).is_none_or(|&first| first <= b' ') {
            return None;
        }
        let mut numbers = [T::default(); N];
        let mut at = start;
        for index in 0..N {
            if KEYED && let Some(own) = self.key.filter(|own| own.before == index) {
                for _ in 0..own.separators {
                    at = lane.after_separator(at)?;
                }
                let same = |(cell, text): &KnownKey| Some((cell.clone(), *text, lane.end_of_same(at, cell)?));
                (*key, at) = match recent.iter().flatten().find_map(same) {
                    Some((cell, text, end)) => (Some((cell, Some(text))), end),
                    None => {
                        let (contents, end) = lane.cell(at)?;
                        (Some((contents, None)), end)
                    }
                };
            }
            for _ in 0..self.cells[index].separators {
                at = lane.after_separator(at)?;
            }
            (numbers[index], at) = read(index, at)?;
        }
        Some((numbers, lane.end_of_row(at, self.behind)?))
    }
}
