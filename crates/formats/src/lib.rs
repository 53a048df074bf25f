//! Files in.
//!
//! [`Source`] opens a file or standard input; [`read_table`] reads the numeric columns that are asked for from
//! comma-, semicolon- or tab-separated text; [`read_half_planes`] reads half-planes from such a table or from cdd's
//! H-representation. Every number is read exactly as [`boundfit_exact::Reading`] says. Every error is an
//! [`InputError`], which names the file, the line, the column, the text found there and what would be accepted.

mod error;
mod half_planes;
mod ine;
mod lines;
mod source;
mod table;

pub use error::{InputError, Place, Problem};
pub use half_planes::{HalfPlaneFile, HalfPlaneFormat, RowOrigin, read_half_planes};
pub use source::{LONGEST_LINE, Source};
pub use table::{ColumnSelector, Header, RowRange, Table, TableOptions, TableRow, read_table};
