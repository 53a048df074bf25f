//! The tables after the region in a report of half-planes or generators: facets, and redundant rows with the reason.

use std::collections::HashMap;

use boundfit_exact::english::{counted, list};
use boundfit_formats::{HalfPlaneFile, RowOrigin};
use boundfit_geometry::{Direction, Generator, Generators, Inequality, Multiplier, Polyhedron, Redundancy};

use super::rows::{redundant_rows, within_equations};
use crate::document::{Block, Table, Text};
use crate::formula::products;
use crate::style::Style;

/// Returns tables about redundancy: the redundant half-planes, or for generators the half-planes that they give, and
/// the redundant generators. Each is a sentence and a table, which has no rows when the sentence says it all.
pub(super) fn table_blocks(
    file: &HalfPlaneFile,
    polyhedron: &Polyhedron,
    style: &Style,
) -> Vec<Block<'static>> {
    let redundant = redundant_rows(file, polyhedron);
    let why = match &file.generators {
        _ if redundant.is_empty() => Vec::new(),
        None => redundancy(file, polyhedron, &redundant, style),
        Some(rows) => redundant_generators(&rows.generators, polyhedron, &redundant),
    };
    let listed = list(redundant.iter().map(ToString::to_string));
    let sentence = if redundant.is_empty() {
        "No row is redundant.".into()
    } else {
        format!("Redundant rows: {listed}")
    };
    let mut blocks = if file.generators.is_some() { facets(polyhedron, style).into() } else { Vec::new() };
    blocks.extend([Block::Lead(sentence.into()), Block::Table(Table::new(["row", "why"], why))]);
    blocks
}

/// The half-planes of a set given by generators.
fn facets(polyhedron: &Polyhedron, style: &Style) -> [Block<'static>; 2] {
    let inequalities = polyhedron.system().inequalities();
    let row = |(number, Inequality { a: [a1, a2], b }): (usize, &Inequality)| {
        let [a1, a2, b] = [a1, a2, b].map(|value| style.proof(value));
        vec![Text::new().number(number), a1, a2, b]
    };
    let sentence = match inequalities.len() {
        0 => "No half-plane bounds it.".to_owned(),
        count => format!("{} a1*theta1 + a2*theta2 <= b", counted(count, "half-plane", "half-planes")),
    };
    let rows = (1..).zip(inequalities).map(row).collect();
    [Block::Lead(sentence.into()), Block::Table(Table::new(["facet", "a1", "a2", "b"], rows))]
}

/// Returns the reason why each of these rows is not needed.
fn redundancy(
    file: &HalfPlaneFile,
    polyhedron: &Polyhedron,
    redundant: &[usize],
    style: &Style,
) -> Vec<Vec<Text>> {
    let mut rows = Vec::new();
    let within = within_equations(file, polyhedron);
    for (index, reason) in polyhedron.redundancies().into_iter().enumerate() {
        let RowOrigin { row, reversed } = file.origins[index];
        let reason = reason.or_else(|| within.get(&index).copied().map(Redundancy::SameAs));
        let Some(reason) = reason.filter(|_| redundant.binary_search(&row).is_ok()) else {
            continue;
        };
        let reason = match reason {
            Redundancy::Always => "holds everywhere".into(),
            Redundancy::SameAs(other) => {
                let RowOrigin { row, reversed } = file.origins[other];
                format!("the same half-plane as row {row}{}", direction(reversed)).into()
            }
            Redundancy::EmptyWithout => "the region is empty without it".into(),
            Redundancy::Dominated { by, slack } if slack.is_zero() => {
                Text::from("touches the region; implied by ").then(products_of(file, &by, style))
            }
            Redundancy::Dominated { by, slack } => {
                let products = Text::from("implied by ").then(products_of(file, &by, style));
                products.words(" with ").number(style.nearest(&slack)).words(" to spare")
            }
        };
        rows.push(vec![format!("{row}{}", direction(reversed)).into(), reason]);
    }
    rows
}

/// Returns the reason why each of these rows is not needed.
fn redundant_generators(
    generators: &Generators,
    polyhedron: &Polyhedron,
    redundant: &[usize],
) -> Vec<Vec<Text>> {
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
    let why = |row: &usize| Some(vec![row.to_string().into(), reason(generator_of(row)?).into()]);
    redundant.iter().filter_map(why).collect()
}

/// `2 * (row 3) + 1/2 * (row 5)`.
pub(super) fn products_of(file: &HalfPlaneFile, multipliers: &[Multiplier], style: &Style) -> Text {
    let what = if file.generators.is_some() { "facet" } else { "row" };
    products(multipliers.iter().map(|multiplier| {
        let RowOrigin { row, reversed } = file.origins[multiplier.index];
        let sign = if reversed { Text::new().mark("-") } else { Text::new() };
        (sign.then(style.proof(&multiplier.value)), format!("{what} {row}"))
    }))
}

/// Returns the text behind a row's number that tells which direction of an equation is meant.
fn direction(reversed: bool) -> &'static str {
    if reversed { " (>=)" } else { "" }
}
