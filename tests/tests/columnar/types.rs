//! Every type of column.

use std::sync::Arc;

use arrow_array::types::{Decimal32Type, Decimal64Type, Decimal128Type, Decimal256Type, Int8Type, Int32Type};
use arrow_array::{
    ArrayRef, ArrowPrimitiveType, BooleanArray, DictionaryArray, Float32Array, Float64Array, Int8Array,
    Int16Array, Int32Array, Int64Array, LargeStringArray, PrimitiveArray, RecordBatch, StringArray,
    StringViewArray, UInt8Array, UInt16Array, UInt32Array, UInt64Array,
};
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_formats::{ColumnSelector, ScanOptions, TableOptions};

use super::{FILES, rows_of, scanned, scanned_text, write_all, write_arrow};

fn decimals<T: arrow_array::types::DecimalType>(
    values: Vec<T::Native>,
    precision: u8,
    scale: i8,
) -> ArrayRef {
    let array = PrimitiveArray::<T>::from_iter_values(values);
    Arc::new(array.with_precision_and_scale(precision, scale).expect("the digits fit"))
}

/// Three rows of every type that has numbers, with the cells as a CSV shows them.
fn every_type() -> Vec<(&'static str, ArrayRef, [&'static str; 3])> {
    let keys = Int32Array::from(vec![1, 0, 1]);
    let words = DictionaryArray::<Int32Type>::new(keys, Arc::new(StringArray::from(vec!["-1/3", "2.50"])));
    let keys = Int8Array::from(vec![0, 0, 2]);
    // The middle value is in no row.
    let floats = Arc::new(Float64Array::from(vec![0.1, f64::NAN, -7.5]));
    let floats = DictionaryArray::<Int8Type>::new(keys, floats);
    let wide =
        |text: &str| <Decimal256Type as ArrowPrimitiveType>::Native::from_string(text).expect("an integer");
    let huge = "12345678901234567890123456789012345678901234567890";
    let exact = "123456789012345678901234567890123456789012345.67890";
    vec![
        ("int8", Arc::new(Int8Array::from(vec![-128, 0, 127])), ["-128", "0", "127"]),
        ("int16", Arc::new(Int16Array::from(vec![-32768, 1, 32767])), ["-32768", "1", "32767"]),
        (
            "int32",
            Arc::new(Int32Array::from(vec![i32::MIN, 2, i32::MAX])),
            ["-2147483648", "2", "2147483647"],
        ),
        (
            "int64",
            Arc::new(Int64Array::from(vec![i64::MIN, 9_007_199_254_740_993, i64::MAX])),
            ["-9223372036854775808", "9007199254740993", "9223372036854775807"],
        ),
        ("uint8", Arc::new(UInt8Array::from(vec![0, 1, 255])), ["0", "1", "255"]),
        ("uint16", Arc::new(UInt16Array::from(vec![0, 1, 65535])), ["0", "1", "65535"]),
        ("uint32", Arc::new(UInt32Array::from(vec![0, 1, u32::MAX])), ["0", "1", "4294967295"]),
        ("uint64", Arc::new(UInt64Array::from(vec![0, 1, u64::MAX])), ["0", "1", "18446744073709551615"]),
        // As the shortest text of a float of this width: not 0.10000000149011612.
        ("float32", Arc::new(Float32Array::from(vec![0.1, -0.0, 3.4e38])), ["0.1", "-0", "3.4e38"]),
        (
            "float64",
            Arc::new(Float64Array::from(vec![0.1 + 0.2, 5e-324, -1.5e300])),
            ["0.30000000000000004", "5e-324", "-1.5e300"],
        ),
        ("decimal32", decimals::<Decimal32Type>(vec![-12345, 0, 7], 9, 3), ["-12.345", "0.000", "0.007"]),
        ("decimal64", decimals::<Decimal64Type>(vec![-1, 25, 30], 18, 18), ["-1e-18", "25e-18", "30e-18"]),
        (
            "decimal128",
            decimals::<Decimal128Type>(vec![-1, 10_i128.pow(37), 30], 38, 20),
            ["-1e-20", "100000000000000000", "30e-20"],
        ),
        (
            "decimal256",
            decimals::<Decimal256Type>(vec![wide(huge), wide("-1"), wide("100000")], 76, 5),
            [exact, "-0.00001", "1.00000"],
        ),
        ("text", Arc::new(StringArray::from(vec!["1e-3", " -7/19 ", "+.5"])), ["1e-3", "-7/19", "+.5"]),
        ("large", Arc::new(LargeStringArray::from(vec!["1", "2", "3"])), ["1", "2", "3"]),
        (
            "view",
            Arc::new(StringViewArray::from(vec!["1.5", "2.25", "33333333333333333.1"])),
            ["1.5", "2.25", "33333333333333333.1"],
        ),
        ("words", Arc::new(words), ["2.50", "-1/3", "2.50"]),
        ("floats", Arc::new(floats), ["0.1", "0.1", "-7.5"]),
    ]
}

#[test]
fn every_type_gives_the_numbers_of_its_csv() {
    let types = every_type();
    let batch = RecordBatch::try_from_iter(types.iter().map(|(name, array, _)| (*name, array.clone())));
    let batch = batch.expect("columns of equal length");
    let names: Vec<&str> = types.iter().map(|(name, _, _)| *name).collect();
    let line = |row: usize| types.iter().map(|(_, _, cells)| cells[row]).collect::<Vec<_>>().join(",");
    let csv = format!("{}\n{}\n{}\n{}\n", names.join(","), line(0), line(1), line(2));
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_all(folder.path(), &[batch], 2);
    for reading in [Reading::Decimal, Reading::Binary64] {
        let table = TableOptions { reading, ..TableOptions::default() };
        let options = ScanOptions { table, ..ScanOptions::default() };
        // The float of 32 bits is itself under binary64, not the double nearest to its text.
        let exceptions: &[&str] = if reading == Reading::Binary64 { &["float32"] } else { &[] };
        let names: Vec<&str> = names.iter().copied().filter(|name| !exceptions.contains(name)).collect();
        let (expected, _) = scanned_text(&csv, &names, &options);
        for file in FILES {
            let path = folder.path().join(file);
            let (rows, result) = scanned(&path, &names, &options).expect("the file is a table");
            assert_eq!(rows, expected, "{file}, {reading:?}");
            assert_eq!((result.names, result.rows_total), (names.iter().map(|&n| n.into()).collect(), 3));
            for name in exceptions {
                let (rows, _) = scanned(&path, &[name], &options).expect("the file is a table");
                let value = Rational::from_f64(f64::from(0.1_f32)).expect("finite");
                assert_eq!(rows[0].1, [value], "{file}");
            }
        }
    }
}

#[test]
fn decimals_of_hundreds() {
    let hundreds = decimals::<Decimal128Type>(vec![-1, 3, 0], 5, -2);
    let folder = tempfile::tempdir().expect("a temporary folder");
    // Parquet has no such decimals.
    write_arrow(folder.path(), &[RecordBatch::try_from_iter([("x", hundreds)]).expect("one column")]);
    for file in &FILES[1..] {
        for reading in [Reading::Decimal, Reading::Binary64] {
            let table = TableOptions { reading, ..TableOptions::default() };
            let options = ScanOptions { table, ..ScanOptions::default() };
            let (rows, _) = scanned(&folder.path().join(file), &["x"], &options).expect("a table");
            assert_eq!(rows, scanned_text("x\n-100\n300\n0\n", &["x"], &options).0, "{file}, {reading:?}");
        }
    }
}

#[test]
fn keys_are_the_text_of_their_cells() {
    let types = every_type();
    let flags: ArrayRef = Arc::new(BooleanArray::from(vec![true, false, true]));
    let spaces: ArrayRef = Arc::new(StringArray::from(vec![" a b ", "ü", "\tc"]));
    let chosen = ["int8", "uint64", "float64", "decimal32", "view", "words"];
    let mut arrays: Vec<(&str, ArrayRef, [&str; 3])> =
        types.into_iter().filter(|(name, _, _)| chosen.contains(name)).collect();
    arrays.push(("flags", flags, ["true", "false", "true"]));
    arrays.push(("spaces", spaces, [" a b ", "ü", "\tc"]));
    let batch = RecordBatch::try_from_iter(arrays.iter().map(|(name, array, _)| (*name, array.clone())));
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_all(folder.path(), &[batch.expect("columns of equal length")], 2);
    for (name, _, expected) in &arrays {
        let options =
            ScanOptions { key: Some(ColumnSelector::name_or_number(name)), ..ScanOptions::default() };
        for file in FILES {
            let (rows, result) = scanned(&folder.path().join(file), &["int8"], &options).expect("a table");
            let keys: Vec<String> = rows.into_iter().filter_map(|(_, _, key)| key).collect();
            // A float as large or small as these is written out in full here, which is as good a key.
            if *name != "float64" {
                assert_eq!(keys, expected, "{file}, {name}");
            }
            assert_eq!(keys.len(), 3);
            assert_eq!(result.key_name.as_ref().map(Foreign::raw), Some(*name));
        }
    }
}

#[test]
fn a_batch_knows_how_its_numbers_are_kept() {
    use boundfit_exact::Column;
    use boundfit_formats::{Batch, Source, scan};
    let numbers: ArrayRef = Arc::new(Float64Array::from(vec![0.25, 1.0, -30.0]));
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_all(folder.path(), &[RecordBatch::try_from_iter([("x", numbers)]).expect("one column")], 9);
    let path = folder.path().join(FILES[0]);
    let kept = |reading| {
        let table = TableOptions { reading, ..TableOptions::default() };
        let options = ScanOptions { table, ..ScanOptions::default() };
        let mut columns = Vec::new();
        let work = |batch: Batch| {
            assert_eq!(rows_of(batch.clone()).len(), batch.rows.len());
            batch.columns
        };
        let source = Source::open(path.to_str().expect("test files have plain names")).expect("a file");
        let selectors = super::columns(&["x"]);
        scan(source, &selectors, &options, work, |part| columns.extend(part)).expect("a table");
        columns
    };
    assert!(
        matches!(&kept(Reading::Decimal)[..], [Column::Narrow(scaled)] if scaled.counts() == [25, 100, -3000])
    );
    assert_eq!(kept(Reading::Binary64), [Column::Doubles(vec![0.25, 1.0, -30.0])]);
}
