//! The answer of `polygon`.

use std::collections::BTreeMap;

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::parts::{IntervalJson, RegionJson, RowNumberJson};
use crate::answer::table::TableJson;
use crate::number::Number;

/// The set that half-planes or generators of a file make.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PolygonJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    pub input: HalfPlaneFileJson,
    /// The set; `active` are rows of half-planes, or of generators the points that equal a vertex or are on a boundary.
    pub region: RegionJson<RowNumberJson>,
    /// The rows that are not needed.
    pub redundant: Vec<usize>,
    /// The half-planes of a set that was given by generators; proofs name them by their number here, from 1. Absent otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub facets: Option<Vec<HalfPlaneJson>>,
    /// The ranges of both coordinates with their proofs; null where no end is bounded.
    pub bounds: Option<[IntervalJson; 2]>,
    /// The centroid of the area, rounded to nearest; null where the set has no finite area above 0.
    pub area_centroid: Option<[Number; 2]>,
    /// The square of the largest distance of two points, exact; null for an empty and for an unbounded set.
    pub squared_diameter: Option<Number>,
    /// For each number whose fraction is too long to be written, the reason; absent if there are none.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub reasons: BTreeMap<&'static str, String>,
}

/// A file of half-planes or generators.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HalfPlaneFileJson {
    /// The file as it was named; null for standard input.
    pub file: Option<Foreign>,
    /// The number of rows.
    pub rows: usize,
    /// The format of the table as it was read; null for files that are neither text nor a sheet nor JSON.
    pub table: Option<TableJson>,
    /// The reading of numbers: exactly as written, or as the nearest doubles.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::READINGS)))]
    pub reading: &'static str,
    /// SHA-256 of the bytes of the file.
    pub sha256: String,
}

/// The half-plane a·θ ≤ b.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HalfPlaneJson {
    /// The normal, exact.
    pub a: [Number; 2],
    /// The offset, exact.
    pub b: Number,
}
