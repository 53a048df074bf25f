//! Clipping step by step, in several orders.

use boundfit_estimation::{Fit, Model, Problem};
use boundfit_exact::Rational;
use boundfit_geometry::clipping::{Step, steps};
use boundfit_geometry::predicates::by_angle;
use boundfit_geometry::{Region, System};
use boundfit_report::Number;
use serde::Serialize;

use crate::number::STYLE;
use crate::points::Points;
use crate::redundancy::RedundantJson;
use crate::region::IndexedRegion;
use crate::texts::{Message, text};

#[derive(Debug, Serialize)]
pub(crate) struct OrderJson {
    id: &'static str,
    name: Message,
    note: Message,
    steps: Vec<StepJson>,
}

/// One half-plane, and the region after it.
#[derive(Debug, Serialize)]
struct StepJson {
    half_plane: usize,
    #[serde(flatten)]
    region: IndexedRegion,
    born: Vec<usize>,
    lost: Vec<usize>,
    redundant: Option<RedundantJson<Number>>,
}

/// The orders in which the half-planes can be clipped. Exact.
pub(crate) fn orders(problem: &Problem, fit: &Fit, points: &mut Points) -> Vec<OrderJson> {
    let system = fit.fps.polyhedron().system();
    let given: Vec<usize> = (0..system.len()).collect();
    let given_note = text!("order.given-note", conditions: problem.conditions.len());
    let (worst, worst_note) = worst_first(fit);
    vec![
        order("given", text!("order.given"), given_note, system, &given, points),
        order("slope", text!("order.slope"), by_slope_note(problem), system, &by_slope(system), points),
        order("worst", text!("order.worst"), worst_note, system, &worst, points),
    ]
}

fn order(
    id: &'static str,
    name: Message,
    note: Message,
    system: &System,
    indices: &[usize],
    points: &mut Points,
) -> OrderJson {
    let steps = steps(system, indices);
    let note = text!("order.note", note: note, outcome: outcome(&steps));
    let mut written: Vec<StepJson> = Vec::with_capacity(steps.len());
    for step in &steps {
        let before = written.last().map(|step| &step.region).filter(|_| step.redundant.is_some());
        // The same set: only its whole lines may now be those of another half-plane.
        let same = before.filter(|region| region.has_no_boundaries()).cloned();
        let region = same.unwrap_or_else(|| IndexedRegion::new(&step.after, points));
        written.push(step_json(step, region, points));
    }
    OrderJson { id, name, note, steps: written }
}

/// Half-planes by the angle of their normals, ties by index; those without a normal last.
fn by_slope(system: &System) -> Vec<usize> {
    let mut indices: Vec<usize> = (0..system.len()).collect();
    indices.sort_by(|&one, &other| match (system.half_plane(one), system.half_plane(other)) {
        (Some(one), Some(other)) => by_angle(one, other),
        (one, other) => one.is_none().cmp(&other.is_none()),
    });
    indices
}

fn by_slope_note(problem: &Problem) -> Message {
    match problem.measurements.model() {
        Model::Line { x } => text!("order.slope-note", x: x.to_string()),
        Model::TwoRegressors { .. } => text!("order.slope-note-two"),
    }
}

/// Half-planes by their slack at an estimate, the most violated first, ties by index.
fn worst_first(fit: &Fit) -> (Vec<usize>, Message) {
    let inequalities = fit.fps.polyhedron().system().inequalities();
    let mut indices: Vec<usize> = (0..inequalities.len()).collect();
    let least_squares =
        fit.least_squares.as_ref().ok().map(|estimate| (&estimate.theta, "order.worst-squares"));
    let minimax = fit.minimax.as_ref().map(|minimax| (&minimax.theta, "order.worst-minimax"));
    let Some((theta, note)) = least_squares.or(minimax) else {
        return (indices, text!("order.worst-none"));
    };
    let slacks: Vec<Rational> = inequalities.iter().map(|inequality| inequality.slack(theta)).collect();
    indices.sort_by(|&one, &other| slacks[one].cmp(&slacks[other]));
    (indices, text!(note))
}

/// Returns the step after which the region is final.
fn outcome(steps: &[Step]) -> Message {
    let count = steps.len();
    let last = steps.iter().rposition(|step| step.redundant.is_none()).map(|position| position + 1);
    match (last, steps.last().map(|step| &*step.after)) {
        (Some(last), Some(Region::Empty(_))) => text!("order.empty", last: last, count: count),
        (Some(last), _) if last == count => text!("order.last", count: count),
        (Some(last), _) => text!("order.final", last: last, count: count),
        (None, _) => text!("order.nothing"),
    }
}

fn step_json(step: &Step, region: IndexedRegion, points: &mut Points) -> StepJson {
    let number = |value: &Rational| STYLE.number(value);
    StepJson {
        half_plane: step.index,
        region,
        born: step.born.iter().map(|point| points.index(point)).collect(),
        lost: step.lost.iter().map(|point| points.index(point)).collect(),
        redundant: step.redundant.as_ref().map(|own| RedundantJson::of_step(own, number)),
    }
}
