//! Records whose cells are separated by runs of blanks and tabs.

/// The place within a record of the last byte.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum State {
    #[default]
    Between,
    InCell,
    InQuotes,
    /// Right after a quote within quotes: it ends them, unless another one follows.
    AfterQuote,
}

/// Takes records apart, out of pieces of any size. Blanks at both ends of a line mean nothing. A cell that
/// starts with a quote ends at the next quote, and may hold blanks, line ends and doubled quotes.
#[derive(Debug, Default)]
pub(crate) struct BlankReader {
    state: State,
}

/// The parts of a record.
pub(crate) trait Cells {
    /// Adds bytes to the cell under way.
    fn extend(&mut self, bytes: &[u8]);
    /// Ends the cell under way.
    fn end_cell(&mut self);
}

impl BlankReader {
    /// Goes on with a record; gives how many bytes it took, and whether the last of them ended it.
    pub(crate) fn read(&mut self, input: &[u8], record: &mut impl Cells) -> (usize, bool) {
        let mut at = 0;
        while let Some(&byte) = input.get(at) {
            let rest = input.get(at..).unwrap_or_default();
            match (self.state, byte) {
                (State::InQuotes, b'"') => self.state = State::AfterQuote,
                (State::InQuotes, _) => {
                    let length = memchr::memchr(b'"', rest).unwrap_or(rest.len());
                    record.extend(rest.get(..length).unwrap_or_default());
                    at += length;
                    continue;
                }
                (State::AfterQuote, b'"') => {
                    record.extend(b"\"");
                    self.state = State::InQuotes;
                }
                (state, b'\r' | b'\n') => {
                    self.end(state, record);
                    return (at + 1, true);
                }
                (state, b' ' | b'\t') => self.end(state, record),
                (State::Between, b'"') => self.state = State::InQuotes,
                _ => {
                    let is_end = |byte: &u8| matches!(byte, b' ' | b'\t' | b'\r' | b'\n');
                    let length = rest.iter().position(is_end).unwrap_or(rest.len());
                    record.extend(rest.get(..length).unwrap_or_default());
                    self.state = State::InCell;
                    at += length;
                    continue;
                }
            }
            at += 1;
        }
        (input.len(), false)
    }

    /// Ends the cell that the last piece left open, since nothing follows.
    pub(crate) fn finish(&mut self, record: &mut impl Cells) {
        self.end(self.state, record);
    }

    /// Returns whether a quote is open.
    pub(crate) fn is_within_quotes(&self) -> bool {
        self.state == State::InQuotes
    }

    fn end(&mut self, state: State, record: &mut impl Cells) {
        if state != State::Between {
            record.end_cell();
        }
        self.state = State::Between;
    }
}
