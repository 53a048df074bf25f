//! Sheets of OpenDocument's `.ods`.

use std::borrow::Cow;
use std::collections::BTreeSet;

use boundfit_exact::DecimalMark;
use quick_xml::events::{BytesStart, Event};

use super::archive::{Archive, Part, attribute_named, check_text, own_text, unreadable};
use super::text::{Lines, MOST_COLUMNS};
use super::{Choice, Listed, MOST_SHEETS, chosen, finite, stored_text};
use crate::error::InputErrorKind;
use crate::memory_use::MemoryUse;

/// Hands the cells of the sheet that is wanted over; gives the sheet.
pub(super) fn read_sheet(
    archive: &mut Archive,
    wanted: Option<&str>,
    lines: &mut Lines,
) -> Result<Choice, InputErrorKind> {
    refuse_password(archive)?;
    let choice = chosen(listed(archive)?, wanted)?;
    let limit = archive.limit();
    let mut part = content(archive)?;
    let mut before = 0;
    loop {
        let is_table = match part.next()? {
            Event::Start(element) => sheet_name(&element)?.is_some(),
            Event::Eof => break,
            _ => false,
        };
        if is_table && before == choice.index {
            read_table(&mut part, limit, lines)?;
            break;
        }
        if is_table {
            part.skip()?;
            before += 1;
        }
    }
    Ok(choice)
}

fn content(archive: &mut Archive) -> Result<Part<'_>, InputErrorKind> {
    archive.part("content.xml")?.ok_or_else(|| unreadable("there is no \"content.xml\" in it"))
}

fn refuse_password(archive: &mut Archive) -> Result<(), InputErrorKind> {
    let Some(mut part) = archive.part("META-INF/manifest.xml")? else { return Ok(()) };
    loop {
        match part.next()? {
            Event::Start(element) if element.local_name().as_ref() == "encryption-data" => {
                return Err(unreadable("it is protected by a password: save it without one"));
            }
            Event::Eof => return Ok(()),
            _ => {}
        }
    }
}

/// All sheets, once it is known that the document does not stop too soon.
fn listed(archive: &mut Archive) -> Result<Vec<Listed>, InputErrorKind> {
    let memory = archive.more_memory();
    let mut part = content(archive)?;
    let mut sheets = Vec::new();
    // The styles stand before the sheets. Each sheet has at most one of its own.
    let (mut style, mut hiding) = (None, BTreeSet::new());
    loop {
        let found = match part.next()? {
            Event::Start(element) if element.name().as_ref() == "style:style" => {
                style = attribute_named(&element, "style:name")?.map(Cow::into_owned);
                None
            }
            Event::Start(element) if element.name().as_ref() == "style:table-properties" => {
                if attribute_named(&element, "table:display")?.as_deref() == Some("false") {
                    hiding.extend(style.take().filter(|_| hiding.len() < MOST_SHEETS));
                }
                None
            }
            Event::Start(element) => {
                let style = attribute_named(&element, "table:style-name")?;
                let is_hidden = style.is_some_and(|style| hiding.contains(style.as_ref()));
                sheet_name(&element)?.map(|name| Listed { name, is_hidden })
            }
            Event::Eof => return Ok(sheets),
            _ => None,
        };
        if let Some(sheet) = found {
            memory.ask(sheet.name.len() as u64, MemoryUse::Workbook)?;
            sheets.push(sheet);
            part.skip()?;
        }
        if sheets.len() > MOST_SHEETS {
            return Err(unreadable(format!("it has more than {MOST_SHEETS} sheets")));
        }
    }
}

/// The name of a sheet, if its element begins here.
fn sheet_name(element: &BytesStart<'_>) -> Result<Option<String>, InputErrorKind> {
    if element.name().as_ref() != "table:table" {
        return Ok(None);
    }
    Ok(attribute_named(element, "table:name")?.map(Cow::into_owned))
}

/// The cells of a row that are not empty.
#[derive(Default)]
struct Row {
    /// The first column of each, how many columns have it, and its text.
    cells: Vec<(u64, u64, String)>,
    /// The number of columns so far.
    width: u64,
    bytes: usize,
}

impl Row {
    fn push(&mut self, repeats: u64, text: String) -> Result<(), InputErrorKind> {
        self.bytes += text.len();
        check_text(self.bytes)?;
        // More are refused when the row is written.
        if !text.is_empty() && self.cells.len() <= MOST_COLUMNS as usize {
            self.cells.push((self.width, repeats, text));
        }
        self.width = self.width.saturating_add(repeats);
        Ok(())
    }

    /// Returns the number of bytes of the row as text.
    fn length(&self) -> u64 {
        let own = |(_, repeats, text): &(u64, u64, String)| repeats.saturating_mul(text.len() as u64);
        let tabs = self.cells.last().map_or(0, |(first, repeats, _)| first.saturating_add(*repeats));
        self.cells.iter().map(own).fold(tabs, u64::saturating_add)
    }

    /// Hands the row over once.
    fn write(&self, row: u64, lines: &mut Lines) -> Result<(), InputErrorKind> {
        for (first, repeats, text) in &self.cells {
            for column in *first..first.saturating_add(*repeats) {
                lines.push(short(row), short(column), text)?;
            }
        }
        Ok(())
    }
}

/// Hands over the cells of the table that has just begun. Empty cells are repeated up to the edge of the
/// sheet, and cost nothing. Other cells are written as often as they are repeated, and no further than the
/// limit of the lines.
fn read_table(part: &mut Part<'_>, limit: u64, lines: &mut Lines) -> Result<(), InputErrorKind> {
    let inside = part.depth();
    let (mut row, mut number, mut row_repeats) = (Row::default(), 0_u64, 1);
    let (mut is_hidden, mut columns) = (false, 0_u64);
    while part.depth() >= inside {
        let event = part.next()?;
        match &event {
            Event::Start(element) => match element.name().as_ref() {
                "table:table-row" => {
                    row = Row::default();
                    row_repeats = repeats(element, "table:number-rows-repeated")?;
                    is_hidden = is_unseen(element)?;
                }
                "table:table-column" => {
                    let first = columns;
                    columns = first.saturating_add(repeats(element, "table:number-columns-repeated")?);
                    if is_unseen(element)? {
                        lines.hide_columns(short(first), short(columns.saturating_sub(1)));
                    }
                }
                "table:table-cell" | "table:covered-table-cell" => {
                    let repeats = repeats(element, "table:number-columns-repeated")?;
                    let cell = Cell::begin(element, lines.decimal)?;
                    lines.merged += u64::from(spans(element)?);
                    drop(event);
                    let is_text = cell.is_text;
                    let text = cell.text(part, limit)?;
                    lines.notice(is_text, &text);
                    row.push(repeats, text)?;
                }
                // A table in a cell, or beside the cells.
                "table:table" | "table:shapes" => {
                    drop(event);
                    part.skip()?;
                }
                _ => {}
            },
            Event::End(element) if element.name().as_ref() == "table:table-row" => {
                let repeats = if row.cells.is_empty() { 0 } else { row_repeats };
                lines.hidden_rows = lines.hidden_rows.saturating_add(if is_hidden { repeats } else { 0 });
                // Before it is written again and again.
                if row.length().saturating_mul(repeats) > limit {
                    return Err(InputErrorKind::WorkbookTooLarge { limit });
                }
                for repeat in 0..repeats {
                    row.write(number.saturating_add(repeat), lines)?;
                }
                number = number.saturating_add(row_repeats);
            }
            Event::Eof => break,
            _ => {}
        }
    }
    Ok(())
}

/// A number of rows or columns that is refused where it is too large.
fn short(number: u64) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX - 1)
}

/// Returns whether a row or a column is hidden, or left out by a filter.
fn is_unseen(element: &BytesStart<'_>) -> Result<bool, InputErrorKind> {
    let visibility = attribute_named(element, "table:visibility")?;
    Ok(matches!(visibility.as_deref(), Some("collapse" | "filter")))
}

/// Returns whether a cell takes the place of others.
fn spans(element: &BytesStart<'_>) -> Result<bool, InputErrorKind> {
    let is_wide = repeats(element, "table:number-columns-spanned")? > 1;
    Ok(is_wide || repeats(element, "table:number-rows-spanned")? > 1)
}

/// The attributes of a cell.
struct Cell {
    /// The stored value as text; `None` where the content of the cell is the value.
    stored: Option<String>,
    formula: Option<String>,
    is_error: bool,
    is_text: bool,
}

impl Cell {
    fn begin(element: &BytesStart<'_>, decimal: DecimalMark) -> Result<Self, InputErrorKind> {
        let of = |name| Ok::<_, InputErrorKind>(attribute_named(element, name)?.map(Cow::into_owned));
        let kind = of("office:value-type")?;
        let stored = match kind.as_deref() {
            Some("float" | "percentage" | "currency") => of("office:value")?.map(|value| {
                finite(&value).map_or_else(|| value.clone(), |number| stored_text(number, decimal))
            }),
            Some("date") => of("office:date-value")?,
            Some("time") => of("office:time-value")?.map(|time| clock_text(&time)),
            Some("boolean") => of("office:boolean-value")?.map(|value| value.to_uppercase()),
            Some("string") => of("office:string-value")?,
            _ => None,
        };
        Ok(Cell {
            stored,
            formula: of("table:formula")?,
            is_error: of("calcext:value-type")?.as_deref() == Some("error"),
            is_text: kind.as_deref() == Some("string"),
        })
    }

    /// The cell as a table of text has it, to its end. A formula without a value is its own text.
    fn text(self, part: &mut Part<'_>, limit: u64) -> Result<String, InputErrorKind> {
        let Cell { stored, formula, is_error, is_text } = self;
        // LibreOffice shows an error in the content of an empty text.
        if is_error {
            let shown = paragraphs(part, limit)?;
            return Ok(if shown.is_empty() { "#N/A".to_owned() } else { shown });
        }
        let text = match stored {
            Some(text) => {
                part.skip()?;
                text
            }
            None => paragraphs(part, limit)?,
        };
        Ok(match formula {
            Some(formula) if text.is_empty() && !is_text => {
                format!("={}", formula.split_once('=').map_or(formula.as_str(), |(_, own)| own))
            }
            _ => text,
        })
    }
}

/// The text of the cell that has just begun, a line for each of its paragraphs, without its comments.
fn paragraphs(part: &mut Part<'_>, limit: u64) -> Result<String, InputErrorKind> {
    let (inside, mut text, mut has_begun) = (part.depth(), String::new(), false);
    while part.depth() >= inside {
        let event = part.next()?;
        match &event {
            Event::Start(element) => match element.name().as_ref() {
                "office:annotation" => {
                    drop(event);
                    part.skip()?;
                }
                "text:p" if has_begun => text.push('\n'),
                "text:p" => has_begun = true,
                "text:s" => {
                    let count = repeats(element, "text:c")?;
                    if count > limit {
                        return Err(InputErrorKind::WorkbookTooLarge { limit });
                    }
                    check_text(text.len().saturating_add(count as usize))?;
                    text.extend(std::iter::repeat_n(' ', count as usize));
                }
                "text:tab" => text.push('\t'),
                "text:line-break" => text.push('\n'),
                _ => {}
            },
            Event::Eof => break,
            // Text between the elements of a cell is there for the eye.
            event if has_begun => text.push_str(own_text(event)?.as_deref().unwrap_or_default()),
            _ => {}
        }
        check_text(text.len())?;
    }
    Ok(text)
}

/// The number in an attribute; 1 without it.
fn repeats(element: &BytesStart<'_>, name: &str) -> Result<u64, InputErrorKind> {
    let Some(value) = attribute_named(element, name)? else { return Ok(1) };
    value.trim().parse().map_err(|_| unreadable(format!("{name} is no number")))
}

/// A duration such as `PT01H02M03S` as clocks show it.
fn clock_text(duration: &str) -> String {
    let parts = || {
        let (hours, rest) = duration.strip_prefix("PT")?.split_once('H')?;
        let (minutes, rest) = rest.split_once('M')?;
        Some(format!("{hours}:{minutes}:{}", rest.strip_suffix('S')?))
    };
    parts().unwrap_or_else(|| duration.to_owned())
}
