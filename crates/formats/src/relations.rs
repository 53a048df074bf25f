//! Cells beside the numbers of half-planes: a row with a relation other than `<=` would be read as another half-plane.

use boundfit_exact::Foreign;

use crate::columns::ColumnPlace;
use crate::error::{InputError, InputErrorKind};

/// Returns whether a cell is a relation of two numbers.
pub(crate) fn is_relation(cell: &[u8]) -> bool {
    const SIGNS: [&str; 10] = ["<=", ">=", "=", "<", ">", "==", "=<", "=>", "\u{2264}", "\u{2265}"];
    const WORDS: [&str; 7] = ["le", "leq", "ge", "geq", "eq", "lt", "gt"];
    is_one_of(&SIGNS, cell) || is_one_of(&WORDS, cell)
}

/// Returns whether a cell is a relation by the letters of MPS: L, G and E may be labels in a column of another name.
fn is_letter_of_relation(place: &ColumnPlace, cell: &[u8]) -> bool {
    const NAMES: [&str; 8] = ["sense", "relation", "rel", "sign", "op", "operator", "type", "direction"];
    let is_named = |name: &Foreign| is_one_of(&NAMES, name.raw().as_bytes());
    place.name.as_ref().is_some_and(is_named) && is_one_of(&["l", "g", "e"], cell)
}

fn is_one_of(words: &[&str], cell: &[u8]) -> bool {
    words.iter().any(|word| word.as_bytes().eq_ignore_ascii_case(cell.trim_ascii()))
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
    let problem = if is_relation(cell) || is_letter_of_relation(place, cell) {
        InputErrorKind::Relation
    } else if !is_asked && place.name.is_none() && !cell.trim_ascii().is_empty() {
        InputErrorKind::BesideHalfPlane
    } else {
        return Ok(());
    };
    Err(place.error(file, line, cell, problem))
}
