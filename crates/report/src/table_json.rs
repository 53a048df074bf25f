//! The detected format of the table: the part `input.table` of all documents about readings, and the line of reports.

use boundfit_estimation::Measurements;
use boundfit_exact::english::counted;
#[cfg(feature = "files")]
use boundfit_formats::{BlockNote, DELIMITERS, Dialect, TableNotes};
use boundfit_questions::LinearityInput;

use crate::answer::table::TableJson;
#[cfg(feature = "files")]
use crate::answer::table::{BlocksJson, HeaderJson, SheetJson, SkippedJson};
use crate::document::Text;

#[cfg(feature = "files")]
impl TableJson {
    /// Returns the description in these notes.
    pub fn new(notes: &TableNotes) -> Self {
        let TableNotes { header, dialect, is_sheet, is_records, block, skipped, sheet, looks, is_comma_open } =
            notes;
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
            decimal_open: *is_comma_open,
            thousands: notation.thousands.map(|mark| mark.mark()),
            encoding: (!is_sheet).then(|| encoding.name()),
            comment: marks,
            sheet: is_sheet.then(|| SheetJson {
                name: sheet.as_ref().map(|sheet| sheet.name.clone()),
                number: sheet.as_ref().map_or(1, |sheet| sheet.number),
                total: sheet.as_ref().map_or(1, |sheet| sheet.total),
                hidden: sheet.as_ref().is_some_and(|sheet| sheet.is_hidden),
                hidden_rows: looks.hidden_rows,
                hidden_columns: looks.hidden_columns,
                merged: looks.merged,
            }),
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
                headers: skipped.headers,
            },
        }
    }

    /// Returns the detected format of the table of these readings.
    pub fn of_measurements(measurements: &Measurements) -> Option<Self> {
        measurements.table().map(TableJson::new)
    }

    /// Returns the detected format of the table of a calibration.
    pub(crate) fn of_input(input: &LinearityInput) -> Option<Self> {
        input.table.as_ref().map(TableJson::new)
    }
}

/// A build without files has no tables of text.
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

/// Returns the unusual features of a table as a line of text, with its line end; nothing for a plain table.
#[cfg(feature = "files")]
pub fn table_line(table: Option<&TableNotes>) -> String {
    table.and_then(TableNotes::words).map_or_else(String::new, |words| format!("Table: {words}\n"))
}

/// Returns how many rows are left out since they lack a number, in words; nothing where none is.
pub fn rows_left_out(rows: usize) -> Option<String> {
    (rows > 0).then(|| format!("{} with missing values left out", counted(rows, "row", "rows")))
}

/// Returns the unusual features of the table of these readings, in words.
#[cfg(feature = "files")]
pub(crate) fn table_words(measurements: &Measurements) -> Option<Text> {
    measurements.table().and_then(TableNotes::words).map(Text::from)
}

/// Returns the unusual features of the table of a calibration, in words.
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

/// Returns the first and the last of rows that follow each other without a gap.
pub fn row_ranges(rows: impl IntoIterator<Item = usize>) -> Vec<[usize; 2]> {
    let mut ranges: Vec<[usize; 2]> = Vec::new();
    for row in rows {
        match ranges.last_mut() {
            Some([_, last]) if *last + 1 == row => *last = row,
            _ => ranges.push([row, row]),
        }
    }
    ranges
}
