//! MATLAB's `.mat` files of version 4 and 5 (`save -v4`, `-v6` and `-v7`), and what Octave's `save -text` writes, as tables.
//!
//! The columns are the real, full vectors and matrices of numbers or logicals. A vector `x` is the column
//! `x`. A matrix `M` with k columns (and at least two rows) is the columns `M(:,1)` to `M(:,k)`. They are
//! counted from 1 in the order of the file. Nothing else in a file is looked at, and only the columns that
//! are asked for must have one length.
//!
//! The bytes are read once, from front to back. `v4` reads variables of version 4 and `octave` variables in
//! text. For version 5, `elements` cuts the bytes into tagged elements. Then `variable` reads a variable's
//! own description, `numbers` reads its numbers, `columns` finds the columns that are asked for, and
//! `batches` hands them out.
//!
//! Source: The MathWorks, *MAT-File Format* (version 5).

mod batches;
mod columns;
mod elements;
mod file;
mod numbers;
mod octave;
mod search;
mod v4;
mod variable;

pub(crate) use batches::scan_mat;
