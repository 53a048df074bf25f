//! Tells which cells of a record stand in quotes: blanks there belong to the text of a cell.

use crate::dialect::BLANKS;

/// Returns true if a cell (from 0) of a record as it stands in the file begins with a quote. Blanks in the
/// cell are then part of its text. The rules are the ones of `csv_core`: a quote opens at the very beginning
/// of a cell, two quotes within are one, and a closing quote ends the quoted part.
pub(super) fn is_quoted(record: &[u8], delimiter: u8, index: usize) -> bool {
    // Blanks that separate cells are in none of them, but for quotes.
    if delimiter == BLANKS {
        return true;
    }
    let mut bytes = record.iter().copied().peekable();
    for _ in 0..index {
        pass_cell(&mut bytes, delimiter);
    }
    bytes.peek() == Some(&b'"')
}

/// Goes to the beginning of the next cell.
fn pass_cell(bytes: &mut std::iter::Peekable<impl Iterator<Item = u8>>, delimiter: u8) {
    let mut is_within = bytes.next_if_eq(&b'"').is_some();
    while let Some(byte) = bytes.next() {
        match byte {
            b'"' if is_within => is_within = bytes.next_if_eq(&b'"').is_some(),
            other if other == delimiter && !is_within => return,
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::is_quoted;

    #[test]
    fn quotes_are_known_from_text_that_has_some() {
        let record = "\"a\",b \"c\", \"d\",\"e,\"\" \",\"f\"g,\"\",h".as_bytes();
        let quoted: Vec<bool> = (0..7).map(|index| is_quoted(record, b',', index)).collect();
        assert_eq!(quoted, [true, false, false, true, true, true, false]);
        assert!(!is_quoted(b"", b',', 0) && !is_quoted(b"a", b',', 5) && is_quoted(b"a", super::BLANKS, 0));
    }
}
