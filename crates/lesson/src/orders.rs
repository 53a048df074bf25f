//! Clipping step by step, in several orders.

use boundfit_estimation::{Fit, Model, Problem};
use boundfit_exact::Rational;
use boundfit_geometry::clipping::{Step, StepRedundancy, steps};
use boundfit_geometry::predicates::by_angle;
use boundfit_geometry::{Region, System};
use boundfit_report::Number;
use serde::Serialize;

use crate::number::STYLE;
use crate::points::Points;
use crate::region::IndexedRegion;

#[derive(Debug, Serialize)]
pub(crate) struct OrderJson {
    id: &'static str,
    name: &'static str,
    note: String,
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
    redundant: Option<RedundantJson>,
}

#[derive(Debug, Serialize)]
struct RedundantJson {
    why: &'static str,
    by: Vec<MultiplierJson>,
    slack: Option<Number>,
}

#[derive(Debug, Serialize)]
struct MultiplierJson {
    half_plane: usize,
    multiplier: Number,
}

/// The orders in which the half-planes can be clipped. Exact.
pub(crate) fn orders(problem: &Problem, fit: &Fit, points: &mut Points) -> Vec<OrderJson> {
    let system = fit.fps.polyhedron().system();
    let given: Vec<usize> = (0..system.len()).collect();
    let then = if problem.conditions.is_empty() { "" } else { "; the conditions come last" };
    let given_note = format!("In the order of the file, each reading with its upper bound first{then}.");
    let (worst, worst_note) = worst_first(fit);
    vec![
        order("given", "as given", given_note, system, &given, points),
        order("slope", "by slope", by_slope_note(problem), system, &by_slope(system), points),
        order("worst", "worst first", worst_note, system, &worst, points),
    ]
}

fn order(
    id: &'static str,
    name: &'static str,
    note: String,
    system: &System,
    indices: &[usize],
    points: &mut Points,
) -> OrderJson {
    let steps = steps(system, indices);
    let note = format!("{note} {}", outcome(&steps));
    OrderJson { id, name, note, steps: steps.iter().map(|step| step_json(step, points)).collect() }
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

fn by_slope_note(problem: &Problem) -> String {
    match problem.measurements.model() {
        Model::Line { x } => format!(
            "By the direction of the boundaries: all upper bounds from the largest {x} to the smallest, then all lower bounds."
        ),
        Model::TwoRegressors { .. } => "By the direction of the boundaries, counter-clockwise.".to_owned(),
    }
}

/// Half-planes by their slack at an estimate, the most violated first, ties by index.
fn worst_first(fit: &Fit) -> (Vec<usize>, String) {
    let inequalities = fit.fps.polyhedron().system().inequalities();
    let mut indices: Vec<usize> = (0..inequalities.len()).collect();
    let least_squares = fit.least_squares.as_ref().ok().map(|estimate| (&estimate.theta, "least-squares"));
    let minimax = fit.minimax.as_ref().map(|minimax| (&minimax.theta, "minimax"));
    let Some((theta, name)) = least_squares.or(minimax) else {
        return (indices, "There is no estimate to start from, so this is the order of the file.".to_owned());
    };
    let slacks: Vec<Rational> = inequalities.iter().map(|inequality| inequality.slack(theta)).collect();
    indices.sort_by(|&one, &other| slacks[one].cmp(&slacks[other]));
    (
        indices,
        format!(
            "The half-planes that the {name} estimate violates most, or keeps most narrowly, come first."
        ),
    )
}

/// When the region is final.
fn outcome(steps: &[Step]) -> String {
    let count = steps.len();
    let last = steps.iter().rposition(|step| step.redundant.is_none()).map(|position| position + 1);
    match (last, steps.last().map(|step| &step.after)) {
        (Some(last), Some(Region::Empty(_))) => {
            format!("Nothing is left after step {last} of {count}.")
        }
        (Some(last), _) if last == count => {
            format!("The set has its final shape only after the last of {count} steps.")
        }
        (Some(last), _) => format!("The set has its final shape after step {last} of {count}."),
        (None, _) => "No step cuts anything off.".to_owned(),
    }
}

fn step_json(step: &Step, points: &mut Points) -> StepJson {
    StepJson {
        half_plane: step.index,
        region: IndexedRegion::new(&step.after, points),
        born: step.born.iter().map(|point| points.index(point)).collect(),
        lost: step.lost.iter().map(|point| points.index(point)).collect(),
        redundant: step.redundant.as_ref().map(redundant),
    }
}

fn redundant(redundancy: &StepRedundancy) -> RedundantJson {
    let without_proof = |why| RedundantJson { why, by: Vec::new(), slack: None };
    match redundancy {
        StepRedundancy::Always => without_proof("always"),
        StepRedundancy::AlreadyEmpty => without_proof("already-empty"),
        StepRedundancy::Dominated { by, slack } => RedundantJson {
            why: "dominated",
            by: by
                .iter()
                .map(|m| MultiplierJson { half_plane: m.index, multiplier: STYLE.number(&m.value) })
                .collect(),
            slack: Some(STYLE.number(slack)),
        },
    }
}
