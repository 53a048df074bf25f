//! The purpose of some memory.

use std::fmt;

use boundfit_exact::english::counted;

/// The purpose of some memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MemoryUse {
    /// The number of rows from the first one on, with what is made of them.
    Rows(usize),
    /// The bytes of a workbook, with the list of its parts.
    Workbook,
    /// The texts and cells of a sheet.
    Cells,
    /// The numbers of variables.
    Variables,
    /// Records that are read together.
    Records,
    /// Record batches that are decoded together.
    Batches,
    /// The last bytes of what a packed file unpacks to, which later ones may repeat.
    Unpacking,
    /// A text that is read whole.
    Text,
    /// The sets for all factors of a range.
    Sets,
}

impl fmt::Display for MemoryUse {
    /// The use with its verb: `the first 5 rows take`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            MemoryUse::Rows(rows) => {
                let verb = if *rows == 1 { "takes" } else { "take" };
                return write!(
                    f,
                    "the first {} {verb}",
                    counted(*rows, "row", "rows").trim_start_matches("1 ")
                );
            }
            MemoryUse::Workbook => "the workbook takes",
            MemoryUse::Cells => "the cells of the sheet take",
            MemoryUse::Variables => "the variables that are asked for take",
            MemoryUse::Records => "the records that are read together take",
            MemoryUse::Batches => "the record batches that are read together take",
            MemoryUse::Unpacking => "unpacking takes",
            MemoryUse::Text => "the text takes",
            MemoryUse::Sets => "the sets for all factors take",
        })
    }
}
