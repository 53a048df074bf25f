//! Files that say one thing a million times are refused before they take time or memory.

#![cfg(target_os = "linux")]

use std::sync::Arc;

use arrow_array::{ArrayRef, DictionaryArray, Int8Array, Int32Array, RecordBatch, StringArray};
use arrow_ipc::writer::FileWriter;
use boundfit_tests::cli::{directory_with, words};
use boundfit_tests::hostile::{FEW_SECONDS, LIMITS, TOO_FAR, refused, run_limited};
use parquet::arrow::ArrowWriter;

const FIT: &str = "fit FILE --x x --y y --eps 1 --no-lp";

fn batch(column: &ArrayRef) -> RecordBatch {
    RecordBatch::try_from_iter([("x", column.clone()), ("y", column.clone())]).unwrap()
}

fn files(column: &ArrayRef) -> [Vec<u8>; 2] {
    let batch = batch(column);
    let (mut parquet, mut arrow) = (Vec::new(), Vec::new());
    let mut writer = ArrowWriter::try_new(&mut parquet, batch.schema(), None).unwrap();
    writer.write(&batch).unwrap();
    writer.close().unwrap();
    let mut writer = FileWriter::try_new(&mut arrow, &batch.schema()).unwrap();
    writer.write(&batch).unwrap();
    writer.finish().unwrap();
    [parquet, arrow]
}

#[test]
fn one_number_in_millions_of_rows_is_refused() {
    let zeros: ArrayRef = Arc::new(Int8Array::from(vec![0; 6_000_000]));
    let [parquet, _] = files(&zeros);
    assert!(parquet.len() < 200_000);
    refused(&parquet, FIT, TOO_FAR, FEW_SECONDS);
}

#[test]
fn record_batches_are_counted() {
    let numbers: ArrayRef = Arc::new(Int32Array::from((0..200_000).collect::<Vec<i32>>()));
    let [_, arrow] = files(&numbers);
    let directory = directory_with(&[("bomb", &arrow)]);
    let line = "fit bomb --x 1 --y 2 --eps 1 --no-lp --limit memory=1MiB";
    let ended = run_limited(directory.path(), &words(line), LIMITS);
    let what = "error: bomb: the record batches that are read together take ";
    assert!(ended.status == Some(1) && ended.messages.starts_with(what), "{ended:?}");
}

/// Every row names one text of nine thousand digits.
#[test]
fn one_long_number_in_many_rows_is_refused_for_its_work() {
    let long = "7".repeat(9_000);
    let texts = StringArray::from(vec![long.as_str()]);
    let column = DictionaryArray::try_new(Int32Array::from(vec![0; 100_000]), Arc::new(texts)).unwrap();
    let work = " products of machine words, more than 400000000 (the limit); --limit work=N raises it\n";
    for file in files(&(Arc::new(column) as ArrayRef)) {
        refused(&file, FIT, work, FEW_SECONDS);
    }
}
