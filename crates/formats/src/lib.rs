//! Files in.
//!
//! [`Source`] opens a file or standard input; [`read_table`] reads the numeric columns that are asked for from
//! comma-, semicolon- or tab-separated text, and [`scan`] does so in batches, for files of any size;
//! [`read_half_planes`] reads half-planes from such a table or from cdd's H-representation. Every number is read exactly
//! as [`boundfit_exact::Reading`] says. Every error is an [`InputError`], which names the file, the line, the column, the
//! text found there and what would be accepted.

#[cfg(feature = "arrow")]
mod arrow;
mod binary;
mod columns;
mod error;
mod half_planes;
mod ine;
mod lines;
mod records;
mod reduction;
mod scan;
mod source;
mod start;
mod table;

pub use columns::{ColumnSelector, Header};
pub use error::{InputError, Place, Problem};
pub use half_planes::{HalfPlaneFile, HalfPlaneFormat, RowOrigin, read_half_planes};
pub use reduction::{
    REDUCTION_MARK, ReductionError, ReductionReader, ReductionRecord, Reductions, open_reduction,
};
pub use scan::{Batch, Column, Pieces, Progress, ScanOptions, Scanned, scan};
pub use source::{LONGEST_LINE, Source};
pub use table::{RowRange, Table, TableOptions, TableRow, read_table};
