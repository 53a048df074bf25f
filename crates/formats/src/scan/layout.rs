//! What is taken from every row of a table.

use boundfit_exact::{Column, PLAIN_DIGITS, PLAIN_EXPONENT, Reading, plain_decimal, plain_double};

use crate::columns::{ColumnPlace, ColumnSelector, Heading, decode};
use crate::error::{InputError, InputErrorKind};
use crate::records::{Record, Records};
use crate::roles::{self, instead_of_number};
use crate::selection::RowCondition;
use crate::table::{TableRow, check_columns, read_number};

use super::batch::{Pieces, ScanOptions};
use super::builder::BatchBuilder;

/// A table's columns, once its first record is known.
pub(super) struct Layout<'a> {
    pub(super) file: &'a str,
    pub(super) options: &'a ScanOptions,
    pub(super) selectors: &'a [ColumnSelector],
    pub(super) width: usize,
    pub(super) delimiter: u8,
    pub(super) has_header: bool,
    /// The names of all columns; none without a header.
    pub(super) header: Vec<String>,
    /// Where the columns asked for are.
    pub(super) places: Vec<ColumnPlace>,
    pub(super) key: Option<ColumnPlace>,
    /// What must hold for rows to be wanted, and where the columns are that it is about.
    pub(super) conditions: Vec<(ColumnPlace, &'a RowCondition)>,
}

impl<'a> Layout<'a> {
    /// The layout that follows from the first record, which starts on this line.
    pub(super) fn new(
        file: &'a str,
        first: &Record,
        line: u64,
        delimiter: u8,
        selectors: &'a [ColumnSelector],
        options: &'a ScanOptions,
    ) -> Result<Self, InputError> {
        check_columns(file, first.len(), line, &options.table.sizes)?;
        let key = options.key.as_ref();
        let conditions = &options.table.conditions;
        let others: Vec<&ColumnSelector> =
            key.into_iter().chain(conditions.iter().map(RowCondition::column)).collect();
        let cells: Vec<&[u8]> = first.cells().collect();
        let heading = Heading::new(file, &cells, line, options.table.header, selectors, &others)?;
        let places = selectors.iter().map(|selector| heading.find(file, selector));
        let conditions =
            conditions.iter().map(|condition| Ok((heading.find(file, condition.column())?, condition)));
        Ok(Layout {
            file,
            options,
            selectors,
            width: heading.width,
            delimiter,
            has_header: heading.names.is_some(),
            places: places.collect::<Result<_, _>>()?,
            key: key.map(|selector| heading.find(file, selector)).transpose()?,
            conditions: conditions.collect::<Result<_, InputError>>()?,
            header: heading.names.unwrap_or_default(),
        })
    }

    /// Records of bytes that start on this line.
    pub(super) fn records(&self, line: u64) -> Records<'a> {
        let longest = self.options.table.sizes.line;
        Records::new(self.file, self.delimiter, line, longest, self.options.keep_text)
    }

    /// An empty batch.
    pub(super) fn batch(&self) -> BatchBuilder {
        BatchBuilder::new(self.places.len(), self.key.is_some(), self.options.keep_text)
    }

    /// Whether a data row, counted from 1, may be wanted.
    #[inline]
    pub(super) fn is_wanted(&self, row: usize) -> bool {
        self.options.table.rows.contains(row)
    }

    /// Whether a row that may be wanted satisfies all conditions. Each must have its number.
    pub(super) fn satisfies_conditions(&self, record: &Record, line: u64) -> Result<bool, InputError> {
        let mut satisfies = true;
        for (place, condition) in &self.conditions {
            let cell = record.cell(place.position - 1);
            satisfies &=
                self.holds(condition, cell).map_err(|problem| place.error(self.file, line, cell, problem))?;
        }
        Ok(satisfies)
    }

    /// Whether the number in a cell satisfies a condition.
    pub(super) fn holds(&self, condition: &RowCondition, cell: &[u8]) -> Result<bool, InputErrorKind> {
        Ok(condition.holds(&read_number(cell, condition.column(), &self.options.table)?))
    }

    /// Whether every text that `plain_decimal` reads keeps to the limits.
    pub(super) fn limits_allow_plain_decimals(&self) -> bool {
        let limits = &self.options.table.limits;
        limits.digits >= PLAIN_DIGITS && limits.exponent >= PLAIN_EXPONENT
    }

    /// Adds the numbers and the key of a record to a batch.
    pub(super) fn add(&self, record: &Record, line: u64, batch: &mut BatchBuilder) -> Result<(), InputError> {
        for ((place, selector), column) in self.places.iter().zip(self.selectors).zip(&mut batch.columns) {
            let cell = record.cell(place.position - 1);
            self.add_number(cell, selector, column)
                .map_err(|problem| place.error(self.file, line, cell, problem))?;
        }
        if let (Some(place), Some(keys)) = (&self.key, &mut batch.keys) {
            let cell = record.cell(place.position - 1);
            Layout::add_key(cell, keys).map_err(|problem| place.error(self.file, line, cell, problem))?;
        }
        Ok(())
    }

    /// Adds a row that is not wanted to a batch, if its cells are numbers.
    pub(super) fn add_other(&self, record: &Record, row: usize, batch: &mut BatchBuilder) {
        let number = |(place, selector): (&ColumnPlace, &ColumnSelector)| {
            read_number(record.cell(place.position - 1), selector, &self.options.table)
        };
        let numbers = self.places.iter().zip(self.selectors).map(number).collect();
        batch.others.extend(Result::ok(numbers).map(|numbers| TableRow { row, numbers }));
    }

    /// Adds the number in a cell to a column.
    pub(super) fn add_number(
        &self,
        cell: &[u8],
        selector: &ColumnSelector,
        column: &mut Column,
    ) -> Result<(), InputErrorKind> {
        let options = &self.options.table;
        if let Some(value) = instead_of_number(cell, selector)? {
            roles::add(column, value, options.reading, selector.role());
            return Ok(());
        }
        let plain = self.limits_allow_plain_decimals();
        match options.reading {
            Reading::Decimal => match plain_decimal(cell).filter(|_| plain) {
                Some((mantissa, _)) if mantissa < 0 && selector.is_non_negative() => {
                    return Err(InputErrorKind::NegativeErrorBound);
                }
                Some((mantissa, exponent)) => column.push_decimal(mantissa, exponent),
                None => column.push(read_number(cell, selector, options)?),
            },
            Reading::Binary64 => match plain_double(cell).filter(|_| plain) {
                Some(double) if double < 0.0 && selector.is_non_negative() => {
                    return Err(InputErrorKind::NegativeErrorBound);
                }
                Some(double) => column.push_double(double),
                None => column.push_double(read_number(cell, selector, options)?.to_f64()),
            },
        }
        Ok(())
    }

    /// Adds the text in a cell to the keys.
    pub(super) fn add_key(cell: &[u8], keys: &mut Pieces<String>) -> Result<(), InputErrorKind> {
        keys.push(decode(cell)?.trim_matches([' ', '\t']));
        Ok(())
    }
}
