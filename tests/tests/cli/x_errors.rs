//! `fit --x-eps`: the example of the page in every format, proofs that verify, refusals; `plot --x-eps`.

use boundfit_tests::cli::{boundfit, directory_with};
use boundfit_tests::program::Run;
use serde_json::Value;

const CURRENT: &str = "U,I\n4.5,109.5\n6,115.3\n7,129.2\n8,134.8\n9,142.1\n10,144.6\n";
const WITH_BOUNDS: &str = "x,y,d,e\n0,0,1,1\n1,0,1/2,0\n-1,1/2,1,0\n";

fn run(table: &str, options: &str) -> Run {
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    boundfit(directory.path(), &format!("fit data.csv {options}"))
}

fn json(table: &str, options: &str, status: i32) -> Value {
    let run = run(table, &format!("{options} --format json"));
    assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{options}");
    serde_json::from_str(&run.stdout).unwrap()
}

fn refused(table: &str, options: &str, status: i32) -> String {
    let run = run(table, options);
    assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{options}: {run:?}");
    run.stderr.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}

#[test]
fn no_line_passes_through_all_bars_and_the_rows_say_why() {
    let text = run(CURRENT, "--x U --y I --eps 1.5 --x-eps 0.15");
    assert_eq!(text.status, 3);
    let lines = text.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    for said in [
        "2 upper left and 3 lower right ask for theta1 >= 8.3846",
        "3 lower right and 6 upper left ask for theta1 <= 6.8149",
        "by a factor of at least 1.2651 (exactly 2630/2079)",
        "eps_min if every x were exact: 3.2875",
    ] {
        assert!(lines.contains(said), "{said}: {}", text.stdout);
    }
    assert!(text.stdout.lines().all(|line| line.len() <= 80), "{}", text.stdout);
    let found = json(CURRENT, "--x U --y I --eps 1.5 --x-eps 0.15", 3);
    assert_eq!(found["schema"], "boundfit/x-errors/2");
    for (end, decimal) in [("lower", "1.2650"), ("upper", "1.2651")] {
        let end = &found["factor"][end];
        assert_eq!((&end["exact"], &end["decimal"]), (&"2630/2079".into(), &decimal.into()));
    }
    assert_eq!(found["sides"][0]["fps"]["certificate"]["farkas"].as_array().unwrap().len(), 3);
    assert_eq!((&found["pieces"], &found["pui"]), (&0.into(), &Value::Null));
}

#[test]
fn steepest_and_shallowest_line_are_told_with_their_corners() {
    let text = run(CURRENT, "--x U --y I --eps 2 --x-eps 1/5").stdout;
    for said in [
        "steepest       I = 7.4616*U + 73.476, through 3 lower right, 6 upper left",
        "shallowest     I = 7.0714*U + 76.286, through 2 upper left, 3 lower right",
    ] {
        assert!(text.contains(said), "{text}");
    }
    let found = json(CURRENT, "--x U --y I --eps 2 --x-eps 1/5", 0);
    assert_eq!(found["slopes"]["largest"]["theta"][0]["exact"], "97/13");
    assert_eq!(found["pui"][0]["lower"]["exact"], "99/14");
    let both = run(CURRENT, "--x U --y I --eps 30 --x-eps 0.5").stdout;
    assert!(both.contains("two pieces joined at theta1 = 0") && both.contains("rises most"), "{both}");
}

#[test]
fn a_number_is_a_number_and_any_other_text_a_column() {
    let found = json(WITH_BOUNDS, "--x x --y y --eps 0.2 --x-eps d", 0);
    assert_eq!((&found["x_epsilon"], &found["x_epsilon_column"]), (&Value::Null, &"d".into()));
    // The larger root of 4·s² + 31·s - 10.
    let ends = ["lower", "upper"].map(|end| found["factor"][end]["exact"].as_str().unwrap());
    assert_eq!(ends, ["15508363034790081/50000000000000000", "31016726069580163/100000000000000000"]);
    let text = run(WITH_BOUNDS, "--x x --y y --eps 0.2 --x-eps d").stdout;
    assert!(text.contains("least factor   between 0.31016 and 0.31017 on the bounds"), "{text}");
    let number = json(WITH_BOUNDS, "--x x --y y --eps 0.2 --x-eps 3", 0);
    assert_eq!(number["x_epsilon"]["exact"], "3");
    let column = json(WITH_BOUNDS, "--x x --y y --eps 2 --x-eps-column 3", 0);
    assert!(column["x_epsilon_column"].is_string(), "{column}");
}

#[test]
fn pieces_become_well_known_text_and_tables() {
    let vertical = "x,y\n1,0\n1,5\n";
    let limits = "--where theta1<=2 --where theta1>=-2";
    let apart = run(vertical, &format!("--x x --y y --eps 1 --x-eps 1 {limits} --format wkt"));
    assert_eq!(apart.stdout, "MULTIPOLYGON (((1.5 1, 2 0, 2 1, 1.5 1)), ((-2 4, -1.5 4, -2 5, -2 4)))\n");
    let text = run(vertical, &format!("--x x --y y --eps 1 --x-eps 1 {limits}")).stdout;
    assert!(
        text.contains("two pieces with a gap between them") && text.contains("is not in the set itself"),
        "{text}"
    );
    let endless = run(vertical, "--x x --y y --eps 1 --x-eps 1");
    assert!(endless.stdout.contains("it leaves no line itself"), "{}", endless.stdout);
    let nowhere = run(vertical, "--x x --y y --eps 1 --x-eps 1 --where 0*theta1>=1");
    assert!(nowhere.stdout.contains("Larger error bounds would not help."), "{}", nowhere.stdout);
    let csv = run(vertical, "--x x --y y --eps 1 --x-eps 1 --format csv").stdout;
    assert!(
        csv.contains("pui_rising,theta1,1.5,inf,,3/2,,")
            && csv.contains("pui_falling,theta1,-inf,-1.5,,,-3/2,"),
        "{csv}"
    );
    assert_eq!(run(CURRENT, "--x U --y I --eps 1.5 --x-eps 0.15 --format wkt").stdout, "POLYGON EMPTY\n");
}

#[test]
fn proofs_of_every_kind_of_set_are_true() {
    let tables = [
        (CURRENT, "--x U --y I --eps 1.5 --x-eps 0.15"),
        (CURRENT, "--x U --y I --eps 2 --x-eps 0.2"),
        (CURRENT, "--x U --y I --eps 30 --x-eps 0.5"),
        (CURRENT, "--x U --y I --eps 9 --x-eps 0.2 --strong"),
        (CURRENT, "--x U --y I --eps 4 --x-eps 0"),
        (CURRENT, "--x U --y I --eps 2 --x-eps 0.2 --rows 2..5 --x-origin 7 --where theta1<=12"),
        (WITH_BOUNDS, "--x x --y y --eps 0.2 --x-eps d"),
        (WITH_BOUNDS, "--x x --y y --eps-column 3 --x-eps d --strong"),
        ("x,y\n1,0\n1,5\n", "--x x --y y --eps 1 --x-eps 1"),
        ("x,lo,up\n1,0,\n2,,5\n", "--x x --lower lo --upper up --x-eps 1"),
    ];
    for (table, options) in tables {
        let directory = directory_with(&[("data.csv", table.as_bytes())]);
        let fit = boundfit(directory.path(), &format!("fit data.csv {options} --proof proof.json"));
        assert!([0, 3].contains(&fit.status), "{options}: {fit:?}");
        let verified = boundfit(directory.path(), "verify proof.json data.csv");
        assert_eq!(verified.status, 0, "{options}: {verified:?}");
    }
}

#[test]
fn what_errors_in_x_do_not_go_with_is_refused() {
    let own = "--x U --y I --eps 1.5 --x-eps 0.15";
    let two = "with errors in x ('--x-eps') there may be two, one for each sign of theta1";
    for (options, message) in [
        ("--by U", "'--by' fits many sets"),
        ("--window 3", "'--window' fits many sets"),
        ("--confidence 0.9", "'--confidence' is about the band of a single set"),
        ("--sweep 1..2", "'--sweep' moves the bounds of y alone"),
        ("--brief", "'--brief' is about a single set"),
        ("--inverse", "'--inverse' is about a single set"),
        (
            "--format ext",
            "'--format m', 'ine' and 'ext' are about a single set, and '--format json' has the vertices of all",
        ),
        (
            "--format csv --vertices",
            "'--vertices' is about a single set, and '--format json' has the vertices of all",
        ),
    ] {
        assert_eq!(refused(CURRENT, &format!("{own} {options}"), 2), format!("{message}: {two}"));
    }
    for (options, message) in [
        (
            "--x U --y I --eps 1 --strong",
            "'--strong' is about errors in x: say how large they may be with '--x-eps' or '--x-eps-column'",
        ),
        (
            "--x U,I --y I --eps 1 --x-eps 1",
            "'--x-eps' is about a line: with two regressors it is not known how their errors go together",
        ),
        (
            "--x U --y I --eps 1 --x-eps -1",
            "invalid value '-1' for '--x-eps <NUM|COL>': negative (expected a number that is at least 0, such as 0.15, or a column)",
        ),
        (
            "--x U --y I --eps min --x-eps 1",
            "'--eps' asks for a multiple of eps_min, which is found as if every x were exact: beside '--x-eps' it is a number, and the \
             answer says by which factor all bounds may shrink or have to grow",
        ),
        (
            "--x U --y I --eps 1 --x-eps 1e99999999",
            "invalid value '1e99999999' for '--x-eps <NUM|COL>': refused: exponent beyond 10000 (the limit) at character 3; \
             --limit exponent=N raises it",
        ),
    ] {
        assert_eq!(refused(CURRENT, options, 2), message, "{options}");
    }
    assert_eq!(
        refused(CURRENT, "--x U --y I --eps 1 --x-eps z", 1),
        "data.csv: line 1: there is no column \"z\" (expected one of \"U\", \"I\" or a number from 1 to 2)"
    );
    assert_eq!(
        refused("x,y,d\n0,0,1\n1,0,-2\n", "--x x --y y --eps 1 --x-eps d", 1),
        "data.csv: line 3, column 3 (d): \"-2\": the error bound is negative (expected a number that is at least 0)"
    );
}

fn plot(table: &str, options: &str) -> Run {
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    boundfit(directory.path(), &format!("plot data.csv {options}"))
}

#[test]
fn pictures_say_what_the_report_says() {
    let vertical = "x,y\n1,0\n1,5\n";
    let limits = "--where theta1<=2 --where theta1>=-2";
    let own = "--x U --y I";
    for (table, options, status, sentences) in [
        (
            CURRENT,
            format!("{own} --eps 1.5 --x-eps 0.15 --figure data"),
            3,
            vec![
                "Rising and level lines: rows 2, 3 and 6 contradict each other.",
                "a factor of at least 1.2651.",
            ],
        ),
        (CURRENT, format!("{own} --eps 1.5 --x-eps 0.15"), 3, vec!["Falling and level lines: rows 1 and 6"]),
        (CURRENT, format!("{own} --eps 2 --x-eps 0.2"), 0, vec!["θ₁ from 7.0714 to 7.4616"]),
        (CURRENT, format!("{own} --eps 30 --x-eps 0.5"), 0, vec!["two convex parts, joined at θ₁ = 0"]),
        (
            CURRENT,
            format!("{own} --eps 9 --x-eps 0.2 --strong"),
            0,
            vec!["top and bottom of each box", "to 9;"],
        ),
        (vertical, format!("--x x --y y --eps 1 --x-eps 1 {limits}"), 0, vec!["two parts with a gap"]),
        (
            vertical,
            "--x x --y y --eps 1 --x-eps 1 --figure data".to_owned(),
            0,
            vec!["as steep as one likes"],
        ),
        (vertical, "--x x --y y --eps 1 --x-eps 1 --strong".to_owned(), 3, vec!["of at least 2.5."]),
        (
            WITH_BOUNDS,
            "--x x --y y --eps 0.2 --x-eps-column d --rows 1..2".to_owned(),
            0,
            vec!["up to d of its row"],
        ),
        (
            "x,lo,up\n1,0,\n2,,5\n",
            "--x x --lower lo --upper up --x-eps 1 --figure data".to_owned(),
            0,
            vec!["reaches the edge"],
        ),
    ] {
        let run = plot(table, &options);
        assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{options}");
        for sentence in sentences {
            assert!(run.stdout.contains(sentence), "{options}: {}", &run.stdout[..run.stdout.len().min(900)]);
        }
    }
}

#[test]
fn pictures_of_many_boxes_are_thinned_out() {
    let table: String = (0..30_000).map(|row| format!("{row},{}\n", row + row * 7 % 5)).collect();
    let table = format!("x,y\n{table}");
    let run = plot(&table, "--x x --y y --eps 4 --x-eps 1 --figure data --rows 1..15000");
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.contains("30000 readings; drawn are some, evenly spread"));
    assert!(run.stdout.len() < 3_000_000, "{}", run.stdout.len());
}

#[test]
fn pictures_that_there_are_not_with_errors_in_x_are_refused() {
    let own = "--x U --y I --eps 2 --x-eps 0.2";
    for figure in ["eui", "pui", "corridor", "directions", "status", "outliers", "range", "next", "all"] {
        let run = plot(CURRENT, &format!("{own} --figure {figure}"));
        let expected = format!(
            "error: '--figure {figure}' is about readings whose x is exact: with errors in x ('--x-eps') draw 'data' or 'fps'"
        );
        assert_eq!(
            (run.status, run.stdout.as_str(), run.stderr.lines().next()),
            (2, "", Some(expected.as_str()))
        );
    }
    for (options, message) in [
        ("--x U --y I --eps 2 --strong", "'--strong' is about errors in x"),
        ("--x U,I --y I --eps 2 --x-eps 1", "'--x-eps' is about a line"),
        (
            "--x U --y I --eps min --x-eps 1",
            "'--eps' asks for a multiple of eps_min, which is found as if every x were exact",
        ),
        ("--x U --y I --eps 1 --x-eps -1", "invalid value '-1' for '--x-eps <NUM|COL>': negative"),
    ] {
        let run = plot(CURRENT, options);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{options}");
        assert!(run.stderr.starts_with(&format!("error: {message}")), "{options}: {}", run.stderr);
    }
}

/// Sets without any bound have no intervals, as in the report of a fit.
#[test]
fn intervals_without_ends_are_null() {
    let directory = directory_with(&[("a.csv", b"x,up\n1,2\n")]);
    for agreement in ["", "--strong"] {
        let line = format!("fit a.csv --x x --upper up --x-eps 1/2 {agreement} --format json");
        let run = boundfit(directory.path(), &line);
        let json: Value = serde_json::from_str(&run.stdout).unwrap();
        assert_eq!((&json["pui"], &json["reasons"]["pui"]), (&Value::Null, &"no end is bounded".into()));
        let bounded = json["sides"].as_array().unwrap().iter().filter(|side| !side["pui"].is_null());
        // One side of the slopes has an end at 0 each.
        assert_eq!(bounded.count(), if agreement.is_empty() { 2 } else { 0 });
    }
}
