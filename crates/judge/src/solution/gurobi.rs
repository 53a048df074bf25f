//! Gurobi and MIPLIB: `NAME VALUE` lines, and the objective on a line of its own. Zeros may be left out.
//!
//! Sources: Gurobi reference manual, "SOL format"; MIPLIB 2017, solution files and their checker, which starts with
//! `=obj= VALUE`, or `=infeas=` where there is no solution. A file with values claims that they are optimal.

use boundfit_exact::{Limits, Rational};
use boundfit_lp::NumberFormat;

use super::error::SolutionError;
use super::line::Line;
use super::{SolutionFile, SolverStatus};

/// Both print as many digits as a binary64 number has, and drop zeros at the end.
const DIGITS: NumberFormat = NumberFormat::SEVENTEEN;
const GUROBI: &str = "Gurobi";
const MIPLIB: &str = "MIPLIB";

/// Returns whether a text is a list of values after `# Objective value = NUMBER` or `=obj= NUMBER`.
pub(super) fn is_gurobi(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}');
    let first = text.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or_default();
    let comment = first.strip_prefix('#').map(|words| words.trim_start().to_ascii_lowercase());
    first.starts_with('=')
        || comment.is_some_and(|words| words.starts_with("objective value") || words.starts_with("solution"))
}

pub(super) fn parse(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let text = text.trim_start_matches('\u{feff}');
    let is_miplib = text.lines().any(|line| line.trim_start().starts_with('='));
    let writer = if is_miplib { MIPLIB } else { GUROBI };
    let optimal = SolverStatus::Optimal;
    let mut file =
        SolutionFile { status: optimal, left_out: Some(Rational::zero()), ..SolutionFile::new(writer) };
    for line in Line::all(writer, text) {
        match line.words().as_slice() {
            [] => {}
            ["=obj=", value] => {
                file.objective = Some((line.figure(value, DIGITS, limits)?, line.number));
            }
            ["=infeas="] => (file.status, file.status_line) = (SolverStatus::Infeasible, line.number),
            ["=unbd="] => (file.status, file.status_line) = (SolverStatus::Unbounded, line.number),
            [first, ..] if first.starts_with('#') => comment(&mut file, line, limits)?,
            [name, value] => {
                file.columns.push(line.entry(*name, Some(line.figure(value, DIGITS, limits)?), None));
            }
            _ => return Err(line.expected("\"NAME VALUE\"")),
        }
    }
    Ok(file)
}

/// A comment, which may say the objective or the model's name.
fn comment(file: &mut SolutionFile, line: Line<'_>, limits: &Limits) -> Result<(), SolutionError> {
    let words = line.text.trim_start().trim_start_matches('#').trim();
    let lower = words.to_ascii_lowercase();
    if lower.starts_with("objective value") {
        let value = words.rsplit(['=', ':', ' ']).find(|word| !word.is_empty()).unwrap_or_default();
        file.objective = Some((line.figure(value, DIGITS, limits)?, line.number));
    } else if lower.starts_with("solution for model ") {
        file.about.extend(words.split_whitespace().last().map(str::to_owned));
    }
    Ok(())
}
