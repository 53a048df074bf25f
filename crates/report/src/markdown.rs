//! Reports in Markdown, as GitHub and Pandoc read it.

use crate::document::{Block, Text};

/// The blocks in order.
pub(crate) fn markdown(blocks: &[Block]) -> String {
    let blocks = blocks.iter().filter(|block| !block.is_blank()).map(|block| match block {
        Block::Title(title) => format!("### {}\n", escaped(title)),
        Block::Paragraph(text) => format!("{}\n", written(text)),
        Block::Facts(facts) => {
            let rows: Vec<Vec<String>> =
                facts.iter().map(|(label, text)| vec![escaped(label), written(text)]).collect();
            table(&[String::new(), String::new()], &rows)
        }
        Block::Table(header, rows) => {
            let rows: Vec<Vec<String>> =
                rows.iter().map(|row| row.iter().map(|cell| escaped(cell)).collect()).collect();
            table(&header.iter().map(|cell| escaped(cell)).collect::<Vec<_>>(), &rows)
        }
    });
    blocks.collect::<Vec<_>>().join("\n")
}

fn table(header: &[String], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| {
        let cells: Vec<&str> = cells.iter().map(|cell| cell.trim_start()).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rule = format!("|{}\n", "---|".repeat(header.len()));
    line(header) + &rule + &rows.iter().map(|row| line(row)).collect::<String>()
}

fn written(text: &Text) -> String {
    text.written(escaped, |given| escaped(given).replace('[', "\\[").replace(']', "\\]"))
}

/// A text of a report that Markdown shows as it is. Brackets are those of intervals, which are no links.
fn escaped(text: &str) -> String {
    let mut result = String::new();
    for character in text.chars() {
        match character {
            '\\' | '`' | '*' | '_' | '|' | '<' | '>' | '#' | '~' | '$' | '&' => {
                result.push('\\');
                result.push(character);
            }
            control if control.is_control() => result.push(' '),
            other => result.push(other),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_means_something_in_markdown_is_escaped() {
        let text = Text::own("|e| <= ").then(Text::given("a|b_c*\n"));
        assert_eq!(
            markdown(&[Block::Facts(vec![("error".to_owned(), text)]), Block::Title("A_b".to_owned())]),
            "|  |  |\n|---|---|\n| error | \\|e\\| \\<= a\\|b\\_c\\*  |\n\n### A\\_b\n"
        );
    }
}
