//! Documents as plain text.

use std::borrow::Cow;
use std::io::{self, Write};

use super::wrap::{WIDTH, wrapped};
use super::{Block, Facts, LongTable, Table, Text};
use crate::align::{columns, widths, write_line};

/// The room for labels of results.
const RESULT_WIDTH: usize = 14;
/// The blanks before a line.
const INDENT: usize = 2;
/// The blanks between two columns.
const GAP: usize = 2;
/// The blanks before the cells of a row that has a line for each.
const PART: usize = 6;

/// The number of bytes that are written at once.
const WRITTEN_AT_ONCE: usize = 1 << 16;

/// Writes the blocks in order: titles flush left after a blank line, all else indented below them. A text that is longer
/// than a line goes on below its beginning.
pub(super) fn write(blocks: &[Block<'_>], out: &mut dyn Write) -> io::Result<()> {
    let (mut text, mut is_first) = (String::new(), true);
    for block in blocks {
        let opens = matches!(block, Block::Title(_) | Block::Lead(_) | Block::Results(_) | Block::Space);
        if opens && !is_first {
            text.push('\n');
        }
        match block {
            Block::Title(line) | Block::Lead(line) => write_behind("", 0, line, &mut text),
            Block::Paragraph(line) => write_behind("", INDENT, line, &mut text),
            Block::Facts(Facts { width, rows }) => {
                for (label, fact) in rows {
                    let label = format!("  {:<width$}  ", label.to_string());
                    write_behind(&label, columns(&label), fact, &mut text);
                }
            }
            Block::Results(lines) => {
                for (label, result) in lines {
                    let label = format!("{:<RESULT_WIDTH$} ", label.to_string());
                    write_behind(&label, columns(&label), result, &mut text);
                }
            }
            Block::Table(table) => write_table(table, &mut text),
            Block::LongTable(table) => write_long_table(table, &mut text, out)?,
            Block::Space => {}
        }
        is_first &= text.is_empty();
    }
    out.write_all(text.as_bytes())
}

/// A label and what stands behind it, which begins in this column and goes on there.
fn write_behind(label: &str, column: usize, what: &Text, text: &mut String) {
    for (number, line) in wrapped(&what.to_string(), WIDTH.saturating_sub(column)).iter().enumerate() {
        let before = if number == 0 { label } else { "" };
        let line = format!("{before}{:blanks$}{line}", "", blanks = column - columns(before).min(column));
        text.push_str(line.trim_end());
        text.push('\n');
    }
}

/// A table: as it is where that is not too wide, with lines of cells below each other where that helps, else with a line for
/// each cell.
fn write_table<'a>(Table { header, rows }: &'a Table, text: &mut String) {
    if rows.is_empty() {
        return;
    }
    let cells = |row: &'a Vec<Text>| row.iter().map(Text::plain).collect::<Vec<_>>();
    let rows: Vec<Vec<Cow<'a, str>>> = std::iter::once(header).chain(rows).map(cells).collect();
    let natural = widths(&rows);
    let limits = limits(&natural);
    // Where all cells are as narrow as they may be, each row is a line as it is: most tables, and all very long ones.
    let broken = (natural != limits)
        .then(|| rows.iter().flat_map(|row| lines_of(row, &limits)).collect::<Vec<Vec<Cow<'_, str>>>>());
    let widths = broken.as_ref().map_or(natural, |lines| widths(lines));
    if widths.iter().sum::<usize>() + INDENT + GAP * (widths.len() - 1) <= WIDTH {
        for line in broken.as_ref().unwrap_or(&rows) {
            text.push_str("  ");
            write_line(line.iter(), &widths, text);
        }
        return;
    }
    let [header, rows @ ..] = rows.as_slice() else { return };
    for row in rows {
        for (column, (name, cell)) in
            header.iter().zip(row).enumerate().filter(|(_, (_, cell))| !cell.is_empty())
        {
            let label = if name.is_empty() { String::new() } else { format!("{name}  ") };
            let before = if column == 0 { INDENT } else { PART };
            write_behind("", before, &Text::from(format!("{label}{}", cell.trim_start())), text);
        }
    }
}

/// A table of any length: without a list of its lines where each is a line as it is. Lines that fill a part are written.
fn write_long_table(table: &LongTable<'_>, text: &mut String, out: &mut dyn Write) -> io::Result<()> {
    let (mut natural, mut is_empty) = (table.header().map(|cell| columns(&cell)).collect::<Vec<_>>(), true);
    table.each(&mut |row| {
        is_empty = false;
        for (width, cell) in natural.iter_mut().zip(row.plain()) {
            *width = columns(&cell).max(*width);
        }
        Ok(())
    })?;
    if is_empty {
        return Ok(());
    }
    if natural != limits(&natural) {
        write_table(&table.to_table(), text);
        return Ok(());
    }
    text.push_str("  ");
    write_line(table.header(), &natural, text);
    table.each(&mut |row| {
        if text.len() > WRITTEN_AT_ONCE {
            out.write_all(text.as_bytes())?;
            text.clear();
        }
        text.push_str("  ");
        write_line(row.plain(), &natural, text);
        Ok(())
    })
}

/// Returns the width limit of each column: narrow columns as they are, the others alike.
fn limits(natural: &[usize]) -> Vec<usize> {
    let mut room = WIDTH - INDENT - GAP * (natural.len() - 1).min(WIDTH / (2 * GAP));
    let mut sorted = natural.to_vec();
    sorted.sort_unstable();
    for (narrower, width) in sorted.iter().enumerate() {
        let share = room / (natural.len() - narrower);
        if *width > share {
            return natural.iter().map(|width| (*width).min(share)).collect();
        }
        room -= width;
    }
    natural.to_vec()
}

/// A row as lines of cells.
fn lines_of(row: &[Cow<'_, str>], limits: &[usize]) -> Vec<Vec<Cow<'static, str>>> {
    let mut cells: Vec<_> = row.iter().zip(limits).map(|(cell, limit)| wrapped(cell, *limit)).collect();
    let height = cells.iter().map(Vec::len).max().unwrap_or(0);
    let line = |number: usize| {
        let cells = cells.iter_mut().map(|lines| lines.get_mut(number).map(std::mem::take));
        cells.map(|line| Cow::Owned(line.unwrap_or_default())).collect()
    };
    (0..height).map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Document;
    use super::*;

    fn text(block: Block<'_>) -> String {
        Document(vec![block]).to_text()
    }

    fn table(cells: &[&str]) -> String {
        let row = |cells: &[&str]| cells.iter().map(|cell| Text::from(*cell)).collect::<Vec<_>>();
        let header = row(&["", "a", "b"]);
        text(Block::Table(Table { header, rows: vec![row(cells)] }))
    }

    #[test]
    fn cells_are_broken_and_rows_taken_apart_to_fit() {
        assert_eq!(table(&["x", "1", "2"]), "     a  b\n  x  1  2\n");
        let (word, words) = ("seven77 ".repeat(3), "seven77 ".repeat(6));
        let expected = format!(
            "     a                        b\n  x  {0}  {1}\n  {2:28}seven77 seven77 seven77 seven77 seven77 seven77\n",
            word.trim_end(),
            words.trim_end(),
            ""
        );
        let twice = words.repeat(2);
        assert_eq!(table(&["x", word.trim_end(), twice.trim_end()]), expected);
        let long = "1".repeat(50);
        assert_eq!(table(&["x", &long, &long]), format!("  x\n      a  {long}\n      b  {long}\n"));
    }

    #[test]
    fn long_facts_go_on_below_themselves() {
        let facts = Facts { width: 3, rows: vec![("abc".into(), "word ".repeat(20).trim_end().into())] };
        let expected = format!("  abc  {}\n       {}\n", ["word"; 14].join(" "), ["word"; 6].join(" "));
        assert_eq!(text(Block::Facts(facts)), expected);
    }
}
