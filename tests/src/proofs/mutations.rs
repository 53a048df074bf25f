//! Proofs and data with changes of every kind, for what must treat all of them alike.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use serde_json::Value;

use super::sha256;
use super::tampering::{collect, replacements};

/// Other ways to write what stands for an index or a flag.
const INDICES: &[&str] = &[
    "0",
    "1",
    "2",
    "00",
    "01",
    "-0",
    "-1",
    "+1",
    "0.0",
    "1.0",
    "1e0",
    "1E0",
    "true",
    "false",
    "null",
    "\"0\"",
    "[]",
    "9007199254740993",
    "18446744073709551615",
    "18446744073709551616",
    "1e400",
    "NaN",
    "Infinity",
    "0x1",
    "[0]",
];

/// Other things that could be taken for a number of a proof.
const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "1",
    "-1",
    "2/2",
    "0/7",
    "1/0",
    "0.5",
    ".5",
    "5.",
    "1e1",
    "2e-1",
    "1e1000000",
    "+1",
    " 1",
    "1 ",
    "01",
    "1/02",
    "\u{2212}1",
    "1_000",
    "1/-1",
    "--1",
    "",
    "x",
    "\u{661}",
    "\u{ff11}",
    "1\\n",
    "\\u0031",
    "nan",
    "1d0",
    "1/2/3",
];

/// Names of half-planes and what is nearly one.
const NAMES: &[&str] = &[
    "1 upper",
    "1 lower",
    "2 upper",
    "3 lower",
    "where:1",
    "where:1 upper",
    "where:1 lower",
    "where:2",
    "01 upper",
    "1  upper",
    " 1 upper",
    "1 Upper",
    "+1 upper",
    "1\\tupper",
    "\\u0031 upper",
    "0 upper",
    "where:0",
    "where:01",
    "1",
    "upper",
    "",
    "\\u001b[1A\\rverified",
    "\\ud800",
    "\\ud83d\\ude00",
    "\u{202e}1 upper",
    "99999999999999999999 upper",
];

/// Pieces of JSON and of what is none.
const PIECES: &[&[u8]] = &[
    b"\xef\xbb\xbf",
    b"\xff",
    b"\xc3",
    b"\0",
    b"\x01",
    b"\x7f",
    b"\"",
    b"\\",
    b"\\u0000",
    b"\\ud800",
    b"{",
    b"}",
    b"[",
    b"]",
    b",",
    b":",
    b" ",
    b"\n",
    b"\r",
    b"\t",
    b"\x0b",
    b"\x0c",
    b"\xc2\xa0",
    b"//",
    b"/**/",
    b"null",
    b"true",
    b"-",
    b"0",
    b"1e5",
    b".5",
    b"\"more\": 1,",
    b"\"header\": true,",
    b"\"rows\": [1, 1],",
    b"\"law\": null,",
    b"\"interval\": null,",
    b"\"x_origin\": \"0\",",
    b"\"x_origin\": null,",
    b"\"interval\": [1, null],",
    b"\"law\": [[], []],",
    b"\"law\": [[[\"abs\", 1, \"1/9\"]], [[\"written\", 2, \"1\"]]],",
];

/// Cells that are hard to read.
const CELLS: &[&[u8]] = &[
    b"0",
    b"-0",
    b"1",
    b"+1",
    b"1.",
    b".5",
    b"1.50",
    b"1e2",
    b"1E+2",
    b"1e-2",
    b"1d1",
    b"1D-1",
    b"1e",
    b"1/3",
    b"-2/6",
    b"0/5",
    b"1/0",
    b"03/4",
    b"3/04",
    b"1/2/3",
    b"1/-2",
    b"1.5/2",
    b".",
    b"-",
    b"--",
    b"?",
    b"NA",
    b"n/a",
    b"#N/A",
    b"NaN",
    b"null",
    b"NONE",
    b"none ",
    b"",
    b" ",
    b"\t",
    b"\x0b",
    b"\x0b1",
    b"\x0c1 ",
    b"\xc2\xa01",
    b"\xe2\x80\x871",
    b"\xe2\x80\x831",
    b"\xe3\x80\x80",
    b"\xe2\x88\x921",
    b"1e\xe2\x88\x922",
    b"\xd9\xa1",
    b"\xc3\xa9",
    b"\xe9",
    b"\xff",
    b"\0",
    b"1\0",
    b"inf",
    b"1_0",
    b"1,5",
    b"1;5",
    b"1|5",
    b"\"1\"",
    b"\"1",
    b"1\"",
    b"\"1\"2",
    b"\"1\"\"\"",
    b"\" 1 \"",
    b"\"1\n\"",
    b"\"\r\n\"",
    b"\"a,b\"",
    b"1e10000",
    b"1e10001",
    b"1e-10001",
    b"1e00000000000000000001",
    b"1e99999999999999999999",
    b".e99999",
    b"1e99999x",
    b"1e+-5",
    b"+-1",
    b"\xef\xbb\xbf1",
    b"0x10",
    b"12345678901234567890",
    b"0.1234567890123456789",
    b"1e400",
    b"1e-400",
    b"9e307",
    b"-179769313486231580793728971405303415e274",
];

/// A proof and its data, as bytes, with some changes; the hash of the data is mended more often than not.
pub fn mutated(proof: &str, data: &[u8], rng: &mut ChaCha8Rng) -> (Vec<u8>, Vec<u8>) {
    let mut data = data.to_vec();
    let mut value: Value = serde_json::from_str(proof).expect("a proof");
    let changes = rng.random_range(1..=3);
    let mut bytes_changes = 0;
    for _ in 0..changes {
        match rng.random_range(0..10) {
            0..4 => change_value(&mut value, rng),
            4..7 => change_data(&mut data, &mut value, rng),
            _ => bytes_changes += 1,
        }
    }
    if value.is_object() && rng.random_bool(0.95) {
        value["sha256"] = sha256(&data).into();
    }
    let text = if rng.random_bool(0.5) {
        value.to_string()
    } else {
        serde_json::to_string_pretty(&value).expect("JSON")
    };
    let mut bytes = text.into_bytes();
    (0..bytes_changes).for_each(|_| change_bytes(&mut bytes, rng));
    (bytes, data)
}

fn pick<'a, T: ?Sized>(from: &[&'a T], rng: &mut ChaCha8Rng) -> &'a T {
    from[rng.random_range(0..from.len())]
}

/// Changes one value for another of its kind, as it may stand in a proof.
fn change_value(value: &mut Value, rng: &mut ChaCha8Rng) {
    let mut places = Vec::new();
    collect(value, String::new(), &mut places);
    let place = &places[rng.random_range(0..places.len())];
    let Some(old) = value.pointer_mut(place) else { return };
    let all = replacements(old);
    if !all.is_empty() {
        *old = all[rng.random_range(0..all.len())].clone();
    }
}

/// Changes bytes of the data, or how the proof says that they are read.
fn change_data(data: &mut Vec<u8>, value: &mut Value, rng: &mut ChaCha8Rng) {
    let at = |data: &Vec<u8>, rng: &mut ChaCha8Rng| rng.random_range(0..=data.len());
    match rng.random_range(0..12) {
        0..6 => {
            // Another cell.
            let is_end = |byte: &u8| matches!(byte, b',' | b';' | b'\t' | b'\n' | b'\r');
            let from = at(data, rng);
            let start = data[..from].iter().rposition(is_end).map_or(0, |end| end + 1);
            let length = data[start..].iter().position(is_end).unwrap_or(data.len() - start);
            let cell = match rng.random_range(0..200) {
                0 => vec![b'7'; 10_001],
                1 => [b"0.", "7".repeat(10_000).as_bytes()].concat(),
                _ => pick(CELLS, rng).to_vec(),
            };
            data.splice(start..start + length, cell);
        }
        6 => {
            let delimiter = pick(&[",", ";", "\t", "|", " ", "e", "\"", "\n", "é", "\0", ",,", ""], rng);
            if value.is_object() {
                value["delimiter"] = delimiter.into();
            }
            if let (Some(&byte), true) = (delimiter.as_bytes().first(), rng.random_bool(0.7)) {
                data.iter_mut().filter(|own| **own == b',').for_each(|own| *own = byte);
            }
        }
        7 => {
            let piece = pick(
                &[&b"\n"[..], b"\r", b"\r\n", b"\n \n", b"\"", b",", b"\xef\xbb\xbf", b"\"\"\n", b" "],
                rng,
            );
            let place = if rng.random_bool(0.3) { 0 } else { at(data, rng) };
            data.splice(place..place, piece.iter().copied());
        }
        8 => {
            let text = String::from_utf8_lossy(data).replace('\n', pick(&["\r", "\r\n", "\n\n"], rng));
            *data = text.into_bytes();
        }
        9 => {
            let place = at(data, rng);
            data.truncate(place);
        }
        _ => {
            let place = at(data, rng);
            data.iter_mut().skip(place).take(1).for_each(|byte| *byte ^= 1 << rng.random_range(0..8));
        }
    }
}

/// Changes the text of a proof, which may be none any more.
fn change_bytes(bytes: &mut Vec<u8>, rng: &mut ChaCha8Rng) {
    let place = rng.random_range(0..=bytes.len());
    match rng.random_range(0..16) {
        0..3 => bytes.iter_mut().skip(place).take(1).for_each(|byte| *byte ^= 1 << rng.random_range(0..8)),
        3 => {
            bytes.splice(place..place, pick(PIECES, rng).iter().copied());
        }
        4..6 => {
            // Behind the brace: a field more, or twice.
            bytes.splice(1.min(bytes.len())..1.min(bytes.len()), pick(PIECES, rng).iter().copied());
        }
        6..9 => replace_token(
            bytes,
            place,
            |byte| byte.is_ascii_digit() || b"-.eE".contains(&byte),
            pick(INDICES, rng),
        ),
        9..11 => replace_text(bytes, place, pick(NUMBERS, rng)),
        11..13 => replace_text(bytes, place, pick(NAMES, rng)),
        13 => {
            let depth = pick(&[&3_usize, &7, &60, &130, &3000], rng);
            let nested = format!("{}{}", "[".repeat(*depth), "]".repeat(*depth));
            replace_token(bytes, place, |byte| byte.is_ascii_digit(), &nested);
        }
        14 => repeat_field(bytes, rng),
        _ => match rng.random_range(0..6) {
            0 => bytes.truncate(place),
            1 => drop(bytes.splice(0..0, *b"\xef\xbb\xbf")),
            2 => *bytes = String::from_utf8_lossy(bytes).encode_utf16().flat_map(u16::to_le_bytes).collect(),
            3 => {
                let values: Option<Vec<Value>> = serde_json::from_slice::<Value>(bytes)
                    .ok()
                    .and_then(|value| value.as_object().map(|fields| fields.values().cloned().collect()));
                *bytes = values.map_or_else(Vec::new, |values| Value::from(values).to_string().into_bytes());
            }
            4 => bytes.extend_from_slice(b"{}"),
            _ => bytes.extend_from_slice(b" \n\t\r"),
        },
    }
}

/// Replaces the bytes of a kind at or behind a place.
fn replace_token(bytes: &mut Vec<u8>, place: usize, is_own: impl Fn(u8) -> bool, by: &str) {
    let Some(start) = bytes[place..].iter().position(|&byte| is_own(byte)).map(|more| place + more) else {
        return;
    };
    let length = bytes[start..].iter().take_while(|&&byte| is_own(byte)).count();
    bytes.splice(start..start + length, by.bytes());
}

/// Replaces a text behind a place.
fn replace_text(bytes: &mut Vec<u8>, place: usize, by: &str) {
    let quotes: Vec<usize> = (place..bytes.len()).filter(|&at| bytes[at] == b'"').take(3).collect();
    if let &[first, second, third] = quotes.as_slice() {
        // One of the two is within a text, and the other between texts.
        let is_between = bytes[first + 1..second].iter().any(|byte| b",:[]".contains(byte));
        let (start, end) = if is_between { (second, third) } else { (first, second) };
        bytes.splice(start + 1..end, by.bytes());
    }
}

/// Repeats a field, with the value that it has or an empty list.
fn repeat_field(bytes: &mut Vec<u8>, rng: &mut ChaCha8Rng) {
    let Ok(Value::Object(fields)) = serde_json::from_slice(bytes) else { return };
    let index = rng.random_range(0..fields.len().max(1));
    let Some((name, value)) = fields.iter().nth(index) else { return };
    let value = if rng.random_bool(0.5) { value.to_string() } else { "[]".to_owned() };
    let field = format!("\"{name}\": {value},");
    bytes.splice(1..1, field.bytes());
}
