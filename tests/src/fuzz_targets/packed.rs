//! Workbooks and packed tables: whatever they hold, they are read or refused.

use std::io::{Cursor, Write};

use boundfit_formats::{ColumnSelector, Missing, Source, TableOptions, read_table};
use flate2::Compression;
use flate2::write::GzEncoder;

use super::table::{LIMITS, POOL, sizes};
use crate::workbooks::{archive, xlsx, xlsx_with};

/// The bytes as a workbook, and as each part of one that is whole otherwise: what is there to unpack changes nothing.
pub fn workbook_reader(data: &[u8]) {
    let sheet = "<row r=\"1\"><c r=\"A1\" t=\"s\"><v>0</v></c><c r=\"B1\" t=\"s\"><v>1</v></c></row>\
        <row r=\"2\"><c r=\"A2\" s=\"1\"><v>1</v></c><c r=\"B2\"><f>A2</f><v>2</v></c></row>";
    let content = ("content.xml", data);
    let mimetype: (&str, &[u8]) = ("mimetype", b"application/vnd.oasis.opendocument.spreadsheet");
    let mut books = vec![data.to_vec(), archive(&[mimetype, content])];
    if let Ok(text) = std::str::from_utf8(data) {
        let parts =
            ["xl/sharedStrings.xml", "xl/styles.xml", "xl/workbook.xml", "xl/_rels/workbook.xml.rels"];
        books.extend(parts.map(|part| xlsx_with(&[("S", sheet)], part, text)));
        books.push(xlsx(&[("S", text)]));
    }
    for book in books {
        // Either is right.
        let _ = read(&book);
    }
}

/// The bytes as what a packed file holds, or is.
pub fn packed_reader(data: &[u8]) {
    let mut packed = GzEncoder::new(Vec::new(), Compression::fast());
    packed.write_all(data).expect("memory takes everything");
    let packed = packed.finish().expect("memory takes everything");
    let table = read(data);
    // Data that is packed twice is not unpacked twice.
    let is_packed = [&b"\x1f\x8b"[..], b"\x28\xb5\x2f\xfd"].into_iter().any(|mark| data.starts_with(mark));
    if table.is_ok() && !is_packed {
        assert_eq!(read(&packed), table, "a table is the same when it is packed");
    }
}

/// The number of rows there are, and how many are left out.
fn read(data: &[u8]) -> Result<(usize, usize), String> {
    let mut found = Err(String::new());
    for missing in [Missing::Refuse, Missing::Skip] {
        let options = TableOptions { missing, limits: LIMITS, sizes: sizes(), ..TableOptions::default() };
        for columns in [["x", "y"], ["1", "2"]] {
            let columns = columns.map(ColumnSelector::name_or_number);
            let table = POOL.install(|| {
                let source = Source::new("data", Cursor::new(data.to_vec()));
                read_table(source, &columns, &options)
                    .map(|table| (table.rows.len(), table.scanned.rows_missing))
                    .map_err(|error| error.to_string())
            });
            found = found.or(table);
        }
    }
    found
}
