//! GLPK: what `glpsol -w FILE` and `glpsol -o FILE` write.
//!
//! Source: GLPK reference manual (5.0), `glp_write_sol` (`%.15g`) and `glp_print_sol` (`%.6g`). HiGHS writes the same with
//! `write_solution_style` 2 and 3.

use std::borrow::Cow;

use boundfit_exact::{Limits, Rational};
use boundfit_lp::{NumberFormat, Printed};

use super::error::SolutionError;
use super::figure::Figure;
use super::line::Line;
use super::{Announced, Entry, Reference, SolutionFile, SolverStatus};

const FORMAT: &str = "GLPK";
const PLAIN: NumberFormat = NumberFormat::FIFTEEN;
const PRINTED: NumberFormat = NumberFormat::SIX;
/// The format of the objective in the heading.
const HEADING: NumberFormat = NumberFormat::Significant(10);

/// Returns whether a text is a solution for programs: comment lines, then `s bas`, `s ipt` or `s mip`.
pub(super) fn is_plain(text: &str) -> bool {
    let is_comment = |line: &&str| line.split_whitespace().next().is_none_or(|word| word == "c");
    text.lines().find(|line| !is_comment(line)).is_some_and(|line| line.trim_start().starts_with("s "))
        || text.starts_with("c Problem:")
}

/// Returns whether a text is a solution for people: it starts with the problem's name and size.
pub(super) fn is_printed(text: &str) -> bool {
    let mut lines = text.lines();
    let mut starts = |key: &str| lines.next().is_some_and(|line| line.starts_with(key));
    starts("Problem:") && starts("Rows:")
}

/// Reads a solution for programs. Rows and columns have numbers here.
pub(super) fn parse_plain(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let file = SolutionFile::new(FORMAT);
    let mut plain = Plain { heading: Heading::default(), solution: None, file };
    for line in Line::all(FORMAT, text) {
        plain.read(line, limits)?;
    }
    let Plain { heading, solution, mut file } = plain;
    let kind = solution.ok_or(SolutionError::End { format: FORMAT, missing: "a line \"s bas\"" })?;
    // The heading of interior points says infeasible where the program may be unbounded.
    let told = heading.status.filter(|_| !kind.is_interior);
    file.status = told.unwrap_or(kind.status);
    file.status_line = kind.announced.line;
    file.about = heading.about;
    file.has_duals = kind.has_duals;
    file.announced = Some(kind.announced);
    Ok(file)
}

struct Plain {
    heading: Heading,
    solution: Option<Kind>,
    file: SolutionFile,
}

/// The kind of program that the line `s` states.
#[derive(Clone)]
struct Kind {
    /// The place of a row's activity among its words.
    value: usize,
    has_duals: bool,
    is_interior: bool,
    rows: usize,
    announced: Announced,
    status: SolverStatus,
}

impl Plain {
    fn read(&mut self, line: Line<'_>, limits: &Limits) -> Result<(), SolutionError> {
        let words = line.words();
        match words.first().copied() {
            None | Some("e") => Ok(()),
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
        let columns = self.solution.as_ref().map(|kind| kind.announced.columns);
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

impl Kind {
    fn read(line: Line<'_>, words: &[&str]) -> Result<Self, SolutionError> {
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
        let announced = Announced { columns, line: line.number, text: line.text.to_owned() };
        Ok(Kind { value, has_duals, is_interior: *kind == "ipt", rows, announced, status })
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
        Ok(Entry {
            of: Reference::Place(number.saturating_sub(1)),
            line: line.number,
            value: Some(value),
            price,
            price_line: line.number,
        })
    }
}

/// The lines `Key: value` at the top.
#[derive(Default)]
struct Heading {
    about: Vec<String>,
    status: Option<SolverStatus>,
    status_line: usize,
    /// The objective's name, what is said about its value, and where.
    objective: Option<(String, String, usize)>,
}

impl Heading {
    fn read(&mut self, line: Line<'_>, text: &str) {
        let Some((key, value)) = text.split_once(':') else { return };
        match key {
            "Status" if self.status.is_none() => {
                (self.status, self.status_line) = (Some(status(value)), line.number);
            }
            "Problem" => self.about.push(value.trim().to_owned()),
            "Objective" => {
                self.about.push(value.trim().to_owned());
                let name = value.split_whitespace().next().unwrap_or_default();
                let rest = value.split_once('=').map_or("", |(_, rest)| rest);
                let figure = rest.split_whitespace().next().unwrap_or_default();
                self.objective = Some((name.to_owned(), figure.to_owned(), line.number));
            }
            _ => {}
        }
    }
}

fn status(words: &str) -> SolverStatus {
    match words.trim() {
        "INTEGER OPTIMAL" => SolverStatus::Optimal,
        "INTEGER EMPTY" => SolverStatus::Infeasible,
        other => SolverStatus::of_words(other),
    }
}

/// The place where a line of a solution for people belongs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Section {
    Heading,
    Rows,
    Columns,
}

/// Reads a solution for people.
pub(super) fn parse_printed(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let mut heading = Heading::default();
    let mut file = SolutionFile { has_duals: true, ..SolutionFile::new(FORMAT) };
    let mut section = Section::Heading;
    let mut is_interior = false;
    let mut lines = Line::all(FORMAT, text).peekable();
    while let Some(line) = lines.next() {
        let mut words = line.words();
        if line.text.starts_with("Karush-Kuhn-Tucker") || line.text.starts_with("End of output") {
            break;
        }
        match words.as_slice() {
            ["No.", "Row", rest @ ..] => {
                section = Section::Rows;
                // Interior points have no basis, and integer programs have no marginals either.
                is_interior = rest.contains(&"Marginal") && !rest.contains(&"St");
            }
            ["No.", "Column", ..] => section = Section::Columns,
            _ if section == Section::Heading => heading.read(line, line.text),
            [number, _, ..] if number.parse::<usize>().is_ok() => {
                // A long name has a line of its own.
                let next = (words.len() == 2).then(|| lines.next()).flatten();
                words.extend(next.iter().flat_map(|next| next.words()));
                let (entry, has_dual_place) = record(line, &words, limits)?;
                let is_objective = |(name, ..): &(String, String, usize)| matches!(&entry.of, Reference::Name(own) if own == name);
                match section {
                    Section::Columns => file.columns.push(entry),
                    _ if heading.objective.as_ref().is_some_and(is_objective) => {}
                    _ => {
                        file.has_duals &= has_dual_place;
                        file.rows.push(entry);
                    }
                }
            }
            [] => {}
            [first, ..] if first.starts_with("---") => {}
            _ => return Err(line.expected("\"NUMBER NAME STATUS ACTIVITY ...\"")),
        }
    }
    let told = heading.status.ok_or(SolutionError::End { format: FORMAT, missing: "a line \"Status:\"" })?;
    file.status = match told {
        // As in [`parse_plain`].
        SolverStatus::Infeasible if is_interior => SolverStatus::InfeasibleOrUnbounded,
        told => told,
    };
    file.status_line = heading.status_line;
    file.about = heading.about;
    if let Some((_, value, number)) = heading.objective.filter(|(_, value, _)| !value.is_empty()) {
        let line = Line { format: FORMAT, number, text };
        file.objective = Some((line.figure(&value, HEADING, limits)?, number));
    }
    Ok(file)
}

/// A row or a column, and whether such a line has a place for a multiplier.
fn record(line: Line<'_>, words: &[&str], limits: &Limits) -> Result<(Entry, bool), SolutionError> {
    let (name, value, price, has_dual_place) = match words {
        [_, name, "B", value, ..] => (name, value, None, true),
        [_, name, "NL" | "NU" | "NF" | "NS", value, .., dual] => (name, value, Some(dual), true),
        [_, name, "NL" | "NU" | "NF" | "NS", value] => (name, value, None, true),
        // Interior points and integer programs have no basis.
        [_, name, "*", value, ..] | [_, name, value, ..] => (name, value, None, false),
        _ => return Err(line.expected("\"NUMBER NAME STATUS ACTIVITY ...\"")),
    };
    let price = match price {
        // `< eps` stands for what is smaller than 10⁻⁹: that is left out.
        Some(&"eps") => Some(left_out()),
        Some(price) => Some(line.figure(price, PRINTED, limits)?),
        None if has_dual_place => Some(Figure::Finite(Printed::exact(Rational::zero()))),
        None => None,
    };
    let of = Reference::Name((*name).to_owned());
    // It prints 0 for a value that is at most 10⁻⁹.
    let value = match line.figure(value, PRINTED, limits)? {
        Figure::Finite(printed) if printed.value.is_zero() => left_out(),
        other => other,
    };
    Ok((Entry { of, line: line.number, value: Some(value), price, price_line: line.number }, has_dual_place))
}

/// The 0 that stands for what is at most 10⁻⁹.
fn left_out() -> Figure {
    Figure::Finite(Printed::left_out(Rational::scientific(1, -9)))
}
