//! The way through each row to the cells that are wanted.

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
