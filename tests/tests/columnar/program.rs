//! `boundfit fit` on binary tables.

use boundfit_tests::cli::{boundfit, directory_with};
use boundfit_tests::hostile::gzip;
use boundfit_tests::program::{root, run, run_with_input};
use serde_json::Value;

fn fitted(file: &str, options: &[&str]) -> Value {
    let path = format!("fixtures/arrow/{file}");
    let mut arguments =
        vec!["fit", &path, "--x", "count", "--y", "exact", "--eps", "2000", "--format", "json"];
    arguments.extend(options);
    let run = run(&arguments);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let mut report: Value = serde_json::from_str(&run.stdout).expect("the report is JSON");
    // Another file, other bytes, another hash.
    report["input"]["file"] = Value::Null;
    report["input"]["sha256"] = Value::Null;
    // The format in which a text was read.
    report["input"]["table"] = Value::Null;
    report
}

#[test]
fn the_report_is_that_of_the_csv() {
    for options in [&[][..], &["--rows", "4..27"], &["--reading", "binary64"], &["--no-eui"], &["--no-lp"]] {
        let expected = fitted("readings.csv", options);
        for file in ["polars.parquet", "polars.arrow", "pyarrow.parquet", "pyarrow.arrow", "pyarrow.arrows"] {
            assert_eq!(fitted(file, options), expected, "{file}, {options:?}");
        }
    }
}

#[test]
fn standard_input_asks_for_a_file() {
    let bytes = std::fs::read(root().join("fixtures/arrow/polars.parquet")).expect("the fixture is there");
    let run = run_with_input(&["fit", "-", "--x", "count", "--y", "exact", "--eps", "1"], &bytes);
    let words = "this is a Parquet file; it is read from a named file, not from standard input";
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.contains(words), "{}", run.stderr);
}

#[test]
fn nothing_unpacks_to_a_columnar_file() {
    let directory = directory_with(&[("b", &gzip(b"PAR1 and more"))]);
    let words = "error: b: this is a Parquet file; it is read from a file of its own, not out of a compressed one or another stream";
    for command in ["fit", "check"] {
        let run = boundfit(directory.path(), &format!("{command} b --x x --y y --eps 1"));
        assert_eq!((run.status, run.stdout.as_str()), (1, ""));
        assert!(run.stderr.starts_with(words), "{}", run.stderr);
    }
}

#[test]
fn a_reduction_fits_like_the_whole() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for reading in ["decimal", "binary64"] {
        let columns = ["--x", "count", "--y", "exact", "--reading", reading];
        for file in ["polars.parquet", "polars.arrow", "pyarrow.arrows"] {
            let path = folder.path().join(format!("{file}.{reading}"));
            let (whole, reduced) = (format!("fixtures/arrow/{file}"), path.to_str().expect("UTF-8"));
            let reduce = ["reduce", &whole, "-o", reduced];
            let run = boundfit_tests::program::run(&[&reduce[..], &columns].concat());
            assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{file}");
            let fit = |file: &str| {
                let fit = ["fit", file, "--eps", "1000000", "--format", "json"];
                let run = boundfit_tests::program::run(&[&fit[..], &columns].concat());
                let report: serde_json::Value = serde_json::from_str(&run.stdout).expect("JSON");
                [&report["fps"]["area"], &report["least_squares"]["theta"], &report["epsilon_min"]]
                    .map(Clone::clone)
            };
            assert_eq!(fit(reduced), fit(&whole), "{file} {reading}");
        }
    }
}

#[test]
fn damage_that_a_library_does_not_expect_is_an_error_and_nothing_else() {
    let mut bytes =
        std::fs::read(root().join("fixtures/arrow/pyarrow.arrows")).expect("the fixture is there");
    // The place of a column's numbers is now beyond the end.
    bytes[480] ^= 0x40;
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("damaged.arrows");
    std::fs::write(&path, bytes).expect("the folder can be written");
    let path = path.to_str().expect("UTF-8");
    let run = run(&["fit", path, "--x", "exact", "--y", "volts", "--eps", "1"]);
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert_eq!(run.stderr, format!("error: {path}: cannot read an Arrow IPC stream: it is damaged\n"));
}
