//! Sheets of Excel's `.xlsx` and of OpenDocument's `.ods` as tables of text.
//!
//! A sheet is written as tab-separated text, one line per row, and read by the rules of text. Headers,
//! missing cells and everything else are the same as in a table of text. A number is a double. Its text is
//! the shortest that reads back as that double, so 0.1 is 1/10 under the decimal reading and the double
//! itself under binary64.

mod archive;
mod formats;
mod ods;
mod text;
mod xlsx;
mod xlsx_book;
mod xlsx_cells;

use std::io::{Cursor, Read};

use boundfit_exact::Foreign;
use sha2::{Digest, Sha256};

use crate::budget::HeldMemory;
use crate::columns::ColumnSelector;
use crate::columns::Role;
use crate::error::{InputError, InputErrorKind};
use crate::hash::hexadecimal;
use crate::memory_use::MemoryUse;
use crate::notes::TableNotes;
use crate::packing::most_unpacked;
use crate::scan::{Batch, ScanOptions, Scanned, scan_text};

use archive::{Archive, FORMAT, Kind};
use text::Lines;

/// The most sheets that a workbook may have.
const MOST_SHEETS: usize = 10_000;

/// A sheet as text.
struct Sheet {
    name: String,
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
pub(crate) fn scan_workbook<T: Send>(
    file: &str,
    bytes: Box<dyn Read>,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    work: impl Fn(Batch) -> T + Sync,
    take: impl FnMut(T),
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
    let sizes = &options.table.sizes;
    let most = limit.min(most_unpacked(total, sizes.ratio));
    let sheet = sheet_text(content, wanted, most, memory).map_err(|problem| match problem {
        InputErrorKind::WorkbookTooLarge { .. } if most < limit => {
            InputErrorKind::UnpacksTooFar { ratio: sizes.ratio }
        }
        problem => problem,
    });
    let Sheet { name, text, memory: _memory } = sheet.map_err(fail)?;
    let mut inner = ScanOptions { hash: false, progress: None, ..options.clone() };
    inner.table.dialect.delimiter = Some(text::DELIMITER);
    let scanned = scan_text(file, Box::new(Cursor::new(text)), columns, &inner, work, take);
    let scanned = scanned.map_err(|error| error.in_sheet(&name))?;
    if let Some(progress) = &options.progress {
        progress.advanced(total);
    }
    let table = scanned.table.map(|notes| TableNotes { is_sheet: true, ..notes });
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
    limit: u64,
    memory: HeldMemory,
) -> Result<Sheet, InputErrorKind> {
    let mut lines = Lines::new(limit, memory.budget().nothing());
    let mut archive = Archive::open(content, limit, memory)?;
    let name = match archive.kind()? {
        Kind::Xlsx => xlsx::read_sheet(&mut archive, wanted, &mut lines)?,
        Kind::Ods => ods::read_sheet(&mut archive, wanted, &mut lines)?,
    };
    drop(archive);
    let (text, memory) = lines.finish()?;
    Ok(Sheet { name, text, memory })
}

/// Returns the index of the wanted sheet, from 0.
fn chosen(names: &[&str], wanted: Option<&str>) -> Result<usize, InputErrorKind> {
    let found = match wanted {
        None => (!names.is_empty()).then_some(0),
        Some(wanted) => names.iter().position(|name| *name == wanted).or_else(|| {
            let number: usize = wanted.parse().ok()?;
            number.checked_sub(1).filter(|&index| index < names.len())
        }),
    };
    found.ok_or_else(|| InputErrorKind::UnknownSheet {
        wanted: wanted.unwrap_or("1").into(),
        available: names.iter().map(|&name| Foreign::from(name)).collect(),
    })
}

/// The double that a cell stores as this text; `None` where that is none.
fn finite(text: &str) -> Option<f64> {
    let text = text.trim();
    let is_number = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    text.parse().ok().filter(|number: &f64| is_number && number.is_finite())
}
