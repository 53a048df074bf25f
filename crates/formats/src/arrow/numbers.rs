//! Arrays as columns of exact numbers.

use arrow_array::cast::AsArray;
use arrow_array::types::{
    Decimal32Type, Decimal64Type, Decimal128Type, Decimal256Type, Float32Type, Float64Type, Int8Type,
    Int16Type, Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{Array, ArrayRef, ArrowPrimitiveType};
use arrow_schema::DataType;
use boundfit_exact::{Column, DecimalMark, Rational, Reading, Shortest, Unit, WorkMeter};

use super::texts::{BadCell, refuse_nulls, text};
use crate::cells::CellReader;
use crate::columns::ColumnSelector;
use crate::columns::Role;
use crate::dialect::MissingWords;
use crate::error::InputErrorKind;
use crate::fractions::Fractions;
use crate::roles::instead_of_number;
use crate::table::TableOptions;

/// The values that a column takes from an array without a dictionary.
pub(super) fn numbers(
    array: &ArrayRef,
    selector: &ColumnSelector,
    options: &TableOptions,
    meter: &WorkMeter,
) -> Result<Column, BadCell> {
    match selector.role() {
        Role::Number | Role::NonNegative => given_numbers(array, selector, options, meter),
        Role::Presence => {
            let counts = (0..array.len()).map(|index| i128::from(!is_missing(array, index)));
            Ok(Column::of_counts(counts, Unit::TenTo(0)))
        }
        Role::Optional => optional_numbers(array, selector, options, meter),
        Role::HalfUnit => half_units(array, selector),
    }
}

/// Returns a mark for each cell, `true` where the cell has no number; `None` where all cells have one.
pub(super) fn missing(array: &ArrayRef) -> Option<Vec<bool>> {
    if !may_lack_numbers(array) {
        return None;
    }
    let missing: Vec<bool> = (0..array.len()).map(|index| is_missing(array, index)).collect();
    missing.contains(&true).then_some(missing)
}

/// Returns whether a look at each cell may find one without a number. Cost: a fraction of a nanosecond per cell.
fn may_lack_numbers(array: &ArrayRef) -> bool {
    array.null_count() > 0
        || match array.data_type() {
            // Not `any`, so that many are compared at a time.
            DataType::Float32 => {
                let floats = array.as_primitive::<Float32Type>().values();
                floats.iter().fold(false, |found, float| found | float.is_nan())
            }
            DataType::Float64 => {
                let floats = array.as_primitive::<Float64Type>().values();
                floats.iter().fold(false, |found, float| found | float.is_nan())
            }
            DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View => true,
            _ => false,
        }
}

/// The cells of text that are fractions.
pub(super) fn fractions(array: &ArrayRef) -> Fractions {
    let mut fractions = Fractions::default();
    if matches!(array.data_type(), DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View) {
        let texts = (0..array.len()).filter(|&index| array.is_valid(index));
        texts.filter_map(|index| text(array, index)).for_each(|text| fractions.count(text.as_bytes()));
    }
    fractions
}

/// Returns whether a cell has no number: null, not a number, or a word for that.
fn is_missing(array: &ArrayRef, index: usize) -> bool {
    array.is_null(index)
        || match array.data_type() {
            DataType::Float32 => array.as_primitive::<Float32Type>().value(index).is_nan(),
            DataType::Float64 => array.as_primitive::<Float64Type>().value(index).is_nan(),
            DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View => {
                text(array, index).is_none_or(|text| boundfit_exact::is_missing(&text))
            }
            _ => false,
        }
}

/// The numbers of an array, with 0 where there is none.
fn optional_numbers(
    array: &ArrayRef,
    selector: &ColumnSelector,
    options: &TableOptions,
    meter: &WorkMeter,
) -> Result<Column, BadCell> {
    let is_there: Vec<bool> = (0..array.len()).map(|index| !is_missing(array, index)).collect();
    if !is_there.contains(&false) {
        return given_numbers(array, selector, options, meter);
    }
    let mut column = Column::default();
    for (index, is_there) in is_there.into_iter().enumerate() {
        if is_there {
            let own = given_numbers(&array.slice(index, 1), selector, options, meter);
            column.append(&own.map_err(|bad| BadCell { index: Some(index), ..bad })?, 0..1);
        } else if options.reading == Reading::Binary64 {
            column.push_double(0.0);
        } else {
            column.push_decimal(0, 0);
        }
    }
    Ok(column)
}

/// Half a unit of the last digit of each cell, where the type keeps digits.
fn half_units(array: &ArrayRef, selector: &ColumnSelector) -> Result<Column, BadCell> {
    if matches!(array.data_type(), DataType::Float32 | DataType::Float64) {
        return Err(BadCell::of_column(InputErrorKind::NoDigits { format: "a column of floats" }));
    }
    let mut column = Column::default();
    for index in 0..array.len() {
        let cell = text(array, index)
            .ok_or_else(|| BadCell::of_type(array.data_type(), "a column of decimals or text"))?;
        let value =
            instead_of_number(cell.as_bytes(), selector, Some(DecimalMark::Point), &MissingWords::default());
        let value = value.map_err(|problem| BadCell::at(array, index, problem))?;
        let (mantissa, exponent) = value.unwrap_or_default();
        column.push(Rational::scientific(mantissa, exponent));
    }
    Ok(column)
}

/// The numbers of an array without a dictionary.
fn given_numbers(
    array: &ArrayRef,
    selector: &ColumnSelector,
    options: &TableOptions,
    meter: &WorkMeter,
) -> Result<Column, BadCell> {
    refuse_nulls(array)?;
    let reader = Reader { array, cells: CellReader { selector, options, meter } };
    let column = match array.data_type() {
        DataType::Int8 => reader.integers::<Int8Type>(0),
        DataType::Int16 => reader.integers::<Int16Type>(0),
        DataType::Int32 => reader.integers::<Int32Type>(0),
        DataType::Int64 => reader.integers::<Int64Type>(0),
        DataType::UInt8 => reader.integers::<UInt8Type>(0),
        DataType::UInt16 => reader.integers::<UInt16Type>(0),
        DataType::UInt32 => reader.integers::<UInt32Type>(0),
        DataType::UInt64 => reader.integers::<UInt64Type>(0),
        DataType::Decimal32(_, scale) => reader.integers::<Decimal32Type>(*scale),
        DataType::Decimal64(_, scale) => reader.integers::<Decimal64Type>(*scale),
        DataType::Decimal128(_, scale) => reader.integers::<Decimal128Type>(*scale),
        DataType::Decimal256(..) => {
            let decimals = array.as_primitive::<Decimal256Type>();
            reader.texts((0..decimals.len()).map(|index| decimals.value_as_string(index)))?
        }
        DataType::Float32 => {
            let floats = array.as_primitive::<Float32Type>().values();
            let doubles = || floats.iter().map(|&float| f64::from(float)).collect::<Vec<f64>>();
            reader.floats(floats, Column::of_shortest_f32, || Column::of_doubles(&doubles()))?
        }
        DataType::Float64 => {
            let doubles = array.as_primitive::<Float64Type>().values();
            reader.floats(doubles, Column::of_shortest, || Column::of_doubles(doubles))?
        }
        DataType::Utf8 => reader.texts(array.as_string::<i32>().iter().flatten())?,
        DataType::LargeUtf8 => reader.texts(array.as_string::<i64>().iter().flatten())?,
        DataType::Utf8View => reader.texts(array.as_string_view().iter().flatten())?,
        other => return Err(BadCell::of_type(other, "a column of integers, decimals, floats or text")),
    };
    if selector.is_non_negative()
        && let Some(index) = column.first_negative()
    {
        return Err(BadCell::at(array, index, InputErrorKind::NegativeErrorBound));
    }
    Ok(column)
}

struct Reader<'a> {
    array: &'a ArrayRef,
    cells: CellReader<'a>,
}

impl Reader<'_> {
    /// Integers that count `10^-scale`.
    fn integers<T: ArrowPrimitiveType<Native: Into<i128>>>(&self, scale: i8) -> Column {
        let values = self.array.as_primitive::<T>().values();
        self.cells.counts(values.iter().map(|&value| value.into()), -i32::from(scale))
    }

    /// Finite floats: what their shortest text says, or themselves.
    fn floats<F: Shortest>(
        &self,
        floats: &[F],
        decimals: impl FnOnce(&[F]) -> Result<Column, usize>,
        doubles: impl FnOnce() -> Result<Column, usize>,
    ) -> Result<Column, BadCell> {
        let column = self.cells.floats(floats, decimals, doubles);
        column.map_err(|(index, problem)| BadCell::at(self.array, index, problem))
    }

    /// Numbers as text.
    fn texts<S: AsRef<str>>(&self, texts: impl Iterator<Item = S>) -> Result<Column, BadCell> {
        let column = self.cells.texts(texts);
        column.map_err(|(index, problem)| BadCell::at(self.array, index, problem))
    }
}
