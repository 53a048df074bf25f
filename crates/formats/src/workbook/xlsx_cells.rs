//! The cells of a sheet of `.xlsx`.

use boundfit_exact::{DecimalMark, Foreign};
use quick_xml::events::{BytesStart, Event};

use super::archive::{Part, attribute, unreadable};
use super::finite;
use super::text::Lines;
use super::xlsx_book::{Book, is_set, rich_text, unescaped};
use crate::error::InputErrorKind;

/// The value stored in a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stored {
    Number,
    /// The number of a text of the workbook.
    SharedText,
    /// A text in the cell, beside its value.
    InlineText,
    /// The text that a formula gave.
    Text,
    Truth,
    /// An error or a date, as it is shown.
    Shown,
}

/// A cell, as its element begins.
struct Cell {
    row: u32,
    column: u32,
    stored: Stored,
    /// The number of its format.
    style: usize,
}

/// The content of a cell.
#[derive(Default)]
struct Content {
    formula: Option<String>,
    value: String,
    inline: String,
}

/// Hands over the cells of a sheet, and what of it is hidden or merged. The stated size of the sheet is not used.
pub(super) fn read_cells(part: &mut Part<'_>, book: &Book, lines: &mut Lines) -> Result<(), InputErrorKind> {
    let (mut row, mut column, mut has_begun) = (0, 0, false);
    let mut is_hidden = false;
    loop {
        let event = part.next()?;
        let cell = match &event {
            Event::Start(element) => match element.local_name().as_ref() {
                "sheetData" => {
                    has_begun = true;
                    None
                }
                "col" if !has_begun => {
                    hide_columns(element, lines)?;
                    None
                }
                "mergeCell" => {
                    lines.merged += 1;
                    None
                }
                "row" if has_begun => {
                    column = 0;
                    is_hidden = is_set(element, "hidden")?;
                    if let Some(number) = attribute(element, "r")? {
                        row = row_of(&number).ok_or_else(|| no_cell(&number))?;
                    }
                    None
                }
                "c" if has_begun => Some(Cell::begin(element, row, column)?),
                _ => None,
            },
            Event::End(element) => match element.local_name().as_ref() {
                // Nothing but the list of merged cells is wanted behind them.
                "sheetData" => {
                    has_begun = false;
                    None
                }
                "row" => {
                    row = row.saturating_add(1);
                    None
                }
                _ => None,
            },
            Event::Eof => return Ok(()),
            _ => None,
        };
        drop(event);
        if let Some(cell) = cell {
            if let Some(text) = book.text(&cell, Content::read(part)?, lines.decimal)? {
                lines.push(cell.row, cell.column, &text)?;
                lines.notice(cell.stored != Stored::Number, &text);
                // Once for each row.
                lines.hidden_rows += u64::from(std::mem::take(&mut is_hidden));
            }
            (row, column) = (cell.row, cell.column.saturating_add(1));
        }
    }
}

/// Notices columns that are hidden.
fn hide_columns(element: &BytesStart<'_>, lines: &mut Lines) -> Result<(), InputErrorKind> {
    if is_set(element, "hidden")? {
        let column =
            |name| Ok::<_, InputErrorKind>(attribute(element, name)?.and_then(|number| row_of(&number)));
        if let Some((first, last)) = column("min")?.zip(column("max")?) {
            lines.hide_columns(first, last);
        }
    }
    Ok(())
}

impl Cell {
    /// A cell that says where it is, or comes next.
    fn begin(element: &BytesStart<'_>, row: u32, column: u32) -> Result<Self, InputErrorKind> {
        let place = attribute(element, "r")?;
        let place = place.map(|text| place_of(&text).ok_or_else(|| no_cell(&text))).transpose()?;
        let (row, column) = place.unwrap_or((row, column));
        let stored = match attribute(element, "t")?.as_deref() {
            Some("s") => Stored::SharedText,
            Some("inlineStr" | "is") => Stored::InlineText,
            Some("str") => Stored::Text,
            Some("b") => Stored::Truth,
            Some("e" | "d") => Stored::Shown,
            _ => Stored::Number,
        };
        let style = attribute(element, "s")?.and_then(|style| style.parse().ok());
        Ok(Cell { row, column, stored, style: style.unwrap_or_default() })
    }
}

impl Content {
    /// Reads the attributes of the cell that has just begun.
    fn read(part: &mut Part<'_>) -> Result<Self, InputErrorKind> {
        let (inside, mut content) = (part.depth(), Content::default());
        while part.depth() >= inside {
            let event = part.next()?;
            let name = match &event {
                Event::Start(element) => element.local_name().as_ref().to_owned(),
                Event::Eof => break,
                _ => continue,
            };
            drop(event);
            match name.as_str() {
                "f" => content.formula = Some(part.text()?),
                "v" => content.value = part.text()?,
                "is" => content.inline = rich_text(part)?,
                _ => part.skip()?,
            }
        }
        Ok(content)
    }
}

impl Book {
    /// A cell as a table of text has it; nothing where it is empty. A formula without a value is its own text.
    fn text(
        &self,
        cell: &Cell,
        content: Content,
        decimal: DecimalMark,
    ) -> Result<Option<String>, InputErrorKind> {
        let Content { formula, value, inline } = content;
        let is_unknown = value.is_empty() || self.is_recalculated && value == "0";
        if let Some(formula) = formula.filter(|_| is_unknown && cell.stored != Stored::Text) {
            return Ok(Some(format!("={formula}")));
        }
        let text = match cell.stored {
            _ if !inline.is_empty() => inline,
            Stored::InlineText => String::new(),
            _ if value.is_empty() => String::new(),
            Stored::SharedText => {
                let text = value.trim().parse().ok().and_then(|index| self.texts.get(index));
                text.ok_or_else(|| no_text(&value))?.to_owned()
            }
            Stored::Text => unescaped(value),
            Stored::Shown => value,
            Stored::Truth => match value.trim() {
                "0" | "false" => "FALSE".to_owned(),
                "1" | "true" => "TRUE".to_owned(),
                _ => value,
            },
            Stored::Number => match finite(&value) {
                Some(number) => {
                    let shows = self.shows.get(cell.style).copied().unwrap_or_default();
                    shows.text(number, decimal, self.counts_from_1904)
                }
                None => value,
            },
        };
        Ok(Some(text).filter(|text| !text.is_empty()))
    }
}

/// The row and the column of a reference such as `B7`, from 0.
fn place_of(reference: &str) -> Option<(u32, u32)> {
    let letters = reference.bytes().take_while(u8::is_ascii_alphabetic).count();
    let (column, row) = reference.split_at_checked(letters)?;
    if !(1..=3).contains(&letters) {
        return None;
    }
    let value = |letter: u8| u32::from(letter.to_ascii_uppercase() - b'A') + 1;
    let column = column.bytes().fold(0, |column, letter| column * 26 + value(letter));
    Some((row_of(row)?, column - 1))
}

/// A row by its number, from 0.
fn row_of(number: &str) -> Option<u32> {
    let is_short = (1..=7).contains(&number.len()) && number.bytes().all(|byte| byte.is_ascii_digit());
    number.parse::<u32>().ok().filter(|_| is_short)?.checked_sub(1)
}

fn no_cell(reference: &str) -> InputErrorKind {
    unreadable(format!("{} names no cell", Foreign::of(reference).quoted()))
}

fn no_text(number: &str) -> InputErrorKind {
    unreadable(format!("a cell has the text number {}, which there is not", Foreign::of(number).quoted()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_name_cells() {
        for (text, place) in [
            ("A1", Some((0, 0))),
            ("b7", Some((6, 1))),
            ("XFD1048576", Some((1_048_575, 16_383))),
            ("ABCDEFGH4", None),
            ("A99999999999", None),
            ("A0", None),
            ("A", None),
            ("7", None),
            ("A-1", None),
            ("\u{c4}1", None),
        ] {
            assert_eq!(place_of(text), place, "{text}");
        }
    }
}
