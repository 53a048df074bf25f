//! What the answers have in common: intervals, names of half-planes, ends with their proofs, sets.

use std::borrow::Cow;

use serde::Serialize;

use crate::number::{Number, Reader};

/// The ends of an interval; an end is null where nothing bounds. Ends are numbers, or functions of the factor s on the error bounds.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "{V}Range"))]
pub struct RangeJson<V = Number> {
    /// The lower end; a number is rounded down. Null where nothing bounds from below.
    pub lower: Option<V>,
    /// The upper end; a number is rounded up. Null where nothing bounds from above.
    pub upper: Option<V>,
}

/// The name of a half-plane.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ActiveJson {
    /// The number of the row in the file, from 1; null for a condition and for the sign of the slope.
    pub row: Option<usize>,
    /// The bound of the row, `upper` or `lower`; or the condition, `where:1`; of an equation `where:1 upper` (≤) or `where:1 lower`
    /// (≥). Under errors in x a corner of the box follows, `upper left`, and `theta1 >= 0` is the side itself.
    pub bound: Cow<'static, str>,
}

/// The number of a row in the file, from 1.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RowNumberJson(pub usize);

/// Half-planes whose borders pass through a vertex, or are a side of the set.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "{A}List"))]
pub struct ActiveListJson<A> {
    /// The first 1,000 of these half-planes.
    pub active: Vec<A>,
    /// The number of half-planes beyond those listed; absent if there are none.
    #[serde(skip_serializing_if = "is_zero")]
    pub active_more: usize,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "as serde asks")]
pub(crate) fn is_zero<T: Default + PartialEq>(count: &T) -> bool {
    *count == T::default()
}

/// A half-plane times a positive multiplier. The sum of all terms of a proof is the claim.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TermJson {
    /// The number of the row in the file, from 1; null for a condition and for the sign of the slope.
    pub row: Option<usize>,
    /// The bound of the row or the condition, as in `active`; `facet` for a half-plane of the list `facets`.
    pub bound: Cow<'static, str>,
    /// The exact multiplier, greater than 0.
    pub multiplier: Number,
}

/// An end of an interval: a number with the terms that prove it. All forms of the number are null where nothing bounds.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BoundJson {
    /// The number in its forms.
    #[serde(flatten)]
    pub end: EndJson,
    /// The terms that prove the end; empty where nothing bounds.
    pub active: Vec<TermJson>,
}

/// The forms of an end.
#[derive(Debug, Clone)]
pub enum EndJson {
    /// A number.
    Bounded(Number),
    /// Nothing bounds: the forms that this reader gets are null.
    Unbounded(Reader),
}

/// The interval of a parameter, each end with its proof.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct IntervalJson {
    /// The lower end, rounded down.
    pub lower: BoundJson,
    /// The upper end, rounded up.
    pub upper: BoundJson,
}

/// The lines at the two ends of the slopes.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SlopesJson {
    /// The line with the largest slope; null where slopes have no upper end.
    pub largest: Option<SlopeJson>,
    /// The line with the smallest slope; null where slopes have no lower end.
    pub smallest: Option<SlopeJson>,
}

/// A line at an end of the slopes.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SlopeJson {
    /// Slope and intercept, exact.
    pub theta: [Number; 2],
    /// The side that has the line, with errors in x only: `+` (θ1 ≥ 0), `-` (θ1 ≤ 0) or `both`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::SIDES)))]
    pub side: Option<&'static str>,
    /// The bounds that the line touches.
    pub active: Vec<ActiveJson>,
}

/// A vertex of a set.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "{V}{A}Vertex"))]
pub struct VertexJson<V, A> {
    /// θ1 and θ2, exact.
    pub theta: [V; 2],
    /// The half-planes whose borders pass through the vertex.
    #[serde(flatten)]
    pub active: ActiveListJson<A>,
}

/// The proof that a set is empty.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CertificateJson {
    /// The terms, at most three, that add up to 0 ≤ a negative number.
    pub farkas: Vec<TermJson>,
}

/// A set of parameters: a convex polygon, perhaps unbounded or degenerate, or nothing.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "{A}Region"))]
pub struct RegionJson<A> {
    /// The kind of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::kinds())))]
    pub kind: &'static str,
    /// The vertices, counter-clockwise from the lexicographically smallest.
    pub vertices: Vec<VertexJson<Number, A>>,
    /// Directions in which the set goes on without end, as coprime integers.
    pub rays: Vec<[Number; 2]>,
    /// Directions in which the set goes on without end both ways, as coprime integers.
    pub lines: Vec<[Number; 2]>,
    /// The half-planes behind each side of a set without vertices; otherwise empty.
    pub boundaries: Vec<ActiveListJson<A>>,
    /// A point of the set, exact; null for the empty set.
    pub witness: Option<[Number; 2]>,
    /// The area, rounded to nearest; null for an empty and for an infinite set.
    pub area: Option<Number>,
    /// The proof that the set is empty; null for other sets and where `farkas` of the answer has it.
    pub certificate: Option<CertificateJson>,
}

/// The kind of a set, and why it is empty.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FeasibleSetJson {
    /// The kind of the set.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = crate::answer::words::kinds())))]
    pub kind: &'static str,
    /// The proof that the set is empty; null for other sets.
    pub certificate: Option<CertificateJson>,
}

/// A least-squares estimate.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LeastSquaresJson {
    /// θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error where there is one.
    pub theta: [Number; 2],
    /// True if the estimate is in the feasible set.
    pub in_fps: bool,
    /// The largest distance of each parameter to any in the feasible set, rounded up so that it covers the rounding of `theta`;
    /// null where the set is empty or unbounded.
    pub guaranteed_error: Option<[Number; 2]>,
}

/// The central estimate: the middle of the PUI box.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CentralJson {
    /// θ1 and θ2: exact fractions; decimals have the last place of the guaranteed error.
    pub theta: [Number; 2],
    /// Half the width of each interval, rounded up so that it covers the rounding of `theta`.
    pub guaranteed_error: [Number; 2],
}

/// The program that wrote a document.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProgramJson {
    /// `boundfit`.
    pub name: &'static str,
    /// The version of the program.
    pub version: &'static str,
}
