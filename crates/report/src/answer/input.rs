//! What an answer is about: file, rows, columns, model and error bound.

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::parts::is_zero;
use crate::answer::table::TableJson;
use crate::number::Number;

/// The question: file, rows, columns, model, error bound and conditions.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InputJson {
    /// The file as it was named; null for standard input.
    pub file: Option<Foreign>,
    /// The number of rows that are used.
    pub rows: usize,
    /// The number of rows in the file.
    pub rows_total: usize,
    /// The rows that were asked for; absent if all were.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub selection: Option<SelectionJson>,
    /// The number of rows that were skipped because a value is missing; absent if there are none.
    #[serde(skip_serializing_if = "is_zero")]
    pub rows_missing: usize,
    /// The format of the table as it was read; null for files that are neither text nor a sheet nor JSON.
    pub table: Option<TableJson>,
    /// The columns whose cells are fractions; absent if there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fractions: Vec<FractionsJson>,
    /// The reading of numbers: exactly as written, or as the nearest doubles.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::READINGS)))]
    pub reading: &'static str,
    /// SHA-256 of the bytes of the file; null where they were not hashed.
    pub sha256: Option<String>,
    /// `line-through-origin` means that θ2 is 0.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["line", "line-through-origin", "two-regressors"])))]
    pub model: &'static str,
    /// The column of x, or both columns of the regressors.
    pub x: Vec<Foreign>,
    /// The column of y; null where readings have only bounds.
    pub y: Option<Foreign>,
    /// The units of columns and parameters; absent if no name of a column has a unit, as in `U (mV)` or `U [mV]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub units: Option<UnitsJson>,
    /// The error bound ε of all readings, rounded up; null where each reading has its own.
    pub epsilon: Option<Number>,
    /// The column of error bounds; null where there is none.
    pub epsilon_column: Option<Foreign>,
    /// The law of the error bound as it was typed; absent without a law.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub epsilon_law: Option<Foreign>,
    /// The columns of bounds that take the place of y and ε; absent if there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interval: Option<IntervalColumnsJson>,
    /// The multiple of the least error bound that was asked for, as `1.2*min`; absent otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub epsilon_from_least: Option<FromLeastJson>,
    /// The value from which x is counted, exact; absent if it is 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x_origin: Option<Number>,
    /// The conditions on the parameters as they were typed.
    pub r#where: Vec<Foreign>,
}

/// A column whose cells are fractions such as `3/4`.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FractionsJson {
    /// The name of the column.
    pub column: Foreign,
    /// The number of cells that are fractions.
    pub cells: usize,
    /// The first such cell.
    pub first: Foreign,
}

/// The rows that were asked for.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SelectionJson {
    /// The rows by number, such as `5,14-36`; null if not asked for.
    pub rows: Option<String>,
    /// The excluded rows by number; null if there are none.
    pub without: Option<String>,
    /// The conditions on cells, such as `V >= -6`.
    pub where_row: Vec<Foreign>,
}

/// An error bound that was found from the readings themselves.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FromLeastJson {
    /// The multiple that was asked for, exact.
    pub factor: Number,
    /// The least error bound that leaves a feasible parameter, rounded up.
    pub epsilon_min: Number,
    /// The assumption behind such a bound.
    pub assumes: &'static str,
}

/// The columns of bounds on each reading; one of them may be null.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct IntervalColumnsJson {
    /// The column of lower bounds; null where there is none.
    pub lower: Option<Foreign>,
    /// The column of upper bounds; null where there is none.
    pub upper: Option<Foreign>,
}

/// Units from the names of columns, and the units of the parameters that follow; null where unknown.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct UnitsJson {
    /// The unit of each column of x.
    pub x: Vec<Option<String>>,
    /// The unit of y.
    pub y: Option<String>,
    /// The unit of θ1.
    pub theta1: Option<String>,
    /// The unit of θ2.
    pub theta2: Option<String>,
}

/// The input of a report that has a line per answer: the same for all lines.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LineInputJson<'a> {
    /// The format of the table as it was read; null for files that are neither text nor a sheet nor JSON.
    pub table: Option<&'a TableJson>,
    /// The JSON of this.
    #[serde(skip)]
    pub(crate) written: &'a str,
}
