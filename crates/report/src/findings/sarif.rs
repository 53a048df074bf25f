//! Findings about solutions as SARIF, which code hosts show beside the files.
//!
//! Source: OASIS, "Static Analysis Results Interchange Format (SARIF) Version 2.1.0".

use boundfit_exact::Foreign;
use boundfit_judge::{Aspect, Finding, JudgedSolution, Worth};
use boundfit_lp::Model;
use serde_json::{Value, json};

use super::sentence::sentence;
use crate::json::to_text;

/// The findings as SARIF 2.1.0, with a line end: a rule for each aspect, a result for each finding at its line. A
/// refuted aspect is an error, a missing answer a warning; every other aspect passed.
pub fn solutions_sarif(model: &Model, solutions: &[JudgedSolution]) -> String {
    let rules: Vec<Value> = Aspect::ALL.iter().map(|aspect| rule(*aspect)).collect();
    let results = solutions.iter().flat_map(|judged| {
        judged.findings.findings.iter().map(|finding| result(model, &judged.file, finding))
    });
    to_text(&json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": {"driver": {
                "name": "boundfit",
                "version": env!("CARGO_PKG_VERSION"),
                "rules": rules,
            }},
            "results": results.collect::<Vec<_>>(),
        }],
    }))
}

fn rule(aspect: Aspect) -> Value {
    json!({
        "id": aspect.name(),
        "shortDescription": {"text": format!("Whether {}.", aspect.question())},
        "defaultConfiguration": {"level": "error"},
    })
}

fn result(model: &Model, file: &Foreign, finding: &Finding) -> Value {
    // A level other than "none" is for what failed.
    let (kind, level) = match finding.worth {
        Worth::Refuted => ("fail", "error"),
        Worth::NoAnswer => ("fail", "warning"),
        _ => ("pass", "none"),
    };
    let index = Aspect::ALL.iter().position(|aspect| *aspect == finding.aspect);
    json!({
        "ruleId": finding.aspect.name(),
        "ruleIndex": index,
        "kind": kind,
        "level": level,
        "message": {"text": format!("{}: {}.", finding.worth.name(), sentence(model, finding))},
        "locations": [{"physicalLocation": {
            "artifactLocation": {"uri": uri(file.raw())},
            "region": {"startLine": finding.line.max(1)},
        }}],
    })
}

/// A path as a reference: what may not stand in one is written as `%` and two digits.
fn uri(path: &str) -> String {
    let mut uri = String::new();
    for byte in path.replace('\\', "/").bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => {
                uri.push(char::from(byte));
            }
            other => uri.push_str(&format!("%{other:02X}")),
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_references() {
        assert_eq!(uri("out/a b:ü.sol"), "out/a%20b%3A%C3%BC.sol");
        assert_eq!(uri("C\\x.sol"), "C/x.sol");
    }
}
