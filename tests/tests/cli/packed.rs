//! Compressed tables are read as the tables that they unpack to; the hash is that of the file.

use std::fs;
use std::io::Write;
use std::path::Path;

use flate2::Compression;
use flate2::write::GzEncoder;
use ruzstd::encoding::{CompressionLevel, compress_to_vec};
use serde_json::Value;
use sha2::{Digest, Sha256};

use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, fixture, report};
use boundfit_tests::program::root;

const FIT: &str = "--x Vz --y z --rows 14..36 --eps 0.5e-3";

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn zstd(bytes: &[u8]) -> Vec<u8> {
    compress_to_vec(bytes, CompressionLevel::Fastest)
}

/// A frame of Zstandard that is to be passed over.
fn skippable(content: &[u8]) -> Vec<u8> {
    [b"\x50\x2a\x4d\x18", &(content.len() as u32).to_le_bytes()[..], content].concat()
}

/// A report without what says which bytes were read, and their hash.
fn answer(directory: &Path, line: &str) -> (Value, String) {
    let mut report = report(directory, line, b"");
    let input = report["input"].as_object_mut().unwrap();
    let hash = input.remove("sha256").unwrap().as_str().unwrap().to_owned();
    input.retain(|key, _| !["file", "name"].contains(&key.as_str()));
    (report, hash)
}

#[test]
fn a_compressed_table_is_the_table() {
    let csv = fixture("transducer/transducer.csv");
    let (first, second) = csv.split_at(300);
    let mat = fs::read(root().join("fixtures/mat/transducer-v7.mat")).unwrap();
    let packed = [
        ("one.csv.gz", gzip(csv.as_bytes())),
        ("no-name", gzip(csv.as_bytes())),
        ("parts.gz", [gzip(first.as_bytes()), gzip(second.as_bytes())].concat()),
        ("one.csv.zst", zstd(csv.as_bytes())),
        (
            "parts.zst",
            [zstd(first.as_bytes()), skippable(b"?"), zstd(second.as_bytes()), skippable(b"")].concat(),
        ),
        ("after.zst", [skippable(&[7; 300]), zstd(csv.as_bytes())].concat()),
    ];
    let files: Vec<(&str, &[u8])> = packed.iter().map(|(name, bytes)| (*name, bytes.as_slice())).collect();
    let directory = directory_with(&files);
    fs::write(directory.path().join("data.csv"), &csv).unwrap();
    let (expected, _) = answer(directory.path(), &format!("fit data.csv {FIT}"));
    for (name, bytes) in &packed {
        let (found, hash) = answer(directory.path(), &format!("fit {name} {FIT}"));
        assert_eq!(found, expected, "{name}");
        let of_file: String = Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(hash, of_file, "{name}");
        let run = boundfit_with_input(directory.path(), &format!("fit - {FIT} --format json"), bytes);
        let of_stream: Value = serde_json::from_str(&run.stdout).unwrap();
        assert_eq!(
            (&of_stream["pui"], &of_stream["input"]["sha256"]),
            (&expected["pui"], &Value::from(hash))
        );
        for command in ["check", "convert --to lp --objective theta1-min", "plot", "lesson"] {
            let (command, more) = command.split_once(' ').unwrap_or((command, ""));
            let claim = if command == "check" { "--claim-pui 0,1,0,1" } else { "" };
            let run = boundfit(directory.path(), &format!("{command} {name} {FIT} {more} {claim}"));
            assert!(
                run.stderr.is_empty() && [0, 4].contains(&run.status),
                "{command} {name}: {}",
                run.stderr
            );
        }
    }
    fs::write(directory.path().join("mat.gz"), gzip(&mat)).unwrap();
    fs::write(directory.path().join("data.mat"), &mat).unwrap();
    let fit = |file: &str| answer(directory.path(), &format!("fit {file} {FIT}")).0;
    assert_eq!(fit("mat.gz"), fit("data.mat"));
}

#[test]
fn many_rows_and_reductions_are_packed_too() {
    let row = |k: i64| format!("{k},{}\n", 3 * k + k * k % 17);
    let csv = format!("x,y\n{}", (0..40_000).map(row).collect::<String>());
    let directory = directory_with(&[("data.csv", csv.as_bytes()), ("data.csv.gz", &gzip(csv.as_bytes()))]);
    let fit = |file: &str| answer(directory.path(), &format!("fit {file} --x x --y y --eps 20")).0;
    // Above the rows that are kept the EUI takes a second look at the file.
    assert_eq!(fit("data.csv.gz"), fit("data.csv"));
    for file in ["data.csv", "data.csv.gz"] {
        assert_eq!(
            boundfit(directory.path(), &format!("reduce {file} --x x --y y -o {file}.reduced")).status,
            0
        );
    }
    let reduced = fs::read(directory.path().join("data.csv.reduced")).unwrap();
    assert!(reduced == fs::read(directory.path().join("data.csv.gz.reduced")).unwrap());
    fs::write(directory.path().join("reduced.zst"), zstd(&reduced)).unwrap();
    assert_eq!(fit("reduced.zst"), fit("data.csv.reduced"));
}

/// Checks the message on a compressed file.
fn refused(bytes: &[u8], message: &str) {
    let directory = directory_with(&[("b", bytes)]);
    for command in ["fit", "check"] {
        let run = boundfit(directory.path(), &format!("{command} b --x x --y y --eps 1"));
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{message}");
        assert!(run.stderr.starts_with(&format!("error: b: {message}")), "{}", run.stderr);
    }
}

#[test]
fn damage_and_bombs_are_refused() {
    let csv = format!("x,y\n{}", "1,2\n2,3\n".repeat(1000));
    for (whole, format) in [(gzip(csv.as_bytes()), "a gzip file"), (zstd(csv.as_bytes()), "a Zstandard file")]
    {
        for cut in [whole.len() / 2, whole.len() - 1] {
            let directory = directory_with(&[("b", &whole[..cut])]);
            let run = boundfit(directory.path(), "fit b --x x --y y --eps 1");
            let words = format!("cannot read {format}: it ");
            assert!(run.status == 1 && run.stderr.contains(&words), "{}", run.stderr);
        }
        let mut wrong = whole.clone();
        let middle = wrong.len() / 2;
        wrong[middle] ^= 0x55;
        let directory = directory_with(&[("b", &wrong)]);
        let run = boundfit(directory.path(), "fit b --x x --y y --eps 1");
        assert!(run.status == 1 && run.stdout.is_empty(), "{format}: {run:?}");
    }
    for bomb in [gzip(&vec![b'\n'; 1 << 22]), zstd(&vec![b'\n'; 1 << 22])] {
        let directory = directory_with(&[("b", &bomb)]);
        let run = boundfit(directory.path(), "fit b --x x --y y --eps 1 --limit unpacked=1000000");
        let words =
            "refused: it unpacks to more than 1000000 bytes (the limit); --limit unpacked=N raises it\n";
        assert!(
            run.status == 1 && run.stderr.starts_with("error: b: ") && run.stderr.ends_with(words),
            "{}",
            run.stderr
        );
    }
    refused(
        &gzip(b"RDX3\nX\n\0\0"),
        "this is an R workspace (.RData); in R, save the data frame in it as CSV",
    );
}

#[test]
fn a_proof_is_about_text_that_is_not_packed() {
    let directory = directory_with(&[("data.csv.gz", &gzip(b"x,y\n1,2\n2,3\n"))]);
    let run = boundfit(directory.path(), "fit data.csv.gz --x x --y y --eps 1 --proof p.json");
    let words = "the data are none that the checkers read: they are another kind of file, or packed; save them as CSV with points";
    assert!(run.status == 2 && run.stderr.contains(words), "{}", run.stderr);
    assert!(!directory.path().join("p.json").exists());
}
