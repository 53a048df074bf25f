//! The start of a table: byte order mark and delimiter.

use crate::blanks::{BlankReader, Cells};
use crate::error::InputErrorKind;
use crate::reduction::error::ReductionError;
use crate::reduction::record::REDUCTION_MARK;

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// The most bytes of blank lines that are read ahead of the first line that is not blank.
const MOST_BEFORE: usize = 1 << 16;

/// Looks for the first line that is not blank in a start that grows.
#[derive(Default)]
pub(crate) struct FirstLine {
    /// The number of bytes of the start that are known to come before it.
    before: usize,
}

impl FirstLine {
    /// Returns whether so much comes before the line that it is not worth holding.
    pub(crate) fn is_far_away(&self) -> bool {
        self.before > MOST_BEFORE
    }

    /// Returns whether the line and its end are in the start, to which so many bytes were added since the last call.
    pub(crate) fn is_in(&mut self, start: &[u8], added: usize) -> bool {
        if self.before == 0 {
            self.before = start.len() - without_mark(start).len();
        }
        let rest = start.get(self.before..).unwrap_or_default().trim_ascii_start();
        self.before = start.len() - rest.len();
        let fresh = rest.len().min(added);
        rest.iter().rev().take(fresh).any(|&byte| byte == b'\n')
    }
}

/// The bytes without a byte order mark.
pub(crate) fn without_mark(start: &[u8]) -> &[u8] {
    start.strip_prefix(BYTE_ORDER_MARK).unwrap_or(start)
}

/// Refuses what is no table: reductions where nothing is known of them.
pub(crate) fn refuse_other(start: &[u8]) -> Result<(), InputErrorKind> {
    if start.starts_with(REDUCTION_MARK.as_bytes()) {
        return Err(ReductionError::NotHere.into());
    }
    Ok(())
}

/// The separator of cells of a line, if anything but blanks does: a semicolon, tab, comma or bar outside quotes, in this order.
pub(crate) fn delimiter_of(line: &[u8]) -> Option<u8> {
    let outside = outside_quotes(line);
    [b';', b'\t', b',', b'|'].into_iter().find(|delimiter| outside.contains(delimiter))
}

/// Returns true if blanks, and nothing else, separate the cells of a table with these first two lines. Both
/// lines then have as many cells, or the second has a cell more (the names of rows, which need no name).
pub(crate) fn are_blanks(first: &[u8], second: Option<&[u8]>) -> bool {
    let cells = cells_between_blanks(first);
    let is_next = |second: &[u8]| {
        let next = cells_between_blanks(second);
        (next == cells || next == cells + 1) && matches!(delimiter_of(second), None | Some(b','))
    };
    cells > 1 && second.is_none_or(is_next)
}

/// A line without what is in quotes.
fn outside_quotes(line: &[u8]) -> Vec<u8> {
    let mut quoted = false;
    let is_outside = |byte: &&u8| {
        quoted ^= **byte == b'"';
        !quoted
    };
    line.iter().filter(is_outside).copied().collect()
}

/// Returns the number of cells of a line if blanks separate them.
pub(crate) fn cells_between_blanks(line: &[u8]) -> usize {
    let mut record = Count(0);
    let mut reader = BlankReader::default();
    reader.read(line, &mut record);
    reader.finish(&mut record);
    record.0
}

struct Count(usize);

impl Cells for Count {
    fn extend(&mut self, _: &[u8]) {}

    fn end_cell(&mut self) {
        self.0 += 1;
    }
}
