//! Workbooks as other programs write them, and hostile ones.

use std::path::Path;

use boundfit_tests::cli::{boundfit, directory_with, fixture, report};
use boundfit_tests::program::root;
use boundfit_tests::workbooks::{archive, ods, ods_rows, ods_with, xlsx, xlsx_rows};

/// Returns the answer of a command to a workbook among the fixtures: its status, and the line on standard error
/// without the file's name.
fn said(file: &str, options: &str) -> (i32, String) {
    let path = format!("fixtures/workbooks/{file}");
    let run = boundfit(&root(), &format!("fit {path} --eps 50 {options}"));
    (run.status, run.stderr.replace(&format!("error: {path}: "), ""))
}

#[test]
fn the_empty_cells_of_libreoffice_cost_nothing() {
    let directory = directory_with(&[("cars.csv", fixture("tables/cars.csv").as_bytes())]);
    let pui = |directory: &Path, file: &str| {
        report(directory, &format!("fit {file} --x speed --y dist --eps 50"), b"")["pui"].clone()
    };
    let found = pui(&root(), "fixtures/workbooks/cars-by-libreoffice.ods");
    assert_eq!(found, pui(directory.path(), "cars.csv"));
}

/// Empty cells between others, in columns and rows, move what follows.
#[test]
fn empty_cells_between_others_are_counted() {
    let csv = "x,,y\n1,,2\n,,\n,,\n2,,3\n3,,4.5";
    let rows = "<table:table-row><table:table-cell office:value-type=\"string\"><text:p>x</text:p></table:table-cell>\
        <table:table-cell/><table:table-cell office:value-type=\"string\"><text:p>y</text:p></table:table-cell>\
        <table:table-cell table:number-columns-repeated=\"16381\"/></table:table-row>"
        .to_owned();
    let number =
        |value: &str| format!("<table:table-cell office:value-type=\"float\" office:value=\"{value}\"/>");
    let row = |x: &str, y: &str| {
        let gap = "<table:covered-table-cell table:number-columns-repeated=\"1\"/>";
        format!("<table:table-row>{}{gap}{}</table:table-row>", number(x), number(y))
    };
    let gap = "<table:table-row table:number-rows-repeated=\"2\"><table:table-cell table:number-columns-repeated=\"16384\"/></table:table-row>";
    let end = gap.replace("\"2\"", "\"1048570\"");
    let rows = rows + &row("1", "2") + gap + &row("2", "3") + &row("3", "4.5") + &end;
    let directory = directory_with(&[
        ("a.ods", &ods(&[("S", &rows)])),
        ("b.ods", &ods(&[("S", &ods_rows(csv))])),
        ("bad.ods", &ods(&[("S", &rows.replace("4.5", "NaN"))])),
    ]);
    let fit = |file: &str| {
        let run =
            boundfit(directory.path(), &format!("fit {file} --x x --y y --eps 1 --block all --format csv"));
        assert_eq!((run.status, run.stderr), (0, format!("note: {file}: all 2 blocks\n")));
        run.stdout
    };
    assert_eq!(fit("a.ods"), fit("b.ods"));
    let run = boundfit(directory.path(), "fit bad.ods --x x --y y --eps 1 --block all");
    assert!(run.stderr.starts_with("error: bad.ods: S!C6 (y): \"NaN\": "), "{}", run.stderr);
}

#[test]
fn errors_of_a_spreadsheet_are_missing_values() {
    let advice = "(expected a number in every row); --missing skip leaves such rows out\n";
    let first = format!("\"#DIV/0!\": the value is missing, and in 6 rows more {advice}");
    for (file, place) in [
        ("errors-by-libreoffice.ods", "Sheet!B2 (y)"),
        ("errors-by-libreoffice.xlsx", "Sheet!B2 (y)"),
        ("errors-by-libreoffice.csv", "line 2, column 2 (y)"),
    ] {
        assert_eq!(said(file, "--x x --y y"), (1, format!("{place}: {first}")));
        let json = report(
            &root(),
            &format!("fit fixtures/workbooks/{file} --x x --y y --eps 1 --missing skip"),
            b"",
        );
        assert_eq!(
            (json["input"]["rows"].as_u64(), json["input"]["rows_missing"].as_u64()),
            (Some(4), Some(7))
        );
    }
    let error = |text: &str| format!("<c r=\"B2\" t=\"e\"><f>X</f><v>{text}</v></c>");
    for text in
        ["#DIV/0!", "#VALUE!", "#REF!", "#NAME?", "#NUM!", "#N/A", "#NULL!", "#SPILL!", "#GETTING_DATA"]
    {
        let rows = xlsx_rows("x,y", b'A', 1)
            + &format!("<row r=\"2\"><c r=\"A2\"><v>1</v></c>{}</row>", error(text))
            + &xlsx_rows("2,3\n3,4", b'A', 3);
        let directory = directory_with(&[
            ("b.xlsx", &xlsx(&[("S", &rows)])),
            ("b.csv", format!("x,y\n1,{text}\n2,3\n3,4\n").as_bytes()),
        ]);
        for (file, place) in [("b.xlsx", "S!B2 (y)"), ("b.csv", "line 2, column 2 (y)")] {
            let run = boundfit(directory.path(), &format!("fit {file} --x x --y y --eps 1"));
            let expected = format!(
                "error: {file}: {place}: \"{text}\": the value is missing, in this row only {advice}"
            );
            assert_eq!((run.status, run.stderr), (1, expected));
        }
    }
}

#[test]
fn formulas_that_nobody_computed_are_refused() {
    let expected = "\"=A2*2\": a formula without a stored value (expected a value: open the workbook in a spreadsheet and save it)\n";
    for (file, sheet) in
        [("uncomputed-by-openpyxl.xlsx", "Sheet"), ("uncomputed-by-xlsxwriter.xlsx", "Sheet1")]
    {
        for options in ["--x x --y y", "--x x --y y --missing skip", "--x y --y x --rows 1"] {
            let place = format!("{sheet}!B2 (y)");
            assert_eq!(said(file, options), (1, format!("{place}: {expected}")), "{options}");
        }
    }
    let cell = "<table:table-cell table:formula=\"of:=[.A2]*2\" office:value-type=\"float\"/>";
    let rows = ods_rows("x,y")
        + "<table:table-row>"
        + &ods_rows("1").replace("<table:table-row>", "").replace("</table:table-row>", "")
        + cell
        + "</table:table-row>";
    let directory = directory_with(&[("b.ods", &ods(&[("S", &rows)]))]);
    let run = boundfit(directory.path(), "fit b.ods --x x --y y --eps 1");
    let expected = expected.replace("=A2*2", "=[.A2]*2");
    assert_eq!((run.status, run.stderr), (1, format!("error: b.ods: S!B2 (y): {expected}")));
    // A formula whose value is an empty text has a value.
    let rows = xlsx_rows("x,y", b'A', 1)
        + "<row r=\"2\"><c r=\"A2\"><v>1</v></c><c r=\"B2\" t=\"str\"><f>\"\"</f><v></v></c></row>";
    let directory = directory_with(&[("b.xlsx", &xlsx(&[("S", &rows)]))]);
    let run = boundfit(directory.path(), "fit b.xlsx --x x --y y --eps 1");
    assert!(run.stderr.contains("S!B2 (y): \"\": the value is missing"), "{}", run.stderr);
}

#[test]
fn dates_of_libreoffice_are_refused_by_a_sentence() {
    let time = "a date or a time, not a number (expected a number: give the cells the format of one, or add a column of seconds or days)\n";
    let said = said("dates-by-libreoffice.ods", "--x t --y y");
    assert_eq!(said, (1, format!("Sheet!A2 (t): \"2024-01-02T03:04:05\": {time}")));
    let cell = "<table:table-cell office:value-type=\"time\" office:time-value=\"PT01H02M03S\"/>";
    let rows = ods_rows("x,y\n1,2") + "<table:table-row>" + cell + cell + "</table:table-row>";
    let directory = directory_with(&[("b.ods", &ods(&[("S", &rows)]))]);
    let run = boundfit(directory.path(), "fit b.ods --x x --y y --eps 1");
    assert_eq!(run.stderr, format!("error: b.ods: S!A3 (x): \"01:02:03\": {time}"));
}

#[test]
fn what_a_workbook_claims_is_not_believed() {
    for file in
        ["claims-two-billion-texts.xlsx", "claims-more-texts-than-memory.xlsx", "dimension-backwards.xlsx"]
    {
        assert_eq!(said(file, "--x x --y y"), (0, String::new()), "{file}");
    }
    let none = |text: &str| (1, format!("cannot read a workbook: {text:?} names no cell\n"));
    assert_eq!(said("column-without-end.xlsx", "--x x --y y"), none("ABCDEFGH4"));
    assert_eq!(said("row-without-end.xlsx", "--x x --y y"), none("99999999999"));
}

#[test]
fn parts_that_cannot_be_are_refused_by_one_sentence() {
    let deep = "<a>".repeat(300);
    let wide = format!("<table:table table:name=\"{}\"/>", "n".repeat(20_000_000));
    let sheets = "<table:table table:name=\"S\"/>".repeat(10_001);
    for (book, reason) in [
        (ods_with(&deep), "its elements are nested deeper than 256 levels"),
        (ods_with(&format!("<d>{wide}</d>")), "one of its texts has more than 16777216 bytes"),
        (ods_with(&format!("<d>{sheets}</d>")), "it has more than 10000 sheets"),
        (archive(&[("xl/workbook.xml", b"<workbook/>")]), ""),
    ] {
        let directory = directory_with(&[("b.ods", &book)]);
        let run = boundfit(directory.path(), "fit b.ods --x x --y y --eps 1");
        let expected = match reason {
            "" => "there is no sheet \"1\" (expected a workbook with sheets)".to_owned(),
            reason => format!("cannot read a workbook: {reason}"),
        };
        assert_eq!((run.status, run.stderr), (1, format!("error: b.ods: {expected}\n")));
    }
}
