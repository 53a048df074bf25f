//! Columns of plain text under each other.

use unicode_width::UnicodeWidthStr;

/// The width of each column of some lines with equally many cells, as a terminal shows them.
pub(crate) fn widths<L: AsRef<[String]>>(lines: &[L]) -> Vec<usize> {
    let columns = lines.first().map_or(0, |line| line.as_ref().len());
    let width = |column: usize| {
        lines.iter().filter_map(|line| line.as_ref().get(column)).map(|cell| cell.width()).max().unwrap_or(0)
    };
    (0..columns).map(width).collect()
}

/// Appends a line, its cells as far apart as their columns are wide; a wider cell moves the rest of the line. Nothing
/// stands behind the last text.
pub(crate) fn write_line(cells: &[String], widths: &[usize], text: &mut String) {
    let mut missing = 0;
    for (cell, &width) in cells.iter().zip(widths) {
        if !cell.is_empty() {
            text.extend(std::iter::repeat_n(' ', missing));
            text.push_str(cell);
            missing = 0;
        }
        missing += width.saturating_sub(cell.width()) + 2;
    }
    text.push('\n');
}
