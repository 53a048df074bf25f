//! The answer of `fit`.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::answer::input::InputJson;
use crate::answer::parts::{
    ActiveJson, CentralJson, IntervalJson, LeastSquaresJson, ProgramJson, RangeJson, RegionJson, SlopesJson,
    TermJson,
};
use crate::answer::sweep::SweepJson;
use crate::number::Number;

/// A fit: the feasible parameter set of the readings, and every estimate from it.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FitJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The program that wrote the document.
    pub program: ProgramJson,
    /// The question.
    pub input: InputJson,
    /// The least-squares estimate θ̂; null where the readings do not determine it.
    pub least_squares: Option<FitLeastSquaresJson>,
    /// The estimate uncertainty intervals of θ1 and θ2; null where they are not known.
    pub eui: Option<[RangeJson; 2]>,
    /// The feasible parameter set.
    pub fps: RegionJson<ActiveJson>,
    /// The parameter uncertainty intervals of θ1 and θ2; null where no end is bounded.
    pub pui: Option<[IntervalJson; 2]>,
    /// The central estimate; null where the set is empty or unbounded.
    pub central: Option<CentralJson>,
    /// The steepest and the shallowest line; null for an empty set and for two regressors.
    pub slopes: Option<SlopesJson>,
    /// The least error bound with a feasible parameter, rounded up; null where bounds differ between readings (see `minimax`).
    pub epsilon_min: Option<Number>,
    /// Gain and offset, which turn readings into x; null unless the model is a line.
    pub inverse: Option<InversesJson>,
    /// The minimax estimate; null where no factor on the bounds leaves a feasible parameter.
    pub minimax: Option<MinimaxJson>,
    /// The area of the feasible set over that of its PUI box, rounded to nearest; null where the box has no finite area above 0.
    pub tightness: Option<Number>,
    /// The centroid of the area, rounded to nearest; null where the set has no finite area above 0.
    pub area_centroid: Option<[Number; 2]>,
    /// The rows of an empty set whose removal alone makes it non-empty; null for other sets and where not all rows are in memory.
    pub mended_without: Option<Vec<usize>>,
    /// The reason for each main part that is null.
    pub reasons: BTreeMap<&'static str, String>,
    /// The sets under scaled error bounds; absent unless asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sweep: Option<SweepJson>,
    /// The guarantee for further readings; absent unless asked for, and where there is no least error bound.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub guarantee: Option<GuaranteeJson>,
}

/// The least-squares estimate, exact and in doubles.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FitLeastSquaresJson {
    /// The exact estimate.
    #[serde(flatten)]
    pub estimate: LeastSquaresJson,
    /// The same estimate in doubles, by `qr` and by `pseudo_inverse`; an estimate is null where its method fails. Empty where not all
    /// readings are in memory.
    pub binary64: BTreeMap<&'static str, Option<FloatJson>>,
}

/// An estimate computed in doubles.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FloatJson {
    /// θ1 and θ2 as doubles.
    pub theta: [f64; 2],
    /// The distance of each to the exact estimate, rounded up.
    pub distance: [Number; 2],
}

/// The inverse line x = gain · y + offset.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InversesJson {
    /// 1/θ1.
    pub gain: InverseJson,
    /// −θ2/θ1.
    pub offset: InverseJson,
}

/// A parameter of the inverse line.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InverseJson {
    /// The range over the feasible set: no interval, one, or two where slopes have both signs. Ends are rounded outward.
    pub exact_range: Vec<RangeJson>,
    /// The range over the PUI box, rounded outward.
    pub box_range: Vec<RangeJson>,
    /// The range over the EUI box, rounded outward; null where there is no EUI.
    pub eui_range: Option<Vec<RangeJson>>,
    /// The value for the central estimate, exact; null where there is none.
    pub central: Option<Number>,
    /// The value for the least-squares estimate, exact; null where there is none.
    pub least_squares: Option<Number>,
}

/// The estimate that survives the smallest error bounds.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MinimaxJson {
    /// θ1 and θ2, exact.
    pub theta: [Number; 2],
    /// True if no other parameter serves as well.
    pub unique: bool,
    /// The least error bound, rounded up; null where bounds differ between readings.
    pub epsilon: Option<Number>,
    /// The least common factor on the bounds, or on the widths of intervals, rounded up; null under one bound for all readings.
    pub epsilon_factor: Option<Number>,
    /// The terms that prove that no smaller bound or factor leaves a parameter.
    pub proof: Vec<TermJson>,
}

/// A guarantee for further readings.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct GuaranteeJson {
    /// The confidence that was asked for, exact.
    pub confidence: Number,
    /// The share of further readings in the band of the least error bound, rounded down; 0 where nothing is guaranteed.
    pub covered: Number,
    /// The number of readings that it follows from.
    pub readings: usize,
    /// The number of unknowns.
    pub unknowns: u32,
    /// The assumptions.
    pub assumes: Vec<String>,
    /// The source of the proof.
    pub source: &'static str,
}
