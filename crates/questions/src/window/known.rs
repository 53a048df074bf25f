//! The answer about a window, which stays while readings come and go that cannot change it.

use std::sync::Arc;

use boundfit_geometry::predicates::{Side, side};
use boundfit_geometry::{Constraint, Polyhedron, RegionKind, Vertex};

use super::answer::WindowFit;
use super::store::{Id, Store};

/// An answer with the half-planes that it was found from. All answers about these alone are those about the window, so that
/// nothing changes as long as they stay and every other half-plane has the set of these strictly within.
#[derive(Debug)]
pub(super) struct Known {
    pub(super) fit: Arc<WindowFit>,
    ids: Vec<Id>,
    /// The set of these half-planes, a polygon.
    polyhedron: Polyhedron,
}

impl Known {
    /// The answer that was found from the half-planes of this set.
    pub(super) fn new(fit: WindowFit, ids: Vec<Id>, polyhedron: Polyhedron) -> Self {
        Known { fit: Arc::new(fit), ids, polyhedron }
    }

    /// Returns whether it stays when a half-plane comes. Cost: linear in the few vertices.
    pub(super) fn stays_with(&self, store: &Store, id: Id) -> bool {
        let vertices = || self.polyhedron.region().vertices().iter().map(Vertex::point);
        match store.constraint(id) {
            None | Some(Constraint::Always) => true,
            Some(Constraint::Never) => false,
            Some(Constraint::HalfPlane(own)) => {
                self.fit.kind == RegionKind::Polygon
                    && vertices().all(|vertex| side(own, vertex) == Side::Inside)
            }
        }
    }

    /// Returns whether it stays when a half-plane leaves.
    pub(super) fn stays_without(&self, id: Id) -> bool {
        self.fit.kind == RegionKind::Polygon && !self.ids.contains(&id)
    }
}

#[cfg(test)]
mod tests {
    use boundfit_estimation::{BoundName, Condition, Measurement, ParameterBound, ParameterInterval};
    use boundfit_exact::Rational;

    use super::*;
    use crate::Window;

    /// The ends of both intervals, each with the named bounds that prove it.
    fn proved(fit: &WindowFit) -> Vec<Option<Vec<(BoundName, Rational)>>> {
        let ends = fit.pui.iter().flatten().flat_map(|own| [&own.lower, &own.upper]);
        let proof = |end: &ParameterBound| match end {
            ParameterBound::Unbounded(_) => None,
            ParameterBound::Bounded { value, proof } => {
                let own = proof.multipliers.iter().map(|m| (fit.names[m.index], m.value.clone()));
                Some(own.chain([(BoundName::Where(0), value.clone())]).collect())
            }
        };
        ends.map(proof).collect()
    }

    #[test]
    fn an_answer_that_stays_is_that_of_a_new_window() {
        let mut seed = 3_u64;
        let mut next = |below: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as i64 % below
        };
        let (mut stayed, mut empty) = (0, 0);
        for round in 0..24 {
            let (size, most) = ([3, 9, 100][round % 3], [4, 9, 30][round / 3 % 3]);
            let conditions: Vec<Condition> = Vec::new();
            let mut window = Window::new(&conditions);
            let mut last: Option<Arc<WindowFit>> = None;
            for row in 1..=120 {
                let x = next(2 * size) - size;
                let far = if next(60) == 0 { 40 } else { 0 };
                let y = Rational::ratio(15 * x + next(11) - 5 + far, 10);
                let epsilon = Rational::ratio(if round % 4 == 3 && next(20) == 0 { 6 } else { 5 }, 10);
                window.push(Measurement::around(row, [Rational::from(x), Rational::one()], y, epsilon));
                if window.len() > most {
                    window.pop();
                }
                let mut fresh = Window::new(&conditions);
                window.readings().for_each(|reading| fresh.push(reading.clone()));
                let (own, expected) = (window.fit(), fresh.fit());
                assert_eq!(
                    (own.kind, &own.central, &own.least),
                    (expected.kind, &expected.central, &expected.least)
                );
                let intervals = |fit: &WindowFit| {
                    fit.pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval))
                };
                assert_eq!(intervals(&own), intervals(&expected));
                // A flat set has several proofs.
                assert!(own.kind != RegionKind::Polygon || proved(&own) == proved(&expected));
                assert_eq!(own.contradiction.is_some(), expected.contradiction.is_some());
                let rows: Vec<usize> = window.readings().map(|reading| reading.row).collect();
                assert!(own.names.iter().filter_map(|name| name.row()).all(|row| rows.contains(&row)));
                stayed += usize::from(last.is_some_and(|last| Arc::ptr_eq(&last, &own)));
                empty += usize::from(own.contradiction.is_some());
                last = Some(own);
            }
        }
        assert!(stayed > 100 && empty > 50, "{stayed} {empty}");
    }
}
