//! `boundfit range` and `fit --window`: formats, order, exit statuses, refusals; windows equal fits of their rows.

use boundfit_tests::cli::refusals::{check_refusal, refuses};
use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, report};
use boundfit_tests::program::root;
use serde_json::{Value, json};

const TRANSDUCER: &str = "fixtures/transducer/transducer.csv --x Vz --y z --eps 0.5e-3";

fn range_of(table: &str, options: &str) -> (i32, Value) {
    let run = boundfit_with_input(&root(), &format!("range - {options} --format json"), table.as_bytes());
    assert_eq!(run.stderr, "", "{options}");
    (run.status, serde_json::from_str(&run.stdout).unwrap())
}

/// The lines of windows and the exit status.
fn windows_of(table: &str, options: &str) -> (i32, Vec<Value>) {
    let run = boundfit_with_input(&root(), &format!("fit - {options} --format json"), table.as_bytes());
    (run.status, run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect())
}

#[test]
fn the_rows_that_the_laboratory_took_lie_in_the_longest_run() {
    let found = report(&root(), &format!("range {TRANSDUCER}"), b"");
    assert_eq!((&found["schema"], &found["by"]), (&json!("boundfit/range/1"), &json!("x")));
    assert_eq!((&found["longest"], &found["widest"]), (&json!([13, 36]), &json!([13, 36])));
    assert_eq!(found["fewest"], json!([[1, 7], [8, 13], [13, 36], [37, 41], [42, 46]]));
    assert_eq!(found["order"], json!((1..=46).collect::<Vec<usize>>()));
    assert_eq!(found["runs"].as_array().unwrap().len(), 20);
    // The longest run says what a fit of its rows says.
    let fit = report(&root(), &format!("fit {TRANSDUCER} --rows 13..36"), b"");
    for part in ["pui", "central", "epsilon_min"] {
        assert_eq!(found["longest_fit"][part], fit[part], "{part}");
    }
    // So does a fit of one reading more that nothing is left, for the reason that the run gives.
    let more = report(&root(), &format!("fit {TRANSDUCER} --rows 13..37"), b"");
    assert_eq!(more["fps"]["kind"], "empty");
    let after = found["parts"][11]["after"].as_array().unwrap();
    assert!(after.iter().any(|term| term["row"] == 37), "{after:?}");
}

#[test]
fn readings_at_one_x_are_one_place() {
    // In order of x the rows are 2, 4, 3 and 5, 1; the two at x = 1 contradict each other, so that no run has either.
    let table = "x,y\n2,2\n0,0\n1,9\n1,1\n";
    let table = table.replace("1,9\n1,1\n", "1,9\n0.5,0.5\n1,1\n");
    let (status, found) = range_of(&table, "--x x --y y --eps 0.1");
    assert_eq!((status, &found["order"]), (0, &json!([2, 4, 3, 5, 1])));
    assert_eq!(found["runs"], json!([[1, 2], [5, 5]]));
    let alone: Vec<&Value> = found["alone"].as_array().unwrap().iter().map(|own| &own["row"]).collect();
    assert_eq!(alone, [&json!(3), &json!(5)]);
    // Two readings at x = 2 agree with each other, but only the first one with those before: none of them joins.
    let (_, found) = range_of("x,y\n0,0\n1,0.6\n2,2\n2,2.4\n3,3.2\n", "--x x --y y --eps 0.2");
    assert_eq!(found["runs"], json!([[1, 2], [2, 4], [3, 5]]));
    let text = boundfit_with_input(
        &root(),
        "range - --x x --y y --eps 0.2",
        b"x,y\n0,0\n1,0.6\n2,2\n2,2.4\n3,3.2\n",
    );
    assert!(text.stdout.contains("  longest  x from 1 to 2: 3 readings, rows 2..4\n"), "{}", text.stdout);
    let (_, by_row) = range_of(&table, "--x x --y y --eps 0.1 --by-row");
    assert_eq!((&by_row["by"], &by_row["order"]), (&json!("row"), &json!([1, 2, 3, 4, 5])));
    let (_, two) = range_of("u,v,y\n1,0,1\n1,0,1\n1,0,5\n", "--x u,v --y y --eps 0.1");
    assert_eq!((&two["by"], &two["runs"]), (&json!("row"), &json!([[1, 2], [3, 3]])));
    assert_eq!(two["parts"][0]["x"], Value::Null);
}

#[test]
fn a_reading_that_never_fits_is_in_no_run() {
    let (status, found) = range_of("x,lo,up\n0,0,1\n1,2,1\n2,0,1\n", "--x x --lower lo --upper up");
    assert_eq!((status, &found["runs"]), (0, &json!([[1, 1], [3, 3]])));
    assert_eq!((&found["alone"][0]["position"], &found["alone"][0]["row"]), (&json!(2), &json!(2)));
    let text = boundfit_with_input(
        &root(),
        "range - --x x --lower lo --upper up",
        b"x,lo,up\n0,0,1\n1,2,1\n2,0,1\n",
    );
    assert!(
        text.stdout.contains("Row 2 is in no run: 2 upper, 2 lower contradict each other.\n"),
        "{}",
        text.stdout
    );
    let (status, found) = range_of("x,y\n0,0\n", "--x x --y y --eps 1 --where '0*theta1 >= 1'");
    assert_eq!((status, &found["runs"], &found["longest"]), (3, &json!([]), &Value::Null));
    let run =
        boundfit_with_input(&root(), "range - --x x --y y --eps 1 --where '0*theta1 >= 1'", b"x,y\n0,0\n");
    assert_eq!(run.status, 3);
    assert!(run.stdout.contains("No reading fits, not even those of one x alone."), "{}", run.stdout);
    let by_row = boundfit_with_input(
        &root(),
        "range - --x x,u --y y --eps 1 --where '0*theta1 >= 1'",
        b"x,u,y\n0,0,0\n",
    );
    assert!(by_row.stdout.contains("No reading fits, not even alone."), "{}", by_row.stdout);
    // Each of these readings fits alone, but a line has one value at an x.
    let run = boundfit_with_input(&root(), "range - --x x --y y --eps 0.5", b"x,y\n1,1\n1,3\n");
    assert!(run.stdout.contains("No reading fits, not even those of one x alone."), "{}", run.stdout);
    let run = boundfit_with_input(&root(), "range - --x x --y y --eps 0.5", b"x,y\n1,1\n");
    assert!(run.stdout.contains("The only reading fits: one run has it."), "{}", run.stdout);
}

#[test]
fn csv_has_a_row_for_each_run() {
    let run = boundfit_with_input(
        &root(),
        "range - --x x --y y --eps 0.1 --format csv",
        b"x,y\n0,0\n1,1\n2,2\n3,9\n",
    );
    let expected = "first,last,readings,first_row,last_row,x_least,x_largest,longest,fewest,before,after\n\
                    1,3,3,1,3,0,2,true,true,,\"1 upper, 2 lower, 4 lower\"\n\
                    3,4,2,3,4,2,3,false,true,\"2 lower, 3 upper, 4 lower\",\n";
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let lines: Vec<&str> = run.stdout.lines().collect();
    let wanted: Vec<&str> = expected.lines().collect();
    assert_eq!(lines.len(), wanted.len(), "{}", run.stdout);
    for (line, wanted) in lines.iter().zip(wanted) {
        let cells = |line: &str| line.split(',').take(9).map(ToOwned::to_owned).collect::<Vec<_>>();
        assert_eq!(cells(line), cells(wanted), "{}", run.stdout);
    }
}

#[test]
fn range_refuses_what_has_no_order_of_x_and_what_has_not_every_reading() {
    refuses(
        &root(),
        "range fixtures/transducer/transducer.csv --x Vz,z --y z --eps 1 --by-x",
        2,
        "two regressors have no order of x (expected the order of rows)",
    );
    let both = boundfit(&root(), &format!("range {TRANSDUCER} --by-x --by-row"));
    assert_eq!((both.status, both.stdout.as_str()), (2, ""));
    assert!(both.stderr.contains("'--by-x' cannot be used with '--by-row'"), "{}", both.stderr);
    let reduced = boundfit(&root(), "reduce fixtures/norris/norris.csv --x x --y y").stdout;
    let directory = directory_with(&[("reduced.csv", reduced.as_bytes())]);
    refuses(
        directory.path(),
        "range reduced.csv --x x --y y --eps 2",
        2,
        "'range' is about every reading, and the data are a reduction: ask about the table that it was made from",
    );
    refuses(
        directory.path(),
        "fit reduced.csv --x x --y y --eps 2 --window 3",
        2,
        "a fit of windows is about every reading, and the data are a reduction: ask about the table that it was made from",
    );
}

#[test]
fn a_window_is_a_fit_of_its_rows() {
    let table = std::fs::read_to_string(root().join("fixtures/transducer/transducer.csv")).unwrap();
    for (options, count) in [("--window 7", 40), ("--window 15 --step 10", 4), ("--window-x 2 --step 3", 11)]
    {
        let (status, lines) = windows_of(&table, &format!("--x Vz --y z --eps 0.5e-3 {options}"));
        assert_eq!((status, lines.len()), (3, count), "{options}");
        for line in lines.iter().step_by(3) {
            let rows = format!("{}..{}", line["first_row"], line["last_row"]);
            let fit = report(&root(), &format!("fit {TRANSDUCER} --rows {rows}"), b"");
            assert_eq!(
                (&line["schema"], &line["rows"]),
                (&json!("boundfit/window/1"), &fit["input"]["rows"])
            );
            assert_eq!(line["fps"]["kind"], fit["fps"]["kind"], "{rows}");
            for part in ["central", "epsilon_min"] {
                assert_eq!(line[part], fit[part], "{rows} {part}");
            }
            for (own, other) in [0, 1].map(|axis| (&line["pui"][axis], &fit["pui"][axis])) {
                assert_eq!(own["lower"]["exact"], other["lower"]["exact"], "{rows}");
                assert_eq!(own["upper"]["exact"], other["upper"]["exact"], "{rows}");
            }
        }
    }
}

#[test]
fn windows_along_x_do_not_depend_on_the_order_of_rows() {
    let lines = |table: &str| {
        let (_, lines) = windows_of(table, "--x x --y y --eps 1 --window-x 2");
        lines
            .iter()
            .map(|line| (line["x"].clone(), line["pui"][0]["lower"]["exact"].clone()))
            .collect::<Vec<_>>()
    };
    let sorted = lines("x,y\n0,0\n1,1\n2,3\n3,3\n5,5\n");
    assert_eq!(sorted.len(), 3);
    assert_eq!(sorted, lines("x,y\n5,5\n2,3\n0,0\n3,3\n1,1\n"));
}

#[test]
fn windows_that_are_not_whole_are_told() {
    let run =
        boundfit_with_input(&root(), "fit - --x x --y y --eps 1 --window 9 --format csv", b"x,y\n0,0\n1,1\n");
    assert_eq!(run.status, 0);
    assert_eq!(
        run.stderr,
        "1 window of 9 readings, step 1 reading: 1 bounded, 0 unbounded, 0 empty\n\
         All readings together do not fill a window: the only one has all of them\n"
    );
    assert_eq!(
        run.stdout,
        "first_row,last_row,rows,x_first,x_last,kind,theta1_lower,theta1_upper,theta2_lower,theta2_upper,\
         theta1_central,theta1_error,theta2_central,theta2_error,epsilon_min\n\
         1,2,2,0,1,polygon,-1,3,-1,1,1,2,0,1,0\n"
    );
    let run =
        boundfit_with_input(&root(), "fit - --x x --y y --eps 1 --window 1 --step 2", b"x,y\n0,0\n1,1\n");
    assert!(
        run.stdout.contains("strip") && run.stdout.ends_with("1 reading comes after the last window\n"),
        "{run:?}"
    );
}

#[test]
fn windows_refuse_what_is_another_question() {
    let fit = format!("fit {TRANSDUCER}");
    for (options, message) in [
        ("--step 3", "'--step' says how far a window moves on: say which with '--window' or '--window-x'"),
        (
            "--window-x 0",
            "invalid value '0' for '--window-x <NUM>': expected a number above 0, such as 60 or 0.5",
        ),
        (
            "--window-x -1",
            "invalid value '-1' for '--window-x <NUM>': expected a number above 0, such as 60 or 0.5",
        ),
        (
            "--window-x day",
            "invalid value 'day' for '--window-x <NUM>': not a number: unexpected character 'd' at character 1 \
             (expected a number above 0, such as 60 or 0.5)",
        ),
    ] {
        refuses(&root(), &format!("{fit} {options}"), 2, message);
    }
    refuses(
        &root(),
        "fit fixtures/transducer/transducer.csv --x Vz,z --y z --eps 1 --window-x 2",
        2,
        "'--window-x' is about a line: two regressors have no x to look back along; '--window' counts readings",
    );
    for (options, part) in [
        ("--window 0", "invalid value '0' for '--window <N>'"),
        ("--window 3 --step 0", "invalid value '0' for '--step <K>'"),
        ("--window 3 --window-x 2", "'--window' and '--window-x' both say how far a window reaches back"),
        ("--window 3 --by z", "'--window <N>' cannot be used with '--by <COL>'"),
        ("--window 3 --sweep 1..2", "'--window <N>' cannot be used with '--sweep <FROM..TO>'"),
        ("--window 3 --proof p.json", "'--window <N>' cannot be used with '--proof <FILE>'"),
    ] {
        let run = boundfit(&root(), &format!("{fit} {options}"));
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{options}");
        assert!(run.stderr.contains(part), "{options}: {}", run.stderr);
    }
    let run = boundfit(&root(), &format!("{fit} --window 3 --format wkt"));
    check_refusal(&run, &fit, 2, "'--window' and '--window-x' write text, json or csv");
}
