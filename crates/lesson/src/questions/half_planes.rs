//! The number of half-planes that the set needs.

use boundfit_geometry::{Redundancy, RegionKind};

use super::wording::{bounds, every_bound, sentences};
use super::{Facts, Question};
use crate::half_planes::irredundant;
use crate::region::same_set;
use crate::texts::text;

/// Asks how many of the half-planes matter.
pub(super) fn how_many_matter(facts: &Facts<'_>) -> Question {
    let needed = irredundant(facts.problem, facts.fit);
    let total = facts.inequalities().len();
    let names = bounds(needed.iter().map(|&index| facts.fit.fps.name(index)), facts.problem);
    let is_empty = facts.region().is_empty();
    let answer = match needed.len() {
        0 => text!("q.matter.none", bounds: every_bound(facts.problem)),
        count if count == total => text!("q.matter.all", names: names),
        count => {
            let some = text!("q.matter.some", count: count, names: names);
            let rest = if is_empty { "q.matter.rest-empty" } else { "q.matter.rest" };
            let mut said = vec![some, text!(rest, others: total - needed.len())];
            if !is_empty && has_choice(facts, &needed) {
                said.push(text!("q.matter.choice"));
            }
            sentences(said)
        }
    };
    let asked = if is_empty { "q.matter.question-empty" } else { "q.matter.question" };
    let question = text!(
        asked,
        readings: facts.problem.measurements.kept().len(),
        conditions: facts.problem.conditions.len(),
        total: total
    );
    Question { id: "how-many-matter", question, answer, show: None }
}

/// Returns whether other half-planes than these would shape the set just as well: some repeat one of them, or the set is flat
/// and one of them could be replaced.
fn has_choice(facts: &Facts<'_>, needed: &[usize]) -> bool {
    use RegionKind::{Line, Point, Ray, Segment};
    let polyhedron = facts.fit.fps.polyhedron();
    let repeats = |reason: &Option<Redundancy>| matches!(reason, Some(Redundancy::SameAs(_)));
    let replaceable = |index: &usize| same_set(facts.others(&[*index]).0.region(), facts.region());
    polyhedron.redundancies().iter().any(repeats)
        || (matches!(facts.region().kind(), Point | Segment | Ray | Line) && needed.iter().any(replaceable))
}
