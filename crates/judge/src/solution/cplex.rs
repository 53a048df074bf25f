//! CPLEX: solution files in XML.
//!
//! Source: IBM, "SOL file format"; the names of the elements and attributes are those of `solution.xsd`.

use boundfit_exact::Limits;
use boundfit_lp::NumberFormat;
use roxmltree::{Document, Node, ParsingOptions};

use super::error::SolutionError;
use super::line::Line;
use super::{Entry, Reference, SolutionFile, SolverStatus};

const FORMAT: &str = "CPLEX";
const DIGITS: NumberFormat = NumberFormat::FIFTEEN;

/// Returns whether a text is XML.
pub(super) fn is_xml(text: &str) -> bool {
    text.trim_start_matches('\u{feff}').trim_start().starts_with('<')
}

/// Reads a solution in XML, the first one of a pool of them. A document type definition is refused.
pub(super) fn parse(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let options = ParsingOptions { allow_dtd: false, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options)?;
    let missing = |missing| SolutionError::End { format: FORMAT, missing };
    let solution = document.descendants().find(|node| node.has_tag_name("CPLEXSolution"));
    let solution = solution.ok_or(missing("an element <CPLEXSolution>"))?;
    let header = child(solution, "header").ok_or(missing("an element <header>"))?;
    let words =
        header.attribute("solutionStatusString").ok_or(missing("an attribute solutionStatusString"))?;
    let mut file = SolutionFile::new(FORMAT);
    let is_feasible = header.attribute("primalFeasible") == Some("1");
    (file.status, file.status_line) = (status(words, is_feasible), line(text, header).number);
    file.about.extend(header.attribute("problemName").map(str::to_owned));
    if let Some(value) = header.attribute("objectiveValue") {
        let line = line(text, header);
        file.objective = Some((line.figure(value, DIGITS, limits)?, line.number));
    }
    if file.status != SolverStatus::Optimal {
        return Ok(file);
    }
    let variables = child(solution, "variables").ok_or(missing("an element <variables>"))?;
    for node in variables.children().filter(|node| node.has_tag_name("variable")) {
        file.columns.push(variable(text, node, limits)?);
    }
    let rows = child(solution, "linearConstraints");
    let rows = rows.iter().flat_map(Node::children).filter(|node| node.has_tag_name("constraint"));
    for (place, node) in rows.enumerate() {
        let line = line(text, node);
        let price = node.attribute("dual").map(|dual| line.figure(dual, DIGITS, limits)).transpose()?;
        file.has_slacks |= node.has_attribute("slack");
        let of = node.attribute("name").map_or(Reference::Place(place), Reference::from);
        file.rows.push(line.entry(of, None, price));
    }
    // Integer programs have none.
    file.has_duals = file.rows.iter().all(|row| row.price.is_some());
    Ok(file)
}

fn variable(text: &str, node: Node<'_, '_>, limits: &Limits) -> Result<Entry, SolutionError> {
    let line = line(text, node);
    let expected = || line.expected("<variable name=... value=.../>");
    let name = node.attribute("name").ok_or_else(expected)?;
    let value = node.attribute("value").ok_or_else(expected)?;
    let price = node.attribute("reducedCost").map(|cost| line.figure(cost, DIGITS, limits)).transpose()?;
    Ok(line.entry(name, Some(line.figure(value, DIGITS, limits)?), price))
}

fn child<'a, 'input>(parent: Node<'a, 'input>, name: &'static str) -> Option<Node<'a, 'input>> {
    parent.children().find(|node| node.has_tag_name(name))
}

fn line<'a>(text: &'a str, node: Node<'_, '_>) -> Line<'a> {
    let range = node.range();
    let number = node.document().text_pos_at(range.start).row as usize;
    Line { format: FORMAT, number, text: text.get(range).unwrap_or_default() }
}

/// The status in CPLEX's words, beside a point that is feasible or not. Without one, its "unbounded" means that the objective would
/// improve for ever: it "does not include that the model has been proven to be feasible" (IBM, `IloCplex::getStatus`).
fn status(words: &str, is_feasible: bool) -> SolverStatus {
    match words {
        "integer optimal solution" | "integer optimal, tolerance" => SolverStatus::Optimal,
        other => match SolverStatus::of_words(other.trim_start_matches("integer ")) {
            SolverStatus::Unbounded if !is_feasible => SolverStatus::InfeasibleOrUnbounded,
            status => status,
        },
    }
}
