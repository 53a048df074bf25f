//! Tables: two readers, one result.

use std::fs;
use std::io::Cursor;
use std::sync::LazyLock;

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{
    Batch, ColumnSelector, Header, RowRange, ScanOptions, SizeLimits, Source, TableOptions, read_table, scan,
};
use rayon::{ThreadPool, ThreadPoolBuilder};
use tempfile::NamedTempFile;

/// What a reader found: the names, the number of rows, the hash, and the rows wanted with their numbers.
type Found = (Vec<String>, usize, Option<String>, Vec<(usize, Vec<Rational>)>);

/// Numbers short enough that every input takes microseconds.
const LIMITS: Limits = Limits { digits: 60, exponent: 400 };

/// What a small machine would set.
const SIZES: SizeLimits =
    SizeLimits { rows: 1_000, elements: 10_000, nesting: 16, line: 1 << 16, columns: 1_000 };

/// One thread for everything: handing work from one to another would take most of the time.
static POOL: LazyLock<ThreadPool> =
    LazyLock::new(|| ThreadPoolBuilder::new().num_threads(1).build().expect("one more thread"));

/// Both readers give the same table or the same message, in whatever chunks the bytes come.
pub fn csv_reader(data: &[u8]) {
    let source = || Source::new("data.csv", Cursor::new(data.to_vec()));
    POOL.install(|| both_agree(&source, data));
}

/// The same for bytes that start like a MAT-file of version 5, as they stand or after such a start. Binary tables are read
/// from files alone.
pub fn mat_reader(data: &[u8]) {
    let mut bytes = Vec::new();
    if !data.starts_with(b"MATLAB 5.0 MAT-file") {
        bytes.extend_from_slice(b"MATLAB 5.0 MAT-file, Platform: GLNXA64");
        bytes.resize(124, b' ');
        bytes.extend_from_slice(b"\x00\x01IM");
    }
    bytes.extend_from_slice(data);
    let file = NamedTempFile::new().expect("a temporary file");
    fs::write(&file, &bytes).expect("a temporary file can be written");
    let path = file.path().to_string_lossy();
    let source = || Source::open(&path).expect("the file is there");
    POOL.install(|| both_agree(&source, data));
}

fn both_agree(source: &(dyn Fn() -> Source + Sync), data: &[u8]) {
    let choice = data.iter().fold(0_usize, |sum, &byte| sum + usize::from(byte));
    let delimiter = [None, None, None, Some(b';'), Some(b',')][choice % 5];
    let header = [Header::Auto, Header::Auto, Header::Present, Header::Absent][choice % 4];
    let rows = [None, None, RowRange::new(2, 3)][choice % 3];
    let chunk_bytes = 1 + choice % 64;
    for columns in [["x", "y"], ["1", "2"]] {
        let columns = columns.map(ColumnSelector::name_or_number);
        for reading in [Reading::Decimal, Reading::Binary64] {
            let table = TableOptions {
                header,
                delimiter,
                rows,
                reading,
                limits: LIMITS,
                sizes: SIZES,
                ..TableOptions::default()
            };
            let expected = by_table(source(), &columns, &table);
            for chunk_bytes in [chunk_bytes, 1 << 18] {
                let options = ScanOptions { table: table.clone(), chunk_bytes, ..ScanOptions::default() };
                assert_eq!(by_scan(source(), &columns, &options), expected, "chunks of {chunk_bytes}");
            }
        }
    }
}

fn by_table(source: Source, columns: &[ColumnSelector], options: &TableOptions) -> Result<Found, String> {
    let table = read_table(source, columns, options).map_err(|error| error.to_string())?;
    let rows = table.rows.into_iter().map(|row| (row.row, row.numbers)).collect();
    Ok((table.names, table.rows_total, Some(table.sha256), rows))
}

fn by_scan(source: Source, columns: &[ColumnSelector], options: &ScanOptions) -> Result<Found, String> {
    let mut rows = Vec::new();
    let take = |batch: Batch| {
        rows.extend((0..batch.rows).map(|index| {
            let numbers = batch.columns.iter().map(|column| column.get(index)).collect();
            (batch.first_row + index, numbers)
        }));
    };
    let scanned = scan(source, columns, options, |batch| batch, take);
    let scanned = scanned.map_err(|error| error.to_string())?;
    Ok((scanned.names, scanned.rows_total, scanned.sha256, rows))
}
