//! Where the readings of a report come from.

use boundfit_exact::{Foreign, Reading};

/// Where the readings come from.
#[derive(Debug, Clone, Copy)]
pub struct Origin<'a> {
    /// The file, in the words of the user; `None` for standard input.
    pub file: Option<Foreign<&'a str>>,
    /// How numbers were read.
    pub reading: Reading,
    /// `true` if the file stores them in binary, so that they were not read from text.
    pub is_stored: bool,
}
