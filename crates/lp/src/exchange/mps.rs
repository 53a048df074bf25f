//! Free-format MPS.

use std::fmt;

use super::rows::{WrittenRow, WrittenRows};
use super::written::{Written, WrittenColumn, put};
use crate::model::ObjectiveSense;

/// The number that every reader takes for infinity.
const INFINITY: &str = "1e30";

/// The program as free MPS, with the sections that it needs: not every reader knows OBJSENSE.
pub(super) fn write(text: &mut impl fmt::Write, program: &Written<'_>) -> fmt::Result {
    for remark in &program.remarks {
        writeln!(text, "* {remark}")?;
    }
    let objective = &program.objective;
    writeln!(text, "{}", format!("NAME {}", program.name).trim_end())?;
    if program.sense == ObjectiveSense::Maximize {
        writeln!(text, "OBJSENSE\n    MAX")?;
    }
    writeln!(text, "ROWS\n N {}", objective.name)?;
    for row in program.rows.iter() {
        put(text, &[kind(&row), row.name, "\n"])?;
    }
    writeln!(text, "COLUMNS")?;
    write_columns(text, program)?;
    writeln!(text, "RHS")?;
    let [_, opposite] = &program.constant;
    if opposite != "0" {
        writeln!(text, " RHS {} {opposite}", objective.name)?;
    }
    for row in program.rows.iter() {
        match row.lower.or(row.upper) {
            Some("0") => {}
            Some(side) => put(text, &[" RHS ", row.name, " ", side, "\n"])?,
            None => put(text, &[" RHS ", row.name, " -", INFINITY, "\n"])?,
        }
    }
    if program.rows.has_ranges() {
        writeln!(text, "RANGES")?;
        for row in program.rows.iter() {
            row.range.iter().try_for_each(|range| put(text, &[" RANGE ", row.name, " ", range, "\n"]))?;
        }
    }
    writeln!(text, "BOUNDS")?;
    program.columns.iter().try_for_each(|column| write_bounds(text, column))?;
    writeln!(text, "ENDATA")
}

/// Each column with its coefficients, first that in the objective, which is written even where it is 0: a column exists by being
/// named here.
fn write_columns(text: &mut impl fmt::Write, program: &Written<'_>) -> fmt::Result {
    /// The number of columns up to which all rows are searched, which takes no memory.
    const FEW: usize = 2;
    let is_many = program.columns.len() > FEW;
    let mut entries = if is_many { by_column(program.rows, program.columns.len()) } else { Vec::new() };
    entries.resize_with(program.columns.len(), Vec::new);
    for (place, (WrittenColumn { name, .. }, entries)) in program.columns.iter().zip(&entries).enumerate() {
        let objective = &program.objective;
        let mut write =
            |row: &str, coefficient: &str| put(text, &[" ", name, " ", row, " ", coefficient, "\n"]);
        write(objective.name, objective.coefficient(place).unwrap_or("0"))?;
        entries.iter().try_for_each(|(row, coefficient)| write(row, coefficient))?;
        if !is_many {
            let mut found = program.rows.iter().filter_map(|row| Some((row.name, row.coefficient(place)?)));
            found.try_for_each(|(row, coefficient)| write(row, coefficient))?;
        }
    }
    Ok(())
}

/// Returns, for each column, the names of the rows that have it, with its coefficients there.
fn by_column(rows: &WrittenRows, columns: usize) -> Vec<Vec<(&str, &str)>> {
    let mut entries = vec![Vec::new(); columns];
    for row in rows.iter() {
        for (place, coefficient) in row.coefficients() {
            entries.iter_mut().skip(place).take(1).for_each(|column| column.push((row.name, coefficient)));
        }
    }
    entries
}

/// The type of a row. One with two bounds is at least the lower one, with a range; one without any is at least −∞.
fn kind(row: &WrittenRow<'_>) -> &'static str {
    match (row.lower, row.upper) {
        _ if row.fixed().is_some() => " E ",
        (None, Some(_)) => " L ",
        _ => " G ",
    }
}

fn write_bounds(text: &mut impl fmt::Write, column: &WrittenColumn) -> fmt::Result {
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
