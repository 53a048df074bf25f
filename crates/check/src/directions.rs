//! The set beside what linear programs in many directions see of it.
//!
//! The optimisers of the programs are vertices of the set, so that their hull lies inside it: an *inner* approximation.
//! The programs' values bound the set by one half-plane per direction: an *outer* approximation.

use boundfit_estimation::{Fps, Problem};
use boundfit_exact::{Interval, Rational};
use boundfit_geometry::predicates::lexicographic;
use boundfit_geometry::{Hulls, Inequality, Point, Polyhedron, System};
use boundfit_lp::{ExactOutcome, ExactSimplex, Row, spread_objectives};

use crate::rows::ProgramRows;

/// Vertices and area of one set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Approximation {
    /// Counter-clockwise.
    pub vertices: Vec<[Rational; 2]>,
    /// The area; `None` when it is infinite.
    pub area: Option<Rational>,
}

/// The number of directions in which a set is looked at, and the place where they are spread evenly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AskedDirections {
    /// The number of directions.
    pub count: usize,
    /// Says whether they are spread evenly where the box of both intervals is a square, where there is one; else in (θ1, θ2) as it is.
    pub is_scaled: bool,
}

/// The exact set between its inner and its outer approximation. Exact: the programs are solved by the exact simplex.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Directions {
    /// The number of directions.
    pub count: usize,
    /// True if they are spread evenly where the box of both intervals is a square.
    pub is_scaled: bool,
    /// The number of directions that the set does not bound.
    pub unbounded: usize,
    /// The hull of the optimisers; `None` when the set is empty.
    pub inner: Option<Approximation>,
    /// The set itself.
    pub exact: Approximation,
    /// The intersection of the supporting half-planes; `None` when the set is empty.
    pub outer: Option<Approximation>,
}

/// Solves a program in each direction, with the rows of all readings. Cost: an exact simplex run for each.
pub fn directions(problem: &Problem, rows: &ProgramRows, asked: AskedDirections) -> Directions {
    let exact = Fps::new(&problem.measurements, &problem.conditions);
    approximated(&rows.exact_simplex(), &asked.objectives(exact.polyhedron()), exact.polyhedron())
}

/// Solves a program over a set for each of some objectives. Cost: one exact simplex run for each, over the
/// irredundant bounds, which decide the same as all.
pub fn directions_along(polyhedron: &Polyhedron, objectives: &Objectives) -> Directions {
    let system = polyhedron.system();
    let bounds = polyhedron.irredundant().into_iter().filter_map(|index| system.inequalities().get(index));
    let rows: Vec<Row> = bounds.map(|bound| Row { a: bound.a.clone(), b: bound.b.clone() }).collect();
    approximated(&ExactSimplex::new(&rows), objectives, polyhedron)
}

/// The objectives to minimize, one per direction.
#[derive(Debug, Clone)]
pub struct Objectives {
    /// Coefficients of θ1 and θ2.
    pub coefficients: Vec<[Rational; 2]>,
    /// True if they are spread evenly where the box of both intervals is a square.
    pub is_scaled: bool,
}

impl AskedDirections {
    /// The objectives for a set. Without a bounded box of some width they are spread evenly in (θ1, θ2) in any case.
    pub fn objectives(self, polyhedron: &Polyhedron) -> Objectives {
        let width = |interval: &Interval| interval.ends().map(|(lower, upper)| upper - lower);
        let ratio = || {
            let [first, second] = polyhedron.bounding_box()?;
            let ratio = width(&first)?.checked_div(&width(&second)?)?;
            // A direction need not be exact: what is found along it is.
            Rational::from_f64(ratio.to_f64()).filter(Rational::is_positive)
        };
        let ratio = self.is_scaled.then(ratio).flatten();
        let spread = spread_objectives(self.count);
        let is_scaled = ratio.is_some();
        let coefficients = match ratio {
            Some(ratio) => spread.into_iter().map(|[c1, c2]| [c1, c2 * &ratio]).collect(),
            None => spread,
        };
        Objectives { coefficients, is_scaled }
    }
}

/// Returns what programs over a set see of it.
fn approximated(simplex: &ExactSimplex, objectives: &Objectives, exact: &Polyhedron) -> Directions {
    let mut optimisers = Vec::new();
    let mut supporting = System::default();
    let (mut unbounded, mut empty) = (0, false);
    for objective in &objectives.coefficients {
        match simplex.minimise(objective) {
            ExactOutcome::Optimal { theta, value, .. } => {
                optimisers.push(Point::new(&theta[0], &theta[1]));
                let [a1, a2] = objective.clone();
                supporting.push(Inequality::new(-a1, -a2, -value));
            }
            ExactOutcome::Unbounded { .. } => unbounded += 1,
            ExactOutcome::Infeasible { .. } => empty = true,
        }
    }
    Directions {
        count: objectives.coefficients.len(),
        is_scaled: objectives.is_scaled,
        unbounded,
        inner: (!empty).then(|| hull(optimisers)),
        exact: approximation(exact),
        outer: (!empty).then(|| approximation(&Polyhedron::intersect(supporting))),
    }
}

fn approximation(polyhedron: &Polyhedron) -> Approximation {
    let region = polyhedron.region();
    let vertices = region.vertices().iter().map(|vertex| vertex.point().coordinates()).collect();
    Approximation { vertices, area: region.area() }
}

/// The convex hull of points and its area.
fn hull(mut points: Vec<Point>) -> Approximation {
    points.sort_by(lexicographic);
    points.dedup();
    let corners = Hulls::of_sorted(&points).corners();
    let vertices: Vec<[Rational; 2]> =
        corners.into_iter().filter_map(|k| points.get(k)).map(Point::coordinates).collect();
    let next = vertices.iter().cycle().skip(1);
    let doubled: Rational = vertices.iter().zip(next).map(|(p, q)| &p[0] * &q[1] - &p[1] * &q[0]).sum();
    Approximation { vertices, area: Some(doubled.half()) }
}
