//! The answer of `fit` with errors in x.

use std::collections::BTreeMap;

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::input::InputJson;
use crate::answer::parts::{
    ActiveJson, CentralJson, IntervalJson, ProgramJson, RangeJson, RegionJson, SlopesJson,
};
use crate::number::Number;

/// A fit of a line to readings whose x have errors, too.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct XErrorJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The program that wrote the document.
    pub program: ProgramJson,
    /// The question.
    pub input: InputJson,
    /// The bound on the errors of all x, rounded up; null where a column has them.
    pub x_epsilon: Option<Number>,
    /// The column of bounds on the errors of x; null where one bound holds for all.
    pub x_epsilon_column: Option<Foreign>,
    /// `weak`: a line agrees with a reading for some x that the errors allow; `strong`: for every such x.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["weak", "strong"])))]
    pub agreement: &'static str,
    /// The sets of lines with θ1 ≥ 0 and with θ1 ≤ 0, or the one set of both.
    pub sides: Vec<XErrorSideJson>,
    /// The number of sets that make up all of it, without one that another contains.
    pub pieces: usize,
    /// True if two sets have lines with θ1 = 0 in common; null unless there are two.
    pub joined: Option<bool>,
    /// The parameter uncertainty intervals over all sets; null where no end is bounded.
    pub pui: Option<[IntervalJson; 2]>,
    /// The central estimate; null where there are no lines or the set is unbounded.
    pub central: Option<XErrorCentralJson>,
    /// The steepest and the shallowest line; null where there are no lines.
    pub slopes: Option<SlopesJson>,
    /// The least factor on the bounds of x and y; null where it is not known.
    pub factor: Option<FactorJson>,
    /// The least-squares estimate as if every x were exact; null where the readings do not determine it.
    pub least_squares: Option<XErrorLeastSquaresJson>,
    /// The estimate uncertainty intervals as if every x were exact, rounded outward; null where they are not known.
    pub eui: Option<[RangeJson; 2]>,
    /// The reason for each main part that is null.
    pub reasons: BTreeMap<&'static str, String>,
}

/// The feasible lines of one side.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct XErrorSideJson {
    /// `+`: θ1 ≥ 0; `-`: θ1 ≤ 0; `both`: all lines.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::SIDES)))]
    pub side: &'static str,
    /// The set.
    pub fps: RegionJson<ActiveJson>,
    /// The parameter uncertainty intervals of the set; null where no end is bounded.
    pub pui: Option<[IntervalJson; 2]>,
}

/// The central estimate of all sets.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct XErrorCentralJson {
    /// The estimate.
    #[serde(flatten)]
    pub estimate: CentralJson,
    /// True if it is in one of the sets.
    pub in_fps: bool,
}

/// The least factor on the bounds of x and y that leaves a line: lower < factor ≤ upper, or both ends are the factor itself.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FactorJson {
    /// Less than the least factor, or the least factor where both ends are equal; a number of 17 digits, rounded down.
    pub lower: Number,
    /// At least the least factor; a number of 17 digits, rounded up.
    pub upper: Number,
    /// True if `upper` leaves a line.
    pub attained: bool,
    /// The side of the line, or of the last lines.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::SIDES)))]
    pub side: &'static str,
    /// A line that `upper` leaves, exact; null where there is none.
    pub theta: Option<[Number; 2]>,
    /// Bounds that leave nothing under `lower`, or under smaller factors where both ends are equal.
    pub fixed_by: Vec<ActiveJson>,
}

/// The least-squares estimate as if every x were exact.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct XErrorLeastSquaresJson {
    /// θ1 and θ2, exact.
    pub theta: [Number; 2],
    /// True if the estimate is in one of the sets.
    pub in_fps: bool,
    /// True if the estimate is in the feasible set of exact x; null where that is not known.
    pub in_fps_without_x_errors: Option<bool>,
}
