//! How many half-planes the set needs.

use super::wording::{bounds, counted, in_words, sentence};
use super::{Facts, Question};
use crate::half_planes::irredundant;

/// How many of the half-planes matter?
pub(super) fn how_many_matter(facts: &Facts<'_>) -> Question {
    let needed = irredundant(facts.problem, facts.fit);
    let total = facts.inequalities().len();
    let names = bounds(needed.iter().map(|&index| facts.fit.fps.name(index)), facts.problem);
    let count = sentence(&in_words(needed.len()));
    let (asked, rest) = if facts.region().is_empty() {
        ("are enough to leave nothing", "All the others could be left out.")
    } else {
        ("shape the set", "All the others could be left out, and the set would be the same.")
    };
    let answer = match needed.len() {
        0 => "None: each of them holds for every θ.".to_owned(),
        count if count == total => format!("All of them: {names}."),
        _ => format!("{count}: {names}. {rest}"),
    };
    let question = format!(
        "{} {}. How many of these {asked}?",
        givers(facts),
        counted(total, "half-plane", "half-planes")
    );
    Question { id: "how-many-matter", question, answer, show: None }
}

/// `23 readings and one condition give`.
fn givers(facts: &Facts<'_>) -> String {
    let rows = facts.problem.measurements.rows().len();
    let readings = counted(rows, "reading", "readings");
    let givers = match facts.problem.conditions.len() {
        0 => format!("{readings} {}", if rows == 1 { "gives" } else { "give" }),
        conditions => format!("{readings} and {} give", counted(conditions, "condition", "conditions")),
    };
    sentence(&givers)
}
