//! Readings: the fit on machine integers, on numbers of any size and from all half-planes; brute force, the exact
//! simplex, and both sides of ε_min.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use boundfit_check::ProgramRows;
use boundfit_estimation::{ErrorBound, Fit, Minimax, Model, Problem, fit};
use boundfit_exact::{Integer, Rational};
use boundfit_geometry::{Inequality, System, Vertex};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::half_planes::{across, intersected};
use super::placement::Placement;
use super::simplex::{is_feasible, same_maximum};
use super::{Case, same};
use crate::columns::Shape;
use crate::definitions::{answer, answer_in_general, least_bound};
use crate::oracle::{Row, solve};
use crate::readings::naive_least_squares;
use crate::readings::{line, problem, with_error_bound, with_rows, y_and_epsilon};
use crate::shape::shape;
use boundfit_lp::PuiEnd;

/// The difficulty of readings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReadingsFamily {
    /// Readings of lines and of two regressors, under one bound or one per row, with conditions.
    Any,
    /// The same at the least error bound: no interior.
    AtLeastBound,
    /// Readings of lines on an integer grid: in line, above each other, at the ends of 64 bits.
    Grid,
}

impl ReadingsFamily {
    /// All of them.
    pub const ALL: [ReadingsFamily; 3] =
        [ReadingsFamily::Any, ReadingsFamily::AtLeastBound, ReadingsFamily::Grid];

    /// The name in the table of counts.
    pub fn name(self) -> &'static str {
        match self {
            ReadingsFamily::Any => "readings",
            ReadingsFamily::AtLeastBound => "at eps_min",
            ReadingsFamily::Grid => "grid readings",
        }
    }

    /// Readings of this family.
    pub fn case(self, rng: &mut ChaCha8Rng) -> ReadingsCase {
        let problem = match self {
            ReadingsFamily::Any => problem(rng),
            ReadingsFamily::Grid => on_grid(rng),
            ReadingsFamily::AtLeastBound => {
                let problem = if rng.random_bool(0.5) { problem(rng) } else { on_grid(rng) };
                match Minimax::new(&problem.measurements, &problem.conditions) {
                    Some(minimax) => with_error_bound(&problem, &minimax.least),
                    None => problem,
                }
            }
        };
        ReadingsCase { problem }
    }
}

fn on_grid(rng: &mut ChaCha8Rng) -> Problem {
    let shape = Shape::ALL[rng.random_range(0..Shape::ALL.len())];
    let count = rng.random_range(1..=12);
    let (x, y) = shape.columns(rng, count);
    let mut unit = || {
        let ten = [1, 10, 1_000, 1_000_000][rng.random_range(0..4)];
        Rational::ratio(1, [ten, 3 * ten][usize::from(rng.random_bool(0.1))])
    };
    let (x_unit, y_unit) = (unit(), unit());
    let bits = rng.random_range(1..63);
    let half_steps = rng.random_range(0..1_i64 << bits);
    let epsilon = Rational::ratio(half_steps, 2) * &y_unit;
    let readings = x.into_iter().zip(y);
    line(readings.map(|(x, y)| (Rational::from(x) * &x_unit, Rational::from(y) * &y_unit)), epsilon)
}

/// A fit.
#[derive(Debug, Clone)]
pub struct ReadingsCase {
    problem: Problem,
}

impl Case for ReadingsCase {
    fn check(&self) -> Result<&'static str, String> {
        let fit = fit(&self.problem);
        fit.verify(&self.problem).map_err(|error| format!("the fit's own proofs: {error:?}"))?;
        self.same_without_machine_integers(&fit)?;
        let (every, kind) = self.same_by_every_half_plane(&fit)?;
        if let Some(rows) = oracle_rows(&every) {
            let region = intersected(every)?.0;
            let answer = Placement::identity().answer(region.region());
            same("the FPS and brute force", &answer, &Some(solve(&rows)))?;
        }
        let least = |minimax: &Option<Minimax>| minimax.clone().map(|m| (m.least, m.theta, m.unique));
        same("ε_min by hulls and by cuts", &least(&fit.minimax), &least_bound(&self.problem))?;
        self.least_bound_is_least(fit.minimax.as_ref())?;
        Ok(kind)
    }

    fn without(&self, index: usize) -> Option<Box<dyn Case>> {
        let Problem { measurements, conditions } = &self.problem;
        let count = measurements.kept().len();
        let mut problem = self.problem.clone();
        if index < count {
            let mut rows = measurements.kept().to_vec();
            rows.remove(index);
            problem = with_rows(&problem, rows);
        } else if index - count < conditions.len() {
            problem.conditions.remove(index - count);
        } else {
            return None;
        }
        Some(Box::new(ReadingsCase { problem }))
    }

    fn fixture(&self) -> String {
        let Problem { measurements, conditions } = &self.problem;
        let (header, model) = match measurements.model() {
            Model::Line { .. } => ("x", "--x x"),
            Model::TwoRegressors { .. } => ("u,v", "--x u,v"),
        };
        let is_line = matches!(measurements.model(), Model::Line { .. });
        let bound = match measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => format!("--eps {epsilon}"),
            _ => "--eps-column eps".to_owned(),
        };
        let conditions: String =
            conditions.iter().map(|condition| format!(" --where '{}'", condition.text())).collect();
        let mut text = format!("{header},y,eps\n");
        for row in measurements.kept() {
            let ([u, v], (response, epsilon)) = (&row.regressor, y_and_epsilon(row));
            let regressor = if is_line { u.to_string() } else { format!("{u},{v}") };
            let _ = writeln!(text, "{regressor},{response},{epsilon}");
        }
        format!("{text}(as: boundfit fit FILE {model} --y y {bound}{conditions})\n")
    }
}

impl ReadingsCase {
    fn same_without_machine_integers(&self, fit: &Fit) -> Result<(), String> {
        let direct = naive_least_squares(&self.problem.measurements);
        same("least squares by its definition", &fit.least_squares, &direct)?;
        same(
            "the fit in another unit",
            &answer(&self.problem, fit, &Rational::one()),
            &answer_in_general(&self.problem),
        )
    }

    /// The FPS is that of all half-planes, by clipping and by the simplex; gives them and its kind.
    fn same_by_every_half_plane(&self, fit: &Fit) -> Result<(System, &'static str), String> {
        let every = fit.with_every_half_plane(&self.problem);
        let system = every.fps.polyhedron().system().clone();
        let (polyhedron, kind) = intersected(system.clone())?;
        let own = fit.fps.polyhedron().region();
        same("the FPS and all half-planes", &shape(own), &shape(polyhedron.region()))?;
        let active = |fit: &Fit| -> Vec<BTreeSet<_>> {
            let vertices = fit.fps.polyhedron().region().vertices();
            let names = |vertex: &Vertex| fit.fps.active(vertex.active(), usize::MAX).names;
            vertices.iter().map(|vertex| names(vertex).into_iter().collect()).collect()
        };
        same("active rows", &active(fit), &active(&every))?;
        same("PUI of all half-planes", &fit.pui_intervals(), &every.pui_intervals())?;
        let objectives = PuiEnd::ALL.map(PuiEnd::objective).into_iter().chain(across(own));
        objectives.into_iter().try_for_each(|objective| same_maximum(&polyhedron, objective))?;
        Ok((system, kind))
    }

    /// Checks by the simplex that a point is left at the least bound, none just below it, and never any without a
    /// bound.
    fn least_bound_is_least(&self, minimax: Option<&Minimax>) -> Result<(), String> {
        let leaves = |bound: &Rational| {
            is_feasible(&ProgramRows::new(&with_error_bound(&self.problem, bound)).plain())
        };
        let Problem { measurements, conditions } = &self.problem;
        let Some(minimax) = minimax else {
            return same("something is left at a huge bound", &leaves(&Rational::from(i64::MAX)), &false);
        };
        same("the proof of ε_min", &minimax.proof.verify(measurements, conditions, &minimax.least), &true)?;
        same("something is left at ε_min", &leaves(&minimax.least), &true)?;
        let below = &minimax.least * Rational::ratio((1 << 40) - 1, 1 << 40);
        same("something is left below ε_min", &leaves(&below), &minimax.least.is_zero())
    }
}

/// The inequalities as integers, if they are within the oracle's range.
fn oracle_rows(system: &System) -> Option<Vec<Row>> {
    let row = |Inequality { a: [a1, a2], b }: &Inequality| -> Option<Row> {
        let common = a1.denominator().lcm(&a2.denominator()).lcm(&b.denominator());
        let whole = |value: &Rational| -> Option<i128> {
            let scaled: Integer = value.numerator() * common.quotient(&value.denominator());
            scaled.to_i128().filter(|value| value.unsigned_abs() < 1 << 31)
        };
        Some([whole(a1)?, whole(a2)?, whole(b)?])
    };
    system.inequalities().iter().map(row).collect()
}
