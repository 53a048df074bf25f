//! Limits on a file as a whole.

use boundfit_exact::MOST_WORK;

use crate::budget::MemoryBudget;
#[cfg(any(feature = "arrow", feature = "matlab"))]
use crate::error::InputErrorKind;
#[cfg(any(feature = "arrow", feature = "matlab"))]
use crate::packing::most_unpacked;

/// The most that one file may ask for, beside what one of its numbers may ([`boundfit_exact::Limits`]). Input
/// that passes a limit is refused before memory is taken for it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SizeLimits {
    /// Bytes of one line, and of one row where quotes make it go over several lines.
    pub line: usize,
    /// Columns of a table of text.
    pub columns: usize,
    /// Rows that the size line of an `.ine` or `.ext` file may announce, and of a table that is held in memory whole.
    pub rows: usize,
    /// Elements that one array of a `.mat` file may have.
    pub elements: usize,
    /// Bytes that a compressed file may unpack to.
    pub unpacked: u64,
    /// The factor of its size up to which a packed file may unpack, beyond 67,108,864 bytes. A packed file is
    /// a compressed one, a variable of a `.mat` file or a workbook. Numbers of 8 bytes that columns of a
    /// Parquet or Arrow file stand for count too. Beyond 8,388,608 bytes no more than that is held of what a
    /// Zstandard file unpacks to so that later bytes can repeat it.
    pub ratio: u64,
    /// Bytes that a workbook may have, unpack to, and have as the text of one sheet.
    pub workbook: u64,
    /// Products of machine words that exact arithmetic on its long numbers may take ([`boundfit_exact::Work`]).
    pub work: u64,
    /// Bytes of a text that is held in memory whole: half-planes, a linear program.
    pub text: u64,
    /// The most levels of nested arrays and objects in a JSON file.
    pub nesting: usize,
    /// Bytes of memory that may be held: by readers, of what they cannot hand out at once, and of rows, with what is made of each
    /// ([`HeldRows`](crate::HeldRows)). Clones of these limits share one budget.
    pub memory: MemoryBudget,
}

impl Default for SizeLimits {
    /// 16,777,216 bytes, 100,000 columns, 10,000,000 rows, 100,000,000 elements, 68,719,476,736 bytes, 100 times the size,
    /// 1,073,741,824 bytes, [`MOST_WORK`], 1,073,741,824 bytes, 64 levels, 1,073,741,824 bytes.
    fn default() -> Self {
        SizeLimits {
            line: LONGEST_LINE,
            columns: 100_000,
            rows: 10_000_000,
            elements: 100_000_000,
            unpacked: 1 << 36,
            ratio: 100,
            workbook: 1 << 30,
            work: MOST_WORK,
            text: 1 << 30,
            nesting: 64,
            memory: MemoryBudget::new(1 << 30),
        }
    }
}

#[cfg(any(feature = "arrow", feature = "matlab"))]
impl SizeLimits {
    /// Refuses what so many bytes unpack to, if that is more than they may.
    pub(crate) fn check_ratio(&self, packed: u64, unpacked: u64) -> Result<(), InputErrorKind> {
        let ratio = self.ratio;
        if unpacked <= most_unpacked(packed, ratio) {
            return Ok(());
        }
        Err(InputErrorKind::UnpacksTooFar { ratio })
    }
}

/// The longest line that is read unless more is asked for, in bytes. Without a bound, a file without line ends would be
/// held in memory whole.
pub const LONGEST_LINE: usize = 1 << 24;
