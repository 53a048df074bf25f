//! Quotes around any of the cells, with anything in them, and numbers with exponents: as the reference reads them.

use boundfit_exact::Reading;
use boundfit_formats::{ColumnSelector, RowRange, ScanOptions, TableOptions};
use boundfit_tests::generate::{seeded, share};
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

use super::both::{POOLS, by_reference, by_scan};

/// The oddities of a table whose numbers all are in quotes.
const ODDITIES: &[&str] = &[
    "\"\"",
    "\" \"",
    "\"1\"\"2\"",
    "\"1\"2",
    "1\"2\"",
    "\"1",
    "1\"",
    "\"",
    "\"1,5\"",
    "\"1\n2\"",
    "\"1\r\n2\"",
    "\"1\n\"",
    "\"#1\"",
    "\"1\" ",
    " \"1\"",
    "\"x\"",
    "\"1e\"",
    "\"1e5x\"",
    "\"-1\"",
    "\"1/3\"",
    "\"0.1234567890123456789012\"",
    "\"1e99999\"",
    "1e5e5",
    "1e5\"",
];

fn number(rng: &mut ChaCha8Rng) -> String {
    let digits = |rng: &mut ChaCha8Rng, most: u32| {
        let count = rng.random_range(1..=most);
        rng.random_range(0..10_u64.pow(count)).to_string()
    };
    let most = *[2, 7, 10].choose(rng).unwrap();
    let mut text = format!("{}{}", ["", "-"].choose(rng).unwrap(), digits(rng, most));
    if rng.random_bool(0.8) {
        text += &format!(".{}", digits(rng, most));
    }
    if rng.random_bool(0.4) {
        let sign = ["", "-", "+", "0", "-0"].choose(rng).unwrap();
        text += &format!("{}{sign}{}", ["e", "E"].choose(rng).unwrap(), rng.random_range(0..40));
    }
    text
}

/// A table of three columns, each of which has quotes around its cells or not, with oddities here and there.
fn table(rng: &mut ChaCha8Rng) -> String {
    let line_end = *["\n", "\n", "\r\n"].choose(rng).unwrap();
    let quoted: [bool; 3] = std::array::from_fn(|_| rng.random_bool(0.7));
    let odd = if rng.random_bool(0.5) { 0.02 } else { 0.0 };
    let mut text = format!("\"x\",t,\"y\"{line_end}");
    for _ in 0..rng.random_range(1..30) {
        for (column, &is_quoted) in quoted.iter().enumerate() {
            let number = number(rng);
            text += if column > 0 { "," } else { "" };
            match (rng.random_bool(odd), is_quoted) {
                (true, _) => text += ODDITIES.choose(rng).unwrap(),
                (false, true) => text += &format!("\"{number}\""),
                (false, false) => text += &number,
            }
        }
        text += if rng.random_bool(odd) {
            ["", "\n\n", ",\n", "\n\" \"\n"].choose(rng).unwrap()
        } else {
            line_end
        };
    }
    text.truncate(text.len() - rng.random_range(0..2) * line_end.len());
    text
}

#[test]
fn tables_with_quotes_are_read_by_the_rules_of_csv() {
    let mut rng = seeded(0x9007ed);
    let (mut found, mut refused) = (0, 0);
    for case in 0..share(3000) {
        let text = table(&mut rng);
        let wanted = *[&["x", "y"][..], &["y"], &["y", "x"], &["x", "t", "y"]].choose(&mut rng).unwrap();
        let columns: Vec<_> = wanted.iter().map(|name| ColumnSelector::name_or_number(name)).collect();
        let table = TableOptions {
            reading: *[Reading::Decimal, Reading::Decimal, Reading::Binary64].choose(&mut rng).unwrap(),
            rows: rng.random_bool(0.2).then(|| RowRange::from_row(2)).flatten().into(),
            ..TableOptions::default()
        };
        let options = ScanOptions { table, ..ScanOptions::default() };
        let expected = by_reference(text.as_bytes(), &columns, &options);
        for chunk_bytes in [1, 50, 1 << 18] {
            let options = ScanOptions { chunk_bytes, ..options.clone() };
            let actual = POOLS[1].install(|| by_scan(text.as_bytes(), &columns, &options));
            assert_eq!(actual, expected, "case {case}, chunks of {chunk_bytes}: {columns:?}\n{text:?}");
        }
        *(if expected.is_ok() { &mut found } else { &mut refused }) += 1;
    }
    assert!(found > share(1500) && refused > share(300), "{found} were read, {refused} refused");
}
