//! The JSON report of a check, schema `boundfit/check/2`.

use boundfit_check::{Approximation, Check, Directions, JudgedAnswer, ProgramRows};
use boundfit_estimation::Measurements;
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_lp::{Judgement, Multiplier, PuiEnd, Refutation, RoundedTo, Verdict};
use serde::Serialize;

use crate::json::{TermJson, to_text};
use crate::number::Number;
use crate::style::Style;
use crate::table_json::TableJson;

#[derive(Serialize)]
struct CheckJson<'a> {
    schema: &'static str,
    input: InputJson<'a>,
    tolerance: Number,
    digits_as_printed: bool,
    readings: ReadingsJson,
    claims: Vec<ClaimJson>,
    worst: Option<WorstJson>,
    worst_as_received: Option<WorstJson>,
    directions: Option<DirectionsJson>,
}

/// How many readings the programs are about, and how many are fitted.
#[derive(Serialize)]
struct ReadingsJson {
    asked: usize,
    fitted: usize,
}

/// What the answers are about.
#[derive(Serialize)]
struct InputJson<'a> {
    file: Option<Foreign<&'a str>>,
    table: Option<TableJson>,
}

/// The worst verdict against one reading of the data.
#[derive(Serialize)]
struct WorstJson {
    verdict: &'static str,
    reading: &'static str,
    refuted: bool,
}

#[derive(Serialize)]
struct ClaimJson {
    source: Foreign,
    reading: &'static str,
    bounds: Vec<EndJson>,
    verdict: &'static str,
}

#[derive(Serialize)]
struct EndJson {
    target: &'static str,
    end: &'static str,
    claimed: Option<Number>,
    verdict: &'static str,
    rounded_to: Option<RoundedToJson>,
    exact: Option<Number>,
    excess: Option<Number>,
    excess_in_ulps: Option<Number>,
    excess_in_units: Option<Number>,
    unit: Option<&'static str>,
    tau: Option<Number>,
    tau_in_epsilon: Option<Number>,
    row: Option<usize>,
    bound: Option<String>,
    violation: Option<Number>,
    witness: Option<[Number; 2]>,
    proof: Option<EvidenceJson>,
    repairable: Option<bool>,
    reason: Option<String>,
}

/// Which rounding explains a rounded claim: `binary64`, or `digits` with their number.
#[derive(Serialize)]
struct RoundedToJson {
    kind: &'static str,
    digits: Option<usize>,
}

#[derive(Serialize)]
struct EvidenceJson {
    shows: &'static str,
    rows: Vec<TermJson>,
    theta: Option<[Number; 2]>,
    ray: Option<[Number; 2]>,
}

#[derive(Serialize)]
struct DirectionsJson {
    count: usize,
    scaled: bool,
    unbounded: usize,
    inner: Option<ApproximationJson>,
    exact: ApproximationJson,
    outer: Option<ApproximationJson>,
}

#[derive(Serialize)]
struct ApproximationJson {
    vertices: Vec<[Number; 2]>,
    area: Option<Number>,
}

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
        schema: "boundfit/check/2",
        input: InputJson { file, table: TableJson::of_measurements(measurements) },
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
) -> EndJson {
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
    EndJson {
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
