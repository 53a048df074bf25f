//! The input of a calibration.

use boundfit_estimation::{FractionCells, Selection};
use boundfit_exact::Foreign;
#[cfg(feature = "files")]
use boundfit_formats::TableNotes;

/// The input of a calibration.
#[derive(Debug, Clone)]
pub struct LinearityInput {
    /// The column of x.
    pub x: Foreign,
    /// The columns of readings.
    pub response: ResponseColumns,
    /// The number of rows that are used.
    pub rows: usize,
    /// The number of data rows of the file.
    pub rows_total: usize,
    /// The number of rows that lack a number.
    pub rows_missing: usize,
    /// The rows that were asked for.
    pub selection: Selection,
    /// Columns with cells that are fractions.
    pub fractions: Vec<FractionCells>,
    /// The detected format of the table.
    #[cfg(feature = "files")]
    pub table: Option<TableNotes>,
    /// The units of x and of the readings, where the file states them.
    pub units: [Option<Foreign>; 2],
    /// SHA-256 of the file's bytes.
    pub sha256: Option<String>,
}

/// The columns of readings.
#[derive(Debug, Clone)]
pub enum ResponseColumns {
    /// One, of which no direction is known.
    One(Foreign),
    /// One, beside a column that tells the direction.
    Directed {
        /// The readings.
        y: Foreign,
        /// The direction.
        direction: Foreign,
        /// The words of the column for up and for down.
        words: [Vec<Foreign>; 2],
    },
    /// One for each direction.
    Two {
        /// Upscale.
        up: Foreign,
        /// Downscale.
        down: Foreign,
    },
}
