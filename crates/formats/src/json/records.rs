//! Records that were read together.

use std::ops::Range;

/// Cells of records by the number of their column, from 0, as they come. All texts are in one buffer: memory for each would take longer
/// than reading it.
#[derive(Default)]
pub(super) struct Records {
    /// UTF-8.
    text: Vec<u8>,
    cells: Vec<Cell>,
    /// The line on which each record begins.
    lines: Vec<u64>,
    /// The end of each record's cells.
    ends: Vec<usize>,
}

/// A cell, whose text begins where that of the cell before ends.
struct Cell {
    column: usize,
    end: usize,
}

impl Records {
    /// Adds a cell, in UTF-8, to the record that is being read.
    #[inline]
    pub(super) fn push(&mut self, column: usize, text: &[u8]) {
        self.text.extend_from_slice(text);
        self.cells.push(Cell { column, end: self.text.len() });
    }

    /// The number of cells of the record that is being read.
    pub(super) fn open_cells(&self) -> usize {
        self.cells.len() - self.closed_cells()
    }

    /// Ends the record that is being read, which begins on this line.
    pub(super) fn close(&mut self, line: u64) {
        self.lines.push(line);
        self.ends.push(self.cells.len());
    }

    /// Drops the cells of the record that is being read.
    pub(super) fn drop_open(&mut self) {
        self.cells.truncate(self.closed_cells());
        self.text.truncate(self.cells.last().map_or(0, |cell| cell.end));
    }

    /// The lines on which the records begin.
    pub(super) fn lines(&self) -> &[u64] {
        &self.lines
    }

    /// The text of each cell of the record that is being read.
    pub(super) fn open(&self) -> impl Iterator<Item = &str> {
        let cells = self.cells_in(self.closed_cells(), self.cells.len());
        cells.map(|(_, text)| {
            self.text.get(text).and_then(|text| std::str::from_utf8(text).ok()).unwrap_or_default()
        })
    }

    /// The number of bytes of the texts of the record that is being read.
    pub(super) fn open_bytes(&self) -> usize {
        self.text.len() - self.start_of(self.closed_cells())
    }

    /// The column and the text of each cell of each record.
    pub(super) fn iter(&self) -> impl Iterator<Item = impl Iterator<Item = (usize, &str)>> {
        // At once: many short texts take longer.
        let all = std::str::from_utf8(&self.text).unwrap_or_default();
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(move |(start, &end)| {
            self.cells_in(start, end).map(move |(column, text)| (column, all.get(text).unwrap_or_default()))
        })
    }

    /// The column of each of some cells, and where its text is.
    fn cells_in(&self, start: usize, end: usize) -> impl Iterator<Item = (usize, Range<usize>)> {
        let mut from = self.start_of(start);
        self.cells.get(start..end).unwrap_or_default().iter().map(move |cell| {
            let text = from..cell.end;
            from = cell.end;
            (cell.column, text)
        })
    }

    /// The place where the text of a cell begins.
    fn start_of(&self, cell: usize) -> usize {
        cell.checked_sub(1).and_then(|before| self.cells.get(before)).map_or(0, |before| before.end)
    }

    fn closed_cells(&self) -> usize {
        self.ends.last().copied().unwrap_or_default()
    }
}
