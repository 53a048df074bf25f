//! The refusals, with their words.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use arrow_array::{
    ArrayRef, BooleanArray, Date32Array, Float32Array, Float64Array, Int64Array, RecordBatch, StringArray,
};
use boundfit_exact::{Limits, Reading};
use boundfit_formats::{
    ColumnSelector, Missing, RowCondition, ScanOptions, Scanned, Source, TableOptions, scan,
};

use super::{FILES, message, scanned, scanned_text, wanted_rows, write_all};

/// Files in which each column has one bad cell, in its third row.
fn with_bad_cells(folder: &Path) -> Vec<PathBuf> {
    let good: ArrayRef = Arc::new(Int64Array::from(vec![1, 2, 3, 4]));
    let null: ArrayRef = Arc::new(Int64Array::from(vec![Some(1), Some(2), None, Some(4)]));
    let nan: ArrayRef = Arc::new(Float64Array::from(vec![1.0, 2.0, f64::NAN, 4.0]));
    let infinite: ArrayRef = Arc::new(Float32Array::from(vec![1.0, 2.0, f32::NEG_INFINITY, 4.0]));
    let word: ArrayRef = Arc::new(StringArray::from(vec!["1", "2", "1,5", "4"]));
    let negative: ArrayRef = Arc::new(Float64Array::from(vec![1.0, 0.0, -0.5, 4.0]));
    let flag: ArrayRef = Arc::new(BooleanArray::from(vec![true, false, true, false]));
    let day: ArrayRef = Arc::new(Date32Array::from(vec![1, 2, 3, 4]));
    let columns = [
        ("good", good),
        ("null", null),
        ("nan", nan),
        ("infinite", infinite),
        ("word", word),
        ("negative", negative),
        ("flag", flag),
        ("day", day),
    ];
    let batch = RecordBatch::try_from_iter_with_nullable(columns.map(|(name, array)| (name, array, true)));
    let batch = batch.expect("columns of equal length");
    // The bad row is the first of a record batch and of a row group.
    write_all(folder, &[batch.slice(0, 2), batch.slice(2, 2)], 2);
    FILES.iter().map(|file| folder.join(file)).collect()
}

#[test]
fn a_bad_cell_is_named_by_row_and_column() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let expected = " (expected a decimal such as 1.30e-2 or a fraction such as 7/19)";
    for path in with_bad_cells(folder.path()) {
        for reading in [Reading::Decimal, Reading::Binary64] {
            let table = TableOptions { reading, ..TableOptions::default() };
            let options = ScanOptions { table, ..ScanOptions::default() };
            let message = |name: &str| message(&path, &["good", name], &options);
            let missing = ": the value is missing, in this row only (expected a number in every row)";
            assert_eq!(message("null"), format!(": row 3, column 2 (null){missing}"));
            assert_eq!(message("nan"), format!(": row 3, column 3 (nan): \"NaN\"{missing}"));
            let not_finite = ": not a number: not a finite number at character";
            assert_eq!(
                message("infinite"),
                format!(": row 3, column 4 (infinite): \"-inf\"{not_finite} 2{expected}")
            );
            // The options that say how text is written have no say here.
            let comma = "not a number: a comma, where the decimal mark of texts in such a file is a point (expected 1.5, or a \
                         column of numbers: write the file with one, or as CSV with decimal commas)";
            assert_eq!(message("word"), format!(": row 3, column 5 (word): \"1,5\": {comma}"));
            let of_type = "(expected a column of integers, decimals, floats or text)";
            assert_eq!(
                message("flag"),
                format!(": column 7 (flag): the column has the type Boolean {of_type}")
            );
            assert_eq!(message("day"), format!(": column 8 (day): the column has the type Date32 {of_type}"));
        }
    }
}

/// Rows without a number are left out and counted as those of a CSV are; so are cells that are fractions.
#[test]
fn missing_numbers_and_fractions_are_those_of_text() {
    let x: ArrayRef =
        Arc::new(Float64Array::from(vec![Some(1.0), None, Some(f64::NAN), Some(4.0), Some(5.0), Some(6.0)]));
    let text = vec![Some("1/2"), Some("3"), Some("4"), Some("n/a"), None, Some("-7/19")];
    let y: ArrayRef = Arc::new(StringArray::from(text));
    let z: ArrayRef = Arc::new(Int64Array::from(vec![Some(1), Some(9), Some(9), Some(9), Some(9), None]));
    let csv = "x,y,z\n1,1/2,1\nNA,3,9\nNaN,4,9\n4,n/a,9\n5,,9\n6,-7/19,\n";
    let columns = [("x", x), ("y", y), ("z", z)].map(|(name, array)| (name, array, true));
    let batch = RecordBatch::try_from_iter_with_nullable(columns).expect("columns of equal length");
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_all(folder.path(), &[batch.slice(0, 4), batch.slice(4, 2)], 3);
    let condition =
        |text: &str| RowCondition::parse(text, Reading::Decimal, &Limits::default()).expect("a condition");
    for path in FILES.iter().map(|file| folder.path().join(file)) {
        for (names, conditions) in [
            (&["x", "y"][..], &[][..]),
            (&["y"], &[]),
            (&["x", "y"], &["z > 0"]),
            (&["y"], &["x >= 1", "z >= 0"]),
            (&["y"], &["z < 2"]),
        ] {
            let conditions = conditions.iter().map(|text| condition(text)).collect();
            let missing = Missing::Skip;
            let table = TableOptions { missing, conditions, keep_others: true, ..TableOptions::default() };
            let options = ScanOptions { table, ..ScanOptions::default() };
            let (found, scan) = scanned(&path, names, &options).expect("a table");
            let (expected, in_text) = scanned_text(csv, names, &options);
            assert_eq!(found, expected);
            let what = |scan: &Scanned| (scan.rows_total, scan.rows_missing, scan.fractions.clone());
            assert_eq!(what(&scan), what(&in_text), "{names:?} {:?}", options.table.conditions);
        }
        let message = message(&path, &["x", "y"], &ScanOptions::default());
        assert_eq!(
            message,
            ": row 2, column 1 (x): the value is missing, and in 3 rows more (expected a number in every row)"
        );
    }
}

#[test]
fn only_wanted_cells_need_be_numbers() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for path in with_bad_cells(folder.path()) {
        for name in ["null", "nan", "infinite", "word"] {
            let (rows, result) = scanned(&path, &[name], &wanted_rows(1, 2)).expect("good rows");
            assert_eq!((rows.len(), result.rows_total), (2, 4));
            scanned(&path, &[name], &wanted_rows(4, 4)).expect("a good row");
        }
    }
}

#[test]
fn a_negative_error_bound_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for path in with_bad_cells(folder.path()) {
        let columns = [ColumnSelector::name_or_number("negative").non_negative()];
        let name = path.to_str().expect("test files have plain names");
        let source = Source::open(name).expect("the file is there");
        let error = scan(source, &columns, &ScanOptions::default(), |_| (), |()| ()).expect_err("negative");
        let words = "the error bound is negative (expected a number that is at least 0)";
        assert_eq!(error.to_string(), format!("{name}: row 3, column 6 (negative): \"-0.5\": {words}"));
    }
}

#[test]
fn a_key_without_a_name_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for path in with_bad_cells(folder.path()) {
        let key =
            |name| ScanOptions { key: Some(ColumnSelector::name_or_number(name)), ..ScanOptions::default() };
        let null = ": row 3, column 2 (null): the cell is null (expected a value)";
        assert_eq!(message(&path, &["good"], &key("null")), null);
        let day =
            ": column 8 (day): the column has the type Date32 (expected a column of text or of numbers)";
        assert_eq!(message(&path, &["good"], &key("day")), day);
    }
}

#[test]
fn a_table_without_rows_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let none: ArrayRef = Arc::new(Int64Array::from(Vec::<i64>::new()));
    write_all(folder.path(), &[RecordBatch::try_from_iter([("x", none)]).expect("one column")], 5);
    for file in FILES {
        let words = message(&folder.path().join(file), &["x"], &ScanOptions::default());
        assert_eq!(words, ": the file has a header but no data rows (expected at least one row of numbers)");
    }
}

#[test]
fn a_damaged_file_is_an_error() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let damaged = folder.path().join("damaged.data");
    for path in with_bad_cells(folder.path()) {
        let bytes = fs::read(&path).expect("the file is there");
        let whole = scanned(&path, &["good"], &ScanOptions::default()).expect("a table").0;
        for length in (8..bytes.len()).step_by(13) {
            fs::write(&damaged, &bytes[..length]).expect("the folder can be written");
            match scanned(&damaged, &["good"], &ScanOptions::default()) {
                Err(error) => assert!(!error.to_string().is_empty()),
                // A stream may end without its mark of the end.
                Ok((rows, _)) => assert!(path.ends_with(FILES[2]) && whole.starts_with(&rows), "{length}"),
            }
        }
        // A wrong byte is an error or a wrong number, never a crash. (In Arrow files a wrong length may ask for gigabytes.)
        if !path.ends_with(FILES[0]) {
            continue;
        }
        for position in (8..bytes.len()).step_by(5) {
            let mut bytes = bytes.clone();
            bytes[position] ^= 0xa5;
            fs::write(&damaged, &bytes).expect("the folder can be written");
            let _ = scanned(&damaged, &["good", "word"], &ScanOptions::default());
        }
    }
}
