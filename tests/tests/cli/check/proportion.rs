//! The deviations that are excused and those that are not: the printed digits, and the tolerance.

use serde_json::Value;

use super::{NEAR_PARALLEL, STRIP, boundfit, report, verdicts};
use boundfit_tests::cli::unbroken;

const TRANSDUCER: &str = "check fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3";

/// The claim in the help of the command, and in the paper.
const PUBLISHED: &str = "--claim-pui 1.7909e-3,1.8484e-3,2.2596e-2,2.2807e-2";

#[test]
fn the_published_figures_pass_as_printed() {
    let found = report(&format!("{TRANSDUCER} {PUBLISHED}"), 0);
    for bound in found["claims"][0]["bounds"].as_array().unwrap() {
        assert_eq!(bound["verdict"], "rounded");
        assert_eq!(bound["rounded_to"].to_string(), r#"{"kind":"digits","digits":5}"#);
    }
    let text = boundfit(&format!("{TRANSDUCER} {PUBLISHED}"));
    assert_eq!(text.status, 0);
    let expected =
        "claimed PUI, decimal: all four ends: rounded to 5 digits: right to 0.0020 of the width, 1.2e11 ulp";
    assert!(unbroken(&text.stdout).contains(expected), "{}", text.stdout);
    // They pass strictly, too: what is rounding is no error.
    assert_eq!(report(&format!("{TRANSDUCER} {PUBLISHED} --strict"), 0)["worst"]["verdict"], "rounded");
    // A unit of the last digit is not half of one.
    let off = "--claim-pui 1.7910e-3,1.8484e-3,2.2596e-2,2.2807e-2";
    assert_eq!(verdicts(&report(&format!("{TRANSDUCER} {off}"), 4)["claims"][0])[0], "unsafe");
    let off = "--claim-pui 1.7908e-3,1.8484e-3,2.2596e-2,2.2807e-2";
    assert_eq!(verdicts(&report(&format!("{TRANSDUCER} {off}"), 4)["claims"][0])[0], "loose");
}

#[test]
fn digits_may_be_taken_to_be_exact() {
    let found = report(&format!("{TRANSDUCER} {PUBLISHED} --digits-as-printed off"), 4);
    assert_eq!(found["digits_as_printed"], false);
    assert_eq!(verdicts(&found["claims"][0]), ["unsafe", "loose", "unsafe", "unsafe"]);
    let on = report(&format!("{TRANSDUCER} {PUBLISHED} --digits-as-printed on"), 0);
    assert_eq!(on, report(&format!("{TRANSDUCER} {PUBLISHED}"), 0));
    // Short numbers, whole ones and fractions are exact anyway.
    for ends in ["0.07,0.13,-132,-66", "1/14,2/16,-132,-66"] {
        let line = format!("{NEAR_PARALLEL} --claim-pui {ends}");
        assert_eq!(verdicts(&report(&line, 4)["claims"][0]), ["unsafe"; 4], "{ends}");
    }
    // Doubles have no digits: 0.0667 as a JSON number is off, as a text it is rounded.
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("claim.json");
    for (word, verdict, status) in [("0.0667", "unsafe", 4), ("\"0.0667\"", "rounded", 0)] {
        let claim = format!(
            "{{\"pui\": [[{word}, \"2/15\"], [\"-7940000011/60000000\", \"-3940000001/60000000\"]]}}"
        );
        std::fs::write(&file, claim).unwrap();
        let found = report(&format!("{NEAR_PARALLEL} --claim {}", file.display()), status);
        assert_eq!(verdicts(&found["claims"][0])[0], verdict, "{word}");
    }
}

#[test]
fn the_tolerance_holds_on_either_side_unless_it_is_strict() {
    // The interval of θ1 is [1/15, 2/15]: off by 5e-7 and by 2e-6 of its width, inside and outside.
    let line = |lower: &str, options: &str| {
        format!(
            "{NEAR_PARALLEL} {options} --claim-pui {lower},2/15,-7940000011/60000000,-3940000001/60000000"
        )
    };
    for (lower, verdict, strict) in [
        ("1/15", "exact", "exact"),
        ("20000001/300000000", "within tolerance", "unsafe"),
        ("19999999/300000000", "within tolerance", "loose"),
        ("10000001/150000000", "within tolerance", "unsafe"),
        ("500001/7500000", "unsafe", "unsafe"),
        ("499999/7500000", "loose", "loose"),
    ] {
        let first = |options: &str, verdict: &str| {
            let status = if ["unsafe", "loose"].contains(&verdict) { 4 } else { 0 };
            let found = report(&line(lower, options), status);
            assert_eq!(verdicts(&found["claims"][0])[0], verdict, "{lower} {options}");
        };
        first("", verdict);
        first("--strict", strict);
        first("--tolerance 0", strict);
    }
    // The direction is said, and claim and truth look different.
    let text = boundfit(&line("20000001/300000000", ""));
    let expected = "within tolerance: cuts off 5e-8 of the width (3.3334e-9, 2.5e8 ulp)";
    assert!(unbroken(&text.stdout).contains(expected), "{}", text.stdout);
    for number in ["0.06666667 ", "0.066666666 "] {
        assert!(text.stdout.contains(number), "{number}: {}", text.stdout);
    }
    let text = boundfit(&line("19999999/300000000", ""));
    assert!(unbroken(&text.stdout).contains("within tolerance: too wide by 5e-8 of the width"));
}

#[test]
fn points_are_measured_beside_a_wrong_status() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("claim.json");
    let bound = |line: &str, claim: &str| -> Value {
        std::fs::write(&file, claim).unwrap();
        report(&format!("{line} --claim {}", file.display()), 4)["claims"][0]["bounds"][0].clone()
    };
    // Nothing is bounded, and the point is 1 outside of a reading with the error bound 0.2.
    let points = r#"{"points": [["1000", "0"], ["1000", "0"], null, null]}"#;
    let found = bound(STRIP, points);
    assert_eq!((&found["verdict"], found["tau"].is_object()), (&"wrong status".into(), true));
    assert!(found["violation"].is_object() && found["row"].is_u64() && found["tau_in_epsilon"].is_object());
    let status = r#"{"status": "infeasible", "points": [["1000", "0"], null, null, null]}"#;
    let found = bound(STRIP, status);
    assert_eq!((&found["verdict"], found["tau"].is_object()), (&"wrong status".into(), true));
    assert_eq!(found["proof"]["shows"], "feasible");
}

#[test]
fn options_that_contradict_each_other() {
    let refused = |options: &str, part: &str| {
        let run = boundfit(&format!("{TRANSDUCER} {PUBLISHED} {options}"));
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{options}");
        assert!(run.stderr.contains(part), "{options}: {}", run.stderr);
    };
    refused("--strict --tolerance 1e-3", "'--strict' cannot be used with '--tolerance <NUM>'");
    refused("--digits-as-printed maybe", "invalid value 'maybe' for '--digits-as-printed <on|off>'");
}
