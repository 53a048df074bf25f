//! The answer of a window and that of a group: a line of JSON for each.

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::input::LineInputJson;
use crate::answer::parts::{
    CentralJson, CertificateJson, FeasibleSetJson, IntervalJson, LeastSquaresJson, RangeJson,
};
use crate::number::Number;

/// A window of consecutive readings, and what they say.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WindowJson<'a> {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = WindowJson::SCHEMA)))]
    pub schema: &'static str,
    /// The input, the same for all lines.
    pub input: LineInputJson<'a>,
    /// The row of the first reading of the window.
    pub first_row: usize,
    /// The row of the last reading of the window.
    pub last_row: usize,
    /// The number of readings in it.
    pub rows: usize,
    /// The x of the oldest and of the newest reading, exact; null with two regressors.
    pub x: Option<[Number; 2]>,
    /// The feasible parameter set of the window.
    pub fps: FeasibleSetJson,
    /// The parameter uncertainty intervals; null where no end is bounded.
    pub pui: Option<[IntervalJson; 2]>,
    /// The central estimate; null where the set is empty or unbounded.
    pub central: Option<CentralJson>,
    /// The least error bound with a feasible parameter, rounded up; null unless the model is a line under one bound without
    /// conditions.
    pub epsilon_min: Option<Number>,
}

/// A group of readings, and what they say.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct GroupJson<'a> {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = GroupJson::SCHEMA)))]
    pub schema: &'static str,
    /// The input, the same for all lines.
    pub input: LineInputJson<'a>,
    /// The text in the column of groups.
    pub group: Foreign<&'a str>,
    /// The number of readings of the group.
    pub rows: usize,
    /// The first row of the group; null where rows are not kept.
    pub first_row: Option<usize>,
    /// The least-squares estimate; null where the readings do not determine it.
    pub least_squares: Option<LeastSquaresJson>,
    /// The estimate uncertainty intervals, rounded outward; null where they are not known.
    pub eui: Option<[RangeJson; 2]>,
    /// The feasible parameter set of the group.
    pub fps: GroupSetJson,
    /// The parameter uncertainty intervals; null where no end is bounded.
    pub pui: Option<[IntervalJson; 2]>,
    /// The central estimate; null where the set is empty or unbounded.
    pub central: Option<CentralJson>,
    /// The least error bound with a feasible parameter, rounded up; null where bounds differ between readings.
    pub epsilon_min: Option<Number>,
    /// The least common factor on the bounds that leaves a feasible parameter, rounded up; null under one bound for all readings.
    pub epsilon_factor: Option<Number>,
}

/// The feasible parameter set of a group.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct GroupSetJson {
    /// The kind of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::kinds())))]
    pub kind: &'static str,
    /// The number of vertices.
    pub vertex_count: usize,
    /// The proof that the set is empty; null for other sets.
    pub certificate: Option<CertificateJson>,
}
