//! Numbers of cells, on their way into columns.

use boundfit_exact::{
    Column, DecimalMark, Notation, PLAIN_DIGITS, PLAIN_EXPONENT, Rational, Reading, Thousands, plain_decimal,
    plain_double,
};

use crate::columns::Role;
use crate::columns::{ColumnSelector, decode};
use crate::dialect::{AskedDialect, BLANKS};
use crate::error::InputErrorKind;
use crate::roles::{self, instead_of_number};
use crate::table::TableOptions;

/// A number that was read.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// A mantissa and an exponent of ten.
    Decimal(i64, i32),
    Double(f64),
    Exact(Rational),
    /// The value that a column takes instead of the number, as a mantissa and an exponent of ten.
    Aside((i64, i64), Reading, Role),
}

impl Value {
    pub(super) fn push_to(self, column: &mut Column) {
        match self {
            Value::Decimal(mantissa, exponent) => column.push_decimal(mantissa, exponent),
            Value::Double(double) => column.push_double(double),
            Value::Exact(number) => column.push(number),
            Value::Aside(value, reading, role) => roles::add(column, value, reading, role),
        }
    }

    /// Returns whether this says that a number is there.
    pub(super) fn is_presence(&self) -> bool {
        matches!(self, Value::Aside((1.., _), _, Role::Presence))
    }

    pub(super) fn exact(self) -> Rational {
        match self {
            Value::Decimal(mantissa, exponent) => Rational::scientific(mantissa, exponent),
            Value::Double(double) => Rational::from_f64(double).unwrap_or_default(),
            Value::Exact(number) => number,
            Value::Aside((mantissa, exponent), ..) => Rational::scientific(mantissa, exponent),
        }
    }

    /// Refuses a number that a column does not take.
    pub(super) fn check(&self, selector: &ColumnSelector) -> Result<(), InputErrorKind> {
        match selector.is_non_negative() && self.is_negative() {
            true => Err(InputErrorKind::NegativeErrorBound),
            false => Ok(()),
        }
    }

    fn is_negative(&self) -> bool {
        match self {
            Value::Decimal(mantissa, _) => *mantissa < 0,
            Value::Double(double) => *double < 0.0,
            Value::Exact(number) => number.is_negative(),
            Value::Aside((mantissa, _), ..) => *mantissa < 0,
        }
    }
}

/// The decimal mark of a table's cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mark {
    /// This one: it was asked for, or the delimiter leaves no choice.
    Given(DecimalMark),
    /// This one, by a cell before.
    Found(DecimalMark),
    /// Either: no cell has told yet.
    Open,
}

impl Mark {
    /// The known facts about the numbers of a table whose cells are separated by this, before any is read.
    pub(super) fn of(asked: &AskedDialect, delimiter: u8) -> Self {
        match asked.given_mark() {
            Some(mark) => Mark::Given(mark),
            None if matches!(delimiter, b',' | b';' | b'\t' | b'|' | BLANKS) => Mark::Open,
            None => Mark::Given(DecimalMark::Point),
        }
    }

    /// The mark that cells are known to have.
    pub(super) fn known(self) -> Option<DecimalMark> {
        match self {
            Mark::Given(mark) | Mark::Found(mark) => Some(mark),
            Mark::Open => None,
        }
    }
}

/// The reader of a table's numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Numbers<'a> {
    pub(super) options: &'a TableOptions,
    /// `true` if every text that `plain_decimal` reads keeps to the limits.
    pub(super) plain: bool,
    /// `true` if commas separate cells. Then a comma within quotes may as well group digits, as in `"1,234"`.
    pub(super) has_comma_cells: bool,
}

impl<'a> Numbers<'a> {
    pub(super) fn new(options: &'a TableOptions, delimiter: u8) -> Self {
        let limits = &options.limits;
        let plain = limits.digits >= PLAIN_DIGITS && limits.exponent >= PLAIN_EXPONENT;
        Numbers { options, plain, has_comma_cells: delimiter == b',' }
    }

    /// Returns whether a cell says that its value is missing.
    pub(super) fn is_missing(&self, cell: &[u8]) -> bool {
        decode(cell).is_ok_and(|cell| self.options.missing_as.are_in(cell))
    }

    /// Returns whether there is a number in a cell.
    pub(super) fn is_number(&self, cell: &[u8], mark: Mark) -> bool {
        let is_marked = |decimal| self.read_marked(cell, decimal).is_ok();
        mark.known().map_or_else(|| DecimalMark::ALL.into_iter().any(is_marked), is_marked)
    }

    /// Returns the values that a column takes from a cell: its number unless the column has another role. It
    /// also returns the decimal mark that the number tells if none was known.
    pub(super) fn value(
        &self,
        cell: &[u8],
        selector: &ColumnSelector,
        mark: Mark,
    ) -> Result<(Value, Option<DecimalMark>), InputErrorKind> {
        match instead_of_number(cell, selector, mark.known(), &self.options.missing_as)? {
            Some(value) => Ok((Value::Aside(value, self.options.reading, selector.role()), None)),
            None => self.read(cell, mark),
        }
    }

    /// The number in a cell, and the decimal mark that it tells if none was known.
    pub(super) fn read(
        &self,
        cell: &[u8],
        mark: Mark,
    ) -> Result<(Value, Option<DecimalMark>), InputErrorKind> {
        if !self.options.missing_as.is_empty() && self.options.missing_as.lists(decode(cell)?) {
            return Err(InputErrorKind::Null);
        }
        let (value, told) = match mark {
            Mark::Given(mark) => (self.read_marked(cell, mark)?, None),
            Mark::Found(mark) => match self.read_marked(cell, mark) {
                Err(_) if self.tells(cell, mark.other()) => {
                    return Err(InputErrorKind::AnotherDecimalMark { before: mark });
                }
                value => (value?, None),
            },
            Mark::Open => match self.read_marked(cell, DecimalMark::Point) {
                Ok(value) => (value, cell.contains(&b'.').then_some(DecimalMark::Point)),
                Err(problem) => match self.read_marked(cell, DecimalMark::Comma) {
                    Ok(value) if !self.may_be_grouped(cell) => (value, Some(DecimalMark::Comma)),
                    _ => return Err(problem),
                },
            },
        };
        Ok((value, told))
    }

    /// Returns whether a cell is a number with this decimal mark, and nothing else.
    fn tells(&self, cell: &[u8], mark: DecimalMark) -> bool {
        self.read_marked(cell, mark).is_ok() && !(mark == DecimalMark::Comma && self.may_be_grouped(cell))
    }

    /// Returns whether a cell has a decimal comma, which alone can be meant.
    pub(super) fn tells_comma(&self, cell: &[u8]) -> bool {
        !self.has_comma_cells && cell.contains(&b',') && self.tells(cell, DecimalMark::Comma)
    }

    /// Returns whether the points of a cell may group its digits: `1.000`, but neither `12.5` nor `0.125`.
    pub(super) fn has_group_points(&self, cell: &[u8]) -> bool {
        cell.contains(&b'.') && self.is_grouped(cell, DecimalMark::Comma, Thousands::Point)
    }

    /// Returns whether the commas of a cell may group its digits: `1,234`, but neither `12,5` nor `0,125`.
    pub(super) fn has_group_commas(&self, cell: &[u8]) -> bool {
        self.is_grouped(cell, DecimalMark::Point, Thousands::Comma)
    }

    /// Returns whether commas separate cells, and those of this one may group its digits.
    fn may_be_grouped(&self, cell: &[u8]) -> bool {
        self.has_comma_cells && self.has_group_commas(cell)
    }

    fn is_grouped(&self, cell: &[u8], decimal: DecimalMark, thousands: Thousands) -> bool {
        let grouped = Notation { decimal, thousands: Some(thousands) };
        let is_number = |cell| Reading::Decimal.read_written(cell, grouped, &self.options.limits).is_ok();
        decode(cell).is_ok_and(is_number)
    }

    fn read_marked(&self, cell: &[u8], decimal: DecimalMark) -> Result<Value, InputErrorKind> {
        let TableOptions { reading, limits, dialect, .. } = self.options;
        let mut buffer = [0; PLAIN_DIGITS + 16];
        let with_point = match decimal {
            DecimalMark::Point => Some(cell),
            DecimalMark::Comma => with_point(cell, &mut buffer),
        };
        let plain = with_point.filter(|_| self.plain);
        let value = match reading {
            Reading::Decimal => {
                plain.and_then(plain_decimal).map(|(mantissa, exponent)| Value::Decimal(mantissa, exponent))
            }
            Reading::Binary64 => plain.and_then(plain_double).map(Value::Double),
        };
        if let Some(value) = value {
            return Ok(value);
        }
        let notation = Notation { decimal, thousands: dialect.thousands };
        let number = reading.read_written(decode(cell)?, notation, limits)?;
        Ok(match reading {
            Reading::Decimal => Value::Exact(number),
            Reading::Binary64 => Value::Double(number.to_f64()),
        })
    }
}

/// A cell with decimal points in place of its commas; `None` if it has points, or no room in the buffer.
fn with_point<'b>(cell: &[u8], buffer: &'b mut [u8]) -> Option<&'b [u8]> {
    let copy = buffer.get_mut(..cell.len())?;
    for (to, &from) in copy.iter_mut().zip(cell) {
        *to = match from {
            b'.' => return None,
            b',' => b'.',
            other => other,
        };
    }
    Some(copy)
}
