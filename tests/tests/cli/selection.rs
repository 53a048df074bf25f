//! Some of the rows: the same answer as from a file that has no others, whichever way it is read, and who says which.

use std::collections::BTreeSet;

use boundfit_tests::cli::{boundfit, directory_with, printed};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::Value;

/// Columns and error bound of every fit.
const FIT: &str = "--x x --y y --eps 20";

/// A table whose rows are numbered by its first column, and rows of it.
struct Case {
    rows: Vec<[i64; 4]>,
    options: String,
    picked: Vec<usize>,
}

fn case(rng: &mut ChaCha8Rng, count: usize) -> Case {
    let rows: Vec<[i64; 4]> = (1..=count as i64)
        .map(|row| [row, rng.random_range(0..50), rng.random_range(0..30), rng.random_range(-3..9)])
        .collect();
    let mut options = String::new();
    let mut picked: Vec<usize> = (1..=count).collect();
    let (mut ranges, mut members) = (Vec::new(), BTreeSet::new());
    for _ in 0..rng.random_range(0..3) {
        let first = rng.random_range(1..=count);
        let last = rng.random_range(first..=count);
        let (text, range) = match rng.random_range(0..4) {
            0 => (format!("{first}"), first..=first),
            1 => (format!("..{last}"), 1..=last),
            2 => (format!("{first}.."), first..=count),
            _ => (format!("{first}..{last}"), first..=last),
        };
        ranges.push(text);
        members.extend(range);
    }
    if !ranges.is_empty() {
        options += &format!(" --rows {}", ranges.join(","));
        picked.retain(|row| members.contains(row));
    }
    if rng.random_bool(0.5) {
        let [one, other] = [0; 2].map(|_| rng.random_range(1..=count));
        options += &format!(" --without {one},{other}");
        picked.retain(|row| *row != one && *row != other);
    }
    if rng.random_bool(0.5) {
        let (sign, holds) = *SIGNS.choose(rng).unwrap();
        let bound = rng.random_range(-2..8);
        let column = ["t", "4", "\"t\""].choose(rng).unwrap();
        options += &format!(" --where-row '{column} {sign} {bound}'");
        picked.retain(|row| holds(rows[row - 1][3], bound));
    }
    Case { rows, options, picked }
}

type Comparison = fn(i64, i64) -> bool;

/// The signs of comparisons, with the comparison of integers that each stands for.
const SIGNS: [(&str, Comparison); 6] = [
    ("<", |a, b| a < b),
    ("<=", |a, b| a <= b),
    ("=", |a, b| a == b),
    ("!=", |a, b| a != b),
    (">=", |a, b| a >= b),
    (">", |a, b| a > b),
];

fn text<'a>(rows: impl IntoIterator<Item = &'a [i64; 4]>) -> String {
    let line = |row: &[i64; 4]| format!("{},{},{},{}\n", row[0], row[1], row[2], row[3]);
    "n,x,y,t\n".to_owned() + &rows.into_iter().map(line).collect::<String>()
}

/// The report without what differs between a file and a part of it.
fn comparable(report: &str, numbers: &[usize]) -> Value {
    let mut report: Value = serde_json::from_str(report).unwrap();
    report["input"] = report["input"]["rows"].take();
    renumber(&mut report, numbers);
    report
}

/// Numbers of rows in a part of a file become those in the file.
fn renumber(value: &mut Value, numbers: &[usize]) {
    match value {
        Value::Object(fields) => {
            for (name, field) in fields {
                match field.as_u64().filter(|_| name == "row") {
                    Some(row) if !numbers.is_empty() => *field = numbers[row as usize - 1].into(),
                    _ => renumber(field, numbers),
                }
            }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| renumber(item, numbers)),
        _ => {}
    }
}

#[test]
fn rows_that_are_picked_are_fitted_like_a_file_of_them() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for _ in 0..60 {
        let Case { rows, options, picked } = case(&mut rng, 25);
        let part = text(picked.iter().map(|row| &rows[row - 1]));
        let directory = directory_with(&[("all.csv", text(&rows).as_bytes()), ("part.csv", part.as_bytes())]);
        let all = boundfit(directory.path(), &format!("fit all.csv {FIT} --format json --no-lp{options}"));
        if picked.is_empty() {
            assert_eq!(
                all.status,
                if all.stderr.contains("'--without <ROWS>'") { 2 } else { 1 },
                "{options}"
            );
            assert!(all.stderr.contains("none ") || all.stderr.contains("no row is left"), "{}", all.stderr);
            continue;
        }
        let by_hand = boundfit(directory.path(), &format!("fit part.csv {FIT} --format json --no-lp"));
        assert_eq!(all.status, by_hand.status, "{options}: {}", all.stderr);
        assert_eq!(comparable(&all.stdout, &[]), comparable(&by_hand.stdout, &picked), "{options}");
        // The proof finds the rows.
        let fit = format!("fit all.csv {FIT} --no-lp{options} --proof proof.json -o report.txt --force");
        assert_eq!(boundfit(directory.path(), &fit).status, all.status, "{options}");
        let verified = boundfit(directory.path(), "verify proof.json all.csv");
        assert_eq!((verified.status, verified.stderr.as_str()), (0, ""), "{options}: {}", verified.stdout);
        // Quotes keep the fast lane from reading it.
        let quoted = text(&rows).replace(",", "\",\"").replace('\n', "\"\n\"");
        let quoted = format!("\"{}", quoted.trim_end_matches('"'));
        let directory = directory_with(&[("all.csv", quoted.as_bytes())]);
        let slow = boundfit(directory.path(), &format!("fit all.csv {FIT} --format json --no-lp{options}"));
        assert_eq!(comparable(&slow.stdout, &[]), comparable(&all.stdout, &[]), "{options}");
    }
}

#[test]
fn a_stream_of_any_length_gives_the_rows_that_a_part_of_it_gives() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    for _ in 0..3 {
        let Case { rows, options, picked } = case(&mut rng, 40_000);
        if picked.is_empty() {
            continue;
        }
        let part = text(picked.iter().map(|row| &rows[row - 1]));
        let directory = directory_with(&[("all.csv", text(&rows).as_bytes()), ("part.csv", part.as_bytes())]);
        let fit = |file: &str, options: &str| {
            boundfit(directory.path(), &format!("fit {file} {FIT} --format json --no-lp{options}")).stdout
        };
        let expected = comparable(&fit("part.csv", ""), &picked);
        for threads in [1, 2, 8] {
            let found = fit("all.csv", &format!("{options} --threads {threads}"));
            assert_eq!(comparable(&found, &[]), expected, "{options} on {threads} threads");
        }
        // Its reduction is that of the part.
        let reduce = |file: &str, options: &str| {
            printed(directory.path(), &format!("reduce {file} --x x --y y{options}"))
        };
        assert_eq!(reduce("all.csv", &options), reduce("part.csv", ""), "{options}");
    }
}

#[test]
fn every_command_says_which_rows() {
    let directory = directory_with(&[("data.csv", b"x,y,t\n0,0,5\n1,1,6\n2,9,7\n3,3,x\n4,4,8\n")]);
    let some = "--rows 1..3,5 --without 3 --where-row 't < 8.5' --where-row '3 >= 5'";
    let line = |command: &str| format!("{command} data.csv --x x --y y --eps 1/2 {some}");
    let report = printed(directory.path(), &line("fit --no-lp"));
    let said = "rows 1..3,5 without 3 where t < 8.5 and 3 >= 5";
    assert!(report.replace("\n          ", " ").contains(&format!("data.csv, {said}: 3 of 5")), "{report}");
    let json: Value = serde_json::from_str(&printed(directory.path(), &line("fit --format json"))).unwrap();
    let selection = serde_json::json!({"rows": "1..3,5", "without": "3", "where_row": ["t < 8.5", "3 >= 5"]});
    assert_eq!((&json["input"]["rows"], &json["input"]["selection"]), (&3.into(), &selection));
    let programs = printed(directory.path(), &line("convert --to lp --objective theta1-min"));
    assert!(programs.contains(&format!("data.csv, {said}")), "{programs}");
    for (command, statuses) in
        [("check", [0, 4]), ("plot --figure data", [0, 0]), ("lesson", [0, 0]), ("fit --by t", [0, 0])]
    {
        let run = boundfit(directory.path(), &line(command));
        assert!(statuses.contains(&run.status), "{command}: {}", run.stderr);
    }
}

#[test]
fn a_cell_that_is_compared_must_be_a_number() {
    let directory = directory_with(&[("data.csv", b"x,y,t\n0,0,5\n1,1,warm\n2,2,7\n")]);
    let run = boundfit(directory.path(), "fit data.csv --x x --y y --eps 1 --where-row 't > 6'");
    let start = "error: data.csv: line 3, column 3 (t): \"warm\": not a number: ";
    assert!(run.status == 1 && run.stderr.starts_with(start), "{}", run.stderr);
    // Rows that are left out by number are not looked at.
    printed(directory.path(), "fit data.csv --x x --y y --eps 1 --where-row 't > 4' --without 2 --no-lp");
}
