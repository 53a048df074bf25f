//! Rows that are not wanted but kept where they hold numbers.

use std::ops::Range;

use crate::error::InputError;
use crate::table::TableRow;

use super::batch::Batch;

/// The rows of a range that can be read, where `read` gives a batch or says that a row of it cannot be. Cost: as that of
/// reading the range once, and as often again for each row that cannot be read as the range can be halved.
pub(crate) fn readable_rows(
    rows: Range<usize>,
    read: &impl Fn(Range<usize>) -> Result<Batch, InputError>,
) -> Vec<TableRow> {
    match read(rows.clone()) {
        _ if rows.is_empty() => Vec::new(),
        Ok(batch) => batch.table_rows().collect(),
        Err(_) if rows.len() == 1 => Vec::new(),
        Err(_) => {
            let middle = rows.start.midpoint(rows.end);
            let halves = [rows.start..middle, middle..rows.end];
            halves.into_iter().flat_map(|half| readable_rows(half, read)).collect()
        }
    }
}
