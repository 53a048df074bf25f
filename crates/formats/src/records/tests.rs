//! Tests of records.

use super::*;

/// The records of a text that comes in pieces of so many bytes, each with its line.
fn records(
    text: &[u8],
    delimiter: u8,
    size: usize,
    longest: usize,
) -> Result<Vec<(u64, Vec<String>)>, InputError> {
    let syntax = Syntax { delimiter, comment: Some([b'#'; 2]) };
    let sizes = SizeLimits { line: longest, ..SizeLimits::default() };
    let mut records = Records::new("test", syntax, 1, &sizes, false);
    let mut found = Vec::new();
    let mut add = |records: &Records| {
        let cells = records.record().cells().map(|cell| String::from_utf8_lossy(cell).into_owned());
        found.push((records.record_line(), cells.collect()));
    };
    for mut piece in text.chunks(size) {
        while records.next(&mut piece)? {
            add(&records);
        }
    }
    if records.finish() {
        add(&records);
    }
    Ok(found)
}

#[test]
fn records_have_their_cells_and_lines_however_small_the_pieces_are() {
    let text = b"a,b\n\"c\nd\"\r\n\"e\"\"\"\rf,\n\n \r\n#\"\n\ng\n#end";
    let expected =
        [(1, vec!["a", "b"]), (2, vec!["c\nd"]), (4, vec!["e\""]), (5, vec!["f", ""]), (10, vec!["g"])];
    let expected = expected.map(|(line, cells)| (line, cells.into_iter().map(str::to_owned).collect()));
    for size in 1..=text.len() {
        assert_eq!(records(text, b',', size, 100).unwrap(), expected, "in pieces of {size} bytes");
    }
}

#[test]
fn whole_lines_give_the_records_that_single_bytes_give() {
    // A piece of one byte is no line, so that the library reads all of it.
    let mut state = 1_u64;
    let mut next = |below: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    };
    for _ in 0..20_000 {
        let length = next(24);
        let text: Vec<u8> = (0..length).map(|_| b"a1,,;\n\n\r\" #\t\xef"[next(12) as usize]).collect();
        for delimiter in [b',', b';', b'\t'] {
            let by_bytes = records(&text, delimiter, 1, 100).unwrap();
            for size in [2, 5, 24] {
                let in_pieces = records(&text, delimiter, size, 100).unwrap();
                assert_eq!(in_pieces, by_bytes, "{} in pieces of {size}", text.escape_ascii());
            }
        }
    }
}

#[test]
fn runs_of_blanks_separate_cells_but_not_within_quotes() {
    let text = b"  a\t b \r\n \t\n\"c d\" \"e\"\"\nf\"\n#c\r\"\"  1\"2 \"g\"h";
    let expected = [(1, vec!["a", "b"]), (3, vec!["c d", "e\"\nf"]), (6, vec!["", "1\"2", "gh"])];
    let expected = expected.map(|(line, cells)| (line, cells.into_iter().map(str::to_owned).collect()));
    for size in 1..=text.len() {
        assert_eq!(records(text, b' ', size, 100).unwrap(), expected, "in pieces of {size} bytes");
    }
}

#[test]
fn an_endless_record_stops() {
    let text = [&b"\n\na\n"[..], b"\"", &[b'x'; 1000], b"\n", &[b'x'; 1000]].concat();
    for size in [1, 7, 64] {
        let error = records(&text, b',', size, 1500).unwrap_err();
        assert_eq!(error.place.line, Some(4));
        assert!(matches!(error.kind, InputErrorKind::RowTooLong { limit: 1500 }));
    }
    assert_eq!(records(&text, b',', 64, 2002).unwrap().len(), 2);
}
