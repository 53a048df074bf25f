//! Many floats: the numbers that the shortest texts say, or the floats themselves.

use std::fmt::Write;
use std::sync::Arc;

use arrow_array::{ArrayRef, Float32Array, Float64Array, RecordBatch};
use boundfit_exact::Reading;
use boundfit_formats::{ScanOptions, TableOptions};

use super::{FILES, scanned, scanned_text, write_all};

/// The next number of a generator.
fn next(state: &mut u64) -> u64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state ^ *state >> 32).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// Columns of one kind each: of few digits, of all digits, a few long ones among short ones, of every size, the edges of the format,
/// and nothing but zeros.
fn columns(rows: usize) -> Vec<(&'static str, Vec<f64>)> {
    let mut state = 5;
    let mut column = |make: &dyn Fn(u64, u64) -> f64| -> Vec<f64> {
        (0..rows).map(|_| make(next(&mut state), next(&mut state))).collect()
    };
    let short = |bits: u64| (bits % 2_000_001) as f64 / 1e4 - 100.0;
    let finite = |bits: u64| Some(f64::from_bits(bits)).filter(|value| value.is_finite()).unwrap_or(0.5);
    let edges =
        [0.0, -0.0, 5e-324, f64::MIN_POSITIVE, f64::MAX, -f64::MAX, 1e22, 1e23, 9.5e-5, 2_f64.powi(60)];
    vec![
        ("short", column(&|bits, _| (short(bits) * 1e4).round() / 1e4)),
        ("long", column(&|bits, _| (bits >> 11) as f64 / (1_u64 << 53) as f64)),
        (
            "mixed",
            column(&|bits, more| {
                if more.is_multiple_of(97) { short(bits) / 3.0 } else { (bits % 1000) as f64 / 10.0 }
            }),
        ),
        ("integers", column(&|bits, _| (bits % 4096) as f64)),
        ("all", column(&|bits, _| finite(bits))),
        ("edges", column(&|bits, _| edges[bits as usize % edges.len()])),
        ("zeros", column(&|bits, _| if bits.is_multiple_of(2) { 0.0 } else { -0.0 })),
    ]
}

fn check(array: ArrayRef, texts: &[String], name: &str) {
    let mut text = "x\n".to_owned();
    texts.iter().for_each(|cell| writeln!(text, "{cell}").expect("memory"));
    let folder = tempfile::tempdir().expect("a folder");
    write_all(folder.path(), &[RecordBatch::try_from_iter([("x", array)]).expect("a batch")], 1000);
    for reading in [Reading::Decimal, Reading::Binary64] {
        let table = TableOptions { reading, ..TableOptions::default() };
        let options = ScanOptions { table, ..ScanOptions::default() };
        let expected = scanned_text(&text, &["x"], &options).0;
        for file in FILES {
            let rows = scanned(&folder.path().join(file), &["x"], &options).expect("numbers").0;
            assert!(rows == expected, "{name} {file} {reading:?}");
        }
    }
}

#[test]
fn doubles_are_the_numbers_of_a_csv_of_their_shortest_texts() {
    for (name, doubles) in columns(3000) {
        let texts: Vec<String> = doubles.iter().map(|double| format!("{double:e}")).collect();
        check(Arc::new(Float64Array::from(doubles)), &texts, name);
    }
}

#[test]
fn floats_of_32_bits_are_too_with_texts_of_their_own() {
    for (name, doubles) in columns(3000) {
        let floats: Vec<f32> =
            doubles.iter().map(|&double| double as f32).filter(|float| float.is_finite()).collect();
        // In binary64 the float is meant, which its own shortest text need not be nearest to.
        let folder = tempfile::tempdir().expect("a folder");
        let array: ArrayRef = Arc::new(Float32Array::from(floats.clone()));
        write_all(folder.path(), &[RecordBatch::try_from_iter([("x", array)]).expect("a batch")], 1000);
        for reading in [Reading::Decimal, Reading::Binary64] {
            let mut text = "x\n".to_owned();
            for float in &floats {
                let cell = match reading {
                    Reading::Decimal => format!("{float:e}"),
                    Reading::Binary64 => format!("{:e}", f64::from(*float)),
                };
                writeln!(text, "{cell}").expect("memory");
            }
            let table = TableOptions { reading, ..TableOptions::default() };
            let options = ScanOptions { table, ..ScanOptions::default() };
            let expected = scanned_text(&text, &["x"], &options).0;
            let rows = scanned(&folder.path().join(FILES[0]), &["x"], &options).expect("numbers").0;
            assert!(rows == expected, "{name} {reading:?}");
        }
    }
}
