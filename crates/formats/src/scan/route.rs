//! The way through each row to the cells that are wanted.

use memchr::memchr2;

use super::layout::Layout;
use crate::columns::Role;

/// Separators that are no part of a number.
const SEPARATORS: &[u8] = b",;\t|:";

/// The way through a row.
pub(super) struct Route {
    /// The way to the cells that conditions on rows are about.
    pub(super) conditions: Vec<Step>,
    /// The way to those whose contents are wanted.
    pub(super) steps: Vec<Step>,
    /// The number of cells after the last of these.
    pub(super) behind: usize,
    /// `true` if a row needs a number in one of the columns that may lack one.
    pub(super) wants_presence: bool,
}

/// A cell that is wanted.
pub(super) struct Step {
    /// The number of separators since the cell before; `None` for the same cell again.
    pub(super) separators: Option<usize>,
    pub(super) what: What,
}

/// The use of a cell.
#[derive(Clone, Copy)]
pub(super) enum What {
    /// A number of a column, which may have to be at least 0.
    Number { column: usize, non_negative: bool },
    /// The presence of a column's number.
    Presence { column: usize },
    /// A cell that a column takes for another purpose.
    Aside { column: usize },
    /// The key.
    Key,
    /// The condition on rows with this number, from 0.
    Condition(usize),
}

impl Route {
    /// Returns the route through the rows of a table. It returns `None` when the fast lane cannot tell
    /// numbers from separators, reads numbers beyond the limits, or would pass over rows that are kept.
    pub(super) fn new(layout: &Layout) -> Option<Self> {
        let table = &layout.options.table;
        if !SEPARATORS.contains(&layout.syntax.delimiter)
            || !layout.numbers.plain
            || !table.missing_as.is_empty()
            || (table.keep_others && table.selects_rows())
            || table.keep_cells
            || layout.looks_beside()
        {
            return None;
        }
        let numbers = layout.places.iter().zip(layout.selectors).enumerate();
        let numbers = numbers.map(|(column, (place, selector))| {
            let what = match selector.role() {
                Role::Number | Role::NonNegative | Role::Optional => {
                    What::Number { column, non_negative: selector.is_non_negative() }
                }
                Role::Presence => What::Presence { column },
                Role::HalfUnit => What::Aside { column },
            };
            (place.position, what)
        });
        let key = layout.key.iter().map(|place| (place.position, What::Key));
        let conditions = layout.conditions.iter().enumerate();
        let conditions = conditions.map(|(index, (place, _))| (place.position, What::Condition(index)));
        let cells: Vec<(usize, What)> = numbers.chain(key).collect();
        let last = cells.iter().map(|(position, _)| *position).max();
        let (conditions, steps) = (way(conditions.collect()), way(cells));
        let behind = layout.shape.width - last.unwrap_or(1);
        Some(Route { conditions, steps, behind, wants_presence: layout.wants_presence() })
    }
}

/// The way through a row to these cells.
fn way(mut cells: Vec<(usize, What)>) -> Vec<Step> {
    cells.sort_by_key(|(position, _)| *position);
    let mut last = None;
    let step = |(position, what): (usize, What)| {
        let separators = match last.replace(position) {
            None => Some(position - 1),
            Some(last) => (position > last).then(|| position - last),
        };
        Step { separators, what }
    };
    cells.into_iter().map(step).collect()
}

/// The place of the first delimiter or line feed of a text, if there is one. Most cells are short: to look at the words of a cell takes
/// fewer instructions than to call [`memchr2`].
#[inline(always)]
pub(super) fn first_end(text: &[u8], delimiter: u8) -> Option<usize> {
    let (words, _) = text.first_chunk::<16>().map(|start| start.as_chunks()).unwrap_or_default();
    for (place, word) in words.iter().enumerate() {
        let word = u64::from_le_bytes(*word);
        let ends = bytes_that_are(word, delimiter) | bytes_that_are(word, b'\n');
        if ends != 0 {
            return Some(8 * place + (ends.trailing_zeros() / 8) as usize);
        }
    }
    memchr2(delimiter, b'\n', text)
}

/// The high bits of the bytes of a word that are this byte; higher than the lowest of them there may be more.
#[inline(always)]
fn bytes_that_are(word: u64, byte: u8) -> u64 {
    const LOWEST: u64 = 0x0101_0101_0101_0101;
    const HIGHEST: u64 = 0x8080_8080_8080_8080;
    // A borrow leaves only a byte that was 0.
    let differences = word ^ LOWEST.wrapping_mul(byte.into());
    differences.wrapping_sub(LOWEST) & !differences & HIGHEST
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bytes beside the delimiter and the line feed, and bytes above 127, at every distance from the end.
    #[test]
    fn a_cell_ends_at_the_first_delimiter_or_line_feed() {
        let others = [b'-', b'9', b' ', b'\t', b';', b'+', 0, 1, 9, 11, 43, 45, 128, 138, 172, 255];
        for length in 0..40 {
            for seed in 0..64_usize {
                let byte =
                    |place: usize| others[(place * 7 + seed * 11 + place * place * seed) % others.len()];
                let mut text: Vec<u8> = (0..length).map(byte).collect();
                assert_eq!(first_end(&text, b','), None, "{text:?}");
                text.push([b',', b'\n'][seed % 2]);
                text.extend((0..seed % 20).map(|place| [b',', b'\n', b'-'][place % 3]));
                assert_eq!(first_end(&text, b','), Some(length), "{text:?}");
            }
        }
    }
}
