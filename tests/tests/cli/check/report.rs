//! The reports of `check`: the JSON schema, the text, the comparison in many directions.

use boundfit_tests::cli::unbroken;
use boundfit_tests::lp_cases::{hard_cases, number};
use boundfit_tests::program::run_with_input;
use serde_json::Value;

use super::{NEAR_PARALLEL, STRIP, boundfit, report, verdicts};

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

/// `{"exact": "p/q", "decimal": "..."}`.
fn is_number(value: &Value) -> bool {
    (keys(value) == ["exact", "decimal", "value"] || keys(value) == ["exact", "decimal", "value", "outward"])
        && value["exact"].is_string()
        && value["decimal"].is_string()
        && or_null(&value["value"], Value::is_number)
}

fn or_null(value: &Value, check: impl Fn(&Value) -> bool) -> bool {
    value.is_null() || check(value)
}

fn is_pair(value: &Value) -> bool {
    value.as_array().is_some_and(|pair| pair.len() == 2 && pair.iter().all(is_number))
}

fn is_worst(worst: &Value) -> bool {
    let refuted = ["loose", "infeasible point", "unsafe", "inverted interval", "wrong status"];
    keys(worst) == ["verdict", "reading", "refuted"]
        && ["decimal", "binary64"].contains(&worst["reading"].as_str().unwrap())
        && worst["refuted"] == refuted.contains(&worst["verdict"].as_str().unwrap())
}

/// Checks every key of `boundfit/check/2`.
fn check_schema(found: &Value) {
    let expected = [
        "schema",
        "input",
        "tolerance",
        "digits_as_printed",
        "readings",
        "claims",
        "worst",
        "worst_as_received",
        "directions",
    ];
    assert_eq!(keys(found), expected);
    assert!(is_number(&found["tolerance"]) && found["digits_as_printed"].is_boolean());
    assert_eq!(found["schema"], "boundfit/check/2");
    assert_eq!(keys(&found["readings"]), ["asked", "fitted"]);
    for key in ["worst", "worst_as_received"] {
        assert!(or_null(&found[key], is_worst), "{key}: {found}");
    }
    for claim in found["claims"].as_array().unwrap() {
        assert_eq!(keys(claim), ["source", "reading", "bounds", "verdict"]);
        assert!(claim["source"].is_string() && claim["verdict"].is_string());
        assert!(["decimal", "binary64"].contains(&claim["reading"].as_str().unwrap()));
        let bounds = claim["bounds"].as_array().unwrap();
        let names: Vec<[&str; 2]> =
            bounds.iter().map(|bound| ["target", "end"].map(|key| bound[key].as_str().unwrap())).collect();
        assert_eq!(
            names,
            [["theta1", "lower"], ["theta1", "upper"], ["theta2", "lower"], ["theta2", "upper"]]
        );
        bounds.iter().for_each(check_bound);
        assert!(verdicts(claim).contains(&claim["verdict"].as_str().unwrap()));
    }
}

fn check_bound(bound: &Value) {
    let expected = [
        "target",
        "end",
        "claimed",
        "verdict",
        "rounded_to",
        "exact",
        "excess",
        "excess_in_ulps",
        "excess_in_units",
        "unit",
        "tau",
        "tau_in_epsilon",
        "row",
        "bound",
        "violation",
        "witness",
        "proof",
        "repairable",
        "reason",
    ];
    assert_eq!(keys(bound), expected);
    for key in [
        "claimed",
        "exact",
        "excess",
        "excess_in_ulps",
        "excess_in_units",
        "tau",
        "tau_in_epsilon",
        "violation",
    ] {
        assert!(or_null(&bound[key], is_number), "{key}: {bound}");
    }
    assert_eq!(bound["rounded_to"].is_object(), bound["verdict"] == "rounded", "{bound}");
    if bound["rounded_to"].is_object() {
        let to = &bound["rounded_to"];
        assert_eq!(keys(to), ["kind", "digits"]);
        assert_eq!(to["kind"], if to["digits"].is_u64() { "digits" } else { "binary64" }, "{bound}");
    }
    assert_eq!(bound["unit"].is_string(), bound["excess_in_units"].is_object(), "{bound}");
    assert!(or_null(&bound["unit"], |unit| ["width", "value", "eps"].contains(&unit.as_str().unwrap())));
    assert!(or_null(&bound["row"], Value::is_u64) && or_null(&bound["bound"], Value::is_string), "{bound}");
    assert_eq!(bound["bound"].is_null(), bound["violation"].is_null(), "{bound}");
    assert!(or_null(&bound["witness"], is_pair), "{bound}");
    assert!(or_null(&bound["repairable"], Value::is_boolean) && or_null(&bound["reason"], Value::is_string));
    assert_eq!(bound["proof"].is_object(), bound["verdict"] == "wrong status", "{bound}");
    if let Value::Object(_) = &bound["proof"] {
        let proof = &bound["proof"];
        assert_eq!(keys(proof), ["shows", "rows", "theta", "ray"]);
        assert!(or_null(&proof["theta"], is_pair) && or_null(&proof["ray"], is_pair), "{proof}");
        for row in proof["rows"].as_array().unwrap() {
            assert_eq!(keys(row), ["row", "bound", "multiplier"]);
            assert!(or_null(&row["row"], Value::is_u64) && row["bound"].is_string());
            assert!(is_number(&row["multiplier"]));
        }
    }
}

#[test]
fn every_report_follows_the_schema() {
    let mut sources = 0;
    for case in hard_cases() {
        let line = format!("check fixtures/hard-lp/{}.csv --x x --y y --eps {}", case.name, case.epsilon);
        let run = boundfit(&format!("{line} --format json"));
        let found: Value = serde_json::from_str(&run.stdout).unwrap();
        check_schema(&found);
        assert!(found["directions"].is_null());
        // The worst verdict and the exit status are about the data as read.
        let as_read =
            found["claims"].as_array().unwrap().iter().filter(|claim| claim["reading"] == "decimal");
        let as_read: Vec<&str> = as_read.map(|claim| claim["verdict"].as_str().unwrap()).collect();
        assert!(as_read.contains(&found["worst"]["verdict"].as_str().unwrap()));
        let fine = |verdict: &&str| ["exact", "rounded", "within tolerance", "no answer"].contains(verdict);
        assert_eq!(run.status, if as_read.iter().all(fine) { 0 } else { 4 }, "{}", case.name);
        sources += as_read.len();
        // The exact simplex is right everywhere.
        let exact = report(&format!("{line} --solver exact-simplex"), 0);
        assert_eq!(
            (exact["claims"].as_array().unwrap().len(), &exact["worst"]["verdict"]),
            (1, &"exact".into())
        );
    }
    assert_eq!(sources, 12 * boundfit_check::source_names().len());
    for line in [
        format!("{STRIP} --claim-pui 0,1,2,3 --directions 4"),
        format!("{NEAR_PARALLEL} --where 'theta1 >= 0.1' --claim-pui 0,1,2,3"),
        format!("{STRIP} --where 'theta1 >= 3' --where 'theta1 <= 2' --claim-pui 0,1,2,3"),
    ] {
        check_schema(&report(&line, 4));
    }
}

#[test]
fn one_reading_or_both() {
    let claim = "--claim fixtures/claims/near-parallel-exact.json";
    let readings = |line: &str, status: i32| -> Vec<String> {
        let found = report(line, status);
        check_schema(&found);
        let claims = found["claims"].as_array().unwrap();
        claims.iter().map(|claim| claim["reading"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(readings(&format!("{NEAR_PARALLEL} {claim}"), 0), ["decimal", "binary64"]);
    // Exact for the data as written is not exact for the doubles.
    assert_eq!(readings(&format!("{NEAR_PARALLEL} {claim} --reading binary64"), 0), ["binary64"]);
    let found = report(&format!("{NEAR_PARALLEL} {claim}"), 0);
    assert_eq!(found["worst"].to_string(), r#"{"verdict":"exact","reading":"decimal","refuted":false}"#);
    let as_received = r#"{"verdict":"within tolerance","reading":"binary64","refuted":false}"#;
    assert_eq!(found["worst_as_received"].to_string(), as_received);
    let text = boundfit(&format!("{NEAR_PARALLEL} {claim}")).stdout;
    let expected = "Worst verdict: exact The data as written (decimal) decide this and the exit status; against the \
                    doubles that a solver receives (binary64) the worst is: within tolerance.";
    assert!(unbroken(&text).contains(expected), "{text}");
    let doubles = report(&format!("{NEAR_PARALLEL} {claim} --reading binary64"), 0);
    assert_eq!(doubles["worst"].to_string(), as_received);
    assert!(doubles["worst_as_received"].is_null());
    let text = boundfit(&format!("{NEAR_PARALLEL} {claim} --reading binary64")).stdout;
    let expected = "The data as doubles (binary64) decide this and the exit status.";
    assert!(unbroken(&text).contains(expected), "{text}");
    // Where every number is a double, there is nothing else to judge against.
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("whole.csv"), "x,y\n1,2\n2,3\n3,5\n").unwrap();
    let whole =
        format!("check {}/whole.csv --x x --y y --eps 1 --claim-pui 0,1,2,3", folder.path().display());
    assert_eq!(readings(&whole, 4), ["decimal"]);
    // The exact simplex gets the exact rows: the doubles are no excuse.
    assert_eq!(readings(&format!("{NEAR_PARALLEL} --solver exact-simplex"), 0), ["decimal"]);
    assert_eq!(
        readings(&format!("{NEAR_PARALLEL} --solver exact-simplex --reading binary64"), 0),
        ["binary64"]
    );
}

#[test]
fn the_set_seen_from_many_directions() {
    let found = report(&format!("{NEAR_PARALLEL} --directions 16"), 0);
    check_schema(&found);
    assert!(found["claims"].as_array().unwrap().is_empty() && found["worst"].is_null());
    let seen = &found["directions"];
    assert_eq!(keys(seen), ["count", "scaled", "unbounded", "inner", "exact", "outer"]);
    assert_eq!((&seen["count"], &seen["unbounded"]), (&16.into(), &0.into()));
    let area = |name: &str| {
        assert_eq!(keys(&seen[name]), ["vertices", "area"]);
        assert!(
            seen[name]["vertices"].as_array().unwrap().iter().all(is_pair) && is_number(&seen[name]["area"])
        );
        number(seen[name]["area"]["exact"].as_str().unwrap())
    };
    assert!(area("inner") <= area("exact") && area("exact") <= area("outer"));
    assert_eq!(area("exact"), number("1/300000000"));
    let vertices = |name: &str| seen[name]["vertices"].as_array().unwrap().clone();
    assert!(vertices("inner").iter().all(|vertex| vertices("exact").contains(vertex)));
    let scaled = report(&format!("{NEAR_PARALLEL} --directions 16 --scaled"), 0);
    assert_eq!([&seen["scaled"], &scaled["directions"]["scaled"]], [false, true]);
    assert_ne!(scaled["directions"]["outer"], seen["outer"]);
    // Sixteen is the default.
    assert_eq!(report(&format!("{NEAR_PARALLEL} --directions"), 0), found);

    let text = boundfit(&format!("{NEAR_PARALLEL} --directions 16")).stdout;
    for part in [
        "The set seen from 16 directions\n",
        "inner: hull of the optimisers",
        "the set itself                 4         3.3333e-9\n",
        "outer: supporting half-planes",
        "The directions are spread evenly in the plane of theta1 and theta2.\n",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let strip = report(&format!("{STRIP} --directions 8"), 0);
    assert_eq!(strip["directions"]["unbounded"], 8);
    assert!(strip["directions"]["exact"]["area"].is_null());
    let strip = boundfit(&format!("{STRIP} --directions 8")).stdout;
    assert!(strip.contains("The set seen from 8 directions, 8 of them unbounded\n"), "{strip}");
    let empty = "check fixtures/hard-lp/empty-by-1e-9.csv --x x --y y --eps 0.373923265 --directions 5";
    let empty = report(empty, 0);
    assert!(empty["directions"]["inner"].is_null() && empty["directions"]["outer"].is_null());
}

#[test]
fn text_names_the_row_and_the_reason() {
    let point = r#"{"source": "me", "points": [[0, "2.00000005"], null, null, null]}"#;
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("claim.json"), point).unwrap();
    let run = boundfit(&format!("{NEAR_PARALLEL} --claim {}/claim.json", folder.path().display()));
    assert_eq!(run.status, 4);
    let expected = [
        "LP answers about fixtures/claims/near-parallel.csv, judged exactly\n",
        "me, decimal: theta1 min: infeasible point: too wide by 1 of the width (0.066667, 4.9e15 ulp); \
         the point exceeds 1 upper by 1: it needs eps + 1 (2e7 of eps)\n",
        "me, decimal: theta1 max: no answer: no point given\n",
        "\nWorst verdict: infeasible point; refuted\n",
    ];
    for part in expected {
        assert!(unbroken(&run.stdout).contains(part.trim()), "{part}: {}", run.stdout);
    }
}

/// The text of a check of these readings at an error bound, in single blanks.
fn checked(table: &str, epsilon: &str, options: &[&str]) -> String {
    let words = [&["check", "-", "--x", "x", "--y", "y", "--eps", epsilon], options].concat();
    unbroken(&run_with_input(&words, table.as_bytes()).stdout)
}

/// (1.0000, 1.0000) is feasible, too, and within what is claimed.
#[test]
fn a_witness_lies_beyond_the_claim_as_printed() {
    let claim = ["--claim-pui", "0.999999999,1.000000001,0.9999999999,1.0000000001"];
    let text = checked("x,y\n0,1\n1,2\n2,3\n", "1e-9", &claim);
    for (end, point) in [("min", "(1.00000000, 0.999999999)"), ("max", "(1, 1.000000001)")] {
        let verdict = format!("claimed PUI, decimal: theta2 {end}: unsafe: cuts off 0.45 of the width");
        let (_, found) = text.split_once(&verdict).unwrap();
        let (_, found) = found.split_once("; ").unwrap();
        assert!(found.starts_with(&format!("{point} is feasible")), "{text}");
    }
}

#[test]
fn equal_claims_look_equal_and_crossed_ones_crossed() {
    // Rounded outward, one number would be two.
    let two = "x,y\n0,0\n1,3\n";
    let text = checked(two, "0", &["--claim-pui", "3.0000000000000004,3.0000000000000004,0,0"]);
    let expected =
        "claimed PUI decimal 3.0000 rounded 3.0000 rounded 0 exact 0 exact true ends decimal 3 3 0 0 ";
    assert!(text.contains(expected), "{text}");
    // Rounded outward, the lower end would lie below the upper one.
    let crossed = "3,3,-6.938893903907226e-17,-6.938893903907238e-17";
    let text = checked(two, "0", &["--claim-pui", crossed, "--digits-as-printed", "off"]);
    let expected = "theta2 min -6.938893903907226e-17 inverted interval \
                    theta2 max -6.938893903907238e-17 inverted interval source true ends ";
    assert!(text.contains(expected), "{text}");
    // A claim of one number is told from both ends of an interval.
    let text = checked(two, "1e-7", &["--claim-pui", "3.0000001,3.0000001,0,0"]);
    let expected = "claimed PUI decimal 3.0000001 3.0000001 0 unsafe 0 unsafe unsafe unsafe \
                    true ends decimal 2.9999998 3.0000002 -1e-7 1e-7 ";
    assert!(text.contains(expected), "{text}");
}

#[test]
fn ends_that_do_not_exist_say_why() {
    let text = checked("x,y\n0,0\n1,3\n2,7\n", "0", &["--solver", "exact-simplex"]);
    let expected = "exact-simplex decimal empty set empty set empty set empty set exact exact exact exact \
                    true ends decimal empty set empty set empty set empty set ";
    assert!(text.contains(expected), "{text}");
    let text = checked("x,y\n1,3\n", "1", &["--where", "theta1 >= 0", "--solver", "exact-simplex"]);
    let expected = "exact-simplex decimal 0 exact unbounded unbounded 4 exact exact exact \
                    true ends decimal 0 unbounded unbounded 4 ";
    assert!(text.contains(expected), "{text}");
}
