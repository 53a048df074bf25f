//! Readings from files: delimited text, MATLAB's `.mat`, and with the feature `arrow` Parquet and Arrow IPC.
//!
//! [`Measurements::scan`] reads a file in parts, in memory that does not grow with it;
//! [`Measurements::read`] reads a [`Source`], which need not be a file. A column is named by its header or its number, and
//! every error names file, line, column and text. Columns in memory are a source too ([`MemoryTable`]); a [`Question`] says what is
//! asked of either.
//!
//! ```
//! use boundfit::files::{LineForm, ColumnSelector, Columns, EpsilonColumn, Measurements, Source, TableOptions};
//! use boundfit::{Problem, Rational};
//!
//! let table = Source::new("readings.csv", "x,y\n0,0\n1,1.5\n2,2\n".as_bytes());
//! let columns = Columns {
//!     first: ColumnSelector::name_or_number("x"),
//!     second: None,
//!     response: Some(ColumnSelector::name_or_number("y")),
//!     epsilon: EpsilonColumn::Uniform(Rational::ratio(1, 2)),
//!     form: LineForm::default(),
//! };
//! let fit = Problem::new(Measurements::read(table, &columns, &TableOptions::default())?).fit();
//! assert_eq!(fit.vertices(), boundfit::fit(&[0, 1, 2], &["0", "1.5", "2"], "1/2").unwrap().vertices());
//! # Ok::<(), boundfit::files::InputError>(())
//! ```

pub use boundfit_estimation::{
    AskedBound, Columns, EpsilonColumn, Fleet, GroupAnswer, GroupFit, GroupLine, Keep, LineForm,
    Measurements, ParseBoundError, Question, ReducedTable,
};
pub use boundfit_exact::{Limits, Reading};
pub use boundfit_formats::{
    AskedBlock, AskedDialect, ColumnSelector, CommentMark, Encoding, HalfPlaneFile, Header, InputError,
    InputErrorKind, MemoryBudget, MemoryNumbers, MemoryTable, Missing, MissingWords, Pieces, RowCondition,
    RowKeys, RowRange, RowSet, ScanOptions, Setting, SizeLimits, Source, TableOptions, Way, read_half_planes,
};
