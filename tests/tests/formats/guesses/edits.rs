//! Edits of plain tables: the report names each edit that changes the answer.

use boundfit_tests::generate::seeded;
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

use super::{auto, read};

/// A plain table: its lines, without line ends.
fn plain(rng: &mut ChaCha8Rng) -> (Vec<String>, String) {
    let delimiter = [",", ";", "\t", " "].choose(rng).unwrap().to_string();
    let width = rng.random_range(2..=4);
    let number = |rng: &mut ChaCha8Rng| match rng.random_range(0..3) {
        0 => rng.random_range(-50..50).to_string(),
        _ => format!("{}.{}", rng.random_range(-50..50), rng.random_range(0..100)),
    };
    let names = ["x", "y", "t", "n"][..width].join(&delimiter);
    let rows = (0..rng.random_range(3..9))
        .map(|_| (0..width).map(|_| number(rng)).collect::<Vec<_>>().join(&delimiter));
    let lines = [names].into_iter().chain(rows).collect();
    (lines, delimiter)
}

/// One change that leaves the readings what they are, to whom looks at the table; or tells that they are something else.
fn edit(lines: &mut Vec<String>, delimiter: &str, rng: &mut ChaCha8Rng) {
    let at = rng.random_range(0..=lines.len());
    let row = rng.random_range(1..lines.len().max(2)).min(lines.len() - 1);
    match rng.random_range(0..15) {
        0 => {
            lines[0] = lines[0]
                .split(delimiter)
                .enumerate()
                .map(|(k, _)| (1960 + k).to_string())
                .collect::<Vec<_>>()
                .join(delimiter)
        }
        1 => lines.insert(
            0,
            lines[0]
                .split(delimiter)
                .enumerate()
                .map(|(k, _)| k.to_string())
                .collect::<Vec<_>>()
                .join(delimiter),
        ),
        2 => _ = lines.remove(0),
        3 => lines.insert(at, String::new()),
        4 => (0..2).for_each(|_| lines.insert(at, String::new())),
        5 => {
            lines.insert(at, ["# run 2", "% a note", "#", "# 1 2", "# 3,4"].choose(rng).unwrap().to_string())
        }
        6 => {
            lines[row] =
                lines[row].rsplit_once(delimiter).map_or_else(String::new, |(start, _)| start.to_owned())
        }
        7 => lines[row] += &format!("{delimiter}late"),
        8 => lines[row] += delimiter,
        9 => lines
            .splice(0..0, ["Device: X 7".to_owned(), "made, in haste; 3".to_owned(), String::new()])
            .for_each(drop),
        10 => lines.insert(at, lines[0].clone()),
        11 => {
            lines.iter_mut().enumerate().skip(1).for_each(|(k, line)| *line = format!("{k}{delimiter}{line}"))
        }
        12 => {
            lines[0] = format!("{delimiter}{}", lines[0].split_once(delimiter).map_or("", |(_, rest)| rest))
        }
        13 => lines.insert(0, format!("sep={delimiter}")),
        _ => lines.iter_mut().for_each(|line| {
            *line =
                line.split(delimiter).map(|cell| format!("\"{cell}\"")).collect::<Vec<_>>().join(delimiter)
        }),
    }
}

/// Changes 5,000 tables in one to three places: none is read with other numbers than the plain table, unless a report
/// mentions the format.
#[test]
fn no_edit_gives_another_answer_without_a_word() {
    let mut rng = seeded(0x6e55);
    let (mut same, mut said, mut refused) = (0, 0, 0);
    for number in 0..5000 {
        let (lines, delimiter) = plain(&mut rng);
        let columns = *[["x", "y"], ["1", "2"], ["x", "2"]].choose(&mut rng).unwrap();
        let text = |lines: &[String]| lines.join("\n") + "\n";
        let expected = read(text(&lines).as_bytes(), &columns, auto(), 1 << 18).unwrap().1;
        let mut edited = lines.clone();
        for _ in 0..rng.random_range(1..=3) {
            if !edited.is_empty() {
                edit(&mut edited, &delimiter, &mut rng);
            }
        }
        let text = text(&edited);
        let bytes: Vec<u8> = match rng.random_range(0..10) {
            0 => "\u{feff}"
                .chars()
                .chain(text.chars())
                .collect::<String>()
                .encode_utf16()
                .flat_map(u16::to_le_bytes)
                .collect(),
            1 => text.replace('x', "x\u{e4}").chars().map(|letter| letter as u8).collect(),
            2 => text.replace('\n', "\r\n").into_bytes(),
            _ => text.clone().into_bytes(),
        };
        let chunk_bytes = *[1, 16, 1 << 18].choose(&mut rng).unwrap();
        match read(&bytes, &columns, auto(), chunk_bytes) {
            Err(_) => refused += 1,
            Ok((_, rows, words)) if rows == expected => {
                same += 1;
                drop(words);
            }
            // Blanks between columns are said of every such table.
            Ok((_, rows, words)) => {
                let words = words.map(|words| words.replace("separated by blanks", "")).unwrap_or_default();
                assert!(!words.is_empty(), "case {number}, {columns:?}: {rows:?}, not {expected:?}\n{text}");
                said += 1;
            }
        }
    }
    assert!(same > 500 && said > 150 && refused > 500, "{same} the same, {said} said, {refused} refused");
}
