//! `boundfit reduce`, and fits of what it writes.

use std::fs;
use std::path::Path;

use boundfit_tests::program::{Run, run, run_with_input};
use serde_json::Value;

use boundfit_tests::cli::directory_with;

const TABLE: &str = "time;x ;y;note\n1;0;0;a\n2;1.0;1e0;\"b; c\"\n3;2;2.5;d\n4;1.00;1/2;e\n5;3;3.00;f\n";

fn reduce(input: &str, more: &[&str]) -> Run {
    run_with_input(&[&["reduce", "-", "--x", "x", "--y", "y"], more].concat(), input.as_bytes())
}

#[test]
fn kept_rows_stand_as_they_were_written_under_their_header() {
    let run = reduce(TABLE, &[]);
    let expected = "# boundfit/reduced/1 {\"rows\":5,\"kept\":4,\"header\":true,\"reading\":\"decimal\",\"x\":\"x\",\
                    \"y\":\"y\",\"epsilon\":null,\"sums\":[\"7\",\"7\",\"15\",\"31/2\"]}\n\
                    time;x ;y;note\n1;0;0;a\n3;2;2.5;d\n4;1.00;1/2;e\n5;3;3.00;f\n";
    assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (0, expected, ""));
    // A reduction of a reduction is itself.
    assert_eq!(reduce(expected, &[]).stdout, expected);
}

#[test]
fn a_fit_of_the_reduction_says_what_a_fit_of_the_whole_says() {
    let directory = directory_with(&[("whole.csv", TABLE.as_bytes())]);
    let [whole, reduced] = ["whole.csv", "reduced.csv"].map(|name| directory.path().join(name));
    fs::write(&reduced, reduce(TABLE, &[]).stdout).unwrap();
    for epsilon in ["1/4", "0.4", "3"] {
        let [whole, reduced] = [&whole, &reduced].map(|file| fit(file, epsilon));
        for key in ["pui", "central", "epsilon_min", "tightness", "area_centroid"] {
            assert_eq!(without_rows(&whole[key]), without_rows(&reduced[key]), "{key} at {epsilon}");
        }
        let theta = |report: &Value| report["least_squares"]["theta"].clone();
        assert_eq!(theta(&whole), theta(&reduced));
        assert_eq!((&reduced["input"]["rows"], &reduced["input"]["rows_total"]), (&5.into(), &5.into()));
        assert!(reduced["eui"].is_null());
        let reason = "the data are a reduction, which does not have the x of every reading";
        assert_eq!(reduced["reasons"]["eui"], reason);
    }
}

fn fit(file: &Path, epsilon: &str) -> Value {
    let run =
        run(&["fit", file.to_str().unwrap(), "--x", "x", "--y", "y", "--eps", epsilon, "--format", "json"]);
    serde_json::from_str(&run.stdout).expect("a report")
}

fn without_rows(value: &Value) -> Value {
    match value {
        Value::Array(items) => items.iter().map(without_rows).collect(),
        Value::Object(entries) => {
            let others = entries.iter().filter(|(key, _)| *key != "row");
            others.map(|(key, value)| (key.clone(), without_rows(value))).collect()
        }
        other => other.clone(),
    }
}

#[test]
fn rows_are_compared_with_those_of_the_same_error_bound() {
    let table = "x,y,e\n0,0,1\n1,0,1\n2,0,1\n1,0.5,2\n1,9,1\n";
    let kept = |more: &[&str]| -> Vec<String> {
        reduce(table, more).stdout.lines().skip(2).map(str::to_owned).collect()
    };
    assert_eq!(kept(&["--eps-column", "e"]), ["0,0,1", "1,0,1", "2,0,1", "1,0.5,2", "1,9,1"]);
    assert_eq!(kept(&[]), ["0,0,1", "1,0,1", "2,0,1", "1,9,1"]);
}

#[test]
fn what_does_not_belong_together_is_refused() {
    let one = reduce("x,y\n0,0\n1,1\n", &[]).stdout;
    let other = reduce("x,z,y\n0,0,5\n1,1,5\n", &[]).stdout;
    let binary = reduce("x,y\n0,0\n1,1\n", &["--reading", "binary64"]).stdout;
    let cut = one.trim_end().rsplit_once('\n').unwrap().0.to_owned() + "\n";
    let cases = [
        (
            format!("{one}{other}"),
            "line 6: the reduction from line 5 on differs from the first one in its header",
        ),
        (format!("{one}{binary}"), "differs from the first one in the reading of numbers"),
        (format!("{one}9,9\n"), "the reduction from line 1 on announces 2 lines of readings, but 3 follow"),
        (cut.clone(), "the reduction from line 1 on announces 2 lines of readings, but 1 follow"),
        (format!("{cut}{one}"), "the reduction from line 1 on announces 2 lines of readings, but 1 follow"),
        (binary, "the reduction is about the reading binary64, not decimal"),
        (one.replace("rows\":2", "rows\":-2"), "the line in front of a reduction is not understood"),
        (
            one.replace("\"1\"", "\"1e5\""),
            "a sum in the line in front of a reduction: exponent beyond 0 (the limit) at character 3\n",
        ),
    ];
    for (input, message) in cases {
        let run = reduce(&input, &[]);
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{input}");
        assert!(run.stderr.contains(message), "{input}\n{}", run.stderr);
    }
    let fits = [
        ("fit - --x y --y x --eps 1", "the reduction is about the column of x x, not y"),
        ("fit - --x x --y y --eps-column x", "error bounds from one bound for all readings, not x"),
        ("fit - --x x --y y --eps 10%*|y|", "error bounds from one bound for all readings, not 10%*|y|"),
        ("fit - --x x --y y --eps 1 --rows 1..2", "no rows of a reduction can be picked"),
        ("fit - --x x,y --y y --eps 1", "the reduction is about the model a line, not two regressors"),
        ("lesson - --x x --y y --eps 1", "this is a reduction, and here every reading is wanted"),
        ("fit - --x x --y y --eps 1 --by x", "this is a reduction, and here every reading is wanted"),
    ];
    for (line, message) in fits {
        let run = run_with_input(&line.split(' ').collect::<Vec<_>>(), one.as_bytes());
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{line}");
        assert!(run.stderr.contains(message), "{line}\n{}", run.stderr);
    }
}

#[test]
fn what_needs_the_set_alone_reads_reductions_too() {
    let row = |k: i64| format!("{k},{}\n", 3 * k + k * k % 17);
    let table = format!("x,y\n{}", (0..300).map(row).collect::<String>());
    let directory = boundfit_tests::cli::directory_with(&[("data.csv", table.as_bytes())]);
    let run = |line: &str| boundfit_tests::cli::boundfit(directory.path(), line);
    assert_eq!(run("reduce data.csv --x x --y y -o reduced.csv").status, 0);
    let judged = |file: &str| {
        let line = format!("check {file} --x x --y y --eps 20 --solver microlp --format json");
        let mut report: serde_json::Value = serde_json::from_str(&run(&line).stdout).unwrap();
        // The rows of a reduction are counted anew.
        for bound in report["claims"][0]["bounds"].as_array_mut().unwrap() {
            bound["row"].take();
        }
        report["input"]["file"].take();
        report
    };
    assert_eq!(judged("reduced.csv"), judged("data.csv"));
    let picture = run("plot reduced.csv --x x --y y --eps 20 --figure fps");
    assert_eq!((picture.status, picture.stderr.as_str()), (0, ""));
    let program = run("convert reduced.csv --x x --y y --eps 20 --to lp --objective theta1-min").stdout;
    assert!(program.contains("data: reduced.csv, the rows that a reduction keeps"), "{program}");
    for figure in ["data", "eui", "pui", "corridor", "directions"] {
        let run = run(&format!("plot reduced.csv --x x --y y --eps 20 --figure {figure}"));
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{figure}");
    }
}
