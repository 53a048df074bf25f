//! What changes when a reading is left out.

use boundfit_exact::Rounding;
use boundfit_geometry::{Redundancy, RegionKind};
use boundfit_lp::End;

use super::wording::{THETA, bound, bounds, described, sentence, size, value};
use super::{Facts, Question, Show};
use crate::half_planes::irredundant;
use crate::leave_one_out::{Moved, Without};

/// A reading that matters: the one without which most ends move.
pub(super) fn one_that_matters(facts: &Facts<'_>) -> Option<Question> {
    let mattering = facts.without.iter().filter(|without| without.matters);
    // The first of several equal ones.
    let without =
        mattering.reduce(|most, next| if next.moved.len() > most.moved.len() { next } else { most })?;
    let region = facts.region();
    let answer = if region.is_empty() {
        format!("The set is no longer empty: it is {}.", described(&without.region))
    } else {
        let ends: Vec<String> = without.moved.iter().map(|moved| moved_end(facts, moved)).collect();
        let ends = if ends.is_empty() {
            "Neither interval changes, but the set grows".to_owned()
        } else {
            sentence(&ends.join("; "))
        };
        format!("{ends}. {}", shape_change(facts, without))
    };
    Some(Question {
        id: "remove-a-reading-that-matters",
        question: format!("Leave out reading {}: what changes?", without.row),
        answer,
        show: Some(Show::Row { row: without.row }),
    })
}

fn moved_end(facts: &Facts<'_>, moved: &Moved) -> String {
    let theta = THETA[moved.axis];
    let (end, way, infinity, rounding) = match moved.end {
        End::Lower => ("lower", "down", "−∞", Rounding::Down),
        End::Upper => ("upper", "up", "∞", Rounding::Up),
    };
    match &moved.by_and_to {
        Some((by, to)) => {
            let to = value(to, facts.digits.of_parameter(moved.axis), rounding);
            format!("the {end} end of {theta} moves {way} by {} to {to}", size(by, Rounding::Up))
        }
        None => format!("the {end} end of {theta} goes {way} to {infinity}"),
    }
}

fn shape_change(facts: &Facts<'_>, without: &Without) -> String {
    let before = facts.region();
    let after = &without.region;
    match (before.area(), after.area()) {
        (Some(old), Some(new)) if after.kind() == RegionKind::Polygon => {
            let [old, new] = [&old, &new].map(|area| size(area, Rounding::Nearest));
            format!("The set is then {}, and its area grows from {old} to {new}.", described(after))
        }
        _ => format!("The set is then {}.", described(after)),
    }
}

/// A reading that does not matter.
pub(super) fn one_that_does_not(facts: &Facts<'_>) -> Option<Question> {
    let needed = irredundant(facts.problem, facts.fit);
    let is_needed =
        |position: usize| needed.contains(&(2 * position)) || needed.contains(&(2 * position + 1));
    let idle = || facts.without.iter().enumerate().filter(|(_, without)| !without.matters);
    // Better one with a reason of its own than the twin of one that matters.
    let (position, without) = idle().find(|(position, _)| !is_needed(*position)).or_else(|| idle().next())?;
    let answer = if facts.region().is_empty() {
        "Nothing: the set is empty without it too, because what is left still contradicts itself.".to_owned()
    } else {
        let redundancies = facts.fit.fps.polyhedron().redundancies();
        let reason = |index: usize, which: &str| {
            redundancies
                .get(index)?
                .as_ref()
                .map(|redundancy| format!("Its {which} bound {}", why(facts, redundancy)))
        };
        match (reason(2 * position, "upper"), reason(2 * position + 1, "lower")) {
            (Some(upper), Some(lower)) => format!("Nothing at all. {upper}. {lower}."),
            _ => "Nothing at all: other bounds are the same half-planes as its own.".to_owned(),
        }
    };
    Some(Question {
        id: "remove-a-reading-that-does-not-matter",
        question: format!("Leave out reading {}: what changes?", without.row),
        answer,
        show: Some(Show::Row { row: without.row }),
    })
}

/// Why a half-plane could be left out.
fn why(facts: &Facts<'_>, redundancy: &Redundancy) -> String {
    match redundancy {
        Redundancy::Always => "holds for every θ".to_owned(),
        Redundancy::SameAs(index) => {
            format!("is the same half-plane as {}", bound(facts.fit.fps.name(*index), facts.problem))
        }
        Redundancy::Dominated { by, slack } => {
            let names = bounds(by.iter().map(|m| facts.fit.fps.name(m.index)), facts.problem);
            let spare = if slack.is_zero() {
                "with nothing to spare: it touches the set".to_owned()
            } else {
                format!("with {} to spare", size(slack, Rounding::Down))
            };
            format!("follows from {names}, {spare}")
        }
        Redundancy::EmptyWithout => "is not needed".to_owned(),
    }
}
