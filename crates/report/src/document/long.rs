//! Tables of any length: the cells of a million vertices take the memory of their characters.

use std::borrow::Cow;
use std::fmt::{Display, Write as _};

use super::inline::plain_words;
use super::{Table, Text};

/// A table whose columns hold numbers or words alone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct LongTable {
    header: Vec<Text>,
    kinds: Vec<Column>,
    /// All cells, row by row.
    cells: String,
    /// The end of each cell.
    ends: Vec<usize>,
}

/// The kind of the cells of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Column {
    Number,
    Words,
}

impl LongTable {
    /// A table with these columns, and no row yet.
    pub(crate) fn new(columns: impl IntoIterator<Item = (Text, Column)>) -> Self {
        let (header, kinds) = columns.into_iter().unzip();
        LongTable { header, kinds, cells: String::new(), ends: Vec::new() }
    }

    /// Adds the next cell of a row.
    pub(crate) fn push(&mut self, cell: impl Display) {
        // Writing to a string never fails.
        let _ = write!(self.cells, "{cell}");
        self.ends.push(self.cells.len());
    }

    /// The table with a text for each cell.
    pub(super) fn to_table(&self) -> Table {
        let text = |(kind, cell): (Column, &str)| match kind {
            Column::Number => Text::new().number(cell),
            Column::Words => Text::from(cell),
        };
        let rows = self.rows().map(|row| row.map(text).collect()).collect();
        Table { header: self.header.clone(), rows }
    }

    /// The lines of cells as plain text, the header first, unless there is no row.
    pub(super) fn plain(&self) -> impl Iterator<Item = Vec<Cow<'_, str>>> {
        let cell = |(kind, cell)| match kind {
            Column::Number => Cow::Borrowed(cell),
            Column::Words => plain_words(cell),
        };
        let header = (!self.ends.is_empty()).then(|| self.header.iter().map(Text::plain).collect());
        header.into_iter().chain(self.rows().map(move |row| row.map(cell).collect()))
    }

    fn rows(&self) -> impl Iterator<Item = impl Iterator<Item = (Column, &str)>> {
        let columns = self.kinds.len().max(1);
        self.ends.chunks(columns).enumerate().map(move |(row, ends)| {
            let before = (row * columns).checked_sub(1).and_then(|last| self.ends.get(last));
            let starts = [before.copied().unwrap_or_default()].into_iter().chain(ends.iter().copied());
            let cells = starts.zip(ends).map(|(start, &end)| self.cells.get(start..end).unwrap_or_default());
            self.kinds.iter().copied().zip(cells)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Block, Document};
    use super::*;

    #[test]
    fn a_long_table_looks_like_any_other() {
        for (rows, wide) in [(0, ""), (1, ""), (3, "2 up\u{7}per, "), (2, &"a word and another, ".repeat(9))]
        {
            let columns = [("no.".into(), Column::Number), ("active".into(), Column::Words)];
            let mut long = LongTable::new(columns);
            let mut table = Table { header: vec!["no.".into(), "active".into()], rows: Vec::new() };
            for row in 0..rows {
                let words = if row == 1 { String::new() } else { format!("{wide}{row}_lower") };
                long.push(format_args!("-{row}.5e300"));
                long.push(&words);
                table.rows.push(vec![Text::new().number(format!("-{row}.5e300")), words.into()]);
            }
            let [long, table] = [Block::LongTable(long), Block::Table(table)].map(|own| Document(vec![own]));
            assert_eq!(long.to_text(), table.to_text());
            assert_eq!(long.to_latex(), table.to_latex());
            assert_eq!(long.to_markdown(), table.to_markdown());
        }
    }
}
