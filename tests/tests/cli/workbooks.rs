//! Sheets of .xlsx and .ods workbooks give the answers of the same tables as text.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use boundfit_tests::cli::{boundfit, boundfit_with_input, directory_with, fixture, printed, report};
use boundfit_tests::workbooks::{archive, ods, ods_rows, ods_with, xlsx, xlsx_rows};

const FIT: &str = "--x Vz --y z --rows 14..36 --eps 0.5e-3";

/// A report without what says which bytes were read.
fn answer(directory: &Path, line: &str) -> Value {
    let mut report = report(directory, line, b"");
    for key in ["sha256", "file", "name", "table"] {
        report["input"].as_object_mut().unwrap().remove(key);
    }
    report
}

#[test]
fn a_sheet_is_the_table_that_it_shows() {
    let csv = fixture("transducer/transducer.csv");
    let directory = directory_with(&[
        ("data.csv", csv.as_bytes()),
        ("data.xlsx", &xlsx(&[("Data", &xlsx_rows(&csv, b'A', 1))])),
        ("moved.xlsx", &xlsx(&[("Data", &xlsx_rows(&csv, b'C', 7))])),
        (
            "second.xlsx",
            &xlsx(&[("Notes", &xlsx_rows("a\nb", b'A', 1)), ("Data", &xlsx_rows(&csv, b'A', 1))]),
        ),
        ("data.ods", &ods(&[("Data", &ods_rows(&csv))])),
        ("second.ods", &ods(&[("Notes", &ods_rows("a\nb")), ("Data", &ods_rows(&csv))])),
    ]);
    for reading in ["decimal", "binary64"] {
        let expected = answer(directory.path(), &format!("fit data.csv {FIT} --reading {reading}"));
        for file in [
            "data.xlsx",
            "moved.xlsx",
            "data.xlsx --sheet Data",
            "data.xlsx --sheet 1",
            "second.xlsx --sheet Data",
            "second.xlsx --sheet 2",
            "data.ods",
            "second.ods --sheet 2",
            "second.ods --sheet Data",
        ] {
            assert_eq!(
                answer(directory.path(), &format!("fit {file} {FIT} --reading {reading}")),
                expected,
                "{file}"
            );
        }
    }
    let bytes = fs::read(directory.path().join("data.xlsx")).unwrap();
    let by_name = printed(directory.path(), &format!("fit data.xlsx {FIT}"));
    let run = boundfit_with_input(directory.path(), &format!("fit - {FIT}"), &bytes);
    assert_eq!(run.stdout.replace("standard input", "data.xlsx"), by_name);
}

#[test]
fn numbers_are_doubles_and_their_shortest_text() {
    let rows = "<row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>x</t></is></c><c r=\"B1\" t=\"inlineStr\"><is><t>y</t></is></c></row>\
        <row r=\"2\"><c r=\"A2\"><v>0.10000000000000001</v></c><c r=\"B2\"><v>1E-10</v></c></row>\
        <row r=\"3\"><c r=\"A3\"><v>2.2999999999999998</v></c><c r=\"B3\" t=\"inlineStr\"><is><t>7/19</t></is></c></row>";
    let directory = directory_with(&[
        ("data.xlsx", &xlsx(&[("Sheet1", rows)])),
        ("data.csv", b"x,y\n0.1,0.0000000001\n2.3,7/19\n"),
    ]);
    for reading in ["decimal", "binary64"] {
        let fit = |file: &str| {
            answer(directory.path(), &format!("fit {file} --x x --y y --eps 1 --reading {reading}"))
        };
        assert_eq!(fit("data.xlsx"), fit("data.csv"), "{reading}");
    }
}

/// Checks the message on a workbook.
fn refused(bytes: &[u8], options: &str, message: &str) {
    let directory = directory_with(&[("b.xlsx", bytes)]);
    let run = boundfit(directory.path(), &format!("fit b.xlsx {options}"));
    assert_eq!((run.status, run.stdout.as_str(), run.stderr), (1, "", format!("error: b.xlsx{message}\n")));
}

const XY: &str = "--x x --y y --eps 1";

#[test]
fn errors_name_sheet_and_cell() {
    let number = "not a number: unexpected character 'a' at character 1 (expected a decimal such as 1.30e-2 or a fraction such as 7/19)";
    let csv = "x,y\n1,2\n3,abc";
    for book in [xlsx(&[("Run 1", &xlsx_rows(csv, b'A', 1))]), ods(&[("Run 1", &ods_rows(csv))])] {
        refused(&book, XY, &format!(": Run 1!B3 (y): \"abc\": {number}"));
        let directory = directory_with(&[("b.xlsx", &book)]);
        let run = boundfit(directory.path(), "fit b.xlsx --x t --y y --eps 1");
        let unknown = "error: b.xlsx: Run 1, row 1: there is no column \"t\" (expected one of \"x\", \"y\"";
        assert!(run.status == 1 && run.stderr.starts_with(unknown), "{}", run.stderr);
    }
    let moved = xlsx(&[("S", &xlsx_rows(csv, b'Y', 5))]);
    refused(&moved, XY, &format!(": S!Z7 (y): \"abc\": {number}"));
}

#[test]
fn dates_are_refused_by_a_sentence() {
    let time = "a date or a time, not a number (expected a number: give the cells the format of one, or add a column of seconds or days)";
    let rows = xlsx_rows("x,y\n1,2", b'A', 1)
        + "<row r=\"3\"><c r=\"A3\" s=\"1\"><v>45000</v></c><c r=\"B3\"><v>3</v></c></row>";
    refused(&xlsx(&[("S", &rows)]), XY, &format!(": S!A3 (x): \"2023-03-15\": {time}"));
    let rows = ods_rows("x,y\n1,2")
        + "<table:table-row><table:table-cell office:value-type=\"date\" office:date-value=\"2023-03-15\"/><table:table-cell office:value-type=\"float\" office:value=\"3\"/></table:table-row>";
    refused(&ods(&[("S", &rows)]), XY, &format!(": S!A3 (x): \"2023-03-15\": {time}"));
}

#[test]
fn sheets_that_are_not_there() {
    let book = xlsx(&[("First", ""), ("Second", "")]);
    let expected = "(expected one of \"First\", \"Second\" or a number from 1 to 2)";
    for wanted in ["first", "0", "3", "Third"] {
        refused(
            &book,
            &format!("{XY} --sheet {wanted}"),
            &format!(": there is no sheet \"{wanted}\" {expected}"),
        );
    }
    refused(
        &book,
        XY,
        ": First: the sheet is empty; the other one is \"Second\" (expected at least one row of numbers); --sheet N|NAME \
         chooses one",
    );
    refused(
        b"x,y\n1,2\n",
        &format!("{XY} --sheet 1"),
        ": a sheet is asked for, and this is no workbook (.xlsx, .ods)",
    );
}

#[test]
fn a_sheet_that_nobody_chose_is_a_guess() {
    let rows = [xlsx_rows("x,y\n1,2\n2,3", b'A', 1), xlsx_rows("a", b'A', 1)];
    let directory = directory_with(&[("b.xlsx", &xlsx(&[("Data", &rows[0]), ("Notes", &rows[1])]))]);
    let line = "fit b.xlsx --x x --y y --eps 1 --format csv";
    let [guessed, chosen] =
        ["", " --sheet 1"].map(|sheet| boundfit(directory.path(), &format!("{line}{sheet}")));
    assert_eq!(guessed.stderr, "note: b.xlsx: sheet 1 of 2 (\"Data\")\n");
    assert_eq!((chosen.stderr.as_str(), chosen.stdout), ("", guessed.stdout));
    let report = printed(directory.path(), "fit b.xlsx --x x --y y --eps 1 --sheet Data");
    assert!(report.contains("\n  table    sheet 1 of 2 (\"Data\")\n"), "{report}");
}

#[test]
fn json_says_what_a_spreadsheet_shows_otherwise() {
    let plain = xlsx_rows("x,y\n1,2\n2,3", b'A', 1);
    let hidden = plain.replace("<row r=\"3\">", "<row r=\"3\" hidden=\"1\">");
    let directory = directory_with(&[
        ("one.xlsx", &xlsx(&[("Data", &hidden)])),
        ("two.xlsx", &xlsx(&[("Notes", ""), ("Data", &plain)])),
        ("blocks.csv", b"x,y\n1,2\n\n\nx,y\n2,3\n"),
    ]);
    let table = |line: &str| {
        let line = format!("fit {line} --x x --y y --eps 1");
        report(directory.path(), &line, b"")["input"]["table"].clone()
    };
    let sheet = |name: Option<&str>, number: u64, total: u64, hidden_rows: u64| {
        json!({"name": name, "number": number, "total": total, "hidden": false,
            "hidden_rows": hidden_rows, "hidden_columns": 0, "merged": 0})
    };
    assert_eq!(table("one.xlsx")["sheet"], sheet(None, 1, 1, 1));
    assert_eq!(table("two.xlsx --sheet Data")["sheet"], sheet(Some("Data"), 2, 2, 0));
    let blocks = table("blocks.csv --block all");
    assert_eq!((blocks.get("sheet"), &blocks["skipped"]["headers"]), (None, &json!(1)));
}

#[test]
fn other_archives_are_named() {
    for (files, message) in [
        (&["word/document.xml"][..], "a Word document; copy its table into a spreadsheet and save that"),
        (&["xl/workbook.bin"], "a binary Excel workbook (.xlsb); save it as .xlsx"),
        (
            &["a.npy"],
            "a NumPy archive (.npz); save an array of it as text: numpy.savetxt('FILE.csv', array, delimiter=',', fmt='%s')",
        ),
        (&["mimetype", "content.xml"], "an OpenDocument file without sheets; save its table as .ods or CSV"),
        (&["data.csv"], "a zip archive; unpack it and name the file that is in it"),
    ] {
        let files: Vec<(&str, &[u8])> = files.iter().map(|name| (*name, &b"x,y\n1,2\n"[..])).collect();
        refused(&archive(&files), XY, &format!(": this is {message}"));
    }
    let directory = directory_with(&[("b.xlsx", b"PK\x03\x04 and nothing more")]);
    let run = boundfit(directory.path(), &format!("fit b.xlsx {XY}"));
    assert!(
        run.status == 1 && run.stderr.starts_with("error: b.xlsx: cannot read a workbook: "),
        "{}",
        run.stderr
    );
}

#[test]
fn bombs_are_refused_before_memory_is_taken() {
    let too_large = |limit: u64| {
        format!(
            ": refused: the workbook has or unpacks to more than {limit} bytes (the limit); --limit workbook=N raises it"
        )
    };
    // A part that nobody reads counts too.
    let csv = "x,y\n1,2\n2,3";
    let padding = vec![b' '; 1 << 20];
    let zeros = archive(&[("xl/workbook.xml", &padding)]);
    assert!(zeros.len() < 10_000);
    refused(&zeros, &format!("{XY} --limit workbook=100000"), &too_large(100_000));
    let book = xlsx(&[("S", &xlsx_rows(csv, b'A', 1))]);
    refused(&book, &format!("{XY} --limit workbook=500"), &too_large(500));
    // Cells far apart: the text of the sheet has a tab for each that is between.
    let far: String =
        (1..200_000).map(|row| format!("<row r=\"{row}\"><c r=\"A{row}\"><v>1</v></c></row>")).collect();
    let far = far + "<row r=\"200000\"><c r=\"XFD200000\"><v>1</v></c></row>";
    let too_far = ": refused: it unpacks to more than 67108864 bytes and 100 times its size (the limit); --limit ratio=N raises it";
    let any_ratio = format!("{XY} --limit ratio=1000000000");
    refused(&xlsx(&[("S", &far)]), XY, too_far);
    refused(&xlsx(&[("S", &far)]), &any_ratio, &too_large(1 << 30));
    // Repetitions that a library would write out.
    let cell = "<table:table-cell office:value-type=\"float\" office:value=\"1\" table:number-columns-repeated=\"16384\"/>";
    let rows = format!("<table:table-row table:number-rows-repeated=\"1048576\">{cell}</table:table-row>");
    refused(&ods(&[("S", &rows)]), XY, too_far);
    refused(&ods(&[("S", &rows)]), &any_ratio, &too_large(1 << 30));
    let spaces = "<table:table-row><table:table-cell office:value-type=\"string\"><text:p><text:s text:c=\"99999999999\"/></text:p></table:table-cell></table:table-row>";
    refused(&ods(&[("S", spaces)]), XY, too_far);
    refused(&ods(&[("S", spaces)]), &any_ratio, &too_large(1 << 30));
}

#[test]
fn damaged_workbooks_are_refused() {
    let start = "<office:document-content><table:table table:name=\"S\"><table:table-row>";
    refused(&ods_with(start), XY, ": cannot read a workbook: it stops too soon");
    let book = xlsx(&[("S", &xlsx_rows("x,y\n1,2\n2,3", b'A', 1))]);
    for cut in [10, 100, book.len() / 2, book.len() - 1] {
        let directory = directory_with(&[("b.xlsx", &book[..cut])]);
        let run = boundfit(directory.path(), &format!("fit b.xlsx {XY}"));
        assert!(
            run.status == 1 && run.stderr.starts_with("error: b.xlsx: cannot read a workbook: "),
            "{}",
            run.stderr
        );
    }
    let order = "<row r=\"2\"><c r=\"A2\"><v>1</v></c></row><row r=\"1\"><c r=\"A1\"><v>1</v></c></row>";
    refused(
        &xlsx(&[("S", order)]),
        XY,
        ": cannot read a workbook: the cells of row 1 are not in their order",
    );
}

#[test]
fn every_command_reads_sheets() {
    let csv = "x,y,g\n1,2,a\n2,3,a\n3,5,b\n4,6,b";
    let directory = directory_with(&[
        ("data.csv", csv.as_bytes()),
        ("data.xlsx", &xlsx(&[("S", &xlsx_rows(csv, b'A', 1))])),
        ("data.ods", &ods(&[("S", &ods_rows(csv))])),
    ]);
    for command in [
        "fit DATA --x x --y y --eps 1 --by g",
        "check DATA --x x --y y --eps 1 --claim-pui 0,1,0,1 --format json",
        "plot DATA --x x --y y --eps 1 --figure data",
        "lesson DATA --x x --y y --eps 1",
        "convert DATA --x x --y y --eps 1 --to lp --objective theta1-min",
    ] {
        let expected = boundfit(directory.path(), &command.replace("DATA", "data.csv"));
        for file in ["data.xlsx", "data.ods"] {
            let run = boundfit(directory.path(), &command.replace("DATA", file));
            assert_eq!(
                (run.status, run.stderr.as_str()),
                (expected.status, expected.stderr.as_str()),
                "{command}"
            );
            let hash = |text: &str| text.replace(file, "data.csv");
            // Sheets have neither a delimiter nor an encoding.
            let of_sheet = |text: &str| {
                let text = text.replace("\"delimiter\": \"comma\"", "\"delimiter\": null");
                text.replace("\"encoding\": \"UTF-8\"", "\"encoding\": null")
            };
            let without_sheet =
                |text: String| match (text.find("      \"sheet\": {"), text.find("      \"blocks\"")) {
                    (Some(start), Some(end)) => format!("{}{}", &text[..start], &text[end..]),
                    _ => text,
                };
            let answer = without_sheet(hash(&run.stdout));
            assert!(
                command.starts_with("lesson") || answer == of_sheet(&expected.stdout),
                "{command} {answer}"
            );
        }
    }
    let fit = |file: &str| answer(directory.path(), &format!("fit {file} --x x --y y --eps 1"));
    for file in ["data.csv", "data.xlsx", "data.ods"] {
        assert_eq!(
            boundfit(directory.path(), &format!("reduce {file} --x x --y y -o {file}.reduced")).status,
            0
        );
    }
    assert_eq!(fit("data.xlsx.reduced")["pui"], fit("data.csv.reduced")["pui"]);
    assert_eq!(fit("data.ods.reduced"), fit("data.xlsx.reduced"));
}

/// Options say how the table of the data is written; of one beside it they hold as far as they can.
#[test]
fn tables_beside_the_data_may_be_of_another_kind() {
    let more = xlsx(&[("M\u{fc}ller", &xlsx_rows("x,y\n4,4.5\n5,9", b'A', 1))]);
    let directory = directory_with(&[
        ("base.csv", b"x;y\n1;1,1\n2;1,9\n3;3\n"),
        ("more.csv", b"x;y\n4;4,5\n5;9\n"),
        ("more.xlsx", &more),
        ("more.json", br#"[{"x": 4, "y": 4.5}, {"x": 5, "y": 9}]"#),
    ]);
    let options = "--delimiter semicolon --decimal comma --encoding windows-1252 --header yes --comment none";
    let judged = |more: &str| {
        let line = format!("status base.csv --x x --y y --eps 1/2 {options} --new {more} --format csv");
        let run = boundfit(directory.path(), &line);
        assert_eq!(run.status, 0, "{more}: {run:?}");
        run.stdout
    };
    let expected = judged("more.csv");
    assert_eq!(expected.lines().count(), 6, "{expected}");
    assert_eq!(judged("more.xlsx"), expected);
    assert_eq!(judged("more.json"), expected);
}

/// The rows of several groups would be one.
#[test]
fn an_empty_name_of_a_group_is_refused_where_cells_are_merged_and_said_elsewhere() {
    let csv = "s,x,y\nA,1,1\n,2,2\nB,1,3\n,2,4\n";
    let rows = xlsx_rows(csv, b'A', 1);
    let directory = directory_with(&[
        ("plain.xlsx", &xlsx(&[("S", &rows)])),
        ("plain.csv", csv.as_bytes()),
        ("merged.ods", &{
            let spanned = "<table:table-cell table:number-rows-spanned=\"2\"";
            let rows = ods_rows(csv);
            let (header, rest) = rows.split_once("</table:table-row>").unwrap();
            let rest = rest.replacen("<table:table-cell", spanned, 1);
            ods(&[("S", &format!("{header}</table:table-row>{rest}"))])
        }),
    ]);
    let run = boundfit(directory.path(), "fit merged.ods --x x --y y --eps 1 --by s");
    let message = "cells of \"s\" are empty, and the sheet has merged cells, whose first cell alone has the value: write the name \
                   of the group into every row";
    assert!(run.status == 1 && run.stderr.contains(message), "{} {}", run.status, run.stderr);
    for file in ["plain.xlsx", "plain.csv"] {
        let report = printed(directory.path(), &format!("fit {file} --x x --y y --eps 1 --by s"));
        assert!(report.contains("rows without the name of a group are one group, \"\""), "{report}");
    }
}
