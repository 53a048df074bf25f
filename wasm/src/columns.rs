//! The columns of a table that nothing is known of yet.

use std::io::Cursor;

use boundfit::Reading;
use boundfit::engine::exact::{DecimalMark, Limits, Notation, Thousands};
use boundfit::engine::formats::{Batch, ScanOptions, Scanned, TableNotes, read_table, scan};
use boundfit::files::{ColumnSelector, InputErrorKind, Missing, Source, TableOptions};
use boundfit::report::TableJson;
use serde::Serialize;

use crate::options::TableAlone;
use crate::refusal::Refusal;

/// A name that no header has: a column is found missing when the names of all others are known.
const NOBODY: &str = "\u{1}";
/// The number of columns above which the numeric ones are not told: each is looked for on its own.
const MOST_TOLD: usize = 30;

/// The columns of a table, as JSON.
#[derive(Debug, Serialize)]
struct ColumnsJson {
    /// The names of the columns, `col1` and so on where there are none.
    columns: Vec<String>,
    /// `true` if the first row names the columns.
    header: bool,
    /// The columns that have a number, where they were looked for.
    numeric: Option<Vec<bool>>,
    /// The detected format of the table, as reports have it.
    table: Option<TableJson>,
}

/// The names of the columns, in whatever form the table is written, or what is wrong.
pub(crate) fn columns(table: Vec<u8>, options: &str) -> Result<String, Refusal> {
    let words = TableAlone::parse(options)?;
    let source = || Source::new(words.file(), Cursor::new(table.clone()));
    let asked = TableOptions { missing: Missing::Skip, ..words.options()? };
    let (cells, count) = match read_table(source(), &[ColumnSelector::name(NOBODY)], &asked) {
        Ok(_) => return Err("the table has a column without a name that could be shown".to_owned().into()),
        Err(error) => match error.kind {
            InputErrorKind::UnknownColumn { available, numbers, .. } => {
                let count = available.len().max(numbers.unwrap_or_default());
                (available, count)
            }
            InputErrorKind::NoDelimiter { line, .. } => (vec![line], 1),
            _ => return Err(error.into()),
        },
    };
    let asked = ScanOptions {
        table: asked,
        allow_nothing: true,
        hash: false,
        list_rows: false,
        ..ScanOptions::default()
    };
    let told = count <= MOST_TOLD;
    let read = |number: usize| {
        let column = ColumnSelector::name_or_number(&number.to_string());
        let mut rows = 0;
        let found = scan(source(), &[column], &asked, |batch| batch.rows.len(), |more| rows += more);
        found.ok().filter(|_| rows > 0)
    };
    let has_numbers = |number: usize| {
        let key = Some(ColumnSelector::name_or_number(&number.to_string()));
        let has_one =
            |batch: Batch| batch.keys.is_some_and(|keys| (0..keys.len()).any(|row| is_number(keys.get(row))));
        let mut some = false;
        let read = scan(source(), &[], &ScanOptions { key, ..asked.clone() }, has_one, |more| some |= more);
        // A column that cannot be read may have one.
        read.is_err() || some
    };
    let found: Vec<Option<Scanned>> = if told { (1..=count).map(read).collect() } else { Vec::new() };
    let notes: Vec<_> = found.iter().flatten().filter_map(|scanned| scanned.table.as_ref()).collect();
    // A column of whole numbers tells no decimal mark.
    let is_comma = |own: &&&TableNotes| own.dialect.notation.decimal == DecimalMark::Comma;
    let notes = notes.iter().find(is_comma).or(notes.first());
    let has_names = cells.iter().any(|name| is_name(name.raw()));
    // Records of JSON have names in no line of their own.
    let is_named = |notes: &TableNotes| notes.header.line.is_some() || notes.is_records && has_names;
    let header = notes.map_or(has_names, |notes| is_named(notes));
    let shown = |number: usize| match cells.get(number - 1).filter(|name| header && !name.is_empty()) {
        Some(name) => name.raw().to_owned(),
        None => format!("col{number}"),
    };
    let found = ColumnsJson {
        columns: (1..=count).map(shown).collect(),
        header,
        numeric: told.then(|| {
            (1..).zip(&found).map(|(number, scanned)| scanned.is_some() || has_numbers(number)).collect()
        }),
        table: notes.copied().map(TableJson::new),
    };
    serde_json::to_string(&found).map_err(|error| error.to_string().into())
}

/// Returns whether a cell is a number, with either mark and digits in groups or not.
fn is_number(cell: &str) -> bool {
    let groups = || Thousands::ALL.into_iter().map(Some).chain([None]);
    let mut notations = DecimalMark::ALL
        .into_iter()
        .flat_map(|decimal| groups().map(move |thousands| Notation { decimal, thousands }));
    notations.any(|notation| Reading::Decimal.read_written(cell, notation, &Limits::default()).is_ok())
}

/// Returns whether a cell of the first row names a column, and is neither a number nor a word for a missing one.
fn is_name(cell: &str) -> bool {
    let is_number = cell.starts_with(|first: char| first.is_ascii_digit() || "+-−.,".contains(first));
    !cell.is_empty() && !is_number && !["nan", "na", "n/a", "inf"].contains(&cell.to_lowercase().as_str())
}
