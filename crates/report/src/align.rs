//! Columns of plain text under each other.

use unicode_width::UnicodeWidthStr;

/// Returns the number of columns that a text takes on a terminal.
pub(crate) fn columns(text: &str) -> usize {
    // Without leaving early, so that many bytes are looked at in one step.
    let is_plain = text.bytes().fold(true, |is_plain, byte| is_plain & (byte.wrapping_sub(b' ') < 95));
    if is_plain { text.len() } else { text.width() }
}

/// The width of each column of some lines with equally many cells, as a terminal shows them.
pub(crate) fn widths<C: AsRef<str>, L: AsRef<[C]>>(lines: &[L]) -> Vec<usize> {
    let count = lines.first().map_or(0, |line| line.as_ref().len());
    let width = |column: usize| {
        lines
            .iter()
            .filter_map(|line| line.as_ref().get(column))
            .map(|cell| columns(cell.as_ref()))
            .max()
            .unwrap_or(0)
    };
    (0..count).map(width).collect()
}

/// Appends a line, its cells as far apart as their columns are wide; a wider cell moves the rest of the line. Nothing
/// stands behind the last text.
pub(crate) fn write_line<C: AsRef<str>>(cells: impl Iterator<Item = C>, widths: &[usize], text: &mut String) {
    let mut missing = 0;
    for (cell, &width) in cells.zip(widths) {
        let cell = cell.as_ref();
        if !cell.is_empty() {
            text.extend(std::iter::repeat_n(' ', missing));
            text.push_str(cell);
            missing = 0;
        }
        missing += width.saturating_sub(columns(cell)) + 2;
    }
    text.push('\n');
}
