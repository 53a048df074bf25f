//! Tables as other programs write them, and damaged ones.

use std::fs;

use boundfit_formats::{ColumnSelector, Source, TableOptions, read_table};
use boundfit_tests::foreign;
use boundfit_tests::program::root;

#[test]
fn foreign_tables_are_read_right_or_refused_with_a_way_out() {
    foreign::check(cfg!(feature = "arrow"));
}

/// Files that are cut or changed anywhere are read or refused; none ends the program, and what they claim takes no memory.
#[test]
fn damaged_files_are_read_or_refused() {
    let mut state = 27_u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let files = [
        ("octave/mixed.txt", ["I", "U"]),
        ("octave/matrices.txt", ["1", "B(:,2)"]),
        ("octave/classes.txt", ["k", "b"]),
        ("octave/ranges.txt", ["r", "h"]),
        ("octave/mixed-v4.mat", ["I", "U"]),
        ("numpy/kinds-v4.mat", ["i4", "i2"]),
        ("numpy/big-endian-v4.mat", ["I", "U"]),
        ("loggers/nested.json", ["I", "U"]),
        ("loggers/late-key.ndjson", ["I", "U"]),
        ("loggers/arrays.json", ["1", "2"]),
        ("loggers/powershell.json", ["I", "U"]),
        ("pandas/records-words.json", ["I", "who"]),
        ("pandas/cp1252.csv", ["I", "U"]),
        ("pandas/utf16le.csv", ["I", "U"]),
    ];
    let mut read = 0;
    for (file, columns) in files {
        let content = fs::read(root().join("fixtures/foreign").join(file)).unwrap();
        let columns = columns.map(ColumnSelector::name_or_number);
        for round in 0..150 {
            let mut bytes = content.clone();
            match round % 3 {
                0 => bytes.truncate(random(content.len())),
                1 => bytes[random(content.len())] = random(256) as u8,
                _ => {
                    let (from, to) = (random(content.len()), random(content.len()));
                    let piece = bytes[from..content.len().min(from + 1 + random(40))].to_vec();
                    bytes.splice(to..to, piece);
                }
            }
            let source = Source::new(file, std::io::Cursor::new(bytes));
            read += usize::from(read_table(source, &columns, &TableOptions::default()).is_ok());
        }
    }
    // Some of them are what they were.
    assert!(read > 100, "{read}");
}
