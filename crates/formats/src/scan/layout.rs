//! The values taken from every row of a table.

use boundfit_exact::english::split_unit;
use boundfit_exact::{DecimalMark, Foreign, Notation, Thousands, WorkMeter};
use memchr::memmem;

use crate::block::AskedBlock;
use crate::columns::{ColumnPlace, ColumnSelector, decode, refuse_same};
use crate::dialect::{BLANKS, CommentMark, Dialect, Encoding};
use crate::error::{InputError, InputErrorKind};
use crate::heading::{Heading, without_mark};
use crate::notes::{BlockNote, HeaderNote, SheetLooks, Skipped, TableNotes};
use crate::records::{Record, Records, Syntax};
use crate::relations::refuse_beside;
use crate::selection::RowCondition;
use crate::units::unit_of_cell;

use super::batch::{Batch, ScanOptions};
use super::notes::Notes;
use super::preamble::{Preamble, USUAL_MARKS};
use super::values::{Mark, Numbers};

/// The number of cells of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Shape {
    /// The smallest number.
    least: usize,
    /// The largest number, without empty ones at the end.
    pub(super) width: usize,
}

impl Shape {
    /// Returns the shape of a table with this first record: empty cells at its end may be left out below.
    pub(super) fn of_first(cells: &[Vec<u8>]) -> Self {
        let is_filled = |cell: &Vec<u8>| !cell.trim_ascii().is_empty();
        let least = cells.iter().rposition(is_filled).map_or(1, |last| last + 1);
        Shape { least, width: cells.len() }
    }

    /// Returns the shape of a table whose rows have a name more than the header.
    pub(super) fn with_row_names(self) -> Self {
        Shape { least: self.least + 1, width: self.width + 1 }
    }
}

/// A table's columns, once its first record is known.
pub(super) struct Layout<'a> {
    pub(super) file: &'a str,
    pub(super) options: &'a ScanOptions,
    pub(super) selectors: &'a [ColumnSelector],
    pub(super) shape: Shape,
    /// The last cell that a row must have.
    needed: usize,
    /// The number of lines before the table that do not belong to it.
    passed: u64,
    pub(super) syntax: Syntax,
    /// The line that names the columns.
    pub(super) names_in: HeaderNote,
    /// `true` if that line is a record that begins with a comment mark, which is none of its first name.
    pub(super) is_header_marked: bool,
    pub(super) skipped: Skipped,
    /// The block that is read, of a file with several.
    pub(super) block: Option<BlockNote>,
    /// The comment before the table, and the line of its first record.
    pub(super) title: Option<Foreign>,
    pub(super) first_line: u64,
    /// The known facts about decimal marks so far.
    pub(super) mark: Mark,
    /// `true` if the comma that told the mark may as well group digits.
    pub(super) is_comma_open: bool,
    pub(super) numbers: Numbers<'a>,
    /// The work on the numbers that were read.
    pub(super) meter: WorkMeter,
    /// The names of all columns; none without a header.
    pub(super) header: Vec<Foreign>,
    /// The places of the columns asked for.
    pub(super) places: Vec<ColumnPlace>,
    pub(super) key: Option<ColumnPlace>,
    /// The conditions for rows to be wanted, and where the columns are that it is about.
    pub(super) conditions: Vec<(ColumnPlace, &'a RowCondition)>,
    pub(super) units: Vec<Option<Foreign>>,
    pub(super) encoding: Encoding,
    records_before: usize,
    /// `true` if comments turned up between rows or after them.
    pub(super) has_comments: bool,
}

impl<'a> Layout<'a> {
    /// The layout that follows from what the first records say.
    pub(super) fn new(
        file: &'a str,
        heading: &Heading,
        shape: Shape,
        preamble: &Preamble,
        selectors: &'a [ColumnSelector],
        options: &'a ScanOptions,
    ) -> Result<Self, InputError> {
        let dialect = &options.table.dialect;
        let syntax = preamble.syntax;
        if syntax.delimiter == BLANKS && dialect.thousands == Some(Thousands::Blank) {
            return Err(InputError::of_file(file, InputErrorKind::BlanksTwice));
        }
        let places = selectors.iter().map(|selector| heading.find(file, selector));
        let places: Vec<ColumnPlace> = places.collect::<Result<_, _>>()?;
        if !options.same_columns {
            refuse_same(file, places.iter().zip(selectors)).map_err(|mut error| {
                error.place.line = Some(heading.line);
                error
            })?;
        }
        let key = options.key.as_ref();
        let conditions = options.table.conditions.iter();
        let conditions = conditions.map(|condition| Ok((heading.find(file, condition.column())?, condition)));
        let key = key.map(|selector| heading.find(file, selector)).transpose()?;
        let conditions: Vec<(ColumnPlace, &RowCondition)> = conditions.collect::<Result<_, InputError>>()?;
        let needed = places.iter().chain(&key).chain(conditions.iter().map(|(place, _)| place));
        let needed = needed.map(|place| place.position).max().unwrap_or(1);
        Ok(Layout {
            file,
            options,
            selectors,
            shape,
            needed,
            passed: preamble.passed,
            syntax,
            names_in: HeaderNote::default(),
            is_header_marked: false,
            skipped: Skipped::default(),
            block: None,
            title: None,
            first_line: 1,
            mark: Mark::of(dialect, syntax.delimiter),
            is_comma_open: false,
            numbers: Numbers::new(&options.table, syntax.delimiter),
            meter: WorkMeter::default(),
            places,
            key,
            conditions,
            header: heading.names.clone().unwrap_or_default(),
            units: Vec::new(),
            encoding: Encoding::default(),
            records_before: 0,
            has_comments: false,
        })
    }

    /// The detected format of the table, as far as is known by now.
    pub(super) fn table_notes(&self) -> TableNotes {
        let is_number = |place: &ColumnPlace| {
            place.name.as_ref().is_some_and(|name| {
                name.is_empty() || self.numbers.is_number(name.raw().as_bytes(), Mark::Open)
            })
        };
        let has_numbers = self.names_in.line.is_some() && self.places.iter().any(is_number);
        TableNotes {
            sheet: None,
            header: HeaderNote {
                has_numbers,
                is_comment: self.names_in.is_comment || self.is_header_marked,
                ..self.names_in
            },
            dialect: self.dialect(),
            is_sheet: false,
            looks: SheetLooks::default(),
            is_records: false,
            is_comma_open: self.is_comma_open,
            block: self.block.clone(),
            skipped: self.skipped,
        }
    }

    /// This layout of a text in this encoding, after so many records that are no rows, with a row of units or not.
    pub(super) fn with(self, encoding: Encoding, records_before: usize, units: Option<&[Vec<u8>]>) -> Self {
        let in_row = |place: &ColumnPlace| {
            let cell = units?.get(place.position - 1)?;
            unit_of_cell(&String::from_utf8_lossy(cell))
        };
        let in_name = |place: &ColumnPlace| split_unit(place.name.as_ref()?.raw()).1.map(Foreign::from);
        let units = self.places.iter().map(|place| in_row(place).or_else(|| in_name(place))).collect();
        Layout { encoding, records_before, units, ..self }
    }

    /// Returns the dialect of the table, as far as it is known by now.
    pub(super) fn dialect(&self) -> Dialect {
        let table = &self.options.table;
        Dialect {
            delimiter: self.syntax.delimiter,
            notation: Notation {
                decimal: self.mark.known().unwrap_or_default(),
                thousands: table.dialect.thousands,
            },
            comment: self.syntax.comment.or(self.has_comments.then_some(USUAL_MARKS)),
            skip_lines: self.passed,
            records_before: self.records_before,
            has_row_names: self.names_in.has_row_names,
            encoding: self.encoding,
            missing: table.missing,
        }
    }

    /// Records of bytes that start on this line.
    pub(super) fn records(&self, line: u64) -> Records<'a> {
        // The text of a record tells whether a key stands in quotes.
        let keeps_text = self.options.keep_text || self.key.is_some();
        Records::new(self.file, self.syntax, line, &self.options.table.sizes, keeps_text)
            .of_width(self.shape.width)
    }

    /// An empty batch.
    pub(super) fn batch(&self) -> Batch {
        Batch::new(self.places.len(), self.key.is_some(), self.options.keep_text)
    }

    /// Returns whether the rows of all blocks are read as if there were one.
    pub(super) fn takes_all_blocks(&self) -> bool {
        self.options.table.block == Some(AskedBlock::All)
    }

    /// Returns whether a record repeats the header, as each of several blocks that are read as one may.
    pub(super) fn is_header(&self, record: &Record) -> bool {
        if !self.takes_all_blocks() || self.header.is_empty() {
            return false;
        }
        let names = self.header.get(usize::from(self.names_in.has_row_names)..).unwrap_or_default();
        let is_name = |(cell, name): (&[u8], &Foreign)| {
            let cell = decode(cell).map(str::trim);
            cell.is_ok_and(|cell| {
                cell == name.raw() || self.is_header_marked && without_mark(cell) == name.raw()
            })
        };
        // Names that are numbers may be a row.
        record.len() == names.len()
            && record.cells().zip(names).all(is_name)
            && !record.cells().all(|cell| self.numbers.is_number(cell, Mark::Open))
    }

    /// Returns whether some rows may have the header among them.
    pub(super) fn may_repeat_header(&self, rows: &[u8]) -> bool {
        let longest = || self.header.iter().map(|name| name.raw()).max_by_key(|name| name.len());
        self.takes_all_blocks()
            && longest()
                .is_some_and(|name| name.contains('"') || memmem::find(rows, name.as_bytes()).is_some())
    }

    /// Returns whether a data row, counted from 1, may be wanted.
    #[inline]
    pub(super) fn is_wanted(&self, row: usize) -> bool {
        self.options.table.rows.contains(row)
    }

    /// Returns whether the first mark is still to be found, and commas separate cells.
    pub(super) fn waits_for_mark(&self) -> bool {
        self.mark == Mark::Open && self.numbers.has_comma_cells
    }

    /// Returns whether the number in a cell satisfies a condition, and the decimal mark that it tells if none was known.
    pub(super) fn holds(
        &self,
        condition: &RowCondition,
        cell: &[u8],
        mark: Mark,
    ) -> Result<(bool, Option<DecimalMark>), InputErrorKind> {
        let (value, told) = self.numbers.read(cell, mark)?;
        Ok((condition.holds(&value.exact()), told))
    }

    /// Returns whether a line that starts with this byte may turn out to be a comment, by its number of cells.
    pub(super) fn may_be_comment(&self, first: u8) -> bool {
        self.options.table.dialect.comment == CommentMark::Auto && USUAL_MARKS.contains(&first)
    }

    /// Returns whether a record is a comment rather than a row.
    pub(super) fn is_comment(&self, record: &Record) -> bool {
        let starts_like_one = record.cell(0).first().is_some_and(|&first| self.may_be_comment(first));
        starts_like_one && !self.fits(record)
    }

    fn fits(&self, record: &Record) -> bool {
        let Shape { least, width } = self.shape;
        let is_empty = |index: usize| record.cell(index).trim_ascii().is_empty();
        record.len() >= least && (width..record.len()).all(is_empty)
    }

    /// Refuses a row that has more cells than the first one, or not all that are asked for; others are counted. Where blanks separate
    /// cells nobody knows which one is not there.
    pub(super) fn check_width(
        &self,
        record: &Record,
        line: u64,
        notes: &mut Notes,
    ) -> Result<(), InputError> {
        let (found, expected) = (record.len(), self.shape.width);
        if self.fits(record) {
            notes.skipped.long_rows += u64::from(found > expected);
            return Ok(());
        }
        if (self.needed..=expected).contains(&found) && self.syntax.delimiter != BLANKS {
            notes.skipped.short_rows += 1;
            return Ok(());
        }
        let is_split = self.syntax.delimiter == b',' && found == 2 * expected && record.cells().all(is_half);
        let kind = match is_split {
            true => InputErrorKind::CommasTwice { found, expected },
            false => InputErrorKind::RaggedRow { found, expected },
        };
        Err(InputError::of_line(self.file, line, kind))
    }

    /// Returns whether cells that are not asked for may make a row another one.
    pub(super) fn looks_beside(&self) -> bool {
        self.options.table.are_half_planes && self.shape.width > self.places.len()
    }

    /// Refuses cells beside the numbers of a half-plane that make it another one.
    pub(super) fn check_beside(&self, record: &Record, line: u64) -> Result<(), InputError> {
        for (index, cell) in record.cells().enumerate().filter(|_| self.looks_beside()) {
            let place = ColumnPlace { position: index + 1, name: self.header.get(index).cloned() };
            let is_asked = self.places.iter().any(|asked| asked.position == place.position);
            refuse_beside(self.file, &place, line, cell, is_asked)?;
        }
        Ok(())
    }

    /// Refuses a row as units in which every cell that is asked for is a number.
    pub(super) fn check_units(&self, cells: &[Vec<u8>]) -> Result<(), InputErrorKind> {
        let cell = |place: &ColumnPlace| cells.get(place.position - 1).map(Vec::as_slice).unwrap_or_default();
        match self.places.iter().all(|place| begins_with_digits(cell(place))) {
            true => Err(InputErrorKind::NumbersAsUnits),
            false => Ok(()),
        }
    }
}

/// Returns whether a cell begins as a number does, whatever groups its digits or stands behind them: `1 000,0`, `10 V`.
pub(super) fn begins_with_digits(cell: &[u8]) -> bool {
    let mut bytes = cell.trim_ascii().iter().skip_while(|byte| b"+-.,".contains(byte));
    bytes.next().is_some_and(u8::is_ascii_digit)
}

/// Returns whether a cell may be what stands before or behind a comma of a number.
fn is_half(cell: &[u8]) -> bool {
    let cell = cell.trim_ascii();
    let digits = cell.strip_prefix(b"-").unwrap_or(cell);
    !digits.is_empty() && digits.iter().all(u8::is_ascii_digit)
}
