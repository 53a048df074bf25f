//! Batches under construction.

use boundfit_exact::{Rational, Scaled};

use super::batch::{Batch, Column, Pieces};
use crate::table::TableRow;

/// The exponent of zeros alone, which are zeros on every power of ten.
const ANY_EXPONENT: i32 = i32::MIN;

/// A column under construction. How its numbers are kept follows from their values alone.
#[derive(Debug)]
pub(crate) struct ColumnBuilder(Column);

impl Default for ColumnBuilder {
    fn default() -> Self {
        ColumnBuilder(Column::Scaled(Scaled { mantissas: Vec::new(), exponent: ANY_EXPONENT }))
    }
}

impl ColumnBuilder {
    /// Adds `mantissa · 10^exponent`.
    #[inline]
    pub(crate) fn push_decimal(&mut self, mantissa: i64, exponent: i32) {
        match &mut self.0 {
            Column::Scaled(scaled) if scaled.exponent == exponent => scaled.mantissas.push(mantissa),
            _ => self.push_rescaled(mantissa, exponent),
        }
    }

    /// The same when the exponent is not that of the numbers before.
    fn push_rescaled(&mut self, mantissa: i64, exponent: i32) {
        if let Column::Scaled(scaled) = &mut self.0
            && push_scaled(scaled, mantissa, exponent)
        {
            return;
        }
        self.push_exact(Scaled { mantissas: vec![mantissa], exponent }.get(0));
    }

    /// Adds a number that is not a decimal of 64 bits.
    pub(crate) fn push_exact(&mut self, number: Rational) {
        if let Column::Exact(numbers) = &mut self.0 {
            numbers.push(number);
            return;
        }
        let before = std::mem::take(self).finish();
        let numbers = (0..before.len()).map(|index| before.get(index)).chain([number]);
        self.0 = Column::Exact(numbers.collect());
    }

    /// Adds a double to a column of nothing else.
    #[inline]
    pub(crate) fn push_double(&mut self, double: f64) {
        // Zero has one sign.
        let double = double + 0.0;
        match &mut self.0 {
            Column::Doubles(doubles) => doubles.push(double),
            _ => self.0 = Column::Doubles(vec![double]),
        }
    }

    fn reserve(&mut self, count: usize) {
        match &mut self.0 {
            Column::Scaled(scaled) => scaled.mantissas.reserve(count),
            Column::Doubles(doubles) => doubles.reserve(count),
            Column::Exact(numbers) => numbers.reserve(count),
        }
    }

    /// The numbers added so far.
    pub(crate) fn finish(mut self) -> Column {
        if let Column::Scaled(Scaled { exponent: exponent @ ANY_EXPONENT, .. }) = &mut self.0 {
            *exponent = 0;
        }
        self.0
    }
}

/// Adds a decimal to others, or gives `false` when they do not all fit on their finest power of ten.
fn push_scaled(scaled: &mut Scaled, mantissa: i64, exponent: i32) -> bool {
    let mut mantissa = mantissa;
    if mantissa == 0 || scaled.exponent == ANY_EXPONENT {
        scaled.exponent = if mantissa == 0 { scaled.exponent } else { exponent };
    } else if exponent > scaled.exponent {
        match times(mantissa, exponent - scaled.exponent) {
            Some(product) => mantissa = product,
            None => return false,
        }
    } else {
        let finer = scaled.exponent - exponent;
        let products: Option<Vec<i64>> = scaled.mantissas.iter().map(|&own| times(own, finer)).collect();
        match products {
            Some(products) => *scaled = Scaled { mantissas: products, exponent },
            None => return false,
        }
    }
    scaled.mantissas.push(mantissa);
    true
}

/// `mantissa · 10^exponent` for an exponent that is not negative, if it fits.
fn times(mantissa: i64, exponent: i32) -> Option<i64> {
    10_i64.checked_pow(exponent.unsigned_abs()).and_then(|power| mantissa.checked_mul(power))
}

/// A batch under construction.
#[derive(Debug)]
pub(super) struct BatchBuilder {
    pub(super) columns: Vec<ColumnBuilder>,
    pub(super) keys: Option<Pieces<String>>,
    lines: Option<Pieces<Vec<u8>>>,
    first_row: usize,
    rows: usize,
    pub(super) others: Vec<TableRow>,
}

impl BatchBuilder {
    pub(super) fn new(columns: usize, keys: bool, lines: bool) -> Self {
        BatchBuilder {
            columns: std::iter::repeat_with(ColumnBuilder::default).take(columns).collect(),
            keys: keys.then(Pieces::default),
            lines: lines.then(Pieces::default),
            first_row: 0,
            rows: 0,
            others: Vec::new(),
        }
    }

    /// Makes room for the numbers of so many more rows.
    pub(super) fn reserve(&mut self, rows: usize) {
        self.columns.iter_mut().for_each(|column| column.reserve(rows));
    }

    /// Completes a row, of which the numbers and the key have been added.
    #[inline]
    pub(super) fn end_row(&mut self, row: usize, line: Option<&[u8]>) {
        if let (Some(lines), Some(line)) = (&mut self.lines, line) {
            lines.push(line);
        }
        if self.rows == 0 {
            self.first_row = row;
        }
        self.rows += 1;
    }

    /// The batch, when it has rows, with so much added to their numbers.
    pub(super) fn finish(self, shift: usize) -> Option<Batch> {
        let columns = self.columns.into_iter().map(ColumnBuilder::finish).collect();
        let BatchBuilder { first_row, rows, keys, lines, mut others, .. } = self;
        others.iter_mut().for_each(|other| other.row += shift);
        let is_empty = rows == 0 && others.is_empty();
        (!is_empty).then_some(Batch { first_row: first_row + shift, rows, columns, keys, lines, others })
    }
}
