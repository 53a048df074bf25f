//! Tables of any length: a million rows take no memory, since each is made when it is written.

use std::borrow::Cow;
use std::fmt::{self, Display, Write as _};
use std::io;

use super::inline::plain_words;
use super::{Table, Text};

/// A table whose columns hold numbers or words alone.
pub(crate) struct LongTable<'a> {
    header: Vec<Text>,
    kinds: Vec<Column>,
    rows: Box<MakeRows<'a>>,
}

/// A function that makes the rows, in order, and hands each on.
type MakeRows<'a> = dyn Fn(&mut Rows<'_>) -> io::Result<()> + 'a;

/// The kind of the cells of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Column {
    Number,
    Words,
}

/// The place where rows go as they are made.
pub(crate) struct Rows<'a> {
    /// The cells of the row that is being made.
    row: Row<'a>,
    next: &'a mut dyn FnMut(&Row<'_>) -> io::Result<()>,
}

/// The cells of a row.
pub(super) struct Row<'a> {
    kinds: &'a [Column],
    cells: String,
    /// The end of each cell.
    ends: Vec<usize>,
}

impl fmt::Debug for LongTable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LongTable").field("header", &self.header).finish_non_exhaustive()
    }
}

impl<'a> LongTable<'a> {
    /// A table with these columns. Its rows are made whenever it is written, and once before for the widths of its columns in plain
    /// text.
    pub(crate) fn new(
        columns: impl IntoIterator<Item = (Text, Column)>,
        rows: impl Fn(&mut Rows<'_>) -> io::Result<()> + 'a,
    ) -> Self {
        let (header, kinds) = columns.into_iter().unzip();
        LongTable { header, kinds, rows: Box::new(rows) }
    }

    /// The table with a text for each cell.
    pub(super) fn to_table(&self) -> Table {
        let text = |(kind, cell): (Column, &str)| match kind {
            Column::Number => Text::new().number(cell),
            Column::Words => Text::from(cell),
        };
        let mut rows = Vec::new();
        let made = self.each(&mut |row| {
            rows.push(row.cells().map(text).collect());
            Ok(())
        });
        debug_assert!(made.is_ok());
        Table { header: self.header.clone(), rows }
    }

    pub(super) fn header(&self) -> impl Iterator<Item = Cow<'_, str>> {
        self.header.iter().map(Text::plain)
    }

    /// Makes each row for a function.
    pub(super) fn each(&self, next: &mut dyn FnMut(&Row<'_>) -> io::Result<()>) -> io::Result<()> {
        let row = Row { kinds: &self.kinds, cells: String::new(), ends: Vec::new() };
        (self.rows)(&mut Rows { row, next })
    }
}

impl Rows<'_> {
    /// Adds the next cell of a row.
    pub(crate) fn push(&mut self, cell: impl Display) {
        self.push_by(|text| write!(text, "{cell}"));
    }

    /// Adds the next cell, which a function writes without a formatter.
    pub(crate) fn push_by(&mut self, write: impl FnOnce(&mut String) -> fmt::Result) {
        let Row { cells, ends, .. } = &mut self.row;
        // Writing to a string never fails.
        let _ = write(cells);
        ends.push(cells.len());
    }

    /// Ends a row.
    pub(crate) fn end(&mut self) -> io::Result<()> {
        (self.next)(&self.row)?;
        self.row.cells.clear();
        self.row.ends.clear();
        Ok(())
    }
}

impl Row<'_> {
    fn cells(&self) -> impl Iterator<Item = (Column, &str)> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        let cells =
            starts.zip(&self.ends).map(|(start, &end)| self.cells.get(start..end).unwrap_or_default());
        self.kinds.iter().copied().zip(cells)
    }

    /// The cells as plain text.
    pub(super) fn plain(&self) -> impl Iterator<Item = Cow<'_, str>> {
        self.cells().map(|(kind, cell)| match kind {
            Column::Number => Cow::Borrowed(cell),
            Column::Words => plain_words(cell),
        })
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::super::{Block, Document};
    use super::*;

    #[test]
    fn a_long_table_looks_like_any_other() {
        for (rows, wide) in [(0, ""), (1, ""), (3, "2 up\u{7}per, "), (2, &"a word and another, ".repeat(9))]
        {
            let columns = [("no.".into(), Column::Number), ("active".into(), Column::Words)];
            let words = |row: usize| if row == 1 { String::new() } else { format!("{wide}{row}_lower") };
            let long = LongTable::new(columns, |table| {
                (0..rows).try_for_each(|row| {
                    table.push(format_args!("-{row}.5e300"));
                    table.push(words(row));
                    table.end()
                })
            });
            let row = |row| vec![Text::new().number(format!("-{row}.5e300")), words(row).into()];
            let header = vec!["no.".into(), "active".into()];
            let table = Table { header, rows: (0..rows).map(row).collect() };
            let [long, table] = [Block::LongTable(long), Block::Table(table)].map(|own| Document(vec![own]));
            assert_eq!(long.to_text(), table.to_text());
            assert_eq!(long.to_latex(), table.to_latex());
            assert_eq!(long.to_markdown(), table.to_markdown());
        }
    }

    /// Refuses to be written to after some parts.
    struct Parts {
        sizes: Vec<usize>,
        most: usize,
    }

    impl io::Write for Parts {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if self.sizes.len() == self.most {
                return Err(io::ErrorKind::BrokenPipe.into());
            }
            self.sizes.push(bytes.len());
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn rows_are_written_as_they_are_made_and_no_more_of_them_after_an_error() {
        const ROWS: usize = 20_000;
        let made = Cell::new(0);
        let columns = [("no.".into(), Column::Number), ("active".into(), Column::Words)];
        let table = LongTable::new(columns, |table| {
            (0..ROWS).try_for_each(|row| {
                made.set(made.get() + 1);
                table.push(row);
                table.push("1_lower, 2_upper");
                table.end()
            })
        });
        let document = Document(vec![Block::Title("title".into()), Block::LongTable(table)]);
        let mut parts = Parts { sizes: Vec::new(), most: usize::MAX };
        document.write_text(&mut parts).unwrap();
        assert_eq!(parts.sizes.iter().sum::<usize>(), document.to_text().len());
        let largest = parts.sizes.iter().max().copied().unwrap_or_default();
        assert!(parts.sizes.len() > 5 && largest < 70_000, "{:?}", parts.sizes);
        made.set(0);
        let mut parts = Parts { sizes: Vec::new(), most: 1 };
        assert_eq!(document.write_text(&mut parts).unwrap_err().kind(), io::ErrorKind::BrokenPipe);
        // All rows have widths; two parts hold less than half of them.
        assert!(made.get() < ROWS + ROWS / 2, "{}", made.get());
    }
}
