//! Sheets of workbooks: stored numbers in any notation, which sheet is read, and what is asked for in vain.

use std::io::{Cursor, Write};

use boundfit_exact::{DecimalMark, Thousands};
use boundfit_formats::{
    AskedBlock, ColumnSelector, CommentMark, Encoding, Header, InputError, MemoryNumbers, MemoryTable,
    MissingWords, SizeLimits, Source, TableNotes, TableOptions, open_reduction, read_table,
};
use boundfit_tests::workbooks::{archive, ods, ods_rows, ods_with, xlsx, xlsx_rows, xlsx_with};
use flate2::Compression;
use flate2::write::GzEncoder;
use ruzstd::encoding::{CompressionLevel, compress_to_vec};

/// The numbers of columns row by row and what is said of the table, or the message without the file's name.
type Read = Result<(Vec<Vec<String>>, Option<String>), String>;

fn read_from(source: Source, columns: &[&str], change: impl FnOnce(&mut TableOptions)) -> Read {
    let mut options = TableOptions::default();
    change(&mut options);
    let columns: Vec<ColumnSelector> =
        columns.iter().map(|column| ColumnSelector::name_or_number(column)).collect();
    let message = |error: InputError| error.to_string().strip_prefix("b: ").unwrap().to_owned();
    let table = read_table(source, &columns, &options).map_err(message)?;
    let numbers = table.rows.iter().map(|row| row.numbers.iter().map(ToString::to_string).collect());
    Ok((numbers.collect(), table.scanned.table.as_ref().and_then(TableNotes::words)))
}

fn read(bytes: &[u8], columns: &[&str], change: impl FnOnce(&mut TableOptions)) -> Read {
    read_from(Source::new("b", Cursor::new(bytes.to_vec())), columns, change)
}

/// The column y.
fn ys(bytes: &[u8], change: impl FnOnce(&mut TableOptions)) -> Result<Vec<String>, String> {
    read(bytes, &["y"], change).map(|(rows, _)| rows.concat())
}

/// Both kinds of workbooks of these rows, in whose texts a semicolon stands for a comma.
fn books(csv: &str) -> [Vec<u8>; 2] {
    [
        xlsx(&[("S", &xlsx_rows(csv, b'A', 1).replace(';', ","))]),
        ods(&[("S", &ods_rows(csv).replace(';', ","))]),
    ]
}

#[test]
fn stored_numbers_keep_their_value_in_every_notation() {
    let comma = |options: &mut TableOptions| options.dialect.decimal = Some(DecimalMark::Comma);
    let grouped = |mark| move |options: &mut TableOptions| options.dialect.thousands = Some(mark);
    for book in books("x,y\n1,8.5\n2,8;3\n3,7.25") {
        assert_eq!(ys(&book, comma).unwrap(), ["17/2", "83/10", "29/4"]);
        assert_eq!(ys(&book, grouped(Thousands::Point)).unwrap(), ["17/2", "83/10", "29/4"]);
        // Nothing but texts has a decimal mark.
        assert_eq!(ys(&book, |_| ()).unwrap(), ["17/2", "83/10", "29/4"]);
    }
    for book in books("x,y\n1,1;5\n2,3.1\n3,0;125") {
        assert_eq!(ys(&book, |_| ()).unwrap(), ["3/2", "31/10", "1/8"]);
    }
    // A comma that may group digits tells no mark.
    for book in books("x,y\n1,8.5\n2,1;234") {
        assert!(
            ys(&book, |_| ()).unwrap_err().starts_with("S!B3 (y): \"1,234\": a number with a decimal comma")
        );
    }
    for book in books("x,y\n1,1.234\n2,-1.5e-7\n3,2.5e300\n4,1.234;5") {
        let tiny = "-3/20000000";
        let huge = format!("25{}", "0".repeat(299));
        assert_eq!(ys(&book, grouped(Thousands::Point)).unwrap(), ["617/500", tiny, &huge, "2469/2"]);
    }
    for (text, mark) in [("1;234.5", Thousands::Comma), ("1'234.5", Thousands::Apostrophe)] {
        for book in books(&format!("x,y\n1,1234567.25\n2,{text}")) {
            assert_eq!(ys(&book, grouped(mark)).unwrap(), ["4938269/4", "2469/2"]);
        }
    }
    // Conditions and words for missing values are about the same numbers.
    for book in books("x,y\n0.5,1\n1.5,2\n2.5,-999.5\n3.5,4") {
        let some = |options: &mut TableOptions| {
            comma(options);
            options.missing = boundfit_formats::Missing::Skip;
            options.missing_as = MissingWords::new(["-999.5".to_owned()]);
        };
        assert_eq!(ys(&book, some).unwrap(), ["1", "2", "4"]);
    }
}

#[test]
fn what_is_asked_for_in_vain_is_refused() {
    let matrix = b"# name: x\n# type: matrix\n# rows: 2\n# columns: 2\n 1 2\n 2 3\n\n\n";
    let [xlsx, ods] = books("1,2\n2,3");
    let memory = || {
        let mut table = MemoryTable::default();
        table.push("x", MemoryNumbers::Doubles(vec![1.0, 2.0]));
        Source::of_table("b", table)
    };
    let mat = std::fs::read(boundfit_tests::program::root().join("fixtures/mat/transducer-v7.mat")).unwrap();
    let objects: &[u8] = br#"{"x": 1, "y": 2}"#;
    let arrays: &[u8] = br#"[["1", 2], [2, 3]]"#;
    /// Words for what is asked for, whether workbooks have it, and how it is asked for.
    type Asked = (&'static str, bool, &'static dyn Fn(&mut TableOptions));
    let has_no_effect: [Asked; 11] = [
        ("an encoding is", false, &|options| options.dialect.encoding = Some(Encoding::Iso8859Part1)),
        ("a delimiter is", false, &|options| options.dialect.delimiter = Some(b';')),
        ("a block is", true, &|options| options.block = Some(AskedBlock::All)),
        ("lines to skip are", true, &|options| options.dialect.skip_lines = 1),
        ("a row of units is", true, &|options| options.dialect.units_row = true),
        ("words for missing values are", true, &|options| {
            options.missing_as = MissingWords::new(["?!".to_owned()]);
        }),
        ("a decimal mark is", true, &|options| options.dialect.decimal = Some(DecimalMark::Comma)),
        ("a mark between digits is", true, &|options| options.dialect.thousands = Some(Thousands::Blank)),
        ("a mark of comments is", true, &|options| options.dialect.comment = CommentMark::None),
        ("a header is", true, &|options| options.header = Header::Present),
        ("no header is", true, &|options| options.header = Header::Absent),
    ];
    for (asked, fits_sheets, change) in has_no_effect {
        let words = if fits_sheets { "neither text nor a workbook" } else { "no text table" };
        let refusal = Err(format!("{asked} asked for, and this is {words}"));
        for bytes in [&mat, matrix.as_slice()] {
            assert_eq!(read(bytes, &["1"], change), refusal, "{asked}");
        }
        assert_eq!(read_from(memory(), &["1"], change), refusal, "{asked}");
        for book in [&xlsx, &ods] {
            let read = read(book, &["1"], change);
            assert_eq!(read == refusal, !fits_sheets, "{asked}: {read:?}");
        }
        let of_json = read(objects, &["x"], change);
        assert_eq!(of_json == refusal, asked != "an encoding is", "{asked}: {of_json:?}");
        let of_json = read(arrays, &["1"], change);
        let takes = ["an encoding is", "a header is", "no header is"].contains(&asked);
        assert_eq!(of_json == refusal, !takes, "{asked}: {of_json:?}");
        assert!(read(b"1;2\n2;3\n", &["1"], change) != refusal, "{asked}");
    }
}

#[test]
fn the_note_says_which_sheet_of_several_was_read() {
    let list = |state: &str| {
        format!(
            "<workbook xmlns:r=\"r\"><sheets><sheet name=\"Old\" {state} r:id=\"rId1\"/><sheet name=\"New\" r:id=\"rId2\"/></sheets></workbook>"
        )
    };
    let rows = [xlsx_rows("x,y\n1,2", b'A', 1), xlsx_rows("x,y\n1,3", b'A', 1)];
    let sheets = [("Old", rows[0].as_str()), ("New", &rows[1])];
    let table = |style: &str, name: &str, csv: &str| {
        format!(
            "<table:table table:style-name=\"{style}\" table:name=\"{name}\">{}</table:table>",
            ods_rows(csv)
        )
    };
    let ods_of = |style: &str| {
        let styles = "<style:style style:name=\"ta1\"><style:table-properties table:display=\"true\"/></style:style>\
            <style:style style:name=\"ta2\"><style:table-properties table:display=\"false\"/></style:style>";
        let [old, new] = [table(style, "Old", "x,y\n1,2"), table("ta1", "New", "x,y\n1,3")];
        ods_with(&format!("<d><s>{styles}</s>{old}{new}</d>"))
    };
    for (book, hidden) in [
        (xlsx_with(&sheets, "xl/workbook.xml", &list("")), ""),
        (xlsx_with(&sheets, "xl/workbook.xml", &list("state=\"hidden\"")), ", hidden"),
        (xlsx_with(&sheets, "xl/workbook.xml", &list("state=\"veryHidden\"")), ", hidden"),
        (ods_of("ta1"), ""),
        (ods_of("ta2"), ", hidden"),
    ] {
        let of = |sheet: Option<&str>| {
            let (rows, words) =
                read(&book, &["y"], |options| options.sheet = sheet.map(str::to_owned)).unwrap();
            (rows.concat().concat(), words.unwrap())
        };
        assert_eq!(of(None), ("2".to_owned(), format!("sheet 1 of 2 (\"Old\"{hidden})")));
        assert_eq!(of(Some("2")), ("3".to_owned(), "sheet 2 of 2 (\"New\")".to_owned()));
    }
    for book in books("x,y\n1,2") {
        assert_eq!(read(&book, &["y"], |_| ()).unwrap().1, None);
    }
}

#[test]
fn rows_and_columns_that_are_hidden_are_read_and_said() {
    let sheet = |before: &str, rows: &str, behind: &str| {
        let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
        let text =
            format!("<worksheet xmlns=\"{main}\">{before}<sheetData>{rows}</sheetData>{behind}</worksheet>");
        xlsx_with(&[("S", "")], "xl/worksheets/sheet1.xml", &text)
    };
    let csv = "x,y,z\n1,2,7\n3,4,7\n5,6,7";
    let plain = xlsx_rows(csv, b'A', 1);
    let hidden = plain.replace("<row r=\"3\">", "<row r=\"3\" hidden=\"1\">");
    // Rows and columns without cells are nothing that is read.
    let far = "<row r=\"9\" hidden=\"true\"></row>";
    let columns =
        "<cols><col min=\"3\" max=\"16384\" hidden=\"1\"/><col min=\"1\" max=\"2\" hidden=\"0\"/></cols>";
    let merged = "<mergeCells count=\"2\"><mergeCell ref=\"D1:E1\"/><mergeCell ref=\"D2:D4\"/></mergeCells>";
    let first = "the first cell alone";
    let of_ods = |rows: &str| ods(&[("S", rows)]);
    let rows = ods_rows(csv);
    let (one, rest) = rows.split_once("</table:table-row>").unwrap();
    let collapsed = |word: &str| {
        let rest =
            rest.replacen("<table:table-row", &format!("<table:table-row table:visibility=\"{word}\""), 1);
        of_ods(&format!("{one}</table:table-row>{rest}"))
    };
    let column = "<table:table-column table:number-columns-repeated=\"2\"/><table:table-column table:visibility=\"collapse\" table:number-columns-repeated=\"1022\"/>";
    let spanned =
        rows.replacen("<table:table-cell", "<table:table-cell table:number-columns-spanned=\"2\"", 1);
    for (book, words) in [
        (sheet("", &plain, ""), None),
        (sheet("", &format!("{hidden}{far}"), ""), Some("1 hidden row is read".to_owned())),
        (sheet(columns, &plain, ""), Some("1 hidden column is read".to_owned())),
        (sheet("", &plain, merged), Some(format!("2 areas of merged cells have their values in {first}"))),
        (collapsed("collapse"), Some("1 hidden row is read".to_owned())),
        (collapsed("filter"), Some("1 hidden row is read".to_owned())),
        (collapsed("visible"), None),
        (of_ods(&format!("{column}{rows}")), Some("1 hidden column is read".to_owned())),
        (of_ods(&spanned), Some(format!("1 area of merged cells has its value in {first}"))),
    ] {
        let (rows, said) = read(&book, &["y"], |_| ()).unwrap();
        assert_eq!((rows.concat(), said), (["2", "4", "6"].map(str::to_owned).to_vec(), words));
    }
}

#[test]
fn a_name_of_one_sheet_and_number_of_another_is_refused() {
    let rows = |y: u32| (xlsx_rows(&format!("x,y\n1,{y}"), b'A', 1), ods_rows(&format!("x,y\n1,{y}")));
    let [a, b, c] = [7, 8, 9].map(rows);
    for book in
        [xlsx(&[("2", &a.0), ("Run", &b.0), ("3", &c.0)]), ods(&[("2", &a.1), ("Run", &b.1), ("3", &c.1)])]
    {
        let of = |sheet: &str| ys(&book, |options| options.sheet = Some(sheet.to_owned()));
        let refusal = "\"2\" is the name of sheet 1 and the number of another one (expected '\"2\"', with the quotes, \
            for the name; for the number the name of that sheet)";
        assert_eq!(of("2"), Err(refusal.to_owned()));
        for (sheet, y) in [("\"2\"", "7"), ("'2'", "7"), ("1", "7"), ("Run", "8"), ("3", "9"), ("'3'", "9")] {
            assert_eq!(of(sheet), Ok(vec![y.to_owned()]), "{sheet}");
        }
    }
}

#[test]
fn an_empty_sheet_is_refused_with_the_others() {
    let full = [xlsx_rows("x,y\n1,2", b'A', 1), ods_rows("x,y\n1,2")];
    let rows = "(expected at least one row of numbers)";
    for (book, others) in [
        (xlsx(&[("A", ""), ("B", &full[0])]), "; the other one is \"B\""),
        (ods(&[("A", ""), ("B", &full[1]), ("C", "")]), "; the others are \"B\", \"C\""),
        (ods(&[("A", "")]), ""),
    ] {
        assert_eq!(ys(&book, |_| ()), Err(format!("A: the sheet is empty{others} {rows}")));
    }
}

#[test]
fn records_that_are_torn_are_refused_before_their_columns() {
    let wrong = |text: &[u8]| read(text, &["x", "y"], |_| ()).unwrap_err();
    assert_eq!(
        wrong(b"[{\"x\": 1,\n \"z\" 2}]"),
        "line 2: \"2}]\": read as JSON, where ':' belongs here (expected JSON with an object for each row, or a table \
         of text such as CSV)"
    );
    let ends = |line: u32, before: &str| {
        format!("line {line}: read as JSON, the file ends here, before {before} (expected a complete file)")
    };
    for (text, line, before) in [
        ("[{\"x\": 1, \"y\": 2},\n{\"x\": 2,", 2, "a text in quotes"),
        ("[{\"x\": 1, \"y\": 2},\n{\"x\": 2,\n\n", 4, "a text in quotes"),
        ("[{\"x\": 1, \"y\": 2}", 1, "',' or ']'"),
        ("[{\"x\": 1, \"y\"", 1, "':'"),
        ("{\"x\": 1, \"y\": [3", 1, "the end of an object or array"),
        ("[[1, 2],\n[3, \"4", 2, "the quote that ends a text"),
    ] {
        assert_eq!(read(text.as_bytes(), &["1", "2"], |_| ()).unwrap_err(), ends(line, before), "{text:?}");
    }
    let unknown = "there is no column \"y\" (expected one of \"x\", \"z\" or a number from 1 to 2)";
    assert_eq!(wrong(b"[{\"x\": 1, \"z\": 2},\n{\"x\" 2}]"), unknown);
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

#[test]
fn zeros_behind_gzip_are_passed_over() {
    let parts = [gzip(b"x,y\n1,2\n"), gzip(b"2,3\n")].concat();
    let expected = Ok(vec!["2".to_owned(), "3".to_owned()]);
    for zeros in [0, 1, 7, 512, 100_000] {
        let padded = [&parts[..], &vec![0; zeros]].concat();
        assert_eq!(ys(&padded, |_| ()), expected, "{zeros}");
        if zeros > 0 {
            let damaged = "line 4: cannot read a gzip file: it is damaged: bytes follow zeros behind its end";
            assert_eq!(ys(&[&padded[..], &parts].concat(), |_| ()), Err(damaged.to_owned()), "{zeros}");
        }
    }
    let damaged = "line 4: cannot read a gzip file: it is damaged: invalid gzip header";
    assert_eq!(ys(&[&parts[..], b"and more behind the end"].concat(), |_| ()), Err(damaged.to_owned()));
    let short = "line 4: cannot read a gzip file: it stops too soon";
    assert_eq!(ys(&parts[..parts.len() - 1], |_| ()), Err(short.to_owned()));
}

#[test]
fn long_content_of_zstandard_is_told_by_its_start() {
    let csv: String = (0..2000).map(|k| format!("{k},{}\n", k * k % 97)).collect();
    let csv = format!("x,y\n{csv}");
    let records: String = (0..2000).map(|k| format!("{{\"x\": {k}, \"y\": {}}}\n", k * k % 97)).collect();
    let column = |number: &dyn Fn(usize) -> usize| -> String {
        (0..2000).map(|k| format!(" {}\n", number(k))).collect()
    };
    let octave = [("x", column(&|k| k)), ("y", column(&|k| k * k % 97))].map(|(name, rows)| {
        format!("# name: {name}\n# type: matrix\n# rows: 2000\n# columns: 1\n{rows}\n\n")
    });
    let expected = ys(csv.as_bytes(), |_| ()).unwrap();
    for content in [
        csv.clone().into_bytes(),
        records.into_bytes(),
        octave.concat().into_bytes(),
        xlsx(&[("S", &xlsx_rows(&csv, b'A', 1))]),
        ods(&[("S", &ods_rows(&csv))]),
    ] {
        assert!(content.len() > 1 << 10);
        for packed in [compress_to_vec(&content[..], CompressionLevel::Fastest), gzip(&content)] {
            assert_eq!(ys(&packed, |_| ()).as_ref(), Ok(&expected));
        }
    }
}

#[test]
fn archives_without_a_table_are_named() {
    let header = |name: &str| {
        let mut header = name.as_bytes().to_vec();
        header.resize(100, 0);
        header.extend(b"0000644\x000001750\x000001750\x00");
        header.resize(512, 0);
        header
    };
    let tar = [header("data.csv"), b"x,y\n1,2\n".to_vec()].concat();
    let unpack = "this is a tar archive; unpack it and name the file that is in it";
    for bytes in [&tar, &gzip(&tar)] {
        assert_eq!(ys(bytes, |_| ()), Err(unpack.to_owned()));
        // Who looks for a reduction hands on the first bytes of other files by themselves.
        let source = Source::new("b", Cursor::new(bytes.clone()));
        let (source, _) = open_reduction(source, &SizeLimits::default()).unwrap();
        assert_eq!(read_from(source, &["y"], |_| ()), Err(unpack.to_owned()));
    }
    let empty = "this is an empty zip archive; there is no file in it to read";
    assert_eq!(ys(&archive(&[]), |_| ()), Err(empty.to_owned()));
}
