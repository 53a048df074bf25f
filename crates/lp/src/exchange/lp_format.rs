//! CPLEX's LP format.

use std::fmt;

use super::rows::WrittenRow;
use super::written::{Written, WrittenColumn, put};
use crate::model::ObjectiveSense;

/// The longest line; CPLEX stops at 560 characters.
const LONGEST_LINE: usize = 500;

/// The program in LP format. All variables stand in the objective, so that every reader numbers them alike.
pub(super) fn write(text: &mut impl fmt::Write, program: &Written<'_>) -> fmt::Result {
    for remark in &program.remarks {
        writeln!(text, "\\ {remark}")?;
    }
    let sense = match program.sense {
        ObjectiveSense::Minimize => "Minimize",
        ObjectiveSense::Maximize => "Maximize",
    };
    let Written { objective, columns, .. } = program;
    let costs = columns.iter().enumerate();
    let costs = costs.map(|(place, column)| (objective.coefficient(place).unwrap_or("0"), column));
    let mut parts: Vec<Term<'_>> = terms(costs).collect();
    let [constant, _] = &program.constant;
    match constant.strip_prefix('-') {
        Some(size) => parts.push(["- ", size, "", ""]),
        None if parts.is_empty() => parts.push(["", constant, "", ""]),
        None if constant == "0" => {}
        None => parts.push(["+ ", constant, "", ""]),
    }
    put(text, &[sense, "\n ", objective.name, ": "])?;
    write_sum(text, &parts, separator(&parts, 0))?;
    writeln!(text, "\nSubject To")?;
    let mut parts = Vec::new();
    for row in program.rows.iter() {
        parts.clear();
        let used = row.coefficients();
        parts.extend(terms(used.filter_map(|(place, value)| Some((value, columns.get(place)?)))));
        if parts.is_empty() {
            parts.extend(terms(columns.iter().take(2).map(|column| ("0", column))));
        }
        write_row(text, &row, &parts)?;
    }
    if columns.iter().any(|column| column.lower.as_deref() != Some("0") || column.upper.is_some()) {
        writeln!(text, "Bounds")?;
    }
    columns.iter().try_for_each(|column| write_bounds(text, column))?;
    writeln!(text, "End")
}

fn write_row(text: &mut impl fmt::Write, row: &WrittenRow<'_>, parts: &[Term<'_>]) -> fmt::Result {
    // A row of no variables at all needs both sides to be told from a number.
    let (lower, upper) = (row.lower, row.upper);
    let side = |bound: Option<&str>| bound.map_or(0, str::len);
    let more = row.name.len() + side(lower.filter(|_| row.range.is_some())) + side(upper.or(lower));
    let space = separator(parts, more);
    put(text, &[" ", row.name, ": "])?;
    if parts.is_empty() {
        return writeln!(text, "{} <= 0 <= {}", lower.unwrap_or("-inf"), upper.unwrap_or("inf"));
    }
    let (relation, side) = match (lower, upper) {
        (Some(fixed), Some(_)) if row.range.is_none() => ("= ", fixed),
        (Some(lower), Some(upper)) => {
            put(text, &[lower, " <= "])?;
            ("<= ", upper)
        }
        (None, Some(upper)) => ("<= ", upper),
        (Some(lower), None) => (">= ", lower),
        (None, None) => (">= ", "-1e30"),
    };
    write_sum(text, parts, space)?;
    put(text, &[space, relation, side, "\n"])
}

/// The pieces of a term.
type Term<'a> = [&'a str; 4];

fn write_sum(text: &mut impl fmt::Write, parts: &[Term<'_>], space: &str) -> fmt::Result {
    parts.iter().enumerate().try_for_each(|(place, part)| {
        put(text, &[if place == 0 { "" } else { space }])?;
        put(text, part)
    })
}

/// Returns what separates the parts of a line: a line end, where they and so many more characters are too many for one.
fn separator(parts: &[Term<'_>], more: usize) -> &'static str {
    let length = more + parts.iter().flatten().map(|piece| piece.len()).sum::<usize>();
    if length > LONGEST_LINE { "\n  " } else { " " }
}

/// Terms with their signs.
fn terms<'a>(
    coefficients: impl Iterator<Item = (&'a str, &'a WrittenColumn)>,
) -> impl Iterator<Item = Term<'a>> {
    coefficients.enumerate().map(|(place, (value, column))| match value.strip_prefix('-') {
        Some(size) => ["- ", size, " ", &column.name],
        None if place == 0 => ["", value, " ", &column.name],
        None => ["+ ", value, " ", &column.name],
    })
}

fn write_bounds(text: &mut impl fmt::Write, column: &WrittenColumn) -> fmt::Result {
    let name = &column.name;
    match (column.lower.as_deref(), column.upper.as_deref()) {
        (None, None) => writeln!(text, " {name} free"),
        (Some("0"), None) => Ok(()),
        (Some(lower), None) => writeln!(text, " {name} >= {lower}"),
        (Some(lower), Some(upper)) if lower == upper => writeln!(text, " {name} = {lower}"),
        (lower, Some(upper)) => writeln!(text, " {} <= {name} <= {upper}", lower.unwrap_or("-inf")),
    }
}
