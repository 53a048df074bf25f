//! `boundfit verify`.

#![allow(clippy::indexing_slicing, reason = "a part of a JSON value that is not there is null")]

use boundfit_check::nested_beyond;
use boundfit_exact::{Limits, Rational, Reading, Rounding};
use boundfit_verify::{Falsehood, Proof};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::CommandResult;
use crate::arguments::{Format, LimitArguments, VerifyArguments};
use crate::exit::{Exit, Failure};
use crate::input::{named, read_bytes, read_text};
use crate::output;
use crate::progress::while_working;

/// Reads the proof and the data, checks one against the other and writes the verdict.
pub(crate) fn run(arguments: &VerifyArguments) -> CommandResult {
    let VerifyArguments { proof: proof_file, data: data_file, format, limits, max_proof_size, file } =
        arguments;
    if proof_file == "-" && data_file == "-" {
        return Err(Failure::Usage("the proof and the data cannot both be standard input".to_owned()));
    }
    let text = read_proof(proof_file, limits, *max_proof_size)?;
    let not_a_proof = |problem: &dyn std::fmt::Display| {
        Failure::data(format_args!(
            "{}: not a proof: {problem} (expected JSON of schema boundfit/proof/1)",
            named(proof_file)
        ))
    };
    let value: Value = serde_json::from_str(&text).map_err(|error| not_a_proof(&error))?;
    if value["schema"] != "boundfit/proof/1" {
        return Err(not_a_proof(&"another schema"));
    }
    let proof: Proof = serde_json::from_str(&text).map_err(|error| not_a_proof(&error))?;
    let data = read_bytes(data_file)?;
    let verdict = while_working("verifying", || {
        let hash: String = Sha256::digest(&data).iter().map(|byte| format!("{byte:02x}")).collect();
        proof.verify(&data, &hash, &limits.number())
    });
    // A number beyond the limits is refused, which says nothing of the proof.
    if let Err(problem) = &verdict
        && let Some(flag) = limit(problem)
    {
        return Err(Failure::data(format_args!("{}: {problem}; {flag} raises it", named(data_file))));
    }
    let report = match format {
        Format::Text => text_report(&verdict, named(proof_file), named(data_file), &value),
        Format::Json => json_report(&verdict),
    };
    output::write(&report, file.output.as_deref())?;
    Ok(if verdict.is_ok() { Exit::Answer } else { Exit::Refuted })
}

/// The option that lets a number of the data pass, when such a number is the problem.
fn limit(problem: &Falsehood) -> Option<&'static str> {
    if !problem.starts_with("row ") || !problem.contains("(the limit)") {
        return None;
    }
    Some(if problem.contains("exponent beyond") { "--max-exponent" } else { "--max-digits" })
}

/// The text of a proof that keeps to the limits.
fn read_proof(file: &str, limits: &LimitArguments, largest: u64) -> Result<String, Failure> {
    let refuse = |what: String| Failure::data(format_args!("{}: not a proof: refused: {what}", named(file)));
    let text = read_text(file, largest, "--max-proof-size")?;
    let (nesting, digits) = (limits.sizes().nesting, limits.number().digits);
    if let Some((line, column)) = nested_beyond(&text, nesting) {
        return Err(refuse(format!(
            "nested deeper than {nesting} levels (the limit; --max-nesting raises it) at line {line} column {column}"
        )));
    }
    // Its numbers are computed from several numbers of the data.
    let digits = digits.saturating_mul(10);
    if text.split(|character: char| !character.is_ascii_digit()).any(|run| run.len() > digits) {
        return Err(refuse(format!(
            "a number with more than {digits} digits (10 times the limit; --max-digits raises it)"
        )));
    }
    Ok(text)
}

fn json_report(verdict: &Result<usize, Falsehood>) -> String {
    let (half_planes, falsehood) = match verdict {
        Ok(half_planes) => (Some(half_planes), None),
        Err(statement) => (None, Some(statement)),
    };
    let report = json!({
        "schema": "boundfit/verify/1",
        "verified": verdict.is_ok(),
        "half_planes": half_planes,
        "falsehood": falsehood,
    });
    format!("{report:#}\n")
}

/// The verdict, and what a true proof proves.
fn text_report(verdict: &Result<usize, Falsehood>, proof: &str, data: &str, value: &Value) -> String {
    let half_planes = match verdict {
        Ok(half_planes) => half_planes,
        Err(statement) => return format!("refuted: {proof} is not true of {data}\n  {statement}\n"),
    };
    let list = |name: &str| value[name].as_array().map(Vec::as_slice).unwrap_or_default();
    let (vertices, sides) = (list("vertices").len(), list("sides"));
    let count = |count, one: &str, more: &str| format!("{count} {}", if count == 1 { one } else { more });
    let set = if list("farkas").is_empty() {
        let is_bounded = !sides.is_empty() && sides.iter().all(|side| side[1].is_number());
        let extent = if is_bounded { "bounded" } else { "unbounded" };
        let (vertices, sides) = (count(vertices, "vertex", "vertices"), count(sides.len(), "side", "sides"));
        format!("{extent}, with {vertices} and {sides}")
    } else {
        "empty".to_owned()
    };
    let rows = &value["rows"];
    let mut report = format!(
        "verified: {proof} is true of {data}\n  set     {set}\n  from    {half_planes} half-planes, rows {} to {}\n",
        rows[0], rows[1]
    );
    for (parameter, pair) in list("bounds").chunks_exact(2).enumerate() {
        let [lower, upper] = pair else { continue };
        let lower = end(lower, parameter, Rounding::Down, "-inf");
        let upper = end(upper, parameter, Rounding::Up, "inf");
        report += &format!("  theta{}  [{lower}, {upper}]\n", parameter + 1);
    }
    report
}

/// An end of an interval as a decimal, rounded outward: that of the point, unless there are no multipliers.
fn end(bound: &Value, parameter: usize, rounding: Rounding, unbounded: &str) -> String {
    const DIGITS: usize = 5;
    let value = bound[1][parameter].as_str().filter(|_| bound[0] != json!([]));
    let Some(value) = value else { return unbounded.to_owned() };
    let limits = Limits { digits: value.len(), exponent: 0 };
    let number: Option<Rational> = Reading::Decimal.read(value, &limits).ok();
    number.map_or_else(|| value.to_owned(), |number| number.to_decimal(DIGITS, rounding))
}
