//! The set beside boxes, hulls and what solvers say.

use boundfit_exact::english::{counted_in_words, in_words, listed};
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::RegionKind;
use boundfit_lp::{Judgement, PuiEnd, ToleranceUnit, Verdict};

use super::wording::{THETA, size};
use super::{Facts, Question, Show};
use crate::layers::{LpAnswer, proportion, reason};

/// How much of the PUI box is feasible?
pub(super) fn box_full(facts: &Facts<'_>) -> Option<Question> {
    let region = facts.region();
    let answer = match (region.kind(), facts.fit.tightness()) {
        (RegionKind::Point, _) => "All of it: the set is a single point, and so is its box.".to_owned(),
        (RegionKind::Segment, None) => {
            "All of it: the set is a segment along an axis, and so is its box.".to_owned()
        }
        (RegionKind::Segment, Some(_)) => {
            "None of its area: the set is a segment, a diagonal of the box.".to_owned()
        }
        (RegionKind::Polygon, Some(tightness)) if tightness == Rational::one() => {
            "All of it: the set is a rectangle along the axes.".to_owned()
        }
        (RegionKind::Polygon, Some(tightness)) => {
            let who = if facts.problem.conditions.is_empty() {
                "some reading"
            } else {
                "some reading or condition"
            };
            format!(
                "{} % of its area; the rest are parameter pairs that {who} rules out, although each parameter alone \
                 lies within its interval. The box tells how far each parameter can go, not which pairs go together.",
                size(&(tightness * Rational::from(100)), Rounding::Down)
            )
        }
        _ => return None,
    };
    let question =
        "The box of both parameter intervals (PUI) contains the set. How much of the box is feasible?";
    Some(Question {
        id: "box-full",
        question: question.to_owned(),
        answer,
        show: Some(Show::Layer { layer: "pui" }),
    })
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
    let [area_of_hull, area_of_set] = [inner_area, &exact].map(|area| size(area, Rounding::Nearest));
    let hull = if *inner_area == exact {
        format!(
            "Here the {} optimisers are all the vertices, so that the hull is the set itself, with area {area_of_set}.",
            in_words(optimisers)
        )
    } else if inner_area.is_zero() {
        format!(
            "Here it is only the segment between two of them, without area; the set has area {area_of_set}."
        )
    } else if area_of_hull == area_of_set {
        format!("Here it has a little less area than the set, which has {area_of_set}.")
    } else {
        format!("Here it has area {area_of_hull}, the set {area_of_set}.")
    };
    let outer_text = if *outer == exact {
        "here that, too, is the set itself".to_owned()
    } else {
        format!("its area is {}", size(outer, Rounding::Up))
    };
    let answer = format!(
        "An inner one. Each optimiser is a point of the set, and a convex set contains the hull of any of its points. \
         {hull} An outer approximation is the intersection of the {} half-planes behind the optimal values; \
         {outer_text}.",
        found.count
    );
    let question = format!(
        "{} linear programs, one for each of as many directions, end in {}. Is the hull of these points an inner or an \
         outer approximation of the set?",
        found.count,
        counted_in_words(optimisers, "optimiser", "different optimisers")
    );
    Some(Question { id: "inner-or-outer", question, answer, show: Some(Show::Layer { layer: "directions" }) })
}

/// Did the solvers get the bounds right?
pub(super) fn solvers(facts: &Facts<'_>) -> Option<Question> {
    let floating: Vec<&LpAnswer> = facts.programs.answers.iter().filter(|answer| !answer.is_exact).collect();
    if floating.is_empty() {
        return None;
    }
    let found: Vec<String> =
        floating.iter().map(|answer| format!("{}: {}.", answer.source, finding(facts, answer))).collect();
    let who = match floating.as_slice() {
        [only] => format!("the linear-programming solver {}", only.source),
        _ => "the linear-programming solvers".to_owned(),
    };
    let question = if facts.region().is_empty() {
        format!("Did {who} find out that the set is empty?")
    } else {
        format!("Did {who} get the ends of both intervals right?")
    };
    let answer = format!("Judged against the exact answer. {}", found.join(" "));
    Some(Question { id: "solvers-right", question, answer, show: Some(Show::Layer { layer: "lp" }) })
}

fn finding(facts: &Facts<'_>, answer: &LpAnswer) -> String {
    let judgements = answer.judgements.iter().flatten();
    let worst = judgements.map(|judgement| judgement.verdict).max().unwrap_or(Verdict::NoAnswer);
    match worst {
        Verdict::Exact if facts.region().is_empty() => "yes, it finds no feasible point".to_owned(),
        Verdict::Exact => format!("yes, {}", four_ends(facts)),
        Verdict::Rounded => format!("yes, all four ends, {}, which is rounding", right_to(answer, worst)),
        Verdict::WithinTolerance => {
            format!("yes, all four ends, {}; the tolerance is one millionth", right_to(answer, worst))
        }
        verdict => {
            let of_worst = |end: &PuiEnd| end.of(&answer.judgements).verdict == verdict;
            let name = |end: PuiEnd| format!("the {} end of {}", end.end().name(), THETA[end.axis()]);
            let ends: Vec<String> = PuiEnd::ALL.into_iter().filter(of_worst).map(name).collect();
            let word = if verdict == Verdict::NoAnswer { "not quite" } else { "no" };
            let ends =
                if ends.len() == PuiEnd::ALL.len() { "all four ends".to_owned() } else { listed(&ends) };
            let off = match verdict {
                Verdict::Loose | Verdict::Unsafe => largest_error(answer, verdict)
                    .map(|error| format!("off by {}: ", proportion(error)))
                    .unwrap_or_default(),
                _ => String::new(),
            };
            let why = common_reason(answer, verdict).map(|reason| format!(". {reason}")).unwrap_or_default();
            let why = why.trim_end_matches('.');
            format!("{word}, {off}the verdict on {ends} is “{}”{why}", verdict.name())
        }
    }
}

/// How nearly right the ends with this verdict are, in proportion.
fn right_to(answer: &LpAnswer, verdict: Verdict) -> String {
    largest_error(answer, verdict).map(|error| format!("right to {}", proportion(error))).unwrap_or_default()
}

/// The largest error of the ends with this verdict.
fn largest_error(answer: &LpAnswer, verdict: Verdict) -> Option<(Rational, Option<ToleranceUnit>)> {
    let ends = answer.judgements.iter().flatten().filter(|judgement| judgement.verdict == verdict);
    Judgement::largest_error(ends)
}

/// The ends of both intervals, of which some may be infinite.
fn four_ends(facts: &Facts<'_>) -> &'static str {
    let bounded = facts.fit.pui_intervals().map_or(0, |pui| {
        pui.iter()
            .flat_map(|range| [range.lower(), range.upper()])
            .filter(|end| end.value().is_some())
            .count()
    });
    match bounded {
        0 => "neither interval has an end",
        4 => "all four ends",
        _ => "all four ends, with those that are infinite",
    }
}

/// What is said about every end with a verdict, if that is one and the same thing.
fn common_reason(answer: &LpAnswer, verdict: Verdict) -> Option<String> {
    let with_verdict = answer.judgements.iter().flatten().filter(|judgement| judgement.verdict == verdict);
    let mut reasons = with_verdict.map(reason);
    let first = reasons.next()?;
    if reasons.all(|other| other == first) { first } else { None }
}
