//! The answer of `judge`.

use boundfit_exact::Foreign;
use serde::Serialize;

use crate::answer::parts::{RangeJson, RegionJson};
use crate::number::Number;

/// The exact answer to a linear program, and the verdicts on solutions. Vectors have an entry per column, in the order of the model.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct JudgeJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The model.
    pub input: ModelJson,
    /// The status.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["optimal", "infeasible", "unbounded"])))]
    pub status: &'static str,
    /// The optimum with the constant, exact; null unless optimal.
    pub objective: Option<Number>,
    /// All optimal points; null unless optimal.
    pub face: Option<FaceJson>,
    /// The columns.
    pub columns: Vec<ModelColumnJson>,
    /// The rows.
    pub rows: Vec<ModelRowJson>,
    /// Bounds with multipliers that prove infeasibility: the forms add up to 0, the bounds to more than 0. Null unless infeasible.
    pub farkas: Option<Vec<SideTermJson>>,
    /// A feasible point, exact; null unless unbounded.
    pub point: Option<Vec<Number>>,
    /// A direction that stays feasible and improves; null unless unbounded.
    pub ray: Option<Vec<Number>>,
    /// The feasible set in the plane of the columns that bounds do not fix.
    pub plane: PlaneJson,
    /// The verdicts on solution files; absent if none was given.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub solutions: Vec<SolutionJson>,
}

/// A linear program in a file.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ModelJson {
    /// The file as it was named; null for standard input.
    pub file: Option<Foreign>,
    /// SHA-256 of the bytes of the file.
    pub sha256: String,
    /// The name of the model.
    pub name: Foreign,
    /// The sense: the objective is minimised or maximised.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["min", "max"])))]
    pub sense: &'static str,
    /// The name of the objective.
    pub objective: Foreign,
    /// The constant of the objective.
    pub constant: Number,
}

/// The optimal points: the hull of the vertices, plus multiples of the rays that are not negative and any of the lines. All exact.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FaceJson {
    /// The vertices.
    pub vertices: Vec<Vec<Number>>,
    /// A point on each line that bounds the face, where there is no vertex.
    pub points: Vec<Vec<Number>>,
    /// Directions without end.
    pub rays: Vec<Vec<Number>>,
    /// Directions without end both ways.
    pub lines: Vec<Vec<Number>>,
}

/// A column of the model.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ModelColumnJson {
    /// The name.
    pub name: Foreign,
    /// The lower bound; null where there is none.
    pub lower: Option<Number>,
    /// The upper bound; null where there is none.
    pub upper: Option<Number>,
    /// The coefficient of the objective.
    pub cost: Number,
    /// The value at the first optimal point, exact; null unless optimal.
    pub value: Option<Number>,
    /// The reduced cost, exact; null unless optimal.
    pub reduced_cost: Option<Number>,
    /// The place in the basis; null unless optimal.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["basic", "lower", "upper", "free", null])))]
    pub basis: Option<&'static str>,
}

/// A row of the model.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ModelRowJson {
    /// The name.
    pub name: Foreign,
    /// The lower bound; null where there is none.
    pub lower: Option<Number>,
    /// The upper bound; null where there is none.
    pub upper: Option<Number>,
    /// The value at the first optimal point, exact; null unless optimal.
    pub value: Option<Number>,
    /// The dual price, exact; null unless optimal.
    pub dual: Option<Number>,
    /// The place in the basis; null unless optimal.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["basic", "lower", "upper", "free", null])))]
    pub basis: Option<&'static str>,
}

/// A bound of a row or of a column.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SideJson {
    /// The name of the row; null for a column.
    pub row: Option<Foreign>,
    /// The name of the column; null for a row.
    pub column: Option<Foreign>,
    /// The bound: `lower` as it stands, `upper` negated.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::ENDS)))]
    pub side: &'static str,
}

/// A bound times a multiplier.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SideTermJson {
    /// The bound.
    #[serde(flatten)]
    pub side: SideJson,
    /// The multiplier, exact and greater than 0.
    pub multiplier: Number,
}

/// The feasible set in the plane of the columns that bounds do not fix. With fewer than two columns the missing coordinates are 0.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PlaneJson {
    /// The names of these columns, at most two.
    pub columns: Vec<Foreign>,
    /// The set.
    pub region: RegionJson<SideJson>,
    /// The range of each column, rounded outward; null for an empty set.
    pub ranges: Option<Vec<RangeJson>>,
}

/// The verdict on a solution file.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SolutionJson {
    /// The file as it was named.
    pub file: Foreign,
    /// The program whose format the file has.
    pub writer: &'static str,
    /// The status that the file states: `optimal`, `infeasible`, `unbounded`, `infeasible-or-unbounded` or other words of the solver.
    pub status: String,
    /// The worst verdict.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::WORTHS)))]
    pub verdict: &'static str,
    /// The verdict on each aspect.
    pub findings: Vec<FindingJson>,
    /// The part of the file that is not judged, and why; null where every part is.
    pub not_judged: Option<String>,
}

/// The verdict on an aspect of a solution; what does not apply is null.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FindingJson {
    /// The aspect.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["status", "objective", "primal", "optimality", "dual", "complementary-slackness", "duality-gap", "ray", "farkas"])))]
    pub aspect: &'static str,
    /// The verdict.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::WORTHS)))]
    pub verdict: &'static str,
    /// The line of the file.
    pub line: usize,
    /// The largest error, rounded up.
    pub error: Option<Number>,
    /// The error in units of its measure, rounded up.
    pub relative: Option<Number>,
    /// The row with the largest error.
    pub row: Option<Foreign>,
    /// The column with the largest error.
    pub column: Option<Foreign>,
    /// The bound with the largest error.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::or_null(&crate::answer::words::ENDS))))]
    pub bound: Option<&'static str>,
    /// The number that the file states.
    pub claimed: Option<Number>,
    /// The true number; at a bound its value.
    pub exact: Option<Number>,
    /// The tolerances that would excuse the error.
    pub tolerance: Option<ToleranceJson>,
    /// The verdict as a sentence.
    pub message: String,
}

/// The smallest tolerances that excuse an error, rounded up.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ToleranceJson {
    /// The tolerance in the units of the rows and bounds as the file has them.
    pub absolute: Number,
    /// The tolerance in units of the larger of 1, the value and the bound.
    pub relative: Number,
    /// The tolerance in the units of each row after a division by its largest coefficient.
    pub scaled: Number,
}
