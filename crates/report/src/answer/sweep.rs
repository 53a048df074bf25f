//! The sets under scaled error bounds: a part of the answer of `fit`.

use serde::Serialize;

use crate::answer::parts::{ActiveJson, ActiveListJson, RangeJson, VertexJson};
use crate::number::Number;

/// The feasible sets under all error bounds times s, from one factor s to another.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SweepJson {
    /// The first factor, rounded up.
    pub from: Number,
    /// The last factor, rounded up.
    pub to: Number,
    /// The least factor that leaves a feasible parameter, rounded up; null where none does.
    pub least: Option<Number>,
    /// The factors at which the shape of the set changes, ascending, with the set there.
    pub breakpoints: Vec<BreakpointJson>,
    /// The sets between two breakpoints as functions of s.
    pub pieces: Vec<PieceJson>,
}

/// A factor at which half-planes enter or leave the shape, and the set there.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Breakpoint"))]
pub struct BreakpointJson<V = VertexJson<Number, ActiveJson>> {
    /// The factor, rounded up.
    pub s: Number,
    /// The error bound s·ε, rounded up; null where readings differ in their bounds.
    pub epsilon: Option<Number>,
    /// The kind of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::kinds())))]
    pub kind: &'static str,
    /// The vertices, counter-clockwise from the lexicographically smallest.
    pub vertices: Vec<V>,
    /// Directions in which the set goes on without end, as coprime integers.
    pub rays: Vec<[String; 2]>,
    /// Directions in which the set goes on without end both ways, as coprime integers.
    pub lines: Vec<[String; 2]>,
    /// The sides of a set without vertices.
    pub boundaries: Vec<BoundaryJson<Number>>,
    /// The parameter uncertainty intervals, rounded outward; null for an empty set.
    pub pui: Option<[RangeJson; 2]>,
    /// The area, rounded to nearest; null for an empty and for an infinite set.
    pub area: Option<Number>,
    /// The bounds that enter the shape here.
    pub entering: Vec<ActiveJson>,
    /// The bounds that leave the shape here.
    pub leaving: Vec<ActiveJson>,
}

/// The set between two breakpoints; every number is a function of s.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Piece"))]
pub struct PieceJson<V = VertexJson<LinearJson, ActiveJson>> {
    /// The factor at which it begins, rounded up.
    pub from: Number,
    /// The factor at which it ends, rounded up.
    pub to: Number,
    /// The kind of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::kinds())))]
    pub kind: &'static str,
    /// The vertices, counter-clockwise.
    pub vertices: Vec<V>,
    /// Directions in which the set goes on without end, as coprime integers.
    pub rays: Vec<[String; 2]>,
    /// Directions in which the set goes on without end both ways, as coprime integers.
    pub lines: Vec<[String; 2]>,
    /// The sides of a set without vertices.
    pub boundaries: Vec<BoundaryJson<LinearJson>>,
    /// The parameter uncertainty intervals; null for an empty set.
    pub pui: Option<[RangeJson<LinearJson>; 2]>,
    /// The area; null for an infinite set.
    pub area: Option<QuadraticJson>,
}

/// A side normal·θ ≤ offset of a set without vertices.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "{V}Boundary"))]
pub struct BoundaryJson<V> {
    /// The outer normal, as coprime integers.
    pub normal: [String; 2],
    /// The largest value of normal·θ, exact.
    pub offset: V,
    /// The half-planes behind the side.
    #[serde(flatten)]
    pub active: ActiveListJson<ActiveJson>,
}

/// The function constant + slope·s, with exact fractions.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LinearJson {
    /// The value at s = 0.
    pub constant: String,
    /// The factor of s.
    pub slope: String,
}

/// The function constant + slope·s + quadratic·s². A coefficient is null where its fraction is too long.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct QuadraticJson {
    /// The value at s = 0, an exact fraction.
    pub constant: Option<String>,
    /// The factor of s, an exact fraction.
    pub slope: Option<String>,
    /// The factor of s², an exact fraction.
    pub quadratic: Option<String>,
    /// Decimals of all three, rounded to nearest; absent if all fractions are written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub decimals: Option<[String; 3]>,
}
