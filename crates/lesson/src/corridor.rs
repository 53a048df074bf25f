//! The band that all feasible lines cover.

use boundfit_estimation::{Corridor, CorridorEdge, Fit, Model, Problem};
use boundfit_exact::{Endpoint, Rational};
use serde::Serialize;

use crate::points::Points;

#[derive(Debug, Serialize)]
pub(crate) struct CorridorJson {
    upper: EdgeJson,
    lower: EdgeJson,
}

/// One edge of the band: on the k-th interval of x it is the line with the parameters of the k-th point.
#[derive(Debug, Serialize)]
struct EdgeJson {
    from: Option<String>,
    to: Option<String>,
    nowhere: bool,
    lines: Vec<usize>,
    breakpoints: Vec<String>,
}

/// The corridor; `None` when the set is empty or the model is not a line.
pub(crate) fn corridor(problem: &Problem, fit: &Fit, points: &mut Points) -> Option<CorridorJson> {
    if !matches!(problem.measurements.model(), Model::Line { .. }) {
        return None;
    }
    let Corridor { upper, lower } = Corridor::new(fit.fps.polyhedron())?;
    Some(CorridorJson { upper: edge(&upper, points), lower: edge(&lower, points) })
}

fn edge(edge: &CorridorEdge, points: &mut Points) -> EdgeJson {
    let end = |end: &Endpoint| end.value().map(Rational::to_string);
    let domain = edge.domain();
    EdgeJson {
        from: domain.and_then(|domain| end(domain.lower())),
        to: domain.and_then(|domain| end(domain.upper())),
        nowhere: domain.is_none(),
        lines: edge.lines().iter().map(|theta| points.index_of(theta)).collect(),
        breakpoints: edge.breakpoints().iter().map(Rational::to_string).collect(),
    }
}
