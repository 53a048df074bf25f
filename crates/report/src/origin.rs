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

impl<'a> Origin<'a> {
    /// Returns the name of the source in a report.
    pub fn name(&self) -> Foreign<&'a str> {
        self.file.unwrap_or(Foreign::of("standard input"))
    }

    /// The way in which numbers were read, as a report states it.
    pub(crate) fn words_of_reading(&self) -> &'static str {
        match self.reading {
            _ if self.is_stored => "binary64: the numbers of the file exactly as stored",
            Reading::Decimal => "decimal: numbers exactly as written",
            Reading::Binary64 => "binary64: the double nearest to each number, exactly",
        }
    }
}
