//! CBC and SCIP: lists of variables after a line with the status. Both leave out what is 0.
//!
//! Sources: CBC user guide, "solution"; SCIP, `write solution`.

use boundfit_exact::Limits;

use super::error::ClaimError;
use super::solution::{Line, PrintedPoint, Solution, Status};

const CBC: &str = "CBC";
const SCIP: &str = "SCIP";

/// Whether a text is a solution of CBC: its first line is `STATUS - objective value NUMBER`.
pub(super) fn is_cbc(text: &str) -> bool {
    text.lines().next().is_some_and(|line| line.contains(" - objective value "))
}

/// Whether a text is a solution of SCIP.
pub(super) fn is_scip(text: &str) -> bool {
    text.starts_with("solution status:") || text.starts_with("objective value:")
}

/// Reads a solution of CBC.
pub(super) fn parse_cbc(text: &str, limits: &Limits) -> Result<Solution, ClaimError> {
    let words = text.split(" - objective value ").next().unwrap_or_default();
    let status = Status::of_words(words);
    let mut point = PrintedPoint::default();
    for line in Line::all(CBC, text).skip(1) {
        let mut words = line.words();
        // What is outside its bounds.
        words.retain(|word| *word != "**");
        match words.as_slice() {
            [] => {}
            [_, name, value, _] => point.set(name, line.number(value, limits)?),
            _ => return Err(line.expected("\"INDEX NAME VALUE DUAL\"")),
        }
    }
    finish(CBC, status, point)
}

/// Reads a solution of SCIP.
pub(super) fn parse_scip(text: &str, limits: &Limits) -> Result<Solution, ClaimError> {
    let (mut status, mut point) = (Status::Other("not in the file".to_owned()), PrintedPoint::default());
    for line in Line::all(SCIP, text) {
        match line.words().as_slice() {
            [] | ["objective", "value:", _] | ["no", "solution", "available"] => {}
            ["solution", "status:", ..] => {
                let words = line.text.split_once(':').map_or("", |(_, words)| words);
                status = Status::of_words(words);
            }
            [name, value, rest @ ..] if rest.len() <= 1 => point.set(name, line.number(value, limits)?),
            _ => return Err(line.expected("\"NAME VALUE (obj:NUMBER)\"")),
        }
    }
    finish(SCIP, status, point)
}

fn finish(format: &'static str, status: Status, point: PrintedPoint) -> Result<Solution, ClaimError> {
    let point = match status {
        Status::Optimal => point.or_zero().finish().map_err(|missing| ClaimError::End { format, missing })?,
        _ => None,
    };
    Ok(Solution { format, target: None, status, point, duals: None })
}
