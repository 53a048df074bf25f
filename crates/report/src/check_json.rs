//! The JSON report of a check, schema `boundfit/check/2`.

use boundfit_check::{Approximation, Check, Directions, JudgedAnswer, ProgramRows};
use boundfit_estimation::Measurements;
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_lp::{Judgement, Multiplier, PuiEnd, Refutation, RoundedTo, Verdict};

use crate::answer::check::{
    ApproximationJson, CheckInputJson, CheckJson, ClaimJson, ClaimedEndJson, DirectionsJson, EvidenceJson,
    ReadingsJson, RoundedToJson, WorstJson,
};
use crate::answer::parts::TermJson;
use crate::answer::table::TableJson;
use crate::input_json::from_least;
use crate::json::to_text;
use crate::style::Style;

/// The report as JSON, with a line end, about the readings of this file; `None` for standard input. `reading` is that of the data;
/// `worst` is against it.
pub fn check_json(
    check: &Check,
    measurements: &Measurements,
    file: Option<Foreign<&str>>,
    reading: Reading,
    style: &Style,
) -> String {
    let report = CheckJson {
        schema: CheckJson::SCHEMA,
        input: CheckInputJson {
            file,
            table: TableJson::of_measurements(measurements),
            epsilon_from_least: from_least(measurements, style),
        },
        tolerance: style.given_number(&check.tolerance),
        digits_as_printed: check.as_printed,
        readings: ReadingsJson { asked: check.readings.asked, fitted: check.readings.fitted },
        claims: check.answers.iter().map(|answer| claim(answer, &check.rows, style)).collect(),
        worst: worst(check, reading),
        worst_as_received: worst(check, Reading::Binary64).filter(|_| reading != Reading::Binary64),
        directions: check.directions.as_ref().map(|found| directions(found, style)),
    };
    to_text(&report)
}

fn worst(check: &Check, reading: Reading) -> Option<WorstJson> {
    let worst = check.worst(reading)?;
    Some(WorstJson { verdict: worst.name(), reading: reading.name(), refuted: worst.is_refutation() })
}

fn claim(answer: &JudgedAnswer, rows: &ProgramRows, style: &Style) -> ClaimJson {
    let bound_at = |end: PuiEnd| {
        let target = ["theta1", "theta2"][end.axis()];
        bound(target, end.end().name(), end.of(&answer.bounds), rows, style)
    };
    ClaimJson {
        source: answer.source.clone(),
        reading: answer.reading.name(),
        bounds: PuiEnd::ALL.map(bound_at).into(),
        verdict: answer.worst().name(),
    }
}

fn bound(
    target: &'static str,
    end: &'static str,
    judgement: &Judgement,
    rows: &ProgramRows,
    style: &Style,
) -> ClaimedEndJson {
    let number = |value: &Option<Rational>| value.as_ref().map(|value| style.number(value));
    let violated = judgement.violation.as_ref().map(|violation| {
        let TermJson { row, bound, multiplier } =
            TermJson::new(rows.name(violation.row), &violation.by, style);
        (row, bound, multiplier)
    });
    let (row, bound, violation) = match violated {
        Some((row, bound, by)) => (row, Some(bound), Some(by)),
        None => (None, None, None),
    };
    ClaimedEndJson {
        target,
        end,
        claimed: number(&judgement.claimed),
        verdict: judgement.verdict.name(),
        rounded_to: judgement.rounded_to.filter(|_| judgement.verdict == Verdict::Rounded).map(rounded_to),
        exact: judgement
            .exact
            .as_ref()
            .map(|exact| if end == "lower" { style.lower_number(exact) } else { style.upper_number(exact) }),
        excess: number(&judgement.excess),
        excess_in_ulps: number(&judgement.excess_in_ulps),
        excess_in_units: judgement.excess_in_units.as_ref().map(|(units, _)| style.number(units)),
        unit: judgement.excess_in_units.as_ref().map(|(_, unit)| unit.name()),
        tau: judgement.tau.as_ref().map(|tau| style.upper_number(tau)),
        tau_in_epsilon: judgement.tau_in_epsilon.as_ref().map(|tau| style.upper_number(tau)),
        row,
        bound,
        violation,
        witness: judgement.witness.as_ref().map(|theta| style.numbers(theta)),
        proof: judgement.proof.as_ref().map(|found| proof(found, rows, style)),
        repairable: judgement.repairable,
        reason: judgement.reason.clone(),
    }
}

fn rounded_to(to: RoundedTo) -> RoundedToJson {
    match to {
        RoundedTo::Binary64 => RoundedToJson { kind: "binary64", digits: None },
        RoundedTo::Digits(digits) => RoundedToJson { kind: "digits", digits: Some(digits) },
    }
}

fn proof(proof: &Refutation, rows: &ProgramRows, style: &Style) -> EvidenceJson {
    let terms = |multipliers: &[Multiplier]| {
        multipliers.iter().map(|m| TermJson::new(rows.name(m.row), &m.value, style)).collect()
    };
    let (shows, rows, theta, ray) = match proof {
        Refutation::Infeasible(multipliers) => ("infeasible", terms(multipliers), None, None),
        Refutation::Bound(multipliers) => ("bounded", terms(multipliers), None, None),
        Refutation::FeasiblePoint(theta) => ("feasible", Vec::new(), Some(theta), None),
        Refutation::Ray { theta, ray } => ("unbounded", Vec::new(), Some(theta), Some(ray)),
    };
    let pair = |pair: Option<&[Rational; 2]>| pair.map(|pair| style.numbers(pair));
    EvidenceJson { shows, rows, theta: pair(theta), ray: pair(ray) }
}

fn directions(found: &Directions, style: &Style) -> DirectionsJson {
    let approximation = |found: &Approximation| ApproximationJson {
        vertices: found.vertices.iter().map(|vertex| style.numbers(vertex)).collect(),
        area: found.area.as_ref().map(|area| style.number(area)),
    };
    DirectionsJson {
        count: found.count,
        scaled: found.is_scaled,
        unbounded: found.unbounded,
        inner: found.inner.as_ref().map(approximation),
        exact: approximation(&found.exact),
        outer: found.outer.as_ref().map(approximation),
    }
}
