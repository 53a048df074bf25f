//! The answer of `check`.

use std::borrow::Cow;

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::input::FromLeastJson;
use crate::answer::parts::TermJson;
use crate::answer::table::TableJson;
use crate::number::Number;

/// The verdicts on the answers of LP solvers to the four linear programs of a fit.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CheckJson<'a> {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = CheckJson::SCHEMA)))]
    pub schema: &'static str,
    /// The data of the answers.
    pub input: CheckInputJson<'a>,
    /// The tolerance that was asked for.
    pub tolerance: Number,
    /// True if a claim may be off by the rounding of its last printed digit.
    pub digits_as_printed: bool,
    /// The readings of the programs.
    pub readings: ReadingsJson,
    /// The answers, judged.
    pub claims: Vec<ClaimJson>,
    /// The worst verdict against the data as read, which decides the exit status; null without answers.
    pub worst: Option<WorstJson>,
    /// The worst verdict against the doubles that a solver receives; null where no answer is judged by them.
    pub worst_as_received: Option<WorstJson>,
    /// Approximations of the set by linear programs in many directions; null unless asked for.
    pub directions: Option<DirectionsJson>,
}

/// The readings of the programs.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReadingsJson {
    /// The number of readings with rows in the programs; the others cannot bound anything.
    pub asked: usize,
    /// The number of readings that are fitted.
    pub fitted: usize,
}

/// The data of the answers.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CheckInputJson<'a> {
    /// The file as it was named; null for standard input.
    pub file: Option<Foreign<&'a str>>,
    /// The format of the table as it was read; null for files that are neither text nor a sheet nor JSON.
    pub table: Option<TableJson>,
    /// The multiple of the least error bound that was asked for, as `1.2*min`; absent otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub epsilon_from_least: Option<FromLeastJson>,
}

/// The worst verdict against one reading of the data.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WorstJson {
    /// The verdict.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::VERDICTS)))]
    pub verdict: &'static str,
    /// The reading of numbers.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::READINGS)))]
    pub reading: &'static str,
    /// True if the verdict is a refutation.
    pub refuted: bool,
}

/// The answers of one source.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ClaimJson {
    /// The name of the solver or file.
    pub source: Foreign,
    /// The data that the answers are judged against.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::READINGS)))]
    pub reading: &'static str,
    /// The four ends, judged.
    pub bounds: Vec<ClaimedEndJson>,
    /// The worst verdict.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::VERDICTS)))]
    pub verdict: &'static str,
}

/// A claimed end of a parameter's interval, judged.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ClaimedEndJson {
    /// The parameter.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["theta1", "theta2"])))]
    pub target: &'static str,
    /// The end.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::ENDS)))]
    pub end: &'static str,
    /// The claimed end; null where none is claimed.
    pub claimed: Option<Number>,
    /// The verdict.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::VERDICTS)))]
    pub verdict: &'static str,
    /// The rounding that explains the claim; null unless the verdict is `rounded`.
    pub rounded_to: Option<RoundedToJson>,
    /// The true end, rounded outward; null where there is none.
    pub exact: Option<Number>,
    /// The distance of the claim outside the true interval, exact; negative inside.
    pub excess: Option<Number>,
    /// The excess in units in the last place of a double at the true end.
    pub excess_in_ulps: Option<Number>,
    /// The excess in `unit`; without its sign it is the smallest tolerance that excuses the claim.
    pub excess_in_units: Option<Number>,
    /// The unit: the `width` of the true interval; where that is 0 or infinite the `value` of the end, else `eps`.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["width", "value", "eps", null])))]
    pub unit: Option<&'static str>,
    /// The smallest τ with the claimed point in FPS(ε + τ), rounded up; null without a point.
    pub tau: Option<Number>,
    /// τ in units of ε, rounded up; null without a point.
    pub tau_in_epsilon: Option<Number>,
    /// The row of the half-plane that the claimed point violates most; null for a condition and without a violation.
    pub row: Option<usize>,
    /// The bound of that half-plane; null without a violation.
    pub bound: Option<Cow<'static, str>>,
    /// The amount by which the point violates it, exact; null without a violation.
    pub violation: Option<Number>,
    /// A feasible point that an unsafe end cuts off, exact; null for other verdicts.
    pub witness: Option<[Number; 2]>,
    /// The proof of a wrong status; null for other verdicts.
    pub proof: Option<EvidenceJson>,
    /// True if the rows with the largest duals prove the true end; null without duals, or with another number of them than rows.
    pub repairable: Option<bool>,
    /// The reason why there is no answer, or which duals are ignored and why; null otherwise.
    pub reason: Option<String>,
}

/// The rounding that explains a claim.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RoundedToJson {
    /// The target: doubles, or decimal digits.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["binary64", "digits"])))]
    pub kind: &'static str,
    /// The number of significant digits; null for doubles.
    pub digits: Option<usize>,
}

/// The proof of a wrong status.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EvidenceJson {
    /// The fact about the program that it shows.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["infeasible", "bounded", "feasible", "unbounded"])))]
    pub shows: &'static str,
    /// Rows with multipliers; empty for `feasible` and `unbounded`.
    pub rows: Vec<TermJson>,
    /// A feasible point, exact; null for `infeasible` and `bounded`.
    pub theta: Option<[Number; 2]>,
    /// A direction without end; null unless it shows `unbounded`.
    pub ray: Option<[Number; 2]>,
}

/// Approximations of the set by linear programs in many directions.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DirectionsJson {
    /// The number of directions.
    pub count: usize,
    /// True if directions are even after both parameters are scaled by their intervals.
    pub scaled: bool,
    /// The number of directions without an optimum.
    pub unbounded: usize,
    /// The hull of the optimal points; null where there are none.
    pub inner: Option<ApproximationJson>,
    /// The set itself.
    pub exact: ApproximationJson,
    /// The intersection of the half-planes of all optima; null where there are none.
    pub outer: Option<ApproximationJson>,
}

/// A polygon.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ApproximationJson {
    /// The vertices, exact.
    pub vertices: Vec<[Number; 2]>,
    /// The area; null where it is infinite.
    pub area: Option<Number>,
}
