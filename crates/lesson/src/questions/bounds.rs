//! The half-planes that fix the ends of the intervals, and the proofs that a set is empty or goes on for ever.

use boundfit_estimation::{BoundName, ParameterBound, ParameterInterval};
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{BoundProof, Direction, Multiplier, Region, RegionKind, UnboundedProof};
use boundfit_lp::End;

use super::wording::{
    THETA, clash, combination, described, every_bound, never, owners, pair, sentences, value,
};
use super::{Facts, Question, Show};
use crate::half_planes::contradiction as contradiction_of;
use crate::number::DIGITS;
use crate::texts::{Message, Value, text};

/// Asks why there is no feasible line.
pub(super) fn contradiction(facts: &Facts<'_>) -> Option<Question> {
    let terms = contradiction_of(facts.problem, facts.fit)?;
    let products = terms.iter().map(|(name, times)| Some(&facts.inequality(*name)?.b * times));
    let sum: Rational = products.collect::<Option<Vec<_>>>()?.into_iter().sum();
    let sum = value(&sum, DIGITS, Rounding::Up);
    let answer = match terms.as_slice() {
        [(name, _)] => {
            let says = value(&facts.inequality(*name)?.b, DIGITS, Rounding::Up);
            text!("q.empty.alone", what: never(*name, facts.problem), number: says)
        }
        _ => {
            let added = text!("q.empty.sum", combination: combination(&terms, facts.problem), number: sum);
            sentences([contradicting(&terms, facts), added])
        }
    };
    let row = terms.iter().find_map(|(name, _)| name.row());
    let question = if facts.is_line() { "q.empty.question-line" } else { "q.empty.question-pair" };
    Some(Question {
        id: "why-empty",
        question: text!(question),
        answer,
        show: row.map(|row| Show::Row { row }),
    })
}

/// `Three bounds contradict each other.`, of several half-planes.
fn contradicting(terms: &[(BoundName, Rational)], facts: &Facts<'_>) -> Message {
    let bounds = terms.iter().filter(|(name, _)| name.row().is_some()).count();
    let conditions = terms.len() - bounds;
    match (bounds, conditions) {
        (0, _) => {
            let names: Vec<BoundName> = terms.iter().map(|(name, _)| *name).collect();
            text!("q.empty.whatever", clash: clash(&names, facts.problem))
        }
        (_, 0) => text!("q.empty.bounds", bounds: bounds),
        _ => text!("q.empty.both", bounds: bounds, conditions: conditions),
    }
}

/// Asks what fixes the largest feasible θ₁.
pub(super) fn upper_end(facts: &Facts<'_>) -> Option<Question> {
    let pui = facts.fit.pui.as_ref()?;
    Some(match &pui[0].upper {
        ParameterBound::Bounded { value, proof } => {
            end(facts, "upper-end-theta1", 0, End::Upper, value, proof)
        }
        ParameterBound::Unbounded(proof) => Question {
            id: "upper-end-theta1",
            question: text!("q.end.how-large"),
            answer: unbounded(proof),
            show: None,
        },
    })
}

fn unbounded(proof: &UnboundedProof) -> Message {
    let point = pair(&proof.point.coordinates());
    text!("q.end.unbounded", point: point, direction: direction(&proof.ray))
}

/// Asks what fixes the first bounded end, if the upper end of θ₁ is not bounded.
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
    let (largest, answer, relation, rounding) = match end {
        End::Lower => ("q.end.smallest", "q.end.answer-lower", "≥", Rounding::Down),
        End::Upper => ("q.end.largest", "q.end.answer-upper", "≤", Rounding::Up),
    };
    let theta = THETA[axis];
    let proved = match terms.as_slice() {
        [(_, times)] if *times == Rational::one() => "q.end.says",
        [_] => "q.end.is",
        _ => "q.end.gives",
    };
    let proved = text!(
        proved,
        combination: combination(&terms, facts.problem),
        theta: theta,
        relation: relation,
        value: value(end_value, facts.styles[axis].significant(), rounding)
    );
    let vertices = facts.region().vertices();
    let vertex = vertices.iter().position(|vertex| *vertex.point() == proof.attained_at);
    let show = vertex.map(|index| Show::Vertex { index });
    let attained = match vertex {
        Some(_) if facts.region().kind() == RegionKind::Point => "q.end.by-point",
        Some(_) if facts.region().kind() == RegionKind::Segment => "q.end.by-segment",
        Some(_) => "q.end.by-vertex",
        None => "q.end.by-some",
    };
    let answer = text!(answer, owners: owners, proof: proved, theta: theta, attained: text!(attained));
    let is_only_one =
        facts.fit.pui_intervals().and_then(|pui| pui[axis].width()).is_some_and(|w| w.is_zero());
    let only = is_only_one.then(|| text!("q.end.only", theta: theta));
    Question {
        id,
        question: text!(who_fixes(&terms), what: text!(largest, theta: theta)),
        answer: sentences([Some(answer), only].into_iter().flatten()),
        show: show.or_else(|| terms.iter().find_map(|(name, _)| name.row()).map(|row| Show::Row { row })),
    }
}

/// The question about who fixes something.
fn who_fixes(terms: &[(BoundName, Rational)]) -> &'static str {
    let readings = terms.iter().filter(|(name, _)| name.row().is_some()).count();
    match (readings, terms.len() - readings) {
        (1, 0) => "q.end.who-reading",
        (2, 0) => "q.end.who-readings",
        (0, 1) => "q.end.who-condition",
        (0, 2) => "q.end.who-conditions",
        (1, 1) => "q.end.who-both",
        _ => "q.end.who-any",
    }
}

/// Asks in which directions the set goes on for ever.
pub(super) fn recession(facts: &Facts<'_>) -> Option<Question> {
    let region = facts.region();
    if region.is_bounded() {
        return None;
    }
    let answer = if region.kind() == RegionKind::Plane {
        text!("q.recession.plane", bounds: every_bound(facts.problem))
    } else {
        let phi = if facts.is_line() { "φ = (x, 1)" } else { "φ" };
        text!("q.recession.answer", set: described(region), ways: ways(region), phi: phi)
    };
    Some(Question {
        id: "directions-without-end",
        question: text!("q.recession.question"),
        answer,
        show: None,
    })
}

/// The directions in which an unbounded set goes on, other than the plane.
fn ways(region: &Region) -> Message {
    let rays: Vec<Message> = region.rays().iter().map(direction).collect();
    let lines: Vec<Message> = region.lines().iter().map(direction).collect();
    match (rays.as_slice(), lines.as_slice()) {
        ([from, to], _) => text!("q.recession.between", from: from.clone(), to: to.clone()),
        ([ray], [line]) => text!("q.recession.half-plane", line: line.clone(), ray: ray.clone()),
        (_, [line]) => text!("q.recession.line", line: line.clone()),
        _ => text!("q.recession.along", rays: Value::listed(rays)),
    }
}

fn direction(direction: &Direction) -> Message {
    pair(&[direction.dx(), direction.dy()].map(Rational::from))
}
