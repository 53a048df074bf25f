//! The answer of `next`.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::answer::input::InputJson;
use crate::answer::parts::{FeasibleSetJson, RangeJson};
use crate::answer::predict::NewReadingJson;
use crate::number::Number;

/// The x where one more reading certainly makes the feasible set smaller, and the best x of a range.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NextReadingJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    pub input: InputJson,
    /// The feasible parameter set.
    pub fps: FeasibleSetJson,
    /// The error of the next reading.
    pub new_reading: NewReadingJson,
    /// The open intervals of x, ascending, where a reading certainly makes the set smaller. Decimals and doubles are rounded inward. Null
    /// where the set is empty.
    pub certain: Option<Vec<RangeJson>>,
    /// The range in which the best x is looked for; null where the set is empty or the x of the readings are not known.
    pub within: Option<SearchRangeJson>,
    /// True if a reading certainly makes the set smaller somewhere in `within`; null where `within` is.
    pub certain_within: Option<bool>,
    /// The best x of the range for each goal; empty where `within` is null.
    pub goals: Vec<GoalJson>,
    /// The reason for each part that is null and for each goal that is left out.
    pub reasons: BTreeMap<&'static str, String>,
}

/// A range of x, both ends included.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SearchRangeJson {
    /// The lower end, exact.
    pub lower: Number,
    /// The upper end, exact.
    pub upper: Number,
    /// True if the range was given; otherwise it is that of the readings.
    pub given: bool,
}

/// The best x for a goal.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct GoalJson {
    /// The goal: the length of a parameter's interval, or the area of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = boundfit_questions::Goal::ALL.map(boundfit_questions::Goal::name))))]
    pub goal: &'static str,
    /// The value of the goal before the reading, rounded up; null where it has no bound.
    pub now: Option<Number>,
    /// The largest value after a reading at the best x, rounded up; null where it has no bound.
    pub worst: Option<Number>,
    /// The best x, exact, ascending; empty where the worst outcome leaves the goal as it is at every x of the range.
    pub at: Vec<Number>,
}
