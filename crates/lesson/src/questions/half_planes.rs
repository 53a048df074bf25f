//! How many half-planes the set needs.

use boundfit_exact::english::{counted_in_words, in_words, sentence};
use boundfit_geometry::{Redundancy, RegionKind};

use super::wording::{bounds, every_bound};
use super::{Facts, Question};
use crate::half_planes::irredundant;
use crate::region::same_set;

/// How many of the half-planes matter?
pub(super) fn how_many_matter(facts: &Facts<'_>) -> Question {
    let needed = irredundant(facts.problem, facts.fit);
    let total = facts.inequalities().len();
    let names = bounds(needed.iter().map(|&index| facts.fit.fps.name(index)), facts.problem);
    let count = sentence(&in_words(needed.len()));
    let others = if total == needed.len() + 1 { "The other one" } else { "All the others" };
    let (asked, rest) = if facts.region().is_empty() {
        (
            "are enough to leave nothing",
            format!("{others} could be left out, and the set would still be empty."),
        )
    } else {
        let choice = if has_choice(facts, &needed) { " This is not the only such choice." } else { "" };
        ("shape the set", format!("{others} could be left out, and the set would be the same.{choice}"))
    };
    let answer = match needed.len() {
        0 => format!("None: {} holds for every θ.", every_bound(facts.problem)),
        count if count == total => format!("All of them: {names}."),
        _ => format!("{count}: {names}. {rest}"),
    };
    let question = format!(
        "{} {}. How many of these {asked}?",
        givers(facts),
        counted_in_words(total, "half-plane", "half-planes")
    );
    Question { id: "how-many-matter", question, answer, show: None }
}

/// Whether other half-planes than these would shape the set just as well: some repeat one of them, or the set is flat
/// and one of them could be replaced.
fn has_choice(facts: &Facts<'_>, needed: &[usize]) -> bool {
    use RegionKind::{Line, Point, Ray, Segment};
    let polyhedron = facts.fit.fps.polyhedron();
    let repeats = |reason: &Option<Redundancy>| matches!(reason, Some(Redundancy::SameAs(_)));
    let replaceable = |index: &usize| same_set(facts.others(&[*index]).0.region(), facts.region());
    polyhedron.redundancies().iter().any(repeats)
        || (matches!(facts.region().kind(), Point | Segment | Ray | Line) && needed.iter().any(replaceable))
}

/// `23 readings and one condition give`.
fn givers(facts: &Facts<'_>) -> String {
    let rows = facts.problem.measurements.kept().len();
    let readings = counted_in_words(rows, "reading", "readings");
    let givers = match facts.problem.conditions.len() {
        0 => format!("{readings} {}", if rows == 1 { "gives" } else { "give" }),
        conditions => {
            format!("{readings} and {} give", counted_in_words(conditions, "condition", "conditions"))
        }
    };
    sentence(&givers)
}
