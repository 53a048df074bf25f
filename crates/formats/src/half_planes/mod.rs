//! Half-planes from a file: an H- or V-representation of cdd and lrs, or a table with columns a1, a2, b.

pub(crate) mod file;

use std::io::Cursor;

use boundfit_geometry::Inequality;

use crate::cdd::parse_cdd;
use crate::columns::ColumnSelector;
use crate::error::{InputError, InputErrorKind};
use crate::memory_use::MemoryUse;
use crate::notes::TableNotes;
use crate::open::read_table;
use crate::source::Source;
use crate::table::TableOptions;
use crate::whole::WholeFile;

use file::OF_A_HALF_PLANE;
pub use file::{GeneratorRows, HalfPlaneFile, RowOrigin};

/// The two file formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HalfPlaneFormat {
    /// cdd and lrs: rows `b -a1 -a2`, or `1 x y` and `0 x y` after a line `V-representation`, between `begin` and `end`.
    Ine,
    /// A table with columns a1, a2, b.
    Csv,
}

impl HalfPlaneFormat {
    /// The format that a file name announces, if it announces one.
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, extension) = name.rsplit_once('.')?;
        match extension.to_ascii_lowercase().as_str() {
            "ine" | "ext" => Some(HalfPlaneFormat::Ine),
            "csv" | "tsv" => Some(HalfPlaneFormat::Csv),
            _ => None,
        }
    }
}

/// Reads half-planes `a1·θ1 + a2·θ2 ≤ b`. The format follows from the file's name, else from its contents: a line `begin`
/// makes it a representation of cdd and lrs. That is an H-representation unless a line `V-representation` comes before.
///
/// # Errors
/// The first thing wrong, with its place.
pub fn read_half_planes(source: Source, options: &TableOptions) -> Result<HalfPlaneFile, InputError> {
    let format = HalfPlaneFormat::of_name(source.name().raw());
    let WholeFile { name, content, sha256 } = WholeFile::read(source, &options.sizes)?;
    let has_begin =
        || content.split(|&byte| byte == b'\n').any(|line| line.trim_ascii().starts_with(b"begin"));
    let memory = options.sizes.memory.nothing();
    let asked = memory.ask(content.len() as u64, MemoryUse::Text);
    asked.map_err(|problem| InputError::of_file(&name, problem))?;
    let is_ine = format.map_or_else(has_begin, |format| format == HalfPlaneFormat::Ine);
    if is_ine {
        return parse_cdd(name.raw(), &content, sha256, options);
    }
    let columns = [("a1", 1), ("a2", 2), ("b", 3)].map(|(name, at)| ColumnSelector::name_at(name, at));
    let row_cost = options.row_cost.max(OF_A_HALF_PLANE);
    let options = TableOptions { row_cost, are_half_planes: true, ..options.clone() };
    let table = read_table(Source::new(name.clone(), Cursor::new(content)), &columns, &options)?;
    if let Some(column) =
        table.scanned.header.iter().find(|column| is_coefficient_beyond_the_plane(column.raw()))
    {
        let column = column.clone();
        return Err(InputError::of_file(&name, InputErrorKind::MoreThanThePlane { column }));
    }
    let inequalities = table.rows.iter().map(|row| {
        let mut numbers = row.numbers.iter().cloned();
        let [a1, a2, b] = [0; 3].map(|_| numbers.next().unwrap_or_default());
        Inequality::new(a1, a2, b)
    });
    Ok(HalfPlaneFile {
        system: inequalities.collect(),
        origins: table.rows.iter().map(|row| RowOrigin { row: row.row, reversed: false }).collect(),
        rows: table.scanned.rows_total,
        sha256,
        generators: None,
        layout: table.scanned.layout,
        table: table.scanned.table.map(in_order),
    })
}

/// The detected format of the table, in which columns without names are a1, a2 and b in this order: that is no guess.
fn in_order(mut notes: TableNotes) -> TableNotes {
    notes.header.is_open &= notes.header.line.is_some();
    notes
}

/// Returns whether a column is a3, a4 and so on.
fn is_coefficient_beyond_the_plane(column: &str) -> bool {
    let number = column.strip_prefix(['a', 'A']).and_then(|number| number.parse::<u32>().ok());
    number.is_some_and(|number| number > 2)
}
