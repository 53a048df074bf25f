//! The answer of `verify`.

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::parts::RangeJson;
use crate::number::Number;

/// The verdict on a proof.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VerifyJson<'a> {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = VerifyJson::SCHEMA)))]
    pub schema: &'static str,
    /// True if every statement is true of the data, and the question is the one asked. Only the rows and conditions of a theorem
    /// for Coq are compared: `coqc` alone checks what it concludes.
    pub verified: bool,
    /// The number of half-planes; null unless the proof is true.
    pub half_planes: Option<usize>,
    /// The first false statement, or the first of the differences; null when verified.
    pub falsehood: Option<String>,
    /// The differences between the question of the proof and the one asked, a sentence each.
    pub differences: &'a [String],
    /// The file of the proof; null for standard input.
    pub proof: Option<&'a str>,
    /// The file of the data; null for standard input.
    pub data: Option<&'a str>,
    /// The question of the proof, whether the proof is true or not.
    pub about: AboutJson,
    /// The proved facts about the feasible set; null unless the proof is true and about one set.
    pub set: Option<ProvedSetJson>,
    /// The number of rows of a theorem for Coq, all of which are those of the data; null for other proofs.
    pub theorem_rows: Option<usize>,
    /// The proved statements, in the order of a proof `boundfit/proof/2`; null unless the proof is true and of that kind.
    pub statements: Option<Vec<ProvedJson>>,
}

/// The question of a proof.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AboutJson {
    /// First and last number of each range of rows.
    pub rows: Vec<[u64; 2]>,
    /// The number of rows of the data; null where they were not read to the end.
    pub rows_total: Option<u64>,
    /// The reading of numbers: exactly as written, or as the nearest doubles.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::READINGS)))]
    pub reading: &'static str,
    /// True if the first row names the columns.
    pub header: bool,
    /// The character between cells.
    pub delimiter: char,
    /// The first regressor, x of a line.
    pub phi1: ColumnTimesJson,
    /// The second regressor, 1 of a line.
    pub phi2: ColumnTimesJson,
    /// The reading.
    pub y: ColumnTimesJson,
    /// The error bound.
    pub epsilon: ColumnTimesJson,
    /// The number that is taken from the column of `phi1` first.
    pub x_origin: Number,
    /// The bound on the error of `phi1`; null where x is exact.
    pub x_error: Option<ColumnTimesJson>,
    /// The columns that are added to y.
    pub response: Vec<ColumnTimesJson>,
    /// The columns of bounds that take the place of y and ε; null where there are none.
    pub interval: Option<RangeJson<BoundColumnJson>>,
    /// The terms that are added to ε above and below y; null without a law.
    pub law: Option<LawJson>,
    /// The conditions as text.
    pub conditions: Vec<String>,
}

/// A column times a number.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ColumnTimesJson {
    /// The number of the column, from 1; column 0 holds 1 in every row.
    pub column: u64,
    /// The name of the column in the header; null without one.
    pub name: Option<Foreign>,
    /// The exact number by which the column is multiplied.
    pub times: Number,
}

/// A column of bounds.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BoundColumnJson {
    /// The number of the column, from 1.
    pub column: u64,
    /// The name of the column in the header; null without one.
    pub name: Option<Foreign>,
}

/// A law of the error bound.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LawJson {
    /// The terms above y.
    pub above: Vec<LawTermJson>,
    /// The terms below y.
    pub below: Vec<LawTermJson>,
}

/// A term of a law.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LawTermJson {
    /// The quantity of the number in the column: itself, without its sign, or half a unit of its last written digit.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["number", "abs", "written"])))]
    pub quantity: &'static str,
    /// The number of the column, from 1; column 0 holds 1 in every row.
    pub column: u64,
    /// The exact number by which the quantity is multiplied.
    pub times: Number,
}

/// The proved facts about the feasible set.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProvedSetJson {
    /// The extent of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["empty", "bounded", "unbounded"])))]
    pub extent: &'static str,
    /// The number of vertices.
    pub vertices: usize,
    /// The number of sides.
    pub sides: usize,
    /// The ranges of both parameters, rounded outward; null for an empty set.
    pub ranges: Option<[RangeJson; 2]>,
}

/// A statement that is proved, and its scope.
#[derive(Debug, Default, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProvedJson {
    /// The kind of the statement.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["form", "point", "empty", "least", "set", "left out", "another"])))]
    pub kind: &'static str,
    /// First and last number of each range of rows in the scope; null for all rows.
    pub rows: Option<Vec<[u64; 2]>>,
    /// The rows that are left out.
    pub without: Vec<u64>,
    /// The numbers of the conditions in the scope, from 1; null for all conditions.
    #[serde(rename = "where")]
    pub conditions: Option<Vec<u64>>,
    /// The factor on the error bounds; null where they are as asked.
    pub factor: Option<Number>,
    /// The bound that takes the place of the error bounds; null where they are as asked.
    pub epsilon: Option<Number>,
    /// The part of the set, with errors in x; null otherwise.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["+", "-", "strong", null])))]
    pub side: Option<&'static str>,
    /// The coefficients of the form; only for `form`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub form: Option<[Number; 2]>,
    /// The range of the form, rounded outward; only for `form`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<RangeJson>,
    /// The point, exact; only for `point`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point: Option<[Number; 2]>,
    /// The extent of the set; only for `set`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["empty", "bounded", "unbounded"])))]
    pub extent: Option<&'static str>,
    /// The number of vertices; only for `set`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertices: Option<usize>,
    /// The number of sides; only for `set`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sides: Option<usize>,
    /// The number of rows to leave out at least; only for `left out`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub least: Option<u64>,
    /// The sets of so many rows; only for `left out`, and absent where they are not stated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sets: Option<Vec<Vec<u64>>>,
}
