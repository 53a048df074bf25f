//! The answer of `range`.

use serde::Serialize;

use crate::answer::input::InputJson;
use crate::answer::parts::{CentralJson, IntervalJson, TermJson};
use crate::number::Number;

/// The runs of consecutive readings that one line fits. Positions count from 1 in `order`.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LinearRangeJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    pub input: InputJson,
    /// The order of the readings: by x, or by row.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["x", "row"])))]
    pub by: &'static str,
    /// The row at each position.
    pub order: Vec<usize>,
    /// First and last position of each run that cannot be made longer, ascending.
    pub runs: Vec<PositionsJson>,
    /// The run with the most readings; null where no reading fits.
    pub longest: Option<PositionsJson>,
    /// The run with the widest range of x; null where the order is not by x or x is not known.
    pub widest: Option<PositionsJson>,
    /// The fewest runs that together have every reading that is in a run.
    pub fewest: Vec<PositionsJson>,
    /// Each run with what stops it, in the order of `runs`.
    pub parts: Vec<RunJson>,
    /// The readings that are in no run.
    pub alone: Vec<AloneJson>,
    /// The fit of the longest run; null where there is none.
    pub longest_fit: Option<LongestJson>,
}

/// First and last position, from 1.
pub type PositionsJson = [usize; 2];

/// A run with what stops it.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RunJson {
    /// The first position.
    pub first: usize,
    /// The last position.
    pub last: usize,
    /// The rows at both positions.
    pub rows: [usize; 2],
    /// The least and the largest x, exact; null where x is not known.
    pub x: Option<[Number; 2]>,
    /// The terms that contradict each other once the readings at the x before the run are added (by row: the reading before it); null at
    /// the first reading.
    pub before: Option<Vec<TermJson>>,
    /// The same of the readings after the run; null at the last reading.
    pub after: Option<Vec<TermJson>>,
}

/// A reading that is in no run.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AloneJson {
    /// The position of the reading.
    pub position: usize,
    /// The row of the reading.
    pub row: usize,
    /// The terms by which the readings at its x contradict each other or the conditions.
    pub farkas: Vec<TermJson>,
}

/// The feasible set of the longest run.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LongestJson {
    /// The kind of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::kinds())))]
    pub kind: &'static str,
    /// The parameter uncertainty intervals; null where no end is bounded.
    pub pui: Option<[IntervalJson; 2]>,
    /// The central estimate; null where the set is unbounded.
    pub central: Option<CentralJson>,
    /// The least error bound with a feasible parameter, rounded up; null where bounds differ between readings.
    pub epsilon_min: Option<Number>,
}
