//! Parquet and Arrow IPC files: the same rows as from a CSV of the same table, and errors that name row and column.
//!
//! A program of its own, with all that the feature `arrow` changes: the other tests need not be built once more.

mod bombs;
mod errors;
mod fixtures;
mod floats;
mod foreign;
mod program;
mod stored;
mod tables;
mod types;

use std::fs::File;
use std::io::Cursor;
use std::path::Path;

use arrow_array::RecordBatch;
use arrow_ipc::writer::{FileWriter, StreamWriter};
use boundfit_exact::Rational;
use boundfit_formats::{
    Batch, ColumnSelector, InputError, RowRange, ScanOptions, Scanned, Source, TableOptions, scan,
};
use parquet::arrow::ArrowWriter;
use parquet::file::properties::WriterProperties;

/// Number, numbers and key of every row, in the order in which the scan handed them out.
type Rows = Vec<(usize, Vec<Rational>, Option<String>)>;

fn rows_of(batch: Batch) -> Rows {
    let row = |index: usize| {
        let numbers = batch.columns.iter().map(|column| column.get(index)).collect();
        let key = batch.keys.as_ref().map(|keys| keys.get(index).to_owned());
        (batch.rows.get(index), numbers, key)
    };
    (0..batch.rows.len()).map(row).collect()
}

fn columns(names: &[&str]) -> Vec<ColumnSelector> {
    names.iter().map(|name| ColumnSelector::name_or_number(name)).collect()
}

fn scanned(path: &Path, names: &[&str], options: &ScanOptions) -> Result<(Rows, Scanned), InputError> {
    let mut rows = Rows::new();
    let source = Source::open(path.to_str().expect("test files have plain names"))?;
    let result = scan(source, &columns(names), options, rows_of, |part| rows.extend(part))?;
    Ok((rows, result))
}

fn scanned_text(text: &str, names: &[&str], options: &ScanOptions) -> (Rows, Scanned) {
    let mut rows = Rows::new();
    let source = Source::new("table.csv", Cursor::new(text.to_owned()));
    let result = scan(source, &columns(names), options, rows_of, |part| rows.extend(part));
    (rows, result.expect("the text is a table"))
}

/// The message of a scan that fails, without the name of the file.
fn message(path: &Path, names: &[&str], options: &ScanOptions) -> String {
    let error = scanned(path, names, options).expect_err("the scan fails").to_string();
    let file = path.to_str().expect("test files have plain names");
    error.strip_prefix(file).expect("the message begins with the file").to_owned()
}

fn wanted_rows(first: usize, last: usize) -> ScanOptions {
    let rows = RowRange::new(first, last).into();
    ScanOptions { table: TableOptions { rows, ..TableOptions::default() }, ..ScanOptions::default() }
}

/// Names that do not tell the format.
const FILES: [&str; 3] = ["parquet.data", "arrow.data", "stream.data"];

/// Writes the batches as a Parquet file with row groups of at most `group` rows, an Arrow file and an Arrow stream.
fn write_all(folder: &Path, batches: &[RecordBatch], group: usize) {
    let schema = batches[0].schema();
    let properties = WriterProperties::builder().set_max_row_group_row_count(Some(group)).build();
    let mut parquet = ArrowWriter::try_new(create(folder, FILES[0]), schema, Some(properties))
        .expect("a schema that Parquet has");
    batches.iter().for_each(|batch| parquet.write(batch).expect("Parquet is written"));
    parquet.close().expect("Parquet is written");
    write_arrow(folder, batches);
}

/// Writes the batches as an Arrow file and an Arrow stream.
fn write_arrow(folder: &Path, batches: &[RecordBatch]) {
    let schema = batches[0].schema();
    let mut file = FileWriter::try_new(create(folder, FILES[1]), &schema).expect("a schema");
    let mut stream = StreamWriter::try_new(create(folder, FILES[2]), &schema).expect("a schema");
    for batch in batches {
        file.write(batch).expect("Arrow is written");
        stream.write(batch).expect("Arrow is written");
    }
    file.finish().expect("Arrow is written");
    stream.finish().expect("Arrow is written");
}

fn create(folder: &Path, name: &str) -> File {
    File::create(folder.join(name)).expect("the folder can be written")
}
