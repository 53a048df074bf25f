//! Tables: the reader and its reference, one result.

use std::fs;
use std::io::Cursor;
use std::sync::LazyLock;

use boundfit_exact::{Foreign, Limits, MOST_WORK, Reading};
use boundfit_formats::{
    AskedBlock, AskedDialect, Batch, ColumnSelector, CommentMark, Header, MemoryBudget, Missing,
    MissingWords, RowCondition, RowRange, RowSet, ScanOptions, SizeLimits, Source, TableOptions, TableRow,
    scan,
};
use rayon::{ThreadPool, ThreadPoolBuilder};
use tempfile::NamedTempFile;

use crate::reference_table::{self, Found, NAME, may_be_binary, may_be_records};

/// Numbers short enough that every input takes microseconds.
pub(super) const LIMITS: Limits = Limits { digits: 60, exponent: 400 };

/// Returns what a small machine would set.
pub(super) fn sizes() -> SizeLimits {
    SizeLimits {
        rows: 1_000,
        elements: 10_000,
        nesting: 16,
        line: 1 << 16,
        columns: 1_000,
        unpacked: 1 << 20,
        ratio: 1_000,
        workbook: 1 << 20,
        work: MOST_WORK,
        text: 1 << 20,
        memory: MemoryBudget::new(1 << 24),
    }
}

/// One thread for everything: handing work from one to another would take most of the time.
pub(super) static POOL: LazyLock<ThreadPool> =
    LazyLock::new(|| ThreadPoolBuilder::new().num_threads(1).build().expect("one more thread"));

/// The reader gives the table or the message of the reference, in whatever chunks the bytes come.
pub fn csv_reader(data: &[u8]) {
    let source = || Source::new(NAME, Cursor::new(data.to_vec()));
    POOL.install(|| {
        all_options(data, &|columns, options| {
            let expected = reference_table::read(data, None, columns, &options.table);
            let found = by_scan(source(), columns, options);
            let is_binary = found.as_ref().is_err_and(|message| message.starts_with("data.csv: this is a"));
            let is_time = is_refused_as_time(&found, &expected);
            let may_differ = is_binary && may_be_binary(data) || may_be_records(data) || is_time;
            assert!(found == expected || may_differ, "{found:?}, not {expected:?}");
        });
    });
}

/// Returns whether a text that is no number is refused as a date, a time or a number with a unit. The reference does not know
/// the texts that are.
fn is_refused_as_time<T>(found: &Result<T, String>, expected: &Result<T, String>) -> bool {
    let (Err(found), Err(expected)) = (found, expected) else { return false };
    let is_time = |what: &str| {
        let place = found.split_once(what).map(|(place, _)| place);
        place.is_some_and(|place| expected.starts_with(&format!("{place}: not a number")))
    };
    is_time(": not a number: this looks like a date")
        || is_time(": a date or a time, not a number")
        || is_time(": not a number: letters stand behind it")
}

/// Bytes that start like a MAT-file of version 5, as they stand or after such a start, are read or refused, and some of
/// their rows like all of them. Binary tables are read from files alone.
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
    POOL.install(|| {
        all_options(data, &|columns, options| {
            let Ok(found) = by_scan(source(), columns, options) else { return };
            let whole =
                TableOptions { rows: RowSet::default(), conditions: Vec::new(), ..options.table.clone() };
            let Ok(whole) = by_scan(source(), columns, &ScanOptions { table: whole, ..options.clone() })
            else {
                return;
            };
            assert!(found.rows.iter().all(|row| whole.rows.contains(row)));
            assert_eq!((found.names, found.rows_total), (whole.names, whole.rows_total));
        });
    });
}

/// Columns and ways to read them that the bytes choose.
fn all_options(data: &[u8], check: &(dyn Fn(&[ColumnSelector], &ScanOptions) + Sync)) {
    let choice = data.iter().fold(0_usize, |sum, &byte| sum + usize::from(byte));
    let delimiter = [None, None, None, Some(b';'), Some(b',')][choice % 5];
    // Comments, and what blanks separate, are read only by the program.
    let text = reference_table::in_utf8(data);
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&text);
    let delimiter = delimiter.or_else(|| reference_table::detect(text).is_none().then_some(b','));
    let comment = CommentMark::None;
    let missing = [Missing::Refuse, Missing::Skip][choice / 2 % 2];
    let header = [Header::Auto, Header::Auto, Header::Present, Header::Absent][choice % 4];
    let rows = [None, None, RowRange::new(2, 3)][choice % 3];
    let condition = RowCondition::parse("2 >= 1", Reading::Decimal, &LIMITS).expect("a condition");
    let conditions = if choice % 7 == 0 { vec![condition] } else { Vec::new() };
    let chunk_bytes = 1 + choice % 64;
    for columns in [["x", "y"], ["1", "2"]] {
        let columns = columns.map(ColumnSelector::name_or_number);
        for reading in [Reading::Decimal, Reading::Binary64] {
            let table = TableOptions {
                sheet: None,
                header,
                dialect: AskedDialect { delimiter, comment, ..AskedDialect::default() },
                missing,
                missing_as: MissingWords::default(),
                block: Some(AskedBlock::All),
                rows: rows.into(),
                conditions: conditions.clone(),
                keep_others: choice % 2 == 0,
                keep_cells: choice % 3 == 0,
                reading,
                limits: LIMITS,
                sizes: sizes(),
                ..TableOptions::default()
            };
            for chunk_bytes in [chunk_bytes, 1 << 18] {
                check(&columns, &ScanOptions { table: table.clone(), chunk_bytes, ..ScanOptions::default() });
            }
        }
    }
}

fn by_scan(source: Source, columns: &[ColumnSelector], options: &ScanOptions) -> Result<Found, String> {
    let mut batches = Vec::new();
    let scanned = scan(source, columns, options, |batch| batch, |batch| batches.push(batch));
    let scanned = scanned.map_err(|error| error.to_string())?;
    let numbered = |row: TableRow| (row.row, row.numbers);
    Ok(Found {
        names: scanned.names.into_iter().map(Foreign::into_raw).collect(),
        rows_total: scanned.rows_total,
        sha256: scanned.sha256.unwrap_or_default(),
        rows: batches.iter().flat_map(Batch::table_rows).map(numbered).collect(),
        others: batches.iter().flat_map(|batch| batch.others.clone()).map(numbered).collect(),
    })
}
