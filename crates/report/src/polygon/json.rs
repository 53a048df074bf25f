//! The JSON report of any half-planes or generators, schema `boundfit/polygon/2`.

use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_formats::{HalfPlaneFile, RowOrigin};
use boundfit_geometry::{Inequality, Multiplier, Polyhedron, Support};

use super::rows::{redundant_rows, rows_of};
use crate::answer::parts::{BoundJson, IntervalJson, RegionJson, RowNumberJson, TermJson};
use crate::answer::polygon::{HalfPlaneFileJson, HalfPlaneJson, PolygonJson};
use crate::answer::table::TableJson;
use crate::json::{centroid_json, long_fractions, to_text};
use crate::number::Number;
use crate::style::Style;

/// The report as JSON, with a line end, about the file of this name; `None` for standard input. Half-planes are named by their row in the file, from 1; the bound is `upper`
/// for a row as given and `lower` for the other direction of an equation.
///
/// The rows of a V-representation are generators. Active at a vertex are the points that equal it, and at a boundary
/// the points on it. Redundant rows are generators, too. The half-planes are then listed as `facets`, and named in
/// proofs by their number there, from 1, with the bound `facet`.
pub fn polygon_json(
    file: &HalfPlaneFile,
    polyhedron: &Polyhedron,
    name: Option<Foreign<&str>>,
    reading: Reading,
    style: &Style,
) -> String {
    let region = polyhedron.region();
    let farkas = region
        .certificate()
        .map(|certificate| certificate.multipliers().iter().map(|m| term(file, m, style)).collect());
    let measures = region.measures();
    let area_centroid = centroid_json(&measures, style);
    let active = |indices: &[usize]| {
        let rows = rows_of(file, indices).into_iter();
        rows.map(RowNumberJson).collect::<Vec<_>>().into()
    };
    let region_json = RegionJson::new(region, &measures, style, active, farkas);
    let reasons = long_fractions("region.area", region_json.area(), area_centroid.as_ref(), style).collect();
    let report = PolygonJson {
        schema: PolygonJson::SCHEMA,
        input: HalfPlaneFileJson {
            file: name.map(Foreign::from),
            rows: file.rows,
            table: file.table.as_ref().map(TableJson::new),
            reading: reading.name(),
            sha256: file.sha256.clone(),
        },
        region: region_json,
        facets: file.generators.is_some().then(|| facets(polyhedron, style)),
        redundant: redundant_rows(file, polyhedron),
        bounds: bounds(file, polyhedron, style),
        area_centroid,
        squared_diameter: region.squared_diameter().map(|diameter| style.number(&diameter)),
        reasons,
    };
    to_text(&report)
}

fn facets(polyhedron: &Polyhedron, style: &Style) -> Vec<HalfPlaneJson> {
    let facet = |Inequality { a, b }: &Inequality| HalfPlaneJson { a: style.numbers(a), b: style.number(b) };
    polyhedron.system().inequalities().iter().map(facet).collect()
}

fn term(file: &HalfPlaneFile, multiplier: &Multiplier, style: &Style) -> TermJson {
    let RowOrigin { row, reversed } = file.origins[multiplier.index];
    let bound = match (&file.generators, reversed) {
        (Some(_), _) => "facet",
        (None, true) => "lower",
        (None, false) => "upper",
    };
    TermJson { row: Some(row), bound: bound.to_owned(), multiplier: style.number(&multiplier.value) }
}

fn bounds(file: &HalfPlaneFile, polyhedron: &Polyhedron, style: &Style) -> Option<[IntervalJson; 2]> {
    let end = |form: [Rational; 2], number: &dyn Fn(&Rational) -> Number| match polyhedron.support(&form) {
        Support::Empty(_) => None,
        Support::Unbounded(_) => Some(BoundJson::unbounded(style)),
        Support::Bounded { proof, .. } => {
            let active = proof.multipliers.iter().map(|m| term(file, m, style)).collect();
            Some(BoundJson::proved(number(&proof.value), active))
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
    let any = bounds.iter().any(|interval| interval.lower.is_bounded() || interval.upper.is_bounded());
    any.then_some(bounds)
}
