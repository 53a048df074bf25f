//! Plain decimals are read as the full parser reads them.

use boundfit_exact::{Limits, Rational, Reading, Unit, plain_decimal, plain_double, plain_prefix};
use boundfit_formats::{ColumnSelector, ScanOptions, TableOptions};
use boundfit_tests::generate::seeded;
use rand::RngExt;
use rand::seq::IndexedRandom;

use super::both::{batches, source};

#[test]
fn plain_decimals_are_what_they_spell() {
    let mut rng = seeded(0xdec1);
    let limits = Limits::default();
    let read = |reading: Reading, text: &str| reading.read(text, &limits);
    let (mut plain, mut other) = (0, 0);
    for _ in 0..100_000 {
        let digits = |rng: &mut rand_chacha::ChaCha8Rng, most: usize| -> String {
            let count = rng.random_range(0..=most);
            (0..count).map(|_| *b"0012345678999".choose(rng).unwrap() as char).collect()
        };
        let most = *[3, 8, 9, 17, 22].choose(&mut rng).unwrap();
        let mut text = ["", "", "-", "+", " ", "--"].choose(&mut rng).unwrap().to_string();
        text += &digits(&mut rng, most);
        text += ["", ".", ".", "."].choose(&mut rng).unwrap();
        text += &digits(&mut rng, most);
        if rng.random_bool(0.3) {
            let sign = ["", "-", "+"].choose(&mut rng).unwrap();
            text += &format!("e{sign}{}", digits(&mut rng, 3));
        }
        if rng.random_bool(0.1) {
            let at = rng.random_range(0..=text.len());
            text.insert(at, *['.', ' ', '/', 'e', ':', '\t', '5', '\u{e9}'].choose(&mut rng).unwrap());
        }
        let exact = read(Reading::Decimal, &text);
        match plain_decimal(text.as_bytes()) {
            Some((mantissa, exponent)) => {
                let number = Unit::TenTo(exponent).times(mantissa.into());
                assert_eq!(Ok(number), exact, "{text:?}");
                plain += 1;
            }
            // Nothing plain and short is left to the full parser.
            None => {
                let is_short = text.bytes().filter(u8::is_ascii_digit).count() <= 18;
                // Long exponents are read where what they cost is counted.
                let exponent =
                    text.split_once('e').and_then(|(_, exponent)| exponent.trim().parse::<i32>().ok());
                let is_far = exponent.is_some_and(|exponent| exponent.abs() > 900);
                assert!(!is_short || is_far || exact.is_err() || text.contains('/'), "{text:?}");
                other += 1;
            }
        }
        if let Some(double) = plain_double(text.as_bytes()) {
            assert_eq!(Rational::from_f64(double), read(Reading::Binary64, &text).ok(), "{text:?}");
        }
        if let Some(prefix) = plain_prefix(text.as_bytes()) {
            let number = Unit::TenTo(-prefix.fraction_digits).times(prefix.mantissa.into());
            assert_eq!(Ok(number), read(Reading::Decimal, &text[..prefix.length]), "{text:?}");
        }
    }
    assert!(plain > 30_000 && other > 10_000, "{plain} were plain, {other} not");
}

/// Many rows are read at once, in either reading; the full parser reads each cell alone.
#[test]
fn long_cells_of_a_table_are_what_they_spell() {
    let mut rng = seeded(0x10e6);
    let mut cell = || {
        let x: f64 = rng.random_range(-4.0..4.0);
        let places = rng.random_range(0..24);
        match rng.random_range(0..8) {
            0 => format!("{x}"),
            1 => format!("{x:.places$}"),
            2 => format!("{x:.places$e}"),
            3 => format!("{:e}", x * 10_f64.powi(rng.random_range(-300..300))),
            4 => format!("{}", rng.random::<i64>() >> rng.random_range(0..60)),
            // Half-way between doubles.
            5 => format!("-{}.5", (1_u64 << 52) + rng.random_range(0..1 << 52)),
            6 => format!("0.{:0places$}{}", 0, rng.random::<u64>()),
            _ => format!("{:019}E+{places}", rng.random::<u64>()),
        }
    };
    let rows: Vec<[String; 2]> = (0..4000).map(|_| [cell(), cell()]).collect();
    let lines: Vec<String> = rows.iter().map(|row| row.join(",")).collect();
    let text = format!("x,y\n{}\n", lines.join("\n"));
    let columns = ["x", "y"].map(ColumnSelector::name_or_number);
    for reading in [Reading::Decimal, Reading::Binary64] {
        let table = TableOptions { reading, ..TableOptions::default() };
        let options = ScanOptions { table, chunk_bytes: 1 << 12, ..ScanOptions::default() };
        let (_, batches) = batches(source(text.as_bytes()), &columns, &options).unwrap();
        let found: Vec<_> = batches.iter().flat_map(|batch| batch.table_rows()).collect();
        assert_eq!(found.len(), rows.len());
        for (found, cells) in found.iter().zip(&rows) {
            let expected = cells.each_ref().map(|cell| reading.read(cell, &Limits::default()).unwrap());
            assert_eq!(found.numbers, expected, "{reading:?} {cells:?}");
        }
    }
}
