//! The same data in every form of table gives the same answer, byte for byte but for the hash of the file.

use boundfit_tests::program::root;
use serde_json::Value;
use tempfile::TempDir;

use boundfit_tests::cli::{
    FIT_TRANSDUCER, TRANSDUCER, boundfit, directory_with, fixture, printed, printed_with_input, report,
};

/// The fit of the transducer's linearity interval, to which a table and ways to read it are added.
const FIT: &str = "--rows 14..36 --eps 0.5e-3 --format json";

/// The cells of the transducer's table, z and Vz, header first.
fn cells() -> Vec<[String; 2]> {
    let row = |line: &str| {
        let (z, voltage) = line.split_once(',').unwrap();
        [z.to_owned(), voltage.to_owned()]
    };
    fixture("transducer/transducer.csv").lines().map(row).collect()
}

/// The table with each row written by a function of its number (0 for the header) and its cells.
fn table(row: impl Fn(usize, &str, &str) -> String) -> String {
    cells().iter().enumerate().map(|(number, [z, voltage])| row(number, z, voltage)).collect()
}

/// The table without its header.
fn without_header(separator: &str) -> String {
    table(|number, z, voltage| if number == 0 { String::new() } else { format!("{z}{separator}{voltage}\n") })
}

fn in_directory(table: &str) -> TempDir {
    directory_with(&[("data.csv", table.as_bytes())])
}

/// A report without what it says of the file itself, and the hash of the file.
fn split_hash(report: &str) -> (Value, String) {
    let mut parsed: Value = serde_json::from_str(report).unwrap();
    let input = parsed["input"].as_object_mut().unwrap();
    let hash = input.remove("sha256").unwrap().as_str().unwrap().to_owned();
    input.remove("file");
    // The format that was detected is no part of the answer.
    input.remove("table");
    (parsed, hash)
}

/// Checks that a table, read with these options, gives the answer of the fixture.
fn same_answer(what: &str, table: &str, options: &str) {
    same_answer_with(what, table, options, &Value::Null);
}

/// Checks that a table, read with these options, gives the answer of the fixture, and is said to have these cells that are
/// fractions, or none.
fn same_answer_with(what: &str, table: &str, options: &str, fractions: &Value) {
    let (mut expected, original_hash) =
        split_hash(&printed(&root(), &format!("{FIT_TRANSDUCER} --format json")));
    if !fractions.is_null() {
        expected["input"]["fractions"] = fractions.clone();
    }
    let directory = in_directory(table);
    let answer = printed(directory.path(), &format!("fit data.csv {FIT} {options}"));
    // A table without a header has numbers for names.
    let answer = answer.replace("\"col2\"", "\"Vz\"").replace("\"col1\"", "\"z\"");
    let (answer, hash) = split_hash(&answer);
    assert!(answer == expected, "{what}: {table}\n{answer}");
    assert_eq!(hash == original_hash, table == fixture("transducer/transducer.csv"), "{what}");
}

#[test]
fn separators() {
    for (separator, name) in [(",", "comma"), (";", "semicolon"), ("\t", "tab")] {
        let named = table(|_, z, voltage| format!("{z}{separator}{voltage}\n"));
        same_answer(name, &named, "--x Vz --y z");
        same_answer(name, &named, &format!("--x Vz --y z --delimiter {name}"));
        let bare = without_header(separator);
        same_answer(name, &bare, "--x 2 --y 1");
        same_answer(name, &bare, &format!("--x 2 --y 1 --delimiter {name} --header no"));
    }
}

#[test]
fn columns_by_name_and_by_number() {
    let original = fixture("transducer/transducer.csv");
    for options in ["--x Vz --y z", "--x 2 --y 1", "--x Vz --y 1", "--x 2 --y z", "--x 2 --y 1 --header yes"]
    {
        same_answer(options, &original, options);
    }
    same_answer("spaces around a name", &original, "--x ' Vz ' --y z");
    let swapped = table(|_, z, voltage| format!("{voltage},{z}\n"));
    same_answer("swapped columns", &swapped, "--x Vz --y z");
    same_answer("swapped columns", &swapped, "--x 1 --y 2");
}

#[test]
fn other_columns_may_hold_anything() {
    let notes = table(|number, z, voltage| format!("{number},note {number},{z},\u{fc}ber,{voltage},,nan\n"));
    same_answer("notes", &notes, "--x Vz --y z");
    same_answer("notes", &notes, "--x 5 --y 3");
    let quoted = table(|_, z, voltage| format!("{z};\"a; \"\"b\"\",\nc\";{voltage}\n"));
    same_answer("a separator, quotes and a line end within quotes", &quoted, "--x Vz --y z");
    let semicolon = table(|number, z, voltage| format!("{z},{voltage},\"{number};\"\n"));
    same_answer("another separator within quotes", &semicolon, "--x Vz --y z");
    let empty_names =
        table(
            |number, z, voltage| {
                if number == 0 { format!("{z},{voltage},,\n") } else { format!("{z},{voltage},1,2\n") }
            },
        );
    same_answer("columns without names", &empty_names, "--x Vz --y z");
}

#[test]
fn quotes_spaces_and_notations() {
    let quoted = table(|_, z, voltage| format!("\"{z}\",\"{voltage}\"\n"));
    same_answer("quoted cells", &quoted, "--x Vz --y z");
    let spaces = table(|_, z, voltage| format!("  {z} ,   {voltage}  \n"));
    same_answer("spaces around cells", &spaces, "--x Vz --y z");
    let spaces_in_quotes = table(|_, z, voltage| format!("\" {z} \",\" {voltage}\"\n"));
    same_answer("spaces within quotes", &spaces_in_quotes, "--x Vz --y z");
    let signs = table(|number, z, voltage| match number {
        0 => format!("{z},{voltage}\n"),
        _ => format!("+{z}0,{}{voltage}\n", if voltage.starts_with('-') { "" } else { "+" }),
    });
    same_answer("signs and zeros", &signs, "--x Vz --y z");
    let scientific = table(|number, z, voltage| match number {
        0 => format!("{z},{voltage}\n"),
        _ => {
            // A whole number with a zero in front would make it a date.
            let (sign, digits) = voltage.strip_prefix('-').map_or(("", voltage), |digits| ("-", digits));
            let digits = digits.replace('.', "");
            format!("{}e-3,{sign}{}/10000\n", number - 1, digits.trim_start_matches('0'))
        }
    });
    // This line is the first among the rows that are fitted.
    let (_, first) = scientific.lines().nth(14).unwrap().split_once(',').unwrap();
    let fractions = serde_json::json!([{"column": "Vz", "cells": 23, "first": first}]);
    same_answer_with("scientific notation and fractions", &scientific, "--x Vz --y z", &fractions);
}

#[test]
fn line_ends_blank_lines_and_marks() {
    let original = fixture("transducer/transducer.csv");
    let crlf = original.replace('\n', "\r\n");
    same_answer("CRLF", &crlf, "--x Vz --y z");
    same_answer("byte order mark", &format!("\u{feff}{original}"), "--x Vz --y z");
    same_answer(
        "byte order mark and quotes",
        &format!("\u{feff}{}", original.replacen("z,Vz", "\"z\",Vz", 1)),
        "--x Vz --y z",
    );
    same_answer("byte order mark, no header", &format!("\u{feff}{}", without_header(",")), "--x 2 --y 1");
    same_answer("no line end at the end", original.trim_end(), "--x Vz --y z");
    same_answer("no line end at the end, CRLF", crlf.trim_end(), "--x Vz --y z");
    for blank in ["\n", "\r\n", "   \n", "\t\n"] {
        let start = format!("{blank}{blank}{original}");
        same_answer("blank lines at the start", &start, "--x Vz --y z");
        let middle = table(|number, z, voltage| match number {
            0 | 1 | 20 => format!("{z},{voltage}\n{blank}{blank}"),
            _ => format!("{z},{voltage}\n"),
        });
        same_answer("blank lines in the middle", &middle, "--x Vz --y z --block all");
        same_answer("blank lines at the end", &format!("{original}{blank}{blank}"), "--x Vz --y z");
    }
    let rows = table(|_, z, voltage| format!("\"{z}\"; {voltage} \r\n\r\n"));
    same_answer("everything at once", &format!("\u{feff}\r\n{rows}"), "--x Vz --y z");
}

#[test]
fn a_header_is_found_or_told() {
    let bare = without_header(",");
    same_answer("no header", &bare, "--x 2 --y 1");
    same_answer("no header", &bare, "--x 2 --y 1 --header no");
    let directory = in_directory(&bare);
    let told = report(directory.path(), "fit data.csv --x 2 --y 1 --eps 1 --header yes", b"");
    assert_eq!(told["input"]["rows_total"], 45, "the first row is taken for a header");
    let run = boundfit(&root(), &format!("fit {TRANSDUCER} --x 2 --y 1 --eps 1 --header no"));
    let problem = "\"Vz\": not a number: unexpected character 'V' at character 1";
    let expected = format!(
        "error: {TRANSDUCER}: line 1, column 2: {problem} (expected a decimal such as 1.30e-2 or a fraction such as 7/19)\n"
    );
    assert_eq!((run.status, run.stderr), (1, expected));
    // A first row of failed numbers is data, not a header.
    for cell in ["nan", "NaN", "inf", "NA", "n/a", "null", "None"] {
        let directory = in_directory(&format!("{cell};{cell}\n1;2\n"));
        let run = boundfit(directory.path(), "fit data.csv --x 1 --y 2 --eps 1");
        let problem = if cell == "inf" { "not a number: " } else { "the value is missing" };
        let start = format!("error: data.csv: line 1, column 1: {cell:?}: {problem}");
        assert!(run.stderr.starts_with(&start), "{}", run.stderr);
    }
}

#[test]
fn the_separator_that_is_told_is_used() {
    let directory = in_directory("t,u;x;y;v,w\n1,2;3;4;5,6\n");
    let x_and_y = |options: &str| {
        let input = report(directory.path(), &format!("fit data.csv --eps 1 {options}"), b"")["input"].take();
        [input["x"][0].clone(), input["y"].clone()]
    };
    assert_eq!(x_and_y("--x 2 --y y"), ["x", "y"], "a semicolon wins where both occur");
    assert_eq!(x_and_y("--x 2 --y y --delimiter semicolon"), ["x", "y"]);
    assert_eq!(x_and_y("--x 1 --y w --delimiter comma"), ["t", "w"]);
}

#[test]
fn standard_input_is_a_file_like_any_other() {
    let original = fixture("transducer/transducer.csv");
    let line = FIT_TRANSDUCER.replace(TRANSDUCER, "-");
    let json = printed_with_input(&root(), &format!("{line} --format json"), original.as_bytes());
    assert_eq!(split_hash(&json), split_hash(&printed(&root(), &format!("{FIT_TRANSDUCER} --format json"))));
    let text = printed_with_input(&root(), &line, original.as_bytes());
    assert_eq!(text.replace("standard input", TRANSDUCER), printed(&root(), FIT_TRANSDUCER));
}

/// A report with every row number moved on.
fn with_rows_moved(mut value: Value, by: u64) -> Value {
    match &mut value {
        Value::Object(fields) => {
            for (name, value) in fields.iter_mut() {
                *value = match value.as_u64() {
                    Some(row) if name == "row" => Value::from(row + by),
                    _ => with_rows_moved(value.take(), by),
                };
            }
        }
        Value::Array(items) => {
            items.iter_mut().for_each(|item| *item = with_rows_moved(item.take(), by));
        }
        _ => {}
    }
    value
}

#[test]
fn rows_are_counted_in_the_whole_file() {
    let cut = table(|number, z, voltage| {
        if number == 0 || (14..=36).contains(&number) { format!("{z},{voltage}\n") } else { String::new() }
    });
    let directory = in_directory(&cut);
    let mut of_cut =
        with_rows_moved(report(directory.path(), "fit data.csv --x Vz --y z --eps 0.5e-3", b""), 13);
    let whole = report(&root(), FIT_TRANSDUCER, b"");
    assert_eq!((&of_cut["input"]["rows_total"], &whole["input"]["rows_total"]), (&23.into(), &46.into()));
    of_cut["input"] = whole["input"].clone();
    assert_eq!(of_cut, whole);
    for (rows, count) in [("1..1", 1), ("46..46", 1), ("1..46", 46), ("45..46", 2), (" 14 .. 36 ", 23)] {
        let line = format!("fit {TRANSDUCER} --x Vz --y z --eps 1 --rows '{rows}'");
        assert_eq!(report(&root(), &line, b"")["input"]["rows"], count, "{rows}");
    }
}

#[test]
fn only_the_cells_asked_for_need_be_numbers() {
    let damaged = table(|number, z, voltage| match number {
        1 | 13 => format!("{z},broken\n"),
        37 => ",\n".to_owned(),
        46 => format!("nan,{voltage}\n"),
        _ => format!("{z},{voltage}\n"),
    });
    same_answer("damage outside the rows", &damaged, "--x Vz --y z");
    let directory = in_directory(&damaged);
    let run = boundfit(directory.path(), "fit data.csv --x Vz --y z --eps 1");
    assert!(run.stderr.starts_with("error: data.csv: line 2, column 2 (Vz): \"broken\": "), "{}", run.stderr);
}

#[test]
fn the_error_bound_is_the_same_number_in_every_notation() {
    let expected = printed(&root(), &format!("{FIT_TRANSDUCER} --format json"));
    for eps in
        ["5e-4", "0.0005", ".0005", "+0.00050", "1/2000", "5E-04", "0.05e-2", "50/100000", "' 0.5e-3 '"]
    {
        let line = FIT_TRANSDUCER.replace("0.5e-3", eps);
        assert_eq!(printed(&root(), &format!("{line} --format json")), expected, "{eps}");
    }
    let column = table(|number, z, voltage| {
        let eps = if number == 0 { "eps" } else { "5/10000" };
        format!("{z},{eps},{voltage}\n")
    });
    let directory = in_directory(&column);
    let per_row = report(directory.path(), "fit data.csv --x Vz --y z --eps-column eps --rows 14..36", b"");
    let uniform = report(&root(), FIT_TRANSDUCER, b"");
    for part in ["least_squares", "eui", "fps", "pui", "central", "inverse"] {
        assert_eq!(per_row[part], uniform[part], "{part}");
    }
}
