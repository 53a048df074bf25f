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
    /// The fewest runs that have all readings, one after the other; empty where a reading is in no run.
    pub fewest: Vec<PositionsJson>,
    /// Each run with what stops it, in the order of `runs`.
    pub parts: Vec<RunJson>,
    /// The readings that are in no run.
    pub alone: Vec<AloneJson>,
    /// What the readings of the longest run say; null where there is none.
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
    /// The x at both positions, exact; null where x is not known.
    pub x: Option<[Number; 2]>,
    /// The contradiction with the reading before the run; null at the first reading.
    pub before: Option<Vec<TermJson>>,
    /// The contradiction with the reading after the run; null at the last reading.
    pub after: Option<Vec<TermJson>>,
}

/// A reading that is in no run.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AloneJson {
    /// Its position.
    pub position: usize,
    /// Its row.
    pub row: usize,
    /// The contradiction within the reading, or between it and the conditions.
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
