//! Files in which solvers write what they answer, each format as its writer documents it.

mod cbc;
mod cost_row;
mod cplex;
mod error;
mod figure;
mod given;
mod glpk;
mod gurobi;
mod highs;
mod json;
mod line;
mod printed;
mod scip;
#[cfg(test)]
mod tests;

use boundfit_exact::{Limits, Rational};

pub use error::{SolutionError, quoted};
pub use figure::Figure;
pub use given::{Given, NotFinite, Part, Solution};

/// The end that a solver reports.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SolverStatus {
    /// An optimum.
    Optimal,
    /// No feasible point.
    Infeasible,
    /// No optimum, because the objective improves for ever.
    Unbounded,
    /// One of the two.
    InfeasibleOrUnbounded,
    /// No answer, in the solver's own words.
    Other(String),
}

impl SolverStatus {
    /// The status that words say, as far as solvers agree on them.
    pub fn of_words(words: &str) -> Self {
        let lower = words.trim().to_ascii_lowercase();
        let is_infeasible = lower.contains("infeasible");
        // "optimality not proven" is no optimum, and an optimum of relaxed rows is one of another program.
        let begins = |word| lower.strip_prefix(word).is_some_and(|rest: &str| !rest.starts_with(is_of_word));
        match lower.as_str() {
            // GLPK calls a point of its way there so.
            "infeasible (intermediate)" => SolverStatus::Other(words.trim().to_owned()),
            _ if is_infeasible && lower.contains("unbounded") => SolverStatus::InfeasibleOrUnbounded,
            _ if begins("optimal") && !lower.contains("relaxed") => SolverStatus::Optimal,
            _ if begins("unbounded") => SolverStatus::Unbounded,
            _ if begins("infeasible") || lower == "integer infeasible" => SolverStatus::Infeasible,
            _ => SolverStatus::Other(words.trim().to_owned()),
        }
    }
}

/// Returns whether a word goes on with a character.
fn is_of_word(character: char) -> bool {
    character.is_alphanumeric() || "_-?".contains(character)
}

/// The reference of a file to a column or a row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Reference {
    /// The name.
    Name(String),
    /// The place in the model, from 0.
    Place(usize),
}

impl From<&str> for Reference {
    fn from(name: &str) -> Self {
        Reference::Name(name.to_owned())
    }
}

/// The entries of a file about one column or row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// The column or row.
    pub of: Reference,
    /// The line that says so, from 1.
    pub line: usize,
    /// The column's value or the row's activity.
    pub value: Option<Figure>,
    /// The column's reduced cost or the row's dual.
    pub price: Option<Figure>,
    /// The line of the price, from 1.
    pub price_line: usize,
}

/// A size that a file announces, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Announced {
    /// The number of columns.
    pub columns: usize,
    /// The line that says so, from 1.
    pub line: usize,
    /// The text of the line.
    pub text: String,
}

/// The content of a solution file, whatever its format. Numbers are exactly those of the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SolutionFile {
    /// The program that writes such files.
    pub writer: &'static str,
    /// The names that the file gives its problem and its objective.
    pub about: Vec<String>,
    /// The end of the solver, and the line that says so, from 1.
    pub status: SolverStatus,
    /// The line of the status, from 1.
    pub status_line: usize,
    /// The optimum that is claimed, and the line that says so.
    pub objective: Option<(Figure, usize)>,
    /// The columns, in the order of the file.
    pub columns: Vec<Entry>,
    /// The rows, in the order of the file, the objective left out where the file names it.
    pub rows: Vec<Entry>,
    /// A direction in which the objective is said to improve for ever, by column.
    pub ray: Option<Vec<Entry>>,
    /// Multipliers of rows that are said to prove that there is no feasible point. Positive ones take the lower bound
    /// of their row, negative ones the upper one; the bounds of columns take the rest.
    pub farkas: Option<Vec<Entry>>,
    /// True if rows have slacks, which are not read.
    pub has_slacks: bool,
    /// True if the file has duals of rows.
    pub has_duals: bool,
    /// True if a row or column that the file does not list has the price 0. The prices of rows of any other file are whole, or not
    /// looked at.
    pub omits_zero_duals: bool,
    /// Columns that the writer leaves out are at most this large; `None` where it writes all of them.
    pub left_out: Option<Rational>,
    /// The size that the file announces.
    pub announced: Option<Announced>,
}

impl SolutionFile {
    fn new(writer: &'static str) -> Self {
        SolutionFile {
            writer,
            about: Vec::new(),
            status: SolverStatus::Other("not in the file".to_owned()),
            status_line: 1,
            objective: None,
            columns: Vec::new(),
            rows: Vec::new(),
            ray: None,
            farkas: None,
            has_slacks: false,
            has_duals: false,
            omits_zero_duals: false,
            left_out: None,
            announced: None,
        }
    }
}

/// Reads a solution file of any known format; its content tells which. Cost: a few looks at each byte.
///
/// # Errors
/// When something is wrong with the file; the error names the line.
pub fn read_solution(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    type Is = fn(&str) -> bool;
    type Parse = fn(&str, &Limits) -> Result<SolutionFile, SolutionError>;
    let formats: [(Is, Parse); 11] = [
        (json::is_json, json::parse),
        (cplex::is_xml, cplex::parse),
        (highs::is_raw, highs::parse_raw),
        (highs::is_table, highs::parse_table),
        (highs::is_old, highs::refuse_old),
        (printed::is_it, printed::parse),
        (cbc::is_cbc, cbc::parse_cbc),
        (cbc::is_clp, cbc::parse_clp),
        (scip::is_scip, scip::parse),
        (gurobi::is_gurobi, gurobi::parse),
        (glpk::is_plain, glpk::parse_plain),
    ];
    let parse = formats.into_iter().find(|(is_it, _)| is_it(text)).map(|(_, parse)| parse);
    parse.ok_or(SolutionError::UnknownFormat)?(text, limits)
}
