//! Outliers as JSON, schema `boundfit/outliers/1`.

use std::collections::BTreeMap;

use boundfit_estimation::{Measurement, Problem, Ties};
use boundfit_exact::Rational;
use boundfit_geometry::{Direction, Measure, Vertex};
use boundfit_questions::{Growth, NoOutliers, Outliers, Piece};

use super::OutliersReport;
use crate::answer::input::InputJson;
use crate::answer::outliers::{GrowthJson, LeftRegionJson, MissedJson, OutliersJson};
use crate::answer::parts::{ActiveJson, ActiveListJson, CertificateJson, RangeJson, VertexJson};
use crate::json::to_text;
use crate::number::Number;
use crate::origin::Origin;
use crate::style::Style;

/// The number of rows in all for which the report has the amounts by which they are missed.
const MOST_TOLD: usize = 20_000;

/// The report as indented JSON, with a line end.
pub fn outliers_json(report: &OutliersReport, origin: &Origin, style: &Style) -> String {
    let outliers = report.outliers.ok();
    let pieces = outliers.map(|outliers| outliers.pieces.as_slice()).unwrap_or_default();
    let mut told = 0;
    let regions: Vec<LeftRegionJson> = pieces
        .iter()
        .map(|piece| {
            told += piece.rows.len();
            region(report.problem, piece, told <= MOST_TOLD, style)
        })
        .collect();
    let area = outliers.and_then(Outliers::area);
    let growth: Vec<GrowthJson> = report.growth.iter().map(|growth| growth_json(growth, style)).collect();
    let mut reasons = BTreeMap::new();
    if told > MOST_TOLD {
        reasons.insert("regions.missed", format!("told of the first sets, of at most {MOST_TOLD} rows"));
    }
    let areas = regions.iter().filter_map(|region| region.area.as_ref());
    let mut areas = areas.chain(growth.iter().filter_map(|growth| growth.area.as_ref()));
    if areas.any(Number::lacks_fraction) {
        reasons.insert("area", style.too_long());
    }
    let certificate = match report.outliers {
        Err(NoOutliers::Conditions(terms)) => {
            reasons.insert("least", "the conditions contradict each other, whatever is left out".to_owned());
            Some(CertificateJson::new(terms, style))
        }
        _ => None,
    };
    to_text(&OutliersJson {
        schema: OutliersJson::SCHEMA,
        input: InputJson::new(report.problem, origin, style),
        least: outliers.map(|outliers| outliers.least),
        sets: pieces.iter().map(|piece| piece.rows.clone()).collect(),
        complete: outliers.is_none_or(|outliers| outliers.is_complete),
        pieces: pieces.iter().map(|piece| vertices(piece, style)).collect(),
        regions,
        pui: outliers.and_then(Outliers::pui).map(|pui| RangeJson::both(&pui, style)),
        area: area.map(|area| style.measure_number(&Measure::of(&area))),
        growth,
        certificate,
        reasons,
    })
}

fn vertices(piece: &Piece, style: &Style) -> Vec<VertexJson<Number, ActiveJson>> {
    let vertex = |vertex: &Vertex| VertexJson {
        theta: style.numbers(&vertex.point().coordinates()),
        active: names(piece, vertex.active()),
    };
    piece.left.polyhedron().region().vertices().iter().map(vertex).collect()
}

fn names(piece: &Piece, indices: &[usize]) -> ActiveListJson<ActiveJson> {
    (&piece.left.active(indices, Ties::MOST_LISTED)).into()
}

fn region(problem: &Problem, piece: &Piece, tells_missed: bool, style: &Style) -> LeftRegionJson {
    let polyhedron = piece.left.polyhedron();
    let region = polyhedron.region();
    let direction = |d: &Direction| [d.dx(), d.dy()].map(|c| style.number(&Rational::from(c)));
    let missed = |(row, reading): (usize, &Measurement)| {
        let missed = piece.missed_by(reading);
        let bound = missed.as_ref().map(|(name, _)| match name {
            boundfit_estimation::BoundName::Lower(_) => "lower",
            _ => "upper",
        });
        let by = missed.map(|(_, by)| RangeJson::new(&by, style));
        MissedJson { row, bound, by }
    };
    LeftRegionJson {
        kind: region.kind().name(),
        rays: region.rays().iter().map(direction).collect(),
        lines: region.lines().iter().map(direction).collect(),
        boundaries: region.boundaries().iter().map(|own| names(piece, own.active())).collect(),
        witness: region.witness().map(|point| style.numbers(&point.coordinates())),
        pui: polyhedron.bounding_box().map(|pui| RangeJson::both(&pui, style)),
        area: region.measures().area().map(|area| style.measure_number(&area)),
        missed: tells_missed
            .then(|| problem.measurements.readings_of(&piece.rows).into_iter().map(missed).collect()),
    }
}

fn growth_json(growth: &Growth, style: &Style) -> GrowthJson {
    GrowthJson {
        most: growth.most,
        pieces: growth.pieces,
        holes: growth.holes,
        pui: growth.pui.as_ref().map(|pui| RangeJson::both(pui, style)),
        area: growth
            .area
            .as_ref()
            .filter(|_| growth.pieces > 0)
            .map(|area| style.measure_number(&Measure::of(area))),
    }
}
