//! Reports in LaTeX: a fragment to be read into a document that uses the package `booktabs`.

mod notation;

use crate::document::{Block, Text};
use notation::{escaped, formulas};

/// The blocks in order.
pub(crate) fn latex(blocks: &[Block]) -> String {
    let blocks = blocks.iter().filter(|block| !block.is_blank()).map(|block| match block {
        Block::Title(title) => format!("\\paragraph{{{}}}\n", formulas(title)),
        Block::Paragraph(text) => format!("{}\n", written(text)),
        Block::Facts(facts) => {
            let rows: Vec<Vec<String>> =
                facts.iter().map(|(label, text)| vec![formulas(label), written(text)]).collect();
            // Sentences, which need lines of some width.
            tabular("lp{0.75\\linewidth}", None, &rows)
        }
        Block::Table(header, rows) => {
            let header: Vec<String> = header.iter().map(|cell| formulas(cell)).collect();
            let rows: Vec<Vec<String>> =
                rows.iter().map(|row| row.iter().map(|cell| cell_of(cell)).collect()).collect();
            tabular(&"l".repeat(header.len()), Some(&header), &rows)
        }
    });
    let blocks: Vec<String> = blocks.collect();
    format!("% needs \\usepackage{{booktabs}}\n{}", blocks.join("\n"))
}

fn tabular(columns: &str, header: Option<&[String]>, rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| format!("{} \\\\\n", cells.join(" & "));
    let header = header.map(|cells| line(cells) + "\\midrule\n").unwrap_or_default();
    let rows: String = rows.iter().map(|row| line(row)).collect();
    format!(
        "\\begin{{center}}\n\\begin{{tabular}}{{{columns}}}\n\\toprule\n{header}{rows}\\bottomrule\n\
         \\end{{tabular}}\n\\end{{center}}\n"
    )
}

/// A cell; one that is set off by spaces belongs to what is above.
fn cell_of(text: &str) -> String {
    let indent = if text.starts_with(' ') { "\\quad " } else { "" };
    format!("{indent}{}", formulas(text.trim_start()))
}

fn written(text: &Text) -> String {
    text.written(formulas, escaped)
}
