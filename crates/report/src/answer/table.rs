//! How a table was read: its header, dialect and what was passed over.

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::parts::is_zero;

/// The detected format of a table of text, JSON or a sheet.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TableJson {
    /// The line that names the columns.
    pub header: HeaderJson,
    /// `comma`, `semicolon`, `tab`, `space`, `pipe` or the character; null for sheets and JSON.
    pub delimiter: Option<String>,
    /// The decimal mark.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["point", "comma"])))]
    pub decimal: &'static str,
    /// True if the comma that was taken for the decimal mark may as well group digits; absent otherwise.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub decimal_open: bool,
    /// The character that groups digits; null where there is none.
    pub thousands: Option<&'static str>,
    /// The encoding of the text, such as `UTF-8`; null for sheets.
    pub encoding: Option<&'static str>,
    /// The characters that start a comment line; null where there are none.
    pub comment: Option<String>,
    /// The sheet of a workbook; absent for other files.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sheet: Option<SheetJson>,
    /// The blocks of the file, and which was read; null for a file of one block.
    pub blocks: Option<BlocksJson>,
    /// The lines and rows that are unusual.
    pub skipped: SkippedJson,
}

/// The line that names the columns.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HeaderJson {
    /// The number of the line, or of the row of a sheet; null without names.
    pub line: Option<u64>,
    /// True if that line is a comment, or a row that begins as one.
    pub comment: bool,
    /// True if nothing told a header from a reading: every cell of the first line that is used is a number or missing.
    pub open: bool,
    /// True if each row begins with a name, so that it has a cell more than the header.
    pub row_names: bool,
}

/// The sheet that was read, and what a spreadsheet shows otherwise.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SheetJson {
    /// The name of the sheet; null in a workbook of one sheet.
    pub name: Option<Foreign>,
    /// The number of the sheet, from 1.
    pub number: usize,
    /// The number of sheets in the workbook.
    pub total: usize,
    /// True if spreadsheets do not show the sheet.
    pub hidden: bool,
    /// The number of rows that were read although spreadsheets do not show them.
    pub hidden_rows: u64,
    /// The number of columns that spreadsheets do not show.
    pub hidden_columns: u64,
    /// The number of areas of merged cells. Their first cell alone has a value.
    pub merged: u64,
}

/// The blocks of a file.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BlocksJson {
    /// The number of blocks in the file.
    pub total: usize,
    /// The number of the block that was read, from 1; null where all were.
    pub read: Option<usize>,
    /// The name of that block; null where it has none.
    pub name: Option<Foreign>,
}

/// Lines that were passed over, and rows of another length.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SkippedJson {
    /// Lines before the table that were skipped because the names stand in a later one.
    pub lines: u64,
    /// Comment lines between rows.
    pub comments: u64,
    /// Rows with fewer cells than the first one.
    pub short_rows: u64,
    /// Rows with more cells than the first one.
    pub long_rows: u64,
    /// Rows that repeat the header; absent if there are none.
    #[serde(skip_serializing_if = "is_zero")]
    pub headers: u64,
}
