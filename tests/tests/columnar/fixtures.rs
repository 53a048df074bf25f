//! Files that other programs wrote.

use boundfit_exact::Reading;
use boundfit_formats::{ColumnSelector, ScanOptions, TableOptions};
use boundfit_tests::program::root;

use super::{scanned, scanned_text};

#[test]
fn files_of_polars_and_pyarrow_give_the_rows_of_the_csv() {
    let folder = root().join("fixtures/arrow");
    let csv = std::fs::read_to_string(folder.join("readings.csv")).expect("the fixture is there");
    for reading in [Reading::Decimal, Reading::Binary64] {
        let table = TableOptions { reading, ..TableOptions::default() };
        let key = Some(ColumnSelector::name_or_number("sensor"));
        let options = ScanOptions { table, key, ..ScanOptions::default() };
        let names = ["count", "volts", "exact", "text"];
        let (expected, _) = scanned_text(&csv, &names, &options);
        for file in ["polars.parquet", "polars.arrow", "pyarrow.parquet", "pyarrow.arrow", "pyarrow.arrows"] {
            let (rows, result) = scanned(&folder.join(file), &names, &options).expect(file);
            assert_eq!(rows, expected, "{file}, {reading:?}");
            assert_eq!(result.rows_total, 30);
        }
    }
}

#[test]
fn the_hash_is_that_of_the_whole_file() {
    let path = root().join("fixtures/arrow/polars.parquet");
    let hash = |hash| {
        let options = ScanOptions { hash, ..ScanOptions::default() };
        scanned(&path, &["volts"], &options).expect("the file is a table").1.sha256
    };
    // As sha256sum says.
    let expected = "0181b554935eb1f581564c6c328f548564994b553dcec9efb77cf5d30ff9cebf";
    assert_eq!(hash(true).as_deref(), Some(expected));
    assert_eq!(hash(false), None);
}
