//! GLPK: what `glpsol -w FILE` and `glpsol -o FILE` write.
//!
//! Source: GLPK reference manual (5.0), `glp_write_sol` and `glp_print_sol`. HiGHS writes the same with
//! `write_solution_style` 2 and 3.

use boundfit_exact::Limits;

use boundfit_lp::PuiEnd;

use super::error::ClaimError;
use super::solution::{Line, PrintedPoint, Solution, Status};

const FORMAT: &str = "GLPK";

/// Whether a text is a solution for programs: comment lines, then `s bas`, `s ipt` or `s mip`.
pub(super) fn is_plain(text: &str) -> bool {
    let is_comment = |line: &&str| line.split_whitespace().next().is_none_or(|word| word == "c");
    text.lines().find(|line| !is_comment(line)).is_some_and(|line| line.trim_start().starts_with("s "))
        || text.starts_with("c Problem:")
}

/// Whether a text is a solution for people: it starts with the problem's name and size.
pub(super) fn is_printed(text: &str) -> bool {
    let mut lines = text.lines();
    let mut starts = |key: &str| lines.next().is_some_and(|line| line.starts_with(key));
    starts("Problem:") && starts("Rows:")
}

/// Reads a solution for programs. Variables have numbers here, θ1 is 1.
pub(super) fn parse_plain(text: &str, limits: &Limits) -> Result<Solution, ClaimError> {
    let mut plain = Plain {
        heading: Heading::default(),
        solution: None,
        point: PrintedPoint::default(),
        duals: Vec::new(),
    };
    for line in Line::all(FORMAT, text) {
        plain.read(line, limits)?;
    }
    let missing = |missing| ClaimError::End { format: FORMAT, missing };
    let kind = plain.solution.ok_or(missing("a line \"s bas\""))?;
    // Of interior points the heading says infeasible where it may be unbounded.
    let told = plain.heading.status.filter(|_| !kind.is_interior);
    let status = told.unwrap_or(kind.status);
    let point = if status == Status::Optimal { plain.point.finish().map_err(missing)? } else { None };
    let duals = (kind.has_duals && status == Status::Optimal).then_some(plain.duals);
    Ok(Solution { format: FORMAT, target: plain.heading.target, status, point, duals })
}

struct Plain {
    heading: Heading,
    solution: Option<Kind>,
    point: PrintedPoint,
    duals: Vec<f64>,
}

/// What the line `s` says.
#[derive(Clone)]
struct Kind {
    /// The place of a row's activity among its words.
    value: usize,
    has_duals: bool,
    is_interior: bool,
    rows: usize,
    status: Status,
}

impl Plain {
    fn read(&mut self, line: Line<'_>, limits: &Limits) -> Result<(), ClaimError> {
        let words = line.words();
        match words.first().copied() {
            None | Some("e") => Ok(()),
            Some("c") => {
                self.heading.read(line.text.trim_start().trim_start_matches('c').trim_start());
                Ok(())
            }
            Some("s") if self.solution.is_none() => {
                self.solution = Some(Kind::read(line, &words)?);
                Ok(())
            }
            Some("i") => self.row(line, &words, limits),
            Some("j") => self.column(line, &words, limits),
            Some(_) => Err(line.expected("a line that starts with c, s, i, j or e")),
        }
    }

    fn row(&mut self, line: Line<'_>, words: &[&str], limits: &Limits) -> Result<(), ClaimError> {
        let expected = || line.expected("\"i ROW ...\" after \"s\", rows in order");
        let kind = self.solution.as_ref().ok_or_else(expected)?;
        let number = words.get(1).and_then(|word| word.parse::<usize>().ok());
        if number != Some(self.duals.len() + 1) || number > Some(kind.rows) {
            return Err(expected());
        }
        line.number(words.get(kind.value).ok_or_else(expected)?, limits)?;
        let dual = words.get(kind.value + 1).filter(|_| kind.has_duals);
        let dual = dual.map_or(Ok(0.0), |word| line.dual(word, limits))?;
        self.duals.push(dual);
        Ok(())
    }

    fn column(&mut self, line: Line<'_>, words: &[&str], limits: &Limits) -> Result<(), ClaimError> {
        let expected = || line.expected("\"j 1 ...\" and \"j 2 ...\" after \"s\"");
        let kind = self.solution.as_ref().ok_or_else(expected)?;
        let name = match words.get(1).copied() {
            Some("1") => "theta1",
            Some("2") => "theta2",
            _ => return Err(expected()),
        };
        let value = line.number(words.get(kind.value).ok_or_else(expected)?, limits)?;
        self.point.set(name, value);
        Ok(())
    }
}

impl Kind {
    fn read(line: Line<'_>, words: &[&str]) -> Result<Self, ClaimError> {
        let expected = || line.expected("\"s bas ROWS 2 PRIMAL DUAL OBJECTIVE\", or ipt or mip");
        let size = |word: &str| word.parse::<usize>().ok();
        let [_, kind, rows, columns, rest @ ..] = words else { return Err(expected()) };
        let rows = size(rows).ok_or_else(expected)?;
        if size(columns) != Some(2) {
            return Err(line.expected("2 variables, theta1 and theta2"));
        }
        let other = || Status::Other(format!("{} ({})", kind, rest.first().copied().unwrap_or_default()));
        let (value, has_duals, status) = match (*kind, rest) {
            ("bas", ["f", "f", _]) => (3, true, Status::Optimal),
            ("bas", ["n", _, _]) => (3, true, Status::Infeasible),
            ("bas", ["f", "n", _]) => (3, true, Status::Unbounded),
            ("bas", [_, "n", _]) => (3, true, Status::InfeasibleOrUnbounded),
            ("bas", [primal, dual, _]) => (3, true, Status::Other(format!("undecided ({primal} {dual})"))),
            ("ipt", ["o", _]) => (2, true, Status::Optimal),
            // No point that is feasible for the program and its dual.
            ("ipt", ["n", _]) => (2, true, Status::InfeasibleOrUnbounded),
            ("ipt", [_, _]) => (2, true, other()),
            ("mip", ["o", _]) => (2, false, Status::Optimal),
            ("mip", ["n", _]) => (2, false, Status::Infeasible),
            ("mip", [_, _]) => (2, false, other()),
            _ => return Err(expected()),
        };
        Ok(Kind { value, has_duals, is_interior: *kind == "ipt", rows, status })
    }
}

/// What the lines `Key: value` at the top say.
#[derive(Default)]
struct Heading {
    target: Option<PuiEnd>,
    status: Option<Status>,
    objective: String,
}

impl Heading {
    fn read(&mut self, line: &str) {
        let Some((key, value)) = line.split_once(':') else { return };
        match key {
            "Status" => self.status = self.status.take().or_else(|| Some(status(value))),
            "Problem" | "Objective" => {
                self.target = self.target.or_else(|| PuiEnd::find(value).map(|(_, target, _)| target));
                if key == "Objective" {
                    self.objective = value.split_whitespace().next().unwrap_or_default().to_owned();
                }
            }
            _ => {}
        }
    }
}

fn status(words: &str) -> Status {
    match words.trim() {
        "INTEGER OPTIMAL" => Status::Optimal,
        "INTEGER EMPTY" => Status::Infeasible,
        other => Status::of_words(other),
    }
}

/// Reads a solution for people.
pub(super) fn parse_printed(text: &str, limits: &Limits) -> Result<Solution, ClaimError> {
    /// Where a line belongs.
    enum Section {
        Heading,
        Rows,
        Columns,
    }
    let mut heading = Heading::default();
    let (mut point, mut duals) = (PrintedPoint::default(), Vec::new());
    let mut section = Section::Heading;
    let mut has_duals = true;
    let mut lines = Line::all(FORMAT, text).peekable();
    while let Some(line) = lines.next() {
        let mut words = line.words();
        if line.text.starts_with("Karush-Kuhn-Tucker") || line.text.starts_with("End of output") {
            break;
        }
        match words.as_slice() {
            ["No.", "Row", ..] => section = Section::Rows,
            ["No.", "Column", ..] => section = Section::Columns,
            _ if matches!(section, Section::Heading) => heading.read(line.text),
            [number, _, ..] if number.parse::<usize>().is_ok() => {
                // A long name has a line of its own.
                let next = (words.len() == 2).then(|| lines.next()).flatten();
                words.extend(next.iter().flat_map(|next| next.words()));
                let record = Record::read(line, &words)?;
                let value = line.number(record.value, limits)?;
                match section {
                    Section::Columns => point.set(record.name, value),
                    _ if record.name == heading.objective => {}
                    _ => {
                        has_duals &= record.has_dual_place;
                        duals.push(record.dual.map_or(Ok(0.0), |dual| line.dual(dual, limits))?);
                    }
                }
            }
            [] => {}
            [first, ..] if first.starts_with("---") => {}
            _ => return Err(line.expected("\"NUMBER NAME STATUS ACTIVITY ...\"")),
        }
    }
    let missing = |missing| ClaimError::End { format: FORMAT, missing };
    let status = heading.status.ok_or(missing("a line \"Status:\""))?;
    let point = if status == Status::Optimal { point.finish().map_err(missing)? } else { None };
    let duals = (has_duals && status == Status::Optimal).then_some(duals);
    Ok(Solution { format: FORMAT, target: heading.target, status, point, duals })
}

/// A row or a column.
struct Record<'a> {
    name: &'a str,
    value: &'a str,
    /// The multiplier, which only those have that are not in the basis.
    dual: Option<&'a str>,
    has_dual_place: bool,
}

impl<'a> Record<'a> {
    fn read(line: Line<'_>, words: &[&'a str]) -> Result<Self, ClaimError> {
        match words {
            [_, name, "B", value, ..] => Ok(Record { name, value, dual: None, has_dual_place: true }),
            [_, name, "NL" | "NU" | "NF" | "NS", value, .., dual] => {
                // `< eps` stands for almost nothing.
                let dual = (*dual != "eps").then_some(*dual);
                Ok(Record { name, value, dual, has_dual_place: true })
            }
            [_, name, "NL" | "NU" | "NF" | "NS", value] => {
                Ok(Record { name, value, dual: None, has_dual_place: true })
            }
            // Interior points and integer programs have no basis.
            [_, name, "*", value, ..] | [_, name, value, ..] => {
                Ok(Record { name, value, dual: None, has_dual_place: false })
            }
            _ => Err(line.expected("\"NUMBER NAME STATUS ACTIVITY ...\"")),
        }
    }
}
