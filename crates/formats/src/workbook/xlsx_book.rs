//! Reads the parts of an `.xlsx` beside its cells: sheets, formats and texts.

use std::collections::BTreeMap;

use quick_xml::events::{BytesStart, Event};

use super::archive::{Archive, Part, attribute, check_text, own_text, unreadable};
use super::formats::Shows;
use super::{Listed, MOST_SHEETS};
use crate::budget::HeldMemory;
use crate::error::InputErrorKind;
use crate::memory_use::MemoryUse;

/// Sheets and what else there is one of each in a workbook. Nothing real has as many, and each takes memory.
pub(super) fn refuse_many(count: usize) -> Result<(), InputErrorKind> {
    if count <= MOST_SHEETS {
        return Ok(());
    }
    Err(unreadable(format!("it has more than {MOST_SHEETS} parts")))
}

/// The meaning of cells beside their content.
#[derive(Default)]
pub(super) struct Book {
    pub(super) counts_from_1904: bool,
    /// `true` if formulas are to be computed anew, so that a 0 in them may be no value.
    pub(super) is_recalculated: bool,
    /// The meanings of the formats of cells, by their number.
    pub(super) shows: Vec<Shows>,
    pub(super) texts: Texts,
}

impl Book {
    /// The sheets, and which relation has each.
    pub(super) fn read_workbook(
        &mut self,
        archive: &mut Archive,
        path: &str,
    ) -> Result<Vec<(Listed, String)>, InputErrorKind> {
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
                        let state = attribute(&element, "state")?;
                        let is_hidden = matches!(state.as_deref(), Some("hidden" | "veryHidden"));
                        sheets.push((Listed { name, is_hidden }, id));
                        refuse_many(sheets.len())?;
                    }
                    _ => {}
                },
                Event::Eof => return Ok(sheets),
                _ => {}
            }
        }
    }

    pub(super) fn read_styles(&mut self, archive: &mut Archive, path: &str) -> Result<(), InputErrorKind> {
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

    pub(super) fn read_texts(&mut self, archive: &mut Archive, path: &str) -> Result<(), InputErrorKind> {
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

/// Returns whether an attribute is there and true.
pub(super) fn is_set(element: &BytesStart<'_>, name: &str) -> Result<bool, InputErrorKind> {
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
    /// The memory of the workbook's parts.
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
