//! SCIP: what `write solution` writes, a list of variables after a line with the status. Zeros are left out.
//! Files that a program writes for its best point lack that line. Their values claim to be optimal, as those of Gurobi do.
//!
//! Source: SCIP, `SCIPprintSol`, numbers as `%20.15g`, none below `numerics/epsilon` (10⁻⁹).

use boundfit_exact::{Limits, Rational};
use boundfit_lp::NumberFormat;

use super::error::SolutionError;
use super::line::Line;
use super::{SolutionFile, SolverStatus};

const SCIP: &str = "SCIP";
const DIGITS: NumberFormat = NumberFormat::FIFTEEN;

pub(super) fn is_scip(text: &str) -> bool {
    text.starts_with("solution status:") || text.starts_with("objective value:")
}

pub(super) fn parse(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let mut file = SolutionFile { left_out: Some(Rational::scientific(1, -9)), ..SolutionFile::new(SCIP) };
    let mut says_status = false;
    for line in Line::all(SCIP, text) {
        match line.words().as_slice() {
            [] | ["no", "solution", "available"] => {}
            ["objective", "value:", value] => {
                file.objective = Some((line.figure(value, DIGITS, limits)?, line.number));
            }
            ["solution", "status:", ..] => {
                let words = line.text.split_once(':').map_or("", |(_, words)| words);
                (file.status, file.status_line) = (SolverStatus::of_words(words), line.number);
                says_status = true;
            }
            [name, value, rest @ ..] if rest.len() <= 1 => {
                file.columns.push(line.entry(*name, Some(line.figure(value, DIGITS, limits)?), None));
            }
            _ => return Err(line.expected("\"NAME VALUE (obj:NUMBER)\"")),
        }
    }
    if !says_status && (file.objective.is_some() || !file.columns.is_empty()) {
        file.status = SolverStatus::Optimal;
    }
    Ok(file)
}
