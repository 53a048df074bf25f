//! The answer of `predict`.

use std::collections::BTreeMap;

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::input::InputJson;
use crate::answer::parts::{FeasibleSetJson, RangeJson, TermJson};
use crate::number::Number;

/// The values of all feasible lines at given x, and the x that given readings may come from.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PredictionJson<A = Vec<PredictedJson>, F = Vec<SourceJson>> {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = PredictionJson::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    pub input: InputJson,
    /// The feasible parameter set.
    pub fps: FeasibleSetJson,
    /// The error of a further reading; null where nothing is known of it, with a reason.
    pub new_reading: Option<NewReadingJson>,
    /// The prediction at each value asked for; empty where the set is empty.
    pub at: A,
    /// The sources of each reading asked for; empty where the set is empty.
    pub from: F,
    /// The reason for each part that is null or empty.
    pub reasons: BTreeMap<&'static str, String>,
}

/// The bound on the error of a further reading.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NewReadingJson {
    /// The bound, rounded up; null under a law.
    pub epsilon: Option<Number>,
    /// The law as it was typed; null without one.
    pub law: Option<Foreign>,
    /// True if the bound was given for further readings; otherwise it is that of the readings.
    pub given: bool,
}

/// The prediction at one value.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PredictedJson {
    /// The value asked for, exact: x, or both regressors.
    pub x: ValueJson,
    /// The interval of the feasible lines there, rounded outward.
    pub line: RangeJson,
    /// The interval of a further reading there, rounded outward; null where nothing is known of its error.
    pub reading: Option<RangeJson>,
    /// The proof of both ends of `line`; null for an end where the set is empty. The terms of a lower end prove −φ·θ ≤ −lower.
    pub proof: RangeJson<ProofEndJson>,
}

/// An x, or both regressors.
#[derive(Debug, Serialize)]
#[serde(untagged)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum ValueJson {
    /// The x of a line.
    One(Number),
    /// The two regressors.
    Two([Number; 2]),
}

/// The proof of an end: where it is reached and the terms that prove it, or the ray along which there is none.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProofEndJson {
    /// The parameters that reach the end, exact; where there is no end, a point of the set.
    pub theta: [Number; 2],
    /// The terms that prove the end; empty where there is none.
    pub active: Vec<TermJson>,
    /// The direction along which the value goes on without end; null where there is an end.
    pub ray: Option<[Number; 2]>,
}

/// The x that a reading may come from.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SourceJson {
    /// The reading asked for, exact.
    pub y: Number,
    /// The intervals of x, ascending: none, one or two.
    pub x: Vec<PossibleJson>,
}

/// An interval of x that a reading may come from.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PossibleJson {
    /// Both ends, rounded outward; null without end.
    #[serde(flatten)]
    pub range: RangeJson,
    /// True if the lower end belongs to the interval; null without end.
    pub lower_included: Option<bool>,
    /// True if the upper end belongs to the interval; null without end.
    pub upper_included: Option<bool>,
    /// The proof of both ends; null for an end that is not there.
    pub proof: RangeJson<SourceEndJson>,
}

/// The proof of an end of x.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SourceEndJson {
    /// The end of the line's interval that decides there.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::ENDS)))]
    pub line: &'static str,
    /// The proof of that end.
    #[serde(flatten)]
    pub end: ProofEndJson,
}
