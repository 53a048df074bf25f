//! Sheets of Excel's `.xlsx` and of OpenDocument's `.ods` as tables of text.
//!
//! A sheet is written as tab-separated text, one line per row, and read by the rules of text. Headers,
//! missing cells and everything else are the same as in a table of text. A number is a double. Its text is
//! the shortest that reads back as that double, so 0.1 is 1/10 under the decimal reading and the double
//! itself under binary64. Numbers have the decimal mark that is asked for, or that of the
//! texts, so that it is about texts alone.

mod archive;
mod formats;
mod ods;
mod text;
mod xlsx;
mod xlsx_book;
mod xlsx_cells;

use std::io::{Cursor, Read};

use boundfit_exact::{DecimalMark, Foreign};
use sha2::{Digest, Sha256};

use crate::budget::HeldMemory;
use crate::columns::ColumnSelector;
use crate::columns::Role;
use crate::doubles::double_text;
use crate::error::{InputError, InputErrorKind};
use crate::hash::hexadecimal;
use crate::memory_use::MemoryUse;
use crate::notes::{SheetLooks, SheetNote, TableNotes};
use crate::packing::most_unpacked;
use crate::quoted_name::in_quotes;
use crate::scan::{Consumer, ScanOptions, Scanned, scan_text};

use archive::{Archive, FORMAT, Kind};
use text::Lines;

/// The most sheets that a workbook may have.
const MOST_SHEETS: usize = 10_000;

/// A sheet as text.
struct Sheet {
    choice: Choice,
    looks: SheetLooks,
    text: Vec<u8>,
    /// The memory of the text.
    memory: HeldMemory,
}

/// Reads a sheet of a workbook as [`scan`](crate::scan) says, by default the first one.
///
/// Exact. Cost: one pass; memory for the file, the texts that cells have by number and the text of the sheet, at most
/// [`SizeLimits::workbook`](crate::SizeLimits) bytes of each, asked for from [`SizeLimits::memory`](crate::SizeLimits).
///
/// # Errors
/// The first thing wrong, with sheet and cell.
pub(crate) fn scan_workbook(
    file: &str,
    bytes: Box<dyn Read>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    consumer: &mut Consumer,
) -> Result<Scanned, InputError> {
    let fail = |problem: InputErrorKind| InputError::of_file(file, problem);
    // The digits that a cell shows are not those that it stores.
    if columns.iter().any(|column| column.role() == Role::HalfUnit) {
        return Err(fail(InputErrorKind::NoDigits { format: FORMAT }));
    }
    let limit = options.table.sizes.workbook;
    let memory = options.table.sizes.memory.nothing();
    let content = whole(bytes, limit, &memory).map_err(fail)?;
    let sha256 = options.hash.then(|| hexadecimal(&Sha256::new_with_prefix(&content)));
    let total = content.len() as u64;
    let wanted = options.table.sheet.as_deref();
    let decimal = options.table.dialect.given_mark();
    let sizes = &options.table.sizes;
    let most = limit.min(most_unpacked(total, sizes.ratio));
    let sheet = sheet_text(content, wanted, decimal, most, memory).map_err(|problem| match problem {
        InputErrorKind::WorkbookTooLarge { .. } if most < limit => {
            InputErrorKind::UnpacksTooFar { ratio: sizes.ratio }
        }
        problem => problem,
    });
    let Sheet { choice, looks, text, memory: _memory } = sheet.map_err(fail)?;
    let mut inner = ScanOptions { hash: false, progress: None, ..options.clone() };
    inner.table.dialect.delimiter = Some(text::DELIMITER);
    inner.table.dialect.encoding = None;
    let scanned = scan_text(file, Box::new(Cursor::new(text)), columns, &inner, consumer);
    let scanned = scanned.map_err(|error| match error.in_sheet(choice.name()) {
        InputError { kind: InputErrorKind::Empty, file, place } => {
            InputError { kind: InputErrorKind::EmptySheet { others: choice.others() }, file, place }
        }
        error => error,
    })?;
    if let Some(progress) = &options.progress {
        progress.advanced(total);
    }
    let table =
        scanned.table.map(|notes| TableNotes { sheet: choice.note(), is_sheet: true, looks, ..notes });
    Ok(Scanned { layout: None, table, bytes: total, sha256, ..scanned })
}

/// The number of bytes of a workbook that are read at a time.
const PIECE: u64 = 1 << 16;

/// The bytes of a workbook, of which there may be so many.
fn whole(mut bytes: Box<dyn Read>, limit: u64, memory: &HeldMemory) -> Result<Vec<u8>, InputErrorKind> {
    let mut content = Vec::new();
    loop {
        memory.ask_for_all(content.len() as u64 + PIECE, MemoryUse::Workbook)?;
        let most = (limit.saturating_add(1)).saturating_sub(content.len() as u64).min(PIECE);
        let count = bytes.by_ref().take(most).read_to_end(&mut content)?;
        if content.len() as u64 > limit {
            return Err(InputErrorKind::WorkbookTooLarge { limit });
        }
        if count == 0 {
            return Ok(content);
        }
    }
}

/// The sheet that is wanted, by its name or its number from 1, or the first one, as text of at most so many bytes. The memory is that
/// of the content.
fn sheet_text(
    content: Vec<u8>,
    wanted: Option<&str>,
    decimal: Option<DecimalMark>,
    limit: u64,
    memory: HeldMemory,
) -> Result<Sheet, InputErrorKind> {
    let budget = memory.budget().clone();
    let mut lines = Lines::new(decimal.unwrap_or_default(), limit, budget.nothing());
    let mut archive = Archive::open(content, limit, memory)?;
    let read_sheet = match archive.kind()? {
        Kind::Xlsx => xlsx::read_sheet,
        Kind::Ods => ods::read_sheet,
    };
    let mut choice = read_sheet(&mut archive, wanted, &mut lines)?;
    // Stored numbers have no mark of their own: they take that of the texts.
    if decimal.is_none() && lines.needs_commas() {
        drop(lines);
        lines = Lines::new(DecimalMark::Comma, limit, budget.nothing());
        choice = read_sheet(&mut archive, wanted, &mut lines)?;
    }
    drop(archive);
    let looks = lines.looks();
    let (text, memory) = lines.finish()?;
    Ok(Sheet { choice, looks, text, memory })
}

/// A sheet in the list of a workbook.
struct Listed {
    name: String,
    is_hidden: bool,
}

/// The sheets of a workbook, and which one is read.
struct Choice {
    sheets: Vec<Listed>,
    /// The index of the sheet, from 0.
    index: usize,
    is_asked: bool,
}

impl Choice {
    /// Returns the name of the sheet.
    fn name(&self) -> &str {
        self.sheets.get(self.index).map_or("", |sheet| sheet.name.as_str())
    }

    /// Returns the sheet for reports, if there are several.
    fn note(&self) -> Option<SheetNote> {
        let &Choice { ref sheets, index, is_asked } = self;
        let Listed { name, is_hidden } = sheets.get(index).filter(|_| sheets.len() > 1)?;
        let (name, is_hidden) = (name.as_str().into(), *is_hidden);
        Some(SheetNote { name, number: index + 1, total: sheets.len(), is_hidden, is_asked })
    }

    /// Returns the names of the other sheets.
    fn others(&self) -> Vec<Foreign> {
        let others = self.sheets.iter().enumerate().filter(|(index, _)| *index != self.index);
        others.map(|(_, sheet)| sheet.name.as_str().into()).collect()
    }
}

/// Chooses the wanted sheet.
fn chosen(sheets: Vec<Listed>, wanted: Option<&str>) -> Result<Choice, InputErrorKind> {
    let position = |wanted: &str| sheets.iter().position(|sheet| sheet.name == wanted);
    let found = match wanted {
        None => (!sheets.is_empty()).then_some(0),
        Some(wanted) => {
            let numbered = wanted.parse().ok().and_then(|number: usize| number.checked_sub(1));
            let numbered = numbered.filter(|&index| index < sheets.len());
            match (position(wanted), numbered) {
                (Some(named), Some(numbered)) if named != numbered => {
                    let (wanted, named) = (wanted.into(), named + 1);
                    return Err(InputErrorKind::SheetNameOrNumber { wanted, named });
                }
                (named, numbered) => named.or(numbered).or_else(|| position(in_quotes(wanted)?)),
            }
        }
    };
    match found {
        Some(index) => Ok(Choice { sheets, index, is_asked: wanted.is_some() }),
        None => Err(InputErrorKind::UnknownSheet {
            wanted: wanted.unwrap_or("1").into(),
            available: sheets.iter().map(|sheet| sheet.name.as_str().into()).collect(),
        }),
    }
}

/// Returns a stored double as text with this decimal mark.
fn stored_text(number: f64, decimal: DecimalMark) -> String {
    let text = double_text(number);
    match decimal {
        DecimalMark::Point => text,
        DecimalMark::Comma => text.replace('.', ","),
    }
}

/// The double that a cell stores as this text; `None` where that is none.
fn finite(text: &str) -> Option<f64> {
    let text = text.trim();
    let is_number = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    text.parse().ok().filter(|number: &f64| is_number && number.is_finite())
}
