//! Sheets of Excel's `.xlsx` and of OpenDocument's `.ods` as tables of text.
//!
//! A sheet is written as tab-separated text, one line for each of its rows, and read by the rules of text: headers, missing
//! cells and everything else are those of a table of text. A number is a double; its text is the shortest that reads back as
//! that double, so that 0.1 is 1/10 under the decimal reading and the double itself under binary64.

mod cells;
mod measure;
mod text;

use std::io::{Cursor, Read};
use std::panic::{AssertUnwindSafe, catch_unwind};

use sha2::{Digest, Sha256};

use crate::columns::ColumnSelector;
use crate::error::{InputError, InputErrorKind};
use crate::hash::hexadecimal;
use crate::limits::most_unpacked;
use crate::roles::Role;
use crate::scan::{Batch, ScanOptions, Scanned, scan_text};

use cells::sheet_text;
use measure::measure;

/// What messages call such files.
const FORMAT: &str = "a workbook";

/// The two kinds of workbooks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Office Open XML.
    Xlsx,
    /// OpenDocument.
    Ods,
}

/// A sheet as text.
struct Sheet {
    name: String,
    text: Vec<u8>,
}

/// Reads a sheet of a workbook as [`scan`](crate::scan) says, by default the first one.
///
/// Exact. Cost: one pass; memory for what the file unpacks to, at most [`SizeLimits::workbook`](crate::SizeLimits) bytes of
/// each of the file, its parts and the text of the sheet.
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
    let mut content = Vec::new();
    bytes.take(limit.saturating_add(1)).read_to_end(&mut content).map_err(|error| fail(error.into()))?;
    if content.len() as u64 > limit {
        return Err(fail(InputErrorKind::WorkbookTooLarge { limit }));
    }
    let sha256 = options.hash.then(|| hexadecimal(&Sha256::new_with_prefix(&content)));
    let total = content.len() as u64;
    let wanted = options.table.sheet.as_deref();
    let sizes = &options.table.sizes;
    let most = limit.min(most_unpacked(total, sizes.ratio));
    let sheet = guarded(|| {
        let kind = measure(&content, most)?;
        sheet_text(kind, content, wanted, most)
    });
    let sheet = sheet.map_err(|problem| match problem {
        InputErrorKind::WorkbookTooLarge { .. } if most < limit => {
            InputErrorKind::UnpacksTooFar { ratio: sizes.ratio }
        }
        problem => problem,
    });
    let Sheet { name, text } = sheet.map_err(fail)?;
    let mut inner = ScanOptions { hash: false, progress: None, ..options.clone() };
    inner.table.dialect.delimiter = Some(text::DELIMITER);
    let scanned = scan_text(file, Box::new(Cursor::new(text)), columns, &inner, work, take);
    let scanned = scanned.map_err(|error| error.in_sheet(&name))?;
    if let Some(progress) = &options.progress {
        progress.advanced(total);
    }
    Ok(Scanned { layout: None, bytes: total, sha256, ..scanned })
}

/// Lets the libraries work. That one of them crashes on a damaged file is an error like the others.
fn guarded<T>(work: impl FnOnce() -> Result<T, InputErrorKind>) -> Result<T, InputErrorKind> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Err(unreadable("it is damaged")))
}

/// What a library says about a workbook that it cannot read.
fn unreadable(reason: impl ToString) -> InputErrorKind {
    InputErrorKind::Unreadable { format: FORMAT, reason: reason.to_string().into() }
}
