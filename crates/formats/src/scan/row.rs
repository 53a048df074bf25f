//! A row of a table: its numbers, its key and its cells, or why it is none.

use boundfit_exact::{DecimalMark, TooMuchWork, is_missing, trim_number};

use crate::columns::{ColumnPlace, Role, decode};
use crate::error::{InputError, InputErrorKind};
use crate::records::Record;
use crate::table::TableRow;
use crate::times::{is_time, or_time};

use super::keys::RowKeys;
use super::layout::{Layout, begins_with_digits};
use super::notes::Notes;
use super::quoting::is_quoted;
use super::values::{Mark, Value};

/// A row that can be added to a batch, or why it is none.
pub(super) enum Row {
    Values(Vec<Value>),
    /// A condition on rows does not hold.
    Unwanted,
    /// The first cell that has no number, but nothing or a word for that.
    Lacks(InputError),
}

impl Layout<'_> {
    /// The numbers of a record. Where the decimal mark was open, the first one tells it: that is noted, with the error that its
    /// cell is if another mark came before.
    pub(super) fn row(
        &self,
        record: &Record,
        line: u64,
        row: usize,
        looks_at_conditions: bool,
        mark: &mut Mark,
        notes: &mut Notes,
    ) -> Result<Row, InputError> {
        let mut values = Vec::with_capacity(self.places.len());
        let mut lacks = None;
        let was_open = *mark == Mark::Open;
        let mut tell =
            |mark: &mut Mark, found: Option<DecimalMark>, error: &dyn Fn(InputErrorKind) -> InputError| {
                if let Some(found) = found {
                    *mark = Mark::Found(found);
                    let before = found.other();
                    notes.mark = Some((found, error(InputErrorKind::AnotherDecimalMark { before })));
                }
            };
        let mut satisfies = true;
        for (place, condition) in self.conditions.iter().filter(|_| looks_at_conditions) {
            let cell = self.cell(record, place, line)?;
            let error = |problem| place.error(self.file, line, cell, problem);
            match self.holds(condition, cell, *mark) {
                Ok((holds, found)) => {
                    tell(mark, found, &error);
                    satisfies &= holds;
                }
                Err(problem) if self.numbers.is_missing(cell) => {
                    lacks.get_or_insert(error(problem));
                }
                Err(problem) => return Err(error(problem)),
            }
        }
        if !satisfies || lacks.is_some() {
            return Ok(if satisfies { lacks.map_or(Row::Unwanted, Row::Lacks) } else { Row::Unwanted });
        }
        for (place, selector) in self.places.iter().zip(self.selectors) {
            let cell = self.cell(record, place, line)?;
            let error = |problem| place.error(self.file, line, cell, or_time(problem, cell));
            match self.numbers.value(cell, selector, *mark) {
                Ok((value, found)) => {
                    tell(mark, found, &error);
                    value.check(selector).map_err(error)?;
                    self.meter(&value, cell).map_err(|problem| error(problem.into()))?;
                    values.push(value);
                }
                Err(problem) if self.numbers.is_missing(cell) => {
                    lacks.get_or_insert(error(problem));
                }
                Err(InputErrorKind::NotANumber(_))
                    if row == 1 && !is_time(cell) && self.has_no_number(record, *mark) =>
                {
                    let behind_units = self.options.table.dialect.units_row;
                    return Err(error(InputErrorKind::NoNumberInFirstRow { behind_units }));
                }
                Err(problem) => return Err(error(problem)),
            }
        }
        if was_open && *mark == Mark::Found(DecimalMark::Point) {
            self.check_group_points(record, line)?;
        }
        if lacks.is_none() && self.wants_presence() && !self.has_presence(&values) {
            return Err(self.no_bound(record, line));
        }
        Ok(lacks.map_or(Row::Values(values), Row::Lacks))
    }

    /// Refuses points that may group digits, as in `1.000`, beside a decimal comma in a column that nobody asked for.
    fn check_group_points(&self, record: &Record, line: u64) -> Result<(), InputError> {
        let mut pointed = self.places.iter().map(|place| record.cell(place.position - 1));
        let may_all_group = pointed.all(|cell| !cell.contains(&b'.') || self.numbers.has_group_points(cell));
        let comma = || (0..record.len()).find(|&index| self.numbers.tells_comma(record.cell(index)));
        let Some(index) = may_all_group.then(comma).flatten() else { return Ok(()) };
        let name = self.header.get(index).cloned();
        let problem = InputErrorKind::AnotherDecimalMark { before: DecimalMark::Point };
        Err(ColumnPlace { position: index + 1, name }.error(self.file, line, record.cell(index), problem))
    }

    /// Adds a number to the work on all of them, and refuses what passes the limit.
    pub(super) fn meter(&self, value: &Value, cell: &[u8]) -> Result<(), TooMuchWork> {
        let Value::Exact(number) = value else { return Ok(()) };
        self.meter.add(number, cell.contains(&b'/'), self.options.table.sizes.work)
    }

    /// Returns whether a row needs a number in one of the columns that may lack one.
    pub(super) fn wants_presence(&self) -> bool {
        !self.options.unbounded_rows
            && self.selectors.iter().any(|selector| selector.role() == Role::Presence)
    }

    /// Returns whether one of the columns that may lack a number has one.
    fn has_presence(&self, values: &[Value]) -> bool {
        let mut told = self.selectors.iter().zip(values);
        told.any(|(selector, value)| selector.role() == Role::Presence && value.is_presence())
    }

    /// The error for a row that has a number in none of the columns that may lack one.
    fn no_bound(&self, record: &Record, line: u64) -> InputError {
        let mut places = self.places.iter().zip(self.selectors);
        match places.find(|(_, selector)| selector.role() == Role::Presence) {
            Some((place, _)) => {
                place.error(self.file, line, record.cell(place.position - 1), InputErrorKind::NoBound)
            }
            None => InputError::of_line(self.file, line, InputErrorKind::NoBound),
        }
    }

    /// Returns the text of a cell. It refuses text behind the closing quote, which is no part of a number.
    fn cell<'r>(&self, record: &'r Record, place: &ColumnPlace, line: u64) -> Result<&'r [u8], InputError> {
        let cell = record.cell(place.position - 1);
        match record.is_torn(place.position - 1) {
            true => Err(place.error(self.file, line, cell, InputErrorKind::BehindQuotes)),
            false => Ok(cell),
        }
    }

    /// Returns true if a record after the header looks like a row of units: none of the asked cells has a number.
    fn has_no_number(&self, record: &Record, mark: Mark) -> bool {
        let cell = |place: &ColumnPlace| record.cell(place.position - 1);
        let is_text = |place: &ColumnPlace| {
            // A number with the other decimal mark is no unit: it gets an error of its own.
            !self.numbers.is_number(cell(place), mark) && !self.numbers.is_number(cell(place), Mark::Open)
        };
        self.names_in.line.is_some()
            && !self.names_in.is_comment
            && self.places.iter().all(is_text)
            // Cells such as `1 000` and `10 V` are numbers that get an error of their own.
            && !self.places.iter().all(|place| begins_with_digits(cell(place)))
    }

    /// The place of the first cell asked for.
    pub(super) fn first_place(&self, record: &Record, line: u64) -> InputError {
        let problem = InputErrorKind::AllMissing { rows: 0 };
        match self.places.first() {
            Some(place) => place.error(self.file, line, record.cell(place.position - 1), problem),
            None => InputError::of_line(self.file, line, problem),
        }
    }

    /// The key of a record, if keys are asked for: what stands in quotes as it is written.
    pub(super) fn key_of<'r>(
        &self,
        record: &'r Record,
        text: Option<&[u8]>,
        line: u64,
    ) -> Result<Option<&'r str>, InputError> {
        let Some(place) = &self.key else { return Ok(None) };
        let cell = record.cell(place.position - 1);
        let key = decode(cell).map_err(|problem| place.error(self.file, line, cell, problem))?;
        let has_blanks = key.len() != unquoted_key(key).len();
        let is_as_written =
            has_blanks && text.is_some_and(|text| is_quoted(text, self.syntax.delimiter, place.position - 1));
        Ok(Some(if is_as_written { key } else { unquoted_key(key) }))
    }

    /// Adds the text in a cell to the keys, what stood in quotes as it is written.
    pub(super) fn add_key(cell: &[u8], is_quoted: bool, keys: &mut RowKeys) -> Result<(), InputErrorKind> {
        let key = decode(cell)?;
        keys.push(if is_quoted { key } else { unquoted_key(key) });
        Ok(())
    }

    /// The row of a record that is not wanted, if its cells are numbers.
    pub(super) fn other(&self, record: &Record, values: Vec<Value>, row: usize) -> TableRow {
        let cells = if self.options.table.keep_cells { self.cells(record) } else { Vec::new() };
        TableRow { row, numbers: values.into_iter().map(Value::exact).collect(), cells }
    }

    /// The texts of the cells that are asked for their numbers.
    pub(super) fn cells(&self, record: &Record) -> Vec<String> {
        let is_number = |role: Role| !matches!(role, Role::Presence | Role::HalfUnit);
        let asked = self.places.iter().zip(self.selectors).filter(|(_, selector)| is_number(selector.role()));
        let text = |cell| match decode(cell).map(trim_number) {
            Ok(text) if !is_missing(text) => match self.options.table.dialect.thousands {
                Some(thousands) => thousands.taken_out_of(text),
                None => text.to_owned(),
            },
            _ => String::new(),
        };
        asked.map(|(place, _)| text(record.cell(place.position - 1))).collect()
    }
}

/// The key in a cell without quotes: the blanks around it set columns off from each other.
pub(super) fn unquoted_key(cell: &str) -> &str {
    cell.trim_matches([' ', '\t'])
}
