//! CPLEX: solution files in XML.
//!
//! Source: IBM, "SOL file format"; the names of the elements and attributes are those of `solution.xsd`.

use boundfit_exact::Limits;
use roxmltree::{Document, Node, ParsingOptions};

use boundfit_lp::PuiEnd;

use super::error::ClaimError;
use super::solution::{Line, PrintedPoint, Solution, Status};

const FORMAT: &str = "CPLEX";

/// Whether a text is XML.
pub(super) fn is_xml(text: &str) -> bool {
    text.trim_start_matches('\u{feff}').trim_start().starts_with('<')
}

/// Reads a solution in XML, the first one of a pool of them. A document type definition is refused.
pub(super) fn parse(text: &str, limits: &Limits) -> Result<Solution, ClaimError> {
    let options = ParsingOptions { allow_dtd: false, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options)?;
    let missing = |missing| ClaimError::End { format: FORMAT, missing };
    let solution = document.descendants().find(|node| node.has_tag_name("CPLEXSolution"));
    let solution = solution.ok_or(missing("an element <CPLEXSolution>"))?;
    let child = |parent: Node<'_, '_>, name: &'static str| {
        let found = parent.children().find(|node| node.has_tag_name(name)).map(|node| node.id());
        found.and_then(|id| document.get_node(id))
    };
    let header = child(solution, "header").ok_or(missing("an element <header>"))?;
    let status = header.attribute("solutionStatusString").map(status);
    let status = status.ok_or(missing("an attribute solutionStatusString"))?;
    let target = header.attribute("problemName").and_then(PuiEnd::find).map(|(_, target, _)| target);
    if status != Status::Optimal {
        return Ok(Solution { format: FORMAT, target, status, point: None, duals: None });
    }
    let line = |node: Node<'_, '_>| {
        let (number, start) = (document.text_pos_at(node.range().start).row as usize, node.range());
        Line { format: FORMAT, number, text: text.get(start).unwrap_or_default() }
    };
    let mut point = PrintedPoint::default();
    let variables = child(solution, "variables").ok_or(missing("an element <variables>"))?;
    for node in variables.children().filter(|node| node.has_tag_name("variable")) {
        let expected = || line(node).expected("<variable name=... value=.../>");
        let name = node.attribute("name").ok_or_else(expected)?;
        let value = node.attribute("value").ok_or_else(expected)?;
        point.set(name, line(node).number(value, limits)?);
    }
    let mut duals = Vec::new();
    let rows = child(solution, "linearConstraints");
    let rows = rows.iter().flat_map(|rows| rows.children()).filter(|node| node.has_tag_name("constraint"));
    for node in rows {
        duals.push(node.attribute("dual").map(|dual| line(node).dual(dual, limits)).transpose()?);
    }
    // Integer programs have none.
    let duals = duals.into_iter().collect::<Option<Vec<f64>>>();
    let point = point.finish().map_err(missing)?;
    Ok(Solution { format: FORMAT, target, status, point, duals })
}

/// The status in CPLEX's words.
fn status(words: &str) -> Status {
    match words {
        "integer optimal solution" | "integer optimal, tolerance" => Status::Optimal,
        // "optimal with unscaled infeasibilities" is an optimum too, and as good as its numbers.
        _ if words.starts_with("optimal") => Status::Optimal,
        other => Status::of_words(other.trim_start_matches("integer ")),
    }
}
