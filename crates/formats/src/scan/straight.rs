//! Rows of which nothing but decimals is wanted: as many as possible in one loop.

use boundfit_exact::{Column, Scaled};

use super::lane::{Lane, Plain, Step, What};

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
    /// The number of cells after the last of these.
    behind: usize,
}

/// A cell with a number.
#[derive(Clone, Copy)]
struct Cell {
    /// The number of separators since the one before.
    separators: usize,
    column: usize,
    non_negative: bool,
}

impl Straight {
    /// Returns a fast path if every step reads a distinct column (presence checks excepted). `columns` is the number of columns of the
    /// table, `behind` the number of cells after them.
    pub(super) fn of(steps: &[Step], columns: usize, behind: usize) -> Option<Self> {
        let (mut cells, mut presences) = (Vec::new(), Vec::new());
        for step in steps {
            match *step {
                Step { separators: Some(separators), what: What::Number { column, non_negative } } => {
                    cells.push(Cell { separators, column, non_negative });
                }
                Step { separators: None, what: What::Presence { column } } => presences.push(column),
                _ => return None,
            }
        }
        if cells.len() + presences.len() != columns {
            return None;
        }
        let to = match *cells.as_slice() {
            [a] => To::One(Way { cells: [a], behind }),
            [a, b] => To::Two(Way { cells: [a, b], behind }),
            [a, b, c] => To::Three(Way { cells: [a, b, c], behind }),
            [a, b, c, d] => To::Four(Way { cells: [a, b, c, d], behind }),
            _ => return None,
        };
        Some(Straight { to, presences })
    }

    /// Adds the rows from a position on up to one that takes more than this; gives how many, and where that one starts. `None`
    /// when a column has become one of other numbers than integers of 64 bits.
    pub(super) fn read(&self, lane: &mut Lane, at: usize) -> Option<(usize, usize)> {
        let mut columns = std::mem::take(&mut lane.batch.columns);
        let read = match &self.to {
            To::One(way) => way.read(lane, at, &mut columns),
            To::Two(way) => way.read(lane, at, &mut columns),
            To::Three(way) => way.read(lane, at, &mut columns),
            To::Four(way) => way.read(lane, at, &mut columns),
        };
        if let Some((rows, _)) = read {
            let is_presence = |(column, _): &(usize, &mut Column)| self.presences.contains(column);
            for (_, presence) in columns.iter_mut().enumerate().filter(is_presence) {
                (0..rows).for_each(|_| presence.push_decimal(1, 0));
            }
        }
        lane.batch.columns = columns;
        read
    }
}

impl<const N: usize> Way<N> {
    /// Reads like [`Straight::read`].
    fn read(&self, lane: &Lane, start: usize, columns: &mut [Column]) -> Option<(usize, usize)> {
        let columns = columns.get_disjoint_mut(self.cells.map(|cell| cell.column)).ok()?;
        let columns = columns.into_iter().map(Column::as_narrow_mut);
        let columns: Vec<&mut Scaled<i64>> = columns.collect::<Option<_>>()?;
        let mut columns: [_; N] = columns.try_into().ok()?;
        let (mut rows, mut at) = (0, start);
        while let Some((numbers, next)) = self.row(lane, at) {
            if !Scaled::push_row(&mut columns, numbers) {
                break;
            }
            at = next;
            rows += 1;
        }
        Some((rows, at))
    }

    /// The numbers of the row that starts here, as mantissas and exponents, and the start of the next line.
    #[inline(always)]
    fn row(&self, lane: &Lane, start: usize) -> Option<([(i64, i32); N], usize)> {
        // A line that starts with white space may be blank.
        if lane.chunk.get(start).is_none_or(|&first| first <= b' ') {
            return None;
        }
        let mut numbers = [(0, 0); N];
        let mut at = start;
        for (cell, number) in self.cells.iter().zip(&mut numbers) {
            for _ in 0..cell.separators {
                at = lane.after_separator(at)?;
            }
            let Plain { mantissa, exponent, end } = lane.plain_number(at)?;
            if cell.non_negative && mantissa < 0 {
                return None;
            }
            *number = (mantissa, exponent);
            at = end;
        }
        Some((numbers, lane.end_of_row(at, self.behind)?))
    }
}
