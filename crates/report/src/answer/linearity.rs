//! The answer of `linearity`.

use std::collections::BTreeMap;

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::input::{FractionsJson, SelectionJson};
use crate::answer::table::TableJson;
use crate::number::Number;

/// The linearity of a calibration: the deviation of its average characteristic from four lines, hysteresis and repeatability.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LinearityJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    pub input: CalibrationJson,
    /// The average characteristic.
    #[serde(flatten)]
    pub average: CharacteristicJson,
    /// The largest difference between both directions, rounded up; null where no x was read in both.
    pub hysteresis: Option<Number>,
    /// The largest difference between readings at one x in one direction, rounded up; null where there are none.
    pub repeatability: Option<Number>,
    /// Hysteresis in percent of full scale, rounded up; null where either is unknown or full scale is 0.
    pub hysteresis_percent: Option<Number>,
    /// Repeatability in percent of full scale, rounded up; null where either is unknown or full scale is 0.
    pub repeatability_percent: Option<Number>,
    /// Each x where hysteresis is reached.
    pub hysteresis_at: Vec<PlaceJson>,
    /// Each x where repeatability is reached.
    pub repeatability_at: Vec<PlaceJson>,
    /// The points that prove the independent linearity; none where it is 0.
    pub proof: Vec<AlternatingJson>,
    /// The point x, y through which the zero-based line goes, exact.
    pub through: [Number; 2],
    /// The characteristic with rising x; null without directions.
    pub up: Option<CharacteristicJson>,
    /// The characteristic with falling x; null without directions.
    pub down: Option<CharacteristicJson>,
    /// The reason for each part that is null.
    pub reasons: BTreeMap<&'static str, String>,
}

/// The question: file, rows, columns and full scale.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CalibrationJson {
    /// The file as it was named; null for standard input.
    pub file: Option<Foreign>,
    /// The number of rows that are used.
    pub rows: usize,
    /// The number of rows in the file.
    pub rows_total: usize,
    /// The rows that were asked for; absent if all were.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub selection: Option<SelectionJson>,
    /// The number of rows that were skipped because a value is missing.
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
    /// The column of x.
    pub x: Foreign,
    /// The column of y; null where each direction has a column of its own.
    pub y: Option<Foreign>,
    /// The column of readings with rising x; null otherwise.
    pub up: Option<Foreign>,
    /// The column of readings with falling x; null otherwise.
    pub down: Option<Foreign>,
    /// The column of directions; null without one.
    pub direction: Option<DirectionJson>,
    /// The number of points of the average characteristic.
    pub points: usize,
    /// The source of full scale: the span of y, or a given number.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["span", "given"])))]
    pub full_scale: &'static str,
}

/// A column of directions.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DirectionJson {
    /// The name of the column.
    pub column: Foreign,
    /// The words for rising x.
    pub up: Vec<Foreign>,
    /// The words for falling x.
    pub down: Vec<Foreign>,
}

/// A characteristic: the mean y at each x, beside four lines.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CharacteristicJson {
    /// The number that percents refer to, exact.
    pub full_scale: Number,
    /// The largest less the smallest y, exact.
    pub span: Number,
    /// The line with the least deviation.
    pub independent: LinearityLineJson,
    /// The line through the first and the last point; null where all x are the same.
    pub terminal: Option<LinearityLineJson>,
    /// The line through the point `through` with the least deviation.
    pub zero_based: LinearityLineJson,
    /// The least-squares line; null where all x are the same.
    pub least_squares: Option<LinearityLineJson>,
}

/// A line beside a characteristic.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LinearityLineJson {
    /// The largest distance in y between characteristic and line, rounded up.
    pub deviation: Number,
    /// The deviation in percent of full scale, rounded up; null where full scale is 0.
    pub percent: Option<Number>,
    /// Slope and intercept, exact.
    pub theta: [Number; 2],
    /// The rows where the deviation is reached.
    pub rows: Vec<usize>,
    /// True if no other line of this sort serves as well.
    pub unique: bool,
}

/// An x with its rows.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PlaceJson {
    /// The value of x, exact.
    pub x: Number,
    /// The rows with this x.
    pub rows: Vec<usize>,
}

/// A point that proves the independent linearity.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AlternatingJson {
    /// The x of the point, exact.
    pub x: Number,
    /// The mean y of the point, exact.
    pub y: Number,
    /// The rows of the point.
    pub rows: Vec<usize>,
    /// y less the line, exact.
    pub residual: Number,
    /// The weight of the point in the proof, exact.
    pub weight: Number,
}
