//! The rows and the messages of the reference.

use boundfit_formats::{ColumnSelector, ScanOptions, TableOptions};
use boundfit_tests::generate::{seeded, share};

use super::both::{POOLS, by_reference, by_scan, pools};
use super::tables::{Case, case};

/// Chunks of so many bytes, at least.
const CHUNKS: [usize; 4] = [1, 7, 64, 4096];

#[test]
fn generated_tables() {
    let mut rng = seeded(0x5ca0);
    let (mut found, mut refused) = (0, 0);
    for number in 0..share(6000) {
        let Case { bytes, columns, options } = case(&mut rng);
        let expected = by_reference(&bytes, &columns, &options);
        for (pool, threads) in pools(number) {
            let by_chunks =
                |chunk_bytes| by_scan(&bytes, &columns, &ScanOptions { chunk_bytes, ..options.clone() });
            let found = pool.install(|| CHUNKS.map(by_chunks));
            for (chunk_bytes, actual) in CHUNKS.iter().zip(found) {
                let text = String::from_utf8_lossy(&bytes);
                let table = &options.table;
                assert_eq!(
                    actual, expected,
                    "case {number}, {threads} threads, chunks of {chunk_bytes}: {columns:?} {table:?}\n{text:?}"
                );
            }
        }
        assert_eq!(by_scan(&bytes, &columns, &options), expected, "case {number}");
        *(if expected.is_ok() { &mut found } else { &mut refused }) += 1;
    }
    assert!(found > share(1400) && refused > share(1500), "{found} were read, {refused} refused");
}

/// A chunk may end after any byte of a file: what is wrong in its last line is found in every one.
#[test]
fn chunks_may_end_anywhere() {
    let columns = ["x", "y"].map(ColumnSelector::name_or_number);
    let start = "\u{feff}\n x,\"y\",t\r\n1.5,-2,a\n\n3,4,\"b\nc\"\r\n  \n5,6e-3,\"\"\"\"\n7/19,8,d\n9,10,e\n";
    for end in ["11,12,f\n", "11,12,f", "11,z,f\n", "11,12\n", "11,12,f\r13,14,\u{0}", "11,12,\"f\n"] {
        let bytes = [start, end].concat();
        let expected = by_reference(bytes.as_bytes(), &columns, &ScanOptions::default());
        for chunk_bytes in 1..=bytes.len() + 1 {
            let options = ScanOptions { chunk_bytes, ..ScanOptions::default() };
            let actual = POOLS[1].install(|| by_scan(bytes.as_bytes(), &columns, &options));
            assert_eq!(actual, expected, "chunks of {chunk_bytes}: {end:?}");
        }
    }
}

/// A byte order mark is one at the start of the file only.
#[test]
fn byte_order_marks() {
    let columns = ["1", "2"].map(ColumnSelector::name_or_number);
    for text in [
        "\u{feff}1,2\n3,4\n",
        "\u{feff}\u{feff}1,2\n3,4\n",
        "\u{feff}\u{feff}\u{feff}1,2\n3,4\n",
        "1,2\n\u{feff}3,4\n",
        "1,\"2\"\n\u{feff}3,\"4\"\n",
        "\u{feff}x,y\n\u{feff}1,2\n",
        "\u{feff}",
    ] {
        let expected = by_reference(text.as_bytes(), &columns, &ScanOptions::default());
        for chunk_bytes in [1, 4096] {
            let options = ScanOptions { chunk_bytes, ..ScanOptions::default() };
            assert_eq!(by_scan(text.as_bytes(), &columns, &options), expected, "{text:?}");
        }
    }
}

/// A file cut off after any byte.
#[test]
fn files_may_end_anywhere() {
    let columns = ["x", "y"].map(ColumnSelector::name_or_number);
    let whole = "\u{feff}x,y\r\n1.5,-2\r\n\r\n3,\"4\"\r\n5,6e-3\r\n";
    for end in 0..=whole.len() {
        let bytes = &whole.as_bytes()[..end];
        let expected = by_reference(bytes, &columns, &ScanOptions::default());
        for chunk_bytes in CHUNKS {
            let options = ScanOptions { chunk_bytes, ..ScanOptions::default() };
            let actual = POOLS[1].install(|| by_scan(bytes, &columns, &options));
            assert_eq!(actual, expected, "the first {end} bytes in chunks of {chunk_bytes}");
        }
    }
}

/// A few megabytes, in which the last row is bad, or the first and the last.
#[test]
fn the_first_bad_row_is_named() {
    let columns = ["x", "y"].map(ColumnSelector::name_or_number);
    let mut text = "x,y\n".to_owned();
    let rows = 200_000;
    for row in 1..=rows {
        text.push_str(&format!("{row}.25,-{}\n", row % 97));
    }
    let options = ScanOptions { table: TableOptions::default(), ..ScanOptions::default() };
    for (bad, message) in [
        ("0x10,1\n", "data.csv: line 200002, column 1 (x): \"0x10\": not a number: "),
        ("1,\"2\"\n3,\"4\nz\n", "data.csv: line 200003: a quote that opens in this row is never closed"),
        (
            "1,2,3\nx,y\n",
            "data.csv: line 200002: the row has 3 cells where the first row has 2 (expected as many cells in every row, also where a value is missing)",
        ),
    ] {
        let text = format!("{text}{bad}");
        let expected = by_reference(text.as_bytes(), &columns, &options);
        for pool in &*POOLS {
            let actual = pool.install(|| by_scan(text.as_bytes(), &columns, &options));
            assert!(actual == expected, "{bad:?}");
        }
        let found = expected.err().unwrap_or_default();
        assert!(found.starts_with(message), "{found}");
    }
}
