//! Free-format MPS.

use std::fmt::Write;

use super::written::{Written, WrittenColumn, WrittenRow};
use crate::model::ObjectiveSense;

/// What every reader takes for infinity.
const INFINITY: &str = "1e30";

/// The program as free MPS, with the sections that it needs: not every reader knows OBJSENSE.
pub(super) fn write(text: &mut String, program: &Written<'_>) -> std::fmt::Result {
    for remark in &program.remarks {
        writeln!(text, "* {remark}")?;
    }
    let objective = program.objective;
    writeln!(text, "{}", format!("NAME {}", program.name).trim_end())?;
    if program.sense == ObjectiveSense::Maximize {
        writeln!(text, "OBJSENSE\n    MAX")?;
    }
    writeln!(text, "ROWS\n N {}", objective.name)?;
    for row in &program.rows {
        writeln!(text, " {} {}", kind(row), row.name)?;
    }
    writeln!(text, "COLUMNS")?;
    let mut entries: Vec<Vec<(&str, &str)>> = vec![Vec::new(); program.columns.len()];
    for row in &program.rows {
        for (place, coefficient) in &row.coefficients {
            entries.iter_mut().skip(*place).take(1).for_each(|column| column.push((&row.name, coefficient)));
        }
    }
    for (place, (WrittenColumn { name, .. }, entries)) in program.columns.iter().zip(entries).enumerate() {
        // Written even where it is 0: a column exists by being named here.
        writeln!(text, " {name} {} {}", objective.name, objective.coefficient(place).unwrap_or("0"))?;
        for (row, coefficient) in entries {
            writeln!(text, " {name} {row} {coefficient}")?;
        }
    }
    writeln!(text, "RHS")?;
    let [_, opposite] = &program.constant;
    if opposite != "0" {
        writeln!(text, " RHS {} {opposite}", objective.name)?;
    }
    for row in &program.rows {
        match row.lower.as_ref().or(row.upper.as_ref()) {
            Some(side) if side == "0" => {}
            Some(side) => writeln!(text, " RHS {} {side}", row.name)?,
            None => writeln!(text, " RHS {} -{INFINITY}", row.name)?,
        }
    }
    if program.rows.iter().any(|row| row.range.is_some()) {
        writeln!(text, "RANGES")?;
    }
    for row in &program.rows {
        row.range.iter().try_for_each(|range| writeln!(text, " RANGE {} {range}", row.name))?;
    }
    writeln!(text, "BOUNDS")?;
    program.columns.iter().try_for_each(|column| write_bounds(text, column))?;
    writeln!(text, "ENDATA")
}

/// The type of a row. One with two bounds is at least the lower one, with a range; one without any is at least −∞.
fn kind(row: &WrittenRow) -> char {
    match (&row.lower, &row.upper) {
        _ if row.fixed().is_some() => 'E',
        (None, Some(_)) => 'L',
        _ => 'G',
    }
}

fn write_bounds(text: &mut String, column: &WrittenColumn) -> std::fmt::Result {
    let name = &column.name;
    match (column.lower.as_deref(), column.upper.as_deref()) {
        (None, None) => writeln!(text, " FR BOUND {name}"),
        (None, Some(upper)) => writeln!(text, " MI BOUND {name}\n UP BOUND {name} {upper}"),
        (Some("0"), None) => Ok(()),
        (Some(lower), None) => writeln!(text, " LO BOUND {name} {lower}"),
        (Some(lower), Some(upper)) if lower == upper => writeln!(text, " FX BOUND {name} {lower}"),
        // Under a negative upper bound the lower one is not 0 unless it is said.
        (Some(lower), Some(upper)) => writeln!(text, " LO BOUND {name} {lower}\n UP BOUND {name} {upper}"),
    }
}
