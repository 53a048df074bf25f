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
    if rows.is_empty() {
        return Vec::new();
    }
    match read(rows.clone()) {
        Ok(batch) => batch.table_rows().collect(),
        Err(_) if rows.len() == 1 => Vec::new(),
        Err(_) => {
            let middle = rows.start.midpoint(rows.end);
            let halves = [rows.start..middle, middle..rows.end];
            halves.into_iter().flat_map(|half| readable_rows(half, read)).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::InputErrorKind;

    #[test]
    fn rows_that_cannot_be_read_are_left_out_and_only_they() {
        for bad in [&[][..], &[3], &[0, 1, 2], &[0, 4, 9], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]] {
            let read = |rows: Range<usize>| match bad.iter().any(|row| rows.contains(row)) {
                true => Err(InputError::of_file("test", InputErrorKind::NotFinite)),
                false => Ok(Batch {
                    rows: [rows].into_iter().collect(),
                    columns: Vec::new(),
                    keys: None,
                    keys_missing: Vec::new(),
                    lines: None,
                    cells: Vec::new(),
                    fractions: Vec::new(),
                    others: Vec::new(),
                }),
            };
            let found: Vec<usize> = readable_rows(0..10, &read).iter().map(|row| row.row).collect();
            let expected: Vec<usize> = (0..10).filter(|row| !bad.contains(row)).collect();
            assert_eq!(found, expected);
        }
        let none = |_: Range<usize>| panic!("there is nothing to read");
        assert!(readable_rows(5..5, &none).is_empty());
        assert!(readable_rows(Range { start: 6, end: 5 }, &none).is_empty());
    }
}
