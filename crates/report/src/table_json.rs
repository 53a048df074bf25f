//! What a table was taken for: the part `input.table` of all documents about readings, and the line of reports.

use boundfit_estimation::Measurements;
use boundfit_exact::Foreign;
#[cfg(feature = "files")]
use boundfit_formats::{BlockNote, DELIMITERS, Dialect, TableNotes};
use boundfit_questions::LinearityInput;
use serde::Serialize;

use crate::document::Text;

/// What a table of text, or a sheet, was taken for.
#[derive(Debug, Serialize)]
pub struct TableJson {
    header: HeaderJson,
    /// `comma`, `semicolon`, `tab`, `space`, `pipe` or the character; null of a sheet and of records.
    delimiter: Option<String>,
    decimal: &'static str,
    thousands: Option<&'static str>,
    /// Null of a sheet.
    encoding: Option<&'static str>,
    /// With which characters lines start that are passed over.
    comment: Option<String>,
    /// Null where there is one block.
    blocks: Option<BlocksJson>,
    skipped: SkippedJson,
}

/// What names the columns.
#[derive(Debug, Serialize)]
struct HeaderJson {
    line: Option<u64>,
    comment: bool,
    open: bool,
    row_names: bool,
}

#[derive(Debug, Serialize)]
struct BlocksJson {
    total: usize,
    /// Null where all were read.
    read: Option<usize>,
    name: Option<Foreign>,
}

#[derive(Debug, Serialize)]
struct SkippedJson {
    lines: u64,
    comments: u64,
    short_rows: u64,
    long_rows: u64,
}

#[cfg(feature = "files")]
impl TableJson {
    /// Of these notes.
    pub fn new(notes: &TableNotes) -> Self {
        let TableNotes { header, dialect, is_sheet, is_records, block, skipped } = notes;
        let Dialect { delimiter, notation, comment, encoding, .. } = dialect;
        let named = DELIMITERS.iter().find(|(_, byte)| byte == delimiter);
        let delimiter =
            named.map_or_else(|| char::from(*delimiter).to_string(), |(name, _)| (*name).to_owned());
        let marks = comment.map(|[one, other]| {
            let marks: &[u8] = if one == other { &[one] } else { &[one, other] };
            marks.iter().map(|&mark| char::from(mark)).collect()
        });
        TableJson {
            header: HeaderJson {
                line: header.line,
                comment: header.is_comment,
                open: header.is_open,
                row_names: header.has_row_names,
            },
            delimiter: (!is_sheet && !is_records).then_some(delimiter),
            decimal: notation.decimal.name(),
            thousands: notation.thousands.map(|mark| mark.mark()),
            encoding: (!is_sheet).then(|| encoding.name()),
            comment: marks,
            blocks: block.as_ref().map(|BlockNote { number, name, total }| BlocksJson {
                total: *total,
                read: *number,
                name: name.clone(),
            }),
            skipped: SkippedJson {
                lines: skipped.lines,
                comments: skipped.comments,
                short_rows: skipped.short_rows,
                long_rows: skipped.long_rows,
            },
        }
    }

    /// What the table of these readings was taken for.
    pub fn of_measurements(measurements: &Measurements) -> Option<Self> {
        measurements.table().map(TableJson::new)
    }

    /// What the table of a calibration was taken for.
    pub(crate) fn of_input(input: &LinearityInput) -> Option<Self> {
        input.table.as_ref().map(TableJson::new)
    }
}

/// Without files there are no tables of text.
#[cfg(not(feature = "files"))]
impl TableJson {
    /// Nothing.
    pub fn of_measurements(_: &Measurements) -> Option<Self> {
        None
    }

    pub(crate) fn of_input(_: &LinearityInput) -> Option<Self> {
        None
    }
}

/// The part `input` of a line of a report that has many: what is the same for all of them.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct LineInputJson<'a> {
    pub(crate) table: Option<&'a TableJson>,
}

/// What is not plain about a table as a line of text, with its line end; nothing where all is.
#[cfg(feature = "files")]
pub fn table_line(table: Option<&TableNotes>) -> String {
    table.and_then(TableNotes::words).map_or_else(String::new, |words| format!("Table: {words}\n"))
}

/// What is not plain about the table of these readings, in words.
#[cfg(feature = "files")]
pub(crate) fn table_words(measurements: &Measurements) -> Option<Text> {
    measurements.table().and_then(TableNotes::words).map(Text::from)
}

/// What is not plain about the table of a calibration, in words.
#[cfg(feature = "files")]
pub(crate) fn words_of_input(input: &LinearityInput) -> Option<Text> {
    input.table.as_ref().and_then(TableNotes::words).map(Text::from)
}

#[cfg(not(feature = "files"))]
pub(crate) fn table_words(_: &Measurements) -> Option<Text> {
    None
}

#[cfg(not(feature = "files"))]
pub(crate) fn words_of_input(_: &LinearityInput) -> Option<Text> {
    None
}
