//! Tables with a reading too many, a quote too few or marks of two kinds: no reading is lost without a word, and advice works.

use boundfit_tests::cli::refusals::refuses;
use boundfit_tests::cli::{boundfit, directory_with, printed, unbroken};

const RANGE: &[u8] = b"# Created by Octave 8\n# name: x\n# type: range\n# base, limit, increment\n\
0 1.1000000000000001 0.10000000000000001\n\n\n# name: y\n# type: matrix\n# rows: 12\n# columns: 1\n\
 0.3\n 0.9\n 2.2\n 2.8\n 4.1\n 4.9\n 6.3\n 6.8\n 8.1\n 9.2\n 9.9\n 11.1\n\n\n";

#[test]
fn no_reading_is_lost_without_a_word() {
    let directory = directory_with(&[
        ("texts.json", br#"[["1","10.5"],["2","20.25"],["3","31"],["4.5","44"]]"#),
        ("named.json", br#"[["t","U"],["2","20.25"],["3","31"],["4.5","44"]]"#),
        ("longer.json", b"[[1,1],\n[2,3,null],\n[3,4,\"\"]]"),
        ("grouped.csv", b"x;y\n1;1.000\n2;2.500\n3;3.100,5\n"),
        ("blanks.csv", "x;y\n1;1 000\n2;2\u{a0}500,5\n3;3\u{202f}600\n".as_bytes()),
        ("torn.csv", b"x,y,note\n1,5,\"5\"7\n2,20,\"a\" \n3,\"30\" ,b\n"),
    ]);
    for (line, facts) in [
        (
            "fit texts.json --x 1 --y 2 --eps 2",
            "texts.json, 4 rows\n  reading  decimal: numbers exactly as written\n  table    no header, the first array is a \
             reading (else header yes)\n",
        ),
        ("fit texts.json --x 1 --y 2 --eps 2 --header no", "texts.json, 4 rows"),
        ("fit texts.json --x 1 --y 10.5 --eps 2 --header yes", "texts.json, 3 rows"),
        ("fit named.json --x t --y U --eps 2", "named.json, 3 rows"),
        ("fit longer.json --x 1 --y 2 --eps 1", "longer.json, 3 rows"),
        ("fit grouped.csv --x x --y y --eps 500 --thousands .", "digits grouped by \".\""),
        ("fit blanks.csv --x x --y y --eps 500 --thousands ' '", "digits grouped by \" \""),
        ("fit torn.csv --x x --y y --eps 10", "torn.csv, 3 rows"),
    ] {
        let report = printed(directory.path(), line);
        assert!(report.contains(facts), "{line}\n{report}");
    }
}

#[test]
fn damaged_tables_are_refused_and_advice_works() {
    let directory = directory_with(&[
        ("mixed.json", b"[{\"x\":2,\"y\":3},\n[7,8],\n{\"x\":4,\"y\":3}]"),
        ("arrays.json", b"[[2,3],\n{\"x\":4,\"y\":3}]"),
        ("longer.json", b"[[1,1],\n[2,3,4],\n[3,4]]"),
        ("units.csv", b"x,y\n1,10.5\n2,20.25\n3,31\n"),
        ("comment.txt", b"x y\n# m s\n1 2\n2 3\n3 5\n"),
        ("one.csv", b"x,y\n-,mA\n1,2\n2,3\n"),
        ("torn.csv", b"x,y\n1,\"5\"7\n2,20\n3,30\n"),
        ("torn.txt", b"x y\n1 \"5\"7\n2 20\n3 30\n"),
        ("matrix.txt", b"# name: M\n# type: matrix\n# rows: 3\n# columns: 2\n 1 2\n 2 3\n 3 5\n 4 9\n\n\n"),
        ("scalar.txt", b"# name: x\n# type: scalar\n3\n4\n\n\n# name: y\n# type: scalar\n3\n\n\n"),
        ("long.txt", b"# name: x\n# type: range\n# base, limit, increment\n0 1e15 1e-3\n\n\n# name: y\n# type: scalar\n3\n\n\n"),
        ("marks.csv", b"x;y\n1;1.000\n2;2.500\n3;3.100,5\n"),
        ("points.csv", b"x;y\n1;1,000\n2;2,500.5\n"),
        ("blanks.csv", b"x;y\n1;1 000\n2;2 500\n"),
        ("swiss.csv", b"x;y\n1;1'000\n2;2'500\n"),
    ]);
    for (line, message) in [
        (
            "fit mixed.json --x x --y y --eps 2",
            "mixed.json: line 2: \"[7,8],\": read as JSON, where an object, as the first record is, belongs here (expected \
             JSON with an object for each row, or a table of text such as CSV)",
        ),
        (
            "fit arrays.json --x 1 --y 2 --eps 2",
            "arrays.json: line 2: \"{\\\"x\\\":4,\\\"y\\\":3}]\": read as JSON, where an array, as the first record is, belongs \
             here (expected JSON with an object for each row, or a table of text such as CSV)",
        ),
        (
            "fit longer.json --x 1 --y 2 --eps 1",
            "longer.json: line 2: the row has 3 cells where the first row has 2 (expected as many cells in every row, also where a value is missing)",
        ),
        (
            "fit longer.json --x 1 --y 2 --eps 1 --units-row",
            "longer.json: a row of units is asked for, and this is neither text nor a workbook",
        ),
        (
            "fit matrix.txt --x 1 --y 2 --eps 1 --skip-lines 4",
            "matrix.txt: lines to skip are asked for, and this is neither text nor a workbook",
        ),
        (
            "fit units.csv --x x --y y --eps 2 --units-row",
            "units.csv: line 2: a row of units was asked for, but this one has numbers in all cells that are asked for \
             (expected units such as mm, or readings without a row of units)",
        ),
        (
            "fit comment.txt --x x --y y --eps 2 --units-row",
            "comment.txt: line 3: a row of units was asked for, but this one has numbers in all cells that are asked for \
             (expected units such as mm, or readings without a row of units)",
        ),
        (
            "fit one.csv --x x --y y --eps 2",
            "one.csv: line 2, column 2 (y): \"mA\": not a number, nor is any other cell of this row that is asked for \
             (expected a row of numbers); --units-row passes over a row of units, --skip-lines N passes over lines \
             before the table",
        ),
        (
            "fit torn.csv --x x --y y --eps 100",
            "torn.csv: line 2, column 2 (y): \"57\": text stands behind a closing quote (expected a delimiter behind the \
             quote, or no quotes)",
        ),
        (
            "fit torn.txt --x x --y y --eps 100",
            "torn.txt: line 2, column 2 (y): \"57\": text stands behind a closing quote (expected a delimiter behind the \
             quote, or no quotes)",
        ),
        (
            "fit matrix.txt --x 1 --y 2 --eps 1",
            "matrix.txt: cannot read Octave's text: line 8: \"M\" has more numbers than are announced",
        ),
        (
            "fit scalar.txt --x x --y y --eps 1",
            "scalar.txt: cannot read Octave's text: line 4: \"x\" has more numbers than are announced",
        ),
        (
            "fit long.txt --x x --y y --eps 1",
            "long.txt: the variable \"x\" is a range of more elements than a matrix may have (expected a \
             vector or matrix of real numbers: double, single, integer or logical, full)",
        ),
        (
            "fit marks.csv --x x --y y --eps 500",
            "marks.csv: line 4, column 2 (y): \"3.100,5\": not a number: unexpected ',' (the decimal mark is a point) at \
             character 6 (expected 1.5); --thousands '.' reads digits in groups of three",
        ),
        (
            "fit points.csv --x x --y y --eps 500",
            "points.csv: line 3, column 2 (y): \"2,500.5\": not a number: unexpected '.' (the decimal mark is a comma) at \
             character 6 (expected 1,5); --thousands ',' reads digits in groups of three",
        ),
        (
            "fit blanks.csv --x x --y y --eps 500",
            "blanks.csv: line 2, column 2 (y): \"1 000\": not a number: unexpected character '0' at character 3 (expected a \
             decimal such as 1.30e-2 or a fraction such as 7/19); --thousands ' ' reads digits in groups of three",
        ),
        (
            "fit swiss.csv --x x --y y --eps 500",
            "swiss.csv: line 2, column 2 (y): \"1'000\": not a number: unexpected character '\\'' at character 2 (expected \
             a decimal such as 1.30e-2 or a fraction such as 7/19); --thousands \"'\" reads digits in groups of three",
        ),
    ] {
        refuses(directory.path(), line, 1, message);
    }
}

/// Rows that lack a number are counted wherever `--missing skip` leaves them out, and so is what was found out about a table beside
/// the data.
#[test]
fn rows_that_are_left_out_are_said_everywhere() {
    let directory = directory_with(&[
        ("data.csv", b"g,x,y\nNA,1,1\na,2,NA\na,1,1\nb,NA,2\n"),
        ("plain.csv", b"x,y\n1,2\n2,3\n3,5\n4,6\n5,9\n"),
        ("beside.csv", b"a;x\n1;60,323\n2;NA\n3;1,5\n"),
        ("new.csv", b"x;y\n3,5;6\n4;NA\n4,5;30\n"),
        ("each.csv", b"x,y,e\n1,2,2\n2,3,2\n3,5,2\n4,6,1\n5,9,1\n"),
    ]);
    let data = "data.csv --x x --y y --eps 0.5 --missing skip";
    let left_out = "2 rows with missing values left out";
    for (line, on_stdout, words) in [
        (format!("fit {data} --by g"), true, left_out),
        (format!("fit {data} --by g --format csv"), false, left_out),
        (format!("fit {data} --by g --format json"), false, left_out),
        (format!("fit {data} --window 1"), true, left_out),
        (format!("fit {data} --window 1 --format csv"), false, left_out),
        (format!("fit {data} --format csv"), false, left_out),
        (format!("check {data} --claim-pui 0,1,0,1"), true, left_out),
        (format!("plot {data} -o data.svg"), false, left_out),
        (format!("convert {data} --to lp --objective theta1-max"), false, left_out),
        (format!("reduce {data} -o reduced.csv").replace(" --eps 0.5", ""), false, left_out),
        (
            "predict plain.csv --x x --y y --eps 1 --at beside.csv:x --missing skip".to_owned(),
            false,
            "note: beside.csv: decimal comma, separated by semicolons, 1 row with missing values left out\n",
        ),
        (
            "status plain.csv --x x --y y --eps 1 --new new.csv --missing skip".to_owned(),
            false,
            "note: new.csv: decimal comma, separated by semicolons, 1 row with missing values left out\n",
        ),
        (
            "fit plain.csv --x x --y y --eps 1.2*min --window 3".to_owned(),
            true,
            "Assumed: no error is larger than 6/5 times eps_min of all readings, a bound found from these very readings\n",
        ),
        (
            "check plain.csv --x x --y y --eps 1.2*min --claim-pui 0,1,0,1".to_owned(),
            true,
            "Assumed: that no error is larger than 1.2 times eps_min",
        ),
    ] {
        let run = boundfit(directory.path(), &line);
        let said = if on_stdout { &run.stdout } else { &run.stderr };
        assert!(unbroken(said).contains(&unbroken(words)), "{line}\n{run:?}");
    }
    // The first window has readings of one bound, by chance.
    let windows =
        boundfit(directory.path(), "fit each.csv --x x --y y --eps-column e --window 3 --format csv").stdout;
    assert!(windows.lines().skip(1).all(|line| line.ends_with(',')), "{windows}");
}

/// The numbers of a range are those that Octave would write, in every pass over them.
#[test]
fn a_range_of_octave_is_what_octave_would_write() {
    let numbers = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11].map(|step| match f64::from(step) * 0.1 {
        // The end of a range is its limit.
        _ if step == 11 => 1.1,
        number => number,
    });
    let y = ["0.3", "0.9", "2.2", "2.8", "4.1", "4.9", "6.3", "6.8", "8.1", "9.2", "9.9", "11.1"];
    let rows: Vec<String> = numbers.iter().zip(y).map(|(x, y)| format!("{x:.16e},{y}\n")).collect();
    let table = format!("x,y\n{}", rows.concat());
    let directory = directory_with(&[("range.txt", RANGE), ("table.csv", table.as_bytes())]);
    let folder = directory.path();
    let exact = |file: &str| {
        let report = printed(folder, &format!("fit {file} --x x --y y --eps 1/2 --exact --brief"));
        let from = report.find("  set ").unwrap();
        report[from..report.find("eps_min").unwrap()].to_owned()
    };
    let expected = exact("table.csv");
    assert_eq!(exact("range.txt"), expected);
    printed(folder, "reduce range.txt --x x --y y -o reduced.csv");
    assert_eq!(exact("reduced.csv"), expected);
    for reading in ["decimal", "binary64"] {
        let report = |file: &str| {
            let line = format!("fit {file} --x x --y y --eps 1/2 --format csv --reading {reading}");
            printed(folder, &line)
        };
        assert_eq!(report("range.txt"), report("table.csv"), "{reading}");
    }
}
