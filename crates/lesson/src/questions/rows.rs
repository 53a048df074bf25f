//! What changes when a reading is left out.

use boundfit_estimation::{BoundName, bounds_of_reading};
use boundfit_exact::english::sentence;
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{Inequality, Multiplier, Polyhedron, Region, RegionKind, Support};
use boundfit_lp::End;

use super::wording::{THETA, bound, clash, combination, described, size, value};
use super::{Facts, Question, Show};
use crate::half_planes::irredundant;
use crate::leave_one_out::{Moved, Without};
use crate::number::DIGITS;

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
            let to = value(to, facts.styles[moved.axis].significant(), rounding);
            format!("the {end} end of {theta} moves {way} by {} to {to}", size(by, Rounding::Up))
        }
        None => format!("the {end} end of {theta} goes {way} to {infinity}"),
    }
}

fn shape_change(facts: &Facts<'_>, without: &Without) -> String {
    let before = facts.region();
    let after = &without.region;
    let area = |region: &Region| region.area().map(|area| size(&area, Rounding::Nearest));
    match (area(before), area(after)) {
        (Some(old), Some(new)) if before.kind() == RegionKind::Polygon => {
            format!("The set is then {}, and its area grows from {old} to {new}.", described(after))
        }
        (_, Some(new)) if after.kind() == RegionKind::Polygon => {
            format!("Instead of {} the set is then {}, with area {new}.", described(before), described(after))
        }
        _ if before.kind() == after.kind() => format!("The set is then {}.", larger(after)),
        _ => format!("Instead of {} the set is then {}.", described(before), described(after)),
    }
}

/// A set of the same kind as one that it contains.
fn larger(region: &Region) -> String {
    match region.kind() {
        RegionKind::Segment => "a longer segment".to_owned(),
        RegionKind::Ray => "a ray that starts farther back".to_owned(),
        RegionKind::Strip => "a wider strip between two parallel lines".to_owned(),
        RegionKind::HalfPlane => "a larger half-plane".to_owned(),
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
        question: format!("Leave out reading {}: what changes?", without.row),
        answer,
        show: Some(Show::Row { row: without.row }),
    })
}

/// Why nothing changes without the bounds of a reading, proved from all other half-planes.
fn without_it(facts: &Facts<'_>, bounds: &[usize]) -> String {
    let (others, names) = facts.others(bounds);
    if let Some(certificate) = others.region().certificate() {
        let named = |m: &Multiplier| names.get(m.index).copied();
        let of_rest: Vec<BoundName> = certificate.multipliers().iter().filter_map(named).collect();
        let conditions = facts.fit.contradiction_of_conditions();
        let clashing = conditions.map_or(of_rest, |terms| terms.into_iter().map(|(name, _)| name).collect());
        return format!(
            "Nothing: the set is empty without it too, because {}.",
            clash(&clashing, facts.problem)
        );
    }
    let reason = |&index: &usize| {
        let inequality = facts.inequalities().get(index)?;
        let which = if matches!(facts.fit.fps.name(index), BoundName::Upper(_)) { "upper" } else { "lower" };
        Some(format!(" Its {which} bound {}.", why(facts, inequality, &others, &names)?))
    };
    format!("Nothing at all.{}", bounds.iter().filter_map(reason).collect::<String>())
}

/// Why a half-plane holds wherever others do; `None` where it does not.
fn why(
    facts: &Facts<'_>,
    inequality: &Inequality,
    others: &Polyhedron,
    names: &[BoundName],
) -> Option<String> {
    let Support::Bounded { proof, .. } = others.support(&inequality.a) else { return None };
    let slack = &inequality.b - &proof.value;
    let named = |m: &Multiplier| Some((names.get(m.index).copied()?, m.value.clone()));
    let terms: Vec<(BoundName, Rational)> = proof.multipliers.iter().map(named).collect::<Option<_>>()?;
    Some(match terms.as_slice() {
        _ if slack.is_negative() => return None,
        [] => "holds for every θ".to_owned(),
        [(only, _)] if slack.is_zero() => {
            format!("is the same half-plane as {}", bound(*only, facts.problem))
        }
        _ => {
            let spare = if slack.is_zero() {
                "with nothing to spare: its boundary touches the set".to_owned()
            } else {
                format!("with {} to spare", value(&slack, DIGITS, Rounding::Down))
            };
            format!("follows from {}, {spare}", combination(&terms, facts.problem))
        }
    })
}
