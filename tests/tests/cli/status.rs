//! `boundfit status`: formats, further readings, streams, refusals.

use std::fmt::Write;

use boundfit_exact::Rational;
use boundfit_tests::cli::{boundfit, directory_with};
use boundfit_tests::program::Run;
use serde_json::Value;

const TABLE: &str = "x,y,lo,up\n0,0,-1,1\n1,1,0,\n2,2,,3\n3,9,8,10\n";

fn run(table: &str, options: &str) -> Run {
    let directory = directory_with(&[("data.csv", table.as_bytes()), ("new.csv", b"x,y\n0,1\n1,50\n9,1\n")]);
    boundfit(directory.path(), &format!("status data.csv {options}"))
}

fn refused(table: &str, options: &str, status: i32) -> String {
    let run = run(table, options);
    assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{options}: {run:?}");
    run.stderr.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}

fn json(table: &str, options: &str, status: i32) -> Value {
    let run = run(table, &format!("{options} --format json"));
    assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{options}");
    serde_json::from_str(&run.stdout).unwrap()
}

/// Returns one text for each row.
fn column(json: &Value, part: &str, key: &str) -> Vec<String> {
    let text = |row: &Value| row[key].as_str().unwrap_or("null").to_owned();
    json.pointer(part).and_then(Value::as_array).unwrap().iter().map(text).collect()
}

#[test]
fn of_an_empty_set_the_readings_that_alone_can_go_are_outliers() {
    let found = json(TABLE, "--x x --y y --eps 1", 3);
    assert_eq!(found["set"]["kind"], "empty");
    assert_eq!(column(&found, "/rows", "status"), ["null"; 4]);
    assert_eq!(column(&found, "/rows", "without"), ["null", "null", "outlier", "outlier"]);
    assert_eq!(found["rows"][3]["without_residual"]["exact"], "6");
    let text = run(TABLE, "--x x --y y --eps 1").stdout;
    assert!(text.contains("Without any one of the readings below the set is not empty"), "{text}");
    assert!(!text.contains("\n  1  "), "{text}");
    // Where two are wrong, none alone can go.
    let found = json("x,y\n0,0\n1,9\n2,0\n3,9\n4,0\n", "--x x --y y --eps 1", 3);
    assert_eq!(column(&found, "/rows", "without"), ["null"; 5]);
}

#[test]
fn further_readings_have_all_five_statuses_and_change_nothing() {
    let alone = json(TABLE, "--x x --y y --eps 3", 0);
    let found = json(TABLE, "--x x --y y --eps 3 --rows 1..4 --new new.csv", 0);
    assert_eq!(found["rows"], alone["rows"]);
    assert_eq!(column(&found, "/new/rows", "status"), ["outer", "outlier", "outlier"]);
    assert_eq!(found["new"]["file"], "new.csv");
    let csv = run(TABLE, "--x x --y y --eps 3 --new new.csv --format csv").stdout;
    assert_eq!(csv.lines().filter(|line| line.starts_with("new,")).count(), 3, "{csv}");
    assert_eq!(csv.lines().nth(6).unwrap().split(',').nth(2), Some("outlier"), "{csv}");
    let text = run(TABLE, "--x x --y y --eps 3 --new new.csv").stdout;
    assert!(text.contains("Further readings, new.csv"), "{text}");
    // Against an empty set nothing can be said.
    let empty = json(TABLE, "--x x --y y --eps 1 --new new.csv", 3);
    assert_eq!(column(&empty, "/new/rows", "status"), ["null"; 3]);
}

#[test]
fn readings_with_one_bound_are_judged_by_it_alone() {
    let found = json(TABLE, "--x x --lower lo --upper up --rows 1..3", 0);
    assert_eq!(column(&found, "/rows", "leverage"), ["null"; 3]);
    assert_eq!(column(&found, "/rows", "status"), ["boundary"; 3]);
    assert_eq!(column(&found, "/rows", "without"), ["strictly outer", "outer", "outer"]);
}

#[test]
fn a_duplicate_says_the_same() {
    let found = json("x,y\n0,0\n0,0\n1,1\n2,0\n", "--x x --y y --eps 1/2", 0);
    assert_eq!(column(&found, "/rows", "without")[..2], ["boundary", "boundary"]);
}

#[test]
fn repair_says_what_cannot_be_widened() {
    let found =
        json("x,y\n0,0\n1,9\n", "--x x --y y --eps 1 --where 'theta1 = 0' --where 'theta1 >= 1' --repair", 3);
    assert_eq!(found["repair"]["total"], Value::Null);
    assert_eq!(found["repair"]["contradiction"].as_array().unwrap().len(), 2);
    let text = run("x,y\n0,0\n0,9\n", "--x x --y y --eps 0 --repair").stdout;
    assert!(text.contains("No widening helps: what has no width to grow contradicts itself"), "{text}");
    let text = run(TABLE, "--x x --y y --eps 9 --repair").stdout;
    assert!(text.contains("No bound has to be wider."), "{text}");
    let found = json("x,y\n0,0\n0,3\n0,1\n", "--x x --y y --eps 1 --repair", 3);
    assert_eq!(found["repair"]["total"]["exact"], "4");
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let options = "--x x --y y --eps 1";
    for (more, message) in [
        (
            "--repair --format csv",
            "'--repair' needs another format than csv, which has a row for each reading and no room for it",
        ),
        (
            "--all --format json",
            "'--all' needs the format text, latex or markdown; other formats list every reading anyway",
        ),
    ] {
        assert_eq!(refused(TABLE, &format!("{options} {more}"), 2), message);
    }
    let own = "--x x --y y --eps '1%*|y| + 1%*range(y) + 3' --new new.csv";
    assert!(
        refused(TABLE, own, 2).starts_with("'--new' is about readings with bounds of their own, and a law")
    );
    assert!(refused(TABLE, &format!("{options} --new none.csv"), 1).starts_with("none.csv: "));
    assert!(refused(TABLE, &format!("{options} -o out.png"), 2).contains("this command writes no .png"));
    let directory = directory_with(&[("data.csv", TABLE.as_bytes())]);
    let both = boundfit(directory.path(), &format!("status - {options} --new -"));
    assert!(both.stderr.contains("DATA and '--new' would both be read from standard input"), "{both:?}");
    boundfit(directory.path(), "reduce data.csv --x x --y y -o small.csv");
    let reduced = boundfit(directory.path(), &format!("status small.csv {options}"));
    assert_eq!(reduced.status, 2);
    assert!(
        reduced.stderr.contains("'status' is about every reading, and the data are a reduction"),
        "{reduced:?}"
    );
}

#[test]
fn the_proof_is_verified() {
    let directory = directory_with(&[("data.csv", TABLE.as_bytes())]);
    for (options, status) in [
        ("--x x --y y --eps 3", 0),
        ("--x x --y y --eps 1", 3),
        ("--x x --lower lo --upper up --rows 1..3", 0),
        ("--x x --y y --eps 1 --rows 1..1", 0),
        ("--x x --y y --eps 3 --where 'theta1 <= 2' --format json -o out.json", 0),
        ("--x x,y --y up --eps 3 --missing skip --format csv -o out.csv", 0),
    ] {
        let made = boundfit(directory.path(), &format!("status data.csv {options} --proof proof.json"));
        let note =
            if options.contains("csv") { "note: data.csv: 1 row with missing values left out\n" } else { "" };
        assert_eq!((made.status, made.stderr.as_str()), (status, note), "{options}");
        let verified = boundfit(directory.path(), "verify proof.json data.csv");
        assert_eq!(verified.status, 0, "{options}: {verified:?}");
        let proof = std::fs::read_to_string(directory.path().join("proof.json")).unwrap();
        assert!(proof.contains("boundfit/proof/2"), "{options}");
    }
}

/// More readings than are kept, one of them far out, one twice.
fn large() -> String {
    let mut table = "x,y\n".to_owned();
    for row in 0..12_000_i64 {
        let noise = (row * 7919 + row * row * 31) % 1999 - 999;
        let y = match row {
            7000 => 30_000_000,
            7001 => row * 3000 + 1100,
            row => row * 3000 + noise,
        };
        writeln!(table, "{row},{}", Rational::ratio(y, 1000)).unwrap();
    }
    table
}

#[test]
fn streams_say_what_is_said_of_readings_in_memory() {
    let table = large();
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    for (bound, status) in
        [("--eps 2", 3), ("--eps 1.2 --without 7001", 0), ("--eps '1.2 + 0.1%*|x|' --without 7001", 0)]
    {
        for format in ["json", "csv", "text"] {
            let options = format!("--x x --y y {bound} --format {format}");
            let streamed = boundfit(directory.path(), &format!("status data.csv {options}"));
            assert_eq!((streamed.status, streamed.stderr.as_str()), (status, ""), "{options}");
            let held = boundfit_tests::cli::boundfit_with_input(
                directory.path(),
                &format!("status - {options}"),
                table.as_bytes(),
            );
            let named = |text: &str| {
                text.replace("\"file\": null", "\"file\": \"data.csv\"").replace("standard input", "data.csv")
            };
            assert!(
                named(&held.stdout) == streamed.stdout,
                "{options}: {} {}",
                held.stdout.len(),
                streamed.stdout.len()
            );
        }
    }
}
