//! Rows of what is not text, as text.

/// Cells, none of them empty, as a line of CSV, without its end.
pub(crate) fn csv_line(cells: &[String]) -> Vec<u8> {
    let quoted = |cell: &String| match cell.contains([',', '"', '\r', '\n']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell.clone(),
    };
    cells.iter().map(quoted).collect::<Vec<_>>().join(",").into_bytes()
}
