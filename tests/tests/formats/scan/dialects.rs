//! A table gives the same rows in every dialect that it can be written in.

use boundfit_exact::{DecimalMark, Thousands};
use boundfit_formats::{
    AskedBlock, AskedDialect, BLANKS, ColumnSelector, CommentMark, Missing, ScanOptions, TableOptions,
};
use boundfit_tests::generate::{seeded, share};
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

use super::both::{by_scan, pools};

/// Chunks of so many bytes, at least.
const CHUNKS: [usize; 3] = [1, 13, 4096];
const NAMES: [&str; 4] = ["a", "b", "c", "d"];

/// A table of texts: numbers with points, or nothing where one is missing.
struct Plain {
    width: usize,
    rows: Vec<Vec<String>>,
}

impl Plain {
    fn new(rng: &mut ChaCha8Rng) -> Self {
        let width = rng.random_range(2..=4);
        let share = if rng.random_bool(0.3) { 0.3 } else { 0.0 };
        let count = rng.random_range(1..12);
        // Nothing at the end would be no row.
        let rows = (0..count).map(|row| {
            let missing = if row == 0 || row + 1 == count { 0.0 } else { share };
            (0..width).map(|_| if rng.random_bool(missing) { String::new() } else { number(rng) }).collect()
        });
        Plain { width, rows: rows.collect() }
    }

    fn text(&self) -> String {
        let lines = self.rows.iter().map(|row| row.join(",") + "\n");
        NAMES[..self.width].join(",") + "\n" + &lines.collect::<String>()
    }
}

fn number(rng: &mut ChaCha8Rng) -> String {
    let (whole, part) = (rng.random_range(-2000..2000), rng.random_range(0..1000));
    match rng.random_range(0..6) {
        0 | 1 => format!("{whole}.{part:03}"),
        2 => format!("{whole}.{part}e-3"),
        3 => format!("1234567.{part}"),
        4 => format!("-0.{part}E2"),
        _ => whole.to_string(),
    }
}

/// A table in some dialect, with the options that describe it.
struct Written {
    bytes: Vec<u8>,
    asked: AskedDialect,
}

fn written(plain: &Plain, rng: &mut ChaCha8Rng) -> Written {
    let delimiter = *[b',', b';', b'\t', b'|', BLANKS].choose(rng).unwrap();
    let mut asked = AskedDialect::default();
    let decimal = *DecimalMark::ALL.choose(rng).unwrap();
    let [has_comments, is_commented, has_units, quotes_all] =
        [0.4, 0.2, 0.2, 0.15].map(|share| rng.random_bool(share));
    let has_units = has_units && !is_commented;
    let has_row_names = !is_commented && rng.random_bool(0.2);
    let has_trailing_cells = !is_commented && !has_row_names && delimiter != BLANKS && rng.random_bool(0.2);
    asked.units_row = has_units;
    asked.comment = if rng.random_bool(0.2) { CommentMark::Mark(b'!') } else { CommentMark::Auto };
    let marks = if asked.comment == CommentMark::Auto { ["#", "%"] } else { ["!", "!"] };
    // A comma between cells or digits of the first line is taken for a delimiter.
    asked.thousands = Thousands::ALL
        .choose(rng)
        .copied()
        .filter(|mark| mark.mark().as_bytes() != [decimal.byte()])
        .filter(|mark| !(*mark == Thousands::Blank && delimiter == BLANKS))
        .filter(|_| rng.random_bool(0.5));
    let has_commas = decimal == DecimalMark::Comma || asked.thousands == Some(Thousands::Comma);
    let hides = has_commas && is_commented && matches!(delimiter, b'|' | BLANKS);
    if hides || rng.random_bool(0.2) {
        asked.delimiter = Some(delimiter);
    }
    if (decimal == DecimalMark::Comma && delimiter == b',') || rng.random_bool(0.2) {
        asked.decimal = Some(decimal);
    }
    let separator = |rng: &mut ChaCha8Rng| match delimiter {
        // A tab in the first line is taken for a delimiter.
        BLANKS if asked.delimiter.is_none() => (*[" ", "   "].choose(rng).unwrap()).to_owned(),
        BLANKS => (*[" ", "\t", "   ", " \t "].choose(rng).unwrap()).to_owned(),
        byte => char::from(byte).to_string(),
    };
    let mut lines: Vec<String> = Vec::new();
    asked.skip_lines = if rng.random_bool(0.2) { 2 } else { 0 };
    lines.extend((0..asked.skip_lines).map(|_| "Device: X;\"made, in haste".to_owned()));
    let comment = |rng: &mut ChaCha8Rng| format!("{} it's a note", marks.choose(rng).unwrap());
    if has_comments {
        lines.extend((0..rng.random_range(1..3)).map(|_| comment(rng)));
    }
    let cell = |text: &str, rng: &mut ChaCha8Rng| {
        let mut text = text.to_owned();
        if decimal == DecimalMark::Comma {
            text = text.replace('.', ",");
        }
        if let Some(thousands) = asked.thousands.filter(|_| rng.random_bool(0.7)) {
            text = grouped(&text, thousands, rng);
        }
        if text.is_empty() {
            let words = ["NA", "nan", "#N/A", "-", ""];
            text = (*words[..if delimiter == BLANKS { 4 } else { 5 }].choose(rng).unwrap()).to_owned();
        } else if rng.random_bool(0.05) {
            text = text.replace('-', "\u{2212}");
        } else if rng.random_bool(0.05) {
            text = text.replace(['e', 'E'], "D") + "\u{a0}";
        }
        let hides = delimiter == b',' && text.contains(',');
        if hides || quotes_all { format!("\"{text}\"") } else { text }
    };
    let header: Vec<String> = NAMES[..plain.width].iter().map(|name| (*name).to_owned()).collect();
    let header = header.join(&separator(rng));
    lines.push(if is_commented { format!("{} {header}", marks[0]) } else { header });
    if has_units {
        let units: Vec<&str> =
            (0..plain.width).map(|_| *["mV", "°C", "(m/s)"].choose(rng).unwrap()).collect();
        lines.push(units.join(&separator(rng)));
    }
    for (number, row) in plain.rows.iter().enumerate() {
        // Among the first lines they would tell something.
        if number > 0 && rng.random_bool(0.1) {
            lines.push(comment(rng));
        }
        let mut cells: Vec<String> = row.iter().map(|text| cell(text, rng)).collect();
        if has_row_names {
            cells.insert(0, format!("\"row {number}\""));
        }
        let mut line = String::new();
        for (index, cell) in cells.iter().enumerate() {
            line += &if index == 0 { String::new() } else { separator(rng) };
            line += cell;
        }
        line += &if has_trailing_cells { separator(rng) } else { String::new() };
        lines.push(line);
    }
    if rng.random_bool(0.2) && delimiter != BLANKS {
        lines.extend((0..2).map(|_| separator(rng).repeat(plain.width - 1 + usize::from(has_row_names))));
    }
    if rng.random_bool(0.2) {
        lines.push(comment(rng));
    }
    let line_end = *["\n", "\n", "\r\n", "\r"].choose(rng).unwrap();
    let text = lines.join(line_end) + if rng.random_bool(0.8) { line_end } else { "" };
    Written { bytes: encoded(&text, rng), asked }
}

/// A number with its digits before the decimal mark in groups of three.
fn grouped(text: &str, thousands: Thousands, rng: &mut ChaCha8Rng) -> String {
    let marks: &[&str] = match thousands {
        Thousands::Comma => &[","],
        Thousands::Point => &["."],
        Thousands::Blank => &[" ", "\u{a0}", "\u{202f}"],
        Thousands::Apostrophe => &["'", "\u{2019}"],
    };
    let start = usize::from(text.starts_with('-'));
    let rest = &text[start..];
    let whole = rest.bytes().take_while(u8::is_ascii_digit).count();
    let mut grouped = text[..start].to_owned();
    for (index, digit) in rest[..whole].char_indices() {
        if index > 0 && (whole - index).is_multiple_of(3) {
            grouped += marks.choose(rng).unwrap();
        }
        grouped.push(digit);
    }
    grouped + &rest[whole..]
}

fn encoded(text: &str, rng: &mut ChaCha8Rng) -> Vec<u8> {
    let marked = format!("\u{feff}{text}");
    match rng.random_range(0..8) {
        0 => marked.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        1 => marked.encode_utf16().flat_map(u16::to_be_bytes).collect(),
        2 => marked.into_bytes(),
        _ => text.as_bytes().to_vec(),
    }
}

#[test]
fn a_table_has_the_same_rows_in_every_dialect() {
    let mut rng = seeded(0xd1a1);
    let columns = ["a", "b"].map(ColumnSelector::name_or_number);
    let options = |dialect: AskedDialect| ScanOptions {
        // Comments between rows are notes here, and begin no blocks.
        table: TableOptions {
            dialect,
            missing: Missing::Skip,
            block: Some(AskedBlock::All),
            ..TableOptions::default()
        },
        ..ScanOptions::default()
    };
    for number in 0..share(5000) {
        let plain = Plain::new(&mut rng);
        let expected = by_scan(plain.text().as_bytes(), &columns, &options(AskedDialect::default())).unwrap();
        let Written { bytes, asked } = written(&plain, &mut rng);
        for (pool, threads) in pools(number) {
            let by_chunks =
                |chunk_bytes| by_scan(&bytes, &columns, &ScanOptions { chunk_bytes, ..options(asked) });
            let all = pool.install(|| CHUNKS.map(by_chunks));
            for (chunk_bytes, found) in CHUNKS.iter().zip(all) {
                let text = String::from_utf8_lossy(&bytes);
                let case = || {
                    format!("case {number}, {threads} threads, chunks of {chunk_bytes}: {asked:?}\n{text:?}")
                };
                let found = found.unwrap_or_else(|error| panic!("{error}: {}", case()));
                assert_eq!(found.rows, expected.rows, "{}", case());
                // A header such as `# a,b` may be meant as it stands.
                let names = found.names.iter().map(|name| name.trim_start_matches(['#', '%', ' ']));
                assert!(names.eq(expected.names.iter()), "{}", case());
                assert_eq!(found.rows_total, expected.rows_total, "{}", case());
            }
        }
    }
}
