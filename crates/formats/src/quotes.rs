//! Cells with text behind their closing quote. The rules of CSV put it together with the text within, but `"5"7` is no 57: a quote or
//! a delimiter is lost.

/// The place within a record of the last byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum State {
    #[default]
    Start,
    InCell,
    InQuotes,
    /// Behind a quote within quotes: it ends the cell, unless another one follows.
    AfterQuote,
    /// Behind such a quote and blanks.
    AfterBlank,
}

/// The cells of a record with text behind their closing quote.
#[derive(Debug, Default)]
pub(crate) struct TornCells {
    state: State,
    /// The number of cells before the one under way.
    cell: usize,
    torn: Vec<usize>,
}

impl TornCells {
    pub(crate) fn clear(&mut self) {
        (self.state, self.cell) = (State::Start, 0);
        self.torn.clear();
    }

    /// Returns whether there is text behind the closing quote of a cell, counted from 0.
    pub(crate) fn has(&self, cell: usize) -> bool {
        self.torn.binary_search(&cell).is_ok()
    }

    /// Goes on with a record. `delimiter` separates cells; a run of blanks counts as one where they do.
    pub(crate) fn pass(&mut self, bytes: &[u8], delimiter: u8) {
        let are_blanks = delimiter == b' ';
        for &byte in bytes {
            let is_blank = matches!(byte, b' ' | b'\t');
            let ends_cell = if are_blanks { is_blank } else { byte == delimiter };
            self.state = match self.state {
                State::InQuotes if byte == b'"' => State::AfterQuote,
                State::InQuotes => State::InQuotes,
                State::Start if are_blanks && is_blank => State::Start,
                _ if ends_cell || matches!(byte, b'\r' | b'\n') => {
                    self.cell += 1;
                    State::Start
                }
                State::Start | State::AfterQuote if byte == b'"' => State::InQuotes,
                State::AfterQuote | State::AfterBlank if is_blank => State::AfterBlank,
                State::AfterQuote | State::AfterBlank => {
                    self.torn.push(self.cell);
                    State::InCell
                }
                State::Start | State::InCell => State::InCell,
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_behind_a_closing_quote_is_found_in_pieces_of_any_size() {
        for (record, delimiter, torn) in [
            ("1,\"5\"7,\"a\"\"b\",\"c\" ,d\"e\"f\n", b',', &[1][..]),
            ("\"3\"0;\"4\n,\";\"\"\"x", b';', &[0]),
            ("  \"1\"  \"2\"3  4\"5\" \"6 7\"8", b' ', &[1, 3]),
            ("\"\",\"\"x,\"\"\"\"", b',', &[1]),
            ("\"a\" \"b,\"c\"d\",\"e\"", b',', &[0, 1]),
        ] {
            for size in 1..=record.len() {
                let mut cells = TornCells::default();
                record.as_bytes().chunks(size).for_each(|piece| cells.pass(piece, delimiter));
                assert_eq!(cells.torn, torn, "{record} {size}");
            }
        }
    }
}
