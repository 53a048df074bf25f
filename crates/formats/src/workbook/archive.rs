//! The parts of a workbook, unpacked as they are read: nothing that a part says of its size is believed.

use std::borrow::Cow;
use std::io::{self, BufReader, Cursor, Read};

use quick_xml::escape::resolve_xml_entity;
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use zip::ZipArchive;
use zip::read::ZipFile;
use zip::result::ZipError;

use crate::budget::HeldMemory;
use crate::error::InputErrorKind;
use crate::limits::LONGEST_LINE;
use crate::memory_use::MemoryUse;

/// The name of such files in messages.
pub(super) const FORMAT: &str = "a workbook";

/// The two kinds of workbooks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Office Open XML.
    Xlsx,
    /// OpenDocument.
    Ods,
}

/// Returns the error of a workbook that cannot be read.
pub(super) fn unreadable(reason: impl ToString) -> InputErrorKind {
    InputErrorKind::Unreadable { format: FORMAT, reason: reason.to_string().into() }
}

/// The most levels of nested elements of a part. Real ones stay below 20.
const DEEPEST: usize = 256;

/// The first bytes of each entry in the list of all parts (APPNOTE.TXT 6.3.10, 4.3.12).
const ENTRY: &[u8] = b"PK\x01\x02";

/// Bytes that the library holds for a part: measured as the largest memory of a process that opened an archive of 3·10⁵ parts.
const OF_AN_ENTRY: u64 = 200;

/// A workbook as the zip archive that it is.
pub(super) struct Archive {
    zip: ZipArchive<Cursor<Vec<u8>>>,
    /// Bytes that each part may unpack to.
    limit: u64,
    /// The memory of the archive's bytes and of the list of its parts.
    memory: HeldMemory,
}

impl Archive {
    /// Opens the archive with these bytes, whose memory this is.
    pub(super) fn open(content: Vec<u8>, limit: u64, memory: HeldMemory) -> Result<Self, InputErrorKind> {
        // Packed bytes look like an entry once in four thousand million.
        let entries = memchr::memmem::find_iter(&content, ENTRY).count() as u64;
        memory.ask(entries.saturating_mul(OF_AN_ENTRY), MemoryUse::Workbook)?;
        let zip = ZipArchive::new(Cursor::new(content)).map_err(of_zip)?;
        Ok(Archive { zip, limit, memory })
    }

    /// Returns the kind of the workbook, or the error that it is none.
    pub(super) fn kind(&mut self) -> Result<Kind, InputErrorKind> {
        let has = |start: &str| self.names().any(|name| name.starts_with(start));
        let other = |format, instead| Err(InputErrorKind::BinaryTable { format, instead });
        if has("xl/workbook.xml") {
            return Ok(Kind::Xlsx);
        }
        if has("content.xml") {
            let mut mimetype = String::new();
            if let Ok(entry) = self.zip.by_name("mimetype") {
                let _ = entry.take(100).read_to_string(&mut mimetype);
            }
            if mimetype.starts_with("application/vnd.oasis.opendocument.spreadsheet") {
                return Ok(Kind::Ods);
            }
            return other("an OpenDocument file without sheets", "save its table as .ods or CSV");
        }
        if has("xl/workbook.bin") {
            return other("a binary Excel workbook (.xlsb)", "save it as .xlsx");
        }
        if has("xl/") {
            return Ok(Kind::Xlsx);
        }
        if has("word/") {
            return other("a Word document", "copy its table into a spreadsheet and save that");
        }
        if self.names().any(|name| name.ends_with(".npy")) {
            return other(
                "a NumPy archive (.npz)",
                "save an array of it as text: numpy.savetxt('FILE.csv', array, delimiter=',', fmt='%s')",
            );
        }
        other("a zip archive", "unpack it and name the file that is in it")
    }

    fn names(&self) -> impl Iterator<Item = Cow<'_, str>> {
        self.zip.file_names().flatten()
    }

    /// The part of this name, in large or small letters.
    pub(super) fn part(&mut self, name: &str) -> Result<Option<Part<'_>>, InputErrorKind> {
        let index = self.zip.index_for_name(name).or_else(|| {
            let is_it = |other: &str| other.eq_ignore_ascii_case(name);
            self.zip.file_names().position(|other| other.is_ok_and(|other| is_it(&other)))
        });
        let Some(index) = index else { return Ok(None) };
        let entry = self.zip.by_index(index).map_err(of_zip)?;
        // A part's stated size can only refuse it sooner: the unpacked bytes are counted in any case.
        if entry.size() > self.limit {
            return Err(InputErrorKind::WorkbookTooLarge { limit: self.limit });
        }
        Ok(Some(Part::new(entry, self.limit)))
    }

    /// Bytes that each part may unpack to.
    pub(super) fn limit(&self) -> u64 {
        self.limit
    }

    /// Memory of the same budget, of which nothing was taken yet.
    pub(super) fn more_memory(&self) -> HeldMemory {
        self.memory.budget().nothing()
    }
}

/// The bytes of a part as they are unpacked.
type Unpacked<'a> = BufReader<Counted<ZipFile<'a, Cursor<Vec<u8>>>>>;

/// The XML of a part, event by event.
pub(super) struct Part<'a> {
    reader: Reader<Unpacked<'a>>,
    buffer: Vec<u8>,
    depth: usize,
    limit: u64,
}

impl<'a> Part<'a> {
    fn new(entry: ZipFile<'a, Cursor<Vec<u8>>>, limit: u64) -> Self {
        let counted = Counted { inner: entry, left: limit, of_token: LONGEST_LINE, passed: None };
        let mut reader = Reader::from_reader(BufReader::new(counted));
        reader.config_mut().expand_empty_elements = true;
        Part { reader, buffer: Vec::new(), depth: 0, limit }
    }

    /// The next event; every start of an element has its end.
    pub(super) fn next(&mut self) -> Result<Event<'_>, InputErrorKind> {
        self.buffer.clear();
        self.reader.get_mut().get_mut().of_token = LONGEST_LINE;
        let event = match self.reader.read_event_into(&mut self.buffer) {
            Ok(event) => event,
            Err(error) => {
                return Err(match self.reader.get_ref().get_ref().passed {
                    Some(Passed::Part) => InputErrorKind::WorkbookTooLarge { limit: self.limit },
                    Some(Passed::Token) => too_long(),
                    None => unreadable(error),
                });
            }
        };
        match event {
            Event::Start(_) if self.depth >= DEEPEST => {
                return Err(unreadable(format!("its elements are nested deeper than {DEEPEST} levels")));
            }
            Event::Start(_) => self.depth += 1,
            Event::End(_) => self.depth = self.depth.saturating_sub(1),
            Event::Eof if self.depth > 0 => return Err(unreadable("it stops too soon")),
            _ => {}
        }
        Ok(event)
    }

    /// Returns the number of open elements.
    pub(super) fn depth(&self) -> usize {
        self.depth
    }

    /// Passes over the rest of the element that has just begun.
    pub(super) fn skip(&mut self) -> Result<(), InputErrorKind> {
        let inside = self.depth;
        while self.depth >= inside {
            if matches!(self.next()?, Event::Eof) {
                break;
            }
        }
        Ok(())
    }

    /// The text of the element that has just begun, without that of the elements in it.
    pub(super) fn text(&mut self) -> Result<String, InputErrorKind> {
        let (inside, mut text) = (self.depth, String::new());
        while self.depth >= inside {
            let event = self.next()?;
            if let Some(own) = own_text(&event)? {
                text.push_str(&own);
                check_text(text.len())?;
            }
            if matches!(event, Event::Eof) {
                break;
            }
        }
        Ok(text)
    }
}

/// The characters that an event stands for, if it is text.
pub(super) fn own_text<'e>(event: &'e Event<'_>) -> Result<Option<Cow<'e, str>>, InputErrorKind> {
    Ok(match event {
        Event::Text(text) => Some(text.xml10_content()),
        Event::CData(text) => Some(text.xml10_content()),
        Event::GeneralRef(name) => Some(match name.resolve_char_ref().map_err(unreadable)? {
            Some(character) => Cow::Owned(character.to_string()),
            None => Cow::Borrowed(resolve_xml_entity(name).unwrap_or_default()),
        }),
        _ => None,
    })
}

/// Refuses a text that is longer than a line of a table may be.
pub(super) fn check_text(bytes: usize) -> Result<(), InputErrorKind> {
    if bytes > LONGEST_LINE { Err(too_long()) } else { Ok(()) }
}

fn too_long() -> InputErrorKind {
    unreadable(format!("one of its texts has more than {LONGEST_LINE} bytes"))
}

/// The value of an attribute, whatever stands in front of the colon of its name.
pub(super) fn attribute<'a>(
    element: &'a BytesStart<'_>,
    name: &str,
) -> Result<Option<Cow<'a, str>>, InputErrorKind> {
    attribute_where(element, |key| key.rsplit(':').next() == Some(name))
}

/// The value of an attribute by its whole name.
pub(super) fn attribute_named<'a>(
    element: &'a BytesStart<'_>,
    name: &str,
) -> Result<Option<Cow<'a, str>>, InputErrorKind> {
    attribute_where(element, |key| key == name)
}

fn attribute_where<'a>(
    element: &'a BytesStart<'_>,
    is_it: impl Fn(&str) -> bool,
) -> Result<Option<Cow<'a, str>>, InputErrorKind> {
    let mut attributes = element.attributes();
    // Looking for a name that is there twice takes the square of their number.
    for attribute in attributes.with_checks(false) {
        let attribute = attribute.map_err(unreadable)?;
        if is_it(attribute.key.as_ref()) {
            return attribute.normalized_value(XmlVersion::Implicit1_0).map(Some).map_err(unreadable);
        }
    }
    Ok(None)
}

/// The unpacked bytes of an entry, up to a limit.
struct Counted<R> {
    inner: R,
    left: u64,
    /// Bytes that the piece of XML may have which is being read: it is in memory whole.
    of_token: usize,
    passed: Option<Passed>,
}

#[derive(Clone, Copy)]
enum Passed {
    Part,
    Token,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        self.passed = match (self.left.checked_sub(count as u64), self.of_token.checked_sub(count)) {
            (None, _) => Some(Passed::Part),
            (_, None) => Some(Passed::Token),
            (Some(left), Some(of_token)) => {
                (self.left, self.of_token) = (left, of_token);
                return Ok(count);
            }
        };
        Err(io::Error::other("too large"))
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
