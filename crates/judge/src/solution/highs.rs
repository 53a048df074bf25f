//! HiGHS: what `--solution_file FILE` writes, in its raw style and in its table for people.
//!
//! Source: HiGHS documentation, "Solution file format". Its styles 2 and 3 are those of GLPK. The raw style prints numbers to
//! 10⁻¹³ (`kHighsSolutionValueToStringTolerance`), with at most 16 digits; the table as `%g`.

use boundfit_exact::{Limits, Rational};
use boundfit_lp::NumberFormat;

use super::error::SolutionError;
use super::figure::Figure;
use super::line::{COLUMNS, Line, ROWS};
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
struct Raw<'a> {
    file: SolutionFile,
    section: Section,
    status: Option<SolverStatus>,
    is_primal_there: bool,
    /// The first word of the section of duals: true if duals follow.
    is_dual_there: Option<bool>,
    /// The lists so far, each with its section, its heading and its length.
    lists: Vec<(Section, Line<'a>, usize)>,
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
        is_dual_there: None,
        lists: Vec::new(),
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
    raw.file.status = raw.status.clone().ok_or(missing("a status"))?;
    if raw.section == Section::Status {
        return Err(missing("\"# Primal solution values\""));
    }
    let is_there = raw.is_primal_there;
    finish(raw.complete()?, is_there)
}

impl<'a> Raw<'a> {
    /// The file, if its lists are as long as their headings say and no section of an optimum is missing.
    fn complete(self) -> Result<SolutionFile, SolutionError> {
        for (_, heading, count) in &self.lists {
            let words = heading.words();
            let [_, kind, said, ..] = words.as_slice() else { continue };
            if said.parse::<usize>().is_ok_and(|said| said != *count) {
                return Err(heading.listed(*count, if *kind == "Rows" { ROWS } else { COLUMNS }));
            }
        }
        // The sparse style has neither rows nor duals.
        if self.file.status != SolverStatus::Optimal || self.file.left_out.is_some() {
            return Ok(self.file);
        }
        let missing = |missing| Err(SolutionError::CutOff { format: FORMAT, missing });
        let count = |section| self.lists.iter().filter(|(own, ..)| *own == section).count();
        if self.is_primal_there && count(Section::Primal) < 2 {
            return missing("\"# Rows\"");
        }
        match self.is_dual_there {
            None => missing("its dual solution values"),
            Some(true) if count(Section::Dual) < 2 => missing("the rows of its duals"),
            Some(_) => Ok(self.file),
        }
    }

    fn read(&mut self, line: Line<'a>, limits: &Limits) -> Result<(), SolutionError> {
        let words = line.words();
        match (self.section, words.as_slice()) {
            (_, []) | (Section::Status, ["Model", "status"]) => {}
            (_, ["#", "Primal", ..]) => self.section = Section::Primal,
            (_, ["#", "Dual", ..]) => (self.section, self.listed) = (Section::Dual, None),
            (_, ["#", "Basis"]) => self.section = Section::Basis,
            (_, ["#", "Columns", _]) => self.list(line, Listed::Columns),
            (Section::Primal, ["#", "Columns", _, "sparse"]) => {
                self.list(line, Listed::SparseColumns);
                self.file.left_out = Some(Rational::zero());
            }
            (_, ["#", "Rows", _]) => {
                self.list(line, Listed::Rows);
                self.file.has_duals |= self.section == Section::Dual;
            }
            (Section::Status, _) if self.status.is_none() => {
                (self.status, self.file.status_line) = (Some(raw_status(line.text)), line.number);
            }
            (Section::Primal, ["None" | "Feasible" | "Infeasible"]) => {
                self.is_primal_there = words != ["None"];
            }
            (Section::Dual, ["None" | "Feasible" | "Infeasible"]) if self.listed.is_none() => {
                self.is_dual_there = Some(words != ["None"]);
            }
            // A column or a row may have that name.
            (Section::Primal, ["Objective", value]) if self.listed.is_none() => {
                self.file.objective = Some((line.figure(value, RAW, limits)?, line.number));
            }
            (Section::Primal, [name, value, _] | [name, value])
                if (words.len() == 3) == (self.listed == Some(Listed::SparseColumns)) =>
            {
                let value = Some(line.figure(value, RAW, limits)?);
                self.count();
                self.side().push(line.entry(*name, value, None));
            }
            (Section::Dual, [name, value]) => {
                let price = line.figure(value, RAW, limits)?;
                self.count();
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

    /// A heading of entries.
    fn list(&mut self, heading: Line<'a>, listed: Listed) {
        self.listed = Some(listed);
        self.lists.push((self.section, heading, 0));
    }

    fn count(&mut self) {
        if let Some((.., count)) = self.lists.last_mut() {
            *count += 1;
        }
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
            None => self.side().push(line.entry(name, None, Some(price))),
        }
    }
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
                side.push(line.entry(*name, value, price));
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
