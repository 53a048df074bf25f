//! The two readers, with what they found in one form.

use std::io::Cursor;
use std::sync::LazyLock;

use boundfit_exact::Rational;
use boundfit_formats::{Batch, ColumnSelector, ScanOptions, Scanned, Source, read_table, scan};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Pools of 1, 2 and 8 threads.
pub static POOLS: LazyLock<Vec<ThreadPool>> = LazyLock::new(|| {
    [1, 2, 8].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build().unwrap()).into()
});

/// What a reader found: the names, the number of rows, the hash, and the rows wanted with their numbers.
#[derive(Debug, PartialEq, Eq)]
pub struct Found {
    pub names: Vec<String>,
    pub rows_total: usize,
    pub sha256: String,
    pub rows: Vec<(usize, Vec<Rational>)>,
}

/// How `read_table` reads these bytes: what it found, or its message.
pub fn by_table(bytes: &[u8], columns: &[ColumnSelector], options: &ScanOptions) -> Result<Found, String> {
    let table = read_table(source(bytes), columns, &options.table).map_err(|error| error.to_string())?;
    let rows = table.rows.into_iter().map(|row| (row.row, row.numbers)).collect();
    Ok(Found { names: table.names, rows_total: table.rows_total, sha256: table.sha256, rows })
}

/// How `scan` reads these bytes in the current pool.
pub fn by_scan(bytes: &[u8], columns: &[ColumnSelector], options: &ScanOptions) -> Result<Found, String> {
    let (scanned, batches) = batches(source(bytes), columns, options)?;
    Ok(found(scanned, &batches))
}

/// All batches, in the order in which they are handed out.
pub fn batches(
    source: Source,
    columns: &[ColumnSelector],
    options: &ScanOptions,
) -> Result<(Scanned, Vec<Batch>), String> {
    let mut batches = Vec::new();
    let scanned = scan(source, columns, options, |batch| batch, |batch| batches.push(batch));
    Ok((scanned.map_err(|error| error.to_string())?, batches))
}

/// The rows of all batches.
pub fn found(scanned: Scanned, batches: &[Batch]) -> Found {
    let rows = batches.iter().flat_map(|batch| {
        assert!(batch.rows > 0 && batch.columns.iter().all(|column| column.len() == batch.rows));
        let numbers = |index| batch.columns.iter().map(|column| column.get(index)).collect();
        (0..batch.rows).map(move |index| (batch.first_row + index, numbers(index)))
    });
    let rows = rows.collect();
    let sha256 = scanned.sha256.unwrap_or_default();
    Found { names: scanned.names, rows_total: scanned.rows_total, sha256, rows }
}

fn source(bytes: &[u8]) -> Source {
    Source::new("data.csv", Cursor::new(bytes.to_vec()))
}
