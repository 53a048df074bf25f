//! What a workbook unpacks to, before a library takes memory for it.

use std::borrow::Cow;
use std::io::{self, BufReader, Cursor, Read};

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use zip::ZipArchive;
use zip::result::ZipError;

use super::{Kind, unreadable};
use crate::error::InputErrorKind;

/// What a cell of OpenDocument takes in memory: the value and its formula.
const BYTES_PER_CELL: u64 = 64;
/// The most rows and columns that the library makes of one sheet.
const MOST: u64 = 1 << 20;

/// Which kind of workbook this is, or what else. Everything in it is unpacked once, to nowhere: sizes that an archive states
/// may be lies.
pub(super) fn measure(content: &[u8], limit: u64) -> Result<Kind, InputErrorKind> {
    let mut archive = ZipArchive::new(Cursor::new(content)).map_err(of_zip)?;
    let kind = kind(&mut archive)?;
    let mut left = limit;
    for index in 0..archive.len() {
        let entry = archive.by_index(index).map_err(of_zip)?;
        let is_content = kind == Kind::Ods && entry.name().is_ok_and(|name| name == "content.xml");
        let mut counted = Counted { inner: entry, left: &mut left, has_passed: false };
        let measured = if is_content { cells(&mut counted) } else { passed_over(&mut counted) };
        let has_passed = counted.has_passed;
        let cells = match measured {
            _ if has_passed => return Err(InputErrorKind::WorkbookTooLarge { limit }),
            measured => measured?,
        };
        let bytes = cells.saturating_mul(BYTES_PER_CELL);
        left = left.checked_sub(bytes).ok_or(InputErrorKind::WorkbookTooLarge { limit })?;
    }
    Ok(kind)
}

fn kind(archive: &mut ZipArchive<Cursor<&[u8]>>) -> Result<Kind, InputErrorKind> {
    let has = |start: &str| names(archive).any(|name| name.starts_with(start));
    let other = |format, instead| Err(InputErrorKind::BinaryTable { format, instead });
    if has("xl/workbook.xml") {
        return Ok(Kind::Xlsx);
    }
    if has("content.xml") {
        let mut mimetype = String::new();
        if let Ok(entry) = archive.by_name("mimetype") {
            let _ = entry.take(100).read_to_string(&mut mimetype);
        }
        if mimetype.starts_with("application/vnd.oasis.opendocument.spreadsheet") {
            return Ok(Kind::Ods);
        }
        return other("an OpenDocument file without sheets", "save its table as .ods or CSV");
    }
    if has("xl/") {
        return other("a binary Excel workbook (.xlsb)", "save it as .xlsx");
    }
    if has("word/") {
        return other("a Word document", "copy its table into a spreadsheet and save that");
    }
    if names(archive).any(|name| name.ends_with(".npy")) {
        return other(
            "a NumPy archive (.npz)",
            "save an array of it as text: numpy.savetxt('FILE.csv', array, delimiter=',')",
        );
    }
    other("a zip archive", "unpack it and name the file that is in it")
}

/// The names in an archive.
fn names<'a>(archive: &'a ZipArchive<Cursor<&[u8]>>) -> impl Iterator<Item = Cow<'a, str>> {
    archive.file_names().flatten()
}

/// Unpacks to nowhere.
fn passed_over(entry: &mut impl Read) -> Result<u64, InputErrorKind> {
    io::copy(entry, &mut io::sink()).map(|_| 0).map_err(unreadable)
}

/// How many cells the largest table of a document has, repetitions counted, once it is known that the document does not stop
/// too soon.
fn cells(entry: &mut impl Read) -> Result<u64, InputErrorKind> {
    let mut reader = Reader::from_reader(BufReader::new(entry));
    let (mut buffer, mut depth, mut total) = (Vec::new(), 0_u64, 0_u64);
    let (mut row_repeats, mut width) = (1, 0_u64);
    let (mut rows, mut widest) = (0_u64, 0_u64);
    loop {
        buffer.clear();
        let event = reader.read_event_into(&mut buffer).map_err(unreadable)?;
        let is_start = matches!(event, Event::Start(_));
        match &event {
            Event::Start(element) | Event::Empty(element) => {
                match element.name().as_ref() {
                    "table:table" => (rows, widest) = (0, 0),
                    "table:table-row" => {
                        row_repeats = repeats(element, "table:number-rows-repeated")?;
                        width = 0;
                    }
                    "table:table-cell" | "table:covered-table-cell" => {
                        width += repeats(element, "table:number-columns-repeated")?.min(MOST);
                        // The last empty cells of a row are repeated up to the edge of the sheet, and cost nothing.
                        if has_value(element) {
                            widest = widest.max(width);
                        }
                    }
                    "text:s" => {
                        let spaces = repeats(element, "text:c")?;
                        total = total.saturating_add(spaces / BYTES_PER_CELL);
                    }
                    _ => {}
                }
                depth += u64::from(is_start);
            }
            Event::End(element) => {
                depth = depth.saturating_sub(1);
                match element.name().as_ref() {
                    "table:table-row" if width > 0 => rows = rows.saturating_add(row_repeats),
                    "table:table" => total = total.saturating_add(rows.min(MOST).saturating_mul(widest)),
                    _ => {}
                }
            }
            Event::Eof if depth > 0 => return Err(unreadable("it stops too soon")),
            Event::Eof => return Ok(total),
            _ => {}
        }
    }
}

fn has_value(cell: &BytesStart) -> bool {
    cell.attributes().flatten().any(|attribute| {
        let key = attribute.key.as_ref();
        key.starts_with("office:") || key == "table:formula"
    })
}

/// The number in an attribute; 1 without it.
fn repeats(element: &BytesStart, name: &str) -> Result<u64, InputErrorKind> {
    let attribute = element.try_get_attribute(name).map_err(unreadable)?;
    let Some(attribute) = attribute else { return Ok(1) };
    attribute.value.trim().parse().map_err(|_| unreadable(format!("{name} is no number")))
}

/// What an entry unpacks to, as long as there may be more.
struct Counted<'a, R> {
    inner: R,
    left: &'a mut u64,
    has_passed: bool,
}

impl<R: Read> Read for Counted<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        match self.left.checked_sub(count as u64) {
            Some(left) => *self.left = left,
            None => {
                self.has_passed = true;
                return Err(io::Error::other("too large"));
            }
        }
        Ok(count)
    }
}

fn of_zip(error: ZipError) -> InputErrorKind {
    match error {
        ZipError::UnsupportedArchive(ZipError::PASSWORD_REQUIRED) => {
            unreadable("it is protected by a password: save it without one")
        }
        error => unreadable(error),
    }
}
