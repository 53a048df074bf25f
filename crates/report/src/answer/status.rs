//! The answer of `status`, which is written part by part while the readings are read again.

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::input::InputJson;
use crate::answer::parts::TermJson;
use crate::number::Number;

/// The status of every reading: what the set of all readings, and that of the others, say of it. Each reading is on a line of its own.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StatusesJson {
    /// The part before the readings.
    #[serde(flatten)]
    pub head: StatusHeadJson,
    /// The status of each reading.
    pub rows: Vec<StatusRowJson>,
    /// The status of further readings; absent unless asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub new: Option<NewStatusesJson>,
    /// The least total widening of the bounds of an empty set; absent unless asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub repair: Option<RepairJson>,
}

/// The part before the readings.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StatusHeadJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = StatusesJson::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    pub input: InputJson,
    /// The set of all readings.
    pub set: JudgedSetJson,
    /// The rows whose removal may change the set: those with an irredundant bound, for an empty set those of the contradiction.
    pub deciding: Vec<usize>,
}

/// The set of all readings.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct JudgedSetJson {
    /// The kind of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::kinds())))]
    pub kind: &'static str,
    /// The terms, at most three, that prove an empty set; null for other sets.
    pub contradiction: Option<Vec<TermJson>>,
}

/// The status of a reading. Leverage and residual are null where the values over the set have no end, or the reading has one
/// bound or no width; all is null against an empty set.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StatusRowJson {
    /// The row.
    pub row: usize,
    /// The width of the predicted interval over that of the reading, from the set of all readings; exact.
    pub leverage: Option<Number>,
    /// The distance of both middles over half the width of the reading, with its sign; exact.
    pub residual: Option<Number>,
    /// The status against the set of all readings.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["inner", "boundary", null])))]
    pub status: Option<&'static str>,
    /// The status against the set of the other readings.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["inner", "boundary", "outer", "strictly outer", "outlier", null])))]
    pub without: Option<&'static str>,
    /// The leverage from the set of the other readings.
    pub without_leverage: Option<Number>,
    /// The residual from the set of the other readings.
    pub without_residual: Option<Number>,
}

/// The status of further readings, against the set of all readings.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NewStatusesJson {
    /// The file of the further readings; null for standard input.
    pub file: Option<Foreign>,
    /// The status of each further reading.
    pub rows: Vec<NewStatusRowJson>,
}

/// The status of a further reading. Fields are null for the same reasons as for the readings of the set.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NewStatusRowJson {
    /// The row.
    pub row: usize,
    /// The width of the predicted interval over that of the reading; exact.
    pub leverage: Option<Number>,
    /// The distance of both middles over half the width of the reading, with its sign; exact.
    pub residual: Option<Number>,
    /// The status against the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["inner", "boundary", "outer", "strictly outer", "outlier", null])))]
    pub status: Option<&'static str>,
}

/// The least total widening that makes the set non-empty.
#[derive(Debug, Default, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RepairJson {
    /// The least sum of the factors on all widths, each at least 1, exact. Null where the bounds and conditions that stay as they
    /// are contradict each other, or not all rows are in memory.
    pub total: Option<Number>,
    /// The number of readings with a width; null where `total` is.
    pub count: Option<usize>,
    /// The parameters that meet the wider bounds, exact; null where `total` is.
    pub theta: Option<[Number; 2]>,
    /// The readings whose bounds are widened.
    pub widened: Vec<WidenedJson>,
    /// The multipliers of readings that prove the total.
    pub multipliers: Vec<RowMultiplierJson>,
    /// The terms of bounds and conditions that stay as they are, which are part of the proof.
    pub held: Vec<TermJson>,
    /// The contradiction of bounds and conditions that stay as they are; null where there is none.
    pub contradiction: Option<Vec<TermJson>>,
}

/// A reading whose bounds are widened.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WidenedJson {
    /// The row.
    pub row: usize,
    /// The factor on its width, rounded up.
    pub factor: Number,
    /// Half of the width that it needs, rounded up.
    pub half_width: Number,
}

/// The multiplier of a reading.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RowMultiplierJson {
    /// The row.
    pub row: usize,
    /// The multiplier, exact, with its sign.
    pub value: Number,
}
