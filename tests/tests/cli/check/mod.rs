//! `boundfit check` and what it has in common with `fit`, started as a user would start them.

mod claims;
mod commands;
mod proportion;
mod refusals;
mod report;
mod solutions;

use boundfit_tests::program::{Run, run};
use serde_json::Value;

/// The readings on which HiGHS reports θ1 in [0.05, 0.15].
pub const NEAR_PARALLEL: &str = "check fixtures/claims/near-parallel.csv --x x --y y --eps 5e-8";

/// Three readings at one x: nothing is bounded.
pub const STRIP: &str = "check fixtures/claims/strip.csv --x x --y y --eps 0.2";

/// Runs the program with the words of a line; what stands between single quotes is one word.
pub fn boundfit(line: &str) -> Run {
    let mut words: Vec<String> = Vec::new();
    for (index, part) in line.split('\'').enumerate() {
        if index % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(ToOwned::to_owned));
        }
    }
    run(&words.iter().map(String::as_str).collect::<Vec<_>>())
}

/// The JSON report of a line that must end with this status.
pub fn report(line: &str, status: i32) -> Value {
    let run = boundfit(&format!("{line} --format json"));
    assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{line}: {run:?}");
    serde_json::from_str(&run.stdout).unwrap()
}

/// The verdicts of one claim in order: minimum and maximum of θ1, then of θ2.
pub fn verdicts(claim: &Value) -> Vec<&str> {
    claim["bounds"].as_array().unwrap().iter().map(|bound| bound["verdict"].as_str().unwrap()).collect()
}
