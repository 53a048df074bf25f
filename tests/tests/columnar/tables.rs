//! Row groups, record batches, ranges of rows, and the choice of columns.

use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use arrow_array::{ArrayRef, Float64Array, Int64Array, RecordBatch, StringArray};
use boundfit_exact::{Limits, Reading};
use boundfit_formats::{
    ColumnSelector, Progress, RowCondition, RowRange, RowSet, ScanOptions, Source, TableOptions, read_table,
};

use super::{FILES, message, scanned, scanned_text, wanted_rows, write_all};

/// `count` rows in batches of `size`, and the same as CSV.
fn table(count: i64, size: usize) -> (Vec<RecordBatch>, String) {
    let sensor: ArrayRef = Arc::new(StringArray::from_iter_values((0..count).map(|i| format!("s{}", i % 5))));
    let x: ArrayRef = Arc::new(Int64Array::from_iter_values((0..count).map(|i| i * 7 % 101)));
    let y: ArrayRef = Arc::new(Float64Array::from_iter_values((0..count).map(|i| i as f64 / 8.0)));
    let whole = RecordBatch::try_from_iter([("sensor", sensor), ("x", x), ("y", y)]).expect("equal lengths");
    let length = |start: usize| size.min(count as usize - start);
    let batches = (0..count as usize).step_by(size).map(|start| whole.slice(start, length(start))).collect();
    let mut csv = "sensor,x,y\n".to_owned();
    for i in 0..count {
        writeln!(csv, "s{},{},{}", i % 5, i * 7 % 101, i as f64 / 8.0).expect("a string takes any text");
    }
    (batches, csv)
}

fn for_each_file(batches: &[RecordBatch], group: usize, check: impl Fn(&Path)) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_all(folder.path(), batches, group);
    FILES.iter().for_each(|file| check(&folder.path().join(file)));
}

#[test]
fn groups_and_batches_make_no_difference() {
    for (count, size, group) in
        [(1, 1, 1), (20, 7, 3), (23, 23, 1000), (64, 16, 16), (200_000, 70_000, 90_000)]
    {
        let (batches, csv) = table(count, size);
        let options =
            ScanOptions { key: Some(ColumnSelector::name_or_number("sensor")), ..ScanOptions::default() };
        let (expected, in_text) = scanned_text(&csv, &["x", "y"], &options);
        for_each_file(&batches, group, |path| {
            let (rows, result) = scanned(path, &["x", "y"], &options).expect("the file is a table");
            assert!(rows == expected, "{count} rows in {}", path.display());
            assert_eq!(result.rows_total, in_text.rows_total);
            assert_eq!((result.names, result.key_name), (in_text.names.clone(), in_text.key_name.clone()));
        });
    }
}

/// Rows that are not wanted are kept where they hold numbers.
#[test]
fn rows_beside_a_range() {
    let text: ArrayRef = Arc::new(StringArray::from(vec!["1", "x", "3", "4", "", "6.5", "7", "8", "y"]));
    let batch = RecordBatch::try_from_iter([("t", text)]).expect("one column");
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_all(folder.path(), &[batch.slice(0, 5), batch.slice(5, 4)], 3);
    let columns = [ColumnSelector::name_or_number("t")];
    let options = TableOptions { keep_others: true, ..wanted_rows(3, 4).table };
    let path = |file: &str| folder.path().join(file).to_string_lossy().into_owned();
    for file in FILES {
        let source = Source::open(&path(file)).expect("the file is there");
        let table = read_table(source, &columns, &options).expect("a table");
        let rows = |rows: &[boundfit_formats::TableRow]| -> Vec<(usize, String)> {
            rows.iter().map(|row| (row.row, row.numbers[0].to_string())).collect()
        };
        let numbered = |rows: &[(usize, &str)]| -> Vec<(usize, String)> {
            rows.iter().map(|&(row, number)| (row, number.to_owned())).collect()
        };
        assert_eq!(rows(&table.rows), numbered(&[(3, "3"), (4, "4")]), "{file}");
        assert_eq!(rows(&table.others), numbered(&[(1, "1"), (6, "13/2"), (7, "7"), (8, "8")]), "{file}");
    }
}

#[test]
fn every_range_of_rows() {
    let (batches, csv) = table(12, 5);
    for_each_file(&batches, 4, |path| {
        for first in 1..=12 {
            for last in first..=12 {
                let options = wanted_rows(first, last);
                let (rows, result) = scanned(path, &["y", "x"], &options).expect("the file is a table");
                assert_eq!(rows, scanned_text(&csv, &["y", "x"], &options).0, "{first}..{last}");
                assert_eq!(result.rows_total, 12);
            }
        }
        let beyond = ": rows 12..13 were asked for, but the file has 12 data rows";
        assert_eq!(message(path, &["x"], &wanted_rows(12, 13)), beyond);
    });
}

/// Lists, rows left out and comparisons of a column that is not asked for pick the same rows as from text.
#[test]
fn rows_by_lists_and_comparisons() {
    let (batches, csv) = table(40, 11);
    let ranges = |ranges: &[(usize, usize)]| -> Vec<RowRange> {
        ranges.iter().map(|&(first, last)| RowRange::new(first, last).expect("a range")).collect()
    };
    let condition =
        |text: &str| RowCondition::parse(text, Reading::Decimal, &Limits::default()).expect("a condition");
    for_each_file(&batches, 7, |path| {
        for wanted in [&[][..], &[(3, 9), (30, 30), (8, 21)]] {
            for without in [&[][..], &[(5, 5), (20, 33)]] {
                for conditions in [&[][..], &["x >= 40"], &["x < 70", "y != 2.5", "2 > 10"]] {
                    let rows = RowSet::new(&ranges(wanted), &ranges(without)).expect("some rows");
                    let conditions = conditions.iter().map(|text| condition(text)).collect();
                    let table =
                        TableOptions { rows, conditions, keep_others: true, ..TableOptions::default() };
                    let options = ScanOptions { table, ..ScanOptions::default() };
                    let (found, scanned) = scanned(path, &["y"], &options).expect("a table");
                    let (expected, in_text) = scanned_text(&csv, &["y"], &options);
                    assert_eq!((&found, &scanned.ranges), (&expected, &in_text.ranges));
                    let columns = [ColumnSelector::name_or_number("y")];
                    let source = Source::open(&path.to_string_lossy()).expect("the file is there");
                    let others = read_table(source, &columns, &options.table).expect("a table").others;
                    let mut all: Vec<usize> = others.iter().map(|row| row.row).collect();
                    all.extend(found.iter().map(|(row, ..)| row));
                    all.sort_unstable();
                    assert_eq!(all, (1..=40).collect::<Vec<_>>());
                }
            }
        }
        let none = TableOptions { conditions: vec![condition("x > 101")], ..TableOptions::default() };
        let options = ScanOptions { table: none, ..ScanOptions::default() };
        assert_eq!(message(path, &["y"], &options), ": of the file's 40 data rows none satisfies x > 101");
        let text = TableOptions { conditions: vec![condition("sensor > 1")], ..TableOptions::default() };
        let options = ScanOptions { table: text, ..ScanOptions::default() };
        let refused = message(path, &["y"], &options);
        assert!(refused.starts_with(": row 1, column 1 (sensor): \"s0\": not a number: "), "{refused}");
    });
}

#[test]
fn columns_by_name_and_number_in_any_order() {
    let (batches, csv) = table(9, 4);
    let options = ScanOptions::default();
    for_each_file(&batches, 4, |path| {
        for names in [&["y", "x"][..], &["3", "2"], &["x", "3"], &["3"]] {
            let (rows, result) = scanned(path, names, &options).expect("the file is a table");
            let (expected, in_text) = scanned_text(&csv, names, &options);
            assert_eq!((rows, result.names), (expected, in_text.names), "{names:?}");
        }
        let unknown =
            ": there is no column \"z\" (expected one of \"sensor\", \"x\", \"y\" or a number from 1 to 3)";
        assert_eq!(message(path, &["z"], &options), unknown);
        let twice =
            ": column 2 (x): the same column is asked for as \"x\" and as \"2\" (expected two columns)";
        assert_eq!(message(path, &["x", "2"], &options), twice);
    });
}

#[test]
fn progress_is_that_of_the_bytes_and_may_stop_the_scan() {
    #[derive(Default)]
    struct Count(AtomicU64, bool);
    impl Progress for Count {
        fn advanced(&self, bytes: u64) {
            self.0.fetch_add(bytes, Ordering::Relaxed);
        }
        fn is_cancelled(&self) -> bool {
            self.1
        }
    }
    let (batches, _) = table(1000, 100);
    for_each_file(&batches, 100, |path| {
        let bytes = std::fs::read(path).expect("the file is there");
        let count = Arc::new(Count::default());
        let options = ScanOptions { progress: Some(count.clone()), ..ScanOptions::default() };
        let (_, result) = scanned(path, &["x"], &options).expect("the file is a table");
        let name = path.to_str().expect("test files have plain names");
        assert_eq!(result.bytes, bytes.len() as u64, "{name}");
        assert_eq!(count.0.load(Ordering::Relaxed), result.bytes, "{name}");
        let stop = Arc::new(Count(AtomicU64::new(0), true));
        let options = ScanOptions { progress: Some(stop), ..ScanOptions::default() };
        assert_eq!(message(path, &["x"], &options), ": interrupted");
    });
}

#[test]
fn batches_come_in_order_from_several_threads() {
    let (batches, csv) = table(5000, 3);
    let expected = scanned_text(&csv, &["y"], &ScanOptions::default()).0;
    for_each_file(&batches, 11, |path| {
        for threads in [1, 2, 8] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads start");
            let (rows, _) = pool.install(|| scanned(path, &["y"], &ScanOptions::default())).expect("a table");
            assert!(rows == expected, "{threads} threads, {}", path.display());
        }
    });
}
