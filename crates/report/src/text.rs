//! Building blocks of the text reports.

use comfy_table::{Table, presets};

/// A borderless table, indented, without trailing white space; nothing without rows.
pub(crate) fn table(header: &[&str], rows: Vec<Vec<String>>) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header(header).add_rows(rows);
    let mut text = String::new();
    for line in table.to_string().lines() {
        text.push(' ');
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// Items joined by commas; only the first ones when there are many.
pub(crate) fn list(items: impl ExactSizeIterator<Item = String>) -> String {
    const MOST: usize = 8;
    let count = items.len();
    let mut shown: Vec<String> = items.take(MOST).collect();
    if count > MOST {
        shown.push(format!("and {} more", count - MOST));
    }
    shown.join(", ")
}

/// `1 vertex`, `2 vertices`.
pub(crate) fn counted(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}
