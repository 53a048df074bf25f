//! Rows of what is not text, as text.

use boundfit_exact::Foreign;

/// Cells, not all of them empty, as a line of CSV, without its end.
pub(crate) fn csv_line(cells: impl IntoIterator<Item = String>) -> Vec<u8> {
    // A line that begins with a mark of comments would be one.
    let quoted = |cell: String| match cell.contains([',', '"', '\r', '\n']) || cell.starts_with(['#', '%']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell,
    };
    cells.into_iter().map(quoted).collect::<Vec<_>>().join(",").into_bytes()
}

/// Returns each of the columns with these titles once, however often it is asked for.
pub(crate) fn each_once<'a, T>(
    columns: impl IntoIterator<Item = T> + 'a,
    titles: &'a [Foreign],
) -> impl Iterator<Item = T> + 'a {
    let is_first =
        |position: usize, title: &Foreign| !titles.iter().take(position).any(|other| other == title);
    let columns = columns.into_iter().zip(titles).enumerate();
    columns.filter_map(move |(position, (column, title))| is_first(position, title).then_some(column))
}
