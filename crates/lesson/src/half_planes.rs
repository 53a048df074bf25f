//! The half-planes of readings and conditions.

use boundfit_estimation::{BoundName, Fit, Problem};
use boundfit_exact::Rational;
use boundfit_geometry::Inequality;
use boundfit_report::ActiveJson;
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(crate) struct HalfPlaneJson {
    name: ActiveJson,
    a: [String; 2],
    b: String,
    irredundant: bool,
}

/// All half-planes `a·θ ≤ b` in the order of the fit's system.
pub(crate) fn half_planes(problem: &Problem, fit: &Fit) -> Vec<HalfPlaneJson> {
    let irredundant = irredundant(problem, fit);
    let inequalities = fit.fps.polyhedron().system().inequalities();
    let half_plane = |(index, inequality): (usize, &Inequality)| HalfPlaneJson {
        name: fit.fps.name(index).into(),
        a: inequality.a.each_ref().map(ToString::to_string),
        b: inequality.b.to_string(),
        irredundant: irredundant.contains(&index),
    };
    inequalities.iter().enumerate().map(half_plane).collect()
}

/// A minimal set of half-planes with the same intersection, ascending; for an empty set those of [`contradiction`].
pub(crate) fn irredundant(problem: &Problem, fit: &Fit) -> Vec<usize> {
    let polyhedron = fit.fps.polyhedron();
    match contradiction(problem, fit) {
        Some(terms) => {
            let named = |index: &usize| terms.iter().any(|(name, _)| *name == fit.fps.name(*index));
            (0..polyhedron.system().len()).filter(named).collect()
        }
        None => polyhedron.irredundant(),
    }
}

/// Returns, for an empty set, at most three half-planes with positive multipliers whose sum is `0 ≤ negative`. They
/// are conditions alone where these contradict each other, else those that the fit reports. The page moves the error
/// bounds, and such conditions leave nothing wherever these stand.
pub(crate) fn contradiction(problem: &Problem, fit: &Fit) -> Option<Vec<(BoundName, Rational)>> {
    fit.contradiction_of_conditions().or_else(|| fit.contradiction(problem.measurements.error_bound()))
}
