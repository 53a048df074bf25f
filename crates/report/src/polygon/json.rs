//! The JSON report of any half-planes or generators, schema `boundfit/polygon/2`.

use boundfit_estimation::parameter_intervals;
use boundfit_exact::{Foreign, Reading};
use boundfit_formats::{HalfPlaneFile, RowOrigin};
use boundfit_geometry::{Inequality, Polyhedron};

use super::rows::{redundant_rows, rows_of};
use crate::answer::parts::{ActiveJson, CertificateJson, IntervalJson, RegionJson, RowNumberJson, TermJson};
use crate::answer::polygon::{HalfPlaneFileJson, HalfPlaneJson, PolygonJson};
use crate::answer::table::TableJson;
use crate::json::{centroid_json, long_fractions, to_text};
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
    let name_of = |index: usize| name_of(file, index);
    let certificate = region.certificate().map(|certificate| CertificateJson {
        farkas: TermJson::named(certificate.multipliers(), name_of, style),
    });
    let measures = region.measures();
    let area_centroid = centroid_json(&measures, style);
    let active = |indices: &[usize]| {
        let rows = rows_of(file, indices).into_iter();
        rows.map(RowNumberJson).collect::<Vec<_>>().into()
    };
    let region_json = RegionJson::new(region, &measures, style, active, certificate);
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
        bounds: parameter_intervals(polyhedron).and_then(|pui| IntervalJson::both(&pui, name_of, style)),
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

/// The name of a half-plane by its row, or of a facet.
fn name_of(file: &HalfPlaneFile, index: usize) -> ActiveJson {
    let RowOrigin { row, reversed } = file.origins[index];
    let bound = match (&file.generators, reversed) {
        (Some(_), _) => "facet",
        (None, true) => "lower",
        (None, false) => "upper",
    };
    ActiveJson { row: Some(row), bound: bound.into() }
}
