//! The content.

use boundfit_geometry::{Generators, System};

use crate::notes::TableNotes;
use crate::table::TextLayout;

/// Bytes that a half-plane or a generator takes at least with what is made of it: measured as the largest memory of a
/// process that read 10⁶ points. The cost of the callers' own data is in [`TableOptions::row_cost`].
pub(crate) const OF_A_HALF_PLANE: usize = 800;

/// The origin of an inequality of the system: a row of the file. For a V-representation, its number among the
/// computed inequalities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RowOrigin {
    /// The row, from 1.
    pub row: usize,
    /// `true` if this is the other direction of a row that is an equation.
    pub reversed: bool,
}

/// The half-planes of a file.
#[derive(Debug, Clone)]
pub struct HalfPlaneFile {
    /// The inequalities; an equation gives two. For a V-representation, a minimal set of them.
    pub system: System,
    /// The origin of each inequality of the system.
    pub origins: Vec<RowOrigin>,
    /// The number of rows of the file.
    pub rows: usize,
    /// SHA-256 of the file's bytes, in hexadecimal.
    pub sha256: String,
    /// The rows of a V-representation.
    pub generators: Option<GeneratorRows>,
    /// The detected format of the table; `None` for a representation of cdd and lrs.
    pub table: Option<TableNotes>,
    /// The place of a1, a2 and b in delimited text; `None` for any other file.
    pub layout: Option<TextLayout>,
}

/// The rows of a V-representation.
#[derive(Debug, Clone)]
pub struct GeneratorRows {
    /// The meaning of each row, in order; after them the origin, when there are rows but none is a point.
    pub generators: Generators,
    /// The rows, from 1, of the points that span the set's part of the boundary of each inequality
    /// ([`Generators::spanning`]).
    pub spanning: Vec<Vec<usize>>,
}
