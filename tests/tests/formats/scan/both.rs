//! The reader and its reference, with what they found in one form.

use std::io::Cursor;
use std::sync::LazyLock;

use boundfit_exact::Foreign;
use boundfit_formats::{Batch, ColumnSelector, ScanOptions, Scanned, Source, TableRow, scan};
pub use boundfit_tests::reference_table::Found;
use boundfit_tests::reference_table::{self, NAME};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Pools of 1, 2 and 4 threads.
pub static POOLS: LazyLock<Vec<ThreadPool>> = LazyLock::new(|| {
    [1, 2, 4].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build().unwrap()).into()
});

/// The pool of one thread, and one of several for this case: 2 and 4 take turns. Threads that wait for each other take most of the
/// time of a small table.
pub fn pools(case: usize) -> [(&'static ThreadPool, usize); 2] {
    [(&POOLS[0], 1), if case.is_multiple_of(2) { (&POOLS[1], 2) } else { (&POOLS[2], 4) }]
}

/// Returns the reference's reading of these bytes: its result, or its message.
pub fn by_reference(
    bytes: &[u8],
    columns: &[ColumnSelector],
    options: &ScanOptions,
) -> Result<Found, String> {
    reference_table::read(bytes, None, columns, &options.table)
}

/// Returns the reading of these bytes by `scan` in the current pool.
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
    let numbered = |row: TableRow| (row.row, row.numbers);
    let rows = batches.iter().flat_map(|batch| {
        assert!(batch.rows.len() + batch.others.len() + batch.keys_missing.len() > 0);
        assert!(batch.columns.iter().all(|column| column.len() == batch.rows.len()));
        batch.table_rows().map(numbered)
    });
    let rows = rows.collect();
    let others = batches.iter().flat_map(|batch| batch.others.clone()).map(numbered).collect();
    let sha256 = scanned.sha256.unwrap_or_default();
    Found {
        names: scanned.names.into_iter().map(Foreign::into_raw).collect(),
        rows_total: scanned.rows_total,
        sha256,
        rows,
        others,
    }
}

pub fn source(bytes: &[u8]) -> Source {
    Source::new(NAME, Cursor::new(bytes.to_vec()))
}
