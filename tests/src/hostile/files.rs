//! Files in the formats that are read, with expensive numbers in them.

use std::io::Write;

use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::numbers::{Written, number, written};
use super::one_of;
use crate::workbooks;

/// Rows of numbers with commas between them, until a number of bytes is reached.
pub(super) fn rows(rng: &mut ChaCha8Rng, columns: usize, bytes: usize) -> String {
    let mut kinds: Vec<Written> = (0..columns).map(|_| written(rng)).collect();
    if rng.random_bool(0.4) {
        let first = kinds[0];
        kinds.fill(first);
    }
    let other = written(rng);
    let (mixed, repeated) = (rng.random_bool(0.2), rng.random_bool(0.1));
    let junk = rng.random_bool(0.03);
    let mut text = String::new();
    let mut last = String::new();
    for row in 0.. {
        let cells: Vec<String> = kinds
            .iter()
            .map(|kind| match rng.random_range(0..20) {
                0 if junk => number(rng, Written::Junk, row),
                0..5 if mixed => number(rng, other, row),
                _ => number(rng, *kind, row),
            })
            .collect();
        let line = if repeated && row > 0 && rng.random_bool(0.7) { last.clone() } else { cells.join(",") };
        if text.len() + line.len() + 1 > bytes && row > 1 {
            break;
        }
        text += &line;
        text.push('\n');
        last = line;
    }
    text
}

/// Returns how large a file becomes: as often as large as it may be as smaller.
pub(super) fn size(rng: &mut ChaCha8Rng) -> usize {
    if rng.random_bool(0.5) { 3600 } else { rng.random_range(30..3600) }
}

/// A table with columns x, y, u and g, of which the last has groups.
pub(super) fn table(rng: &mut ChaCha8Rng) -> String {
    let columns = rng.random_range(2..4);
    let bytes = size(rng);
    format!("{}\n{}", ["x", "y", "u"][..columns].join(","), rows(rng, columns, bytes))
}

/// The table as another dialect, or in another kind of file, with the name of the file.
pub(super) fn as_file(rng: &mut ChaCha8Rng, table: &str) -> (String, Vec<u8>) {
    let plain = |name: &str, text: String| (name.to_owned(), text.into_bytes());
    match rng.random_range(0..30) {
        0 => plain("data.csv", table.replace('.', "\u{1}").replace(',', ";").replace('\u{1}', ",")),
        1 => plain("data.csv", table.replace(',', "\t")),
        2 => plain("data.csv", table.replace(',', "   ")),
        3 => plain("data.csv", table.replace('\n', "\r\n")),
        4 => plain("data.csv", format!("\u{feff}{table}")),
        5 => plain("data.csv", format!("# note\n{table}% end\n")),
        6 => plain("data.csv", table.replace(',', "\",\"").replace('\n', "\"\n\"")),
        7 => {
            let units = table.encode_utf16().flat_map(u16::to_le_bytes);
            ("data.csv".to_owned(), [0xff, 0xfe].into_iter().chain(units).collect())
        }
        8 => ("data.csv.gz".to_owned(), gzip(table.as_bytes())),
        9 => {
            let packed = ruzstd::encoding::compress_to_vec(
                table.as_bytes(),
                ruzstd::encoding::CompressionLevel::Fastest,
            );
            ("data.csv.zst".to_owned(), packed)
        }
        10 => {
            let rows = workbooks::xlsx_rows(&table[..table.len().min(1500)], b'A', 1);
            ("data.xlsx".to_owned(), workbooks::xlsx(&[("Data", &rows)]))
        }
        11 => {
            let rows = workbooks::ods_rows(&table[..table.len().min(1500)]);
            ("data.ods".to_owned(), workbooks::ods(&[("Data", &rows)]))
        }
        12 => ("data.mat".to_owned(), mat(rng)),
        _ => plain("data.csv", table.to_owned()),
    }
}

/// Bytes in a gzip file.
pub fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).expect("memory takes it");
    encoder.finish().expect("memory takes it")
}

/// Returns what unpacks to many times its size, or packs of packs of it.
pub(super) fn bomb(rng: &mut ChaCha8Rng) -> (String, Vec<u8>) {
    let unpacked = rng.random_range(1_usize..4) << 16;
    let piece: &[u8] =
        one_of(rng, &[&b"1"[..], b"1,1\n", b"1,1\n2,1\n", b"\n", b"\0", b",", b"\"", b"1e9999,1e-9999\n"]);
    let content: Vec<u8> =
        b"x,y\n1,2\n2,3\n".iter().chain(piece.iter().cycle().take(unpacked)).copied().collect();
    match rng.random_range(0..4) {
        0 => ("data.csv.gz".to_owned(), gzip(&content)),
        1 => ("data.csv.gz".to_owned(), gzip(&gzip(&content))),
        2 => ("data.csv.zst".to_owned(), repeated_by_zstandard(piece[0], 20)),
        _ => ("data.mat".to_owned(), mat_of(unpacked, true)),
    }
}

/// A frame of so many blocks that each repeat one byte 131,072 times.
pub fn repeated_by_zstandard(byte: u8, blocks: usize) -> Vec<u8> {
    repeated_behind(b"", byte, blocks, 21)
}

/// A frame of these bytes, unless there are none, and so many blocks that each repeat one byte 131,072 times, with a window of two to
/// this power of bytes.
pub fn repeated_behind(start: &[u8], byte: u8, blocks: usize, window: u8) -> Vec<u8> {
    let mut frame = vec![0x28, 0xb5, 0x2f, 0xfd, 0x00, (window - 10) << 3];
    if !start.is_empty() {
        frame.extend(&((start.len() as u32) << 3).to_le_bytes()[..3]);
        frame.extend(start);
    }
    for block in 0..blocks {
        let header = u32::from(block + 1 == blocks) | 1 << 1 | (1 << 17) << 3;
        frame.extend(&header.to_le_bytes()[..3]);
        frame.push(byte);
    }
    frame
}

/// A MATLAB file with variables x and y.
fn mat(rng: &mut ChaCha8Rng) -> Vec<u8> {
    let count = rng.random_range(1..100);
    let packed = rng.random_bool(0.5);
    mat_of(8 * count, packed)
}

/// A MATLAB file of version 7 with so many zeros as x, and as y.
pub fn matlab_zeros(count: usize) -> Vec<u8> {
    mat_of(8 * count, true)
}

fn mat_of(bytes: usize, packed: bool) -> Vec<u8> {
    let element = |kind: u32, content: &[u8]| {
        let mut element = [kind.to_le_bytes(), (content.len() as u32).to_le_bytes()].concat();
        element.extend(content);
        element.resize(element.len().next_multiple_of(8), 0);
        element
    };
    let mut file = b"MATLAB 5.0 MAT-file".to_vec();
    file.resize(124, b' ');
    file.extend(*b"\x00\x01IM");
    for name in ["x", "y"] {
        let numbers: Vec<u8> = match packed {
            true => vec![0; bytes],
            false => (0..bytes / 8).flat_map(|k| (k as f64 * 0.7).sqrt().to_le_bytes()).collect(),
        };
        let sizes = [(bytes / 8) as u32, 1].map(u32::to_le_bytes).concat();
        let parts = [
            element(6, &[6, 0, 0, 0, 0, 0, 0, 0]),
            element(5, &sizes),
            element(1, name.as_bytes()),
            element(9, &numbers),
        ];
        let matrix = element(14, &parts.concat());
        if packed {
            let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
            encoder.write_all(&matrix).expect("memory takes it");
            let content = encoder.finish().expect("memory takes it");
            file.extend([15_u32.to_le_bytes(), (content.len() as u32).to_le_bytes()].concat());
            file.extend(content);
        } else {
            file.extend(matrix);
        }
    }
    file
}

/// An `.ine` or `.ext` file.
pub(super) fn cdd(rng: &mut ChaCha8Rng) -> (String, Vec<u8>) {
    let bytes = size(rng);
    let rows = rows(rng, 3, bytes);
    let count = rows.lines().count();
    let (ending, title) = one_of(rng, &[("ine", "H-representation"), ("ext", "V-representation")]);
    let points = |line: &str| match (ending, line.split_once(',')) {
        ("ext", Some((_, rest))) => format!("{} {}", 1, rest.replace(',', " ")),
        _ => line.replace(',', " "),
    };
    let lines: Vec<String> = rows.lines().map(points).collect();
    let text = format!("{title}\nbegin\n{count} 3 rational\n{}\nend\n", lines.join("\n"));
    (format!("data.{ending}"), text.into_bytes())
}

/// A linear program in two variables.
pub(super) fn model(rng: &mut ChaCha8Rng) -> (String, Vec<u8>) {
    let bytes = size(rng);
    let rows = rows(rng, 3, bytes * 2 / 3);
    let (sense, relation) = (one_of(rng, &["Minimize", "Maximize"]), one_of(rng, &["<=", ">=", "="]));
    let cells = |line: &str| -> Vec<String> { line.split(',').map(ToOwned::to_owned).collect() };
    let parsed: Vec<Vec<String>> = rows.lines().map(cells).collect();
    if rng.random_bool(0.5) {
        let term = |cell: &str| match cell.strip_prefix('-') {
            Some(size) => format!("- {size}"),
            None => format!("+ {cell}"),
        };
        let mut text = format!("{sense}\n obj: x + y\nSubject To\n");
        for row in &parsed {
            text += &format!(" {} x {} y {relation} {}\n", term(&row[0]), term(&row[1]), row[2]);
        }
        text += "Bounds\n x free\n y free\nEnd\n";
        return ("model.lp".to_owned(), text.into_bytes());
    }
    let letter = match relation {
        "<=" => "L",
        ">=" => "G",
        _ => "E",
    };
    let mut text = "NAME p\nROWS\n N o\n".to_owned();
    parsed.iter().enumerate().for_each(|(k, _)| text += &format!(" {letter} r{k}\n"));
    text += "COLUMNS\n x o 1\n";
    parsed.iter().enumerate().for_each(|(k, row)| text += &format!(" x r{k} {}\n", row[0]));
    text += " y o 1\n";
    parsed.iter().enumerate().for_each(|(k, row)| text += &format!(" y r{k} {}\n", row[1]));
    text += "RHS\n";
    parsed.iter().enumerate().for_each(|(k, row)| text += &format!(" b r{k} {}\n", row[2]));
    text += "BOUNDS\n FR z x\n FR z y\nENDATA\n";
    ("model.mps".to_owned(), text.into_bytes())
}
