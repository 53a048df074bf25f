//! HiGHS: what `--solution_file FILE` writes, in its raw style and in its table for people.
//!
//! Source: HiGHS documentation, "Solution file format". Its styles 2 and 3 are those of GLPK. The raw style prints numbers to
//! 10⁻¹³ (`kHighsSolutionValueToStringTolerance`), with at most 16 digits; the table as `%g`.

use boundfit_exact::{Limits, Rational};
use boundfit_lp::NumberFormat;

use super::error::SolutionError;
use super::figure::Figure;
use super::line::Line;
use super::{Entry, Reference, SolutionFile, SolverStatus};

const FORMAT: &str = "HiGHS";
const RAW: NumberFormat = NumberFormat::HIGHS;
const TABLE: NumberFormat = NumberFormat::SIX;

/// Returns whether a text is a solution in raw style.
pub(super) fn is_raw(text: &str) -> bool {
    text.lines().find(|line| !line.trim().is_empty()).is_some_and(|line| line.trim() == "Model status")
}

/// Returns whether a text is a table for people.
pub(super) fn is_table(text: &str) -> bool {
    let mut lines = text.lines();
    lines.next().is_some_and(|line| line.trim() == "Columns")
        && lines.next().is_some_and(|line| line.split_whitespace().take(2).eq(["Index", "Status"]))
}

/// Returns whether a text is a solution in the old raw style, -1: it has neither names nor a status.
pub(super) fn is_old(text: &str) -> bool {
    text.lines()
        .next()
        .is_some_and(|line| line.contains(": Number of columns and rows for primal or dual solution"))
}

/// Refuses the old raw style.
pub(super) fn refuse_old(_: &str, _: &Limits) -> Result<SolutionFile, SolutionError> {
    Err(SolutionError::OldHighs)
}

/// The part that a line of the raw style belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Section {
    Status,
    Primal,
    Dual,
    Basis,
}

/// The kind of entries below a heading.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Listed {
    Columns,
    /// Columns whose value is not 0, each with its number.
    SparseColumns,
    Rows,
}

/// A file in raw style, as far as it was read.
struct Raw {
    file: SolutionFile,
    section: Section,
    status: Option<SolverStatus>,
    is_primal_there: bool,
    /// The entries that follow, once a heading has said so.
    listed: Option<Listed>,
    /// The numbers of entries that the section of duals has met, of columns and of rows.
    priced: [usize; 2],
}

/// Reads a solution in raw style.
pub(super) fn parse_raw(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let mut raw = Raw {
        file: SolutionFile::new(FORMAT),
        section: Section::Status,
        status: None,
        is_primal_there: false,
        listed: None,
        priced: [0, 0],
    };
    for line in Line::all(FORMAT, text) {
        raw.read(line, limits)?;
        if raw.section == Section::Basis {
            break;
        }
    }
    let missing = |missing| SolutionError::End { format: FORMAT, missing };
    raw.file.status = raw.status.ok_or(missing("a status"))?;
    if raw.section == Section::Status {
        return Err(missing("\"# Primal solution values\""));
    }
    finish(raw.file, raw.is_primal_there)
}

impl Raw {
    fn read(&mut self, line: Line<'_>, limits: &Limits) -> Result<(), SolutionError> {
        let words = line.words();
        match (self.section, words.as_slice()) {
            (_, []) | (Section::Status, ["Model", "status"]) => {}
            (_, ["#", "Primal", ..]) => self.section = Section::Primal,
            (_, ["#", "Dual", ..]) => self.section = Section::Dual,
            (_, ["#", "Basis"]) => self.section = Section::Basis,
            (_, ["#", "Columns", _]) => self.listed = Some(Listed::Columns),
            (Section::Primal, ["#", "Columns", _, "sparse"]) => {
                self.listed = Some(Listed::SparseColumns);
                self.file.left_out = Some(Rational::zero());
            }
            (_, ["#", "Rows", _]) => {
                self.listed = Some(Listed::Rows);
                self.file.has_duals |= self.section == Section::Dual;
            }
            (Section::Status, _) if self.status.is_none() => {
                (self.status, self.file.status_line) = (Some(raw_status(line.text)), line.number);
            }
            (Section::Primal, ["None" | "Feasible" | "Infeasible"]) => {
                self.is_primal_there = words != ["None"];
            }
            (Section::Dual, ["None" | "Feasible" | "Infeasible"]) => {}
            // A column or a row may have that name.
            (Section::Primal, ["Objective", value]) if self.listed.is_none() => {
                self.file.objective = Some((line.figure(value, RAW, limits)?, line.number));
            }
            (Section::Primal, [name, value, _] | [name, value])
                if (words.len() == 3) == (self.listed == Some(Listed::SparseColumns)) =>
            {
                let value = Some(line.figure(value, RAW, limits)?);
                self.side().push(entry(name, line, value, None));
            }
            (Section::Dual, [name, value]) => {
                let price = line.figure(value, RAW, limits)?;
                self.price(name, line, price);
            }
            (Section::Status, _) => return Err(line.expected("\"# Primal solution values\"")),
            (Section::Primal, _) if self.listed == Some(Listed::SparseColumns) => {
                return Err(line.expected("\"NAME VALUE NUMBER\""));
            }
            (Section::Primal | Section::Dual, _) => return Err(line.expected("\"NAME VALUE\"")),
            (Section::Basis, _) => {}
        }
        Ok(())
    }

    fn side(&mut self) -> &mut Vec<Entry> {
        if self.listed == Some(Listed::Rows) { &mut self.file.rows } else { &mut self.file.columns }
    }

    /// Prices come in the order of the values; what has no value is an entry of its own.
    fn price(&mut self, name: &str, line: Line<'_>, price: Figure) {
        let [columns, rows] = &mut self.priced;
        let place = if self.listed == Some(Listed::Rows) { rows } else { columns };
        let next = *place;
        *place += 1;
        let is_name = |entry: &&mut Entry| matches!(&entry.of, Reference::Name(own) if own == name);
        match self.side().get_mut(next).filter(is_name) {
            Some(entry) => (entry.price, entry.price_line) = (Some(price), line.number),
            None => self.side().push(entry(name, line, None, Some(price))),
        }
    }
}

fn entry(name: &str, line: Line<'_>, value: Option<Figure>, price: Option<Figure>) -> Entry {
    Entry { of: Reference::Name(name.to_owned()), line: line.number, value, price, price_line: line.number }
}

fn raw_status(words: &str) -> SolverStatus {
    match words.trim() {
        "Primal infeasible or unbounded" => SolverStatus::InfeasibleOrUnbounded,
        other => SolverStatus::of_words(other),
    }
}

fn finish(file: SolutionFile, is_there: bool) -> Result<SolutionFile, SolutionError> {
    if file.status == SolverStatus::Optimal && !is_there {
        return Err(SolutionError::End { format: FORMAT, missing: "the values of an optimum" });
    }
    Ok(file)
}

/// Reads a table for people.
pub(super) fn parse_table(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let (mut are_rows, mut status, mut has_values) = (false, None, true);
    let mut file = SolutionFile { has_duals: true, ..SolutionFile::new(FORMAT) };
    for line in Line::all(FORMAT, text) {
        match line.words().as_slice() {
            [] | ["Columns"] => {}
            ["Objective", "value:", value] => {
                file.objective = Some((line.figure(value, RAW, limits)?, line.number));
            }
            ["Rows"] => are_rows = true,
            ["Index", "Status", ..] => {
                has_values = line.text.contains("Primal") && line.text.contains("Dual");
            }
            ["Model", "status:", ..] => {
                status = line.text.split_once(':').map(|(_, words)| raw_status(words));
                file.status_line = line.number;
            }
            [_, "LB" | "UB" | "FX" | "BS" | "FR" | "NB" | "ZE" | "SB", _, _, value, dual, name]
                if has_values =>
            {
                let value = Some(line.figure(value, TABLE, limits)?);
                let price = Some(line.figure(dual, TABLE, limits)?);
                let side = if are_rows { &mut file.rows } else { &mut file.columns };
                side.push(entry(name, line, value, price));
            }
            // Without a solution the places of its numbers are blank.
            [index, _, _, _] if index.parse::<usize>().is_ok() => has_values = false,
            _ if !has_values => {}
            ["Model" | "Total" | "Number" | "Primal" | "Dual", ..] => {}
            _ => return Err(line.expected("\"INDEX STATUS LOWER UPPER PRIMAL DUAL NAME\"")),
        }
    }
    file.status = status.ok_or(SolutionError::End { format: FORMAT, missing: "a line \"Model status:\"" })?;
    finish(file, has_values)
}
