//! Bad data: the exact message with file, line, column and text, the status 1, and nothing written anywhere.

use boundfit_tests::program::root;

use boundfit_tests::cli::refusals::{A_NUMBER, refuses, refuses_files, refuses_options};
use boundfit_tests::cli::{
    boundfit, boundfit_with_input, directory_with, files_in, printed, unbroken, words,
};

#[test]
fn files_that_cannot_be_opened() {
    let absent = std::fs::File::open("no such file").unwrap_err();
    for line in ["fit absent.csv --x x --y y --eps 1", "polygon absent.csv", "polygon absent.ine"] {
        let file = words(line)[1].clone();
        refuses(&root(), line, 1, &format!("{file}: cannot read: {absent}"));
    }
    let message = "fixtures: is a directory (expected a file)";
    refuses(&root(), "fit fixtures --x x --y y --eps 1", 1, message);
    refuses(&root(), "polygon fixtures", 1, message);
    let message = "standard input: the file is empty (expected at least one row of numbers)";
    refuses(&root(), "fit - --x x --y y --eps 1", 1, message);
    refuses(&root(), "polygon -", 1, message);
}

#[test]
fn tables_of_the_wrong_shape() {
    let at_least_one = "(expected at least one row of numbers)";
    refuses_files(
        "fit",
        "--x x --y y --eps 1",
        &[
            ("empty.csv", &format!(": the file is empty {at_least_one}")),
            ("blank.csv", &format!(": the file is empty {at_least_one}")),
            ("header-only.csv", &format!(": the file has a header but no data rows {at_least_one}")),
            (
                "row-too-short.csv",
                ": line 3: the row has 1 cell where the first row has 2 (expected as many cells in every row, also where a value is missing)",
            ),
            (
                "row-too-long.csv",
                ": line 3: the row has 3 cells where the first row has 2 (expected as many cells in every row, also where a value is missing)",
            ),
            (
                "same-name-twice.csv",
                ": line 1: there are several columns \"x\" (expected a name that occurs once, or the column's number)",
            ),
        ],
    );
    // The ragged row counts even where its cells are not asked for.
    let message = ": line 3: the row has 1 cell where the first row has 2 (expected as many cells in every row, also where a value is missing)";
    refuses_files("fit", "--x x --y y --eps 1 --rows 1..1", &[("row-too-short.csv", message)]);
    // Told apart by number, the columns can be used.
    printed(&root(), "fit fixtures/bad-input/same-name-twice.csv --x 2 --y y --eps 1");
}

#[test]
fn cells_that_are_not_numbers() {
    let cases: &[(&str, &str, usize)] = &[
        ("abc", "unexpected character 'a'", 0),
        ("nan", "", 0),
        ("inf", "not a finite number", 0),
        ("-Infinity", "not a finite number", 1),
        ("1e999999999", "exponent beyond 10000 (the limit)", 2),
        ("1_000", "unexpected '_' (digits are not grouped)", 1),
        ("1,5", "", 0),
        ("0x10", "unexpected character 'x'", 1),
        ("", "", 0),
        ("   ", "", 0),
        ("1e", "a digit is missing", 2),
        ("1/0", "zero denominator", 2),
        ("1/-2", "unexpected character '-'", 2),
        ("1 000", "unexpected character '0'", 2),
        ("\u{2212}1", "", 0),
        ("1.2.3", "unexpected character '.'", 3),
        ("--1", "unexpected character '-'", 1),
        ("#N/A", "", 0),
        ("\u{1b}[31mred", "unexpected character '\\u{1b}'", 0),
        ("1e-999999999", "exponent beyond 10000 (the limit)", 3),
    ];
    // The others are numbers, missing values or decimal commas by now: see `dialects`.
    for (row, &(cell, problem, before)) in (1..).zip(cases).filter(|(_, (_, problem, _))| !problem.is_empty())
    {
        let options = format!("--x x --y y --eps 1 --rows {row}..{row}");
        let line = row + 1;
        let verdict = if problem.ends_with("(the limit)") {
            format!("refused: {problem} at character {}; --limit exponent=N raises it", before + 1)
        } else {
            let way = if cell == "1 000" { "; --thousands ' ' reads digits in groups of three" } else { "" };
            format!("not a number: {problem} at character {} {A_NUMBER}{way}", before + 1)
        };
        let message = format!(": line {line}, column 2 (y): {cell:?}: {verdict}");
        refuses_files("fit", &options, &[("numbers.csv", &message)]);
        // Without a header the column has no name.
        let directory = directory_with(&[("table.csv", format!("1;2\n{cell};3\n").as_bytes())]);
        let message = format!("table.csv: line 2, column 1: {cell:?}: {verdict}");
        refuses(directory.path(), "fit table.csv --x 1 --y 2 --eps 1", 1, &message);
    }
}

#[test]
fn names_that_are_nearly_there_headers_that_are_not_and_quotes_that_stay_open() {
    let directory = directory_with(&[
        ("hubble.csv", b"r (Mpc),v (km/s)\n1,2\n2,3\n"),
        ("plain.csv", b"\n1,2\n2,3\n"),
        ("open.csv", b"x,y\n1,2\n2,\"2\n2,3\n"),
        ("first.csv", b"\"x,y\n1,2\n2,3\n"),
        ("long.csv", b"x,y\n\"1\",2\n\"2,3\n4,5"),
        ("closed.csv", b"x,y\n1,2\n2,\"a\"\n"),
    ]);
    for (line, message) in [
        (
            "fit hubble.csv --x R --y v --eps 1",
            "hubble.csv: line 1: there is no column \"R\"; did you mean \"r (Mpc)\"? (expected one of \"r (Mpc)\", \
             \"v (km/s)\" or a number from 1 to 2)",
        ),
        (
            "fit plain.csv --x x --y y --eps 1",
            "plain.csv: line 2: there is no column \"x\"; the file has no header: ask for columns by number, 1 to 2",
        ),
        (
            "fit open.csv --x x --y y --eps 1",
            "open.csv: line 3: a quote that opens in this row is never closed",
        ),
        (
            "fit first.csv --x x --y y --eps 1",
            "first.csv: line 1: a quote that opens in this row is never closed",
        ),
        (
            "fit long.csv --x x --y y --eps 1",
            "long.csv: line 3: a quote that opens in this row is never closed",
        ),
        (
            "fit closed.csv --x x --y y --eps 1",
            "closed.csv: line 3, column 2 (y): \"a\": not a number: unexpected character 'a' at character 1 \
             (expected a decimal such as 1.30e-2 or a fraction such as 7/19)",
        ),
    ] {
        refuses(directory.path(), line, 1, message);
    }
}

#[test]
fn dates_are_no_fractions() {
    for date in ["03/04", "2012/01", "0/05", "2012/01/01", "1/2/3"] {
        let directory = directory_with(&[("table.csv", format!("x,y\n1/3,2\n{date},3\n").as_bytes())]);
        let message = format!(
            "table.csv: line 3, column 1 (x): {date:?}: not a number: this looks like a date (expected a decimal, a fraction such as \
             7/19, or in place of dates a column of seconds or days)"
        );
        refuses(directory.path(), "fit table.csv --x x --y y --eps 1", 1, &message);
    }
    let directory = directory_with(&[("table.csv", b"x,y\n1/3,2\n0/5,3\n10/4,2012\n")]);
    let report = printed(directory.path(), "fit table.csv --x x --y y --eps 3000 --no-lp");
    assert!(report.contains("\n  note     x: 3 cells are fractions such as 1/3\n"), "{report}");
    assert!(!report.contains("y: "), "{report}");
    let json = printed(directory.path(), "fit table.csv --x y --y x --eps 3000 --format json");
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let fractions = serde_json::json!([{"column": "x", "cells": 3, "first": "1/3"}]);
    assert_eq!(json["input"]["fractions"], fractions);
    let one = printed(directory.path(), "fit table.csv --x x --y y --eps 3000 --no-lp --rows 2 --header yes");
    assert!(one.contains("\n  note     x: 1 cell is a fraction, 0/5\n"), "{one}");
}

#[test]
fn half_planes_of_more_than_the_plane() {
    let directory = directory_with(&[
        ("space.csv", b"a1,a2,a3,b\n1,0,4,4\n"),
        ("more.csv", b"b,a2,a1,a12\n1,0,4,4\n"),
        ("other.csv", b"a1,a2,b,a,area,a0\n1,0,4,4,5,6\n"),
    ]);
    for (file, column) in [("space.csv", "a3"), ("more.csv", "a12")] {
        let message = format!(
            "{file}: there is a column \"{column}\", so these are not half-planes of the plane (expected columns a1, a2 \
             and b: a1*theta1 + a2*theta2 <= b)"
        );
        refuses(directory.path(), &format!("polygon {file}"), 1, &message);
    }
    printed(directory.path(), "polygon other.csv");
}

#[test]
fn numbers_without_end() {
    let digits = "7".repeat(20_000);
    let quoted = format!("\"{}\"...", "7".repeat(40));
    let directory = directory_with(&[
        ("table.csv", format!("x,y\n1,2\n{digits},3\n").as_bytes()),
        ("fraction.csv", format!("x,y\n1,2\n3,0.{digits}\n").as_bytes()),
        ("matrix.ine", format!("begin\n1 3 integer\n1 {digits} 0\nend\n").as_bytes()),
    ]);
    let message = |place: &str, before: usize| {
        format!(
            "{place}: {quoted}: refused: more than 10000 digits (the limit) at character {}; --limit digits=N raises it",
            before + 1
        )
    };
    let fit = "--x x --y y --eps 1";
    let path = directory.path();
    refuses(path, &format!("fit table.csv {fit}"), 1, &message("table.csv: line 3, column 1 (x)", 10_000));
    refuses(path, "polygon matrix.ine", 1, &message("matrix.ine: line 3, column 3", 10_000));
    let quoted_fraction = format!("\"0.{}\"...", "7".repeat(38));
    let in_fraction =
        message("fraction.csv: line 3, column 2 (y)", 10_001).replace(&quoted, &quoted_fraction);
    refuses(path, &format!("fit fraction.csv {fit}"), 1, &in_fraction);
}

#[test]
fn a_line_without_end() {
    let endless = "1".repeat((1 << 24) + 1);
    let directory = directory_with(&[
        ("row.csv", format!("x,y\n1,2\n{endless}").as_bytes()),
        ("header.csv", endless.as_bytes()),
        ("matrix.ine", format!("begin\n{endless}").as_bytes()),
    ]);
    for (command, file, line) in
        [("fit", "row.csv", 3), ("fit", "header.csv", 1), ("polygon", "matrix.ine", 2)]
    {
        let options = if command == "fit" { "--x x --y y --eps 1" } else { "" };
        let message = format!(
            "{file}: line {line}: the line is longer than 16777216 bytes (the limit); --limit line=N raises it"
        );
        refuses(directory.path(), &format!("{command} {file} {options}"), 1, &message);
    }
}

#[test]
fn numbers_beyond_binary64() {
    let options = "--x x --y y --eps 1 --reading binary64";
    let message = ": line 3, column 2 (y): \"1e400\": refused: overflows binary64";
    refuses_files("fit", options, &[("beyond-binary64.csv", message)]);
    printed(&root(), "fit fixtures/bad-input/beyond-binary64.csv --x x --y y --eps 1");
}

#[test]
fn text_in_other_encodings() {
    let way_out =
        "(expected text in UTF-8, as the characters before it are); --encoding windows-1252 reads any byte";
    refuses_files(
        "fit",
        "--x x --y y --eps 1",
        &[
            (
                "latin1.csv",
                ": line 3, column 2 (y): \"±3\": not a number: unexpected character '±' at character 1 (expected a decimal such as 1.30e-2 or a fraction such as 7/19)",
            ),
            (
                "mixed-encodings.csv",
                &format!(
                    ": line 3, column 2 (y): \"\u{fffd}3\": invalid UTF-8 at character 1 of the cell {way_out}"
                ),
            ),
            (
                "picture.csv",
                ": this is a PNG picture; a picture has no table; give the numbers behind it as CSV",
            ),
        ],
    );
    printed(&root(), "fit fixtures/bad-input/latin1.csv --x x --y y --eps 1 --rows 1..1");
    // Where the cell is not asked for, its encoding does not matter.
    printed(&root(), "fit fixtures/bad-input/mixed-encodings.csv --x x --y y --eps 1 --rows 1..1");
}

#[test]
fn what_a_text_is_encoded_as_is_told_or_asked_for() {
    let directory = directory_with(&[("latin1.csv", b"x,y,\xb0C\n1,2,3\n2,3,4\n")]);
    let fit = |options: &str| format!("fit latin1.csv --x 1 --y 2 --eps 1 --no-lp {options}");
    let table = |options: &str| {
        let report = printed(directory.path(), &fit(options));
        report.lines().find_map(|line| line.trim().strip_prefix("table")).map(|words| words.trim().to_owned())
    };
    assert_eq!(table(""), Some("Windows-1252".to_owned()));
    assert_eq!(table("--encoding Latin-1"), Some("ISO-8859-1".to_owned()));
    let message = "latin1.csv: line 1, column 3: \"\u{fffd}C\": invalid UTF-8 at character 1 of the cell (expected text in UTF-8, as the characters before it are); --encoding windows-1252 reads any byte";
    refuses(directory.path(), &fit("--encoding utf-8"), 1, message);
    let proof = boundfit(directory.path(), &fit("--proof proof.json"));
    assert!(
        proof.status != 0 && proof.stderr.contains("about the rows of plain delimited text"),
        "{}",
        proof.stderr
    );
    let unknown = boundfit(directory.path(), &fit("--encoding utf-7"));
    let expected = "expected one of \"auto\", \"utf-8\", \"windows-1252\", \"iso-8859-1\", \"iso-8859-15\", \"utf-16le\", \"utf-16be\"";
    assert!(unknown.status == 2 && unknown.stderr.contains(expected), "{}", unknown.stderr);
}

#[test]
fn error_bounds_below_zero() {
    let place = ": line 3, column 3 (eps): \"-1/2\"";
    let message = format!("{place}: the error bound is negative (expected a number that is at least 0)");
    refuses_files("fit", "--x x --y y --eps-column eps", &[("negative-bound.csv", &message)]);
    let expected = "(expected a number that is at least 0, such as 0.5e-3 or 1/2000)";
    let message = format!("invalid value '-1' for '--eps <NUM>': negative {expected}");
    refuses_options(2, &[("--x Vz --y z --eps -1", &message), ("--x Vz --y z --eps=-1", &message)]);
}

#[test]
fn h_representations_that_are_not_what_they_announce() {
    let whole = "(expected an H- or V-representation: begin, rows, end)";
    let size = "the size line is not understood (expected \"ROWS 3 integer\", \"ROWS 3 rational\" or \"ROWS 3 real\")";
    let linearity = "this does not list rows of the matrix to come (expected \"linearity COUNT ROW...\" before begin, with rows counted from 1)";
    refuses_files(
        "polygon",
        "",
        &[
            (
                "too-few-numbers.ine",
                ": line 6, column 1: \"end\": 3 rows of 3 numbers were announced, but there are 6 numbers before \"end\"",
            ),
            (
                "too-many-numbers.ine",
                ": line 6, column 1: \"end\": 1 rows of 3 numbers were announced, but there are 6 numbers before \"end\"",
            ),
            ("no-begin.ine", &format!(": there is no line \"begin\" {whole}")),
            (
                "no-end.ine",
                ": line 5: the file stops before the line \"end\"; 2 rows were announced and 6 numbers found",
            ),
            (
                "rows-beyond-limit.ine",
                ": line 3, column 1: \"10000001\": there are more than 10000000 rows (the limit); --limit rows=N raises it",
            ),
            (
                "nonnegative.ine",
                ": line 2, column 1: \"nonnegative\": this option makes the set another one (expected rows \"0 1 0\" and \"0 0 1\")",
            ),
            (
                "hull.ine",
                ": line 7, column 1: \"hull\": this option makes the set another one (expected a line \"V-representation\" before begin)",
            ),
            (
                "two-matrices.ine",
                ": line 8, column 1: \"begin\": a second matrix begins here (expected one representation in a file)",
            ),
            ("part-of-a-row.ext", ": line 6, column 1: \"end\": the last row has 2 of 3 numbers"),
            (
                "negative-weight.ext",
                ": line 5, column 1: \"-1\": the row starts with a negative number (expected 1 for a point or 0 for a ray)",
            ),
            (
                "linear-point.ext",
                ": line 5, column 1: \"1\": the row is a point, but a linearity line lists it (expected 0 x y for a line)",
            ),
            (
                "four-columns.ine",
                ": line 3, column 3: \"4\": the matrix has 4 columns, so it is not about the plane (expected 3 columns: b, -a1, -a2 or 1, x, y)",
            ),
            ("bad-size.ine", &format!(": line 3, column 1: \"many\": {size}")),
            ("bad-type.ine", &format!(": line 3, column 5: \"complex\": {size}")),
            (
                "bad-number.ine",
                &format!(
                    ": line 5, column 5: \"one\": not a number: unexpected character 'o' at character 1 {A_NUMBER}"
                ),
            ),
            ("linearity-beyond-rows.ine", &format!(": line 2, column 1: \"linearity 1 3\": {linearity}")),
            ("linearity-miscounted.ine", &format!(": line 2, column 1: \"linearity 2 1\": {linearity}")),
        ],
    );
    let run = boundfit(&root(), "polygon fixtures/bad-input/latin1.ine");
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    let start = "error: fixtures/bad-input/latin1.ine: line 3: invalid UTF-8 at character 5";
    assert!(run.stderr.starts_with(start), "{}", run.stderr);
}

#[test]
fn every_bad_file_is_refused() {
    let folder = root().join("fixtures/bad-input");
    let reading = "--reading binary64";
    for file in files_in(&folder) {
        let line = match file.as_str() {
            // UTF-16 is read.
            "README.md" | "utf16-be.csv" | "utf16-le.csv" => continue,
            "other-names.csv" => format!("polygon {file}"),
            "negative-bound.csv" => format!("fit {file} --x x --y y --eps-column eps"),
            file if file.ends_with(".ine") || file.ends_with(".ext") => format!("polygon {file}"),
            file => format!("fit {file} --x x --y y --eps 1 {reading}"),
        };
        assert_eq!(boundfit(&folder, &line).status, 1, "{line}");
    }
}

/// One reading, or readings at one x, leave a strip: an answer, with advice, not an error.
#[test]
fn too_few_readings_are_no_error() {
    let files: [(&str, &[u8]); 2] = [("one.csv", b"x,y\n5,2\n"), ("same-x.csv", b"x,y\n5,2\n5,2.5\n5,1.5\n")];
    let directory = directory_with(&files);
    for (file, _) in files {
        let text = printed(directory.path(), &format!("fit {file} --x x --y y --eps 1"));
        for line in [
            "Feasible parameter set (FPS): strip",
            "  goes on for ever in both directions of (1, -5)",
            "  One further reading at any x other than 5 would bound it.",
        ] {
            assert!(text.lines().any(|own| own == line), "{line}\n{text}");
        }
        let reason = "least squares none: the regressors are all parallel (for a line: fewer than two distinct x), so the normal equations are singular";
        assert!(unbroken(&text).contains(reason), "{text}");
    }
}

#[test]
fn lines_are_counted_as_editors_count_them() {
    for (table, line) in [
        ("x,y\r\n1,2\r\n2,abc\r\n", 3),
        ("x,y\n\n\n1,2\n\n2,abc\n", 6),
        ("\r\n\r\nx,y\r\n1,2\r\n\r\n2,abc\r\n", 6),
        ("x,y\r1,2\r2,abc\r", 3),
        ("\u{feff}x,y\n\"1\",2\n  \n2,abc\n", 4),
        ("x,y,note\n1,2,\"two\nlines\"\n2,abc,\n", 4),
    ] {
        let directory = directory_with(&[("table.csv", table.as_bytes())]);
        let message = format!(
            "table.csv: line {line}, column 2 (y): \"abc\": not a number: unexpected character 'a' at character 1 {A_NUMBER}"
        );
        refuses(directory.path(), "fit table.csv --x x --y y --eps 1", 1, &message);
    }
}

#[test]
fn equations_announced_too_late() {
    let late = "begin\n3 3 integer\n1 -1 -1\n0 1 0\n0 0 1\nend\nlinearity 1 1\n";
    let directory = directory_with(&[("late.ine", late.as_bytes())]);
    let message = "late.ine: line 7, column 1: \"linearity\": this does not list rows of the matrix to come (expected \"linearity COUNT ROW...\" before begin, with rows counted from 1)";
    refuses(directory.path(), "polygon late.ine", 1, message);
}

/// The first line of the message about a text.
fn message(options: &str, text: &str) -> String {
    let directory = directory_with(&[]);
    let columns = if options.contains("--x ") { "" } else { "--x x --y y" };
    let line = format!("fit - --eps 1 {columns} {options}");
    let run = boundfit_with_input(directory.path(), &line, text.as_bytes());
    assert_eq!(run.stdout, "", "{options} {text:?}");
    run.stderr.lines().next().unwrap_or_default().to_owned()
}

#[test]
fn records_on_one_line_are_told_apart() {
    let records = r#"[{"x":1,"y":2},{"x":2,"y":3},{"x":3},{"x":4,"y":5}]"#;
    let start = "error: standard input: line 1, row 3, column 2 (y): \"\": the value is missing";
    assert!(message("", records).starts_with(start), "{}", message("", records));
    let lines = message("", &records.replace("},", "},\n"));
    assert!(lines.starts_with("error: standard input: line 3, column 2 (y): \"\""), "{lines}");
}

#[test]
fn messages_name_only_ways_that_help() {
    let keys = message("--x 1 --y 2", r#"[{"2":1,"1":2},{"2":2,"1":3}]"#);
    assert!(keys.contains("is the name of column") && !keys.contains("--header"), "{keys}");
    let zero = message("", "x;y\n0'001;2\n2;3\n");
    assert!(zero.contains("\"0'001\"") && !zero.contains("--thousands"), "{zero}");
    let grouped = message("", "x;y\n1'001;2\n2;3\n");
    assert!(grouped.contains("reads digits in groups of three"), "{grouped}");
    let passed = message("--skip-lines 9", "x,y\n1,2\n2,3\n");
    let problem = "error: standard input: the file has no row behind the first 9 lines, which are passed over (expected at least one \
                   row of numbers)";
    assert_eq!(passed, problem);
    assert!(message("--skip-lines 9", "").contains("the file is empty"));
}

/// The first rows of a data logger: names, units, and how each number was made of many.
#[test]
fn two_rows_below_the_names_lead_to_columns_by_number() {
    let logged = "\"TOA5\",\"CR1000\",\"CPU:a.CR1\"\n\"TIMESTAMP\",\"U\",\"T\"\n\"TS\",\"Volts\",\"Deg C\"\n\"\",\"Avg\",\"Min\"\n\
                  \"2024-05-01 00:00:00\",12.5,15.1\n\"2024-05-01 00:10:00\",12.6,15.3\n";
    let asked = "--x U --y T";
    let first = message(asked, logged);
    assert!(first.contains("line 3, column 2 (U): \"Volts\"") && first.contains("--units-row"), "{first}");
    let second = message(&format!("{asked} --units-row"), logged);
    let ways = "; --skip-lines N passes over lines before the readings, --header no takes columns by number";
    assert!(second.contains("line 4, column 2 (U): \"Avg\"") && second.ends_with(ways), "{second}");
    let directory = directory_with(&[("a.dat", logged.as_bytes())]);
    let run = boundfit(directory.path(), "fit a.dat --x 2 --y 3 --eps 1 --skip-lines 4 --header no");
    assert_eq!(run.status, 0, "{}", run.stderr);
}

#[test]
fn times_in_records_are_called_so() {
    let said =
        message("", r#"[{"x":"2024-05-01T00:00:00.000Z","y":1},{"x":"2024-05-02T00:00:00.000Z","y":2}]"#);
    assert!(said.contains("\"2024-05-01T00:00:00.000Z\": a date or a time, not a number"), "{said}");
}
