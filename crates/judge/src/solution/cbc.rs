//! CBC and CLP: what `solution FILE` writes, a list of variables after the status. Long lists leave values of at most 10⁻⁸ out, whatever their
//! prices. Rows are there if asked for (`printingOptions rows` or `all`), before the columns and counted from 0 as they are.
//!
//! Source: CBC user guide, "solution"; `CbcSolver.cpp` and `ClpMain.cpp`: `%15.8g`, the objective in CBC 2 as `%.8f`.

use boundfit_exact::{Limits, Rational};
use boundfit_lp::NumberFormat;

use super::error::SolutionError;
use super::line::Line;
use super::{SolutionFile, SolverStatus};

const CBC: &str = "CBC";
const CLP: &str = "CLP";
const DIGITS: NumberFormat = NumberFormat::EIGHT;
/// The common format of `%15.8g` and `%.8f`.
const OBJECTIVE: NumberFormat = NumberFormat::DownTo { place: -8, most: 8 };

/// Returns whether a text is a solution of CBC: its first line is `STATUS - objective value NUMBER`.
pub(super) fn is_cbc(text: &str) -> bool {
    text.lines().next().is_some_and(|line| line.contains(" - objective value "))
}

/// Returns whether a text is a solution of CLP: the second line is `Objective value NUMBER`.
pub(super) fn is_clp(text: &str) -> bool {
    text.lines().nth(1).is_some_and(|line| line.starts_with("Objective value "))
}

pub(super) fn parse_cbc(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let mut lines = Line::all(CBC, text);
    let (mut status, mut objective) = ("", None);
    if let Some(line) = lines.next() {
        let (words, value) = line.text.split_once(" - objective value ").unwrap_or((line.text, ""));
        status = words;
        // The words behind the number are about how it was found.
        if let Some(value) = value.split_whitespace().next() {
            objective = Some((line.figure(value, OBJECTIVE, limits)?, line.number));
        }
    }
    let file = SolutionFile { status: SolverStatus::of_words(status), objective, ..SolutionFile::new(CBC) };
    entries(file, lines, limits)
}

pub(super) fn parse_clp(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let mut lines = Line::all(CLP, text);
    let mut file = SolutionFile::new(CLP);
    for line in lines.by_ref().take(2) {
        match line.words().as_slice() {
            ["Objective", "value", value] => {
                file.objective = Some((line.figure(value, OBJECTIVE, limits)?, line.number));
            }
            _ if line.number == 1 => file.status = SolverStatus::of_words(line.text),
            _ => return Err(line.expected("\"Objective value NUMBER\"")),
        }
    }
    entries(file, lines, limits)
}

/// Reads the list. Where the numbers start again from below, what came before are rows.
fn entries<'a>(
    mut file: SolutionFile,
    lines: impl Iterator<Item = Line<'a>>,
    limits: &Limits,
) -> Result<SolutionFile, SolutionError> {
    file.left_out = Some(Rational::scientific(1, -8));
    let mut last = None;
    for line in lines {
        let mut words = line.words();
        // CBC marks values outside their bounds.
        words.retain(|word| *word != "**");
        match words.as_slice() {
            [] => {}
            [index, name, value, price] => {
                let index = index.parse::<usize>().ok();
                if index.is_some() && index <= last && file.rows.is_empty() {
                    file.rows = std::mem::take(&mut file.columns);
                    file.has_duals = true;
                }
                last = index;
                file.columns.push(line.entry(
                    *name,
                    Some(line.figure(value, DIGITS, limits)?),
                    Some(line.figure(price, DIGITS, limits)?),
                ));
            }
            _ => return Err(line.expected("\"INDEX NAME VALUE DUAL\"")),
        }
    }
    Ok(file)
}
