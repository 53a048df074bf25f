//! MATLAB files: the numbers that are stored, and errors for what cannot be used, however broken the bytes are.

mod files;
mod structs;

use std::fs;
use std::io::Write;
use std::path::Path;

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{
    Batch, ColumnSelector, InputError, Missing, RowCondition, RowRange, RowSet, ScanOptions, SizeLimits,
    Source, TableOptions, read_table, scan,
};
use boundfit_tests::program::{root, run, run_with_input};
use serde_json::Value;

use files::{Variable, deflated, doubles, file, header, matrix, number};

type Rows = Vec<(usize, Vec<Rational>)>;

fn columns(names: &[&str]) -> Vec<ColumnSelector> {
    names.iter().map(|name| ColumnSelector::name_or_number(name)).collect()
}

fn read(path: &Path, names: &[&str], options: &TableOptions) -> Result<Rows, InputError> {
    let table = read_table(Source::open(path.to_str().unwrap())?, &columns(names), options)?;
    Ok(table.rows.into_iter().map(|row| (row.row, row.numbers)).collect())
}

fn scanned(path: &Path, names: &[&str], options: &TableOptions) -> Result<Rows, InputError> {
    let options = ScanOptions { table: options.clone(), ..ScanOptions::default() };
    let rows = |batch: Batch| -> Rows {
        let row = |index| batch.columns.iter().map(|column| column.get(index)).collect();
        (0..batch.rows.len()).map(|index| (batch.rows.get(index), row(index))).collect()
    };
    let mut all = Rows::new();
    scan(Source::open(path.to_str().unwrap())?, &columns(names), &options, rows, |rows| all.extend(rows))?;
    Ok(all)
}

/// The rows of a file, read in both ways, or the message without the name of the file.
fn both(bytes: &[u8], names: &[&str], options: &TableOptions) -> Result<Rows, String> {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(bytes).unwrap();
    let message = |error: InputError| {
        let message = error.to_string();
        message.strip_prefix(file.path().to_str().unwrap()).unwrap().trim_start_matches(": ").to_owned()
    };
    let found = read(file.path(), names, options).map_err(message);
    assert_eq!(scanned(file.path(), names, options).map_err(message), found);
    found
}

fn message(bytes: &[u8], names: &[&str]) -> String {
    both(bytes, names, &TableOptions::default()).unwrap_err()
}

fn exact(numbers: &[f64]) -> Rows {
    let row = |(row, &number)| (row, vec![Rational::from_f64(number).unwrap()]);
    (1..).zip(numbers).map(row).collect()
}

/// The fit of the transducer from a table, without the hash of its bytes.
fn transducer(file: &str, options: &[&str]) -> Value {
    let fit = ["fit", file, "--rows", "14..36", "--eps", "0.5e-3", "--format", "json"];
    let run = run(&[&fit[..], options].concat());
    assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{file}");
    let mut report: Value = serde_json::from_str(&run.stdout).unwrap();
    report["input"]["sha256"] = Value::Null;
    report["input"]["file"] = Value::Null;
    // The format in which a text was read.
    report["input"]["table"] = Value::Null;
    report
}

#[test]
fn the_fit_is_that_of_the_table_as_binary64() {
    let names = ["--x", "Vz", "--y", "z"];
    let csv = [&names[..], &["--reading", "binary64"]].concat();
    let expected = transducer("fixtures/transducer/transducer.csv", &csv);
    assert_eq!(expected["input"]["reading"], "binary64");
    for file in ["fixtures/mat/transducer-v6.mat", "fixtures/mat/transducer-v7.mat"] {
        assert_eq!(transducer(file, &names), expected, "{file}");
        assert_eq!(transducer(file, &[&names[..], &["--reading", "binary64"]].concat()), expected, "{file}");
    }
    let mut of_matrix = transducer("fixtures/mat/transducer-v7.mat", &["--x", "M(:,1)", "--y", "4"]);
    assert_eq!((&of_matrix["input"]["x"][0], &of_matrix["input"]["y"]), (&"M(:,1)".into(), &"M(:,2)".into()));
    of_matrix["input"] = expected["input"].clone();
    assert_eq!(of_matrix, expected);
}

#[test]
fn every_command_for_tables_reads_them() {
    let file = "fixtures/mat/transducer-v7.mat";
    let data = [file, "--x", "Vz", "--y", "z", "--rows", "14..36", "--eps", "0.5e-3"];
    let text = run(&[&["fit"][..], &data].concat());
    let reading = "reading  binary64: the numbers of the file exactly as stored\n";
    assert!(text.status == 0 && text.stdout.contains(reading), "{text:?}");
    for command in [&["plot"][..], &["lesson"], &["check", "--solver", "exact-simplex"]] {
        let (command, options) = command.split_first().unwrap();
        let run = run(&[&[*command][..], &data, options].concat());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{command}");
    }
    let by = run(&["fit", file, "--by", "M(:,1)", "--x", "Vz", "--y", "z", "--eps", "1"]);
    assert!(by.status == 0 && by.stdout.contains("\n-6.9582  1     strip"), "{by:?}");
}

#[test]
fn a_reduction_is_text_of_the_same_doubles() {
    let reduced = run(&["reduce", "fixtures/mat/transducer-v7.mat", "--x", "M(:,1)", "--y", "z"]);
    assert_eq!((reduced.status, reduced.stderr.as_str()), (0, ""));
    let fit = ["--x", "M(:,1)", "--y", "z", "--eps", "0.5", "--format", "json", "--no-eui"];
    let of = |file: &str, options: &[&str]| {
        let run = run_with_input(&[&["fit", file][..], &fit, options].concat(), reduced.stdout.as_bytes());
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{file}");
        serde_json::from_str::<Value>(&run.stdout).unwrap()
    };
    let (part, whole) = (of("-", &["--reading", "binary64"]), of("fixtures/mat/transducer-v7.mat", &[]));
    // Rows are counted anew.
    for key in ["central", "epsilon_min", "tightness", "area_centroid"] {
        assert_eq!(part[key], whole[key], "{key}");
    }
    let refused = run(&["reduce", "fixtures/mat/scipy.mat", "--x", "d", "--y", "i64"]);
    assert_eq!((refused.status, refused.stdout.as_str()), (1, ""));
    assert!(refused.stderr.contains("no double has this value"), "{}", refused.stderr);
}

#[test]
fn numbers_of_scipy_are_exact() {
    let path = root().join("fixtures/mat/scipy.mat");
    let of = |name: &str, values: &[Rational]| {
        let expected: Rows = (1..).zip(values).map(|(row, value)| (row, vec![value.clone()])).collect();
        for reading in [Reading::Decimal, Reading::Binary64] {
            let options = TableOptions { reading, ..TableOptions::default() };
            assert_eq!(read(&path, &[name], &options).unwrap(), expected, "{name}");
            assert_eq!(scanned(&path, &[name], &options).unwrap(), expected, "{name}");
        }
    };
    let integers = |first: i64| (first..first + 6).map(Rational::from).collect::<Vec<_>>();
    for (name, first) in [
        ("i8", -3),
        ("u8", 250),
        ("i16", -29_999),
        ("u16", 60_001),
        ("i32", 1 - (1 << 31)),
        ("u32", (1 << 32) - 7),
        ("i64", (1 << 62) + 1),
    ] {
        of(name, &integers(first));
    }
    let beyond = Rational::from(1_i64 << 62) * Rational::from(4_i64);
    of("u64", &integers(-7).iter().map(|offset| offset + &beyond).collect::<Vec<_>>());
    of("b", &[0, 1, 0, 1, 0, 1].map(|bit: i64| Rational::from(bit)));
    of("d", &(1..=6).map(|k| Rational::from_f64(f64::from(k) * 0.1).unwrap()).collect::<Vec<_>>());
    let single = |k: i32| Rational::from_f64(f64::from((f64::from(k) * 0.1) as f32)).unwrap();
    of("f", &(1..=6).map(single).collect::<Vec<_>>());
    of("M(:, 2)", &(0..6).map(|k| Rational::ratio(3 * k + 1, 8)).collect::<Vec<_>>());
    of("14", &(0..6).map(|k| Rational::ratio(3 * k + 2, 8)).collect::<Vec<_>>());
}

#[test]
fn both_byte_orders_compressed_or_not() {
    let row = doubles("row", 1, 3, &[0.1, -2.5, 1e300]);
    let column = Variable { dimensions: vec![3, 1], name: "column", ..row.clone() };
    let packed =
        Variable { name: "packed", kind: 2, numbers: vec![vec![7], vec![0], vec![255]], ..column.clone() };
    let variables = [row, column, packed];
    for (is_big, is_compressed) in [(false, false), (false, true), (true, false), (true, true)] {
        let bytes = file(&variables, is_big, is_compressed);
        let found = |name| both(&bytes, &[name], &TableOptions::default()).unwrap();
        assert_eq!(found("row"), exact(&[0.1, -2.5, 1e300]));
        assert_eq!(found("2"), exact(&[0.1, -2.5, 1e300]));
        assert_eq!(found("packed"), exact(&[7.0, 0.0, 255.0]));
        let wanted = TableOptions { rows: RowRange::new(2, 3).into(), ..TableOptions::default() };
        assert_eq!(both(&bytes, &["row"], &wanted).unwrap(), exact(&[0.1, -2.5, 1e300])[1..]);
    }
}

#[test]
fn other_variables_are_refused_by_name() {
    let path = root().join("fixtures/mat");
    let expected = "(expected a vector or matrix of real numbers: double, single, integer or logical, full)";
    let of = |file: &str, names: &[&str]| {
        let bytes = fs::read(path.join(file)).unwrap();
        message(&bytes, names)
    };
    for (file, name, what) in [
        ("scipy.mat", "txt", "text"),
        ("scipy.mat", "c", "complex"),
        ("scipy.mat", "z3", "an array of 3 dimensions"),
        ("scipy.mat", "e", "empty"),
        ("transducer-v7.mat", "note", "text"),
        ("others.mat", "sparse_x", "sparse"),
        ("others.mat", "cells", "a cell array"),
    ] {
        assert_eq!(of(file, &[name]), format!("the variable {name:?} is {what} {expected}"));
    }
    assert_eq!(
        of("scipy.mat", &["d", "M"]),
        "the variable \"M\" is a matrix of 6 rows and 3 columns (expected one of its columns, \"M(:,1)\" to \"M(:,3)\")"
    );
    let unknown = of("transducer-v7.mat", &["Vx"]);
    assert_eq!(
        unknown,
        "there is no column \"Vx\" (expected one of \"Vz\", \"z\", \"M(:,1) to M(:,2)\", \"s.a\")"
    );
    assert!(of("transducer-v7.mat", &["6"]).ends_with(" or a number from 1 to 5)"));
    assert!(of("transducer-v7.mat", &["M(:,3)"]).starts_with("there is no column \"M(:,3)\""));
    assert!(of("hdf5.mat", &["z"]).starts_with("this is an HDF5 file; save its table as CSV"));
    let mut newer = header(false);
    newer[..19].copy_from_slice(b"MATLAB 7.3 MAT-file");
    newer[124..126].copy_from_slice(b"\x00\x02");
    let expected =
        "this is a MATLAB file of version 7.3, which is HDF5; save it with -v7: save('FILE.mat', '-v7')";
    assert_eq!(message(&newer, &["z"]), expected);
    let twice = file(&[doubles("x", 1, 1, &[1.0]), doubles("x", 1, 1, &[2.0])], false, true);
    assert!(message(&twice, &["x"]).starts_with("there are several columns \"x\""));
}

#[test]
fn rows_are_picked_by_lists_and_comparisons() {
    let x: Vec<f64> = (0..60).map(|k| f64::from(k * 7 % 23)).collect();
    // Columns that no selector picks may hold infinite numbers.
    let y: Vec<f64> =
        x.iter().enumerate().map(|(k, &x)| if x < 5.0 { f64::NAN } else { k as f64 / 8.0 }).collect();
    let bytes = file(&[doubles("x", 60, 1, &x), doubles("y", 60, 1, &y)], false, true);
    let range = |first, last| RowRange::new(first, last).unwrap();
    for (wanted, without, bound) in [
        (&[][..], &[][..], 5.0),
        (&[range(3, 20), range(31, 31)][..], &[][..], 9.5),
        (&[][..], &[range(1, 7), range(40, 50)][..], 20.0),
    ] {
        let condition = RowCondition::parse(&format!("x >= {bound}"), Reading::Binary64, &Limits::default());
        let options = TableOptions {
            rows: RowSet::new(wanted, without).unwrap(),
            conditions: vec![condition.unwrap(), any_condition("1 != 21")],
            keep_others: true,
            ..TableOptions::default()
        };
        let is_in =
            |ranges: &[RowRange], row: usize| ranges.iter().any(|range| RowSet::from(*range).contains(row));
        let is_wanted = |(row, x): (usize, f64)| {
            (wanted.is_empty() || is_in(wanted, row)) && !is_in(without, row) && x >= bound && x != 21.0
        };
        let rows = (1..).zip(&x).filter(|&(row, &x)| is_wanted((row, x))).map(|(row, _)| row);
        let expected: Rows = rows.map(|row| (row, vec![Rational::from_f64(y[row - 1]).unwrap()])).collect();
        assert!(expected.len() > 1);
        assert_eq!(both(&bytes, &["y"], &options).unwrap(), expected);
    }
    let none = TableOptions { conditions: vec![any_condition("x > 22")], ..TableOptions::default() };
    assert_eq!(both(&bytes, &["x"], &none).unwrap_err(), "of the file's 60 data rows none satisfies x > 22");
    let bad = TableOptions { conditions: vec![any_condition("y > 0")], ..TableOptions::default() };
    let message = both(&bytes, &["x"], &bad).unwrap_err();
    assert_eq!(
        message,
        "row 1, column 2 (y): \"NaN\": the value is missing, and in 12 rows more (expected a number in every row)"
    );
    // A cell that is no number decides no comparison: the row is left out, unless another comparison does not hold.
    let skip = |conditions: &[&str]| TableOptions {
        conditions: conditions.iter().map(|text| any_condition(text)).collect(),
        missing: Missing::Skip,
        ..TableOptions::default()
    };
    for (conditions, is_wanted) in [
        (&[][..], (&|_: f64, y: f64| !y.is_nan()) as &dyn Fn(f64, f64) -> bool),
        (&["y > 2"], &|_, y| y > 2.0),
        (&["y > 2", "x > 7"], &|x, y| y > 2.0 && x > 7.0),
    ] {
        let rows = (1..).zip(x.iter().zip(&y)).filter(|&(_, (&x, &y))| is_wanted(x, y));
        let expected: Rows = rows.map(|(row, (_, &y))| (row, vec![Rational::from_f64(y).unwrap()])).collect();
        assert_eq!(both(&bytes, &["y"], &skip(conditions)).unwrap(), expected);
        let source = || {
            let mut file = tempfile::NamedTempFile::new().unwrap();
            file.write_all(&bytes).unwrap();
            let source = Source::open(file.path().to_str().unwrap()).unwrap();
            (file, source)
        };
        let (_file, source) = source();
        let missing = read_table(source, &columns(&["y"]), &skip(conditions)).unwrap().scanned.rows_missing;
        assert_eq!(missing, if conditions.len() == 2 { 0 } else { 13 });
    }
    let nothing = file(&[doubles("y", 2, 1, &[f64::NAN, f64::NAN])], false, true);
    assert_eq!(
        both(&nothing, &["y"], &skip(&[])).unwrap_err(),
        "row 1, column 1 (y): \"NaN\": the value is missing, and no row that is asked for has all its values (2 without) \
         (expected a row with all its numbers)"
    );
}

fn any_condition(text: &str) -> RowCondition {
    RowCondition::parse(text, Reading::Binary64, &Limits::default()).unwrap()
}

#[test]
fn a_bad_cell_is_named_by_row_and_column() {
    let x = doubles("x", 4, 1, &[1.0, 2.0, 3.0, 4.0]);
    let bad = doubles("M", 4, 2, &[1.0, 2.0, 3.0, f64::NAN, 5.0, f64::NEG_INFINITY, 7.0, -8.0]);
    let bytes = file(&[x, bad], false, true);
    let nan = "row 4, column 2 (M(:,1)): \"NaN\": the value is missing, in this row only (expected a number in every row)";
    assert_eq!(message(&bytes, &["x", "M(:,1)"]), nan);
    let infinite = "row 2, column 3 (M(:,2)): \"-Inf\": not a finite number (expected a finite number)";
    assert_eq!(message(&bytes, &["x", "M(:,2)"]), infinite);
    let first =
        TableOptions { rows: RowRange::new(1, 3).into(), keep_others: true, ..TableOptions::default() };
    assert_eq!(both(&bytes, &["M(:,1)"], &first).unwrap(), exact(&[1.0, 2.0, 3.0]));
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(&bytes).unwrap();
    let epsilon = [ColumnSelector::name_or_number("M(:,2)").non_negative()];
    let wanted = TableOptions { rows: RowRange::new(3, 4).into(), ..TableOptions::default() };
    let source = Source::open(file.path().to_str().unwrap()).unwrap();
    let negative = read_table(source, &epsilon, &wanted).unwrap_err().to_string();
    assert!(negative.contains("row 4, column 3 (M(:,2)): \"-8\": the error bound is negative"), "{negative}");
    let source = Source::open(file.path().to_str().unwrap()).unwrap();
    let others = read_table(
        source,
        &columns(&["M(:,2)"]),
        &TableOptions { rows: RowRange::new(1, 1).into(), keep_others: true, ..TableOptions::default() },
    );
    let others: Vec<usize> = others.unwrap().others.iter().map(|row| row.row).collect();
    assert_eq!(others, [3, 4]);
}

#[test]
fn columns_must_have_one_length() {
    let bytes = file(&[doubles("x", 2, 1, &[1.0, 2.0]), doubles("y", 1, 3, &[1.0, 2.0, 3.0])], true, false);
    assert_eq!(
        message(&bytes, &["x", "y"]),
        "the column \"x\" has 2 numbers, but \"y\" has 3 (expected columns of one length)"
    );
    both(&bytes, &["y"], &TableOptions::default()).unwrap();
}

#[test]
fn limits_are_named_with_the_option_that_raises_them() {
    let limit = |elements| {
        let sizes = SizeLimits { elements, ratio: u64::MAX, ..SizeLimits::default() };
        TableOptions { sizes, ..TableOptions::default() }
    };
    // A thousand times as large as what it is packed into.
    let zeros = file(&[doubles("x", 500_000, 1, &[0.0; 500_000])], false, true);
    assert!(zeros.len() < 8_000);
    let refused = both(&zeros, &["x"], &limit(499_999)).unwrap_err();
    assert_eq!(refused, "refused: the variable \"x\" has 500000 elements, more than 499999 (the limit)");
    assert_eq!(both(&zeros, &["x"], &limit(500_000)).unwrap().len(), 500_000);
    // More is announced than any machine has.
    let huge = doubles("x", i32::MAX as u32, i32::MAX as u32, &[1.0]);
    for is_compressed in [false, true] {
        let bytes = file(std::slice::from_ref(&huge), false, is_compressed);
        assert!(message(&bytes, &["1"]).contains("has 4611686014132420609 elements, more than 100000000"));
        let all = both(&bytes, &["1"], &limit(usize::MAX)).unwrap_err();
        assert!(all.contains("numbers of 8 bytes are announced, but 8 bytes follow"), "{all}");
        // Nobody asked for it.
        let beside = file(&[huge.clone(), doubles("y", 1, 1, &[1.0])], false, is_compressed);
        both(&beside, &["y"], &TableOptions::default()).unwrap();
    }
    let negative = doubles("x", u32::MAX, 1, &[1.0]);
    assert!(message(&file(&[negative], false, false), &["x"]).contains("a dimension is negative"));
    let fewer = doubles("x", 1, 2, &[1.0, 2.0, 3.0]);
    assert!(
        message(&file(&[fewer], false, true), &["x"]).contains("2 numbers of 8 bytes are announced, but 24")
    );
}

#[test]
fn damaged_files_are_errors() {
    let variables = [doubles("x", 3, 1, &[1.0, 2.0, 3.0]), doubles("y", 3, 1, &[4.0, 5.0, 6.0])];
    for is_compressed in [false, true] {
        let whole = file(&variables, false, is_compressed);
        let expected = both(&whole, &["x", "y"], &TableOptions::default()).unwrap();
        for length in 128..whole.len() {
            let cut = message(&whole[..length], &["x", "y"]);
            assert!(
                cut.contains("it stops within") || cut.contains("no column") || cut.contains("no data"),
                "{length}: {cut}"
            );
        }
        for position in 0..whole.len() {
            for flip in [0xff, 0x01, 0x80] {
                let mut bytes = whole.clone();
                bytes[position] ^= flip;
                // A checksum guards what is compressed; elsewhere a wrong byte may be another number.
                if let Ok(rows) = both(&bytes, &["1", "2"], &TableOptions::default())
                    && is_compressed
                {
                    assert_eq!(rows, expected, "{position}");
                }
            }
        }
    }
    let behind = [matrix(&variables[0], false), vec![0; 8]].concat();
    let content = deflated(&behind);
    let bytes = [header(false), number(15, false), number(content.len() as u32, false), content].concat();
    assert!(message(&bytes, &["x"]).contains("more is inflated than announced"));
}

#[test]
fn standard_input_is_read_like_a_file() {
    let bytes = fs::read(root().join("fixtures/mat/transducer-v6.mat")).unwrap();
    let fit = |file| run_with_input(&["fit", file, "--x", "Vz", "--y", "z", "--eps", "1"], &bytes);
    let of_file = fit("fixtures/mat/transducer-v6.mat").stdout;
    let run = fit("-");
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert_eq!(run.stdout.replace("standard input", "fixtures/mat/transducer-v6.mat"), of_file);
}

#[cfg(unix)]
#[test]
fn a_pipe_is_opened_once() {
    let folder = tempfile::tempdir().unwrap();
    let script = "mkfifo pipe && { printf 'x,y\\n1,2\\n2,3\\n' > pipe & } && \"$BOUNDFIT\" fit pipe --x x --y y --eps 1";
    let mut shell = std::process::Command::new("sh");
    shell.args(["-c", script]).current_dir(folder.path()).env("BOUNDFIT", boundfit_tests::program::binary());
    let output = shell.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Octave 7.3 gave the numbers of elements: a limit is an element where it is as near to one as rounding leaves it.
#[test]
fn a_range_of_octave_has_its_number_of_elements() {
    for (kind, numbers, elements, last) in [
        ("range", "0 1 0.10000000000000001", 11, 1.0),
        ("double_range", "726.57650774824924 726.83600525954591 0.25949751129671139", 2, 726.8360052595459),
        ("double_range", "73038.343833697887 73033.518012704095 -0.20981830407800806", 24, 73033.5180127041),
        ("global double_range", "-73.625 -73.625 0.017", 1, -73.625),
        ("double_range", "-86.375 -73.625000000000043 0.017000000000000001", 751, -73.62500000000004),
        ("double_range", "72 -3407.9999999999986 -4", 871, -3408.0),
        ("double_range", "82.875 625.73213214285714 7.1428571428571432", 76, 618.5892857142858),
    ] {
        let text = format!(
            "# Created by Octave 7.3.0\n# name: r\n# type: {kind}\n# base, limit, increment\n{numbers}\n"
        );
        let rows = both(text.as_bytes(), &["r"], &TableOptions::default()).unwrap();
        let end = rows.last().unwrap().1[0].to_f64();
        assert_eq!((rows.len(), end), (elements, last), "{numbers}");
    }
    let global = b"# name: A\n# type: global matrix\n# rows: 2\n# columns: 1\n 1.5\n -2\n\n\n";
    assert_eq!(both(global, &["A"], &TableOptions::default()).unwrap(), exact(&[1.5, -2.0]));
}
