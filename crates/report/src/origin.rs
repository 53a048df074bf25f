//! The source of the readings of a report.

use boundfit_exact::{Foreign, Reading};

/// The source of the readings.
#[derive(Debug, Clone, Copy)]
pub struct Origin<'a> {
    /// The file, in the words of the user; `None` for standard input.
    pub file: Option<Foreign<&'a str>>,
    /// The way in which numbers were read.
    pub reading: Reading,
    /// `true` if the file stores them in binary, so that they were not read from text.
    pub is_stored: bool,
}
