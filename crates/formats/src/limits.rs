//! What a file as a whole may ask for.

use boundfit_exact::MOST_WORK;

/// The most that one file may ask for, beside what one of its numbers may ([`boundfit_exact::Limits`]). What passes a limit
/// is refused before memory is taken for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SizeLimits {
    /// Bytes of one line, and of one row where quotes make it go over several lines.
    pub line: usize,
    /// Columns of a table of text.
    pub columns: usize,
    /// Rows that the size line of an `.ine` or `.ext` file may announce.
    pub rows: usize,
    /// Elements that one array of a `.mat` file may have.
    pub elements: usize,
    /// Bytes that a compressed file may unpack to.
    pub unpacked: u64,
    /// Bytes that a workbook may have, unpack to, and have as the text of one sheet.
    pub workbook: u64,
    /// Products of machine words that exact arithmetic on its long numbers may take ([`boundfit_exact::Work`]).
    pub work: u64,
    /// How deep arrays and objects of a JSON file may be nested.
    pub nesting: usize,
}

impl Default for SizeLimits {
    /// 16,777,216 bytes, 100,000 columns, 10,000,000 rows, 100,000,000 elements, 68,719,476,736 and 1,073,741,824 bytes,
    /// [`MOST_WORK`], 64 levels.
    fn default() -> Self {
        SizeLimits {
            line: LONGEST_LINE,
            columns: 100_000,
            rows: 10_000_000,
            elements: 100_000_000,
            unpacked: 1 << 36,
            workbook: 1 << 30,
            work: MOST_WORK,
            nesting: 64,
        }
    }
}

/// The longest line that is read unless more is asked for, in bytes. Without a bound, a file without line ends would be
/// held in memory whole.
pub const LONGEST_LINE: usize = 1 << 24;
