//! `fit --by`: every line equals what `fit` says of a file with the rows of that group only.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::io::{BufRead, BufReader};

use boundfit_tests::generate::seeded;
use boundfit_tests::program::{Run, root};
use rand::RngExt;
use serde_json::{Value, json};
use snapbox::{Assert, Data};

use boundfit_tests::cli::numbers::check_numbers;
use boundfit_tests::cli::refusals::{A_NUMBER, refuses};
use boundfit_tests::cli::{
    boundfit, command, directory_with, files_in, finish, fixture, printed, report, words,
};

const LEVELS: &str = "fit fixtures/fleet/levels.csv --by sensor --x V --y level";
const SUMMARY: &str = "7 groups, 24 rows: 2 polygons, 2 unbounded, 2 degenerate (point or segment), 1 empty\n\
                       No theta meets every bound of: T-102\n\
                       rows without the name of a group are one group, \"\"\n";

fn lines_of(run: &Run) -> Vec<Value> {
    run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// The rows of a group in a file, each with its number.
struct Group {
    key: String,
    rows: Vec<(usize, String)>,
}

/// A file's header and its groups by the text of the key column; keys must need no quotes.
fn groups_of(table: &str, key_column: usize) -> (String, Vec<Group>) {
    let mut lines = table.lines();
    let header = lines.next().unwrap().to_owned();
    let mut places: HashMap<String, usize> = HashMap::new();
    let mut groups: Vec<Group> = Vec::new();
    for (number, line) in (1..).zip(lines) {
        let key = line.split(',').nth(key_column).unwrap().to_owned();
        let place = *places.entry(key.clone()).or_insert_with(|| {
            groups.push(Group { key, rows: Vec::new() });
            groups.len() - 1
        });
        groups[place].rows.push((number, line.to_owned()));
    }
    (header, groups)
}

/// A report with each row number replaced by that in the file of all groups.
fn renumbered(mut report: Value, rows: &[(usize, String)]) -> Value {
    fn below(value: &mut Value, rows: &[(usize, String)]) {
        match value {
            Value::Object(fields) => {
                for (name, value) in fields.iter_mut() {
                    match value.as_u64() {
                        Some(row) if name == "row" => *value = json!(rows[row as usize - 1].0),
                        _ => below(value, rows),
                    }
                }
            }
            Value::Array(items) => items.iter_mut().for_each(|item| below(item, rows)),
            _ => {}
        }
    }
    below(&mut report, rows);
    report
}

/// Returns the line of a fleet about a group, from the report of a fit of its rows alone.
fn expected(key: &str, rows: &[(usize, String)], alone: Value) -> Value {
    let alone = renumbered(alone, rows);
    let least_squares = match &alone["least_squares"] {
        Value::Null => Value::Null,
        estimate => json!({
            "theta": estimate["theta"],
            "in_fps": estimate["in_fps"],
            "guaranteed_error": estimate["guaranteed_error"],
        }),
    };
    let fps = &alone["fps"];
    json!({
        "schema": "boundfit/fleet/2",
        "input": {"table": alone["input"]["table"]},
        "group": key,
        "rows": alone["input"]["rows"],
        "first_row": rows[0].0,
        "least_squares": least_squares,
        "eui": alone["eui"],
        "fps": {
            "kind": fps["kind"],
            "vertex_count": fps["vertices"].as_array().unwrap().len(),
            "certificate": fps["certificate"],
        },
        "pui": alone["pui"],
        "central": alone["central"],
        "epsilon_min": alone["epsilon_min"],
        "epsilon_factor": alone["minimax"].get("epsilon_factor").unwrap_or(&Value::Null),
    })
}

/// Compares each line with a fit of that group's rows alone. Returns the kinds that occurred.
fn compare(table: &str, key_column: usize, by: &str, options: &str) -> Vec<String> {
    let directory = directory_with(&[("all.csv", table.as_bytes())]);
    let run = boundfit(directory.path(), &format!("fit all.csv --by {by} {options} --format json"));
    let lines = lines_of(&run);
    let (header, groups) = groups_of(table, key_column);
    assert_eq!(lines.len(), groups.len(), "{options}: {}", run.stderr);
    let mut kinds = Vec::new();
    for (line, Group { key, rows }) in lines.iter().zip(&groups) {
        let own: Vec<&str> = rows.iter().map(|(_, line)| line.as_str()).collect();
        let own = format!("{header}\n{}\n", own.join("\n"));
        std::fs::write(directory.path().join("own.csv"), own).unwrap();
        let alone = report(directory.path(), &format!("fit own.csv {options} --no-lp"), b"");
        assert_eq!(line, &expected(key, rows, alone), "{options}: {key}");
        kinds.push(line["fps"]["kind"].as_str().unwrap().to_owned());
    }
    let status = if kinds.iter().any(|kind| kind == "empty") { 3 } else { 0 };
    assert_eq!(run.status, status);
    kinds
}

/// Groups of one to six readings that take turns; few places and values, so that every kind of set occurs.
fn small_fleet(seed: u64, groups: usize) -> String {
    let mut rng = seeded(seed);
    let mut text = "u,v,key,y,eps\n".to_owned();
    for turn in 0..6 {
        for group in 0..groups {
            if turn <= group % 6 {
                let mut number = |from: i32, to: i32| rng.random_range(from..=to);
                let (u, v, y) = (number(-3, 3), number(-1, 2), number(-8, 8));
                let eps = ["0", "0.5", "1/3", "2", "1e1"][rng.random_range(0..5)];
                writeln!(text, "{u}.5,{v},g{group},{y}e-1,{eps}").unwrap();
            }
        }
    }
    text
}

#[test]
fn every_line_is_that_of_a_fit_of_the_group_alone() {
    let table = small_fleet(1, 40);
    let options = [
        "--x u --y y --eps 0.25",
        "--x u --y y --eps-column eps",
        "--x u,v --y y --eps 0.5",
        "--x u,v --y y --eps-column eps --where 'theta1 >= 0' --where '2*theta1 - theta2 <= 1/3'",
        "--x u --y y --eps 0 --where 'theta1 >= 0'",
        "--x u --y y --eps 0.1 --reading binary64 --digits 17 --rounding nearest",
    ];
    let mut kinds: Vec<String> =
        options.iter().flat_map(|options| compare(&table, 2, "key", options)).collect();
    kinds.sort();
    kinds.dedup();
    let all = ["empty", "line", "point", "polygon", "ray", "segment", "strip", "unbounded-polygon"];
    assert_eq!(kinds, all);
}

#[test]
fn the_transducer_is_a_fleet_of_one() {
    let table = fixture("transducer/transducer.csv");
    let mut lines = table.lines();
    let mut with_key = format!("unit,{}\n", lines.next().unwrap());
    lines.for_each(|line| writeln!(with_key, "K1,{line}").unwrap());
    let kinds = compare(&with_key, 0, "unit", "--x Vz --y z --eps 5e-3");
    assert_eq!(kinds, ["polygon"]);
}

#[test]
fn the_three_formats() {
    for (format, file, status) in
        [("text", "groups.txt", 3), ("csv", "groups.csv", 3), ("json", "groups.ndjson", 3)]
    {
        let run = boundfit(&root(), &format!("{LEVELS} --eps 0.01 --format {format}"));
        let summary = if format == "text" { "" } else { SUMMARY };
        assert_eq!((run.status, run.stderr.as_str()), (status, summary));
        assert!(format != "text" || run.stdout.ends_with(SUMMARY));
        let file = root().join("fixtures/fleet").join(file);
        Assert::new().action_env("SNAPSHOTS").eq(run.stdout, Data::read_from(&file, None).raw());
    }
    let run = boundfit(&root(), &format!("{LEVELS} --eps 0.01 --format json"));
    for line in lines_of(&run) {
        check_numbers(&line, 5);
    }
}

#[test]
fn csv_shows_exact_numbers_and_unbounded_ends() {
    let run = boundfit(&root(), &format!("{LEVELS} --eps-column tolerance --format csv --exact"));
    assert_eq!(run.status, 0);
    let mut lines = run.stdout.lines();
    assert!(lines.next().unwrap().ends_with(",theta2_least_squares,epsilon_factor"));
    assert_eq!(lines.clone().count(), 7);
    assert_eq!(lines.nth(5), Some(",1,6,strip,-inf,inf,-inf,inf,,,,,,,0"));
    assert_eq!(
        lines.next(),
        Some(
            "\"the \"\"old\"\" one\",3,7,polygon,74/375,51/250,-1/125,7/1000,301/1500,1/300,-1/2000,3/400,301/1500,-1/1200,1/10"
        )
    );
}

#[test]
fn strange_keys_come_back_whole() {
    let keys = ["a,b", "say \"x\"", "two\nlines", "", "Ω 5", "\\", "tab\tin", "null", "-1"];
    let mut table = "x;y;key\n".to_owned();
    for key in keys.iter().chain(&keys) {
        writeln!(table, "1;2;\"{}\"", key.replace('"', "\"\"")).unwrap();
    }
    let directory = directory_with(&[("t.csv", table.as_bytes())]);
    let fleet = "fit t.csv --by key --x x --y y --eps 1";
    let run = boundfit(directory.path(), &format!("{fleet} --format json"));
    let groups: Vec<Value> = lines_of(&run).iter().map(|line| line["group"].clone()).collect();
    assert_eq!(groups, keys);
    let csv = boundfit(directory.path(), &format!("{fleet} --format csv")).stdout;
    for key in
        ["\n\"a,b\",2,1,", "\n\"say \"\"x\"\"\",2,2,", "\n\"two\nlines\",2,3,", "\n,2,4,", "\nΩ 5,2,5,"]
    {
        assert!(csv.contains(key), "{key}: {csv}");
    }
    let text = boundfit(directory.path(), fleet).stdout;
    assert_eq!(text.lines().count(), 1 + keys.len() + 3, "{text}");
    assert!(text.contains("\n\"two\\nlines\"  2     strip"), "{text}");
}

#[test]
fn the_same_bytes_for_any_number_of_threads() {
    let mut table = "key,x,y\n".to_owned();
    let mut rng = seeded(5);
    for turn in 0..3 {
        for group in 0..4500 {
            writeln!(table, "s{},{turn},{}", group * 7 % 4500, rng.random_range(-9..=9)).unwrap();
        }
    }
    let directory = directory_with(&[("t.csv", table.as_bytes())]);
    for format in ["text", "json", "csv"] {
        let line = words(&format!("fit t.csv --by key --x x --y y --eps 2 --format {format}"));
        let outputs = ["1", "2", "8"].map(|threads| {
            let mut command = command(directory.path());
            finish(command.args(&line).env("RAYON_NUM_THREADS", threads), b"")
        });
        assert_eq!(outputs[0].status, 3);
        assert_eq!(
            outputs[0].stdout.lines().count(),
            4500 + [0, 1, 4][["json", "csv", "text"].iter().position(|f| *f == format).unwrap()]
        );
        for output in &outputs[1..] {
            assert!(output.stdout == outputs[0].stdout && output.stderr == outputs[0].stderr, "{format}");
        }
    }
}

#[test]
fn tables_without_a_header_and_other_delimiters() {
    let directory = directory_with(&[("t.txt", b"1|x\t1,5\t2\t2\n2\t1,5\t3\t3\n1|x\t1,5\t2.5\t2.5\n")]);
    let line = "fit t.txt --delimiter tab --header no --by 2 --x 3 --y 4 --eps 1 --format csv";
    let run = boundfit(directory.path(), line);
    assert_eq!(run.stdout.lines().nth(1).map(|row| &row[..17]), Some("\"1,5\",3,1,polygon"));
    let run = boundfit(directory.path(), &line.replace("--by 2", "--by 1"));
    let keys: Vec<&str> = run.stdout.lines().skip(1).map(|row| row.split(',').next().unwrap()).collect();
    assert_eq!(keys, ["1|x", "2"]);
}

#[test]
fn rows_are_counted_in_the_file() {
    let run = boundfit(&root(), &format!("{LEVELS} --eps 0.01 --rows 8..11 --format json"));
    let lines = lines_of(&run);
    let seen: Vec<(&str, u64, u64)> = lines
        .iter()
        .map(|line| {
            (
                line["group"].as_str().unwrap(),
                line["first_row"].as_u64().unwrap(),
                line["rows"].as_u64().unwrap(),
            )
        })
        .collect();
    assert_eq!(seen, [("T-101", 8, 1), ("T-102", 9, 1), ("north, inlet", 10, 1), ("T-103", 11, 1)]);
    let summary = "4 groups, 4 rows: 4 unbounded\n";
    assert_eq!((run.status, run.stderr.as_str()), (0, summary));
}

#[test]
fn the_first_row_of_a_large_group_is_its_own() {
    let mut table = "g,x,y\na,5,10.5\n".to_owned();
    (0..20_000).for_each(|k| writeln!(table, "a,{k},{}.{:02}", 2 * k, k * k % 97).unwrap());
    let directory = directory_with(&[("all.csv", table.as_bytes())]);
    let run = boundfit(directory.path(), "fit all.csv --by g --x x --y y --eps 2 --format json");
    let line = &lines_of(&run)[0];
    assert_eq!([&line["rows"], &line["first_row"]], [&json!(20_001), &json!(1)]);
}

#[test]
fn a_file_is_written_whole_or_not_at_all() {
    let directory = directory_with(&[("levels.csv", fixture("fleet/levels.csv").as_bytes())]);
    let fleet = "fit levels.csv --by sensor --x V --y level --eps 0.01";
    for format in ["json", "csv", "text"] {
        let run = boundfit(directory.path(), &format!("{fleet} --format {format} -o out"));
        let summary = if format == "text" { "" } else { SUMMARY };
        assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (3, "", summary));
        let on_standard_output = boundfit(directory.path(), &format!("{fleet} --format {format}"));
        let written = std::fs::read_to_string(directory.path().join("out")).unwrap();
        assert_eq!(written, on_standard_output.stdout);
    }
    let run = boundfit(directory.path(), &format!("{fleet} -o absent/out"));
    assert_eq!(run.status, 1);
    assert!(run.stderr.starts_with("error: absent/out: cannot write: "), "{}", run.stderr);
    assert_eq!(files_in(directory.path()), ["levels.csv", "out"]);
}

#[test]
fn a_reader_that_goes_away_ends_it_quietly() {
    let mut table = "key,x,y\n".to_owned();
    for group in 0..6000 {
        writeln!(table, "s{group},1,2\ns{group},3,{group}").unwrap();
    }
    let directory = directory_with(&[("t.csv", table.as_bytes())]);
    for format in ["text", "json", "csv"] {
        let line = words(&format!("fit t.csv --by key --x x --y y --eps 1 --format {format}"));
        let mut child = command(directory.path()).args(line).spawn().unwrap();
        let mut first = String::new();
        BufReader::with_capacity(1, child.stdout.take().unwrap()).read_line(&mut first).unwrap();
        assert!(first.len() > 20, "{first}");
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), b"".as_slice()), "{format}");
    }
}

#[test]
fn bad_data_is_one_message_and_nothing_else() {
    let directory = directory_with(&[
        ("word.csv", b"key,x,y\na,1,2\nb,2,x\na,3,4\n"),
        ("bound.csv", b"key,x,y,e\na,1,2,1\nb,2,3,-1\n"),
        ("ragged.csv", b"key,x,y\na,1,2\nb,2\n"),
        ("mixed.csv", b"key,x,y\n\xc3\xa4,1,2\n\xe4,2,3\n"),
        ("nothing.csv", b"key,x,y\n"),
    ]);
    let fleet = |file: &str| format!("fit {file} --by key --x x --y y --eps 1");
    for (line, message) in [
        (fleet("word.csv"), format!("word.csv: line 3, column 3 (y): \"x\": not a number: unexpected character 'x' at character 1 {A_NUMBER}")),
        (
            "fit bound.csv --by key --x x --y y --eps-column e".to_owned(),
            "bound.csv: line 3, column 4 (e): \"-1\": the error bound is negative (expected a number that is at least 0)".to_owned(),
        ),
        (fleet("ragged.csv"), "ragged.csv: line 3: the row has 2 cells where the first row has 3 (expected as many cells in every row, also where a value is missing)".to_owned()),
        (
            fleet("word.csv").replace("--by key", "--by unit"),
            "word.csv: line 1: there is no column \"unit\" (expected one of \"key\", \"x\", \"y\" or a number from 1 to 3)".to_owned(),
        ),
        (fleet("nothing.csv"), "nothing.csv: the file has a header but no data rows (expected at least one row of numbers)".to_owned()),
    ] {
        refuses(directory.path(), &line, 1, &message);
    }
    let run = boundfit(directory.path(), &fleet("mixed.csv"));
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.starts_with("error: mixed.csv: line 3, column 1 (key): "), "{}", run.stderr);
}

#[test]
fn what_does_not_go_together_is_bad_usage() {
    for (options, message) in [
        (
            "--eps 1 --by z --sweep 1..2",
            "error: the argument '--by <COL>' cannot be used with '--sweep <FROM..TO>'\n",
        ),
        ("--eps 1 --by z --format wkt", "error: '--by' writes text, json or csv\n"),
        (
            "--eps 1 --by ''",
            "error: invalid value '' for '--by <COL>': expected a header name or a column number\n",
        ),
    ] {
        let run =
            boundfit(&root(), &format!("fit fixtures/transducer/transducer.csv --x Vz --y z {options}"));
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{options}");
        assert!(run.stderr.starts_with(message), "{options}: {}", run.stderr);
    }
    let run = boundfit(&root(), "check fixtures/transducer/transducer.csv --x Vz --y z --eps 1 --format csv");
    assert_eq!(run.status, 2);
    assert!(run.stderr.contains("invalid value 'csv' for '--format <FORMAT>'"), "{}", run.stderr);
}

#[test]
fn the_help_says_what_a_fleet_is_and_which_status_it_ends_with() {
    let help = printed(&root(), "fit --help");
    for part in [
        "--by <COL>\n",
        "--by sensor --x V --y level",
        "has a line\n          of text, JSON or CSV per group",
        "3  the feasible parameter set is empty (with --by or a window, at least one set); the proof is",
    ] {
        assert!(help.contains(part), "{part}: {help}");
    }
}

#[test]
fn group_names_run_nothing_on_a_terminal() {
    let table = "g,x,y\na\u{1b}[2J,1,2\na\u{1b}[2J,2,3\n";
    let directory = directory_with(&[("a.csv", table.as_bytes())]);
    let csv = boundfit(directory.path(), "fit a.csv --x x --y y --eps 1 --by g --format csv").stdout;
    assert!(csv.lines().nth(1).unwrap().starts_with("a\\u{1b}[2J,2,1,"), "{csv}");
}

#[test]
fn the_lines_below_groups_and_windows_fit_a_page() {
    let mut table = "sensor,x,y\n".to_owned();
    for sensor in 0..9 {
        (0..4).for_each(|row| {
            writeln!(table, "a sensor with a long name {sensor},{row},{}", row * row).unwrap()
        });
    }
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    for (options, below) in [
        (
            "--by sensor --eps 0.1",
            "9 groups, 36 rows: 9 empty\n\
             No theta meets every bound of: a sensor with a long name 0, a sensor with a long\n\
             name 1, a sensor with a long name 2, a sensor with a long name 3, a sensor with\n\
             a long name 4 and 4 more\n",
        ),
        (
            "--by sensor --eps min",
            "Assumed: no error is larger than eps_min of its own group, a bound found from\n\
             these very readings\n",
        ),
        (
            "--window 3 --eps min",
            "Assumed: no error is larger than eps_min of all readings, a bound found from\n\
             these very readings: 1\n",
        ),
    ] {
        let run = boundfit(directory.path(), &format!("fit data.csv --x x --y y {options}"));
        assert!(run.stdout.ends_with(below), "{}", run.stdout);
        assert!(run.stdout.lines().all(|line| line.chars().count() <= 80), "{}", run.stdout);
    }
}
