//! Options, rows, groups and commas that somebody wrote: they have an effect, or are refused or named.

use boundfit_tests::cli::{boundfit, directory_with, printed};
use boundfit_tests::program::root;

const TABLE: &[u8] = b"x,y\n1,2\n2,3.1\n3,3.9\n4,5.2\n";

#[test]
fn options_about_decimals_are_refused_where_there_are_none() {
    let directory =
        directory_with(&[("data.csv", TABLE), ("planes.csv", b"a1,a2,b\n-1,0,0\n0,-1,0\n3,7,1\n")]);
    let here = directory.path();
    let fit = "data.csv --x x --y y --eps 1/7";
    let lines = [
        format!("fit {fit} --format csv"),
        format!("fit {fit} --format m"),
        format!("fit {fit} --format ine"),
        format!("fit {fit} --x-eps 0.1 --format csv"),
        format!("predict {fit} --at 2 --format csv"),
        format!("status {fit} --format csv"),
        "linearity data.csv --x x --y y --format csv".to_owned(),
        "polygon planes.csv --format ext".to_owned(),
    ];
    for line in lines {
        for option in ["--digits 3", "--rounding nearest", "--exact"] {
            let (name, _) = option.split_once(' ').unwrap_or((option, ""));
            let problem = format!(
                "error: '{name}' is about decimals in text, latex, markdown and json; this format has doubles, exact numbers or both\n"
            );
            let run = boundfit(here, &format!("{line} {option}"));
            assert!(run.status == 2 && run.stderr.starts_with(&problem), "{line} {option}: {run:?}");
        }
    }
    // Lines of many sets, vertices and long WKT have decimals.
    for line in [
        format!("fit {fit} --format csv --by x --digits 3 --rounding nearest"),
        format!("fit {fit} --format csv --window 3 --exact"),
        format!("fit {fit} --format csv --vertices --digits 3"),
        format!("fit {fit} --format wkt --digits 30"),
        "polygon planes.csv --format csv --digits 3".to_owned(),
    ] {
        assert_eq!(boundfit(here, &line).status, 0, "{line}");
    }
}

#[test]
fn two_regressors_have_no_inverse_line() {
    let directory = directory_with(&[("data.csv", TABLE)]);
    let run = boundfit(directory.path(), "fit data.csv --x x,y --y y --eps 1 --inverse");
    let problem = "error: '--inverse' is about a line: with two regressors there is no single x for each y\n";
    assert!(run.status == 2 && run.stderr.starts_with(problem), "{run:?}");
}

#[test]
fn options_that_a_format_or_a_fleet_has_no_use_for_are_refused() {
    let directory = directory_with(&[("data.csv", TABLE)]);
    for (line, problem) in [
        (
            "outliers data.csv --x x --y y --eps 0 --most 2 --format csv",
            "'--most' is no part of csv: a table has a row for each set ",
        ),
        (
            "fit data.csv --x x --y y --eps 1 --by x --no-eui",
            "'--no-eui' is about one set: '--by' reads each group once",
        ),
    ] {
        let run = boundfit(directory.path(), line);
        assert!(run.status == 2 && run.stderr.starts_with(&format!("error: {problem}")), "{line}: {run:?}");
    }
}

#[test]
fn rows_that_cannot_be_counted_are_refused() {
    let directory = directory_with(&[("data.csv", TABLE)]);
    for (option, text) in [
        ("--rows", "1..99999999999999999999999"),
        ("--rows", "18446744073709551616"),
        ("--without", "1,99999999999999999999.."),
    ] {
        let run = boundfit(directory.path(), &format!("fit data.csv --x x --y y --eps 1 {option} {text}"));
        let problem = format!(
            "error: invalid value '{text}' for '{option} <ROWS>': a row that cannot be counted (expected rows up to {})\n",
            usize::MAX
        );
        assert!(run.status == 2 && run.stderr.starts_with(&problem), "{run:?}");
    }
}

#[test]
fn a_file_of_doubles_is_not_read_as_decimals() {
    let line = "fit fixtures/mat/transducer-v6.mat --x Vz --y z --rows 14..36 --eps 0.5e-3 --brief --reading";
    let run = boundfit(&root(), &format!("{line} decimal"));
    let problem = "error: invalid value 'decimal' for '--reading <READING>': the data store doubles and no decimals: they are read as \
                   binary64, exactly as stored\n";
    assert!(run.status == 2 && run.stderr.starts_with(problem), "{run:?}");
    printed(&root(), &format!("{line} binary64"));
}

#[test]
fn a_group_without_a_reading_is_named() {
    let mut table = "s,x,y\na,1,2\nb,1,\na,2,3.1\n\"b\",4,NA\nc,,2\na,3,4\nc,1,1\n".to_owned();
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let fit = "fit data.csv --x x --y y --eps 1 --by s --missing skip";
    let named = "3 rows with missing values left out\n1 group without a reading: \"b\"\n";
    let text = printed(directory.path(), fit);
    assert!(text.ends_with(named), "{text}");
    for format in ["csv", "json"] {
        let run = boundfit(directory.path(), &format!("{fit} --format {format}"));
        assert!(run.status == 0 && run.stderr.ends_with(named), "{run:?}");
    }
    let plot =
        boundfit(directory.path(), "plot data.csv --x x --y y --eps 1 --by s --missing skip -o sets.svg");
    let notes = "note: data.csv: 3 rows with missing values left out\nnote: data.csv: 1 group without a reading: \"b\"\n";
    assert_eq!((plot.status, plot.stderr.as_str()), (0, notes));
    // Many are counted, and on any number of threads the same ones are named.
    (0..30_000).for_each(|row| table += &format!("g{},{row},\n", row / 1_000));
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let names: Vec<String> = (0..9).map(|group| format!("\"g{group}\"")).collect();
    let named = format!("31 groups without a reading: \"b\", {} and 21 more\n", names.join(", "));
    for threads in ["1", "2"] {
        let text = printed(directory.path(), &format!("{fit} --threads {threads}"));
        assert!(text.lines().all(|line| line.len() <= 80), "{text}");
        assert!(text.replace(",\n\"", ", \"").ends_with(&named), "{text}");
    }
}

#[test]
fn a_decimal_comma_in_an_option_is_noticed() {
    let directory = directory_with(&[("data.csv", b"x;y\n1,5;2\n2,5;3\n3;4,5\n"), ("points.csv", TABLE)]);
    let here = directory.path();
    let condition = boundfit(here, "fit points.csv --x x --y y --eps 1 --where theta1>=2,5");
    let hint = "for '--where <CONDITION>': not a number: unexpected ',' (the decimal mark is a point) at character 10 (a point comes \
                before decimals, whatever the data have: 1.5, not 1,5)\n";
    assert!(condition.status == 2 && condition.stderr.contains(hint), "{condition:?}");
    let left = boundfit(here, "fit points.csv --x x --y y --eps 1 --where 2,5*theta1>=2");
    assert!(
        left.status == 2 && left.stderr.contains("the decimal mark is a point) at character 2 "),
        "{left:?}"
    );
    for option in ["--at", "--from"] {
        let note = format!(
            "note: '{option} 2,5' has several values: a comma separates them, and a point comes before decimals, whatever the data \
             have: 1.5\n"
        );
        let run = boundfit(here, &format!("predict data.csv --x x --y y --eps 1 {option} 2,5"));
        assert_eq!((run.status, run.stderr), (0, note));
        printed(here, &format!("predict points.csv --x x --y y --eps 1 {option} 2,5"));
        printed(here, &format!("predict data.csv --x x --y y --eps 1 {option} 2.5"));
    }
}

#[test]
fn a_prediction_of_nothing_names_every_way_to_ask() {
    let directory = directory_with(&[("data.csv", TABLE)]);
    let run = boundfit(directory.path(), "predict data.csv --x x --y y --eps 1");
    let ways = "  <--at <X,...|FILE:COL>|--from <Y,...|FILE:COL>|--grid <FROM..TO/N>>\n";
    assert!(run.status == 2 && run.stderr.contains(ways), "{run:?}");
}

#[test]
fn what_keeps_a_proof_from_data_is_named() {
    for (data, obstacle) in [
        (&b"x;y\n1,5;2\n2;3\n"[..], "a comma comes before decimals (expected a point)"),
        (b"x y\n1 5\n2 3\n", "blanks separate their cells (expected a comma, a semicolon, a tab or |)"),
        (b"# by hand\nx,y\n1,5\n2,3\n", "comments stand among the rows"),
        (
            b"\xff\xfex\x00,\x00y\x00\n\x001\x00,\x002\x00\n\x002\x00,\x003\x00\n\x00",
            "their bytes are not UTF-8",
        ),
        (b"[{\"x\": 1, \"y\": 2}, {\"x\": 2, \"y\": 3}]", "they are another kind of file, or packed"),
    ] {
        let directory = directory_with(&[("data.csv", data)]);
        for line in ["fit", "status", "range", "outliers", "predict --at 1"] {
            let (command, more) = line.split_once(' ').unwrap_or((line, ""));
            let line = format!("{command} data.csv --x x --y y --eps 1 --proof p.json {more}");
            let run = boundfit(directory.path(), &line);
            let words = format!("the data are none that the checkers read: {obstacle}; save them as CSV");
            assert!(run.status == 2 && run.stderr.contains(&words), "{line}: {run:?}");
        }
    }
}
