//! GLPK: what `glpsol -w FILE` writes, for programs.
//!
//! Source: GLPK reference manual (5.0), `glp_write_sol` (`%.15g`). HiGHS writes the same with `write_solution_style` 2.

use std::borrow::Cow;

use boundfit_exact::{Limits, Rational};
use boundfit_lp::NumberFormat;

use super::error::SolutionError;
use super::figure::Figure;
use super::line::{COLUMNS, Line, ROWS};
use super::{Announced, Entry, Reference, SolutionFile, SolverStatus};

pub(super) const FORMAT: &str = "GLPK";
const PLAIN: NumberFormat = NumberFormat::FIFTEEN;
/// The format of the objective in the heading.
const HEADING: NumberFormat = NumberFormat::Significant(10);

/// Returns whether a text is a solution for programs: comment lines, then `s bas`, `s ipt` or `s mip`.
pub(super) fn is_plain(text: &str) -> bool {
    let is_comment = |line: &&str| line.split_whitespace().next().is_none_or(|word| word == "c");
    text.lines().find(|line| !is_comment(line)).is_some_and(|line| line.trim_start().starts_with("s "))
        || text.starts_with("c Problem:")
}

/// Reads a solution for programs. Rows and columns have numbers here.
pub(super) fn parse_plain(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let file = SolutionFile::new(FORMAT);
    let mut plain = Plain { heading: Heading::default(), solution: None, file, has_end: false };
    for line in Line::all(FORMAT, text) {
        plain.read(line, limits)?;
    }
    let Some(kind) = plain.solution.clone() else { return plain.heading.alone(plain.file) };
    plain.complete(&kind)?;
    plain.agreeing(&kind, limits)?;
    let Plain { heading, mut file, .. } = plain;
    // The heading of interior points says infeasible where the program may be unbounded.
    let told = heading.status.filter(|_| !kind.is_interior);
    file.status = told.map_or(kind.status, |(told, _)| told);
    file.status_line = kind.line.number;
    file.about = heading.about;
    file.has_duals = kind.has_duals;
    file.announced =
        Some(Announced { columns: kind.columns, line: kind.line.number, text: kind.line.text.to_owned() });
    Ok(file)
}

struct Plain<'a> {
    heading: Heading<'a>,
    solution: Option<Kind<'a>>,
    file: SolutionFile,
    /// True once the last line was met.
    has_end: bool,
}

/// The kind of program that the line `s` states.
#[derive(Clone)]
struct Kind<'a> {
    line: Line<'a>,
    /// The place of a row's activity among its words.
    value: usize,
    has_duals: bool,
    is_interior: bool,
    rows: usize,
    columns: usize,
    status: SolverStatus,
}

impl<'a> Plain<'a> {
    fn read(&mut self, line: Line<'a>, limits: &Limits) -> Result<(), SolutionError> {
        let words = line.words();
        match words.first().copied() {
            None => Ok(()),
            Some("e") => {
                self.has_end = true;
                Ok(())
            }
            Some("c") => {
                self.heading.read(line, line.text.trim_start().trim_start_matches('c').trim_start());
                Ok(())
            }
            Some("s") if self.solution.is_none() => {
                self.solution = Some(Kind::read(line, &words)?);
                let objective = words.last().copied().unwrap_or_default();
                self.file.objective = Some((line.figure(objective, PLAIN, limits)?, line.number));
                Ok(())
            }
            Some("i") => self.row(line, &words, limits),
            Some("j") => self.column(line, &words, limits),
            Some(_) => Err(line.expected("a line that starts with c, s, i, j or e")),
        }
    }

    /// Refuses a file that ends early or lists another number of rows or columns than it announces. Where it has no point, HiGHS
    /// stops after the line `s`.
    fn complete(&self, kind: &Kind<'_>) -> Result<(), SolutionError> {
        let (rows, columns) = (self.file.rows.len(), self.file.columns.len());
        if !self.has_end && rows + columns == 0 && kind.status != SolverStatus::Optimal {
            return Ok(());
        }
        if !self.has_end {
            Err(SolutionError::CutOff { format: FORMAT, missing: "its last line \"e o f\"" })
        } else if rows != kind.rows {
            Err(kind.line.listed(rows, ROWS))
        } else if columns != kind.columns {
            Err(kind.line.listed(columns, COLUMNS))
        } else {
            Ok(())
        }
    }

    /// Refuses a heading that says something else than the line `s`.
    fn agreeing(&self, kind: &Kind<'_>, limits: &Limits) -> Result<(), SolutionError> {
        let is_decided = |status: &SolverStatus| !matches!(status, SolverStatus::Other(_));
        let told = self.heading.status.as_ref();
        let told = told.filter(|(told, _)| is_decided(told) && is_decided(&kind.status));
        let is_either = |one: &SolverStatus, other: &SolverStatus| {
            *one == SolverStatus::InfeasibleOrUnbounded && *other != SolverStatus::Optimal
        };
        if let Some((told, line)) = told
            && *told != kind.status
            && !is_either(told, &kind.status)
            && !is_either(&kind.status, told)
        {
            return Err(kind.line.contradicts(line));
        }
        let (Some(Ok((Figure::Finite(told), line))), Some((Figure::Finite(own), _))) =
            (self.heading.objective(limits), &self.file.objective)
        else {
            return Ok(());
        };
        // HiGHS prints 0 for what is smaller than its last digit.
        let reach = told.reach() + own.reach() + Rational::scientific(1, -13);
        if (&told.value - &own.value).abs() > reach + told.value.abs() * Rational::scientific(1, -9) {
            return Err(kind.line.contradicts(&line));
        }
        Ok(())
    }

    fn row(&mut self, line: Line<'_>, words: &[&str], limits: &Limits) -> Result<(), SolutionError> {
        let expected = || line.expected("\"i ROW ...\" after \"s\", rows in order");
        let kind = self.solution.as_ref().ok_or_else(expected)?;
        let number = words.get(1).and_then(|word| word.parse::<usize>().ok());
        if number != Some(self.file.rows.len() + 1) || number > Some(kind.rows) {
            return Err(expected());
        }
        let entry = kind.entry(line, words, limits, expected)?;
        self.file.rows.push(entry);
        Ok(())
    }

    fn column(&mut self, line: Line<'_>, words: &[&str], limits: &Limits) -> Result<(), SolutionError> {
        let columns = self.solution.as_ref().map(|kind| kind.columns);
        let expected = || line.expected(Self::expected_columns(columns));
        let kind = self.solution.as_ref().ok_or_else(expected)?;
        let number = words.get(1).and_then(|word| word.parse::<usize>().ok());
        if number.is_none_or(|number| number == 0) || number > columns {
            return Err(expected());
        }
        let entry = kind.entry(line, words, limits, expected)?;
        self.file.columns.push(entry);
        Ok(())
    }

    fn expected_columns(columns: Option<usize>) -> Cow<'static, str> {
        match columns {
            None | Some(2) => "\"j 1 ...\" and \"j 2 ...\" after \"s\"".into(),
            Some(columns) => format!("\"j COLUMN ...\" after \"s\", {columns} columns from 1").into(),
        }
    }
}

impl<'a> Kind<'a> {
    fn read(line: Line<'a>, words: &[&str]) -> Result<Self, SolutionError> {
        let expected = || line.expected("\"s bas ROWS COLUMNS PRIMAL DUAL OBJECTIVE\", or ipt or mip");
        let size = |word: &str| word.parse::<usize>().ok();
        let [_, kind, rows, columns, rest @ ..] = words else { return Err(expected()) };
        let (rows, columns) = size(rows).zip(size(columns)).ok_or_else(expected)?;
        let other =
            || SolverStatus::Other(format!("{} ({})", kind, rest.first().copied().unwrap_or_default()));
        let (value, has_duals, status) = match (*kind, rest) {
            ("bas", ["f", "f", _]) => (3, true, SolverStatus::Optimal),
            ("bas", ["n", _, _]) => (3, true, SolverStatus::Infeasible),
            ("bas", ["f", "n", _]) => (3, true, SolverStatus::Unbounded),
            ("bas", [_, "n", _]) => (3, true, SolverStatus::InfeasibleOrUnbounded),
            ("bas", [primal, dual, _]) => {
                (3, true, SolverStatus::Other(format!("undecided ({primal} {dual})")))
            }
            ("ipt", ["o", _]) => (2, true, SolverStatus::Optimal),
            // No point that is feasible for the program and its dual.
            ("ipt", ["n", _]) => (2, true, SolverStatus::InfeasibleOrUnbounded),
            ("ipt", [_, _]) => (2, true, other()),
            ("mip", ["o", _]) => (2, false, SolverStatus::Optimal),
            ("mip", ["n", _]) => (2, false, SolverStatus::Infeasible),
            ("mip", [_, _]) => (2, false, other()),
            _ => return Err(expected()),
        };
        Ok(Kind { line, value, has_duals, is_interior: *kind == "ipt", rows, columns, status })
    }

    /// Returns what a line `i` or `j` says, once its number was looked at.
    fn entry(
        &self,
        line: Line<'_>,
        words: &[&str],
        limits: &Limits,
        expected: impl Fn() -> SolutionError,
    ) -> Result<Entry, SolutionError> {
        let number = words.get(1).and_then(|word| word.parse::<usize>().ok()).unwrap_or_default();
        // HiGHS leaves the status blank where an interior point has no basis.
        let has_status = words.get(2).is_some_and(|word| ["b", "l", "u", "f", "s"].contains(word));
        let place = if has_status { self.value } else { 2 };
        let value = line.figure(words.get(place).ok_or_else(expected)?, PLAIN, limits)?;
        let price = words.get(place + 1).filter(|_| self.has_duals);
        let price = price.map(|word| line.figure(word, PLAIN, limits)).transpose()?;
        Ok(line.entry(Reference::Place(number.saturating_sub(1)), Some(value), price))
    }
}

/// The lines `Key: value` at the top.
#[derive(Default)]
pub(super) struct Heading<'a> {
    pub(super) about: Vec<String>,
    pub(super) status: Option<(SolverStatus, Line<'a>)>,
    /// The objective's name, what is said about its value, and where.
    objective: Option<(&'a str, &'a str, Line<'a>)>,
    /// The line with the number of rows, and that with the number of columns.
    pub(super) rows: Option<Line<'a>>,
    pub(super) columns: Option<Line<'a>>,
}

impl<'a> Heading<'a> {
    /// The file of HiGHS about a program without rows and columns, which has no more than the heading.
    fn alone(self, file: SolutionFile) -> Result<SolutionFile, SolutionError> {
        match self.status {
            Some((status @ SolverStatus::Other(_), line)) => {
                Ok(SolutionFile { status, status_line: line.number, about: self.about, ..file })
            }
            _ => Err(SolutionError::End { format: FORMAT, missing: "a line \"s bas\"" }),
        }
    }

    pub(super) fn read(&mut self, line: Line<'a>, text: &'a str) {
        let Some((key, value)) = text.split_once(':') else { return };
        match key {
            "Status" if self.status.is_none() => self.status = Some((status(value), line)),
            "Rows" => self.rows = Some(line),
            "Columns" => self.columns = Some(line),
            "Problem" => self.about.push(value.trim().to_owned()),
            "Objective" => {
                self.about.push(value.trim().to_owned());
                // HiGHS writes no name and no sign where the objective has no name.
                let (name, rest) = value.split_once('=').unwrap_or(("", value));
                let [name, figure] =
                    [name, rest].map(|text| text.split_whitespace().next().unwrap_or_default());
                self.objective = Some((name, figure, line));
            }
            _ => {}
        }
    }

    /// Returns whether a row is that of the objective, by its name.
    pub(super) fn is_objective(&self, row: &Reference) -> bool {
        self.objective.is_some_and(|(name, ..)| *row == Reference::Name(name.to_owned()))
    }

    /// The value of the objective and its line, if one is stated.
    pub(super) fn objective(&self, limits: &Limits) -> Option<Result<(Figure, Line<'a>), SolutionError>> {
        let (_, value, line) = self.objective.filter(|(_, value, _)| !value.is_empty())?;
        Some(line.figure(value, HEADING, limits).map(|figure| (figure, line)))
    }
}

fn status(words: &str) -> SolverStatus {
    match words.trim() {
        "INTEGER OPTIMAL" => SolverStatus::Optimal,
        "INTEGER EMPTY" => SolverStatus::Infeasible,
        other => SolverStatus::of_words(other),
    }
}
