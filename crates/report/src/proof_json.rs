//! A fit as a proof that others can check, schema `boundfit/proof/1` (docs/proof.md).

use boundfit_estimation::{Fit, Fps, ParameterBound, Problem};
use boundfit_exact::Reading;
use boundfit_geometry::Vertex;

use crate::answer::proof::{EndProofJson, ProofJson};
use crate::json::to_text;
use crate::proof_question::ProofQuestion;
use crate::statements::{end_at, end_beyond, of_bounds, walk};

/// Returns the proof of a fit as JSON, with a line end. It has the input with the bytes that it came from, the
/// feasible parameter set with the half-planes of its sides, and its bounds. An empty set has the readings that
/// contradict each other. Returns `None` unless the readings come from delimited text that has a row for each of
/// them, in the form that the checkers read. Returns `None`, too, if the numbers of the fitted rows were not kept.
///
/// All numbers are exact fractions as text. Its size is linear in the vertices and the half-planes that touch them.
pub fn proof_json(problem: &Problem, fit: &Fit, reading: Reading) -> Option<String> {
    let question = ProofQuestion::new(problem, reading)?;
    let polyhedron = fit.fps.polyhedron();
    let name = |index: usize| fit.fps.name(index).into();
    let vertices = polyhedron.region().vertices();
    // Every one of them: that none is missing is part of the proof.
    let touching = |vertex: &Vertex| fit.fps.active(vertex.active(), usize::MAX).names;
    let active = (0..)
        .zip(vertices)
        .flat_map(|(index, vertex)| touching(vertex).into_iter().map(move |own| (index, own.to_string())));
    let theta = |vertex: &Vertex| vertex.point().coordinates().map(|coordinate| coordinate.to_string());
    let contradiction = fit.contradiction(problem.measurements.error_bound()).unwrap_or_default();
    let ends = fit.pui.iter().flatten().flat_map(|interval| [&interval.lower, &interval.upper]);
    let bounds = ends.map(|end| bound_json(end, &fit.fps)).collect();
    let proof = ProofJson {
        schema: ProofJson::SCHEMA,
        question,
        vertices: vertices.iter().map(theta).collect(),
        active: active.collect(),
        sides: walk(polyhedron, &name),
        farkas: of_bounds(&contradiction),
        bounds,
    };
    Some(to_text(&proof))
}

/// Multipliers, a point and a ray. At a finite end the ray is zero; where there is none, there are no multipliers.
fn bound_json(bound: &ParameterBound, fps: &Fps) -> EndProofJson {
    match bound {
        ParameterBound::Bounded { proof, .. } => end_at(proof, &|index| fps.name(index).into()),
        ParameterBound::Unbounded(proof) => end_beyond(proof),
    }
}
