//! `boundfit verify`.

#![allow(clippy::indexing_slicing, reason = "a part of a JSON value that is not there is null")]

use std::fs::File;
use std::io::{self, Read};

use boundfit_exact::{Limits, Rational, Reading, Rounding};
use boundfit_verify::{Falsehood, Proof};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::CommandResult;
use crate::arguments::{Format, LimitArguments, VerifyArguments};
use crate::exit::{Exit, Failure};
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
    let mut data = Vec::new();
    open(data_file)?.read_to_end(&mut data).map_err(|error| cannot_read(data_file, &error))?;
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

/// The file in the words of messages.
fn named(file: &str) -> &str {
    if file == "-" { "standard input" } else { file }
}

fn cannot_read(file: &str, error: &io::Error) -> Failure {
    Failure::data(format_args!("{}: cannot read: {error}", named(file)))
}

fn open(file: &str) -> Result<Box<dyn Read>, Failure> {
    if file == "-" {
        return Ok(Box::new(io::stdin()));
    }
    Ok(Box::new(File::open(file).map_err(|error| cannot_read(file, &error))?))
}

/// The text of a proof that keeps to the limits.
fn read_proof(file: &str, limits: &LimitArguments, largest: u64) -> Result<String, Failure> {
    let refuse = |what: String| Failure::data(format_args!("{}: not a proof: refused: {what}", named(file)));
    let mut text = String::new();
    let read = open(file)?.take(largest.saturating_add(1)).read_to_string(&mut text);
    read.map_err(|error| cannot_read(file, &error))?;
    if text.len() as u64 > largest {
        return Err(refuse(format!("larger than {largest} bytes (the limit; --max-proof-size raises it)")));
    }
    let extent = Extent::of(&text);
    let (nesting, digits) = (limits.sizes().nesting, limits.number().digits);
    if extent.nesting > nesting {
        return Err(refuse(format!(
            "nested deeper than {nesting} levels (the limit; --max-nesting raises it)"
        )));
    }
    // Its numbers are computed from several numbers of the data.
    let digits = digits.saturating_mul(10);
    if extent.digits > digits {
        return Err(refuse(format!(
            "a number with more than {digits} digits (10 times the limit; --max-digits raises it)"
        )));
    }
    Ok(text)
}

/// What a JSON text asks for.
#[derive(Default)]
struct Extent {
    /// How deep its arrays and objects are nested.
    nesting: usize,
    /// The most digits in a row.
    digits: usize,
}

impl Extent {
    fn of(text: &str) -> Self {
        let mut extent = Extent::default();
        let (mut depth, mut digits, mut in_string, mut escaped) = (0_usize, 0, false, false);
        for byte in text.bytes() {
            digits = if byte.is_ascii_digit() { digits + 1 } else { 0 };
            extent.digits = extent.digits.max(digits);
            match byte {
                _ if escaped => escaped = false,
                b'\\' => escaped = in_string,
                b'"' => in_string = !in_string,
                b'[' | b'{' if !in_string => depth += 1,
                b']' | b'}' if !in_string => depth = depth.saturating_sub(1),
                _ => {}
            }
            extent.nesting = extent.nesting.max(depth);
        }
        extent
    }
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
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let kind = match value["vertices"].as_array().map_or(0, Vec::len) {
        count @ 3.. => format!("{} with {count} vertices", text(&value["kind"])),
        _ => text(&value["kind"]),
    };
    let rows = &value["rows"];
    let mut report = format!(
        "verified: {proof} is true of {data}\n  set     {kind}\n  from    {half_planes} half-planes, rows {} to {}\n",
        rows[0], rows[1]
    );
    let bounds = value["bounds"].as_array().map(Vec::as_slice).unwrap_or_default();
    for (parameter, pair) in ["theta1", "theta2"].into_iter().zip(bounds.chunks_exact(2)) {
        let [lower, upper] = pair else { continue };
        let (lower, upper) = (end(lower, Rounding::Down, "-inf"), end(upper, Rounding::Up, "inf"));
        report += &format!("  {parameter}  [{lower}, {upper}]\n");
    }
    report
}

/// An end of an interval as a decimal, rounded outward.
fn end(bound: &Value, rounding: Rounding, unbounded: &str) -> String {
    const DIGITS: usize = 5;
    let Some(value) = bound["value"].as_str() else { return unbounded.to_owned() };
    let limits = Limits { digits: value.len(), exponent: 0 };
    let number: Option<Rational> = Reading::Decimal.read(value, &limits).ok();
    number.map_or_else(|| value.to_owned(), |number| number.to_decimal(DIGITS, rounding))
}
