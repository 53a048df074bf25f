//! A fit as a proof that others can check, schema `boundfit/proof/1` (docs/proof.md).

use boundfit_estimation::{BoundName, Condition, ErrorBound, Fit, Fps, Model, ParameterBound, Problem};
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_geometry::predicates::{Turn, normal_turn};
use boundfit_geometry::{Multiplier, Polyhedron, Vertex};
use serde::Serialize;

use crate::json::to_text;

#[derive(Serialize)]
struct ProofJson {
    schema: &'static str,
    sha256: String,
    delimiter: char,
    header: bool,
    rows: Vec<usize>,
    reading: &'static str,
    model: [(usize, String); 4],
    #[serde(skip_serializing_if = "Option::is_none")]
    interval: Option<[Option<usize>; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    law: Option<[Vec<LawTermJson>; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    x_origin: Option<String>,
    conditions: Vec<Vec<String>>,
    vertices: Vec<[String; 2]>,
    active: Vec<(usize, String)>,
    sides: Vec<(String, Option<usize>)>,
    farkas: Vec<NamedMultiplier>,
    bounds: Vec<(Vec<NamedMultiplier>, [String; 2], [String; 2])>,
}

/// A quantity of a law, the column that it is taken from, and how many times.
type LawTermJson = (&'static str, usize, String);

/// The name of a half-plane and its multiplier.
type NamedMultiplier = (String, String);

/// The proof of a fit as JSON, with a line end: what was read from which bytes, the feasible parameter set with the
/// half-planes of its sides, and its bounds; for an empty set the readings that contradict each other. `None` when the
/// readings do not come from delimited text that has a row for each of them, or which rows were fitted was not kept, or the text
/// is not written as the checkers read it.
///
/// All numbers are exact fractions as text. Its size is linear in the vertices and the half-planes that touch them.
pub fn proof_json(problem: &Problem, fit: &Fit, reading: Reading) -> Option<String> {
    let measurements = &problem.measurements;
    let x_origin = &measurements.line_form().x_origin;
    let layout = measurements.layout().filter(|layout| layout.dialect.is_plain())?;
    if measurements.fitted_rows().is_empty() {
        return None;
    }
    let column = |&column: &usize| (column, "1".to_owned());
    let is_line = matches!(measurements.model(), Model::Line { .. });
    let (regressors, others) = layout.columns.split_at_checked(if is_line { 1 } else { 2 })?;
    // Column 0 holds 1 in every row.
    let [x1, x2] = [regressors.first()?, regressors.get(1).unwrap_or(&0)].map(column);
    let (y, others) = match others.split_first() {
        Some((y, others)) if measurements.has_response() => (column(y), others),
        _ => ((0, "0".to_owned()), others),
    };
    let mut epsilon = (0, "0".to_owned());
    let (mut interval, mut law) = (None, None);
    match measurements.error_bound() {
        ErrorBound::Uniform(bound) => epsilon.1 = bound.to_string(),
        ErrorBound::PerRow(_) => epsilon = column(others.first()?),
        ErrorBound::Interval { lower, upper } => {
            // Behind each bound stands, from the same column, whether it is there.
            let mut columns = others.iter().step_by(2).copied();
            let mut next = |side: &Option<Foreign>| side.as_ref().and_then(|_| columns.next());
            interval = Some([next(lower), next(upper)]);
        }
        ErrorBound::Law(bound) => {
            let range = measurements.range_of_response();
            let term = |(name, times): (&'static str, Rational)| {
                let from = if name == "x" { x1.0 } else { y.0 };
                (if name == "written" { name } else { "abs" }, from, times.to_string())
            };
            let side = |(constant, terms): (Rational, Vec<(&'static str, Rational)>)| {
                let fixed = (!constant.is_zero()).then(|| ("abs", 0, constant.to_string()));
                fixed.into_iter().chain(terms.into_iter().map(term)).collect()
            };
            law = Some(bound.terms(&range).map(side));
        }
    }
    let condition = |condition: &Condition| {
        let inequality = condition.inequality();
        let numbers = [&inequality.a[0], &inequality.a[1], &inequality.b].map(Rational::to_string);
        numbers.into_iter().chain(condition.is_equation().then(|| "=".to_owned())).collect()
    };
    let polyhedron = fit.fps.polyhedron();
    let name = |index: usize| fit.fps.name(index).to_string();
    let vertices = polyhedron.region().vertices();
    // Every one of them: that none is missing is part of the proof.
    let touching = |vertex: &Vertex| fit.fps.active(vertex.active(), usize::MAX).names;
    let active = (0..)
        .zip(vertices)
        .flat_map(|(index, vertex)| touching(vertex).into_iter().map(move |own| (index, own.to_string())));
    let theta = |vertex: &Vertex| vertex.point().coordinates().map(|coordinate| coordinate.to_string());
    let sides = polyhedron.irredundant_by_angle().iter().zip(corners(polyhedron));
    let sides: Vec<_> = sides.map(|(&index, vertex)| (name(index), vertex)).collect();
    let contradiction = fit.contradiction(problem.measurements.error_bound()).unwrap_or_default();
    let farkas: Vec<NamedMultiplier> = contradiction.iter().map(|(name, value)| term(*name, value)).collect();
    let ends = fit.pui.iter().flatten().flat_map(|interval| [&interval.lower, &interval.upper]);
    let bounds = ends.map(|end| bound_json(end, &fit.fps)).collect();
    let proof = ProofJson {
        schema: "boundfit/proof/1",
        sha256: measurements.sha256()?.to_owned(),
        delimiter: char::from(layout.dialect.delimiter),
        header: layout.dialect.records_before > 0,
        rows: measurements.fitted_rows().concat(),
        reading: reading.name(),
        model: [x1, x2, y, epsilon],
        interval,
        law,
        x_origin: (!x_origin.is_zero()).then(|| x_origin.to_string()),
        conditions: problem.conditions.iter().map(condition).collect(),
        vertices: vertices.iter().map(theta).collect(),
        active: active.collect(),
        sides,
        farkas,
        bounds,
    };
    Some(to_text(&proof))
}

/// For each side, in order of angle, the index of the vertex where it meets the next one; `None` where they do not meet.
/// Cost: linear in the number of sides and logarithmic in that of half-planes through a vertex.
fn corners(polyhedron: &Polyhedron) -> Vec<Option<usize>> {
    let sides = polyhedron.irredundant_by_angle();
    let vertices = polyhedron.region().vertices();
    let system = polyhedron.system();
    let mut at = 0;
    let corner = |(&side, &next): (&usize, &usize)| {
        let (f, g) = (system.half_plane(side)?, system.half_plane(next)?);
        if normal_turn(f, g) != Turn::Left {
            return None;
        }
        // Vertices come in the order of the sides: the search goes around once, after the first side.
        let through_both = |index: &usize| {
            vertices.get(*index).is_some_and(|vertex| {
                [side, next].iter().all(|own| vertex.active().binary_search(own).is_ok())
            })
        };
        at = (at..vertices.len()).chain(0..at).find(through_both)?;
        Some(at)
    };
    sides.iter().zip(sides.iter().cycle().skip(1)).map(corner).collect()
}

/// Multipliers, a point and a ray. At a finite end the ray is zero; where there is none, there are no multipliers.
fn bound_json(bound: &ParameterBound, fps: &Fps) -> (Vec<NamedMultiplier>, [String; 2], [String; 2]) {
    let (multipliers, point, ray) = match bound {
        ParameterBound::Bounded { proof, .. } => {
            let multiplier = |m: &Multiplier| term(fps.name(m.index), &m.value);
            let multipliers = proof.multipliers.iter().map(multiplier).collect();
            (multipliers, &proof.attained_at, ["0", "0"].map(ToOwned::to_owned))
        }
        ParameterBound::Unbounded(proof) => {
            (Vec::new(), &proof.point, [proof.ray.dx(), proof.ray.dy()].map(ToString::to_string))
        }
    };
    (multipliers, point.coordinates().map(|coordinate| coordinate.to_string()), ray)
}

fn term(name: BoundName, multiplier: &Rational) -> NamedMultiplier {
    (name.to_string(), multiplier.to_string())
}
