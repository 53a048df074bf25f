//! Words in messages.

use boundfit_exact::Foreign;
use boundfit_exact::english::counted;

use crate::row_range::RowRange;

/// The most names that a message lists.
const MOST_NAMES: usize = 10;

/// A number of things in words.
pub(super) fn count(count: u64, [one, many]: [&str; 2]) -> String {
    counted(usize::try_from(count).unwrap_or(usize::MAX), one, many)
}

/// Returns the first of some names in quotes, and the number of the rest.
pub(super) fn first_names(names: &[Foreign]) -> String {
    let mut first: Vec<String> = names.iter().take(MOST_NAMES).map(Foreign::quoted).collect();
    if names.len() > MOST_NAMES {
        first.push(format!("{} more", names.len() - MOST_NAMES));
    }
    first.join(", ")
}

/// Returns words for the other sheets of a workbook.
pub(super) fn other_sheets(sheets: &[Foreign]) -> String {
    match sheets {
        [] => String::new(),
        [only] => format!("; the other one is {}", only.quoted()),
        sheets => format!("; the others are {}", first_names(sheets)),
    }
}

/// `row 5 was`, `rows 14..36 were`.
pub(super) fn named(rows: RowRange) -> String {
    let is_one = rows.to_string().bytes().all(|byte| byte.is_ascii_digit());
    if is_one { format!("row {rows} was") } else { format!("rows {rows} were") }
}

/// Returns words for the conditions that a wanted row satisfies.
pub(super) fn wanted_by(conditions: &[Foreign]) -> String {
    match conditions {
        [] => "is left".to_owned(),
        conditions => {
            let conditions: Vec<String> = conditions.iter().map(Foreign::to_string).collect();
            format!("satisfies {}", conditions.join(" and "))
        }
    }
}

/// Returns words for the other rows without a value.
pub(super) fn others_missing(rows: usize, is_complete: bool) -> String {
    let up_to_there = if is_complete { "" } else { " at least" };
    match rows.saturating_sub(1) {
        0 if is_complete => ", in this row only".to_owned(),
        0 => String::new(),
        others => format!(", and in{up_to_there} {} more", counted(others, "row", "rows")),
    }
}

/// `2 rows were announced and `, where a number was.
pub(super) fn announced(rows: Option<usize>) -> String {
    rows.map(|rows| format!("{rows} rows were announced and ")).unwrap_or_default()
}
