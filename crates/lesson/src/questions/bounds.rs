//! What fixes the ends of the intervals, and what proves that a set is empty or shows that it goes on for ever.

use boundfit_estimation::{BoundName, ParameterBound, ParameterInterval};
use boundfit_exact::english::{counted_in_words, listed, sentence};
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{BoundProof, Direction, Multiplier, Region, RegionKind, UnboundedProof};
use boundfit_lp::End;

use super::wording::{THETA, clash, combination, described, every_bound, never, owners, pair, value};
use super::{Facts, Question, Show};
use crate::half_planes::contradiction as contradiction_of;
use crate::number::DIGITS;

/// Why is there no feasible line?
pub(super) fn contradiction(facts: &Facts<'_>) -> Option<Question> {
    let terms = contradiction_of(facts.problem, facts.fit)?;
    let products = terms.iter().map(|(name, times)| Some(&facts.inequality(*name)?.b * times));
    let sum: Rational = products.collect::<Option<Vec<_>>>()?.into_iter().sum();
    let sum = value(&sum, DIGITS, Rounding::Up);
    let answer = match terms.as_slice() {
        [(name, _)] => {
            let says = value(&facts.inequality(*name)?.b, DIGITS, Rounding::Up);
            format!(
                "{} can never hold: it says 0 ≤ {says}, whatever θ is.",
                sentence(&never(*name, facts.problem))
            )
        }
        _ => format!(
            "{}. As inequalities in θ, {} add up to 0 ≤ {sum}, which is false for every θ.",
            sentence(&contradicting(&terms, facts)),
            combination(&terms, facts.problem)
        ),
    };
    let row = terms.iter().find_map(|(name, _)| name.row());
    let noun = if facts.is_line() { "line" } else { "parameter pair" };
    Some(Question {
        id: "why-empty",
        question: format!("Why is no {noun} feasible?"),
        answer,
        show: row.map(|row| Show::Row { row }),
    })
}

/// `three bounds contradict each other`, of several half-planes.
fn contradicting(terms: &[(BoundName, Rational)], facts: &Facts<'_>) -> String {
    let bounds = terms.iter().filter(|(name, _)| name.row().is_some()).count();
    let conditions = terms.len() - bounds;
    let bounds_text = counted_in_words(bounds, "bound", "bounds");
    match (bounds, conditions) {
        (0, _) => {
            let names: Vec<BoundName> = terms.iter().map(|(name, _)| *name).collect();
            format!("{}, whatever the readings are", clash(&names, facts.problem))
        }
        (_, 0) => format!("{bounds_text} contradict each other"),
        _ => format!(
            "{bounds_text} and {} contradict each other",
            counted_in_words(conditions, "condition", "conditions")
        ),
    }
}

/// What fixes the largest feasible θ₁?
pub(super) fn upper_end(facts: &Facts<'_>) -> Option<Question> {
    let pui = facts.fit.pui.as_ref()?;
    Some(match &pui[0].upper {
        ParameterBound::Bounded { value, proof } => {
            end(facts, "upper-end-theta1", 0, End::Upper, value, proof)
        }
        ParameterBound::Unbounded(proof) => Question {
            id: "upper-end-theta1",
            question: "How large can θ₁ be?".to_owned(),
            answer: unbounded(proof),
            show: None,
        },
    })
}

fn unbounded(proof: &UnboundedProof) -> String {
    format!(
        "As large as you like. From the feasible point {} one can go on for ever in the direction {} without \
         leaving the set, and θ₁ grows all the way.",
        pair(&proof.point.coordinates()),
        direction(&proof.ray)
    )
}

/// Where the upper end of θ₁ is not bounded, what fixes the first end that is.
pub(super) fn other_end(facts: &Facts<'_>) -> Option<Question> {
    let pui = facts.fit.pui.as_ref()?;
    if let ParameterBound::Bounded { .. } = pui[0].upper {
        return None;
    }
    let end_of = |interval: &ParameterInterval, end: End| match end {
        End::Lower => interval.lower.clone(),
        End::Upper => interval.upper.clone(),
    };
    let asked = [
        ("lower-end-theta1", 0, End::Lower),
        ("upper-end-theta2", 1, End::Upper),
        ("lower-end-theta2", 1, End::Lower),
    ];
    asked.into_iter().find_map(|(id, axis, which)| match end_of(&pui[axis], which) {
        ParameterBound::Bounded { value, proof } => Some(end(facts, id, axis, which, &value, &proof)),
        ParameterBound::Unbounded(_) => None,
    })
}

fn end(
    facts: &Facts<'_>,
    id: &'static str,
    axis: usize,
    end: End,
    end_value: &Rational,
    proof: &BoundProof,
) -> Question {
    let named = |m: &Multiplier| (facts.fit.fps.name(m.index), m.value.clone());
    let terms: Vec<(BoundName, Rational)> = proof.multipliers.iter().map(named).collect();
    let (owners, _) = owners(terms.iter().map(|(name, _)| *name), facts.problem);
    let (extreme, relation, beyond, rounding) = match end {
        End::Lower => ("smallest", "≥", "smaller", Rounding::Down),
        End::Upper => ("largest", "≤", "larger", Rounding::Up),
    };
    let theta = THETA[axis];
    let what = value(end_value, facts.styles[axis].significant(), rounding);
    let proof_text = match terms.as_slice() {
        [(_, times)] if *times == Rational::one() => format!("It says that {theta} {relation} {what}"),
        [_] => format!("{} is {theta} {relation} {what}", sentence(&combination(&terms, facts.problem))),
        _ => format!("{} gives {theta} {relation} {what}", sentence(&combination(&terms, facts.problem))),
    };
    let vertices = facts.region().vertices();
    let vertex = vertices.iter().position(|vertex| *vertex.point() == proof.attained_at);
    let show = vertex.map(|index| Show::Vertex { index });
    let attained = match vertex {
        Some(_) if facts.region().kind() == RegionKind::Point => {
            ", and the only feasible parameter pair attains it"
        }
        Some(_) if facts.region().kind() == RegionKind::Segment => ", and an end of the segment attains it",
        Some(_) => ", and a vertex of the set attains it",
        None => ", and there are feasible parameters that attain it",
    };
    let is_only_one =
        facts.fit.pui_intervals().and_then(|pui| pui[axis].width()).is_some_and(|w| w.is_zero());
    let only = if is_only_one { format!(" No other {theta} is feasible.") } else { String::new() };
    Question {
        id,
        question: format!("{} the {extreme} feasible {theta}?", who_fixes(&terms)),
        answer: format!(
            "{}. {proof_text}, so that no feasible {theta} is {beyond}{attained}.{only}",
            sentence(&owners)
        ),
        show: show.or_else(|| terms.iter().find_map(|(name, _)| name.row()).map(|row| Show::Row { row })),
    }
}

/// The start of a question about who fixes something.
fn who_fixes(terms: &[(BoundName, Rational)]) -> &'static str {
    let readings = terms.iter().filter(|(name, _)| name.row().is_some()).count();
    match (readings, terms.len() - readings) {
        (1, 0) => "Which reading fixes",
        (2, 0) => "Which two readings fix",
        (0, 1) => "Which condition fixes",
        (0, 2) => "Which two conditions fix",
        (1, 1) => "Which reading and which condition fix",
        _ => "What fixes",
    }
}

/// In which directions does the set go on for ever?
pub(super) fn recession(facts: &Facts<'_>) -> Option<Question> {
    let region = facts.region();
    if region.is_bounded() {
        return None;
    }
    let answer = if region.kind() == RegionKind::Plane {
        format!(
            "In every direction: {} holds for every θ, so that the set is the whole plane.",
            every_bound(facts.problem)
        )
    } else {
        let phi = if facts.is_line() { "φ = (x, 1)" } else { "φ" };
        format!(
            "It is {}, and it goes on for ever {}. A further reading with regressors {phi} stops a direction d as soon as \
             φ·d is not 0.",
            described(region),
            ways(region)
        )
    };
    let question = "In which directions does the feasible parameter set go on for ever?".to_owned();
    Some(Question { id: "directions-without-end", question, answer, show: None })
}

/// The directions in which an unbounded set goes on, other than the plane.
fn ways(region: &Region) -> String {
    let rays: Vec<String> = region.rays().iter().map(direction).collect();
    let lines: Vec<String> = region.lines().iter().map(direction).collect();
    match (rays.as_slice(), lines.as_slice()) {
        ([from, to], _) => format!("along {from}, along {to} and in every direction between the two"),
        ([ray], [line]) => format!("to both sides along {line} and in every direction on the side of {ray}"),
        (_, [line]) => format!("to both sides along {line}"),
        _ => format!("along {}", listed(&rays)),
    }
}

fn direction(direction: &Direction) -> String {
    pair(&[direction.dx(), direction.dy()].map(Rational::from))
}
