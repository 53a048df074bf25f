//! Claims, published and made up, against the exact answer.

use boundfit::Reading;
use boundfit::ask::{Common, Form, Request};
use boundfit::engine::exact::Foreign;
use boundfit::files::Source;
use boundfit::report::{Origin, Style};
use boundfit_check::is_solution_name;
use boundfit_tests::cli::unbroken;
use boundfit_tests::lp_cases::{hard_cases, number};
use boundfit_tests::program::root;
use serde_json::{Value, json};

use super::{NEAR_PARALLEL, STRIP, boundfit, report, verdicts};

const EXACT: [&str; 4] = ["1/15", "2/15", "-7940000011/60000000", "-3940000001/60000000"];

/// A claims file made for one test, and the report about the nearly parallel readings.
fn near_parallel(claim: &str, status: i32) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("claim.json");
    std::fs::write(&file, claim).unwrap();
    report(&format!("{NEAR_PARALLEL} --claim {}", file.display()), status)
}

#[test]
fn the_interval_that_highs_reports_is_refuted() {
    let found = report(&format!("{NEAR_PARALLEL} --claim fixtures/claims/near-parallel-highs.json"), 4);
    let claim = &found["claims"][0];
    assert_eq!(claim["source"], "HiGHS 1.15, default settings");
    assert_eq!(verdicts(claim), ["loose", "loose", "exact", "exact"]);
    assert_eq!(
        (&claim["verdict"], &found["worst"]["verdict"]),
        (&Value::from("loose"), &Value::from("loose"))
    );
    for (bound, exact) in claim["bounds"].as_array().unwrap().iter().zip(EXACT) {
        assert_eq!(bound["exact"]["exact"], exact);
    }
    // A JSON number is the double that it is read as.
    let excess = number("1/15") - boundfit_exact::Rational::from_f64(0.05).unwrap();
    assert_eq!(claim["bounds"][0]["excess"]["exact"], excess.to_string());
    let widths = excess.checked_div(&number("1/15")).unwrap();
    assert_eq!(claim["bounds"][0]["excess_in_units"]["exact"], widths.to_string());
    assert_eq!(claim["bounds"][0]["unit"], "width");
    let text = boundfit(&format!("{NEAR_PARALLEL} --claim fixtures/claims/near-parallel-highs.json"));
    assert_eq!(text.status, 4);
    for part in [
        "theta1 min: loose: too wide by 0.26 of the width (0.016667, 1.3e15 ulp)",
        "\nWorst verdict: loose; refuted\n",
    ] {
        assert!(unbroken(&text.stdout).contains(part.trim()), "{part}: {}", text.stdout);
    }
}

#[test]
fn wrong_statuses_are_refuted_with_a_proof() {
    let cases = [
        ("offset-false-infeasible", "feasible", [true, false, false]),
        ("nanometre-dropped", "feasible", [true, false, false]),
        ("unix-time-unbounded", "bounded", [false, false, true]),
        ("empty-by-1e-9", "infeasible", [false, false, true]),
    ];
    let hard = hard_cases();
    for (name, shows, [theta, ray, rows]) in cases {
        let case = hard.iter().find(|case| case.name == name).unwrap();
        let line = format!("check fixtures/hard-lp/{name}.csv --x x --y y --eps {}", case.epsilon);
        let found = report(&format!("{line} --claim fixtures/claims/{name}.json"), 4);
        assert_eq!(found["worst"]["verdict"], "wrong status", "{name}");
        for bound in found["claims"][0]["bounds"].as_array().unwrap() {
            assert_eq!(
                (&bound["verdict"], &bound["proof"]["shows"]),
                (&"wrong status".into(), &shows.into())
            );
            assert_eq!(bound["proof"]["theta"].is_array(), theta, "{name}");
            assert_eq!(bound["proof"]["ray"].is_array(), ray, "{name}");
            assert_eq!(!bound["proof"]["rows"].as_array().unwrap().is_empty(), rows, "{name}");
        }
        let text = boundfit(&format!("{line} --claim fixtures/claims/{name}.json"));
        assert!(text.status == 4 && text.stdout.contains("\nReasons\n"), "{name}");
    }
}

#[test]
fn right_claims_are_accepted() {
    let empty = "check fixtures/hard-lp/empty-by-1e-9.csv --x x --y y --eps 0.373923265";
    let cases = [
        (NEAR_PARALLEL, "near-parallel-exact", "exact"),
        (NEAR_PARALLEL, "near-parallel-rounded", "rounded"),
        (empty, "empty-by-1e-9-right", "exact"),
        (STRIP, "strip-unbounded", "exact"),
        (STRIP, "strip-null", "exact"),
    ];
    for (line, file, verdict) in cases {
        let found = report(&format!("{line} --claim fixtures/claims/{file}.json"), 0);
        assert_eq!(found["worst"]["verdict"], verdict, "{file}");
        assert_eq!(verdicts(&found["claims"][0]), [verdict; 4], "{file}");
        if verdict == "rounded" {
            let mut bounds = found["claims"][0]["bounds"].as_array().unwrap().iter();
            assert!(bounds.all(|bound| bound["rounded_to"]["kind"] == "binary64"), "{found}");
        }
    }
    // Both at once, and a solver too: the worst counts.
    let both =
        "--claim fixtures/claims/near-parallel-exact.json --claim fixtures/claims/near-parallel-highs.json";
    let found = report(&format!("{NEAR_PARALLEL} {both} --solver exact-simplex"), 4);
    let judged: Vec<&Value> =
        found["claims"].as_array().unwrap().iter().filter(|claim| claim["reading"] == "decimal").collect();
    let sources: Vec<&str> = judged.iter().map(|claim| claim["source"].as_str().unwrap()).collect();
    assert_eq!(sources, ["exact fractions", "HiGHS 1.15, default settings", "exact-simplex"]);
    assert_eq!(judged[2]["verdict"], "exact");
}

#[test]
fn every_form_of_a_claims_file() {
    let [lower1, upper1, lower2, upper2] = EXACT;
    // Without a source, the file is the source.
    let found =
        near_parallel(&format!(r#"{{"pui": [["{lower1}", "{upper1}"], ["{lower2}", "{upper2}"]]}}"#), 0);
    assert!(found["claims"][0]["source"].as_str().unwrap().ends_with("claim.json"));
    // Ends that are null are claimed unbounded.
    let found = near_parallel(&format!(r#"{{"pui": [[null, "{upper1}"], ["{lower2}", null]]}}"#), 4);
    assert_eq!(verdicts(&found["claims"][0]), ["wrong status", "exact", "exact", "wrong status"]);
    // Points alone: the ends are theirs; a missing one is no answer.
    let points =
        r#"{"points": [["1/15", "-3940000001/60000000"], ["2/15", "-7940000011/60000000"], null, null]}"#;
    let found = near_parallel(points, 0);
    assert_eq!(verdicts(&found["claims"][0]), ["exact", "exact", "no answer", "no answer"]);
    let bound = &found["claims"][0]["bounds"][0];
    assert_eq!((&bound["tau"]["exact"], &bound["tau_in_epsilon"]["exact"]), (&"0".into(), &"0".into()));
    assert_eq!(found["claims"][0]["bounds"][2]["reason"], "no point given");
    // A point outside beside right ends, as JSON numbers: 1 above the upper bound of row 1 at θ1 = 0.
    let point = format!(
        r#"{{"status": "optimal", "pui": [["{lower1}", "{upper1}"], ["{lower2}", "{upper2}"]],
            "points": [[0, "2.00000005"], null, null, null]}}"#
    );
    let found = near_parallel(&point, 4);
    assert_eq!(verdicts(&found["claims"][0]), ["infeasible point", "exact", "exact", "exact"]);
    let bound = &found["claims"][0]["bounds"][0];
    let expected = ["1", "1", "20000000"];
    let figures = ["violation", "tau", "tau_in_epsilon"].map(|key| bound[key]["exact"].as_str().unwrap());
    assert_eq!((figures, &bound["row"], &bound["bound"]), (expected, &1.into(), &"upper".into()));
    // Duals: rows 1 upper and 4 lower prove the minimum of θ1; eight are expected.
    let claim = |duals: &str| {
        format!(
            r#"{{"pui": [[0, "{upper1}"], ["{lower2}", "{upper2}"]], "duals": [{duals}, null, null, null]}}"#
        )
    };
    for (duals, repairable) in [
        // Row 4 upper and row 1 lower prove the other end.
        ("[0, 0, 0, 3e5, 3e5, 0, 0, 0]", false.into()),
        ("[3.4e5, 0, 0, 1e-9, 0, 0, 0, 3.3e5]", true.into()),
        ("[0, 2, 1, 0, 0, 0, 0, 0]", false.into()),
        ("[1, 2, 3]", Value::Null),
        ("null", Value::Null),
    ] {
        let found = near_parallel(&claim(duals), 4);
        let bound = &found["claims"][0]["bounds"][0];
        assert_eq!(bound["repairable"], repairable, "{duals}");
    }
    // The undecided status, of a set that is neither.
    let found = near_parallel(r#"{"source": "glpk", "status": "infeasible-or-unbounded"}"#, 4);
    assert_eq!(verdicts(&found["claims"][0]), ["wrong status"; 4]);
    // Status alone decides: numbers beside it are not looked at.
    let found = near_parallel(r#"{"status": "unbounded", "pui": [[0, 1], [2, 3]]}"#, 4);
    assert_eq!(verdicts(&found["claims"][0]), ["wrong status"; 4]);
}

#[test]
fn ends_on_the_command_line() {
    let line = |ends: &str| format!("{NEAR_PARALLEL} --claim-pui {ends}");
    assert_eq!(report(&line(&EXACT.join(",")), 0)["worst"]["verdict"], "exact");
    let found = report(&line("0.05,0.15,-149,-49"), 4);
    assert_eq!(found["claims"][0]["source"], "claimed PUI");
    assert_eq!(verdicts(&found["claims"][0]), ["loose"; 4]);
    let found = report(&line("0.07,0.13,-inf,-70"), 4);
    assert_eq!(verdicts(&found["claims"][0]), ["unsafe", "unsafe", "wrong status", "unsafe"]);
    for bound in [0, 1, 3].map(|index| &found["claims"][0]["bounds"][index]) {
        assert!(bound["witness"].is_array(), "{bound}");
    }
    let found = report(&line("2/15,1/15,-7940000011/60000000,-3940000001/60000000"), 4);
    let inverted = "inverted interval";
    assert_eq!(verdicts(&found["claims"][0]), [inverted, inverted, "exact", "exact"]);
    // The tolerance is in widths.
    let wide = line("'1/15, 0.2, -7940000011/60000000, -3940000001/60000000'");
    assert_eq!(report(&wide, 4)["worst"]["verdict"], "loose");
    assert_eq!(report(&format!("{wide} --tolerance 1"), 0)["worst"]["verdict"], "within tolerance");
    assert_eq!(report(&format!("{wide} --tolerance 0.999999999"), 4)["worst"]["verdict"], "loose");
    // Unbounded ends of a strip, in every spelling.
    for ends in ["-inf,inf,-inf,inf", "-Inf,+inf,-inf,Inf"] {
        assert_eq!(report(&format!("{STRIP} --claim-pui {ends}"), 0)["worst"]["verdict"], "exact", "{ends}");
    }
    let found = report(&format!("{STRIP} --claim-pui 0,1,-inf,inf"), 4);
    assert_eq!(verdicts(&found["claims"][0]), ["wrong status", "wrong status", "exact", "exact"]);
    assert_eq!(found["claims"][0]["bounds"][0]["proof"]["shows"], "unbounded");
    // Twice: both are judged.
    let found = report(&format!("{} --claim-pui 0,1,2,3", line(&EXACT.join(","))), 4);
    let worsts = found["claims"].as_array().unwrap().iter().filter(|claim| claim["reading"] == "decimal");
    let worsts: Vec<&str> = worsts.map(|claim| claim["verdict"].as_str().unwrap()).collect();
    assert_eq!(worsts, ["exact", "unsafe"]);
}

#[test]
fn a_request_has_the_texts_of_claims_and_the_answer_of_the_program() {
    let (data, folder) = ("fixtures/hard-lp/nanometre-dropped.csv", "fixtures/solutions/nanometre-dropped");
    let entries = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = entries.filter(|path| is_solution_name(path)).collect();
    files.sort();
    let name = |path: &std::path::Path| format!("{folder}/{}", path.file_name().unwrap().display());
    let claim = |path: &std::path::PathBuf| json!({"file": name(path), "text": std::fs::read_to_string(path).unwrap()});
    let claims: Vec<Value> = files.iter().map(claim).collect();
    assert!(claims.len() >= 4, "{claims:?}");
    let request = json!({"ask": "check", "claim": claims, "x": "x", "y": "y", "eps": "0.05"});
    let (request, Common { readings, .. }) = Request::with_readings(&request.to_string()).unwrap();
    let asked = request.resolve(&readings, Reading::Decimal).unwrap();
    for form in [Form::Text, Form::Json] {
        let source = Source::open(root().join(data).to_str().unwrap()).unwrap();
        let origin = Origin { file: Some(Foreign::of(data)), reading: Reading::Decimal, is_stored: false };
        let told = request.answer(&asked, source, form, Some(origin), &Style::default()).unwrap();
        let options = format!("--x x --y y --eps 0.05 --claim {folder} --format {}", form.name());
        let run = boundfit(&format!("check {data} {options}"));
        assert_eq!((told.text, told.written.is_refuted), (run.stdout, run.status == 4), "{options}");
    }
}
