//! The report of any half-planes or generators. Only here and below the crate knows their files.

mod json;
mod rows;
mod tables;

use boundfit_exact::english::{counted, list};
use boundfit_exact::{Foreign, Integer, Rational};
use boundfit_formats::{HalfPlaneFile, TableNotes};
use boundfit_geometry::{Multiplier, Polyhedron};

use crate::document::{Block, Document, Facts, THETA, Table, Text};
use crate::formula::absurdity;
use crate::region::{measured_point, region_blocks};
use crate::scale::{Scale, scales};
use crate::style::Style;
use rows::rows_of;
use tables::{products_of, table_blocks};

pub use json::polygon_json;

/// The report of half-planes or generators that were read from a file of this name.
pub fn polygon_document<'a>(
    file: &'a HalfPlaneFile,
    polyhedron: &'a Polyhedron,
    name: Foreign<&str>,
    style: &Style,
) -> Document<'a> {
    let ranges = polyhedron.bounding_box();
    let scales = scales(style, ranges.as_ref(), &[], &[], || polyhedron.homogeneous_vertices());
    let what = if file.generators.is_some() { "Generators of " } else { "Half-planes of " };
    let data = Text::from(what).given(name).words(format!(", {}", counted(file.rows, "row", "rows")));
    let names = move |indices: &[usize]| list(rows_of(file, indices).iter().map(ToString::to_string));
    let mut blocks = vec![Block::Lead(data)];
    let table = file.table.as_ref().and_then(TableNotes::words);
    let table = table.map(|words| vec![("table".into(), words.into())]);
    blocks.extend(table.map(|rows| Block::Facts(Facts { width: 8, rows })));
    blocks.extend(region_blocks("Region", polyhedron, &scales, names));
    blocks.extend(emptiness(file, polyhedron, style).map(Block::Paragraph));
    if let Some(bounds) = &ranges {
        let row = |axis: usize| vec![THETA[axis].into(), scales[axis].interval(&bounds[axis])];
        blocks.push(Block::Space);
        blocks.push(Block::Table(Table::new(["", "range"], [0, 1].map(row).into())));
    }
    blocks.push(Block::Facts(Facts { width: 8, rows: measures(polyhedron, style, &scales) }));
    blocks.extend(table_blocks(file, polyhedron, style));
    Document::new(blocks)
}

/// The proof that an empty region is empty.
fn emptiness(file: &HalfPlaneFile, polyhedron: &Polyhedron, style: &Style) -> Option<Text> {
    let multipliers = polyhedron.region().certificate()?.multipliers();
    let right_hand_side = |m: &Multiplier| &polyhedron.system().inequalities()[m.index].b * &m.value;
    let sum: Rational = multipliers.iter().map(right_hand_side).sum();
    let products = Text::from("Proof: ").then(products_of(file, multipliers, style));
    Some(absurdity(products, &sum, style).words("."))
}

/// Area, centroid and diameter, where there are such.
fn measures(polyhedron: &Polyhedron, style: &Style, scales: &[Scale; 2]) -> Vec<(Text, Text)> {
    let region = polyhedron.region();
    let measured = region.measures();
    let area = measured.area().filter(|_| !region.is_empty()).map(|area| ("area", style.measure(&area)));
    let centroid = measured.centroid().map(|centroid| ("centroid", measured_point(&centroid, scales)));
    let diameter = region.squared_diameter();
    let square_root = |square: Rational| match root(&square) {
        Some(root) => Text::new().number(style.nearest(&root)),
        None => Text::from("square root of ").number(style.nearest(&square)),
    };
    let diameter = diameter.map(|square| ("diameter", square_root(square)));
    let measures = area.into_iter().chain(centroid).chain(diameter);
    measures.map(|(label, text)| (label.into(), text)).collect()
}

/// Returns the root of the square of a fraction with terms of at most 64 bits, exactly.
fn root(square: &Rational) -> Option<Rational> {
    let whole = |term: Integer| term.to_i128()?.checked_isqrt().map(Integer::from);
    let root = Rational::new(whole(square.numerator())?, whole(square.denominator())?)?;
    (&root * &root == *square).then_some(root)
}
