//! HiGHS: what `--solution_file FILE` writes, in its raw style and in its table for people.
//!
//! Source: HiGHS documentation, "Solution file format". Its other styles are those of GLPK.

use boundfit_exact::Limits;

use super::error::ClaimError;
use super::solution::{Line, PrintedPoint, Solution, Status};

const FORMAT: &str = "HiGHS";

/// Whether a text is a solution in raw style.
pub(super) fn is_raw(text: &str) -> bool {
    text.lines().find(|line| !line.trim().is_empty()).is_some_and(|line| line.trim() == "Model status")
}

/// Whether a text is a table for people.
pub(super) fn is_table(text: &str) -> bool {
    let mut lines = text.lines();
    lines.next().is_some_and(|line| line.trim() == "Columns")
        && lines.next().is_some_and(|line| line.split_whitespace().take(2).eq(["Index", "Status"]))
}

/// What a line of the raw style belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Section {
    Status,
    Primal,
    Dual,
    Basis,
}

/// Reads a solution in raw style.
pub(super) fn parse_raw(text: &str, limits: &Limits) -> Result<Solution, ClaimError> {
    let mut section = Section::Status;
    let (mut status, mut is_primal_there, mut are_rows) = (None, false, false);
    let (mut point, mut duals) = (PrintedPoint::default(), None);
    for line in Line::all(FORMAT, text) {
        let words = line.words();
        match (section, words.as_slice()) {
            (_, []) | (Section::Status, ["Model", "status"]) => {}
            (_, ["#", "Primal", ..]) => section = Section::Primal,
            (_, ["#", "Dual", ..]) => section = Section::Dual,
            (_, ["#", "Basis"]) => section = Section::Basis,
            (Section::Basis, _) => break,
            (_, ["#", "Columns", _]) => are_rows = false,
            (_, ["#", "Rows", _]) => {
                are_rows = true;
                if section == Section::Dual {
                    duals = Some(Vec::new());
                }
            }
            (Section::Status, _) if status.is_none() => status = Some(raw_status(line.text)),
            (Section::Primal, ["None" | "Feasible" | "Infeasible"]) => is_primal_there = words != ["None"],
            (Section::Dual, ["None" | "Feasible" | "Infeasible"]) | (Section::Primal, ["Objective", _]) => {}
            (Section::Primal, [name, value]) => {
                let value = line.number(value, limits)?;
                if !are_rows {
                    point.set(name, value);
                }
            }
            (Section::Dual, [_, value]) => {
                let value = line.dual(value, limits)?;
                if let Some(duals) = duals.as_mut().filter(|_| are_rows) {
                    duals.push(value);
                }
            }
            (Section::Status, _) => return Err(line.expected("\"# Primal solution values\"")),
            (Section::Primal | Section::Dual, _) => return Err(line.expected("\"NAME VALUE\"")),
        }
    }
    let missing = |missing| ClaimError::End { format: FORMAT, missing };
    let status = status.ok_or(missing("a status"))?;
    if section == Section::Status {
        return Err(missing("\"# Primal solution values\""));
    }
    finish(status, point, duals, is_primal_there)
}

fn raw_status(words: &str) -> Status {
    match words.trim() {
        "Primal infeasible or unbounded" => Status::InfeasibleOrUnbounded,
        other => Status::of_words(other),
    }
}

fn finish(
    status: Status,
    point: PrintedPoint,
    duals: Option<Vec<f64>>,
    is_there: bool,
) -> Result<Solution, ClaimError> {
    let missing = |missing| ClaimError::End { format: FORMAT, missing };
    if status != Status::Optimal {
        return Ok(Solution { format: FORMAT, target: None, status, point: None, duals: None });
    }
    if !is_there {
        return Err(missing("the values of an optimum"));
    }
    let point = point.finish().map_err(missing)?;
    Ok(Solution { format: FORMAT, target: None, status, point, duals })
}

/// Reads a table for people.
pub(super) fn parse_table(text: &str, limits: &Limits) -> Result<Solution, ClaimError> {
    let (mut are_rows, mut status) = (false, None);
    let (mut point, mut duals) = (PrintedPoint::default(), Vec::new());
    let mut has_values = true;
    for line in Line::all(FORMAT, text) {
        match line.words().as_slice() {
            [] | ["Columns"] | ["Objective", "value:", _] => {}
            ["Rows"] => are_rows = true,
            ["Index", "Status", ..] => {
                has_values = line.text.contains("Primal") && line.text.contains("Dual");
            }
            ["Model", "status:", ..] => {
                status = line.text.split_once(':').map(|(_, words)| raw_status(words));
            }
            [_, "LB" | "UB" | "FX" | "BS" | "FR" | "NB" | "ZE" | "SB", _, _, value, dual, name]
                if has_values =>
            {
                let value = line.number(value, limits)?;
                if are_rows {
                    duals.push(line.dual(dual, limits)?);
                } else {
                    point.set(name, value);
                }
            }
            _ if !has_values => {}
            ["Model" | "Total" | "Number" | "Primal" | "Dual", ..] => {}
            _ => return Err(line.expected("\"INDEX STATUS LOWER UPPER PRIMAL DUAL NAME\"")),
        }
    }
    let status = status.ok_or(ClaimError::End { format: FORMAT, missing: "a line \"Model status:\"" })?;
    finish(status, point, Some(duals), has_values)
}
