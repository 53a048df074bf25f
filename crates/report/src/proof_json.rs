//! A fit as a proof that others can check, schema `boundfit/proof/1` (docs/proof.md).

use boundfit_estimation::{BoundName, Fit, Fps, ParameterBound, Problem};
use boundfit_exact::{Rational, Reading};
use boundfit_geometry::predicates::{Turn, normal_turn};
use boundfit_geometry::{Multiplier, Polyhedron, Vertex};

use crate::answer::proof::{EndProofJson, MultipleJson, ProofJson};
use crate::json::to_text;
use crate::proof_question::ProofQuestion;

/// Returns the proof of a fit as JSON, with a line end. It has the input with the bytes that it came from, the
/// feasible parameter set with the half-planes of its sides, and its bounds. An empty set has the readings that
/// contradict each other. Returns `None` unless the readings come from delimited text that has a row for each of
/// them, in the form that the checkers read. Returns `None`, too, if the numbers of the fitted rows were not kept.
///
/// All numbers are exact fractions as text. Its size is linear in the vertices and the half-planes that touch them.
pub fn proof_json(problem: &Problem, fit: &Fit, reading: Reading) -> Option<String> {
    let question = ProofQuestion::new(problem, reading)?;
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
    let farkas: Vec<MultipleJson> = contradiction.iter().map(|(name, value)| term(*name, value)).collect();
    let ends = fit.pui.iter().flatten().flat_map(|interval| [&interval.lower, &interval.upper]);
    let bounds = ends.map(|end| bound_json(end, &fit.fps)).collect();
    let proof = ProofJson {
        schema: ProofJson::SCHEMA,
        question,
        vertices: vertices.iter().map(theta).collect(),
        active: active.collect(),
        sides,
        farkas,
        bounds,
    };
    Some(to_text(&proof))
}

/// Returns, for each side in order of angle, the index of the vertex where it meets the next one; `None` where they
/// do not meet. Cost: linear in the number of sides and logarithmic in that of half-planes through a vertex.
pub(crate) fn corners(polyhedron: &Polyhedron) -> Vec<Option<usize>> {
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
fn bound_json(bound: &ParameterBound, fps: &Fps) -> EndProofJson {
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

fn term(name: BoundName, multiplier: &Rational) -> MultipleJson {
    (name.to_string(), multiplier.to_string())
}
