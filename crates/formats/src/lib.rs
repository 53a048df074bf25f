//! Files in: tables, workbooks, variables, half-planes, with the place of every error.
//!
//! [`Source`] opens a file or standard input. [`read_table`] reads the numeric columns that are asked for
//! from delimited text in many dialects ([`AskedDialect`]). [`scan`] does so in batches, for files of any
//! size; both functions also read MATLAB's `.mat` files (feature `matlab`). [`read_half_planes`] reads half-planes from such a
//! table or from an H- or V-representation of cdd and lrs. Every number is read exactly as
//! [`boundfit_exact::Reading`] says. Every error is an [`InputError`], which names the file, the line, the
//! column, the text found there and what would be accepted.
//!
//! | step | modules |
//! |---|---|
//! | open a file, tell its format | `source`, `open`, `binary`, `mat_kind`, `unpack`, `decoding` |
//! | tell how a text is written | `start`, `dialect`, `heading`, `blocks`, `units` |
//! | read records and cells | `records`, `blanks`, `chunks`, `cells`, `fractions`, `lacking` |
//! | read columns in batches | `scan`, `threads`, `memory` |
//! | other formats | `json`, `workbook`, `mat`, `arrow`, `cdd`, `half_planes`, `reduction` |
//! | choose columns and rows | `columns`, `roles`, `wanted`, `selection`, `row_range`, `block` |
//! | refuse what is too much, say what is wrong | `limits`, `budget`, `packing`, `error`, `notes` |

// Code that reads input never panics on it; exceptions stand at the smallest item, with the proof that it holds.
#![deny(clippy::expect_used, clippy::indexing_slicing, clippy::panic, clippy::unwrap_used)]

#[cfg(feature = "arrow")]
mod arrow;
mod binary;
mod blanks;
mod block;
mod blocks;
mod budget;
mod cdd;
mod cells;
mod chunks;
mod columns;
mod decoding;
mod dialect;
#[cfg(any(feature = "matlab", feature = "spreadsheets"))]
mod doubles;
mod error;
mod fractions;
mod half_planes;
mod hash;
mod heading;
mod json;
mod lacking;
mod limits;
#[cfg(feature = "matlab")]
mod mat;
mod mat_kind;
mod memory;
mod memory_use;
mod notes;
mod open;
mod packing;
mod quoted_name;
mod quotes;
mod records;
mod reduction;
mod relations;
mod roles;
mod row_range;
mod scan;
mod selection;
mod source;
mod start;
mod table;
pub mod threads;
mod times;
mod units;
#[cfg(feature = "packed")]
mod unpack;
#[cfg(not(feature = "packed"))]
#[path = "not_unpacked.rs"]
mod unpack;
mod wanted;
mod whole;
#[cfg(feature = "spreadsheets")]
mod workbook;

pub use block::{AskedBlock, Block};
pub use budget::MemoryBudget;
pub use columns::{ColumnSelector, Header, Role};
pub use dialect::{AskedDialect, BLANKS, CommentMark, DELIMITERS, Dialect, Encoding, Missing, MissingWords};
pub use error::{InputError, InputErrorKind, Place, Setting, Way, nearest};
pub use fractions::Fractions;
pub use half_planes::{GeneratorRows, HalfPlaneFile, HalfPlaneFormat, RowOrigin, read_half_planes};
pub use heading::find_column;
pub use limits::{LONGEST_LINE, SizeLimits};
pub use memory::{MemoryNumbers, MemoryTable};
pub use memory_use::MemoryUse;
pub use notes::{BlockNote, HeaderNote, SheetLooks, SheetNote, Skipped, TableNotes};
pub use open::{HeldRows, Table, read_table, scan};
pub use reduction::{
    AskedReduction, REDUCTION_MARK, ReducedBounds, ReducedMarks, ReducedModel, ReductionError,
    ReductionRecord, Reductions, open_reduction,
};
pub use row_range::RowRange;
pub use scan::{Batch, Pieces, Progress, RowKeys, ScanOptions, Scanned};
pub use selection::{ParseRowConditionError, RowCondition, RowNumbers, RowSet};
pub use source::{Again, Source};
pub use table::{TableOptions, TableRow, TextLayout};
pub use whole::WholeFile;
