//! `boundfit verify`.

use boundfit_check::nested_beyond;
use boundfit_exact::Limit;
use boundfit_report::{verify_json, verify_text};
use boundfit_verify::{Falsehood, Proof};
use serde_json::Value;
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
    let format = file.format(*format)?;
    if proof_file == "-" && data_file == "-" {
        return Err(Failure::Usage("the proof and the data cannot both be standard input".to_owned()));
    }
    let guard = file.replace.guard([proof_file.as_str(), data_file]);
    guard.check(file.output.as_deref())?;
    let text = read_proof(proof_file, limits, *max_proof_size)?;
    let not_a_proof = |problem: &dyn std::fmt::Display| {
        Failure::data(format_args!(
            "{}: not a proof: {problem} (expected JSON of schema boundfit/proof/1)",
            named(proof_file)
        ))
    };
    let value: Value = serde_json::from_str(&text).map_err(|error| not_a_proof(&error))?;
    if value.get("schema").and_then(Value::as_str) != Some("boundfit/proof/1") {
        return Err(not_a_proof(&"another schema"));
    }
    let proof: Proof = serde_json::from_str(&text).map_err(|error| not_a_proof(&error))?;
    let data = read_bytes(data_file)?;
    let verdict = while_working("verifying", || {
        let hash: String = Sha256::digest(&data).iter().map(|byte| format!("{byte:02x}")).collect();
        proof.verify(&data, &hash, &limits.number())
    });
    // A number beyond the limits is refused, which says nothing of the proof.
    if let Err(falsehood @ Falsehood::BeyondLimit { error, .. }) = &verdict
        && let Some(limit) = Limit::of_number(&error.kind)
    {
        let (data, flag) = (named(data_file), limit.flag());
        return Err(Failure::data(format_args!("{data}: {falsehood}; {flag} raises it")));
    }
    let report = match format {
        Format::Text => verify_text(&verdict, named(proof_file), named(data_file)),
        Format::Json => verify_json(&verdict),
    };
    output::write(&report, file.output.as_deref(), &guard)?;
    Ok(if verdict.is_ok() { Exit::Answer } else { Exit::Refuted })
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
