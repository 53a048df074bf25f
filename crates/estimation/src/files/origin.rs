//! The origin of readings that were read from a table.

use boundfit_exact::Foreign;
use boundfit_formats::{Fractions, RowNumbers, RowRange, TableNotes, TableOptions, TextLayout};

use crate::measurements::{Measurements, Readings};
use crate::selection::{FractionCells, Selection};

impl Selection {
    /// The rows that these options ask for.
    pub fn of(options: &TableOptions) -> Self {
        let ranges = |ranges: &[RowRange]| {
            let ranges: Vec<String> = ranges.iter().map(RowRange::to_string).collect();
            (!ranges.is_empty()).then(|| ranges.join(","))
        };
        Selection {
            rows: ranges(options.rows.named()),
            without: ranges(options.rows.without()),
            conditions: options.conditions.iter().map(|condition| condition.text().clone()).collect(),
        }
    }
}

impl FractionCells {
    /// Returns the fractions of columns with these names; a column that is read in several ways appears once.
    pub fn of(names: &[Foreign], fractions: &[Fractions]) -> Vec<Self> {
        let mut found: Vec<FractionCells> = Vec::new();
        for (column, Fractions { cells, first }) in names.iter().zip(fractions) {
            if let Some(first) = first
                && !found.iter().any(|other| other.column == *column)
            {
                found.push(FractionCells { column: column.clone(), cells: *cells, first: first.clone() });
            }
        }
        found
    }
}

impl Measurements {
    /// Numbers the readings of a table by these numbers, in its order, instead of by 1, 2, 3 and so on, and records
    /// the selection that was asked for. `None` unless there are as many numbers as rows, and every reading is in
    /// memory.
    #[must_use]
    pub fn numbered(mut self, numbers: &RowNumbers, asked: Selection) -> Option<Self> {
        let Readings::All(rows) = &mut self.readings else { return None };
        if numbers.len() != self.origin.rows_total {
            return None;
        }
        for row in rows.iter_mut().chain(&mut self.others) {
            row.row = numbers.get(row.row - 1);
        }
        let cells = std::mem::take(&mut self.origin.cells);
        self.origin.cells = cells.into_iter().map(|(row, cells)| (numbers.get(row - 1), cells)).collect();
        self.origin.selection = asked;
        Some(self)
    }

    /// Returns what the table was taken for; `None` unless the readings come from text or a sheet.
    pub fn table(&self) -> Option<&TableNotes> {
        self.origin.table.as_ref()
    }

    /// Returns where in the file the numbers stand: regressors, response and, if each row has one, the error bound.
    /// Returns `None` unless the readings come from delimited text that has a row for each of them.
    pub fn layout(&self) -> Option<&TextLayout> {
        self.origin.layout.as_ref()
    }
}
