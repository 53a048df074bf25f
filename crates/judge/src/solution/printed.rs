//! GLPK: what `glpsol -o FILE` writes, for people.
//!
//! Source: GLPK reference manual (5.0), `glp_print_sol` (`%.6g`). HiGHS writes the same with `write_solution_style` 3.

use boundfit_exact::{Limits, Rational};
use boundfit_lp::{NumberFormat, Printed};

use super::error::SolutionError;
use super::figure::Figure;
use super::glpk::{FORMAT, Heading};
use super::line::{COLUMNS, Line, ROWS};
use super::{Entry, SolutionFile, SolverStatus};

const PRINTED: NumberFormat = NumberFormat::SIX;

/// Returns whether a text is a solution for people: it starts with the problem's name and size.
pub(super) fn is_it(text: &str) -> bool {
    let mut lines = text.lines();
    let mut starts = |key: &str| lines.next().is_some_and(|line| line.starts_with(key));
    starts("Problem:") && starts("Rows:")
}

/// The place where a line of a solution for people belongs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Section {
    Heading,
    Rows,
    Columns,
    /// The errors of the point.
    Conditions,
}

/// Reads a solution for people.
pub(super) fn parse(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let mut heading = Heading::default();
    let mut file = SolutionFile { has_duals: true, ..SolutionFile::new(FORMAT) };
    let mut section = Section::Heading;
    let (mut is_interior, mut has_end, mut counts) = (false, false, [0, 0]);
    let mut lines = Line::all(FORMAT, text).peekable();
    while let Some(line) = lines.next() {
        let mut words = line.words();
        if line.text.starts_with("End of output") {
            has_end = true;
            break;
        }
        if line.text.starts_with("Karush-Kuhn-Tucker") {
            section = Section::Conditions;
        }
        match words.as_slice() {
            ["No.", "Row", rest @ ..] => {
                section = Section::Rows;
                // Interior points have no basis, and integer programs have no marginals either.
                is_interior = rest.contains(&"Marginal") && !rest.contains(&"St");
            }
            ["No.", "Column", ..] => section = Section::Columns,
            _ if section == Section::Heading => heading.read(line, line.text),
            _ if section == Section::Conditions => {}
            [number, _, ..] if number.parse::<usize>().is_ok() => {
                // A long name has a line of its own.
                let next = (words.len() == 2).then(|| lines.next()).flatten();
                words.extend(next.iter().flat_map(|next| next.words()));
                let (entry, has_dual_place) = record(line, &words, limits)?;
                let [rows, columns] = &mut counts;
                *if section == Section::Columns { columns } else { rows } += 1;
                match section {
                    Section::Columns => file.columns.push(entry),
                    _ if heading.is_objective(&entry.of) => {}
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
    let missing = SolutionError::End { format: FORMAT, missing: "a line \"Status:\"" };
    let (told, status_line) = heading.status.clone().ok_or(missing)?;
    file.status = match told {
        // The heading of interior points says infeasible where the program may be unbounded.
        SolverStatus::Infeasible if is_interior => SolverStatus::InfeasibleOrUnbounded,
        told => told,
    };
    file.status_line = status_line.number;
    complete(&file, &heading, counts, has_end)?;
    file.objective = heading.objective(limits).transpose()?.map(|(figure, line)| (figure, line.number));
    file.about = heading.about;
    Ok(file)
}

/// Refuses a file that ends early or lists another number of rows or columns than its heading says.
fn complete(
    file: &SolutionFile,
    heading: &Heading<'_>,
    counts: [usize; 2],
    has_end: bool,
) -> Result<(), SolutionError> {
    // Without a point HiGHS stops after the heading.
    if counts == [0, 0] && file.status != SolverStatus::Optimal {
        return Ok(());
    }
    if !has_end {
        return Err(SolutionError::CutOff { format: FORMAT, missing: "its last line \"End of output\"" });
    }
    for ((size, count), kind) in [heading.rows, heading.columns].into_iter().zip(counts).zip([ROWS, COLUMNS])
    {
        let Some(line) = size else { continue };
        let said = line.words().get(1).and_then(|word| word.parse::<usize>().ok());
        if said.is_some_and(|said| said != count) {
            return Err(line.listed(count, kind));
        }
    }
    Ok(())
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
    // It prints 0 for a value that is at most 10⁻⁹.
    let value = match line.figure(value, PRINTED, limits)? {
        Figure::Finite(printed) if printed.value.is_zero() => left_out(),
        other => other,
    };
    Ok((line.entry(*name, Some(value), price), has_dual_place))
}

/// The 0 that stands for what is at most 10⁻⁹.
fn left_out() -> Figure {
    Figure::Finite(Printed::left_out(Rational::scientific(1, -9)))
}
