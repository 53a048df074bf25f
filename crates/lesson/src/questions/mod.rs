//! Questions with answers, drawn from the data at hand.
//!
//! Every kind of set gets six to ten of them: keys of texts with their values, numbers as the engine rounds them.

mod approximations;
mod bounds;
mod error_bound;
mod estimates;
mod half_planes;
mod rows;
pub(crate) mod wording;

use boundfit_estimation::{BoundName, Fit, Model, Problem};
use boundfit_geometry::{Inequality, Polyhedron, Region};
use boundfit_report::Style;
use serde::Serialize;

use crate::layers::Programs;
use crate::leave_one_out::Without;
use crate::texts::Message;

/// The material of questions.
#[derive(Debug)]
pub(crate) struct Facts<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) fit: &'a Fit,
    pub(crate) styles: [Style; 2],
    pub(crate) programs: &'a Programs,
    pub(crate) without: &'a [Without],
}

/// A question, its answer, and what to show with it.
#[derive(Debug, Serialize)]
pub(crate) struct Question {
    id: &'static str,
    question: Message,
    answer: Message,
    show: Option<Show>,
}

impl Question {
    /// The question and its answer.
    pub(crate) fn texts(&self) -> (&Message, &Message) {
        (&self.question, &self.answer)
    }
}

/// The target of a pointer on the page.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
enum Show {
    /// A vertex of the set, by its position.
    Vertex { index: usize },
    /// A reading.
    Row { row: usize },
    /// A layer of the parameter plane.
    Layer { layer: &'static str },
}

/// The questions that these data answer.
pub(crate) fn questions(facts: &Facts<'_>) -> Vec<Question> {
    let asked = [
        Some(estimates::least_squares(facts)),
        bounds::contradiction(facts),
        bounds::upper_end(facts),
        bounds::other_end(facts),
        bounds::recession(facts),
        Some(half_planes::how_many_matter(facts)),
        rows::one_that_matters(facts),
        rows::one_that_does_not(facts),
        Some(error_bound::least(facts)),
        estimates::central(facts),
        approximations::box_full(facts),
        approximations::inner_or_outer(facts),
        approximations::solvers(facts),
    ];
    asked.into_iter().flatten().collect()
}

impl Facts<'_> {
    fn region(&self) -> &Region {
        self.fit.fps.polyhedron().region()
    }

    fn inequalities(&self) -> &[Inequality] {
        self.fit.fps.polyhedron().system().inequalities()
    }

    fn is_line(&self) -> bool {
        matches!(self.problem.measurements.model(), Model::Line { .. })
    }

    /// The intersection of the half-planes but those given, with the names of the others by their indices there.
    fn others(&self, left_out: &[usize]) -> (Polyhedron, Vec<BoundName>) {
        let kept = self.inequalities().iter().enumerate().filter(|(index, _)| !left_out.contains(index));
        let (names, inequalities): (Vec<BoundName>, Vec<Inequality>) =
            kept.map(|(index, inequality)| (self.fit.fps.name(index), inequality.clone())).unzip();
        (Polyhedron::intersect(inequalities.into_iter().collect()), names)
    }

    /// The inequality with a name.
    fn inequality(&self, name: BoundName) -> Option<&Inequality> {
        let position = (0..self.inequalities().len()).find(|&index| self.fit.fps.name(index) == name)?;
        self.inequalities().get(position)
    }
}
