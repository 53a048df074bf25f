//! Cells as text: keys, and what messages repeat.

use arrow_array::cast::AsArray;
use arrow_array::types::{
    Decimal32Type, Decimal64Type, Decimal128Type, Decimal256Type, Float32Type, Float64Type, Int8Type,
    Int16Type, Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{Array, ArrayRef};
use arrow_schema::DataType;
use boundfit_exact::{Foreign, Reading, Shortest};

use crate::error::InputErrorKind;
use crate::scan::{Pieces, RowKeys, csv_line};

/// The problem with a column, and with which of its cells.
pub(super) struct BadCell {
    pub(super) index: Option<usize>,
    pub(super) text: Option<Foreign>,
    pub(super) problem: InputErrorKind,
}

impl BadCell {
    /// A problem with the column as a whole.
    pub(super) fn of_column(problem: InputErrorKind) -> Self {
        BadCell { index: None, text: None, problem }
    }

    /// A problem with one cell.
    pub(super) fn at(array: &dyn Array, index: usize, problem: InputErrorKind) -> Self {
        BadCell { index: Some(index), text: text(array, index).map(Foreign::from), problem }
    }

    /// A column of another type than is wanted.
    pub(super) fn of_type(data_type: &DataType, expected: &'static str) -> Self {
        BadCell::of_column(InputErrorKind::ColumnType { data_type: data_type.to_string().into(), expected })
    }
}

/// Refuses cells without a value.
pub(super) fn refuse_nulls(array: &dyn Array) -> Result<(), BadCell> {
    if array.null_count() == 0 {
        return Ok(());
    }
    let null = (0..array.len()).find(|&index| array.is_null(index));
    Err(BadCell { index: null, text: None, problem: InputErrorKind::Null })
}

/// The cells as text, as it is stored.
pub(super) fn keys(array: &ArrayRef) -> Result<RowKeys, BadCell> {
    refuse_nulls(array)?;
    let mut keys = RowKeys::default();
    for index in 0..array.len() {
        let key = text(array, index)
            .ok_or_else(|| BadCell::of_type(array.data_type(), "a column of text or of numbers"))?;
        keys.push(&key);
    }
    Ok(keys)
}

/// The rows of some columns of numbers as CSV that reads back as the same numbers in this reading.
pub(super) fn lines(columns: &[ArrayRef], reading: Reading) -> Pieces<Vec<u8>> {
    let cell = |array: &ArrayRef, row: usize| match array.data_type() {
        _ if array.is_null(row) => String::new(),
        // Its own shortest text may be nearer to another double.
        DataType::Float32 if reading == Reading::Binary64 => {
            f64::from(array.as_primitive::<Float32Type>().value(row)).to_string()
        }
        _ => text(array, row).unwrap_or_default(),
    };
    let mut lines = Pieces::<Vec<u8>>::default();
    for row in 0..columns.first().map_or(0, |column| column.len()) {
        lines.push(&csv_line(columns.iter().map(|column| cell(column, row))));
    }
    lines
}

/// A cell that is not null as a CSV would show it; `None` for types that are neither text nor numbers.
pub(super) fn text(array: &dyn Array, index: usize) -> Option<String> {
    Some(match array.data_type() {
        DataType::Utf8 => array.as_string::<i32>().value(index).to_owned(),
        DataType::LargeUtf8 => array.as_string::<i64>().value(index).to_owned(),
        DataType::Utf8View => array.as_string_view().value(index).to_owned(),
        DataType::Boolean => array.as_boolean().value(index).to_string(),
        DataType::Int8 => array.as_primitive::<Int8Type>().value(index).to_string(),
        DataType::Int16 => array.as_primitive::<Int16Type>().value(index).to_string(),
        DataType::Int32 => array.as_primitive::<Int32Type>().value(index).to_string(),
        DataType::Int64 => array.as_primitive::<Int64Type>().value(index).to_string(),
        DataType::UInt8 => array.as_primitive::<UInt8Type>().value(index).to_string(),
        DataType::UInt16 => array.as_primitive::<UInt16Type>().value(index).to_string(),
        DataType::UInt32 => array.as_primitive::<UInt32Type>().value(index).to_string(),
        DataType::UInt64 => array.as_primitive::<UInt64Type>().value(index).to_string(),
        DataType::Float32 => shortest(array.as_primitive::<Float32Type>().value(index)),
        DataType::Float64 => shortest(array.as_primitive::<Float64Type>().value(index)),
        DataType::Decimal32(..) => array.as_primitive::<Decimal32Type>().value_as_string(index),
        DataType::Decimal64(..) => array.as_primitive::<Decimal64Type>().value_as_string(index),
        DataType::Decimal128(..) => array.as_primitive::<Decimal128Type>().value_as_string(index),
        DataType::Decimal256(..) => array.as_primitive::<Decimal256Type>().value_as_string(index),
        _ => return None,
    })
}

fn shortest(float: impl Shortest) -> String {
    float.in_shortest_digits(float.to_string())
}
