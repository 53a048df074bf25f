//! Tables of numbers, and how they are to be read.

use boundfit_exact::{Limits, Rational, Reading};

use crate::block::AskedBlock;
use crate::columns::{ColumnPlace, Header};
use crate::dialect::{AskedDialect, Dialect, Missing, MissingWords};
use crate::error::{InputError, InputErrorKind};
use crate::limits::SizeLimits;
use crate::selection::{RowCondition, RowSet};

/// The place in delimited text of the numbers asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextLayout {
    /// The dialect of the text.
    pub dialect: Dialect,
    /// The numbers of the columns asked for, from 1, in the order asked.
    pub columns: Vec<usize>,
}

impl TextLayout {
    /// The layout of a table whose columns asked for are at these places.
    pub(crate) fn new(dialect: Dialect, places: &[ColumnPlace]) -> Self {
        let columns = places.iter().map(|place| place.position).collect();
        TextLayout { dialect, columns }
    }
}

/// The options of a table.
#[derive(Debug, Clone, Default)]
pub struct TableOptions {
    /// Says whether there is a header.
    pub header: Header,
    /// The sheet of a workbook, by its name or its number from 1; the first one when `None`.
    pub sheet: Option<String>,
    /// The dialect of a text.
    pub dialect: AskedDialect,
    /// The block to read from a file with several blocks; such a file is refused when `None`.
    pub block: Option<AskedBlock>,
    /// The treatment of rows that lack a number.
    pub missing: Missing,
    /// Further words for missing values, in text and workbooks.
    pub missing_as: MissingWords,
    /// The rows that may be wanted.
    pub rows: RowSet,
    /// The conditions for each of these to be wanted: every condition.
    pub conditions: Vec<RowCondition>,
    /// `true` if rows that are not wanted are kept too, where their cells are numbers.
    pub keep_others: bool,
    /// `true` if the texts of the cells are kept too, where the table is text.
    pub keep_cells: bool,
    /// The reading of numbers.
    pub reading: Reading,
    /// `true` if the rows are half-planes. Then relations are refused, and cells beside the columns asked for that have no name.
    pub are_half_planes: bool,
    /// Limits on one number.
    pub limits: Limits,
    /// Limits on the file as a whole.
    pub sizes: SizeLimits,
    /// Bytes of memory that a row takes where rows are held, with all that is made of it, as far as the caller knows; counted
    /// against [`SizeLimits::memory`].
    pub row_cost: usize,
    /// The most wanted rows that may be held: one more is refused as soon as it is met.
    pub most_wanted: Option<usize>,
    /// `true` if the options are those of another table, beside which this one is read: what has no effect here is passed over.
    pub is_beside: bool,
}

impl TableOptions {
    /// Returns whether rows may be passed over.
    pub fn selects_rows(&self) -> bool {
        !self.rows.is_all() || !self.conditions.is_empty()
    }
}

/// One data row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableRow {
    /// Number of the row among the data rows, from 1.
    pub row: usize,
    /// The numbers of the columns asked for, in the order asked.
    pub numbers: Vec<Rational>,
    /// The texts of the cells whose numbers are asked for, as written but for grouped digits, and empty where
    /// a value is missing; only with [`TableOptions::keep_cells`].
    pub cells: Vec<String>,
}

/// Refuses a table whose first record, on this line, has too many cells.
pub(crate) fn check_columns(
    file: &str,
    cells: usize,
    line: u64,
    sizes: &SizeLimits,
) -> Result<(), InputError> {
    if cells <= sizes.columns {
        return Ok(());
    }
    Err(InputError::of_line(file, line, InputErrorKind::TooManyColumns { limit: sizes.columns }))
}
