//! `boundfit judge --solution`: what solvers wrote about `fixtures/tiny-lp`, judged, and the reports of it.

use std::fs;

use boundfit_tests::program::{Run, root, run, run_with_input};
use serde_json::Value;

/// Returns the output of a solver of this name about a program.
fn fixture(name: &str, solver: &str) -> String {
    format!("fixtures/solutions/tiny-lp/{name}.{solver}.sol")
}

fn judge(name: &str, solution: &str, options: &[&str]) -> Run {
    let model = format!("fixtures/tiny-lp/{name}.mps");
    run(&[&["judge", &model, "--solution", solution], options].concat())
}

/// The only solution of the report in JSON.
fn judged(name: &str, solution: &str, options: &[&str]) -> (i32, Value) {
    let run = judge(name, solution, &[&["--format", "json"], options].concat());
    let report: Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{run:?}"));
    (run.status, report["solutions"][0].clone())
}

fn refuted(solution: &Value) -> Vec<&str> {
    let findings = solution["findings"].as_array().unwrap().iter();
    findings.filter(|own| own["verdict"] == "refuted").map(|own| own["aspect"].as_str().unwrap()).collect()
}

/// A changed fixture in a folder of its own.
fn changed(name: &str, solver: &str, from: &str, to: &str) -> (tempfile::TempDir, String) {
    let text = fs::read_to_string(root().join(fixture(name, solver))).unwrap();
    assert!(text.contains(from), "{name} {solver}: {from}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("changed.sol");
    fs::write(&path, text.replacen(from, to, 1)).unwrap();
    let path = path.display().to_string();
    (folder, path)
}

#[test]
fn right_answers_of_every_format_pass() {
    for (name, solver, writer, verdict) in [
        ("maximise", "highs-raw", "HiGHS", "exact"),
        ("maximise", "highs-table", "HiGHS", "exact"),
        ("maximise", "highs-glpsol", "HiGHS", "exact"),
        ("maximise", "glpk-plain", "GLPK", "exact"),
        ("maximise", "glpk-printed", "GLPK", "exact"),
        ("maximise", "cbc", "CBC", "exact"),
        ("vertex-third", "highs-raw", "HiGHS", "rounded"),
        ("vertex-third", "glpk-plain", "GLPK", "rounded"),
        ("vertex-third", "cbc", "CBC", "rounded"),
        ("triangle-empty", "highs-raw", "HiGHS", "exact"),
        ("triangle-empty", "cbc", "CBC", "exact"),
        ("scipy-11618", "highs-raw", "HiGHS", "exact"),
    ] {
        let (status, solution) = judged(name, &fixture(name, solver), &[]);
        let found = (status, solution["writer"].as_str(), solution["verdict"].as_str());
        assert_eq!(found, (0, Some(writer), Some(verdict)), "{name} {solver}: {solution}");
        // An optimum comes with all that can be judged of it.
        let aspects = solution["findings"].as_array().unwrap().len();
        assert_eq!(aspects, if solution["status"] == "optimal" { 7 } else { 1 }, "{name} {solver}");
    }
}

/// A model of `fixtures/solutions/dialects` with what a solver wrote about it.
fn dialect(model: &str, solution: &str) -> (i32, Value) {
    let folder = "fixtures/solutions/dialects";
    let solution =
        if solution.starts_with('/') { solution.to_owned() } else { format!("{folder}/{solution}.sol") };
    let run = run(&["judge", &format!("{folder}/{model}"), "--solution", &solution, "--format", "json"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{run:?}"));
    (run.status, report["solutions"][0].clone())
}

/// The note on the values of rows.
const ACTIVITIES: &str = "the row activities are not looked at: the point decides";

#[test]
fn right_answers_pass_in_every_dialect() {
    for (model, solver, writer, claimed, verdict, aspects) in [
        ("cost-row-last.lp", "highs-glpsol", "HiGHS", "optimal", "rounded", 7),
        ("thirds.lp", "highs-glpsol", "HiGHS", "optimal", "rounded", 7),
        ("interior.lp", "highs-glpsol", "HiGHS", "optimal", "within tolerance", 7),
        ("no-costs.lp", "highs-glpsol", "HiGHS", "optimal", "exact", 7),
        ("row-objective.mps", "highs-raw", "HiGHS", "optimal", "rounded", 7),
        ("column-objective.mps", "highs-raw", "HiGHS", "optimal", "rounded", 7),
        ("tie.mps", "highs-glpsol", "HiGHS", "optimal", "exact", 7),
        ("ranges.mps", "gurobi", "Gurobi", "optimal", "exact", 4),
        ("empty-row.lp", "highs-raw", "HiGHS", "optimal", "exact", 7),
        ("empty-row.lp", "highs-sparse", "HiGHS", "optimal", "exact", 4),
        ("negative-upper.lp", "highs-raw", "HiGHS", "infeasible", "exact", 1),
        ("never-feasible.lp", "cplex", "CPLEX", "infeasible-or-unbounded", "no answer", 1),
        ("unbounded.mps", "glpk-interior-plain", "GLPK", "infeasible-or-unbounded", "no answer", 1),
        ("unbounded.mps", "glpk-interior-printed", "GLPK", "infeasible-or-unbounded", "no answer", 1),
    ] {
        let name = format!("{}.{solver}", model.split('.').next().unwrap());
        let (status, solution) = dialect(model, &name);
        let found = ["writer", "status", "verdict"].map(|key| solution[key].as_str().unwrap());
        assert_eq!((status, found), (0, [writer, claimed, verdict]), "{name}: {solution}");
        assert_eq!(solution["findings"].as_array().unwrap().len(), aspects, "{name}: {solution}");
        let has_rows = claimed == "optimal" && !solver.contains("sparse") && solver != "gurobi";
        let expected = if has_rows { ACTIVITIES.into() } else { Value::Null };
        assert_eq!(solution["not_judged"], expected, "{name}");
    }
}

#[test]
fn duals_are_judged_beside_a_cost_row_or_said_not_to_be() {
    let text =
        fs::read_to_string(root().join("fixtures/solutions/dialects/thirds.highs-glpsol.sol")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("changed.sol");
    fs::write(&path, text.replacen("i 1 u 1 -0.3333333333333", "i 1 u 1 -77", 1)).unwrap();
    let (status, solution) = dialect("thirds.lp", path.to_str().unwrap());
    assert_eq!((status, refuted(&solution)), (4, vec!["dual", "complementary-slackness", "duality-gap"]));
    // Without costs HiGHS states 0 for the constant; every other number is a claim.
    let free = fs::read_to_string(root().join("fixtures/solutions/dialects/no-costs.highs-glpsol.sol"));
    for (objective, aspects) in [("0", vec![]), ("5", vec![]), ("4", vec!["objective"])] {
        let stated = format!("f f {objective}\n");
        let own = free.as_ref().unwrap().replacen("f f 0\n", &stated, 1);
        fs::write(&path, own.replacen("Objective:  0 ", &format!("Objective:  {objective} "), 1)).unwrap();
        let (_, solution) = dialect("no-costs.lp", path.to_str().unwrap());
        assert_eq!(refuted(&solution), aspects, "{objective}: {solution}");
    }
    // Two rows more than the model has: which ones these are is not known.
    let longer = text.replacen("s bas 3 2", "s bas 4 2", 1).replacen("j 1", "i 4 b 5 0\nj 1", 1);
    fs::write(&path, longer).unwrap();
    let (status, solution) = dialect("thirds.lp", path.to_str().unwrap());
    assert_eq!((status, solution["findings"].as_array().unwrap().len()), (0, 4), "{solution}");
    let said = "the duals are not looked at: the file lists 4 rows, the model has 2 rows";
    assert_eq!(solution["not_judged"], format!("{said}; {ACTIVITIES}"));
    // A row that is missing among names has no dual, not the dual 0.
    let (_folder, path) = changed(
        "maximise",
        "highs-table",
        "        2     UB         -inf           18           18            1  R3\n",
        "",
    );
    let (status, solution) = judged("maximise", &path, &[]);
    assert_eq!((status, solution["findings"].as_array().unwrap().len()), (0, 4), "{solution}");
    let said = "the duals are not looked at: the file lists 2 rows, the model has 3 rows";
    assert_eq!(solution["not_judged"], format!("{said}; {ACTIVITIES}"));
}

#[test]
fn wrong_answers_are_refuted() {
    for (name, solver, aspects) in [
        ("hard-nanometre-dropped-theta1-max", "highs-raw", &["status"][..]),
        ("hard-glpk-exact-not-exact-theta1-max", "glpk-exact", &["status"]),
        ("hard-giga-unsafe-theta1-max", "cbc", &["primal", "optimality"]),
        // Infeasible by so little that an absolute tolerance excuses it, which is said.
        ("triangle-empty-1e-9", "highs-raw", &["status"]),
    ] {
        let (status, solution) = judged(name, &fixture(name, solver), &[]);
        assert_eq!((status, refuted(&solution)), (4, aspects.to_vec()), "{name}: {solution}");
    }
    let (_, solution) = judged("triangle-empty-1e-9", &fixture("triangle-empty-1e-9", "highs-raw"), &[]);
    let excuse = &solution["findings"][0]["tolerance"]["absolute"]["value"].as_f64().unwrap();
    assert!((1e-10..=1e-9).contains(excuse), "{excuse}");
}

#[test]
fn a_changed_number_is_refuted_at_its_line() {
    for (from, to, aspects, line) in [
        ("Objective 36", "Objective 36.01", vec!["objective"], 6),
        ("X2 6", "X2 5.9", vec!["optimality", "complementary-slackness", "duality-gap"], 8),
        ("\nR1 0\n", "\nR1 -0.1\n", vec!["dual"], 21),
        ("Optimal", "Infeasible", vec!["status"], 2),
    ] {
        let (_folder, path) = changed("maximise", "highs-raw", from, to);
        let (status, solution) = judged("maximise", &path, &[]);
        assert_eq!((status, refuted(&solution)), (4, aspects), "{to}: {solution}");
        let findings = solution["findings"].as_array().unwrap();
        let worst = findings.iter().find(|own| own["verdict"] == "refuted").unwrap();
        assert_eq!(worst["line"], line, "{to}: {worst}");
    }
}

#[test]
fn tolerance_and_printed_digits_are_options() {
    let (_folder, path) = changed("maximise", "highs-raw", "X1 2\nX2 6", "X1 2.000001\nX2 6");
    let worst = |options: &[&str]| {
        let (status, solution) = judged("maximise", &path, options);
        (status, solution["verdict"].as_str().unwrap().to_owned())
    };
    assert_eq!(worst(&[]), (0, "within tolerance".to_owned()));
    assert_eq!(worst(&["--tolerance", "1e-9"]), (4, "refuted".to_owned()));
    assert_eq!(worst(&["--strict"]), (4, "refuted".to_owned()));
    let third = |options: &[&str]| {
        judged("vertex-third", &fixture("vertex-third", "cbc"), options).1["verdict"].clone()
    };
    assert_eq!(third(&["--strict"]), "rounded");
    assert_eq!(third(&["--strict", "--digits-as-printed", "off"]), "refuted");
}

#[test]
fn text_says_the_proportion_first_and_whose_tolerance_excuses_it() {
    let (_folder, path) = changed("maximise", "highs-raw", "X1 2\n", "X1 2.5\n");
    let run = judge("maximise", &path, &[]);
    assert_eq!(run.status, 4);
    let text = run.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "in HiGHS format: refuted (primal, optimality, slackness, gap)",
        "primal refuted: off by 8.4e-2 of its size: R3 is 19.5, 1.5 above its upper bound 18; excused by a tolerance of 1.5 absolute, 7.7e-2 relative, 0.5 scaled",
        "optimality refuted: off by 4.2e-2 of its size: 37.5 instead of 36",
        "SoPlex (feastol, opttol)",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let right = judge("vertex-third", &fixture("vertex-third", "cbc"), &[]).stdout;
    let right = right.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(right.contains("in CBC format: right, but for rounding"), "{right}");
    assert!(!right.contains("SoPlex"), "{right}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.sol");
    fs::write(&path, "<CPLEXSolution><header solutionStatusString=\"optimal\"/><variables><variable name=\"x\" value=\"1\"/><variable name=\"y\" value=\"0\"/></variables><linearConstraints><constraint name=\"r\" slack=\"77\"/></linearConstraints></CPLEXSolution>").unwrap();
    let (_, cplex) = dialect("ranges.mps", path.to_str().unwrap());
    assert_eq!(cplex["not_judged"], ACTIVITIES);
}

#[test]
fn sarif_has_what_its_schema_asks_for() {
    let (_folder, path) = changed("maximise", "highs-raw", "Objective 36", "Objective 36.01");
    let run = judge("maximise", &path, &["--format", "sarif"]);
    assert_eq!(run.status, 4, "{run:?}");
    let log: Value = serde_json::from_str(&run.stdout).unwrap();
    let keys = |value: &Value| value.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    // Required by the schema: version and runs, of a run its tool, of a driver its name, of a result its message.
    assert_eq!(keys(&log), ["$schema", "version", "runs"]);
    assert_eq!(log["version"], "2.1.0");
    let run = &log["runs"][0];
    assert_eq!(run["tool"]["driver"]["name"], "boundfit");
    let rules: Vec<&str> = run["tool"]["driver"]["rules"]
        .as_array()
        .unwrap()
        .iter()
        .map(|rule| rule["id"].as_str().unwrap())
        .collect();
    let results = run["results"].as_array().unwrap();
    assert_eq!(results.len(), 7);
    for result in results {
        let rule = result["ruleId"].as_str().unwrap();
        assert_eq!(rules[result["ruleIndex"].as_u64().unwrap() as usize], rule);
        assert!(!result["message"]["text"].as_str().unwrap().is_empty());
        // "If kind is anything other than fail, level shall be none" (SARIF 2.1.0, 3.27.10).
        let failed = rule == "objective";
        let expected = if failed { ("fail", "error") } else { ("pass", "none") };
        assert_eq!(
            (result["kind"].as_str().unwrap(), result["level"].as_str().unwrap()),
            expected,
            "{result}"
        );
        let place = &result["locations"][0]["physicalLocation"];
        assert!(place["region"]["startLine"].as_u64().unwrap() >= 1);
        assert_eq!(place["artifactLocation"]["uri"].as_str().unwrap(), path);
        assert_eq!(place["region"]["startLine"] == 6, failed);
    }
}

#[test]
fn junit_is_xml_with_a_case_for_each_aspect() {
    let (folder, path) = changed("maximise", "highs-raw", "Objective 36", "Objective 36.01");
    let strange = folder.path().join("a<b>&\"c.sol");
    fs::copy(&path, &strange).unwrap();
    let run = judge("maximise", strange.to_str().unwrap(), &["--format", "junit"]);
    assert_eq!(run.status, 4);
    let document = roxmltree::Document::parse(&run.stdout).unwrap();
    let suites = document.root_element();
    let counts = |node: roxmltree::Node<'_, '_>| {
        ["tests", "failures", "skipped"].map(|name| node.attribute(name).unwrap().parse::<usize>().unwrap())
    };
    assert_eq!((suites.tag_name().name(), counts(suites)), ("testsuites", [7, 1, 0]));
    let suite = suites.children().find(|node| node.has_tag_name("testsuite")).unwrap();
    assert_eq!((suite.attribute("name"), counts(suite)), (strange.to_str(), [7, 1, 0]));
    let cases: Vec<_> = suite.children().filter(|node| node.has_tag_name("testcase")).collect();
    assert_eq!(cases.len(), 7);
    let failed: Vec<_> =
        cases.iter().filter(|case| case.children().any(|node| node.has_tag_name("failure"))).collect();
    assert_eq!(failed.len(), 1);
    assert_eq!((failed[0].attribute("name"), failed[0].attribute("line")), (Some("objective"), Some("6")));
}

#[test]
fn a_number_that_is_not_finite_is_no_answer_in_every_view() {
    let (_folder, path) = changed("maximise", "highs-raw", "X1 2\n", "X1 nan\n");
    let said = "no answer: the value of X1 is not a finite number";
    let view = |options: &[&str]| {
        let run = judge("maximise", &path, &[&["--strict"], options].concat());
        assert_eq!(run.status, 0, "{run:?}");
        run.stdout
    };
    let text = view(&[]);
    assert!(text.contains("in HiGHS format: no answer\n"), "{text}");
    assert!(text.contains(&format!("primal        {said}\n")), "{text}");
    let (_, solution) = judged("maximise", &path, &["--strict"]);
    let primal = &solution["findings"][2];
    assert_eq!((&solution["verdict"], &primal["verdict"]), (&"no answer".into(), &"no answer".into()));
    assert_eq!((&primal["column"], &primal["line"]), (&"X1".into(), &8.into()));
    let junit = view(&["--format", "junit"]);
    assert!(junit.contains(&format!("<skipped message=\"{said}\"/>")), "{junit}");
    let sarif: Value = serde_json::from_str(&view(&["--format", "sarif"])).unwrap();
    let result = &sarif["runs"][0]["results"][2];
    assert_eq!((&result["level"], &result["kind"]), (&"warning".into(), &"fail".into()));
    assert_eq!(result["message"]["text"], format!("{said}."));
}

#[test]
fn formats_for_findings_alone_want_a_solution() {
    for format in ["sarif", "junit"] {
        let run = run(&["judge", "fixtures/tiny-lp/maximise.mps", "--format", format]);
        let message = "error: sarif and junit write findings about solutions: give '--solution'\n\nFor more information, try '--help'.\n";
        assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (2, "", message));
    }
}

#[test]
fn files_about_something_else_are_refused() {
    let refusal = |name: &str, text: &str| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.sol").display().to_string();
        fs::write(&path, text).unwrap();
        let run = judge(name, &path, &[]);
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{text}");
        run.stderr.strip_prefix(&format!("error: {path}: ")).unwrap().trim_end().to_owned()
    };
    assert_eq!(
        refusal("maximise", "=obj= 1\nX3 1\n"),
        "line 2: X3 is no column of the model (expected X1, X2)"
    );
    assert_eq!(
        refusal("maximise", "s bas 0 3 f f 0\nj 1 b 0 0\nj 2 b 0 0\nj 3 b 0 0\ne o f\n"),
        "line 1: \"s bas 0 3 f f 0\" is no solution of the model (expected X1, X2)"
    );
    assert_eq!(
        refusal("maximise", "what"),
        "this is no solution (expected JSON, or a solution as GLPK, HiGHS, CBC, CLP, SCIP, Gurobi, MIPLIB or, in XML, CPLEX writes it)"
    );
    // A program that is infeasible has status 3 by itself, but not where a solution is asked about.
    let alone = run(&["judge", "fixtures/tiny-lp/triangle-empty.mps"]);
    let judged = judge("triangle-empty", &fixture("triangle-empty", "highs-raw"), &[]);
    assert_eq!((alone.status, judged.status), (3, 0));
}

/// Judges an answer in a file of its own.
fn judged_text(name: &str, text: &str) -> (i32, Value) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.sol");
    fs::write(&path, text).unwrap();
    judged(name, path.to_str().unwrap(), &[])
}

#[test]
fn what_is_null_in_json_is_not_claimed() {
    let right = r#""objective": "-2/3", "x": ["1/3", "1/3"]"#;
    let (own, plain) = judged_text("vertex-third", &format!("{{{right}}}"));
    let nulls = r#""duals": null, "reduced_costs": null, "ray": null, "farkas": null"#;
    let (with_nulls, claimed) = judged_text("vertex-third", &format!("{{{right}, {nulls}}}"));
    assert_eq!((own, refuted(&plain)), (with_nulls, refuted(&claimed)));
    assert_eq!(plain["findings"], claimed["findings"]);
    assert_eq!(plain["claimed_status"], claimed["claimed_status"]);
}

#[test]
fn prices_that_lean_on_no_bound_prove_no_gap() {
    let prices = r#"{"status": "optimal", "duals": [1, 1], "objective": "-2/3", "x": ["1/3", "1/3"]}"#;
    let (_, solution) = judged_text("vertex-third", prices);
    assert!(refuted(&solution).contains(&"dual"), "{solution}");
    let aspects: Vec<&str> =
        solution["findings"].as_array().unwrap().iter().filter_map(|own| own["aspect"].as_str()).collect();
    assert!(
        !aspects.iter().any(|aspect| ["complementary_slackness", "duality_gap"].contains(aspect)),
        "{aspects:?}"
    );
}

#[test]
fn an_objective_without_a_name_is_compared() {
    let named = "Objective:  OBJECTIVE = -0.6666666667";
    let (_folder, right) = changed("vertex-third", "glpk-plain", named, "Objective:  -0.6666666667");
    assert_eq!(judge("vertex-third", &right, &[]).status, 0);
    let (_folder, wrong) = changed("vertex-third", "glpk-plain", named, "Objective:  -7");
    let run = judge("vertex-third", &wrong, &[]);
    assert!(run.status == 1 && run.stderr.contains("-7"), "{run:?}");
}

#[test]
fn words_that_only_begin_like_optimal_are_no_answer() {
    for (status, verdict) in [
        ("optimal", "exact"),
        ("Optimal", "exact"),
        ("optimality not proven", "no answer"),
        ("optimal?", "no answer"),
        ("optimal relaxed sum of infeasibilities", "no answer"),
        ("infeasible point", "no answer"),
    ] {
        let text = format!(r#"{{"status": "{status}", "objective": "-2/3", "x": ["1/3", "1/3"]}}"#);
        let (_, solution) = judged_text("vertex-third", &text);
        assert_eq!(solution["verdict"], verdict, "{status}: {solution}");
    }
}

#[test]
fn a_file_of_scip_without_a_status_claims_an_optimum() {
    for (text, verdict) in [
        ("objective value: -99\nX1 77 (obj:-2)\n", "refuted"),
        ("objective value: -0.666666666666667\n", "refuted"),
        ("solution status: unknown\nobjective value: -99\nX1 77 (obj:-2)\n", "no answer"),
        ("solution status: unknown\nno solution available\n", "no answer"),
    ] {
        let (_, solution) = judged_text("vertex-third", text);
        assert_eq!(solution["writer"], "SCIP", "{solution}");
        let status = solution["findings"].as_array().unwrap().iter().find(|own| own["aspect"] == "status");
        let expected = if verdict == "refuted" { "exact" } else { "no answer" };
        assert_eq!(status.unwrap()["verdict"], expected, "{text}: {solution}");
        assert_eq!(refuted(&solution).contains(&"optimality"), verdict == "refuted", "{text}: {solution}");
    }
    let right = "objective value: -0.666666666666667\nX1 0.333333333333333\nX2 0.333333333333333\n";
    let (status, solution) = judged_text("vertex-third", right);
    assert!(status == 0 && solution["verdict"] == "rounded", "{solution}");
}

#[test]
fn the_optimum_of_the_opposite_sense_is_called_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.json");
    fs::write(&path, r#"{"status": "optimal", "objective": 0, "x": [0, 0]}"#).unwrap();
    let text = judge("vertex-third", path.to_str().unwrap(), &[]).stdout;
    let said = "which is the maximum, but the program asks for the minimum";
    let words: Vec<&str> = text.split_whitespace().collect();
    assert_eq!(words.join(" ").matches(said).count(), 2, "{text}");
}

/// The lists of CBC's `printingOptions rows` leave small values out with their prices: that of z is 1.
#[test]
fn prices_that_a_list_of_cbc_leaves_out_are_not_taken_for_zero() {
    let model = "min\n x + 2 y + 3 z\nst\n c1: x + y + z >= 3\n c2: x - y <= 0\nbounds\n z = 0\nend\n";
    let row = "      1 c2                     0                    -0.5\n";
    let list = format!(
        "Optimal - objective value 4.50000000\n      0 c1                     3                     1.5\n{row}      0 x                    1.5                       0\n      1 y                    1.5                       0\n"
    );
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    fs::write(path("m.lp"), model).unwrap();
    let about = |list: &str| {
        fs::write(path("cbc.sol"), list).unwrap();
        let run = run(&["judge", &path("m.lp"), "--solution", &path("cbc.sol"), "--format", "json"]);
        let report: Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{run:?}"));
        (run.status, report["solutions"][0].clone())
    };
    let (status, solution) = about(&list);
    assert_eq!((status, solution["findings"].as_array().unwrap().len()), (0, 7), "{solution}");
    let (status, solution) = about(&list.replace(row, ""));
    let said = "the duals are not looked at: the file lists 1 row, the model has 2 rows";
    assert_eq!((status, &solution["not_judged"]), (0, &format!("{said}; {ACTIVITIES}").into()), "{solution}");
    let (status, solution) = about(&list.replace("-0.5", "0.5").replace("  1.5\n   ", " -1.5\n   "));
    let said = solution["findings"][4]["message"].as_str().unwrap_or_default().to_owned();
    assert!(status == 4 && said.contains("; all prices have the opposite sign,"), "{solution}");
}

#[test]
fn reduced_costs_without_duals_are_said_to_be_passed_over() {
    let right = r#""objective": "-2/3", "x": ["1/3", "1/3"]"#;
    let (_, solution) = judged_text("vertex-third", &format!("{{{right}, \"reduced_costs\": [5, 5]}}"));
    let said = "the reduced costs are not looked at: there are no duals";
    assert_eq!(solution["not_judged"], said, "{solution}");
    let (_, solution) = judged_text("vertex-third", &format!("{{{right}}}"));
    assert_eq!(solution["not_judged"], Value::Null, "{solution}");
}

#[test]
fn a_model_and_its_solution_cannot_share_standard_input() {
    let run = run(&["judge", "-", "--solution", "-"]);
    let problem = "error: the model and its solutions cannot share standard input\n";
    assert!(run.status == 2 && run.stderr.starts_with(problem), "{run:?}");
    let solution = fs::read(root().join(fixture("maximise", "cbc"))).unwrap();
    let judge = ["judge", "fixtures/tiny-lp/maximise.mps", "--solution", "-"];
    let run = run_with_input(&judge, &solution);
    assert!(run.stdout.contains("\nstandard input, in CBC format: right, exactly\n"), "{run:?}");
}
