//! Batches under construction.

use boundfit_exact::Column;

use super::batch::Batch;
use super::keys::RowKeys;
use super::pieces::Pieces;
use crate::fractions::Fractions;
use crate::selection::RowNumbers;

impl Batch {
    /// A batch without rows, to be filled.
    pub(super) fn new(columns: usize, keys: bool, lines: bool) -> Self {
        Batch {
            columns: vec![Column::default(); columns],
            fractions: vec![Fractions::default(); columns],
            keys: keys.then(RowKeys::default),
            keys_missing: Vec::new(),
            lines: lines.then(Pieces::default),
            rows: RowNumbers::default(),
            cells: Vec::new(),
            others: Vec::new(),
        }
    }

    /// Makes room for the numbers of so many more rows.
    pub(super) fn reserve(&mut self, rows: usize) {
        self.columns.iter_mut().for_each(|column| column.reserve(rows));
    }

    /// Keeps the key of a row that is left out, unless the one before it has the same.
    pub(super) fn leave_out(&mut self, key: &str) {
        if self.keys_missing.last().is_none_or(|last| last != key) {
            self.keys_missing.push(key.to_owned());
        }
    }

    /// Completes a row, of which the numbers and the key have been added.
    #[inline]
    pub(super) fn end_row(&mut self, row: usize, line: Option<&[u8]>) {
        if let (Some(lines), Some(line)) = (&mut self.lines, line) {
            lines.push(line);
        }
        self.rows.push(row);
    }

    /// Completes so many rows from this one on, of which the numbers have been added, when nothing else is kept of rows.
    pub(super) fn end_rows(&mut self, first: usize, rows: usize) {
        self.rows.push_all(first..first + rows);
    }

    /// The batch, when it has rows, with so much added to their numbers.
    pub(super) fn finish(mut self, shift: usize) -> Option<Self> {
        self.others.iter_mut().for_each(|other| other.row += shift);
        self.rows.shift(shift);
        let is_empty = self.rows.is_empty() && self.others.is_empty() && self.keys_missing.is_empty();
        (!is_empty).then_some(self)
    }
}
