//! Documents in Markdown.

use super::{Block, Facts, Inline, Table, Text};

/// The blocks in order.
pub(super) fn written(blocks: &[Block]) -> String {
    let blocks = blocks.iter().filter_map(|block| match block {
        Block::Title(title) => Some(title_of(title)),
        Block::Lead(text) | Block::Paragraph(text) => Some(format!("{}\n", line(text))),
        Block::Facts(Facts { rows, .. }) => facts(rows),
        Block::Results(rows) => Some(title_of(&super::RESULTS.into()) + "\n" + &facts(rows)?),
        Block::Table(table) => of_table(table),
        Block::LongTable(table) => of_table(&table.to_table()),
        Block::Space => None,
    });
    blocks.collect::<Vec<_>>().join("\n")
}

fn title_of(title: &Text) -> String {
    format!("### {}\n", line(title))
}

fn facts(rows: &[(Text, Text)]) -> Option<String> {
    let cells = rows.iter().map(|(label, fact)| vec![line(label), line(fact)]);
    table(&[String::new(), String::new()], cells)
}

fn of_table(Table { header, rows }: &Table) -> Option<String> {
    table(&cells(header), rows.iter().map(|row| cells(row)))
}

fn cells(row: &[Text]) -> Vec<String> {
    row.iter().map(line).collect()
}

/// Nothing without rows.
fn table(header: &[String], rows: impl Iterator<Item = Vec<String>>) -> Option<String> {
    let line = |cells: &[String]| {
        let cells: Vec<&str> = cells.iter().map(|cell| cell.trim_start()).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rows: String = rows.map(|row| line(&row)).collect();
    let rule = "---|".repeat(header.len());
    (!rows.is_empty()).then(|| format!("{}|{rule}\n{rows}", line(header)))
}

/// A text that Markdown shows as it is. Brackets of the report are those of intervals, which are no links; of the user's
/// words nobody knows.
fn line(text: &Text) -> String {
    let mut result = String::new();
    for inline in &text.0 {
        let is_given = matches!(inline, Inline::Given(_));
        for character in inline.to_string().chars() {
            match character {
                '\\' | '`' | '*' | '_' | '|' | '<' | '>' | '#' | '~' | '$' | '&' => {
                    result.extend(['\\', character]);
                }
                '[' | ']' if is_given => result.extend(['\\', character]),
                other => result.push(other),
            }
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::super::Symbol;
    use super::*;

    #[test]
    fn what_means_something_in_markdown_is_escaped() {
        let text = Text::new().mark("|").symbol(Symbol::Error).words("| <= ").given("a|b_c*[]\n");
        let facts = Facts { width: 5, rows: vec![("error".into(), text)] };
        assert_eq!(
            written(&[Block::Facts(facts), Block::Title("A_b".into())]),
            "|  |  |\n|---|---|\n| error | \\|e\\| \\<= a\\|b\\_c\\*\\[\\]\\\\n |\n\n### A\\_b\n"
        );
    }
}
