//! `boundfit predict`: values, sources, laws, files of values, proofs, refusals.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use boundfit_exact::Rational;
use boundfit_tests::cli::numbers::{check_numbers, exact, exact_or_null};
use boundfit_tests::cli::refusals::refuses;
use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, unbroken};
use boundfit_tests::program::root;
use serde_json::{Value, json};

const PREDICT: &str = "predict fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3";

fn report(directory: &Path, line: &str, status: i32) -> Value {
    let run = boundfit(directory, &format!("{line} --format json"));
    assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{line}");
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(report["schema"], "boundfit/predict/1");
    report
}

/// The ends of an interval of the report, as they are written exactly.
fn ends(interval: &Value) -> [String; 2] {
    ["lower", "upper"].map(|end| interval[end]["exact"].as_str().unwrap_or("null").to_owned())
}

#[test]
fn the_line_of_the_transducer() {
    let report = report(&root(), &format!("{PREDICT} --at 3.7,0 --from 0.012"), 0);
    let at = &report["at"][0];
    assert_eq!(at["x"]["exact"], "37/10");
    assert_eq!(ends(&at["line"]), ["648589/22154000", "6511179/220594000"]);
    let half = Rational::ratio(1, 2000);
    for (end, sign) in [("lower", -1), ("upper", 1)] {
        assert_eq!(exact(&at["reading"][end]), exact(&at["line"][end]) + &half * Rational::from(sign));
    }
    // At 0 the line is θ2, whose interval the fit has.
    assert_eq!(ends(&report["at"][1]["line"]), ["500589/22154000", "5031179/220594000"]);
    assert_eq!(report["from"][0]["x"].as_array().unwrap().len(), 1);
    assert_eq!(ends(&report["from"][0]["x"][0]), ["-1312429/210000", "-10929/2000"]);
    assert!(check_numbers(&report, 5) > 30);
}

#[test]
fn every_end_has_a_vertex_that_reaches_it() {
    let report = report(&root(), &format!("{PREDICT} --grid -6..6/6 --from 0.01,0.03"), 0);
    let at = report["at"].as_array().unwrap();
    assert_eq!(at.len(), 7);
    for own in at {
        for end in ["lower", "upper"] {
            let proof = &own["proof"][end];
            let [theta1, theta2] = [0, 1].map(|axis| exact(&proof["theta"][axis]));
            assert_eq!(theta1 * exact(&own["x"]) + theta2, exact(&own["line"][end]));
            assert_eq!(proof["active"].as_array().unwrap().len(), 2);
        }
    }
    for own in report["from"].as_array().unwrap() {
        for (end, line, sign) in [("lower", "upper", -1), ("upper", "lower", 1)] {
            let source = &own["x"][0];
            let proof = &source["proof"][end];
            assert_eq!(proof["line"], line);
            let [theta1, theta2] = [0, 1].map(|axis| exact(&proof["theta"][axis]));
            let reached = exact(&own["y"]) + Rational::ratio(sign, 2000);
            assert_eq!(theta1 * exact(&source[end]) + theta2, reached);
        }
    }
}

#[test]
fn another_origin_changes_no_prediction() {
    let origin = format!("{PREDICT} --x-origin -3 --at 3.7 --from 0.012");
    let [moved, plain] =
        [origin.as_str(), &format!("{PREDICT} --at 3.7 --from 0.012")].map(|line| report(&root(), line, 0));
    assert_eq!(moved["at"][0]["x"], plain["at"][0]["x"]);
    assert_eq!(moved["at"][0]["line"], plain["at"][0]["line"]);
    let strip = |report: &Value| ends(&report["from"][0]["x"][0]);
    assert_eq!(strip(&moved), strip(&plain));
}

#[test]
fn sets_without_end_predict_without_end() {
    let directory = directory_with(&[("one.csv", b"x,y\n1,0\n"), ("two.csv", b"x,y\n0,0\n1,0\n")]);
    let one = report(directory.path(), "predict one.csv --x x --y y --eps 1 --at 1,2 --from 10,2", 0);
    assert_eq!(ends(&one["at"][0]["line"]), ["-1", "1"]);
    assert_eq!(ends(&one["at"][1]["line"]), ["null", "null"]);
    assert!(one["at"][1]["proof"]["upper"]["ray"].is_array());
    let x = &one["from"][0]["x"];
    assert_eq!((ends(&x[0]), ends(&x[1])), (["null".into(), "1".into()], ["1".into(), "null".into()]));
    assert_eq!((&x[0]["upper_included"], &x[0]["lower_included"]), (&json!(false), &Value::Null));
    assert_eq!(ends(&one["from"][1]["x"][0]), ["null", "null"]);
    // Slopes of both signs: left and right, and in between where only small readings are possible.
    let two = report(directory.path(), "predict two.csv --x x --y y --eps 1 --new-eps 0 --from 2,0", 0);
    assert_eq!(two["from"][0]["x"].as_array().unwrap().len(), 2);
    assert_eq!(two["from"][1]["x"].as_array().unwrap().len(), 1);
    let text = unbroken(&boundfit(directory.path(), "predict one.csv --x x --y y --eps 1 --from 10").stdout);
    assert!(text.contains("10 (-inf, 1) or (1, inf)"), "{text}");
}

#[test]
fn an_empty_set_predicts_nothing() {
    let directory = directory_with(&[("empty.csv", b"x,y\n1,0\n1,5\n")]);
    let line = "predict empty.csv --x x --y y --eps 1 --at 1 --from 2";
    let found = report(directory.path(), line, 3);
    assert_eq!((&found["at"], &found["from"]), (&json!([]), &json!([])));
    assert_eq!(found["fps"]["certificate"]["farkas"].as_array().unwrap().len(), 2);
    assert_eq!(found["reasons"]["at"], "the FPS is empty");
    let run = boundfit(directory.path(), line);
    assert_eq!(run.status, 3);
    let text = unbroken(&run.stdout);
    assert!(text.contains("These contradict each other: 1 upper, 2 lower."), "{text}");
    let csv = boundfit(directory.path(), "predict empty.csv --x x --y y --eps 1 --at 1 --format csv");
    assert_eq!((csv.status, csv.stdout.lines().count()), (3, 1));
}

#[test]
fn a_law_is_taken_where_it_is_asked() {
    let directory = directory_with(&[("line.csv", b"x,y\n-1,-1\n0,0\n1,1\n2,2\n")]);
    let line = "predict line.csv --x x --y y --at -2,4";
    let of_x = report(directory.path(), &format!("{line} --eps 0 --new-eps '1/2*|x| + 1'"), 0);
    assert_eq!(ends(&of_x["at"][0]["reading"]), ["-4", "0"]);
    assert_eq!(ends(&of_x["at"][1]["reading"]), ["1", "7"]);
    // y - 1/2·|y| = 4 at 8, y + 1/2·|y| = 4 at 8/3.
    let of_y = report(directory.path(), &format!("{line} --eps 0 --new-eps '50%*|y|'"), 0);
    assert_eq!(ends(&of_y["at"][1]["reading"]), ["8/3", "8"]);
    assert_eq!(ends(&of_y["at"][0]["reading"]), ["-4", "-4/3"]);
    let sides = report(directory.path(), &format!("{line} --eps 0 --new-eps +1/-2 --from 4"), 0);
    // The truth is at most 1 above a reading: the reading is at most 1 below, and 2 above.
    assert_eq!(ends(&sides["at"][1]["reading"]), ["3", "6"]);
    assert_eq!(ends(&sides["from"][0]["x"][0]), ["2", "5"]);
    let origin = report(directory.path(), &format!("{line} --eps 0 --x-origin 1 --new-eps '|x|'"), 0);
    assert_eq!(ends(&origin["at"][1]["reading"]), ["0", "8"]);
    let own = report(directory.path(), &format!("{line} --eps '1/2*|x|'"), 0);
    let [line_at_4, reading] = ["line", "reading"].map(|part| own["at"][1][part]["upper"].clone());
    assert_eq!(exact(&reading), exact(&line_at_4) + Rational::from(2));
    let written = report(directory.path(), &format!("{line} --eps written"), 0);
    assert_eq!(written["at"][0]["reading"], Value::Null);
    assert!(written["reasons"]["reading"].as_str().unwrap().contains("last digit"));
}

#[test]
fn rows_with_bounds_of_their_own_say_nothing_of_a_further_reading() {
    let line = "predict fixtures/clock/offset.csv --x t --lower at_least --upper at_most --at 1";
    let plain = report(&root(), line, 0);
    assert_eq!((&plain["at"][0]["reading"], &plain["new_reading"]), (&Value::Null, &Value::Null));
    let given = report(&root(), &format!("{line} --new-eps 1/3 --from 1000"), 0);
    let third = Rational::ratio(1, 3);
    assert_eq!(exact(&given["at"][0]["reading"]["upper"]), exact(&plain["at"][0]["line"]["upper"]) + third);
    assert_eq!(given["new_reading"]["given"], true);
}

#[test]
fn two_regressors_are_asked_for_pairs() {
    let directory = directory_with(&[("two.csv", b"a,b,y\n1,0,1\n0,1,2\n")]);
    let line = "predict two.csv --x a,b --y y --eps 1";
    let report = report(directory.path(), &format!("{line} --at '1;1,0;3' --at 'two.csv:a;b'"), 0);
    let found: Vec<[String; 2]> =
        report["at"].as_array().unwrap().iter().map(|own| ends(&own["line"])).collect();
    assert_eq!(found, [["1", "5"], ["3", "9"], ["0", "2"], ["1", "3"]]);
    assert_eq!(report["at"][0]["x"].as_array().unwrap().len(), 2);
    let only = "is about a line: with two regressors there is no single x (ask '--at' for pairs)";
    refuses(directory.path(), &format!("{line} --from 2"), 2, &format!("'--from' {only}"));
    refuses(directory.path(), &format!("{line} --grid 0..1/2"), 2, &format!("'--grid' {only}"));
}

#[test]
fn a_column_of_values_gives_what_each_gives() {
    let mut column = String::from("when;what\n");
    let values: Vec<String> = (0..3_000).map(|k| format!("{}.{}", k % 97 - 40, k % 10)).collect();
    values.iter().for_each(|value| writeln!(column, "{value};0.0{}", value.len()).unwrap());
    let directory = directory_with(&[("new.csv", column.as_bytes())]);
    let data = root().join("fixtures/transducer/transducer.csv");
    let plain = format!("predict '{}' --x Vz --y z --rows 14..36 --eps 0.5e-3", data.display());
    let line = format!("{plain} --format csv");
    let read = boundfit(directory.path(), &format!("{line} --at new.csv:when"));
    let given = boundfit(directory.path(), &format!("{line} --at {}", values.join(",")));
    assert_eq!((read.status, read.stdout.lines().count()), (0, 3_001));
    assert!(read.stdout == given.stdout);
    let from = boundfit(directory.path(), &format!("{line} --from new.csv:what"));
    assert_eq!((from.status, from.stderr.as_str()), (0, ""));
    assert_eq!(from.stdout.lines().count(), 3_001);
    let text = unbroken(&boundfit(directory.path(), &format!("{plain} --at new.csv:when")).stdout);
    assert!(text.contains("And 2960 values more, which CSV and JSON have."), "{text}");
    let over = boundfit(directory.path(), &format!("{plain} --at new.csv:when --force -o new.csv"));
    assert_eq!(
        (over.status, over.stderr.as_str()),
        (1, "error: new.csv: not written: it is new.csv, which is read\n")
    );
}

#[test]
fn proofs_of_predictions_are_true_of_the_data() {
    let directory = directory_with(&[("empty.csv", b"x,y\n1,0\n1,5\n"), ("one.csv", b"x,y\n1,0\n")]);
    let data = root().join("fixtures/transducer/transducer.csv");
    fs::copy(data, directory.path().join("transducer.csv")).unwrap();
    for (file, options, status) in [
        ("transducer.csv", "--x Vz --y z --rows 14..36 --eps 0.5e-3 --at 3.7,-2 --from 0.012", 0),
        ("transducer.csv", "--x Vz --y z --rows 14..36 --eps '1%*|y| + 3e-4' --x-origin 2 --grid 0..1/3", 0),
        ("one.csv", "--x x --y y --eps 1 --at 1,2 --from 10", 0),
        ("empty.csv", "--x x --y y --eps 1 --at 1", 3),
    ] {
        let run =
            boundfit(directory.path(), &format!("predict {file} {options} --proof proof.json -o out.txt"));
        assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{file} {options}");
        let verified = boundfit(directory.path(), &format!("verify proof.json {file}"));
        assert_eq!((verified.status, verified.stderr.as_str()), (0, ""), "{file} {options}");
    }
}

#[test]
fn bad_usage_is_refused() {
    let one = "expected numbers such as 3.7,9/2, or FILE:COL";
    let grid = "expected FROM..TO/N with FROM < TO and N steps between them, such as 0..10/100";
    let at = |value: &str, problem: &str| {
        format!("invalid value '{value}' for '--at <X,...|FILE:COL>': {problem}")
    };
    let on_grid =
        |value: &str, problem: &str| format!("invalid value '{value}' for '--grid <FROM..TO/N>': {problem}");
    let law =
        |value: &str, problem: &str| format!("invalid value '{value}' for '--new-eps <NUM>': {problem}");
    let cases = [
        ("--at x", at("x", &format!("not a number: unexpected character 'x' at character 1 ({one})"))),
        ("--at '1;2'", at("1;2", one)),
        ("--at :x", at(":x", one)),
        ("--at f:", at("f:", one)),
        (
            "--at 1e99999999",
            at(
                "1e99999999",
                "refused: exponent beyond 10000 (the limit) at character 3; --limit exponent=N raises it",
            ),
        ),
        ("--grid 0..1", on_grid("0..1", grid)),
        ("--grid 1..0/4", on_grid("1..0/4", grid)),
        ("--grid 0..1/0", on_grid("0..1/0", grid)),
        (
            "--grid 0..1/99999999",
            on_grid("0..1/99999999", "refused: more than 100000 values (expected fewer, or FILE:COL)"),
        ),
        (
            "--at 1 --new-eps min",
            law(
                "min",
                "a multiple of the least bound says nothing of a further reading (expected a number such as 0.5, or a law)",
            ),
        ),
        (
            "--at 1 --new-eps written",
            law(
                "written",
                "the law asks for the last digit written, and a further reading is not written yet (expected a number such as 0.5)",
            ),
        ),
        (
            "--at 1 --new-eps '2*|y|'",
            law(
                "2*|y|",
                "the law allows errors of 100 % of |y| or more, which bounds no further reading (expected a number such as 0.5)",
            ),
        ),
    ];
    for (options, message) in cases {
        refuses(&root(), &format!("{PREDICT} {options}"), 2, &message);
    }
    refuses(
        &root(),
        &format!("{PREDICT} --at no.csv:x"),
        1,
        "no.csv: cannot read: No such file or directory (os error 2)",
    );
    refuses(
        &root(),
        "predict fixtures/clock/offset.csv --x t --lower at_least --upper at_most --from 1",
        2,
        "'--from' needs the error bound of the reading, but the readings are intervals, and nothing says how wide a further one is; \
         state it with '--new-eps'",
    );
    let both = boundfit(&root(), &format!("{PREDICT} --at 1 --from 2 --format csv"));
    assert!(both.stderr.starts_with("error: '--format csv' writes one table"), "{}", both.stderr);
    let proofs = boundfit(&root(), &format!("{PREDICT} --at 1 --proofs --format json"));
    assert!(
        proofs.stderr.starts_with("error: '--proofs' needs the format text, latex or markdown"),
        "{}",
        proofs.stderr
    );
    let input = boundfit(&root(), "predict - --x x --y y --eps 1 --at -:x");
    assert!(input.stderr.starts_with("error: standard input is read once"), "{}", input.stderr);
    let one = boundfit(&root(), &format!("{PREDICT} --at 1 --proof -"));
    assert!(one.stderr.starts_with("error: '--proof -' and the report would both go"), "{}", one.stderr);
}

/// Rounded to nearest, 2.5882 is no x at which the line is at least 5.
#[test]
fn proofs_are_true_at_the_x_that_they_show() {
    let proofs = |table: &[u8], line: &str| {
        let text = boundfit_with_input(&root(), &format!("predict - {line} --proofs"), table).stdout;
        unbroken(text.split_once("(row and bound)\n").unwrap().1)
    };
    let asymmetric = proofs(b"x,y\n1,1.50\n2,2.5\n3,3.500\n4,1e1\n", "--x x --y y --eps +3/-1 --from 2");
    assert_eq!(
        asymmetric,
        "at 0.8 <= 1 (2.5, -1) 16/5 * (3 upper) + 11/5 * (4 lower) \
         at 2.5883 >= 5 (2.8333, -2.3333) 8/17 * (1 lower) + 9/17 * (4 lower)"
    );
    // Beside 1/3 nothing bounds the line.
    let single = proofs(b"x,y\n1/3,0\n", "--x x --y y --eps 1 --from 10");
    assert_eq!(single, "at 1/3 <= 1 (0.3, 0.9) 1 * (1 upper)");
    let seconds = b"t,y\n1764288000,5\n1764288600,5.6\n1764289800,6.8\n";
    assert_eq!(
        proofs(seconds, "--x t --y y --eps 0.01 --from 6"),
        "at 1.76428898e9 <= 5.99 (0.001, -1764282.99) 41/90 * (1 upper) + 49/90 * (3 upper) \
         at 1.76428902e9 >= 6.01 (0.001, -1764283.01) 13/30 * (1 lower) + 17/30 * (3 lower)"
    );
}

#[test]
fn every_format_is_written_and_recognised_as_ours() {
    let directory = directory_with(&[("two.csv", b"a,b,y\n1,0,1\n0,1,2\n")]);
    let lines = [
        "predict two.csv --x a --y y --eps 1 --at 1",
        "predict two.csv --x a --y y --eps 1 --from 1",
        "predict two.csv --x a,b --y y --eps 1 --at '1;2'",
    ];
    for (number, line) in lines.iter().enumerate() {
        for ending in ["txt", "json", "csv", "md", "tex"] {
            for _ in 0..2 {
                let run = boundfit(directory.path(), &format!("{line} -o out{number}.{ending}"));
                assert_eq!(
                    (run.status, run.stdout.as_str(), run.stderr.as_str()),
                    (0, "", ""),
                    "{line} {ending}"
                );
            }
        }
    }
    let csv = fs::read_to_string(directory.path().join("out0.csv")).unwrap();
    assert_eq!(csv.lines().nth(1), Some("1.0,0.0,2.0,-1.0,3.0,1,0,2,-1,3"));
    assert!(exact_or_null(&Value::Null).is_none());
}
