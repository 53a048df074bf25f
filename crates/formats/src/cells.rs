//! Cells of tables that are not text, on their way into columns.

use std::ops::Range;

use boundfit_exact::{
    Column, DecimalMark, PLAIN_DIGITS, PLAIN_EXPONENT, ParseNumberError, ParseNumberErrorKind, Rational,
    Reading, Shortest, Unit, WorkMeter, plain_decimal,
};

use crate::columns::{ColumnSelector, decode};
use crate::error::InputErrorKind;
use crate::roles::instead_of_number;
use crate::table::TableOptions;

/// The reader that makes numbers of the cells of one column.
#[derive(Clone, Copy)]
pub(crate) struct CellReader<'a> {
    pub(crate) selector: &'a ColumnSelector,
    pub(crate) options: &'a TableOptions,
    pub(crate) meter: &'a WorkMeter,
}

/// The index of a cell that cannot be used, and the reason.
pub(crate) type BadIndex = (usize, InputErrorKind);

impl CellReader<'_> {
    /// Returns these multiples of a power of ten; under the binary64 reading the doubles that are nearest to
    /// them.
    pub(crate) fn counts(&self, counts: impl Iterator<Item = i128> + Clone, exponent: i32) -> Column {
        if self.options.reading == Reading::Binary64 {
            return Column::Doubles(counts.map(|count| nearest(count, exponent)).collect());
        }
        Column::of_counts(counts, Unit::TenTo(exponent))
    }

    /// Finite floats: what their shortest text says, or themselves. Others are refused as the text that they would be.
    pub(crate) fn floats<F: Shortest>(
        &self,
        floats: &[F],
        decimals: impl FnOnce(&[F]) -> Result<Column, usize>,
        doubles: impl FnOnce() -> Result<Column, usize>,
    ) -> Result<Column, BadIndex> {
        let text = |float: &F| float.in_shortest_digits(format!("{float:e}"));
        let column = match self.options.reading {
            Reading::Binary64 => doubles(),
            Reading::Decimal if self.is_plain() => decimals(floats),
            // Limits this low are those of the text.
            Reading::Decimal => return self.texts(floats.iter().map(text)),
        };
        column.map_err(|index| {
            let problem = floats.get(index).and_then(|float| self.exact(&text(float)).err());
            (index, problem.unwrap_or(InputErrorKind::NotFinite))
        })
    }

    /// Numbers as text.
    pub(crate) fn texts<S: AsRef<str>>(&self, texts: impl Iterator<Item = S>) -> Result<Column, BadIndex> {
        let mut column = Column::default();
        for (index, text) in texts.enumerate() {
            self.add(text.as_ref(), &mut column).map_err(|problem| (index, problem))?;
        }
        Ok(column)
    }

    /// The numbers of a range of cells, with 0 where there is none.
    pub(crate) fn optional(
        &self,
        range: Range<usize>,
        is_missing: impl Fn(usize) -> bool,
        given: impl Fn(Range<usize>) -> Result<Column, BadIndex>,
    ) -> Result<Column, BadIndex> {
        let mut column = Column::default();
        for index in range.clone() {
            if is_missing(index) {
                match self.options.reading {
                    Reading::Binary64 => column.push_double(0.0),
                    Reading::Decimal => column.push_decimal(0, 0),
                }
            } else {
                let own = given(index..index + 1);
                column.append(&own.map_err(|(_, problem)| (index - range.start, problem))?, 0..1);
            }
        }
        Ok(column)
    }

    /// The column, unless it has a negative number and may have none.
    pub(crate) fn refusing_negative(&self, column: Column) -> Result<Column, BadIndex> {
        match column.first_negative() {
            Some(index) if self.selector.is_non_negative() => {
                Err((index, InputErrorKind::NegativeErrorBound))
            }
            _ => Ok(column),
        }
    }

    /// Returns whether what `plain_decimal` reads keeps to the limits.
    fn is_plain(&self) -> bool {
        let limits = &self.options.limits;
        limits.digits >= PLAIN_DIGITS && limits.exponent >= PLAIN_EXPONENT
    }

    /// The number in a text.
    pub(crate) fn exact(&self, text: &str) -> Result<Rational, InputErrorKind> {
        let (cell, column) = (text.as_bytes(), self.selector);
        if let Some((mantissa, exponent)) =
            instead_of_number(cell, column, Some(DecimalMark::Point), &self.options.missing_as)?
        {
            return Ok(Rational::scientific(mantissa, exponent));
        }
        // A remark about a comma concerns the options that tell how text is written.
        let number = self.options.reading.read(decode(cell)?, &self.options.limits);
        let number = number.map_err(|error| match error.kind {
            ParseNumberErrorKind::Comma => InputErrorKind::Comma,
            kind => ParseNumberError { kind, ..error }.into(),
        })?;
        if column.is_non_negative() && number.is_negative() {
            return Err(InputErrorKind::NegativeErrorBound);
        }
        Ok(number)
    }

    fn add(&self, text: &str, column: &mut Column) -> Result<(), InputErrorKind> {
        match (self.options.reading, plain_decimal(text.as_bytes()).filter(|_| self.is_plain())) {
            (Reading::Decimal, Some((mantissa, exponent))) => column.push_decimal(mantissa, exponent),
            (Reading::Decimal, None) => {
                let number = self.exact(text)?;
                self.meter.add(&number, text.contains('/'), self.options.sizes.work)?;
                column.push(number);
            }
            (Reading::Binary64, _) => column.push_double(self.exact(text)?.to_f64()),
        }
        Ok(())
    }
}

/// The double nearest to `mantissa · 10^exponent`.
fn nearest(mantissa: i128, exponent: i32) -> f64 {
    // The conversion of an integer rounds to the nearest. So does the division of two doubles: integers up to 2⁵³ and
    // powers of ten up to 10¹⁹ are doubles (Clinger 1990).
    match exponent {
        0 => mantissa as f64,
        -19..0 if mantissa.unsigned_abs() <= 1 << 53 => {
            mantissa as f64 / 10_u64.pow(exponent.unsigned_abs()) as f64
        }
        _ => Rational::scientific(mantissa, exponent).to_f64(),
    }
}
