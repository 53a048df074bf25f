//! Cells that are written as fractions. They are numbers, but people are told of them: a spreadsheet may have meant something else.

use boundfit_exact::{Foreign, is_missing};
use memchr::memchr;

/// The number of cells of a column that are fractions such as `3/4`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Fractions {
    /// The number of fractions.
    pub cells: usize,
    /// The first of them.
    pub first: Option<Foreign>,
}

impl Fractions {
    /// Counts a cell that has been read as a number, or may lack one.
    pub(crate) fn count(&mut self, cell: &[u8]) {
        // Some words for what is missing have a slash, too.
        if memchr(b'/', cell).is_some() && !std::str::from_utf8(cell).is_ok_and(is_missing) {
            self.cells += 1;
            self.first.get_or_insert_with(|| String::from_utf8_lossy(cell).trim().into());
        }
    }

    /// Adds those of later cells.
    pub(crate) fn append(&mut self, later: Fractions) {
        self.cells += later.cells;
        self.first = self.first.take().or(later.first);
    }
}
