//! Objects with the same keys as the one before are read by comparing bytes, others token by token: to the same rows.

use std::io::Cursor;

use boundfit_formats::{ColumnSelector, Missing, ScanOptions, SizeLimits, Source, TableOptions};
use rand::RngExt as _;
use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;

use super::both::{batches, found};

/// Returns the number and the numbers of each row, and their keys, or the message.
fn read(text: &str, options: &ScanOptions) -> Result<(Vec<String>, Vec<String>), String> {
    let columns = ["x", "y"].map(ColumnSelector::name_or_number);
    let source = Source::new("r.ndjson", Cursor::new(text.as_bytes().to_vec()));
    let (scanned, batches) = batches(source, &columns, options)?;
    let keys = batches.iter().flat_map(|batch| batch.keys.iter());
    let keys = keys.flat_map(|keys| (0..keys.len()).map(|index| keys.get(index).to_owned())).collect();
    let missing = scanned.rows_missing;
    let rows = found(scanned, &batches).rows;
    let rows = rows.iter().map(|row| format!("{row:?}")).chain([format!("{missing} missing")]);
    Ok((rows.collect(), keys))
}

/// A key with room behind it for its escape.
const KEY: &str = "\"s\"     ";

/// The text, as long as before, with a key escaped, which no comparison of bytes finds.
fn token_by_token(text: &str) -> String {
    text.replace(KEY, "\"\\u0073\"")
}

fn record(random: &mut ChaCha8Rng) -> String {
    let mut pick = |texts: &[&str]| texts[random.random_range(0..texts.len())].to_owned();
    const NUMBERS: [&str; 14] = [
        "1.5",
        "-2",
        "0.8329073596664792",
        "1e-3",
        "2E+5",
        "7",
        "-0",
        "1",
        "2",
        "3",
        "4",
        "12.25",
        "\"5.5\"",
        "null",
    ];
    let space = pick(&["", "", "", "", "", " ", "\t", "\n", "\r\n  "]);
    let key = pick(&[
        "\"a\"",
        "\"b\"",
        "\" c\\t\"",
        "\"\u{e4}\"",
        "\"\\ud83d\\ude42\"",
        "\"l\nf\"",
        "7",
        "null",
        "\"\"",
    ]);
    let (x, y) = (pick(&NUMBERS), pick(&NUMBERS));
    let rare = pick(&["x"; 300].iter().copied().chain(["1", "2", "3", "4", "5", "6"]).collect::<Vec<_>>());
    match rare.as_str() {
        "1" => format!("{{{KEY}:{key},\"y\":{y},\"x\":{x}}}"),
        "2" => format!("{{{KEY}:{key},\"x\":{x}}}"),
        "3" => format!("{{{KEY}:{key},\"x\":{x},\"new\":[1,{{\"x\":2}}],\"y\":{y}}}"),
        "4" => "{}".to_owned(),
        "5" => format!("{{{KEY}:{key},\"x\":{x},\"y\":{y},{KEY}:{key}}}"),
        "6" => format!("{{{KEY}:{key},\"x\":{{\"y\":1}},\"y\":{y}}}"),
        _ => format!("{space}{{{space}{KEY}:{key},{space}\"x\":{space}{x},\"y\":{y}{space}}}"),
    }
}

#[test]
fn objects_like_the_last_give_what_their_tokens_give() {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let (mut refused, mut rows) = (0, 0);
    for case in 0..600 {
        let records: Vec<String> = (0..random.random_range(1..60)).map(|_| record(&mut random)).collect();
        let mut text = match case % 3 {
            0 => records.join("\n"),
            1 => format!("[{}]", records.join(",\n")),
            _ => records.concat(),
        };
        if case % 4 == 0 {
            // Something is wrong, or the text ends too early.
            let at = (0..text.len())
                .rev()
                .find(|&at| at <= random.random_range(0..=text.len()) && text.is_char_boundary(at));
            let (before, behind) = text.split_at(at.unwrap_or_default());
            let wrong = ["", "x", "\"", "}", ",", "\\", "\n{", "]", " 1 "][random.random_range(0..9)];
            text =
                if case % 8 == 0 { format!("{before}{wrong}") } else { format!("{before}{wrong}{behind}") };
        }
        let missing = if case % 5 == 0 { Missing::Refuse } else { Missing::Skip };
        let sizes = match case % 7 {
            3 => SizeLimits { line: random.random_range(1..60), ..SizeLimits::default() },
            4 => SizeLimits { columns: random.random_range(1..5), ..SizeLimits::default() },
            5 => {
                let memory = boundfit_formats::MemoryBudget::new(random.random_range(200..20_000));
                SizeLimits { memory, ..SizeLimits::default() }
            }
            _ => SizeLimits::default(),
        };
        let options = ScanOptions {
            table: TableOptions { missing, sizes, ..TableOptions::default() },
            key: Some(ColumnSelector::name_or_number("s")),
            chunk_bytes: random.random_range(1..2000),
            ..ScanOptions::default()
        };
        let (fast, slow) = (read(&text, &options), read(&token_by_token(&text), &options));
        // The message about an unreadable text shows the start of the key behind it as it is written.
        let shown = |message: String| {
            let place = message.split(": ").nth(1).unwrap_or_default().to_owned();
            (place, message.replace(|of_key| "\"\\su073 ".contains(of_key), ""))
        };
        let [fast, slow] = [fast, slow].map(|read| read.map_err(shown));
        assert_eq!(fast, slow, "{text}");
        match &fast {
            Ok((found, _)) => rows += found.len(),
            Err(_) => refused += 1,
        }
    }
    assert!(rows > 2000 && refused > 50, "{rows} {refused}");
}
