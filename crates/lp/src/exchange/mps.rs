//! Free-format MPS.

use std::fmt::Write;

use super::{ExchangeProgram, Sense};

/// The names of the columns.
const COLUMNS: [&str; 2] = ["theta1", "theta2"];

/// The program as free MPS. A maximum has to be asked for as the minimum of the opposite: not every reader knows OBJSENSE.
pub(super) fn write(text: &mut String, program: &ExchangeProgram<'_>) -> std::fmt::Result {
    for remark in program.remarks() {
        writeln!(text, "* {remark}")?;
    }
    writeln!(text, "NAME {}\nROWS\n N {}", program.name, program.objective_name)?;
    for row in program.rows {
        let sense = match row.sense {
            Sense::AtMost => 'L',
            Sense::AtLeast => 'G',
            Sense::Equal => 'E',
        };
        writeln!(text, " {sense} {}", row.name)?;
    }
    writeln!(text, "COLUMNS")?;
    let objective = program.objective();
    for (axis, column) in COLUMNS.into_iter().enumerate() {
        // Written even where it is 0: a column exists by being named here.
        for coefficient in objective.a.iter().skip(axis).take(1) {
            writeln!(text, " {column} {} {coefficient}", program.objective_name)?;
        }
        for row in program.rows {
            for coefficient in row.numbers.a.iter().skip(axis).take(1).filter(|a| *a != "0") {
                writeln!(text, " {column} {} {coefficient}", row.name)?;
            }
        }
    }
    writeln!(text, "RHS")?;
    for row in program.rows.iter().filter(|row| row.numbers.b != "0") {
        writeln!(text, " RHS {} {}", row.name, row.numbers.b)?;
    }
    writeln!(text, "BOUNDS")?;
    for column in COLUMNS {
        writeln!(text, " FR BOUND {column}")?;
    }
    writeln!(text, "ENDATA")
}
