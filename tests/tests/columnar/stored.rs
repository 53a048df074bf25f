//! Doubles in columnar files are fitted and reduced like text.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch};
use boundfit_tests::stored::{self, Table};

use super::FILES;

fn write(table: &Table, folder: &Path) {
    let column = |(name, numbers): (&String, &Vec<Option<f64>>)| {
        (name.clone(), Arc::new(Float64Array::from(numbers.clone())) as ArrayRef, true)
    };
    let batch = RecordBatch::try_from_iter_with_nullable(table.names.iter().zip(&table.columns).map(column));
    let batch = batch.unwrap();
    let create = |name: &str| File::create(folder.join(name)).unwrap();
    let mut parquet = parquet::arrow::ArrowWriter::try_new(create(FILES[0]), batch.schema(), None).unwrap();
    parquet.write(&batch).unwrap();
    parquet.close().unwrap();
    let mut arrow = arrow_ipc::writer::FileWriter::try_new(create(FILES[1]), &batch.schema()).unwrap();
    arrow.write(&batch).unwrap();
    arrow.finish().unwrap();
}

#[test]
fn columnar_files_are_fitted_and_reduced_like_text_of_their_doubles() {
    stored::check(&FILES[..2], write);
}
