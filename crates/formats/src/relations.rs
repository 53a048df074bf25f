//! Cells beside the numbers of half-planes: a row with a relation other than `<=` would be read as another half-plane.

use crate::columns::ColumnPlace;
use crate::error::{InputError, InputErrorKind};

/// Returns whether a cell is a relation of two numbers.
pub(crate) fn is_relation(cell: &[u8]) -> bool {
    const RELATIONS: [&str; 10] = ["<=", ">=", "=", "<", ">", "==", "=<", "=>", "\u{2264}", "\u{2265}"];
    RELATIONS.iter().any(|relation| relation.as_bytes() == cell.trim_ascii())
}

/// Refuses a relation, and a cell of a column that is none of a1, a2 and b and has no name.
///
/// # Errors
/// The place of the cell.
pub(crate) fn refuse_beside(
    file: &str,
    place: &ColumnPlace,
    line: u64,
    cell: &[u8],
    is_asked: bool,
) -> Result<(), InputError> {
    let problem = if is_relation(cell) {
        InputErrorKind::Relation
    } else if !is_asked && place.name.is_none() && !cell.trim_ascii().is_empty() {
        InputErrorKind::BesideHalfPlane
    } else {
        return Ok(());
    };
    Err(place.error(file, line, cell, problem))
}
