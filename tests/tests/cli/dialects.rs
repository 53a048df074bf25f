//! Text tables as spreadsheets, R, numpy and loggers write them: what is said of them, and what is refused.

use boundfit_tests::cli::refusals::refuses;
use boundfit_tests::cli::{boundfit, directory_with, printed};

#[test]
fn what_is_found_out_is_said() {
    let directory = directory_with(&[
        ("de.csv", "Umfang;Höhe\n8;70\n8,6;65,5\n10,7;72\n".as_bytes()),
        ("savetxt.txt", b"# made by numpy\n# speed dist\n4.0 2\n7.0 4.5\n8 16\n"),
        ("R.txt", b"\"speed\" \"dist\"\n\"1\" 4 2\n\"2\" 7 4\n\"3\" 8 16\n"),
        ("trail.csv", b"U (mV),I [mA]\n1,2,\n2,3,\n4,5,\n,,\n# source: me\n"),
        ("missing.csv", b"x,y\n1,NA\n2,3\n,4\n5,6\n7,8\n"),
        ("units.csv", b"U\tI\nmV\tmA\n1\t2\n2\t3,5\n"),
        ("thousands.csv", b"x,y\n\"60,323\",1\n83000,2\n"),
        ("quoted.csv", b"x,y\n\"0,5\",\"-1,5\"\n\"1,234\",\"1,300\"\n\"9,5\",\"10,5\"\n"),
    ]);
    for (line, facts) in [
        ("fit quoted.csv --x x --y y --eps 2", "decimal comma, separated by commas"),
        // The second look, without the readings that decide, begins with what may be grouped digits.
        ("status quoted.csv --x x --y y --eps 2", "decimal comma, separated by commas"),
        ("fit de.csv --x Umfang --y Höhe --eps 10", "decimal comma, separated by semicolons"),
        ("fit savetxt.txt --x speed --y dist --eps 10", "separated by blanks"),
        ("fit R.txt --x speed --y dist --eps 10", "separated by blanks"),
        ("fit trail.csv --x U --y I --eps 1", "trail.csv, 3 rows"),
        (
            "fit missing.csv --x x --y y --eps 1 --missing skip",
            "missing.csv, 5 rows, 2 rows with missing values left out",
        ),
        ("fit units.csv --x U --y I --eps 1 --units-row", "decimal comma, separated by tabs"),
        (
            "fit thousands.csv --x x --y y --eps 1 --thousands ,",
            "digits grouped by \",\", separated by commas",
        ),
    ] {
        let report = printed(directory.path(), line);
        assert!(report.contains(&format!("{facts}\n")), "{line}\n{report}");
    }
    let json = printed(directory.path(), "fit missing.csv --x x --y y --eps 1 --missing skip --format json");
    assert!(json.contains("\"rows_missing\": 2,"), "{json}");
    let json = printed(directory.path(), "fit quoted.csv --x 1 --y 2 --eps 10 --format json");
    assert!(json.contains("\"delimiter\": \"comma\",\n      \"decimal\": \"comma\","), "{json}");
    let json = printed(directory.path(), "fit de.csv --x 1 --y 2 --eps 10 --format json");
    assert!(json.contains("\"delimiter\": \"semicolon\",\n      \"decimal\": \"comma\","), "{json}");
    let picture = printed(directory.path(), "plot units.csv --x U --y I --eps 1 --units-row");
    assert!(picture.contains("<svg"), "{picture}");
}

#[test]
fn a_comma_that_may_group_digits_is_said_where_no_report_says_it() {
    let directory = directory_with(&[
        ("open.csv", b"x;y\n1;60,323\n2;83,200\n3;101,500\n"),
        ("told.csv", b"x;y\n1;60,3\n2;83,200\n3;101,500\n"),
    ]);
    let note = "note: open.csv: decimal comma, separated by semicolons\n";
    for line in [
        "fit FILE --x x --y y --eps 9 --format csv",
        "plot FILE --x x --y y --eps 9",
        "reduce FILE --x x --y y --eps 9",
        "convert FILE --x x --y y --eps 9 --to lp --objective theta1-min",
    ] {
        let stderr = |file: &str| boundfit(directory.path(), &line.replace("FILE", file)).stderr;
        assert_eq!((stderr("open.csv").as_str(), stderr("told.csv").as_str()), (note, ""), "{line}");
    }
    let run = boundfit(directory.path(), "fit open.csv --x x --y y --eps 9");
    assert!(run.stderr.is_empty(), "{}", run.stderr);
}

#[test]
fn what_cannot_be_found_out_is_refused_with_the_option_that_tells() {
    let directory = directory_with(&[
        ("missing.csv", b"x,y,z,w\n1,NA,1,1\n2,3,1,2\n,4,1,3\n5,6,?,4\n"),
        ("all.csv", b"x,y\n1,NA\nnan,2\n"),
        ("units.csv", b"U,I\nmV,mA\n1,2\n"),
        ("mixed.csv", b"1;2\n2;3\n3,5;4\n4.5;5\n"),
        ("asked.csv", b"x;y\n1.5;2\n"),
        ("thousands.csv", b"x,y\n\"60,323\",1\n"),
        ("groups.csv", b"x;y\n60,32;1\n"),
        ("undivided.csv", b"Device: X\n\nx;y\n1;2\n"),
        ("blanks.txt", b"x y\n1 2\n"),
        ("date.csv", b"x;y\n1,5;2\n"),
        ("grouped.csv", b"Zeit;Weg;Temp\n500;1;20,4\n1.000;2;20,5\n2.000;3;20,6\n"),
        ("decimals.csv", b"Zeit;Weg;Temp\n0.500;1;20,4\n1.250;2;20,5\n"),
    ]);
    for (line, message) in [
        (
            "fit missing.csv --x x --y y --eps 1",
            "missing.csv: line 2, column 2 (y): \"NA\": the value is missing, and in 1 row more (expected a number in \
             every row); --missing skip leaves such rows out",
        ),
        (
            "fit missing.csv --x w --y z --eps 1",
            "missing.csv: line 5, column 3 (z): \"?\": the value is missing, in this row only (expected a number in every \
             row); --missing skip leaves such rows out",
        ),
        (
            "fit all.csv --x x --y y --eps 1 --missing skip",
            "all.csv: line 2, column 2 (y): \"NA\": the value is missing, and no row that is asked for has all its values \
             (2 without) (expected a row with all its numbers)",
        ),
        (
            "fit units.csv --x U --y I --eps 1",
            "units.csv: line 2, column 1 (U): \"mV\": not a number, nor is any other cell of this row that is asked for \
             (expected a row of numbers); --units-row passes over a row of units, --skip-lines N passes over lines before the table",
        ),
        (
            "fit mixed.csv --x 1 --y 2 --eps 1",
            "mixed.csv: line 4, column 1: \"4.5\": a number with a decimal point, where those before have a decimal comma \
             (expected one decimal mark); --decimal comma|point says which, --thousands CHARACTER says what groups digits",
        ),
        (
            "fit grouped.csv --x Zeit --y Weg --eps 1",
            "grouped.csv: line 3, column 3 (Temp): \"20,5\": a number with a decimal comma, where those before have a decimal \
             point (expected one decimal mark); --decimal comma|point says which, --thousands CHARACTER says what groups digits",
        ),
        (
            "fit asked.csv --x x --y y --eps 1 --decimal comma",
            "asked.csv: line 2, column 1 (x): \"1.5\": not a number: unexpected '.' (the decimal mark is a comma) at \
             character 2 (expected 1,5); --decimal point reads 1.5, --thousands '.' reads 60.323 as 60323",
        ),
        (
            "fit thousands.csv --x x --y y --eps 1",
            "thousands.csv: line 2, column 1 (x): \"60,323\": not a number: unexpected ',' (the decimal mark is a point) at \
             character 3 (expected 1.5); --decimal comma reads 1,5, --thousands ',' reads 60,323 as 60323",
        ),
        (
            "fit groups.csv --x x --y y --eps 1 --thousands ,",
            "groups.csv: line 2, column 1 (x): \"60,32\": not a number: digits that are not in groups of three at \
             character 4 (expected a decimal such as 1.30e-2 or a fraction such as 7/19)",
        ),
        (
            "fit undivided.csv --x x --y z --eps 1",
            "undivided.csv: line 1: there is no column \"x\", and nothing was found that separates columns in \"Device: X\" \
             (expected a column's number); --delimiter comma|semicolon|tab|space|pipe says what separates columns, \
             --skip-lines N passes over lines before the table",
        ),
    ] {
        refuses(directory.path(), line, 1, message);
    }
    for line in [
        "fit grouped.csv --x Zeit --y Weg --eps 1 --decimal point",
        "fit grouped.csv --x Zeit --y Weg --eps 500 --thousands . --decimal comma",
        "fit decimals.csv --x Zeit --y Weg --eps 1",
    ] {
        assert_eq!(boundfit(directory.path(), line).status, 0, "{line}");
    }
    for (line, said) in [
        ("fit date.csv --x x --y y --eps 1,5", "invalid value '1,5' for '--eps"),
        ("fit date.csv --x x --y y --eps 1 --comment ab", "expected auto, none or one character such as '#'"),
        (
            "fit date.csv --x x --y y --eps 1 --thousands , --decimal comma",
            "'--thousands' and '--decimal' name one mark: it cannot both group digits and come before decimals",
        ),
        (
            "reduce date.csv --x x --y y --thousands . --decimal point",
            "'--thousands' and '--decimal' name one mark: it cannot both group digits and come before decimals",
        ),
        ("fit date.csv --x x --y y --eps 1 --thousands ;", "expected one of \",\", \".\", \" \", \"'\""),
    ] {
        let run = boundfit(directory.path(), line);
        assert!(run.status == 2 && run.stderr.contains(said), "{}", run.stderr);
    }
}

#[test]
fn what_stands_before_the_table_is_passed_over() {
    let directory = directory_with(&[
        ("preamble.csv", b"Device: X\nmade, in haste\n\nx;y\n1;2\n2;3\n4;5\n"),
        ("bang.csv", b"! a note\nx,y\n1,2\n! another, one\n2,3\n4,5\n"),
    ]);
    for line in [
        "fit preamble.csv --x x --y y --eps 1 --skip-lines 3",
        "fit preamble.csv --x x --y y --eps 1",
        "fit bang.csv --x x --y y --eps 1 --comment ! --block all",
    ] {
        let report = printed(directory.path(), line);
        assert!(report.contains(", 3 rows\n"), "{line}\n{report}");
    }
}

#[test]
fn a_number_for_missing_values_is_read_as_the_cells_are() {
    let directory = directory_with(&[
        ("points.csv", b"x;y\n1;2\n2;-9.999\n3;5\n"),
        ("one.csv", b"x;y\n5;2\n2;1.000\n3;5\n"),
    ]);
    let rows = |line: &str| {
        printed(directory.path(), line).lines().find(|line| line.contains("rows")).map(str::to_owned)
    };
    for (line, said) in [
        (
            "fit points.csv --x x --y y --eps 1 --thousands . --missing skip --missing-as -9999",
            Some("1 row with missing"),
        ),
        ("fit one.csv --x x --y y --eps 1000 --thousands . --missing skip --missing-as 1", None),
        ("fit one.csv --x x --y y --eps 1000 --missing skip --missing-as 1", Some("1 row with missing")),
    ] {
        let found = rows(line).unwrap();
        assert_eq!(
            found.contains("missing"),
            said.is_some_and(|said| found.contains(said)),
            "{line}: {found}"
        );
    }
}

#[test]
fn a_row_of_numbers_is_no_row_of_units_whatever_groups_digits_or_stands_behind_them() {
    let directory = directory_with(&[
        ("blank.csv", b"x;y\n1 000,0;1 000,9\n500,0;500,1\n0,0;0,0\n"),
        ("apostrophe.csv", b"x,y\n1'000.0,1'000.9\n500.0,500.1\n"),
        ("unit.csv", b"x;y\n10 V;1,0 A\n20 V;2,0 A\n"),
        ("fluke.csv", b"x;y\n\"10,01 VDC\";\"1,5\"\n"),
        ("units.csv", b"x;y\nV;mV\n1;1\n2;2\n"),
        ("bare.csv", b"x;y\n1 000,0;1 000,9\n2 000,0;2 000,9\n"),
        ("own.csv", b"x;y\nV;mV\n1;1\n"),
    ]);
    let grouped = "unexpected character";
    let alone = "not a number: letters stand behind it, such as a unit (expected the number alone: a unit belongs in the header, \
                 or in a row of units below it)\n";
    let as_units =
        "line 2: a row of units was asked for, but this one has numbers in all cells that are asked for";
    for (line, parts) in [
        ("fit blank.csv --x x --y y --eps 1", [grouped, "--thousands ' ' reads digits in groups of three"]),
        (
            "fit apostrophe.csv --x x --y y --eps 1",
            [grouped, "--thousands \"'\" reads digits in groups of three"],
        ),
        ("fit blank.csv --x x --y y --eps 1 --units-row", ["blank.csv", as_units]),
        ("fit apostrophe.csv --x x --y y --eps 1 --units-row", ["apostrophe.csv", as_units]),
        ("fit unit.csv --x x --y y --eps 1", ["\"10 V\"", alone]),
        ("fit unit.csv --x x --y y --eps 1 --units-row", ["unit.csv", as_units]),
        ("fit fluke.csv --x x --y y --eps 1", ["\"10,01 VDC\"", alone]),
    ] {
        let message = boundfit(directory.path(), line).stderr;
        assert!(parts.iter().all(|part| message.contains(part)), "{line}\n{message}");
        assert!(!message.contains("--units-row"), "{line}\n{message}");
    }
    // The second table has such a row or not, whatever the first one has.
    for (new, rows) in [("bare.csv", "2 readings"), ("own.csv", "1 reading")] {
        let line = format!("status units.csv --x x --y y --units-row --thousands ' ' --eps 1 --new {new}");
        let report = boundfit(directory.path(), &line).stdout;
        assert!(report.contains(&format!("Further readings, {new}\n  {rows} against")), "{report}");
    }
}

/// Keys of JSON are names, numbers too.
#[test]
fn keys_that_are_numbers_are_listed_as_names() {
    let directory = directory_with(&[
        ("objects.json", br#"[{"1": 1, "2": 2}, {"1": 2, "2": 4}]"#),
        ("arrays.json", b"[[1, 2], [2, 4]]"),
    ]);
    let run = boundfit(directory.path(), "fit objects.json --x a --y 2 --eps 1");
    let expected = "error: objects.json: there is no column \"a\" (expected one of \"1\", \"2\")\n";
    assert_eq!((run.status, run.stderr.as_str()), (1, expected));
    let run = boundfit(directory.path(), "fit arrays.json --x a --y 2 --eps 1");
    assert!(run.stderr.contains("; the file has no header: ask for columns by number, 1 to 2"), "{run:?}");
}
