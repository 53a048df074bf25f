//! The changes when a reading is left out.

use boundfit_estimation::{BoundName, bounds_of_reading};
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{Inequality, Multiplier, Polyhedron, Region, RegionKind, Support};
use boundfit_lp::End;

use super::wording::{THETA, bound, clash, combination, described, sentences, size, value};
use super::{Facts, Question, Show};
use crate::half_planes::irredundant;
use crate::leave_one_out::{Moved, Without};
use crate::number::DIGITS;
use crate::texts::{Message, Value, text};

/// A reading that matters: the one without which most ends move.
pub(super) fn one_that_matters(facts: &Facts<'_>) -> Option<Question> {
    let mattering = facts.without.iter().filter(|without| without.matters);
    // The first of several equal ones.
    let without =
        mattering.reduce(|most, next| if next.moved.len() > most.moved.len() { next } else { most })?;
    let answer = if facts.region().is_empty() {
        text!("q.without.not-empty", set: described(&without.region))
    } else {
        let ends = match without.moved.as_slice() {
            [] => text!("q.without.no-end"),
            moved => {
                let ends = moved.iter().map(|moved| moved_end(facts, moved));
                text!("q.without.ends", ends: Value::joined(ends, "list.semicolon"))
            }
        };
        sentences([ends, shape_change(facts, without)])
    };
    Some(Question {
        id: "remove-a-reading-that-matters",
        question: text!("q.without.question", row: without.row),
        answer,
        show: Some(Show::Row { row: without.row }),
    })
}

fn moved_end(facts: &Facts<'_>, moved: &Moved) -> Message {
    let (by_and_to, to_infinity, rounding) = match moved.end {
        End::Lower => ("q.without.lower-moves", "q.without.lower-infinite", Rounding::Down),
        End::Upper => ("q.without.upper-moves", "q.without.upper-infinite", Rounding::Up),
    };
    let theta = THETA[moved.axis];
    match &moved.by_and_to {
        Some((by, to)) => {
            let to = value(to, facts.styles[moved.axis].significant(), rounding);
            text!(by_and_to, theta: theta, by: size(by, Rounding::Up), to: to)
        }
        None => text!(to_infinity, theta: theta),
    }
}

fn shape_change(facts: &Facts<'_>, without: &Without) -> Message {
    let before = facts.region();
    let after = &without.region;
    let area = |region: &Region| region.area().map(|area| size(&area, Rounding::Nearest));
    let changed = |key: &str| text!(key, before: described(before), after: described(after));
    match (area(before), area(after)) {
        (Some(old), Some(new)) if before.kind() == RegionKind::Polygon => {
            text!("q.without.larger", after: described(after), old: old, new: new)
        }
        (_, Some(new)) if after.kind() == RegionKind::Polygon => {
            changed("q.without.instead-area").with("area", new)
        }
        _ if before.kind() == after.kind() => text!("q.without.then", after: larger(after)),
        _ => changed("q.without.instead"),
    }
}

/// A set of the same kind as one that it contains.
fn larger(region: &Region) -> Message {
    match region.kind() {
        RegionKind::Segment => text!("set.longer-segment"),
        RegionKind::Ray => text!("set.longer-ray"),
        RegionKind::Strip => text!("set.wider-strip"),
        RegionKind::HalfPlane => text!("set.larger-half-plane"),
        _ => described(region),
    }
}

/// A reading that does not matter.
pub(super) fn one_that_does_not(facts: &Facts<'_>) -> Option<Question> {
    let needed = irredundant(facts.problem, facts.fit);
    let rows = facts.problem.measurements.kept();
    let is_needed = |position: usize| bounds_of_reading(rows, position).any(|bound| needed.contains(&bound));
    let idle = || facts.without.iter().enumerate().filter(|(_, without)| !without.matters);
    // Better one with a reason of its own than the twin of one that matters.
    let (position, without) = idle().find(|(position, _)| !is_needed(*position)).or_else(|| idle().next())?;
    let answer = without_it(facts, &bounds_of_reading(rows, position).collect::<Vec<_>>());
    Some(Question {
        id: "remove-a-reading-that-does-not-matter",
        question: text!("q.without.question", row: without.row),
        answer,
        show: Some(Show::Row { row: without.row }),
    })
}

/// Returns the proof from all other half-planes that nothing changes without the bounds of a reading.
fn without_it(facts: &Facts<'_>, bounds: &[usize]) -> Message {
    let (others, names) = facts.others(bounds);
    if let Some(certificate) = others.region().certificate() {
        let named = |m: &Multiplier| names.get(m.index).copied();
        let of_rest: Vec<BoundName> = certificate.multipliers().iter().filter_map(named).collect();
        let conditions = facts.fit.contradiction_of_conditions();
        let clashing = conditions.map_or(of_rest, |terms| terms.into_iter().map(|(name, _)| name).collect());
        return text!("q.without.empty-too", clash: clash(&clashing, facts.problem));
    }
    let reason = |&index: &usize| {
        let inequality = facts.inequalities().get(index)?;
        let is_upper = matches!(facts.fit.fps.name(index), BoundName::Upper(_));
        let which = if is_upper { "q.without.its-upper" } else { "q.without.its-lower" };
        Some(text!(which, why: why(facts, inequality, &others, &names)?))
    };
    sentences([text!("q.without.nothing")].into_iter().chain(bounds.iter().filter_map(reason)))
}

/// Returns the reason why a half-plane holds wherever others do; `None` where it does not.
fn why(
    facts: &Facts<'_>,
    inequality: &Inequality,
    others: &Polyhedron,
    names: &[BoundName],
) -> Option<Message> {
    let Support::Bounded { proof, .. } = others.support(&inequality.a) else { return None };
    let slack = &inequality.b - &proof.value;
    let named = |m: &Multiplier| Some((names.get(m.index).copied()?, m.value.clone()));
    let terms: Vec<(BoundName, Rational)> = proof.multipliers.iter().map(named).collect::<Option<_>>()?;
    let from = || combination(&terms, facts.problem);
    Some(match terms.as_slice() {
        _ if slack.is_negative() => return None,
        [] => text!("q.without.always"),
        [(only, _)] if slack.is_zero() => text!("q.without.same", bound: bound(*only, facts.problem)),
        _ if slack.is_zero() => text!("q.without.touches", combination: from()),
        _ => {
            text!("q.without.spare", combination: from(), slack: value(&slack, DIGITS, Rounding::Down))
        }
    })
}
