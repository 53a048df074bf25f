//! A test of whether least squares is one of the feasible answers.

use boundfit_geometry::Point;
use boundfit_geometry::predicates::{Side, side};

use crate::fit::Fit;

/// Returns whether the least-squares estimate lies in the FPS; `None` when there is no estimate. Exact. Cost: linear in the number
/// of vertices.
pub fn least_squares_is_feasible(fit: &Fit) -> Option<bool> {
    let estimate = fit.least_squares.as_ref().ok()?;
    let polyhedron = fit.fps.polyhedron();
    if polyhedron.is_empty() {
        return Some(false);
    }
    let point = Point::new(&estimate.theta[0], &estimate.theta[1]);
    // The irredundant half-planes are the region.
    let half_planes =
        polyhedron.irredundant_by_angle().iter().filter_map(|&index| polyhedron.system().half_plane(index));
    Some(half_planes.into_iter().all(|half_plane| side(half_plane, &point) != Side::Outside))
}
