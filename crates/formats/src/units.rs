//! Units in the names of columns.

use boundfit_exact::Foreign;

/// The unit in a cell of a row of units, with brackets around it or not.
pub(crate) fn unit_of_cell(cell: &str) -> Option<Foreign> {
    let cell = cell.trim();
    let bare = [('(', ')'), ('[', ']')]
        .into_iter()
        .find_map(|(open, close)| cell.strip_prefix(open)?.strip_suffix(close))
        .unwrap_or(cell)
        .trim();
    (!bare.is_empty()).then(|| bare.into())
}
