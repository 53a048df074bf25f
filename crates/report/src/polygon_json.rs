//! The JSON report of any half-planes, schema `boundfit/polygon/1`.

use boundfit_exact::{Rational, Reading};
use boundfit_formats::{HalfPlaneFile, RowOrigin};
use boundfit_geometry::{Multiplier, Polyhedron, Support};
use serde::Serialize;

use crate::fit_json::to_text;
use crate::region::{BoundJson, IntervalJson, RegionJson, TermJson};
use crate::style::{Number, Style};

#[derive(Serialize)]
struct PolygonJson {
    schema: &'static str,
    input: InputJson,
    region: RegionJson<usize>,
    redundant: Vec<usize>,
    bounds: Option<[IntervalJson; 2]>,
    area_centroid: Option<[Number; 2]>,
    squared_diameter: Option<Number>,
}

#[derive(Serialize)]
struct InputJson {
    rows: usize,
    reading: &'static str,
    sha256: String,
}

/// The report as JSON, with a line end. Half-planes are named by their row in the file, from 1; the bound is `upper`
/// for a row as given and `lower` for the other direction of an equation.
pub fn polygon_json(
    file: &HalfPlaneFile,
    polyhedron: &Polyhedron,
    reading: Reading,
    style: &Style,
) -> String {
    let region = polyhedron.region();
    let farkas = region
        .certificate()
        .map(|certificate| certificate.multipliers().iter().map(|m| term(file, m, style)).collect());
    let numbers = |theta: &[Rational; 2]| theta.each_ref().map(|value| style.number(value));
    let report = PolygonJson {
        schema: "boundfit/polygon/1",
        input: InputJson { rows: file.rows, reading: reading.name(), sha256: file.sha256.clone() },
        region: RegionJson::new(region, style, |indices| rows_of(file, indices), farkas),
        redundant: redundant_rows(file, polyhedron),
        bounds: bounds(file, polyhedron, style),
        area_centroid: region.area_centroid().map(|point| numbers(&point.coordinates())),
        squared_diameter: region.squared_diameter().map(|diameter| style.number(&diameter)),
    };
    to_text(&report)
}

/// The rows of the file behind inequalities, ascending, each once.
pub(crate) fn rows_of(file: &HalfPlaneFile, indices: &[usize]) -> Vec<usize> {
    let mut rows: Vec<usize> = indices.iter().map(|&index| file.origins[index].row).collect();
    rows.sort_unstable();
    rows.dedup();
    rows
}

/// The rows that could be left out together; an equation only when both of its directions could.
pub(crate) fn redundant_rows(file: &HalfPlaneFile, polyhedron: &Polyhedron) -> Vec<usize> {
    let needed = rows_of(file, &polyhedron.irredundant());
    let all: Vec<usize> = (0..file.origins.len()).collect();
    rows_of(file, &all).into_iter().filter(|row| needed.binary_search(row).is_err()).collect()
}

fn term(file: &HalfPlaneFile, multiplier: &Multiplier, style: &Style) -> TermJson {
    let RowOrigin { row, reversed } = file.origins[multiplier.index];
    let bound = if reversed { "lower" } else { "upper" }.to_owned();
    TermJson { row: Some(row), bound, multiplier: style.number(&multiplier.value) }
}

fn bounds(file: &HalfPlaneFile, polyhedron: &Polyhedron, style: &Style) -> Option<[IntervalJson; 2]> {
    let end = |form: [Rational; 2], number: &dyn Fn(&Rational) -> Number| match polyhedron.support(&form) {
        Support::Empty(_) => None,
        Support::Unbounded(_) => Some(BoundJson { value: None, active: Vec::new() }),
        Support::Bounded { proof, .. } => {
            let active = proof.multipliers.iter().map(|m| term(file, m, style)).collect();
            Some(BoundJson { value: Some(number(&proof.value)), active })
        }
    };
    let interval = |theta1: i64, theta2: i64| {
        let form = |sign: i64| [theta1 * sign, theta2 * sign].map(Rational::from);
        Some(IntervalJson {
            lower: end(form(-1), &|value| style.lower_number(&-value))?,
            upper: end(form(1), &|value| style.upper_number(value))?,
        })
    };
    let bounds = [interval(1, 0)?, interval(0, 1)?];
    let any = bounds.iter().any(|interval| interval.lower.value.is_some() || interval.upper.value.is_some());
    any.then_some(bounds)
}
