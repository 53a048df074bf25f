//! Files that solvers write about the programs of `boundfit convert`, as claims.

use std::fs;
use std::path::Path;

use boundfit_tests::lp_cases::number;
use boundfit_tests::program::root;
use serde_json::Value;

use super::{STRIP, boundfit, report, verdicts};

const TRANSDUCER: &str = "check fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3";
const EMPTY: &str = "check fixtures/hard-lp/empty-by-1e-9.csv --x x --y y --eps 0.373923265";
const NANOMETRE: &str = "check fixtures/hard-lp/nanometre-dropped.csv --x x --y y --eps 0.05";
const PROGRAMS: [&str; 4] = ["theta1-min", "theta1-max", "theta2-min", "theta2-max"];

/// The claims about one line that are judged against the data as written.
fn claims(line: &str, status: i32) -> Vec<Value> {
    let found = report(line, status);
    let claims = found["claims"].as_array().unwrap().iter();
    claims.filter(|claim| claim["reading"] == "decimal").cloned().collect()
}

fn claimed(claim: &Value) -> Vec<String> {
    let bounds = claim["bounds"].as_array().unwrap().iter();
    bounds.map(|bound| bound["claimed"]["exact"].as_str().unwrap_or("none").to_owned()).collect()
}

/// A folder with these files.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn solution(path: &str) -> String {
    fs::read_to_string(root().join("fixtures/solutions").join(path)).unwrap()
}

#[test]
fn every_format_says_what_it_prints() {
    // As many digits as each solver prints, all of them taken as they are.
    for (solver, source, value, has_duals) in [
        ("glpk-plain", "GLPK", "0.00179089203479447", true),
        ("glpk-printed", "GLPK", "0.00179089", true),
        ("highs-raw", "HiGHS", "0.0017908920348", true),
        ("highs-table", "HiGHS", "0.00179089", true),
        ("cbc", "CBC", "0.001790892", false),
        ("cplex-xml", "CPLEX", "0.00179089203479447", true),
        ("scip", "SCIP", "0.00179089203479447", false),
    ] {
        let line = format!("{TRANSDUCER} --claim fixtures/solutions/transducer/{solver}");
        let run = boundfit(&line);
        assert!(run.status == 0 || run.status == 4, "{solver}: {run:?}");
        let found = &claims(&line, run.status)[0];
        assert_eq!(
            found["source"],
            format!("{source}, fixtures/solutions/transducer/{solver}/*.sol"),
            "{solver}"
        );
        let text = solution(&format!("transducer/{solver}/theta1-min.sol"));
        let mut printed = text.split(|c: char| c.is_whitespace() || c == '"');
        assert!(printed.any(|word| word == value), "{solver}: {text}");
        assert_eq!(claimed(found)[0], number(value).to_string(), "{solver}");
        for bound in found["bounds"].as_array().unwrap() {
            assert_eq!(bound["repairable"], if has_duals { true.into() } else { Value::Null }, "{solver}");
            assert!(bound["tau"].is_object(), "{solver}: the point is judged too");
            assert_ne!(bound["verdict"], "wrong status", "{solver}");
        }
    }
}

#[test]
fn files_alone_and_folders_are_one_answer() {
    let of = |solver: &str, program: &str| format!("fixtures/solutions/transducer/{solver}/{program}.sol");
    let all: String = PROGRAMS.map(|program| format!(" --claim {}", of("glpk-plain", program))).concat();
    let whole = claims(&format!("{TRANSDUCER} --claim fixtures/solutions/transducer/glpk-plain"), 0);
    assert_eq!(claims(&format!("{TRANSDUCER}{all}"), 0), whole);
    // An end without a file is not claimed.
    let alone = &claims(&format!("{TRANSDUCER} --claim {}", of("glpk-plain", "theta2-max")), 0)[0];
    assert_eq!(alone["source"], format!("GLPK, {}", of("glpk-plain", "theta2-max")));
    assert_eq!(verdicts(alone)[..3], ["no answer"; 3]);
    assert_eq!(alone["bounds"][0]["reason"], "no file given");
    assert_eq!(alone["bounds"][3], whole[0]["bounds"][3]);
    // Files whose names differ in more than the program are answers of their own; other files are passed over.
    let text = |program: &str| solution(&format!("transducer/glpk-plain/{program}.sol"));
    let mixed = folder(&[
        ("a-theta1-min.sol", &text("theta1-min")),
        ("a-theta1_max.sol", &text("theta1-max")),
        ("b-theta1-min.w", &text("theta1-min")),
        ("a-theta1-min.mps", "no solution"),
        ("theta1-min.LOG", "no solution"),
        ("readme", "no solution"),
    ]);
    let found = claims(&format!("{TRANSDUCER} --claim {}", mixed.path().display()), 0);
    let sources: Vec<&str> = found.iter().map(|claim| claim["source"].as_str().unwrap()).collect();
    let name = |name: &str| format!("GLPK, {}/{name}", mixed.path().display());
    assert_eq!(sources, [name("a-*.sol"), name("b-theta1-min.w")]);
    assert_eq!(found[0]["bounds"][1], whole[0]["bounds"][1]);
    // The subject of the file may stand only in the file.
    let unnamed = folder(&[("answer", &text("theta2-min"))]);
    let found = claims(&format!("{TRANSDUCER} --claim {}/answer", unnamed.path().display()), 0);
    assert_eq!(found[0]["bounds"][2], whole[0]["bounds"][2]);
}

#[test]
fn statuses() {
    let verdict = |line: &str, status: i32, name: &str, text: &str| {
        let folder = folder(&[(name, text)]);
        let found = claims(&format!("{line} --claim {}", folder.path().join(name).display()), status);
        (verdicts(&found[0])[0].to_owned(), found[0]["bounds"][0]["reason"].clone())
    };
    let exact = |line: &str, text: &str| {
        assert_eq!(verdict(line, 0, "theta1-min.sol", text), ("exact".to_owned(), Value::Null), "{text}");
    };
    let nothing = |line: &str, text: &str, reason: &str| {
        assert_eq!(
            verdict(line, 0, "theta1-min.sol", text),
            ("no answer".to_owned(), reason.into()),
            "{text}"
        );
    };
    for file in [
        "glpk-plain-infeasible",
        "glpk-printed-infeasible",
        "glpk-exact-infeasible",
        "highs-raw-infeasible",
        "highs-glpsol-infeasible",
        "cbc-infeasible",
    ] {
        let text = solution(&format!("statuses/{file}.sol"));
        exact(EMPTY, &text);
        assert_eq!(verdict(STRIP, 4, "theta1-min.sol", &text).0, "wrong status", "{file}");
    }
    for file in
        ["glpk-plain-unbounded", "glpk-printed-unbounded", "highs-raw-unbounded", "highs-glpsol-unbounded"]
    {
        let text = solution(&format!("statuses/{file}.sol"));
        exact(STRIP, &text);
        assert_eq!(verdict(EMPTY, 4, "theta1-min.sol", &text).0, "wrong status", "{file}");
    }
    // A file of SCIP that lacks its status claims an optimum.
    let scip = solution("transducer/scip/theta1-min.sol");
    let without = scip.split_once('\n').map(|(_, rest)| rest).unwrap();
    assert_eq!(
        verdict(TRANSDUCER, 0, "theta1-min.sol", without),
        verdict(TRANSDUCER, 0, "theta1-min.sol", &scip)
    );
    // With presolve GLPK says nothing about infeasible programs.
    let undefined = solution("statuses/glpk-plain-undefined.sol");
    nothing(EMPTY, &undefined, "the solver's status is UNDEFINED");
    exact(STRIP, &solution("statuses/glpk-interior-infeasible-or-unbounded.sol"));
    let header = |status: &str| {
        format!(
            "<CPLEXSolution version=\"1.2\">\n<header problemName=\"theta1-min\" solutionStatusString=\"{status}\"/>\n</CPLEXSolution>"
        )
    };
    let feasible = |text: String| text.replace("\"/>", "\" primalFeasible=\"1\"/>");
    exact(STRIP, &feasible(header("unbounded")));
    assert_eq!(verdict(EMPTY, 4, "theta1-min.sol", &feasible(header("unbounded"))).0, "wrong status");
    // CPLEX does not say by this word that there is a feasible point.
    exact(EMPTY, &header("unbounded"));
    exact(STRIP, &header("infeasible or unbounded"));
    exact(EMPTY, &header("infeasible"));
    nothing(STRIP, &header("time limit exceeded"), "the solver's status is time limit exceeded");
    exact(EMPTY, "solution status: infeasible\nno solution available\n");
    exact(STRIP, "solution status: infeasible or unbounded\nno solution available\n");
    let raw = |status: &str, primal: &str| {
        format!(
            "Model status\n{status}\n\n# Primal solution values\n{primal}\n\n# Dual solution values\nNone\n"
        )
    };
    exact(STRIP, &raw("Primal infeasible or unbounded", "None"));
    nothing(STRIP, &raw("Time limit reached", "None"), "the solver's status is Time limit reached");
    let infinite = raw("Optimal", "Feasible\nObjective inf\n# Columns 2\ntheta1 inf\ntheta2 nan\n# Rows 0");
    nothing(STRIP, &infinite, "an optimum that is not finite");
}

/// A solver that is wrong is found out from its own file.
#[test]
fn the_false_answer_of_highs_is_refuted() {
    let line = format!("{NANOMETRE} --claim fixtures/solutions/nanometre-dropped");
    let run = boundfit(&line);
    assert_eq!((run.status, run.stderr.as_str()), (4, ""), "{run:?}");
    assert!(run.stdout.contains("\nWorst verdict: "), "{}", run.stdout);
}

#[test]
fn bad_solutions_say_where_and_what_is_expected() {
    let refused = |name: &str, text: &str, message: &str| {
        let folder = folder(&[(name, text)]);
        let path = folder.path().join(name).display().to_string();
        let run = boundfit(&format!("{STRIP} --claim {path}"));
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{text}");
        assert_eq!(run.stderr, format!("error: {path}: {message}\n"), "{text}");
    };
    let unknown = "this is no claim (expected JSON, or a solution as GLPK, HiGHS, CBC, CLP, SCIP, Gurobi, MIPLIB or, in XML, CPLEX writes it)";
    refused("theta1-min.sol", "", unknown);
    refused("theta1-min.sol", "NAME theta1-min\nROWS\n", unknown);
    let glpk = "s bas 1 2 f f 0\ni 1 b 0 0\nj 1 b 1 0\nj 2 b 1 0\ne o f\n";
    let target = "nothing says which of the four programs this answers (expected theta1-min, theta1-max, theta2-min or theta2-max in the file's name)";
    refused("answer.sol", glpk, target);
    let about = format!("c Objective:  theta2_max = 0 (MINimum)\n{glpk}");
    refused("theta1-min.sol", &about, "the file is named after theta1-min and answers theta2-max");
    let cases = [
        (glpk.replace("1 2 f f 0", "1 3 f f 0").replace("e o f", "j 3 b 1 0\ne o f"), "line 1: \"s bas 1 3 f f 0\" (expected 2 variables, theta1 and theta2, as GLPK writes it)"),
        (glpk.replace("s bas 1 2 f f 0", "s bas many"), "line 1: \"s bas many\" (expected \"s bas ROWS COLUMNS PRIMAL DUAL OBJECTIVE\", or ipt or mip, as GLPK writes it)"),
        (glpk.replace("j 1 b 1 0", "j 3 b 1 0"), "line 3: \"j 3 b 1 0\" (expected \"j 1 ...\" and \"j 2 ...\" after \"s\", as GLPK writes it)"),
        (glpk.replace("j 1 b 1 0", "j 1 b one 0"), "line 3: \"one\": unexpected character 'o' at character 1 (expected a number, as GLPK writes it)"),
        (glpk.replace("j 1 b 1 0", "j 1 b 1e10001 0"), "line 3: \"1e10001\": exponent beyond 10000 (the limit) at character 3 (expected a number, as GLPK writes it); --limit exponent=N raises it"),
        (glpk.replace("i 1 b 0 0", "i 2 b 0 0"), "line 2: \"i 2 b 0 0\" (expected \"i ROW ...\" after \"s\", rows in order, as GLPK writes it)"),
        (glpk.replace("i 1 b 0 0", "x 1"), "line 2: \"x 1\" (expected a line that starts with c, s, i, j or e, as GLPK writes it)"),
        (glpk.replace("j 2 b 1 0\n", ""), "line 1: \"s bas 1 2 f f 0\": the file lists 1 column (was the file cut off?)"),
        ("Model status\nOptimal\n".to_owned(), "the file stops without \"# Primal solution values\", which HiGHS writes"),
        ("Model status\nOptimal\n\n# Primal solution values\nFeasible\nObjective 0\n# Columns 2\ntheta1 0\nx 0\n# Rows 0\n# Dual solution values\nNone\n".to_owned(), "the file stops without a value of theta2, which HiGHS writes"),
        ("Model status\nOptimal\n\n# Primal solution values\nFeasible\nObjective 0\n# Columns 2\ntheta1\n".to_owned(), "line 8: \"theta1\" (expected \"NAME VALUE\", as HiGHS writes it)"),
        ("Optimal - objective value 1\n 0 theta1\n".to_owned(), "line 2: \"0 theta1\" (expected \"INDEX NAME VALUE DUAL\", as CBC writes it)"),
        ("Problem:    theta1-min\nRows:       1\n".to_owned(), "the file stops without a line \"Status:\", which GLPK writes"),
        ("<a>\n<b></a>".to_owned(), "expected 'b' tag, not 'a' at 2:4 (expected a <CPLEXSolution>, as CPLEX writes it)"),
        ("<a/>".to_owned(), "the file stops without an element <CPLEXSolution>, which CPLEX writes"),
        ("<CPLEXSolution/>".to_owned(), "the file stops without an element <header>, which CPLEX writes"),
    ];
    for (text, message) in cases {
        refused("theta1-min.sol", &text, message);
    }
    let bomb = "<!DOCTYPE a [<!ENTITY b \"b\">]>\n<CPLEXSolution>&b;</CPLEXSolution>";
    refused("theta1-min.sol", bomb, "XML with DTD detected (expected a <CPLEXSolution>, as CPLEX writes it)");
    let twice = folder(&[("theta1-min.sol", glpk), ("theta1_min.sol", glpk)]);
    let run = boundfit(&format!("{STRIP} --claim {}", twice.path().display()));
    let path = |name: &str| twice.path().join(name).display().to_string();
    let message = format!(
        "error: {}: theta1-min is answered by {} already\n",
        path("theta1_min.sol"),
        path("theta1-min.sol")
    );
    assert_eq!((run.status, run.stderr), (1, message));
    let none = folder(&[("theta1-min.mps", "")]);
    let run = boundfit(&format!("{STRIP} --claim {}", none.path().display()));
    let message = format!(
        "error: {}: no solution is in this folder (expected files named after theta1-min, theta1-max, theta2-min, theta2-max)\n",
        none.path().display()
    );
    assert_eq!((run.status, run.stderr), (1, message));
}

#[test]
fn limits_name_the_option_that_raises_them() {
    let deep = |levels: usize| format!("{{\"pui\": {}{}}}", "[".repeat(levels - 1), "]".repeat(levels - 1));
    let refused = |text: &str, options: &str| {
        let folder = folder(&[("claim.json", text)]);
        let path = folder.path().join("claim.json").display().to_string();
        let run = boundfit(&format!("{STRIP} --claim {path} {options}"));
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{run:?}");
        run.stderr.strip_prefix(&format!("error: {path}: ")).unwrap().trim_end().to_owned()
    };
    let nested = "nested deeper than 64 levels (the limit) at line 1 column 72; --limit nesting=N raises it";
    assert_eq!(refused(&deep(65), ""), nested);
    assert_eq!(refused(&deep(1_000_000), ""), nested);
    let nested = "nested deeper than 3 levels (the limit) at line 2 column 3; --limit nesting=N raises it";
    assert_eq!(refused("{\"status\": \"[[[[\\\"[[\",\n[[[", "--limit nesting=3"), nested);
    // At the limit it is the form that is wrong.
    assert!(
        refused(&deep(64), "").starts_with("data did not match any variant"),
        "{}",
        refused(&deep(64), "")
    );
    assert!(refused(&deep(120), "--limit nesting=120").starts_with("data did not match any variant"));
    let large = "larger than 20 bytes (the limit; --limit text=N raises it)";
    assert_eq!(refused(&format!("{{\"status\":{}\"unbounded\"}}", " ".repeat(20)), "--limit text=20"), large);
    let just = folder(&[("claim.json", "{\"status\":\"unbounded\"}")]);
    let path = Path::new(just.path()).join("claim.json");
    assert_eq!(boundfit(&format!("{STRIP} --claim {} --limit text=22", path.display())).status, 0);
}

#[test]
fn broken_files_are_refused_with_a_reason() {
    for (name, message) in [
        (
            "glpk-cut",
            "the file stops without its last line \"e o f\", which GLPK writes (was the file cut off?)",
        ),
        (
            "glpk-three-variables",
            "line 2: \"s bas 18446744073709551615 3 f f 1\": the file lists 0 rows (was the file cut off?)",
        ),
        (
            "highs-old",
            "this is the old style (-1) of HiGHS, without a status and names (expected write_solution_style 0, 1, 2, 3 or 4)",
        ),
        (
            "theta1-min-highs-cut",
            "line 7: \"# Columns 99999999999\": the file lists 1 column (was the file cut off?)",
        ),
        ("cplex-entities", "XML with DTD detected (expected a <CPLEXSolution>, as CPLEX writes it)"),
        (
            "cplex-without-value",
            "line 5: \"<variable name=\\\"theta2\\\" index=\\\"1\\\"/>\" (expected <variable name=... value=.../>, as CPLEX writes it)",
        ),
    ] {
        let path = format!("fixtures/solutions/bad/{name}.sol");
        let run = boundfit(&format!("{STRIP} --claim {path}"));
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{name}");
        assert_eq!(run.stderr, format!("error: {path}: {message}\n"), "{name}");
    }
}

#[test]
fn an_equation_is_one_row_of_a_file_and_two_sides_of_the_set() {
    const PLACE: &str = "fixtures/solutions/equation";
    let line = |claim: &str| {
        let fit = format!("check {PLACE}/readings.csv --x x --y y --eps 0.3 --where theta1+theta2=1.03");
        format!("{fit} --strict --claim {claim}")
    };
    // The row of the objective, which HiGHS adds in the style of GLPK, is the first one of a model in MPS and the last of others.
    for (solver, writer, status, last) in [
        // Fifteen digits of a number that is off by more than rounding.
        ("glpk-plain", "GLPK", 4, "loose"),
        ("highs-raw", "HiGHS", 0, "rounded"),
        ("highs-glpsol", "HiGHS", 0, "rounded"),
        ("highs-glpsol-mps", "HiGHS", 0, "rounded"),
    ] {
        let found = &claims(&line(&format!("{PLACE}/{solver}")), status)[0];
        assert_eq!(found["source"], format!("{writer}, {PLACE}/{solver}/*.sol"));
        assert_eq!(verdicts(found), ["rounded", "exact", "exact", last], "{solver}");
        for bound in found["bounds"].as_array().unwrap() {
            assert_eq!(bound["repairable"], true, "{solver}");
        }
    }
    // A digit that HiGHS does not print makes it a file of GLPK, whose numbers are finer.
    let text =
        solution("equation/highs-glpsol/theta1-min.sol").replace("0.0683333333333 0", "0.06833333333334 0");
    let finer = folder(&[("theta1-min.sol", &text)]);
    let found = &claims(&line(&format!("{}/theta1-min.sol", finer.path().display())), 4)[0];
    assert_eq!(verdicts(found)[0], "unsafe");
}
