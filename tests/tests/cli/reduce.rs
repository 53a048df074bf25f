//! `boundfit reduce`, and fits of what it writes.

use std::fs;
use std::path::Path;

use boundfit_tests::program::{Run, run, run_with_input};
use serde_json::Value;

use boundfit_tests::cli::{boundfit, directory_with};

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
        ("fit - --x y --y x --eps 1", "the column of x in the reduction is \"x\", not \"y\""),
        ("fit - --x x --y y --eps-column x", "error bounds from one bound for all readings, not x"),
        ("fit - --x x --y y --eps 10%*|y|", "error bounds from one bound for all readings, not \"10%*|y|\""),
        ("fit - --x x --y y --eps 1 --rows 1..2", "no rows of a reduction can be picked"),
        ("fit - --x x,y --y y --eps 1", "the model of the reduction is a line, not two regressors"),
        ("lesson - --x x --y y --eps 1", "this is a reduction, and here every reading is wanted"),
        ("fit - --x x --y y --eps 1 --by x", "this is a reduction, and here every reading is wanted"),
    ];
    for (line, message) in fits {
        let run = run_with_input(&line.split(' ').collect::<Vec<_>>(), one.as_bytes());
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{line}");
        assert!(run.stderr.contains(message), "{line}\n{}", run.stderr);
    }
}

/// 300 rows with two regressors, y, and bounds of which some are missing.
/// Each row of a reduction decides, so that no option may pass over one.
#[test]
fn no_row_of_a_reduction_is_left_out() {
    let table = b"n,x,y,e\n!a,0,0,9\nb,1,5,9\nc,2,2,9\n!d,3,3,9\ne,4,-4,9\n";
    let directory = directory_with(&[("t.csv", table)]);
    let run = |arguments: &str| boundfit(directory.path(), arguments);
    let columns = "--x x --y y --eps-column e";
    assert_eq!(run(&format!("reduce t.csv {columns} -o r.csv")).status, 0);
    for more in ["--comment ! --brief", "--skip-lines 1", "--missing-as=-4 --missing skip"] {
        let refused = run(&format!("fit r.csv {columns} {more}"));
        assert_eq!(refused.status, 1, "{more}: {}", refused.stderr);
        assert!(
            refused.stderr.contains("no row of a reduction can be left out"),
            "{more}: {}",
            refused.stderr
        );
    }
    assert_eq!(run(&format!("fit r.csv {columns} --missing-as=-99 --missing skip")).status, 0);
}

fn readings() -> String {
    let row = |k: i64| {
        let (u, v) = (k * 37 % 101 - 50, k * 53 % 89 - 44);
        let y = 2 * u - v + k % 7;
        let side = |there: bool, value: i64| if there { value.to_string() } else { String::new() };
        format!("{u},{v},{y},{},{},{y}.5\n", side(k % 5 > 0, y - 9), side(k % 5 == 0 || k % 3 > 0, y + 8))
    };
    format!("u,v,y,lo,up,hi\n{}", (0..300).map(row).collect::<String>())
}

/// The tables that are reduced under fixed bounds.
const FIXED: [&str; 6] = [
    "--x u --y y --lower lo --upper up",
    "--x u,v --lower lo --upper up",
    "--x u --upper hi",
    "--x u,v --y y --eps 9/2",
    "--x u --y y --eps 5%*|y|+500",
    "--x u,v --y y --eps +10%*|y|+8/-9",
];

#[test]
fn reductions_under_fixed_bounds_are_fitted_judged_drawn_and_converted_like_the_whole() {
    let directory = directory_with(&[("whole.csv", readings().as_bytes())]);
    let run = |line: &str| boundfit_tests::cli::boundfit(directory.path(), line);
    for options in FIXED {
        assert_eq!(run(&format!("reduce whole.csv {options} -o reduced.csv --force")).status, 0, "{options}");
        let start = fs::read_to_string(directory.path().join("reduced.csv")).unwrap();
        assert!(start.starts_with("# boundfit/reduced/2 {\"rows\":300,\"kept\":"), "{start}");
        assert!(start.lines().count() < 40, "{start}");
        for more in ["", " --where 'theta1 <= 2'"] {
            let line = |file: &str| format!("fit {file} {options}{more} --format json");
            let [(status, whole), (own_status, reduced)] = ["whole.csv", "reduced.csv"].map(|file| {
                let run = run(&line(file));
                (run.status, serde_json::from_str::<Value>(&run.stdout).expect(&run.stderr))
            });
            assert_eq!(own_status, status, "{options}");
            for key in ["pui", "central", "tightness", "area_centroid"] {
                assert_eq!(without_rows(&whole[key]), without_rows(&reduced[key]), "{key} {options}{more}");
            }
            for key in ["kind", "area", "rays", "lines"] {
                assert_eq!(whole["fps"][key], reduced["fps"][key], "{key} {options}{more}");
            }
            assert_eq!(whole["least_squares"]["theta"], reduced["least_squares"]["theta"], "{options}{more}");
            assert_eq!(whole["least_squares"]["in_fps"], reduced["least_squares"]["in_fps"]);
            assert!(reduced["eui"].is_null() && reduced["epsilon_min"].is_null(), "{options}");
            let reason = match options.ends_with("--upper hi") {
                true => whole["reasons"]["minimax"].as_str().unwrap(),
                false => {
                    "the data are a reduction under bounds that are fixed, which does not say how other bounds would do"
                }
            };
            assert_eq!(reduced["reasons"]["minimax"], reason, "{options}");
        }
        let judged = |file: &str| {
            let line = format!("check {file} {options} --solver exact-simplex --format json");
            let mut report: Value = serde_json::from_str(&run(&line).stdout).unwrap();
            // A reduction does not know the format of the original table.
            ["file", "table"].iter().for_each(|part| drop(report["input"][*part].take()));
            // A small table is asked about all readings, a reduction about those that it kept.
            report["readings"]["asked"].take();
            without_rows(&report)
        };
        assert_eq!(judged("reduced.csv"), judged("whole.csv"), "{options}");
        for figure in ["data", "fps", "eui", "pui", "corridor", "directions"] {
            let run = run(&format!("plot reduced.csv {options} --figure {figure}"));
            assert_eq!(run.stderr, "", "{options} {figure}");
        }
        let program = run(&format!("convert reduced.csv {options} --to lp --objective theta1-min"));
        assert!(program.stdout.contains("data: reduced.csv, the rows that a reduction keeps"), "{options}");
    }
}

#[test]
fn what_fixed_bounds_do_not_serve_is_refused() {
    let directory = directory_with(&[("whole.csv", readings().as_bytes())]);
    let run = |line: &str| boundfit_tests::cli::boundfit(directory.path(), line);
    for (reduced, asked, status, message) in [
        (
            "--x u --lower lo --upper up",
            "fit F --x u --upper up",
            1,
            "error bounds from the columns lo and up, not the upper bounds up alone",
        ),
        (
            "--x u --upper hi",
            "fit F --x u --lower lo --upper hi",
            1,
            "error bounds from the upper bounds hi alone, not the columns lo and hi",
        ),
        (
            "--x u --lower lo --upper up",
            "fit F --x u --y y --lower lo --upper up",
            1,
            "the column of y in the reduction is none, not \"y\"",
        ),
        (
            "--x u --lower lo --upper up",
            "fit F --x u --y y --eps 3",
            1,
            "error bounds from the columns lo and up, not 3",
        ),
        (
            "--x u --lower lo --upper up",
            "fit F --x v --lower lo --upper up",
            1,
            "the column of x in the reduction is \"u\", not \"v\"",
        ),
        (
            "--x u --y y",
            "fit F --x u --lower lo --upper up",
            1,
            "error bounds from one bound for all readings, not the columns lo and up",
        ),
        (
            "--x u --y y",
            "reduce F --x u --lower lo",
            1,
            "error bounds from one bound for all readings, not the lower bounds lo alone",
        ),
        ("--x u,v --y y --eps 3", "fit F --x u,v --y y --eps 4", 1, "error bounds from 3, not 4"),
        (
            "--x u,v --y y --eps 3",
            "fit F --x v,u --y y --eps 3",
            1,
            "the first regressor of the reduction is \"u\", not \"v\"",
        ),
        (
            "--x u,v --y y --eps 3",
            "fit F --x u --y y --eps 3",
            1,
            "the model of the reduction is two regressors, not a line",
        ),
        (
            "--x u,v --y y --eps 3",
            "fit F --x u,v --y y --eps 3 --sweep 1..2",
            2,
            "'--sweep' moves the error bounds, and the data are a reduction",
        ),
        (
            "--x u,v --y y --eps 3",
            "fit F --x u,v --y y --eps min",
            2,
            "'--eps' asks for a multiple of eps_min, which moves the error bounds, and the data are a reduction",
        ),
        (
            "--x u,v --y y --eps 3",
            "lesson F --x u,v --y y --eps 3",
            1,
            "this is a reduction, and here every reading is wanted",
        ),
        (
            "--x u,v --y y --eps 5%*|y|",
            "fit F --x u,v --y y --eps 6%*|y|",
            1,
            "error bounds from 1/20*|y|, not \"6%*|y|\"",
        ),
        (
            "--x u --y y --eps +1/-5%*|x|",
            "fit F --x u --y y --eps 1",
            1,
            "error bounds from +(1) -(1/20*|x|), not 1",
        ),
    ] {
        assert_eq!(run(&format!("reduce whole.csv {reduced} -o F --force")).status, 0, "{reduced}");
        let run = run(asked);
        assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{asked}");
        assert!(run.stderr.contains(message), "{asked}\n{}", run.stderr);
    }
    // One way or another, the law is the same.
    assert_eq!(run("reduce whole.csv --x u --y y --eps 5%*|y|+500 -o F --force").status, 0);
    assert_eq!(run("fit F --x u --y y --eps '250 + 0.05*|y| + 250' --no-lp").status, 0);
    for (line, status, message) in [
        (
            "reduce whole.csv --x u,v --y y",
            2,
            "which readings of two regressors decide depends on their bounds",
        ),
        (
            "reduce whole.csv --x u,v --y y --eps min",
            2,
            "which readings of two regressors decide depends on their bounds",
        ),
        (
            "reduce whole.csv --x u,v --y y --eps 1%*range(y)",
            1,
            "a law with range(y) tells its bounds when all readings are known",
        ),
        (
            "reduce whole.csv --x u --lower lo",
            1,
            "line 2, column 4 (lo): \"\": the row has neither a lower nor an upper bound",
        ),
        ("reduce whole.csv --x u", 2, "--y <COL>"),
    ] {
        let run = run(line);
        assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{line}");
        assert!(run.stderr.contains(message), "{line}\n{}", run.stderr);
    }
}

#[test]
fn parts_of_different_wholes_and_unknown_formats_are_refused() {
    let of = |options: &str| {
        let line: Vec<&str> = ["reduce", "-"].into_iter().chain(options.split(' ')).collect();
        run_with_input(&line, b"u,v,y,lo,up\n1,2,3,2,4\n2,2,5,4,6\n").stdout
    };
    let (interval, upper) = (of("--x u --lower lo --upper up"), of("--x u --upper up"));
    let (one, other) = (of("--x u,v --y y --eps 1"), of("--x u,v --y y --eps 2"));
    let law = of("--x u,v --y y --eps |y|");
    let other_law = of("--x u,v --y y --eps 2*|y|");
    for (input, message) in [
        (format!("{interval}{upper}"), "differs from the first one in the columns of lower and upper bounds"),
        (format!("{one}{other}"), "differs from the first one in the error bound"),
        (format!("{law}{other_law}"), "differs from the first one in the law of error bounds"),
        (format!("{one}{law}"), "differs from the first one in where error bounds come from"),
        (format!("{one}{interval}"), "differs from the first one in the number of regressors"),
        (
            one.replace("reduced/2", "reduced/7"),
            "a reduction of format \"7\", which is not known here (expected 1 to 4)",
        ),
        (one.replace("reduced/2", "reduced/1"), "the line in front of a reduction is not understood"),
        (one.replace("[\"u\",\"v\"]", "[]"), "is not understood: x has neither one name nor two"),
        (one.replace("[\"u\",\"v\"]", "[\"u\"]"), "a line under one bound for all readings has format 1"),
        (one.replace("\"y\":\"y\"", "\"y\":null"), "is not understood: y is missing"),
        (
            interval.replace("\"lo\"", "null").replace("\"up\"", "null"),
            "is not understood: neither lower nor upper",
        ),
    ] {
        let run =
            run_with_input(&["reduce", "-", "--x", "u", "--lower", "lo", "--upper", "up"], input.as_bytes());
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{input}");
        assert!(run.stderr.contains(message), "{input}\n{}", run.stderr);
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
        // A reduction does not know the format of the original table.
        ["file", "table"].iter().for_each(|part| drop(report["input"][*part].take()));
        // A small table is asked about all readings, a reduction about those that it kept.
        report["readings"]["asked"].take();
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
