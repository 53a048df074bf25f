//! CPLEX's LP format.

use std::fmt::Write;

use super::written::{Written, WrittenColumn, WrittenRow};
use crate::model::ObjectiveSense;

/// The longest line; CPLEX stops at 560 characters.
const LONGEST_LINE: usize = 500;

/// The program in LP format. All variables stand in the objective, so that every reader numbers them alike.
pub(super) fn write(text: &mut String, program: &Written<'_>) -> std::fmt::Result {
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
    let mut parts = terms(costs);
    let [constant, _] = &program.constant;
    match constant.strip_prefix('-') {
        Some(size) => parts.push(format!("- {size}")),
        None if parts.is_empty() => parts.push(constant.clone()),
        None if constant == "0" => {}
        None => parts.push(format!("+ {constant}")),
    }
    writeln!(text, "{sense}\n {}: {}\nSubject To", objective.name, parts.join(separator(&parts, 0)))?;
    program.rows.iter().try_for_each(|row| write_row(text, row, columns))?;
    if columns.iter().any(|column| column.lower.as_deref() != Some("0") || column.upper.is_some()) {
        writeln!(text, "Bounds")?;
    }
    columns.iter().try_for_each(|column| write_bounds(text, column))?;
    writeln!(text, "End")
}

fn write_row(text: &mut String, row: &WrittenRow, columns: &[WrittenColumn]) -> std::fmt::Result {
    let used = row.coefficients.iter();
    let mut parts = terms(used.filter_map(|(place, value)| Some((value.as_str(), columns.get(*place)?))));
    if parts.is_empty() {
        parts = terms(columns.iter().take(2).map(|column| ("0", column)));
    }
    // A row of no variables at all needs both sides to be told from a number.
    let (lower, upper) = (row.lower.as_deref(), row.upper.as_deref());
    let side = |bound: Option<&str>| bound.map_or(0, str::len);
    let space = separator(
        &parts,
        row.name.len() + side(lower.filter(|_| row.range.is_some())) + side(upper.or(lower)),
    );
    let form = parts.join(space);
    match (lower, upper) {
        _ if parts.is_empty() => {
            writeln!(text, " {}: {} <= 0 <= {}", row.name, lower.unwrap_or("-inf"), upper.unwrap_or("inf"))
        }
        (Some(fixed), Some(_)) if row.range.is_none() => {
            writeln!(text, " {}: {form}{space}= {fixed}", row.name)
        }
        (Some(lower), Some(upper)) => writeln!(text, " {}: {lower} <= {form}{space}<= {upper}", row.name),
        (None, Some(upper)) => writeln!(text, " {}: {form}{space}<= {upper}", row.name),
        (Some(lower), None) => writeln!(text, " {}: {form}{space}>= {lower}", row.name),
        (None, None) => writeln!(text, " {}: {form}{space}>= -1e30", row.name),
    }
}

/// What separates the parts of a line: a line end, where they and so many more characters are too many for one.
fn separator(parts: &[String], more: usize) -> &'static str {
    let length = more + parts.iter().map(String::len).sum::<usize>();
    if length > LONGEST_LINE { "\n  " } else { " " }
}

/// Terms with their signs.
fn terms<'a>(coefficients: impl Iterator<Item = (&'a str, &'a WrittenColumn)>) -> Vec<String> {
    let term = |(place, (value, column)): (usize, (&str, &WrittenColumn))| match value.strip_prefix('-') {
        Some(size) => format!("- {size} {}", column.name),
        None if place == 0 => format!("{value} {}", column.name),
        None => format!("+ {value} {}", column.name),
    };
    coefficients.enumerate().map(term).collect()
}

fn write_bounds(text: &mut String, column: &WrittenColumn) -> std::fmt::Result {
    let name = &column.name;
    match (column.lower.as_deref(), column.upper.as_deref()) {
        (None, None) => writeln!(text, " {name} free"),
        (Some("0"), None) => Ok(()),
        (Some(lower), None) => writeln!(text, " {name} >= {lower}"),
        (Some(lower), Some(upper)) if lower == upper => writeln!(text, " {name} = {lower}"),
        (lower, Some(upper)) => writeln!(text, " {} <= {name} <= {upper}", lower.unwrap_or("-inf")),
    }
}
