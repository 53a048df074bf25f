//! `boundfit fit` on binary tables.

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
    // Other bytes, other hash.
    report["input"]["sha256"] = Value::Null;
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
fn standard_input_and_reduction_ask_for_something_else() {
    let bytes = std::fs::read(root().join("fixtures/arrow/polars.parquet")).expect("the fixture is there");
    let run = run_with_input(&["fit", "-", "--x", "count", "--y", "exact", "--eps", "1"], &bytes);
    let words = "this is a Parquet file; it is read from a named file, not from standard input";
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.contains(words), "{}", run.stderr);
    let run =
        boundfit_tests::program::run(&["reduce", "fixtures/arrow/polars.arrow", "--x", "1", "--y", "2"]);
    assert_eq!((run.status, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.contains("the rows of an Arrow IPC file have no text of their own"), "{}", run.stderr);
}
