//! Generated tables, sound and unsound.

use boundfit_exact::{DecimalMark, Limits, Reading};
use boundfit_formats::{
    AskedBlock, AskedDialect, ColumnSelector, Header, Missing, RowCondition, RowRange, RowSet, ScanOptions,
    TableOptions,
};
use boundfit_tests::reference_table::detect;
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

/// A file and how it is to be read.
pub struct Case {
    pub bytes: Vec<u8>,
    pub columns: Vec<ColumnSelector>,
    pub options: ScanOptions,
}

/// Numbers as they are written, from plain to hardly readable.
const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "0.000",
    "1",
    "-1",
    "5.",
    "-.5",
    "+3",
    "1e3",
    "1.30e-2",
    "2E+3",
    "7/19",
    "-6/4",
    "00012.500",
    "123.4567",
    "-0.0012345",
    "12345678",
    "12345678.12345678",
    "1e300",
    "1e-300",
    "-1e-300",
    " 1.5",
    "1.5\t",
    " 7 ",
    "2305843009213693952",
    "-2305843009213693952",
    "4611686018427387904",
    "9223372036854775807",
    "-9223372036854775808",
    "9223372036854775808",
    "18446744073709551616",
    "1234567890123456789",
    "1234567890123456789012345",
    "0.1234567890123456789",
    "922337203685477.5807",
    "9007199254740993",
    "0.00000000000000000000000000000000000000001",
    "1.7976931348623157e308",
];
/// Cells that are no numbers, or too large ones.
const BAD: &[&str] = &[
    "",
    " ",
    "x",
    "n/a",
    "nan",
    "-inf",
    "1,5",
    "-2,25",
    "1_000",
    "1..2",
    "--1",
    "+-1",
    "1e",
    "1e99999",
    "1/0",
    "1 2",
    "\u{2212}1",
    "é",
    "1\u{0}",
    "1e400",
    "1\"2",
    "\u{feff}1",
];
/// Cells with commas, which need quotes where commas separate cells: decimals, and what may as well be grouped digits.
const COMMAS: &[&str] =
    &["1,5", "-2,25", "0,125", "1234,5", "+3,5e1", "1,234", "-12,345 ", "1,234e2", "1,234,567", ",5", "7,"];
/// Text of a column that is not read, or is the key.
const TEXT: &[&str] =
    &["s1", "s2", " s 3 ", "Ä", "", "\"q\"", "\"a\"\"b\"", "\"a,b;c\td\"", "\"a\nb\"", "\"\r\n\"", "o\"o"];

/// A table of a few rows, in which much may be wrong.
pub fn case(rng: &mut ChaCha8Rng) -> Case {
    let delimiter = *[",", ",", ";", "\t"].choose(rng).unwrap();
    let line_end = *["\n", "\n", "\r\n", "\r"].choose(rng).unwrap();
    let width = rng.random_range(1..=4);
    let text_column = rng.random_bool(0.3).then(|| rng.random_range(1..=width));
    // Most tables have one kind of oddity, if any.
    let chance = |rng: &mut ChaCha8Rng, share: f64| if rng.random_bool(share) { 0.15 } else { 0.0 };
    let [bad, blank, ragged, quoted, mixed_ends] = [0.15, 0.3, 0.1, 0.2, 0.1].map(|share| chance(rng, share));
    let plain = rng.random_bool(0.4);
    let commas = if rng.random_bool(0.15) { *[0.1, 0.6].choose(rng).unwrap() } else { 0.0 };
    let header = rng.random_bool(0.6);
    let mut text = String::new();
    // The second of two byte order marks is the library's.
    text.push_str(if rng.random_bool(0.2) {
        ["\u{feff}", "\u{feff}\u{feff}"].choose(rng).unwrap()
    } else {
        ""
    });
    for row in 0..rng.random_range(0..12) {
        if rng.random_bool(blank) {
            text.push_str(["", "  ", "\t", "\u{c}"].choose(rng).unwrap());
            text.push_str(line_end);
        }
        let width = if rng.random_bool(ragged) { rng.random_range(1..=4) } else { width };
        let cells: Vec<String> = (1..=width)
            .map(|column| {
                if header && row == 0 {
                    return ["a", "b", "\"c\"", " d ", "b"]
                        [if rng.random_bool(0.05) { 4 } else { column - 1 }]
                    .into();
                }
                if text_column != Some(column) && rng.random_bool(commas) {
                    let cell = COMMAS.choose(rng).unwrap();
                    return if delimiter == "," { format!("\"{cell}\"") } else { (*cell).into() };
                }
                let cell = if rng.random_bool(bad) {
                    BAD.choose(rng).unwrap()
                } else if text_column == Some(column) {
                    TEXT.choose(rng).unwrap()
                } else if plain {
                    return format!("{}.{}", rng.random_range(-99..99), rng.random_range(0..9999));
                } else {
                    NUMBERS.choose(rng).unwrap()
                };
                if rng.random_bool(quoted) && !cell.contains('"') {
                    format!("\"{cell}\"")
                } else {
                    (*cell).into()
                }
            })
            .collect();
        text.push_str(&cells.join(delimiter));
        text.push_str(if rng.random_bool(mixed_ends) {
            ["\r", "\n", "\r\n", "\r\r\n"].choose(rng).unwrap()
        } else {
            line_end
        });
    }
    let mut bytes = text.into_bytes();
    if rng.random_bool(0.3) {
        bytes.truncate(rng.random_range(0..=bytes.len()));
    }
    if rng.random_bool(0.05) && !bytes.is_empty() {
        let at = rng.random_range(0..bytes.len());
        bytes[at] = *[0xff, b'"', b'\n', b'\r', 0, b','].choose(rng).unwrap();
    }
    let columns = if rng.random_bool(0.2) { any_columns(rng) } else { columns_of(rng, width, text_column) };
    let mut options = options(rng, plain);
    let dialect = &mut options.table.dialect;
    // Fields separated by blanks are another matter.
    if detect(bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&bytes)).is_none() {
        dialect.delimiter = dialect.delimiter.or(Some(b','));
    }
    Case { bytes, columns, options }
}

/// Columns by number, none of them text.
fn columns_of(rng: &mut ChaCha8Rng, width: usize, text_column: Option<usize>) -> Vec<ColumnSelector> {
    let numbers: Vec<usize> = (1..=width).filter(|column| Some(*column) != text_column).collect();
    let count = rng.random_range(1..=3);
    // Nothing is asked for twice, but for a few.
    let chosen: Vec<usize> = match rng.random_bool(0.05) {
        true => (0..count).filter_map(|_| numbers.choose(rng).copied()).collect(),
        false => numbers.sample(rng, count).copied().collect(),
    };
    if chosen.is_empty() {
        return any_columns(rng);
    }
    chosen.into_iter().map(|number| ColumnSelector::name_or_number(&number.to_string())).collect()
}

/// Columns by number or name, which there may not be.
fn any_columns(rng: &mut ChaCha8Rng) -> Vec<ColumnSelector> {
    let column = |rng: &mut ChaCha8Rng| {
        let names = ["1", "2", "2", "3", "4", "a", "b", "c", "d"];
        let selector = ColumnSelector::name_or_number(names.choose(rng).unwrap());
        if rng.random_bool(0.1) { selector.non_negative() } else { selector }
    };
    (0..rng.random_range(1..=3)).map(|_| column(rng)).collect()
}

/// Some ranges, without others, or all rows where none would be left.
fn row_set(rng: &mut ChaCha8Rng) -> RowSet {
    let range = |rng: &mut ChaCha8Rng| {
        let first = rng.random_range(1..6);
        let last = first + rng.random_range(0..5);
        let range = if rng.random_bool(0.2) { RowRange::from_row(first) } else { RowRange::new(first, last) };
        range.unwrap()
    };
    let ranges = |rng: &mut ChaCha8Rng, most: usize| -> Vec<RowRange> {
        (0..rng.random_range(0..=most)).map(|_| range(rng)).collect()
    };
    RowSet::new(&ranges(rng, 3), &ranges(rng, 2)).unwrap_or_default()
}

/// Comparisons of columns, asked for or not, with numbers that are among their cells.
fn any_conditions(rng: &mut ChaCha8Rng) -> Vec<RowCondition> {
    let condition = |rng: &mut ChaCha8Rng| {
        let column = ["1", "2", "3", "a", "\"b\"", "c"].choose(rng).unwrap();
        let comparison = ["<", "<=", "=", "!=", ">=", ">"].choose(rng).unwrap();
        let number = ["0", "1", "1.5", "-2", "1/3"].choose(rng).unwrap();
        let text = format!("{column} {comparison} {number}");
        RowCondition::parse(&text, Reading::Decimal, &Limits::default()).unwrap()
    };
    (0..rng.random_range(1..=2)).map(|_| condition(rng)).collect()
}

fn options(rng: &mut ChaCha8Rng, plain: bool) -> ScanOptions {
    let rows = if rng.random_bool(0.3) { row_set(rng) } else { RowSet::default() };
    let conditions = if rng.random_bool(0.3) { any_conditions(rng) } else { Vec::new() };
    let unusual = rng.random_bool(0.15);
    let limits = if unusual && !plain { Limits { digits: 5, exponent: 10 } } else { Limits::default() };
    let table = TableOptions {
        header: if unusual { *[Header::Present, Header::Absent].choose(rng).unwrap() } else { Header::Auto },
        dialect: AskedDialect {
            delimiter: [b',', b';', b':', b'0', b'\n', b'"'].choose(rng).copied().filter(|_| unusual),
            decimal: DecimalMark::ALL.choose(rng).copied().filter(|_| unusual),
            ..AskedDialect::default()
        },
        // The reference knows of no blocks.
        block: Some(AskedBlock::All),
        missing: if rng.random_bool(0.3) { Missing::Skip } else { Missing::Refuse },
        rows,
        conditions,
        keep_others: rng.random_bool(0.5),
        reading: if rng.random_bool(0.25) { Reading::Binary64 } else { Reading::Decimal },
        limits,
        ..TableOptions::default()
    };
    ScanOptions { table, ..ScanOptions::default() }
}
