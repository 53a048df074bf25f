//! The set beside boxes, hulls and what solvers say.

use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::RegionKind;
use boundfit_lp::{Judgement, PuiEnd, ToleranceUnit, Verdict};

use super::wording::{THETA, sentences, size};
use super::{Facts, Question, Show};
use crate::layers::{LpAnswer, proportion, reason, verdict_key};
use crate::texts::{Message, Value, text};

/// Asks how much of the PUI box is feasible.
pub(super) fn box_full(facts: &Facts<'_>) -> Option<Question> {
    let answer = match (facts.region().kind(), facts.fit.tightness()) {
        (RegionKind::Point, _) => text!("q.box.point"),
        (RegionKind::Segment, None) => text!("q.box.along"),
        (RegionKind::Segment, Some(_)) => text!("q.box.diagonal"),
        (RegionKind::Polygon, Some(tightness)) if tightness == Rational::one() => text!("q.box.rectangle"),
        (RegionKind::Polygon, Some(tightness)) => {
            let share = size(&(tightness * Rational::from(100)), Rounding::Down);
            text!("q.box.part", share: share, conditions: facts.problem.conditions.len())
        }
        _ => return None,
    };
    let show = Some(Show::Layer { layer: "pui" });
    Some(Question { id: "box-full", question: text!("q.box.question"), answer, show })
}

/// Is the hull of the optimisers an inner or an outer approximation?
pub(super) fn inner_or_outer(facts: &Facts<'_>) -> Option<Question> {
    let found = &facts.programs.directions;
    if facts.region().kind() != RegionKind::Polygon {
        return None;
    }
    let inner = found.inner.as_ref()?;
    let outer = found.outer.as_ref()?.area.as_ref()?;
    let inner_area = inner.area.as_ref()?;
    let exact = facts.region().area()?;
    // Every optimiser is a vertex of the set, and so of the hull.
    let optimisers = inner.vertices.len();
    let areas = [inner_area, &exact].map(|area| size(area, Rounding::Nearest));
    let is_little = areas[0] == areas[1];
    let [area_of_hull, area_of_set] = areas;
    let hull = if *inner_area == exact {
        text!("q.hull.whole", optimisers: optimisers, area: area_of_set)
    } else if inner_area.is_zero() {
        text!("q.hull.segment", area: area_of_set)
    } else if is_little {
        text!("q.hull.little", area: area_of_set)
    } else {
        text!("q.hull.part", hull: area_of_hull, area: area_of_set)
    };
    let outer = if *outer == exact {
        text!("q.hull.outer-whole", count: found.count)
    } else {
        text!("q.hull.outer-part", count: found.count, area: size(outer, Rounding::Up))
    };
    let answer = sentences([text!("q.hull.inner"), hull, outer]);
    let question = text!("q.hull.question", count: found.count, optimisers: optimisers);
    Some(Question { id: "inner-or-outer", question, answer, show: Some(Show::Layer { layer: "directions" }) })
}

/// Did the solvers get the bounds right?
pub(super) fn solvers(facts: &Facts<'_>) -> Option<Question> {
    let floating: Vec<&LpAnswer> = facts.programs.answers.iter().filter(|answer| !answer.is_exact).collect();
    if floating.is_empty() {
        return None;
    }
    let found = floating
        .iter()
        .map(|answer| text!("q.solvers.of", name: &*answer.source, finding: finding(facts, answer)));
    let asked = if facts.region().is_empty() { "q.solvers.question-empty" } else { "q.solvers.question" };
    let names = Value::listed(floating.iter().map(|answer| answer.source.as_str()));
    let answer = sentences([text!("q.solvers.judged")].into_iter().chain(found));
    let show = Some(Show::Layer { layer: "lp" });
    Some(Question { id: "solvers-right", question: text!(asked, names: names), answer, show })
}

fn finding(facts: &Facts<'_>, answer: &LpAnswer) -> Message {
    let judgements = answer.judgements.iter().flatten();
    let worst = judgements.map(|judgement| judgement.verdict).max().unwrap_or(Verdict::NoAnswer);
    let right = || largest_error(answer, worst).map_or_else(|| text!("q.solvers.all"), right_to);
    match worst {
        Verdict::Exact if facts.region().is_empty() => text!("q.solvers.finds-empty"),
        Verdict::Exact => text!("q.solvers.exact", ends: four_ends(facts)),
        Verdict::Rounded => text!("q.solvers.rounded", ends: right()),
        Verdict::WithinTolerance => text!("q.solvers.within", ends: right()),
        verdict => verdict_on(answer, verdict),
    }
}

/// The problem with an answer, at which ends.
fn verdict_on(answer: &LpAnswer, verdict: Verdict) -> Message {
    let of_worst = |end: &PuiEnd| end.of(&answer.judgements).verdict == verdict;
    let named = |end: PuiEnd| text!(&format!("end.{}", end.end().name()), theta: THETA[end.axis()]);
    let ends: Vec<Message> = PuiEnd::ALL.into_iter().filter(of_worst).map(named).collect();
    let ends: Value =
        if ends.len() == PuiEnd::ALL.len() { text!("q.solvers.all").into() } else { Value::listed(ends) };
    let off = match verdict {
        Verdict::Loose | Verdict::Unsafe => largest_error(answer, verdict),
        _ => None,
    };
    let found = match (verdict, off) {
        (Verdict::NoAnswer, _) => text!("q.solvers.no-answer"),
        (_, Some(error)) => text!("q.solvers.off", size: proportion(error)),
        (_, None) => text!("q.solvers.wrong"),
    };
    let verdict_name = text!(&verdict_key(verdict));
    let mut said = vec![found.with("ends", ends).with("verdict", verdict_name)];
    said.extend(common_reason(answer, verdict));
    sentences(said)
}

/// Returns how nearly right all ends are, in proportion.
fn right_to(error: (Rational, Option<ToleranceUnit>)) -> Message {
    text!("q.solvers.right-to", size: proportion(error))
}

/// The largest error of the ends with this verdict.
fn largest_error(answer: &LpAnswer, verdict: Verdict) -> Option<(Rational, Option<ToleranceUnit>)> {
    let ends = answer.judgements.iter().flatten().filter(|judgement| judgement.verdict == verdict);
    Judgement::largest_error(ends)
}

/// The ends of both intervals, of which some may be infinite.
fn four_ends(facts: &Facts<'_>) -> Message {
    let bounded = facts.fit.pui_intervals().map_or(0, |pui| {
        pui.iter()
            .flat_map(|range| [range.lower(), range.upper()])
            .filter(|end| end.value().is_some())
            .count()
    });
    match bounded {
        0 => text!("q.solvers.no-ends"),
        4 => text!("q.solvers.all"),
        _ => text!("q.solvers.all-infinite"),
    }
}

/// Returns the remark about every end with a verdict, if all have the same.
fn common_reason(answer: &LpAnswer, verdict: Verdict) -> Option<Message> {
    let with_verdict = answer.judgements.iter().flatten().filter(|judgement| judgement.verdict == verdict);
    let mut reasons = with_verdict.map(reason);
    let first = reasons.next()?;
    if reasons.all(|other| other == first) { first } else { None }
}
