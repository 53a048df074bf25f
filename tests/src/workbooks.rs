//! Workbooks for tests, written part by part: what a spreadsheet would write, and what none would.

use std::io::{Cursor, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// A zip archive with these files in this order.
pub fn archive(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in files {
        writer.start_file(*name, SimpleFileOptions::default()).unwrap();
        writer.write_all(content).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// The parts of a workbook of Excel that are not sheets: two styles, of which number 1 is a date, and these sheets.
fn xlsx_parts(names: &[&str]) -> Vec<(String, String)> {
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let package = "http://schemas.openxmlformats.org/package/2006/relationships";
    let numbered = || (1..).zip(names);
    let sheets: String = numbered()
        .map(|(k, name)| format!("<sheet name=\"{name}\" sheetId=\"{k}\" r:id=\"rId{k}\"/>"))
        .collect();
    let relations: String = numbered()
        .map(|(k, _)| {
            format!(
                "<Relationship Id=\"rId{k}\" Type=\"{office}/worksheet\" Target=\"worksheets/sheet{k}.xml\"/>"
            )
        })
        .collect();
    [
        (
            "_rels/.rels",
            format!(
                "<Relationships xmlns=\"{package}\"><Relationship Id=\"r\" Type=\"{office}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
            ),
        ),
        (
            "xl/workbook.xml",
            format!("<workbook xmlns=\"{main}\" xmlns:r=\"{office}\"><sheets>{sheets}</sheets></workbook>"),
        ),
        (
            "xl/_rels/workbook.xml.rels",
            format!(
                "<Relationships xmlns=\"{package}\">{relations}<Relationship Id=\"s\" Type=\"{office}/styles\" Target=\"styles.xml\"/></Relationships>"
            ),
        ),
        (
            "xl/styles.xml",
            format!("<styleSheet xmlns=\"{main}\"><cellXfs count=\"2\"><xf numFmtId=\"0\"/><xf numFmtId=\"14\"/></cellXfs></styleSheet>"),
        ),
    ]
    .map(|(name, text)| (name.to_owned(), text))
    .to_vec()
}

/// A workbook of Excel with these sheets, each the XML of its rows.
pub fn xlsx(sheets: &[(&str, &str)]) -> Vec<u8> {
    xlsx_of(sheets, None)
}

/// A workbook of Excel with these sheets, and this in place of a part.
pub fn xlsx_with(sheets: &[(&str, &str)], part: &str, text: &str) -> Vec<u8> {
    xlsx_of(sheets, Some((part, text)))
}

fn xlsx_of(sheets: &[(&str, &str)], other: Option<(&str, &str)>) -> Vec<u8> {
    let names: Vec<&str> = sheets.iter().map(|(name, _)| *name).collect();
    let mut parts = xlsx_parts(&names);
    for (k, (_, rows)) in (1..).zip(sheets) {
        let text = format!(
            "<worksheet xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\"><sheetData>{rows}</sheetData></worksheet>"
        );
        parts.push((format!("xl/worksheets/sheet{k}.xml"), text));
    }
    if let Some((part, text)) = other {
        parts.retain(|(name, _)| name != part);
        parts.push((part.to_owned(), text.to_owned()));
    }
    let parts: Vec<(&str, &[u8])> =
        parts.iter().map(|(name, text)| (name.as_str(), text.as_bytes())).collect();
    archive(&parts)
}

/// The cell of a table as a sheet of Excel has it: a number where the text is one, else text.
fn xlsx_cell(place: &str, text: &str) -> String {
    match text.parse::<f64>() {
        _ if text.is_empty() => String::new(),
        Ok(_) => format!("<c r=\"{place}\"><v>{text}</v></c>"),
        Err(_) => format!("<c r=\"{place}\" t=\"inlineStr\"><is><t>{text}</t></is></c>"),
    }
}

/// The rows of a CSV without quotes as a sheet of Excel has them, from a column and a row on.
pub fn xlsx_rows(csv: &str, column: u8, first_row: usize) -> String {
    let row = |(number, line): (usize, &str)| {
        let cells = (column..).zip(line.split(','));
        let cells: String =
            cells.map(|(letter, text)| xlsx_cell(&format!("{}{number}", char::from(letter)), text)).collect();
        format!("<row r=\"{number}\">{cells}</row>")
    };
    (first_row..).zip(csv.lines()).map(row).collect()
}

/// A workbook of OpenDocument with these sheets, each the XML of its rows.
pub fn ods(sheets: &[(&str, &str)]) -> Vec<u8> {
    let tables: String = sheets
        .iter()
        .map(|(name, rows)| format!("<table:table table:name=\"{name}\">{rows}</table:table>"))
        .collect();
    ods_with(&format!(
        "<office:document-content xmlns:office=\"urn:oasis:names:tc:opendocument:xmlns:office:1.0\" xmlns:table=\"urn:oasis:names:tc:opendocument:xmlns:table:1.0\" xmlns:text=\"urn:oasis:names:tc:opendocument:xmlns:text:1.0\"><office:body><office:spreadsheet>{tables}</office:spreadsheet></office:body></office:document-content>"
    ))
}

/// A workbook of OpenDocument with this content.
pub fn ods_with(content: &str) -> Vec<u8> {
    archive(&[
        ("mimetype", b"application/vnd.oasis.opendocument.spreadsheet"),
        ("META-INF/manifest.xml", b"<manifest:manifest xmlns:manifest=\"m\"></manifest:manifest>"),
        ("content.xml", content.as_bytes()),
    ])
}

/// The rows of a CSV without quotes as OpenDocument has them.
pub fn ods_rows(csv: &str) -> String {
    let cell = |text: &str| match text.parse::<f64>() {
        _ if text.is_empty() => "<table:table-cell/>".to_owned(),
        Ok(_) => format!(
            "<table:table-cell office:value-type=\"float\" office:value=\"{text}\"><text:p>{text}</text:p></table:table-cell>"
        ),
        Err(_) => format!(
            "<table:table-cell office:value-type=\"string\"><text:p>{text}</text:p></table:table-cell>"
        ),
    };
    let row = |line: &str| {
        format!("<table:table-row>{}</table:table-row>", line.split(',').map(cell).collect::<String>())
    };
    csv.lines().map(row).collect()
}
