//! The columns of a table that nothing is known of yet.

use std::io::Cursor;

use boundfit::engine::exact::Foreign;
use boundfit::engine::formats::read_table;
use boundfit::files::{ColumnSelector, InputErrorKind, Source, TableOptions};
use serde::Serialize;

use crate::options::TableWords;

/// What no header has: a column is found missing when the names of all others are known.
const NOBODY: &str = "\u{1}";

/// The columns of a table, as JSON.
#[derive(Debug, Serialize)]
struct ColumnsJson {
    /// Their names, `col1` and so on where there are none.
    columns: Vec<String>,
    /// Whether the first row names them.
    header: bool,
}

/// The names of the columns, in whatever form the table is written, or what is wrong.
pub(crate) fn columns(table: Vec<u8>, options: &str) -> Result<String, String> {
    let words = TableWords::parse(options)?;
    let source = Source::new(words.file(), Cursor::new(table));
    let options = TableOptions { dialect: words.dialect()?, ..TableOptions::default() };
    let names = match read_table(source, &[ColumnSelector::name(NOBODY)], &options) {
        Ok(_) => return Err("the table has a column without a name that could be shown".to_owned()),
        Err(error) => match error.kind {
            InputErrorKind::UnknownColumn { available, .. } => available,
            InputErrorKind::NoDelimiter { line, .. } => vec![line],
            _ => return Err(error.to_string()),
        },
    };
    let header = names.iter().any(|name| is_name(name.raw()));
    let shown = |(number, name): (usize, &Foreign)| match header && !name.is_empty() {
        true => name.raw().to_owned(),
        false => format!("col{number}"),
    };
    let found = ColumnsJson { columns: (1..).zip(&names).map(shown).collect(), header };
    serde_json::to_string(&found).map_err(|error| error.to_string())
}

/// Whether a cell of the first row names a column, and is no number, nor what stands for one.
fn is_name(cell: &str) -> bool {
    let is_number = cell.starts_with(|first: char| first.is_ascii_digit() || "+-−.,".contains(first));
    !cell.is_empty() && !is_number && !["nan", "na", "n/a", "inf"].contains(&cell.to_lowercase().as_str())
}
