//! The answer of `outliers`.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::answer::input::InputJson;
use crate::answer::parts::{ActiveJson, ActiveListJson, CertificateJson, RangeJson, VertexJson};
use crate::number::Number;

/// The fewest readings to exclude so that a feasible parameter is left, and all ways to do so.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OutliersJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    pub input: InputJson,
    /// The fewest readings to exclude; null where the conditions contradict each other.
    pub least: Option<usize>,
    /// Every set of `least` rows whose exclusion leaves a feasible parameter, ascending, in lexicographic order; `[[]]` where no
    /// reading has to be excluded.
    pub sets: Vec<Vec<usize>>,
    /// True if these are all sets; false beyond the limit `sets`.
    pub complete: bool,
    /// For each set, in the order of `sets`, the vertices of the parameters that remain, counter-clockwise. The pieces have no point
    /// in common; together they are the parameters that miss at most `least` readings.
    pub pieces: Vec<Vec<VertexJson<Number, ActiveJson>>>,
    /// The rest of the piece of each set, in the same order.
    pub regions: Vec<LeftRegionJson>,
    /// The ranges of θ1 and θ2 over all pieces, rounded outward; null where there are none.
    pub pui: Option<[RangeJson; 2]>,
    /// The sum of the areas of all pieces, rounded to nearest; null where it is infinite.
    pub area: Option<Number>,
    /// The parameters that miss at most 0, 1, 2, … readings, up to `least` or to the number asked for.
    pub growth: Vec<GrowthJson>,
    /// The proof that the conditions contradict each other; null otherwise.
    pub certificate: Option<CertificateJson>,
    /// The reason for each main part that is null or not complete.
    pub reasons: BTreeMap<&'static str, String>,
}

/// The parameters that remain without a set of readings, beside their vertices.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LeftRegionJson {
    /// The kind of the piece.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::kinds())))]
    pub kind: &'static str,
    /// Directions in which the piece goes on without end, as coprime integers.
    pub rays: Vec<[Number; 2]>,
    /// Directions in which the piece goes on without end both ways, as coprime integers.
    pub lines: Vec<[Number; 2]>,
    /// The half-planes behind each side of a piece without vertices; otherwise empty.
    pub boundaries: Vec<ActiveListJson<ActiveJson>>,
    /// A point of the piece, exact.
    pub witness: Option<[Number; 2]>,
    /// The ranges of θ1 and θ2 over the piece, rounded outward.
    pub pui: Option<[RangeJson; 2]>,
    /// The area, rounded to nearest; null where it is infinite.
    pub area: Option<Number>,
    /// The distance by which each excluded reading is missed; null for sets beyond the first 20,000 rows in all.
    pub missed: Option<Vec<MissedJson>>,
}

/// An excluded reading: the bound that is passed, and by how much.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MissedJson {
    /// The row.
    pub row: usize,
    /// The bound that the parameters pass; null for a row that no parameters meet.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::or_null(&crate::answer::words::ENDS))))]
    pub bound: Option<&'static str>,
    /// The amount by which they pass it, from the least to the most over the piece; null for a row that no parameters meet.
    pub by: Option<RangeJson>,
}

/// The parameters that miss at most so many readings.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct GrowthJson {
    /// The most readings that may be missed.
    pub most: usize,
    /// The number of pieces that are not connected.
    pub pieces: usize,
    /// The number of holes in them.
    pub holes: usize,
    /// The ranges of θ1 and θ2, rounded outward; null where there are no pieces.
    pub pui: Option<[RangeJson; 2]>,
    /// The area, rounded to nearest; null where there are no pieces or it is infinite.
    pub area: Option<Number>,
}
