//! Sheets of Excel's `.xlsx`: the parts of the workbook, then the cells of one sheet.

use std::collections::BTreeMap;

use boundfit_exact::Foreign;
use quick_xml::events::{BytesStart, Event};

use super::archive::{Archive, Part, attribute, check_text, own_text};
use super::formats::Shows;
use super::text::Lines;
use super::xlsx_cells::read_cells;
use super::{MOST_SHEETS, chosen, unreadable};
use crate::budget::{HeldMemory, MemoryUse};
use crate::error::InputErrorKind;

/// Hands the cells of the sheet that is wanted over; gives its name.
pub(super) fn read_sheet(
    archive: &mut Archive,
    wanted: Option<&str>,
    lines: &mut Lines,
) -> Result<String, InputErrorKind> {
    let package = relations(archive, "_rels/.rels", "")?;
    let main = path_of(&package, "officeDocument").unwrap_or("xl/workbook.xml");
    let (folder, file) = main.rsplit_once('/').unwrap_or(("", main));
    let parts = relations(archive, &join(folder, &format!("_rels/{file}.rels")), folder)?;
    let of_kind = |kind: &str, usual: &str| {
        path_of(&parts, kind).map_or_else(|| join(folder, usual), ToOwned::to_owned)
    };
    let mut book = Book::default();
    let mut sheets = book.read_workbook(archive, main)?;
    // Charts, dialogs and macros are sheets too.
    let path_of_sheet = |id: &str| {
        let part = parts.iter().find(|part| part.id == id && part.kind == "worksheet");
        part.map(|part| part.path.as_str())
    };
    sheets.retain(|(_, id)| path_of_sheet(id).is_some());
    let names: Vec<&str> = sheets.iter().map(|(name, _)| name.as_str()).collect();
    let (name, id) = sheets.get(chosen(&names, wanted)?).ok_or_else(|| unreadable("it has no sheet"))?;
    book.read_styles(archive, &of_kind("styles", "styles.xml"))?;
    book.read_texts(archive, &of_kind("sharedStrings", "sharedStrings.xml"))?;
    let path = path_of_sheet(id).unwrap_or_default();
    let missing = || unreadable(format!("there is no {} in it", Foreign::of(path).quoted()));
    read_cells(&mut archive.part(path)?.ok_or_else(missing)?, &book, lines)?;
    Ok(name.clone())
}

/// What one part says of another one.
struct Relation {
    id: String,
    /// The last word of its type.
    kind: String,
    path: String,
}

/// What a part whose own path is in this folder says of others; nothing where it does not.
fn relations(archive: &mut Archive, path: &str, folder: &str) -> Result<Vec<Relation>, InputErrorKind> {
    let mut relations = Vec::new();
    let Some(mut part) = archive.part(path)? else { return Ok(relations) };
    loop {
        match part.next()? {
            Event::Start(element) if element.local_name().as_ref() == "Relationship" => {
                let of = |name| attribute(&element, name);
                let (id, kind, target) = (of("Id")?, of("Type")?, of("Target")?);
                let kind = kind.as_deref().and_then(|kind| kind.rsplit('/').next()).unwrap_or_default();
                let path = join(folder, target.as_deref().unwrap_or_default());
                relations.push(Relation { id: id.unwrap_or_default().into(), kind: kind.to_owned(), path });
                refuse_many(relations.len())?;
            }
            Event::Eof => return Ok(relations),
            _ => {}
        }
    }
}

fn path_of<'a>(relations: &'a [Relation], kind: &str) -> Option<&'a str> {
    relations.iter().find(|relation| relation.kind == kind).map(|relation| relation.path.as_str())
}

/// A path as seen from a folder; one that begins with a slash is seen from the archive.
fn join(folder: &str, path: &str) -> String {
    let from_above = if path.starts_with('/') { "" } else { folder };
    let mut parts: Vec<&str> = Vec::new();
    for part in from_above.split('/').chain(path.split('/')) {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

/// Sheets and what else there is one of each in a workbook. Nothing real has as many, and each takes memory.
fn refuse_many(count: usize) -> Result<(), InputErrorKind> {
    if count <= MOST_SHEETS {
        return Ok(());
    }
    Err(unreadable(format!("it has more than {MOST_SHEETS} parts")))
}

/// What cells mean beside what stands in them.
#[derive(Default)]
pub(super) struct Book {
    pub(super) counts_from_1904: bool,
    /// Whether formulas are to be computed anew, so that a 0 in them may be no value.
    pub(super) is_recalculated: bool,
    /// What the formats of cells show, by their number.
    pub(super) shows: Vec<Shows>,
    pub(super) texts: Texts,
}

impl Book {
    /// The names of the sheets, and which relation has each.
    fn read_workbook(
        &mut self,
        archive: &mut Archive,
        path: &str,
    ) -> Result<Vec<(String, String)>, InputErrorKind> {
        let mut sheets = Vec::new();
        let Some(mut part) = archive.part(path)? else { return Err(unreadable("it has no list of sheets")) };
        loop {
            match part.next()? {
                Event::Start(element) => match element.local_name().as_ref() {
                    "workbookPr" => self.counts_from_1904 = is_set(&element, "date1904")?,
                    "calcPr" => self.is_recalculated = is_set(&element, "fullCalcOnLoad")?,
                    "sheet" => {
                        let [name, id] = [attribute(&element, "name")?, attribute(&element, "id")?]
                            .map(|value| value.unwrap_or_default().into_owned());
                        sheets.push((name, id));
                        refuse_many(sheets.len())?;
                    }
                    _ => {}
                },
                Event::Eof => return Ok(sheets),
                _ => {}
            }
        }
    }

    fn read_styles(&mut self, archive: &mut Archive, path: &str) -> Result<(), InputErrorKind> {
        let Some(mut part) = archive.part(path)? else { return Ok(()) };
        // Only those that show something else than a number.
        let mut written: BTreeMap<u32, Shows> = BTreeMap::new();
        let mut is_in_cells = false;
        loop {
            match part.next()? {
                Event::Start(element) => match element.local_name().as_ref() {
                    "numFmt" => {
                        let code = attribute(&element, "formatCode")?.unwrap_or_default();
                        written.insert(format_of(&element)?, Shows::of_code(&code));
                    }
                    "cellXfs" => is_in_cells = true,
                    "xf" if is_in_cells => {
                        let id = format_of(&element)?;
                        let shows = written.get(&id).copied();
                        self.shows.push(shows.unwrap_or_else(|| Shows::of_number(id)));
                    }
                    _ => {}
                },
                Event::End(element) if element.local_name().as_ref() == "cellXfs" => is_in_cells = false,
                Event::Eof => return Ok(()),
                _ => {}
            }
        }
    }

    fn read_texts(&mut self, archive: &mut Archive, path: &str) -> Result<(), InputErrorKind> {
        let (limit, memory) = (archive.limit(), archive.more_memory());
        let Some(mut part) = archive.part(path)? else { return Ok(()) };
        loop {
            let is_text = match part.next()? {
                Event::Start(element) => element.local_name().as_ref() == "si",
                Event::Eof => {
                    self.texts.memory = Some(memory);
                    return Ok(());
                }
                _ => false,
            };
            if is_text {
                let text = rich_text(&mut part)?;
                memory.ask((text.len() + size_of::<u32>()) as u64, MemoryUse::Cells)?;
                self.texts.push(&text).ok_or(InputErrorKind::WorkbookTooLarge { limit })?;
            }
        }
    }
}

/// The number of the format that an element names.
fn format_of(element: &BytesStart<'_>) -> Result<u32, InputErrorKind> {
    Ok(attribute(element, "numFmtId")?.and_then(|id| id.parse().ok()).unwrap_or_default())
}

fn is_set(element: &BytesStart<'_>, name: &str) -> Result<bool, InputErrorKind> {
    Ok(attribute(element, name)?.is_some_and(|value| matches!(value.as_ref(), "1" | "true")))
}

/// The text of an element that has just begun: that of all of its pieces, but not how it is pronounced.
pub(super) fn rich_text(part: &mut Part<'_>) -> Result<String, InputErrorKind> {
    let (inside, mut text) = (part.depth(), String::new());
    let (mut is_text, mut is_spoken, mut keeps_blanks) = (false, false, false);
    let mut piece = String::new();
    while part.depth() >= inside {
        let event = part.next()?;
        match &event {
            Event::Start(element) => match element.local_name().as_ref() {
                "rPh" => is_spoken = true,
                "t" => {
                    is_text = !is_spoken;
                    keeps_blanks = attribute(element, "space")?.is_some_and(|space| space == "preserve");
                }
                _ => {}
            },
            Event::End(element) => match element.local_name().as_ref() {
                "rPh" => is_spoken = false,
                "t" if is_text => {
                    let blanks = [' ', '\t', '\n', '\r'];
                    text.push_str(if keeps_blanks { &piece } else { piece.trim_matches(blanks) });
                    piece.clear();
                    is_text = false;
                }
                _ => {}
            },
            Event::Eof => break,
            event if is_text => piece.push_str(own_text(event)?.as_deref().unwrap_or_default()),
            _ => {}
        }
        check_text(text.len() + piece.len())?;
    }
    Ok(unescaped(text))
}

/// A text with the characters that XML cannot have, which Excel writes as `_x000D_`.
pub(super) fn unescaped(text: String) -> String {
    if !text.contains("_x") {
        return text;
    }
    let (mut all, mut rest) = (String::with_capacity(text.len()), text.as_str());
    while let Some((before, behind)) = rest.split_once("_x") {
        all.push_str(before);
        let code = behind.split_at_checked(4).filter(|(_, end)| end.starts_with('_'));
        let character = code.and_then(|(code, _)| char::from_u32(u32::from_str_radix(code, 16).ok()?));
        match (character, behind.get(5..)) {
            (Some(character), Some(after)) => {
                all.push(character);
                rest = after;
            }
            _ => {
                all.push_str("_x");
                rest = behind;
            }
        }
    }
    all + rest
}

/// The texts that cells have by number, one behind the other: a claim of how many there are is not believed.
#[derive(Default)]
pub(super) struct Texts {
    all: String,
    ends: Vec<u32>,
    /// What they take.
    memory: Option<HeldMemory>,
}

impl Texts {
    /// `None` where there is no room left.
    fn push(&mut self, text: &str) -> Option<()> {
        self.all.push_str(text);
        self.ends.push(u32::try_from(self.all.len()).ok()?);
        Some(())
    }

    pub(super) fn get(&self, index: usize) -> Option<&str> {
        let end = *self.ends.get(index)?;
        let start =
            index.checked_sub(1).and_then(|before| self.ends.get(before)).copied().unwrap_or_default();
        self.all.get(start as usize..end as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_seen_from_a_folder_or_from_the_archive() {
        for (folder, path, joined) in [
            ("xl", "worksheets/sheet1.xml", "xl/worksheets/sheet1.xml"),
            ("xl", "/xl/sheet1.xml", "xl/sheet1.xml"),
            ("xl/a", "../b.xml", "xl/b.xml"),
            ("", "../../b.xml", "b.xml"),
        ] {
            assert_eq!(join(folder, path), joined);
        }
    }

    #[test]
    fn characters_that_xml_cannot_have() {
        for (text, expected) in [
            ("a_x000D_b", "a\rb"),
            ("_x0041__x0042_", "AB"),
            ("_x12_ _xD800_ _x", "_x12_ _xD800_ _x"),
            ("plain", "plain"),
        ] {
            assert_eq!(unescaped(text.to_owned()), expected);
        }
    }
}
