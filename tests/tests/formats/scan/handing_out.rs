//! The results that a scan hands out beside the numbers, and the time of each.

use std::io::Cursor;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use boundfit_exact::{Column, Foreign, Rational, Reading, Unit};
use boundfit_formats::{
    Batch, ColumnSelector, Missing, Progress, RowRange, ScanOptions, Source, TableOptions,
};
use rand::RngExt as _;
use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;

use super::both::{POOLS, batches};

fn source(text: &str) -> Source {
    Source::new("data.csv", Cursor::new(text.to_owned().into_bytes()))
}

fn by_name(names: &[&str]) -> Vec<ColumnSelector> {
    names.iter().map(|name| ColumnSelector::name_or_number(name)).collect()
}

/// Keys and lines of all batches.
fn texts(batches: &[Batch]) -> (Vec<String>, Vec<String>) {
    let keys = batches.iter().flat_map(|batch| batch.keys.iter());
    let keys = keys.flat_map(|keys| (0..keys.len()).map(|index| keys.get(index).to_owned()));
    let lines = batches.iter().flat_map(|batch| batch.lines.iter());
    let line = |line: &[u8]| String::from_utf8(line.to_vec()).unwrap();
    let lines = lines.flat_map(|lines| (0..lines.len()).map(move |index| line(lines.get(index))));
    (keys.collect(), lines.collect())
}

#[test]
fn keys_and_lines_are_those_of_the_rows() {
    let columns = by_name(&["x"]);
    for (table, keys, lines) in [
        ("s , x\n a\t,1\n\n ä,2 \r\n  \n,3", ["a", "ä", ""].as_slice(), [" a\t,1", " ä,2 ", ",3"].as_slice()),
        (
            "s,x\r\n\"a,\nb\",1\r\n  \r\n\" c \",\"2\"\r\n\"\"\"\",3\r\n\r\n",
            &["a,\nb", " c ", "\""],
            &["\"a,\nb\",1", "\" c \",\"2\"", "\"\"\"\",3"],
        ),
    ] {
        for chunk_bytes in 1..40 {
            let options = ScanOptions {
                key: Some(ColumnSelector::name_or_number("s")),
                keep_text: true,
                chunk_bytes,
                ..ScanOptions::default()
            };
            let (scanned, batches) = POOLS[1].install(|| batches(source(table), &columns, &options)).unwrap();
            let (found_keys, found_lines) = texts(&batches);
            assert_eq!(found_keys, keys, "{table:?} in chunks of {chunk_bytes}");
            assert_eq!(found_lines, lines, "{table:?} in chunks of {chunk_bytes}");
            assert_eq!(scanned.key_name.as_ref().map(Foreign::raw), Some("s"));
            assert_eq!(scanned.header_line.as_deref(), table.lines().next().map(str::as_bytes));
            let delimiter = scanned.layout.map(|layout| layout.dialect.delimiter);
            assert_eq!((scanned.bytes, delimiter), (table.len() as u64, Some(b',')));
        }
    }
}

#[test]
fn a_key_is_text() {
    let columns = by_name(&["x"]);
    let options = ScanOptions { key: by_name(&["s"]).pop(), ..ScanOptions::default() };
    let bytes = b"s,x\na,1\n\xff,2\n".to_vec();
    let (_, found) = batches(Source::new("data.csv", Cursor::new(bytes)), &columns, &options).unwrap();
    assert_eq!(found[0].keys.as_ref().unwrap().get(1), "ÿ");
    let bytes = "s,x\nµ,1\n".as_bytes().iter().chain(b"\xff,2\n").copied().collect::<Vec<u8>>();
    let refused = batches(Source::new("data.csv", Cursor::new(bytes)), &columns, &options);
    assert_eq!(
        refused.unwrap_err(),
        "data.csv: line 3, column 1 (s): \"\u{fffd}\": invalid UTF-8 at character 1 of the cell (expected text in UTF-8, \
         as the characters before it are)"
    );
    let unknown = batches(source("t,x\na,1\n"), &columns, &options);
    assert_eq!(
        unknown.unwrap_err(),
        "data.csv: line 1: there is no column \"s\" (expected one of \"t\", \"x\" or a number from 1 to 2)"
    );
    let number = ScanOptions { key: by_name(&["2"]).pop(), ..ScanOptions::default() };
    let (scanned, batches) = batches(source("7,8\n9,10\n"), &by_name(&["2"]), &number).unwrap();
    assert_eq!(
        (texts(&batches).0, scanned.key_name.as_ref().map(Foreign::raw)),
        (vec!["8".to_owned(), "10".to_owned()], Some("col2"))
    );
}

/// Returns the storage of a column.
fn column(cells: &str, reading: Reading) -> Column {
    let table = TableOptions { reading, ..TableOptions::default() };
    let options = ScanOptions { table, ..ScanOptions::default() };
    let (_, mut batches) = batches(source(cells), &by_name(&["1"]), &options).unwrap();
    batches.pop().unwrap().columns.remove(0)
}

#[test]
fn columns_are_kept_as_their_numbers_allow() {
    let narrow = |counts: &[i64], unit| Column::of_counts(counts.iter().map(|&count| count.into()), unit);
    let wide = |counts: &[i128], unit| Column::of_counts(counts.iter().copied(), unit);
    let most = (1 << 62) - 1;
    for (cells, expected) in [
        ("1.5\n-2\n3.25\n", narrow(&[150, -200, 325], Unit::TenTo(-2))),
        ("0\n0.000\n", narrow(&[0, 0], Unit::Any)),
        ("0.000\n5e300\n0\n", narrow(&[0, 5, 0], Unit::TenTo(300))),
        ("4611686018427387903\n-4611686018427387903\n", narrow(&[most, -most], Unit::TenTo(0))),
        ("461168601842738790\n0.1\n", narrow(&[most - 3, 1], Unit::TenTo(-1))),
        ("0.1\n461168601842738790\n", narrow(&[1, most - 3], Unit::TenTo(-1))),
        ("1\n2e18\n", narrow(&[1, 2_000_000_000_000_000_000], Unit::TenTo(0))),
        ("0\n1/3\n", narrow(&[0, 1], Unit::OneOver(3))),
        ("0.1\n1/3\n", narrow(&[3, 10], Unit::OneOver(30))),
    ] {
        assert!(matches!(expected, Column::Narrow(_)));
        assert_eq!(column(cells, Reading::Decimal), expected, "{cells:?}");
    }
    for (cells, expected) in [
        ("9223372036854775807\n0\n", wide(&[i64::MAX.into(), 0], Unit::TenTo(0))),
        ("922337203685477581\n0.1\n", wide(&[9_223_372_036_854_775_810, 1], Unit::TenTo(-1))),
        ("0.1\n922337203685477581\n", wide(&[1, 9_223_372_036_854_775_810], Unit::TenTo(-1))),
        ("1\n9223372036854775808\n", wide(&[1, 1 << 63], Unit::OneOver(1))),
    ] {
        assert!(matches!(expected, Column::Wide(_)));
        let found = column(cells, Reading::Decimal);
        assert!(matches!(found, Column::Wide(_)), "{cells:?}");
        let numbers = |column: &Column| [column.get(0), column.get(1)];
        assert_eq!(numbers(&found), numbers(&expected), "{cells:?}");
    }
    for cells in ["1e300\n1e-300\n0\n", "1e-300\n-2.5e300\n"] {
        let found = column(cells, Reading::Decimal);
        assert!(matches!(found, Column::Scattered(_)), "{cells:?}");
        for (row, cell) in cells.lines().enumerate() {
            let exact = Reading::Decimal.read(cell, &TableOptions::default().limits);
            assert_eq!(Ok(found.get(row)), exact, "{cells:?}");
        }
    }
    for cells in ["1e300\n1e-300\n1/3\n", "1/3\n1e40\n"] {
        let exact: Vec<Rational> = cells
            .lines()
            .map(|cell| Reading::Decimal.read(cell, &TableOptions::default().limits).unwrap())
            .collect();
        assert_eq!(column(cells, Reading::Decimal), Column::Fractions(exact), "{cells:?}");
    }
    let doubles = column("0.1\n1/3\n-0.0\n-1e-400\n9007199254740993\n", Reading::Binary64);
    let Column::Doubles(doubles) = doubles else { panic!("{doubles:?}") };
    let bits: Vec<u64> = doubles.iter().map(|double| double.to_bits()).collect();
    assert_eq!(bits, [0.1, 1.0 / 3.0, 0.0, 0.0, 9_007_199_254_740_992.0].map(f64::to_bits));
}

/// Batches do not depend on the threads, come in the order of the file and hold wanted rows alone.
#[test]
fn batches_follow_from_the_file() {
    let table: String = (1..=5000).map(|row| format!("{row},{}.5\n", row % 7)).collect();
    let table_options = TableOptions { rows: RowRange::new(1203, 3999).into(), ..TableOptions::default() };
    let options = ScanOptions { table: table_options, chunk_bytes: 300, ..ScanOptions::default() };
    let read = |pool: usize| {
        POOLS[pool].install(|| batches(source(&table), &by_name(&["1", "2"]), &options)).unwrap().1
    };
    let first = read(0);
    assert!(first.len() > 50);
    assert_eq!(first.iter().map(|batch| batch.rows.len()).sum::<usize>(), 3999 - 1202);
    let rows: Vec<usize> =
        first.iter().flat_map(|batch| batch.rows.ranges()).flat_map(|[first, last]| first..=last).collect();
    assert_eq!(rows, (1203..=3999).collect::<Vec<_>>());
    assert!(read(1) == first && read(2) == first);
}

/// Counts the bytes, and cancels after so many.
struct Watch {
    bytes: AtomicU64,
    until: u64,
}

impl Progress for Watch {
    fn advanced(&self, bytes: u64) {
        self.bytes.fetch_add(bytes, Ordering::Relaxed);
    }

    fn is_cancelled(&self) -> bool {
        self.bytes.load(Ordering::Relaxed) >= self.until
    }
}

#[test]
fn progress_is_told_and_may_stop_the_scan() {
    let plain: String = (1..=5000).map(|row| format!("{row},1\n")).collect();
    let quoted = plain.replacen(",1\n", ",\"1\n\"\n", 1);
    for table in [plain, quoted] {
        for (until, message) in [(u64::MAX, None), (10_000, Some("data.csv: interrupted"))] {
            let watch = Arc::new(Watch { bytes: AtomicU64::new(0), until });
            let progress: Arc<dyn Progress> = watch.clone();
            let options =
                ScanOptions { chunk_bytes: 100, progress: Some(progress), ..ScanOptions::default() };
            let scanned = POOLS[1].install(|| batches(source(&table), &by_name(&["1", "2"]), &options));
            assert_eq!(scanned.err().as_deref(), message);
            let told = watch.bytes.load(Ordering::Relaxed);
            assert!(if message.is_none() { told >= table.len() as u64 } else { told < 20_000 }, "{told}");
        }
    }
}

/// A key among plain numbers is read in one loop with them, unless the text of the rows is wanted as well.
#[test]
fn keys_among_plain_numbers_are_those_of_rows_read_cell_by_cell() {
    let mut random = ChaCha8Rng::seed_from_u64(11);
    let columns = by_name(&["x", "y"]);
    let (mut refused, mut rows) = (0, 0);
    for case in 0..400 {
        let mut table = ["s,x,y,t\n", "x,s,y,t\n", "t,x,y,s\n", "y,t,s,x\n"][case % 4].to_owned();
        let names: Vec<String> = table.trim_end().split(',').map(str::to_owned).collect();
        let end = ["\n", "\n", "\r\n"][random.random_range(0..3)];
        let mut key = "k1".to_owned();
        for _ in 0..random.random_range(1..80) {
            let mut pick = |texts: &[&str]| texts[random.random_range(0..texts.len())].to_owned();
            if pick(&["same", "same", "other"]) == "other" {
                key = pick(&["k1", "k", "k12", " k1\t", "", "\u{e4}", "-5", "a b", "k1", "k2", "k3"]);
            }
            let rare = pick(&["x"; 120].iter().copied().chain(["1", "2", "3", "4"]).collect::<Vec<_>>());
            let number = |pick: &mut dyn FnMut(&[&str]) -> String| {
                pick(&["1.5", "-2", "0.25", "1e3", "12345678901234567"])
            };
            let mut cells: Vec<String> = Vec::new();
            for name in &names {
                cells.push(match name.as_str() {
                    "s" if rare == "1" => format!("\"{key}\""),
                    "s" => key.clone(),
                    "t" => pick(&["a", "", "7"]),
                    "x" if rare == "2" => "".to_owned(),
                    "y" if rare == "3" => "1_0".to_owned(),
                    _ => number(&mut pick),
                });
            }
            if rare == "4" {
                cells.pop();
            }
            table += &(cells.join(",") + end);
        }
        let missing = if case % 3 == 0 { Missing::Refuse } else { Missing::Skip };
        let read = |keep_text: bool| {
            let options = ScanOptions {
                table: TableOptions { missing, ..TableOptions::default() },
                key: by_name(&["s"]).pop(),
                keep_text,
                chunk_bytes: [40, 300, 1 << 18][case % 3],
                ..ScanOptions::default()
            };
            let (scanned, batches) = batches(source(&table), &columns, &options)?;
            let numbers: Vec<String> =
                batches.iter().flat_map(Batch::table_rows).map(|row| format!("{row:?}")).collect();
            Ok::<_, String>((texts(&batches).0, numbers, scanned.rows_missing))
        };
        let found = read(false);
        assert_eq!(found, read(true), "{table}");
        match found {
            Ok((keys, ..)) => rows += keys.len(),
            Err(_) => refused += 1,
        }
    }
    assert!(rows > 4000 && refused > 30, "{rows} {refused}");
}
