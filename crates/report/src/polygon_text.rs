//! The text report of any half-planes or generators.

use boundfit_exact::Rational;
use boundfit_formats::HalfPlaneFile;
use boundfit_geometry::{Multiplier, Polyhedron};

use crate::document::{Block, Text};
use crate::polygon_rows::rows_of;
use crate::polygon_tables::{polygon_tables, products};
use crate::region::{VERTEX_HEADER, point_text, region_lines, region_text, region_title, vertex_rows};
use crate::style::Style;
use crate::text::{counted, table};

/// The report as text.
pub fn polygon_text(file: &HalfPlaneFile, polyhedron: &Polyhedron, name: &str, style: &Style) -> String {
    let region = polyhedron.region();
    let rows = counted(file.rows, "row", "rows");
    let styles = style.resolving_both(polyhedron.bounding_box().as_ref());
    let names = |indices: &[usize]| row_names(file, indices);
    let what = given(file);
    let mut text = format!("{what} of {name}, {rows}\n\nRegion: {}", region_text(region, &styles, names));
    if let Some(proof) = emptiness(file, polyhedron, style) {
        text.push_str(&format!("  {proof}\n"));
    }
    if let Some(ranges) = ranges(polyhedron, &styles) {
        text.push('\n');
        text.push_str(&table(&RANGE_HEADER, ranges));
    }
    for (label, value) in measures(polyhedron, style, &styles) {
        text.push_str(&format!("  {label:<8}  {value}\n"));
    }
    for part in polygon_tables(file, polyhedron, style) {
        text.push_str(&format!("\n{}\n{}", part.sentence, table(part.header, part.rows)));
    }
    text
}

fn given(file: &HalfPlaneFile) -> &'static str {
    if file.generators.is_some() { "Generators" } else { "Half-planes" }
}

/// The report as blocks.
pub(crate) fn polygon_blocks(
    file: &HalfPlaneFile,
    polyhedron: &Polyhedron,
    name: &str,
    style: &Style,
) -> Vec<Block> {
    let region = polyhedron.region();
    let styles = style.resolving_both(polyhedron.bounding_box().as_ref());
    let names = |indices: &[usize]| row_names(file, indices);
    let rows = counted(file.rows, "row", "rows");
    let data = Text::own(format!("{} of ", given(file)))
        .then(Text::given(name))
        .then(Text::own(format!(", {rows}")));
    let mut blocks = vec![Block::Paragraph(data), Block::Title(format!("Region: {}", region_title(region)))];
    blocks.push(Block::table(&VERTEX_HEADER, vertex_rows(region, &styles, names)));
    let lines = region_lines(region, names).into_iter().chain(emptiness(file, polyhedron, style));
    blocks.extend(lines.map(|line| Block::Paragraph(Text::own(line))));
    blocks.push(Block::table(&RANGE_HEADER, ranges(polyhedron, &styles).unwrap_or_default()));
    let measures = measures(polyhedron, style, &styles).into_iter();
    blocks.push(Block::Facts(measures.map(|(label, value)| (label.to_owned(), Text::own(value))).collect()));
    for part in polygon_tables(file, polyhedron, style) {
        blocks.push(Block::Paragraph(Text::own(part.sentence)));
        blocks.push(Block::table(part.header, part.rows));
    }
    blocks
}

const RANGE_HEADER: [&str; 2] = ["", "range"];

fn row_names(file: &HalfPlaneFile, indices: &[usize]) -> Vec<String> {
    rows_of(file, indices).iter().map(ToString::to_string).collect()
}

/// What proves that an empty region is empty.
fn emptiness(file: &HalfPlaneFile, polyhedron: &Polyhedron, style: &Style) -> Option<String> {
    let certificate = polyhedron.region().certificate()?;
    let products = products(file, certificate.multipliers(), style);
    let right_hand_side = |m: &Multiplier| &polyhedron.system().inequalities()[m.index].b * &m.value;
    let sum: Rational = certificate.multipliers().iter().map(right_hand_side).sum();
    Some(format!("Proof: {products} gives 0 <= {}.", style.upper_text(&sum)))
}

/// The range of each parameter.
fn ranges(polyhedron: &Polyhedron, styles: &[Style; 2]) -> Option<Vec<Vec<String>>> {
    let bounds = polyhedron.bounding_box()?;
    let rows = ["theta1", "theta2"].into_iter().zip(styles).zip(&bounds);
    Some(rows.map(|((name, style), range)| vec![name.to_owned(), style.interval_text(range)]).collect())
}

/// Area, centroid and diameter, where there are such.
fn measures(polyhedron: &Polyhedron, style: &Style, styles: &[Style; 2]) -> Vec<(&'static str, String)> {
    let region = polyhedron.region();
    let area = region.area().filter(|_| !region.is_empty()).map(|area| ("area", style.text(&area)));
    let centroid = region.area_centroid();
    let centroid = centroid.map(|point| ("centroid", point_text(&point.coordinates(), styles)));
    let diameter = region.squared_diameter();
    let diameter = diameter.map(|square| ("diameter", format!("square root of {}", style.text(&square))));
    area.into_iter().chain(centroid).chain(diameter).collect()
}
