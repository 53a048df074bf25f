//! The detected format of a table of text, or of a sheet: what a report says of it, so that no guess goes unsaid.

use boundfit_exact::{DecimalMark, Foreign};

use crate::dialect::{BLANKS, Dialect, Encoding};

/// The detected format of a table of text, or of a sheet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableNotes {
    /// The sheet that was read, of a workbook with several sheets.
    pub sheet: Option<SheetNote>,
    /// The line that names the columns.
    pub header: HeaderNote,
    /// The dialect of the text; for a sheet the delimiter and the encoding mean nothing.
    pub dialect: Dialect,
    /// `true` if the table is a sheet of a workbook, whose rows are then the lines.
    pub is_sheet: bool,
    /// The parts of a sheet that look different from what is read.
    pub looks: SheetLooks,
    /// `true` if the table is records of JSON, whose keys are the names; then the delimiter means nothing.
    pub is_records: bool,
    /// `true` if the comma that was taken for a decimal one may as well group digits: `60,323`.
    pub is_comma_open: bool,
    /// The block that was read, for a file with several blocks.
    pub block: Option<BlockNote>,
    /// Skipped lines, and rows that differ from the first one.
    pub skipped: Skipped,
}

/// The line that names the columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct HeaderNote {
    /// The line with the names, from 1; `None` where there are none.
    pub line: Option<u64>,
    /// `true` if that line is a comment, or a row that begins as one.
    pub is_comment: bool,
    /// `true` if nothing but its cells told whether the first line is a header, and it could be the other as well.
    pub is_open: bool,
    /// `true` if the name of a column that was asked for is a number, or there is none.
    pub has_numbers: bool,
    /// `true` if the rows have a cell more than the header, which is their name.
    pub has_row_names: bool,
    /// The line of the units that were passed over, where that was asked for.
    pub units: Option<u64>,
}

/// A sheet of a workbook.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SheetNote {
    /// The sheet's name.
    pub name: Foreign,
    /// The sheet's number, from 1.
    pub number: usize,
    /// The number of sheets.
    pub total: usize,
    /// `true` if spreadsheets do not show it.
    pub is_hidden: bool,
    /// `true` if it was asked for, by its name or its number.
    pub is_asked: bool,
}

/// The parts of a sheet that look different from what is read: hidden rows and columns are read as all others, filtered ones too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SheetLooks {
    /// Rows with a cell that is not empty which spreadsheets do not show.
    pub hidden_rows: u64,
    /// Columns up to the last one of any row which spreadsheets do not show.
    pub hidden_columns: u64,
    /// Areas of merged cells, of which the first cell alone has the value.
    pub merged: u64,
}

impl SheetLooks {
    fn words(self) -> impl Iterator<Item = String> {
        let SheetLooks { hidden_rows, hidden_columns, merged } = self;
        [
            counted(hidden_rows, "hidden row is read", "hidden rows are read"),
            counted(hidden_columns, "hidden column is read", "hidden columns are read"),
            counted(
                merged,
                "area of merged cells has its value in the first cell alone",
                "areas of merged cells have their values in the first cell alone",
            ),
        ]
        .into_iter()
        .flatten()
    }
}

/// Returns words for a number of things; `None` for 0.
fn counted(count: u64, one: &str, many: &str) -> Option<String> {
    (count > 0).then(|| format!("{count} {}", if count == 1 { one } else { many }))
}

/// A block of a file that has several.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BlockNote {
    /// The block's number, from 1; `None` where all blocks were read.
    pub number: Option<usize>,
    /// The block's name: the comment before it.
    pub name: Option<Foreign>,
    /// The number of blocks.
    pub total: usize,
}

/// Skipped lines, and rows that differ from the first one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Skipped {
    /// Lines before the table that nobody asked to pass over: the names stand in a later one.
    pub lines: u64,
    /// Lines between rows, or behind them, that are comments.
    pub comments: u64,
    /// Rows with fewer cells than the first one, which end before a cell that is not empty there.
    pub short_rows: u64,
    /// Rows with more cells than the first one, all of which are empty.
    pub long_rows: u64,
    /// Rows that repeat the header, where all blocks are read.
    pub headers: u64,
}

impl Skipped {
    /// Adds what was met in later rows.
    pub(crate) fn add(&mut self, later: Skipped) {
        self.lines += later.lines;
        self.comments += later.comments;
        self.short_rows += later.short_rows;
        self.long_rows += later.long_rows;
        self.headers += later.headers;
    }
}

impl TableNotes {
    /// Returns what is unusual about the cells of reductions, whose lines in front say all else; `None` if nothing is.
    pub fn of_reductions(self) -> Option<Self> {
        let (header, block, skipped) =
            (HeaderNote { line: self.header.line, ..HeaderNote::default() }, None, Skipped::default());
        Some(TableNotes { header, block, skipped, ..self }).filter(|own| own.words().is_some())
    }

    /// Returns words for the unusual properties of the table. The usual table has names in its first line,
    /// numbers with points, and commas, semicolons or tabs between them.
    pub fn words(&self) -> Option<String> {
        let words: Vec<String> =
            [self.sheet_words(), self.header_words(), self.units_words(), self.block_words()]
                .into_iter()
                .flatten()
                .chain(self.skipped_words())
                .chain(self.looks.words())
                .collect();
        let words: Vec<String> = words.into_iter().chain(self.written_words()).collect();
        (!words.is_empty()).then(|| words.join(", "))
    }

    /// Returns whether something about the table was guessed: its sheet, which line has the names, which rows belong to it, the
    /// meaning of a comma. The rest of the way in which the table is written is detected where that is safe, and not guessed.
    pub fn has_guesses(&self) -> bool {
        self.header_words().is_some()
            || self.sheet.as_ref().is_some_and(|sheet| !sheet.is_asked)
            || self.block.is_some()
            || !self.skipped_words().is_empty()
            || self.looks != SheetLooks::default()
            || self.is_comma_open
    }

    fn sheet_words(&self) -> Option<String> {
        let SheetNote { name, number, total, is_hidden, .. } = self.sheet.as_ref()?;
        let hidden = if *is_hidden { ", hidden" } else { "" };
        Some(format!("sheet {number} of {total} ({}{hidden})", name.quoted()))
    }

    fn header_words(&self) -> Option<String> {
        let HeaderNote { line, is_comment, is_open, has_numbers, .. } = self.header;
        let what = if self.is_sheet { "row" } else { "line" };
        match line {
            None if is_open && self.is_records => {
                Some("no header, the first array is a reading (else header yes)".to_owned())
            }
            None if is_open => Some(format!("no header, the first {what} is a reading (else header yes)")),
            None => None,
            Some(line) if is_comment => Some(format!("names in the comment of {what} {line}")),
            Some(line) if is_open => Some(format!("header in {what} {line} (else header no)")),
            Some(line) if has_numbers || self.skipped.lines > 0 => Some(format!("header in {what} {line}")),
            Some(_) => None,
        }
    }

    fn units_words(&self) -> Option<String> {
        let what = if self.is_sheet { "row" } else { "line" };
        self.header.units.map(|line| format!("units in {what} {line}"))
    }

    fn block_words(&self) -> Option<String> {
        let BlockNote { number, name, total } = self.block.as_ref()?;
        Some(match (number, name) {
            (None, _) => format!("all {total} blocks"),
            (Some(number), None) => format!("block {number} of {total}"),
            (Some(number), Some(name)) => format!("block {number} of {total} ({name})"),
        })
    }

    fn skipped_words(&self) -> Vec<String> {
        let Skipped { comments, short_rows, headers, .. } = self.skipped;
        // The blocks account for lines that begin blocks.
        let unsaid = if self.block.is_some() { 0 } else { comments };
        let found = [
            self.header.has_row_names.then(|| {
                // Without quotes `0,1,5` is the row 0 of R, or 0 and 1,5.
                let is_open = self.dialect.delimiter == b',' && !self.is_sheet && !self.is_records;
                let unless = if is_open { " (unless commas are decimal marks)" } else { "" };
                format!("names of rows in column 1{unless}")
            }),
            counted(comments.min(unsaid), "comment line between rows", "comment lines between rows"),
            counted(headers, "header repeated", "headers repeated"),
            counted(short_rows, "row shorter than the first", "rows shorter than the first"),
        ];
        found.into_iter().flatten().collect()
    }

    /// Returns words for the unusual properties of the text's dialect.
    fn written_words(&self) -> Vec<String> {
        let Dialect { delimiter, notation, encoding, .. } = self.dialect;
        let (separator, is_usual) = match delimiter {
            b',' => ("commas", true),
            b';' => ("semicolons", true),
            b'\t' => ("tabs", true),
            b'|' => ("bars", false),
            BLANKS => ("blanks", false),
            _ => ("other characters", true),
        };
        let mut words = Vec::new();
        if notation.decimal == DecimalMark::Comma {
            words.push("decimal comma".to_owned());
        }
        if let Some(thousands) = notation.thousands {
            words.push(format!("digits grouped by {:?}", thousands.mark()));
        }
        if !(self.is_sheet || self.is_records || words.is_empty() && is_usual) {
            words.push(format!("separated by {separator}"));
        }
        if encoding != Encoding::Utf8 {
            words.push(encoding.name().to_owned());
        }
        words
    }
}
