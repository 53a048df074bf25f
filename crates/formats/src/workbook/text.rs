//! Cells as lines of text.

use boundfit_exact::DecimalMark;

use super::archive::unreadable;
use crate::budget::HeldMemory;
use crate::error::InputErrorKind;
use crate::memory_use::MemoryUse;
use crate::notes::SheetLooks;

/// The separator of cells of a line.
pub(super) const DELIMITER: u8 = b'\t';

/// The most rows and columns that a sheet can have.
const MOST_ROWS: u32 = 1 << 20;
pub(super) const MOST_COLUMNS: u32 = 1 << 14;

/// The lines of a sheet, filled cell after cell, row after row.
pub(super) struct Lines {
    text: Vec<u8>,
    /// The end of each complete row, and its number of cells.
    rows: Vec<(usize, u32)>,
    /// The number of cells of the row that is being filled.
    width: u32,
    /// The decimal mark of stored numbers.
    pub(super) decimal: DecimalMark,
    /// The first and the last of each run of columns that are hidden, from 0.
    hidden_columns: Vec<[u32; 2]>,
    /// True if a text cell is a number with a decimal comma, and if one has a decimal point.
    has_marks: [bool; 2],
    /// True if a cell stores a number.
    has_numbers: bool,
    pub(super) hidden_rows: u64,
    pub(super) merged: u64,
    limit: u64,
    memory: HeldMemory,
}

impl Lines {
    /// No lines, with room for at most so many bytes, for which this memory is asked.
    pub(super) fn new(decimal: DecimalMark, limit: u64, memory: HeldMemory) -> Self {
        Lines {
            text: Vec::new(),
            rows: Vec::new(),
            width: 0,
            decimal,
            hidden_columns: Vec::new(),
            has_marks: [false; 2],
            has_numbers: false,
            hidden_rows: 0,
            merged: 0,
            limit,
            memory,
        }
    }

    /// Notices a cell that stores a number, and the decimal mark of a text that is a number whose comma groups no digits.
    pub(super) fn notice(&mut self, is_text: bool, text: &str) {
        if !is_text {
            self.has_numbers |= !text.is_empty();
            return;
        }
        let number = text.trim().trim_start_matches(['+', '-', '\u{2212}']);
        let Some((whole, rest)) = number.split_once([',', '.']) else { return };
        let fraction = rest.split(['e', 'E']).next().unwrap_or_default();
        let are_digits = whole.bytes().chain(fraction.bytes()).all(|byte| byte.is_ascii_digit());
        let is_group = fraction.len() == 3 && (1..=3).contains(&whole.len()) && !whole.starts_with('0');
        if are_digits && !fraction.is_empty() {
            let is_comma = number.as_bytes().get(whole.len()) == Some(&b',');
            let [comma, point] = &mut self.has_marks;
            *comma |= is_comma && !is_group;
            *point |= !is_comma;
        }
    }

    /// Returns whether stored numbers stand beside texts with decimal commas.
    pub(super) fn needs_commas(&self) -> bool {
        self.has_numbers && self.has_marks == [true, false]
    }

    /// Notices a run of columns that are hidden, by its first and its last one, from 0.
    pub(super) fn hide_columns(&mut self, first: u32, last: u32) {
        if self.hidden_columns.len() < MOST_COLUMNS as usize {
            self.hidden_columns.push([first, last]);
        }
    }

    /// The hidden rows and columns that were read, and the merged cells.
    pub(super) fn looks(&self) -> SheetLooks {
        let longest = self.rows.iter().map(|(_, width)| *width).chain([self.width]).max().unwrap_or_default();
        let in_rows =
            |[first, last]: &[u32; 2]| u64::from(longest.min(last.saturating_add(1)).saturating_sub(*first));
        SheetLooks {
            hidden_rows: self.hidden_rows,
            hidden_columns: self.hidden_columns.iter().map(in_rows).sum(),
            merged: self.merged,
        }
    }

    /// Returns the number of bytes in memory: the text, and the rows.
    fn bytes(&self) -> u64 {
        (self.text.len() + size_of_val(self.rows.as_slice())) as u64
    }

    /// Adds the text of a cell; rows and columns are counted from 0 and ascend.
    pub(super) fn push(&mut self, row: u32, column: u32, text: &str) -> Result<(), InputErrorKind> {
        if row >= MOST_ROWS || column >= MOST_COLUMNS {
            return Err(unreadable(format!("it has a cell in row {} and column {}", row + 1, column + 1)));
        }
        let is_earlier =
            (row as usize) < self.rows.len() || (row as usize == self.rows.len() && column < self.width);
        if is_earlier {
            return Err(unreadable(format!("the cells of row {} are not in their order", row + 1)));
        }
        // Before the rows and the tabs that lie between this cell and the one before it.
        let between = size_of::<(usize, u32)>() * (row as usize + 1 - self.rows.len()) + column as usize;
        self.ask(self.bytes() + (between + text.len()) as u64)?;
        while self.rows.len() < row as usize {
            self.end_row();
        }
        let tabs = column - self.width + u32::from(self.width > 0);
        // The first cell of a row that is not empty has as many tabs in front as there are columns before it.
        self.text.extend(std::iter::repeat_n(DELIMITER, tabs as usize));
        self.width = column + 1;
        self.add_cell(text);
        self.check()
    }

    fn end_row(&mut self) {
        self.rows.push((self.text.len(), self.width));
        self.width = 0;
    }

    /// A cell in quotes where it needs them. Line ends become spaces, so that a line is a row.
    fn add_cell(&mut self, text: &str) {
        // A text in quotes keeps the blanks around it.
        let is_plain = !text.contains(['\t', '"', '\n', '\r']) && text.trim_matches(' ') == text;
        if is_plain {
            self.text.extend_from_slice(text.as_bytes());
            return;
        }
        let quoted = text.replace('"', "\"\"").replace(['\n', '\r'], " ");
        self.text.push(b'"');
        self.text.extend_from_slice(quoted.as_bytes());
        self.text.push(b'"');
    }

    /// Asks for so many bytes in all, some at a time.
    fn ask(&self, bytes: u64) -> Result<(), InputErrorKind> {
        const PIECE: u64 = 1 << 16;
        self.memory.ask_for_all(bytes.next_multiple_of(PIECE), MemoryUse::Cells)
    }

    fn check(&self) -> Result<(), InputErrorKind> {
        let bytes = self.text.len() as u64;
        if bytes > self.limit { Err(InputErrorKind::WorkbookTooLarge { limit: self.limit }) } else { Ok(()) }
    }

    /// The text: every row with as many cells as the longest one has, an empty row as an empty line.
    /// The memory is what it takes.
    pub(super) fn finish(mut self) -> Result<(Vec<u8>, HeldMemory), InputErrorKind> {
        if self.width > 0 {
            self.end_row();
        }
        let longest = self.rows.iter().map(|(_, width)| *width).max().unwrap_or_default();
        let padding: u64 =
            self.rows.iter().map(|(_, width)| if *width > 0 { u64::from(longest - width) } else { 0 }).sum();
        if self.text.len() as u64 + padding > self.limit {
            return Err(InputErrorKind::WorkbookTooLarge { limit: self.limit });
        }
        let length = self.text.len() + padding as usize + self.rows.len();
        self.ask(self.bytes() + length as u64)?;
        let mut text = Vec::with_capacity(length);
        let mut start = 0;
        for (end, width) in self.rows {
            text.extend_from_slice(self.text.get(start..end).unwrap_or_default());
            if width > 0 {
                text.extend(std::iter::repeat_n(DELIMITER, (longest - width) as usize));
            }
            text.push(b'\n');
            start = end;
        }
        drop(self.text);
        self.memory.give_back();
        self.memory.ask(length as u64, MemoryUse::Cells)?;
        Ok((text, self.memory))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::budget::MemoryBudget;

    fn lines(cells: &[(u32, u32, &str)], limit: u64) -> Result<String, String> {
        let mut lines = Lines::new(DecimalMark::Point, limit, MemoryBudget::new(1 << 30).nothing());
        for (row, column, text) in cells {
            lines.push(*row, *column, text).map_err(|error| error.to_string())?;
        }
        lines.finish().map(|(text, _)| String::from_utf8(text).unwrap()).map_err(|error| error.to_string())
    }

    #[test]
    fn every_row_is_a_line_and_every_column_a_cell() {
        let cells = [(1, 1, "x"), (1, 3, "y"), (3, 0, "1"), (3, 2, "a\tb\n\"c\""), (4, 2, "2")];
        assert_eq!(lines(&cells, 100).unwrap(), "\n\tx\t\ty\n\n1\t\t\"a\tb \"\"c\"\"\"\t\n\t\t2\t\n");
        assert_eq!(lines(&[], 100).unwrap(), "");
    }

    #[test]
    fn what_is_out_of_order_or_out_of_bounds_is_refused() {
        let order = "cannot read a workbook: the cells of row 1 are not in their order";
        assert_eq!(lines(&[(0, 1, "a"), (0, 0, "b")], 100), Err(order.to_owned()));
        assert_eq!(lines(&[(0, 1, "a"), (0, 1, "b")], 100), Err(order.to_owned()));
        assert_eq!(lines(&[(1, 1, "a"), (0, 2, "b")], 100), Err(order.to_owned()));
        for (row, column) in [(1 << 20, 0), (0, 1 << 14), (u32::MAX - 1, u32::MAX - 1)] {
            assert!(lines(&[(row, column, "a")], 100).unwrap_err().contains("it has a cell in row"));
        }
        let limit = InputErrorKind::WorkbookTooLarge { limit: 10 }.to_string();
        assert_eq!(lines(&[(0, 12, "a")], 10), Err(limit.clone()));
        // Two rows of one cell each beside one of nine: eight tabs behind each of them.
        assert_eq!(lines(&[(0, 0, "a"), (1, 0, "b"), (2, 8, "")], 10), Err(limit));
    }
}
