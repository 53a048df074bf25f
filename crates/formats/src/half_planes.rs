//! Half-planes from a file: an H- or V-representation of cdd and lrs, or a table with columns a1, a2, b.

use std::io::{Cursor, Read};

use boundfit_geometry::{Generators, Inequality, System};

use crate::columns::ColumnSelector;
use crate::error::InputError;
use crate::ine::parse_ine;
use crate::source::Source;
use crate::table::{TableOptions, read_table};

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

/// Which row of the file an inequality of the system comes from; for a V-representation, its number among those computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RowOrigin {
    /// The row, from 1.
    pub row: usize,
    /// Whether this is the other direction of a row that is an equation.
    pub reversed: bool,
}

/// The half-planes of a file.
#[derive(Debug, Clone)]
pub struct HalfPlaneFile {
    /// The inequalities; an equation gives two. For a V-representation, a minimal set of them.
    pub system: System,
    /// Where each inequality of the system comes from.
    pub origins: Vec<RowOrigin>,
    /// How many rows the file has.
    pub rows: usize,
    /// SHA-256 of the file's bytes, in hexadecimal.
    pub sha256: String,
    /// The rows of a V-representation.
    pub generators: Option<GeneratorRows>,
}

/// The rows of a V-representation.
#[derive(Debug, Clone)]
pub struct GeneratorRows {
    /// What each row stands for, in order; after them the origin, when there are rows but none is a point.
    pub generators: Generators,
    /// For each inequality of the system, the rows, from 1, of the points that span the set's part of its boundary
    /// ([`Generators::spanning`]).
    pub spanning: Vec<Vec<usize>>,
}

/// Reads half-planes `a1·θ1 + a2·θ2 ≤ b`. The format follows from the file's name, else from its contents: a line `begin`
/// makes it a representation of cdd and lrs. That is an H-representation unless a line `V-representation` comes before.
///
/// # Errors
/// The first thing wrong, with its place.
pub fn read_half_planes(source: Source, options: &TableOptions) -> Result<HalfPlaneFile, InputError> {
    let format = HalfPlaneFormat::of_name(source.name());
    let (name, mut bytes) = source.watched(&options.sizes);
    let mut content = Vec::new();
    bytes.read_to_end(&mut content).map_err(|error| Source::stopped(&name, error))?;
    let has_begin =
        || content.split(|&byte| byte == b'\n').any(|line| line.trim_ascii().starts_with(b"begin"));
    let is_ine = format.map_or_else(has_begin, |format| format == HalfPlaneFormat::Ine);
    if is_ine {
        return parse_ine(&name, &content, bytes.sha256(), options);
    }
    let columns = [("a1", 1), ("a2", 2), ("b", 3)].map(|(name, at)| ColumnSelector::name_at(name, at));
    let table = read_table(Source::new(name, Cursor::new(content)), &columns, options)?;
    let inequalities = table.rows.iter().map(|row| {
        let mut numbers = row.numbers.iter().cloned();
        let [a1, a2, b] = [0; 3].map(|_| numbers.next().unwrap_or_default());
        Inequality::new(a1, a2, b)
    });
    Ok(HalfPlaneFile {
        system: inequalities.collect(),
        origins: table.rows.iter().map(|row| RowOrigin { row: row.row, reversed: false }).collect(),
        rows: table.rows_total,
        sha256: table.sha256,
        generators: None,
    })
}
