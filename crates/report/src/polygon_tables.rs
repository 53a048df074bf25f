//! What follows the region in a report of half-planes or generators: the facets, and which rows are redundant and why.

use std::collections::HashMap;

use boundfit_formats::{HalfPlaneFile, RowOrigin};
use boundfit_geometry::{Direction, Generator, Generators, Inequality, Multiplier, Polyhedron, Redundancy};

use crate::polygon_rows::redundant_rows;
use crate::style::Style;
use crate::text::{counted, list};

const REDUNDANCY_HEADER: [&str; 2] = ["row", "why"];
const FACET_HEADER: [&str; 4] = ["facet", "a1", "a2", "b"];

/// A sentence, and the table that goes with it; without rows when the sentence says it all.
pub(crate) struct PolygonTable {
    pub(crate) sentence: String,
    pub(crate) header: &'static [&'static str],
    pub(crate) rows: Vec<Vec<String>>,
}

/// Of half-planes which are redundant; of generators the half-planes that they give, and which are redundant.
pub(crate) fn polygon_tables(
    file: &HalfPlaneFile,
    polyhedron: &Polyhedron,
    style: &Style,
) -> Vec<PolygonTable> {
    let redundant = redundant_rows(file, polyhedron);
    let why = match &file.generators {
        _ if redundant.is_empty() => Vec::new(),
        None => redundancy(file, polyhedron, &redundant, style),
        Some(rows) => redundant_generators(&rows.generators, polyhedron, &redundant),
    };
    let listed = list(redundant.iter().map(ToString::to_string));
    let sentence = if redundant.is_empty() {
        "No row is redundant.".to_owned()
    } else {
        format!("Redundant rows: {listed}")
    };
    let redundancy = PolygonTable { sentence, header: &REDUNDANCY_HEADER, rows: why };
    let facets = file.generators.is_some().then(|| facets(polyhedron, style));
    facets.into_iter().chain([redundancy]).collect()
}

/// The half-planes of a set given by generators.
fn facets(polyhedron: &Polyhedron, style: &Style) -> PolygonTable {
    let inequalities = polyhedron.system().inequalities();
    let row = |(number, Inequality { a: [a1, a2], b }): (usize, &Inequality)| {
        let [a1, a2, b] = [a1, a2, b].map(|value| style.proof_text(value));
        vec![number.to_string(), a1, a2, b]
    };
    let rows = (1..).zip(inequalities).map(row).collect();
    let sentence = match inequalities.len() {
        0 => "No half-plane bounds it.".to_owned(),
        count => format!("{} a1*theta1 + a2*theta2 <= b", counted(count, "half-plane", "half-planes")),
    };
    PolygonTable { sentence, header: &FACET_HEADER, rows }
}

/// Why each of these rows is not needed.
fn redundancy(
    file: &HalfPlaneFile,
    polyhedron: &Polyhedron,
    redundant: &[usize],
    style: &Style,
) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for (index, reason) in polyhedron.redundancies().iter().enumerate() {
        let RowOrigin { row, reversed } = file.origins[index];
        let Some(reason) = reason.as_ref().filter(|_| redundant.binary_search(&row).is_ok()) else {
            continue;
        };
        let reason = match reason {
            Redundancy::Always => "holds everywhere".to_owned(),
            Redundancy::SameAs(other) => {
                let RowOrigin { row, reversed } = file.origins[*other];
                format!("the same half-plane as row {row}{}", if reversed { " (>=)" } else { "" })
            }
            Redundancy::EmptyWithout => "the region is empty without it".to_owned(),
            Redundancy::Dominated { by, slack } if slack.is_zero() => {
                format!("touches the region; implied by {}", products(file, by, style))
            }
            Redundancy::Dominated { by, slack } => {
                format!("implied by {} with {} to spare", products(file, by, style), style.text(slack))
            }
        };
        let direction = if reversed { " (>=)" } else { "" };
        rows.push(vec![format!("{row}{direction}"), reason]);
    }
    rows
}

/// Why each of these rows is not needed.
fn redundant_generators(
    generators: &Generators,
    polyhedron: &Polyhedron,
    redundant: &[usize],
) -> Vec<Vec<String>> {
    let mut needed: HashMap<&Generator, usize> = HashMap::new();
    let mut directions: HashMap<Direction, usize> = HashMap::new();
    for index in generators.irredundant(polyhedron.region()) {
        match generators.as_slice().get(index) {
            Some(Generator::Ray(ray)) => {
                directions.insert(ray.clone(), index + 1);
            }
            Some(Generator::Line(line)) => {
                directions.extend([(line.clone(), index + 1), (line.reversed(), index + 1)]);
            }
            Some(generator) => {
                needed.insert(generator, index + 1);
            }
            None => {}
        }
    }
    let reason = |generator: &Generator| match generator {
        Generator::Zero => "has no direction".to_owned(),
        Generator::Point(_) => match needed.get(generator) {
            Some(row) => format!("the same point as row {row}"),
            None => "a point of the set that the others generate".to_owned(),
        },
        Generator::Ray(direction) | Generator::Line(direction) => match directions.get(direction) {
            Some(row) => format!("the same direction as row {row}"),
            None => "a direction that the others generate".to_owned(),
        },
    };
    let generator_of = |row: &usize| generators.as_slice().get(row.checked_sub(1)?);
    let why = |row: &usize| Some(vec![row.to_string(), reason(generator_of(row)?)]);
    redundant.iter().filter_map(why).collect()
}

/// `2 * (row 3) + 1/2 * (row 5)`.
pub(crate) fn products(file: &HalfPlaneFile, multipliers: &[Multiplier], style: &Style) -> String {
    let product = |multiplier: &Multiplier| {
        let RowOrigin { row, reversed } = file.origins[multiplier.index];
        let sign = if reversed { "-" } else { "" };
        let what = if file.generators.is_some() { "facet" } else { "row" };
        format!("{sign}{} * ({what} {row})", style.proof_text(&multiplier.value))
    };
    let products: Vec<String> = multipliers.iter().map(product).collect();
    products.join(" + ")
}
