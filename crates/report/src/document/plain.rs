//! Documents as plain text.

use super::{Block, Facts, Table, Text};
use crate::align::{widths, write_line};

/// The room for labels of results.
const RESULT_WIDTH: usize = 14;

/// The blocks in order: titles flush left after a blank line, all else indented below them.
pub(super) fn written(blocks: &[Block]) -> String {
    let mut text = String::new();
    for block in blocks {
        let opens = matches!(block, Block::Title(_) | Block::Lead(_) | Block::Results(_) | Block::Space);
        if opens && !text.is_empty() {
            text.push('\n');
        }
        match block {
            Block::Title(line) | Block::Lead(line) => text.push_str(&format!("{line}\n")),
            Block::Paragraph(line) => text.push_str(&format!("  {line}\n")),
            Block::Facts(Facts { width, rows }) => {
                for (label, fact) in rows {
                    text.push_str(&format!("  {:<width$}  {fact}\n", label.to_string()));
                }
            }
            Block::Results(lines) => {
                for (label, result) in lines {
                    text.push_str(&format!("{:<RESULT_WIDTH$} {result}\n", label.to_string()));
                }
            }
            Block::Table(table) => write_table(table, &mut text),
            Block::Space => {}
        }
    }
    text
}

fn write_table(Table { header, rows, .. }: &Table, text: &mut String) {
    if rows.is_empty() {
        return;
    }
    let cells = |row: &Vec<Text>| row.iter().map(Text::to_string).collect::<Vec<_>>();
    let lines: Vec<Vec<String>> = std::iter::once(header).chain(rows).map(cells).collect();
    let widths = widths(&lines);
    for line in &lines {
        text.push_str("  ");
        write_line(line, &widths, text);
    }
}
