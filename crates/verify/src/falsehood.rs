//! The falsehoods of a proof.

use std::fmt;

use boundfit_exact::{Foreign, ParseNumberError, Rational};

use crate::name::Name;

/// The first statement that is false: its place in the proof or the data, and what is wrong there.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Falsehood {
    /// The data have another SHA-256.
    OtherData,
    /// The wanted rows are not pairs of a first and a last row that ascend from row 1 on.
    NoRows,
    /// The data end before this wanted row.
    MissingRow(u64),
    /// A wanted row does not have this column, from 1.
    MissingCell {
        /// The data row, from 1.
        row: u64,
        /// The column, from 1.
        column: usize,
    },
    /// A cell of a wanted row is not a number.
    NotANumber {
        /// The data row, from 1.
        row: u64,
        /// The column, from 1.
        column: usize,
        /// The problem of the text.
        error: ParseNumberError,
    },
    /// The error bound of this row is negative.
    NegativeErrorBound(u64),
    /// A cell without a last digit, of which a law takes half a unit.
    NoLastDigit {
        /// The row, from 1.
        row: u64,
        /// The column, from 1.
        column: usize,
    },
    /// The data and the conditions give no half-plane of this name.
    UnknownHalfPlane(Foreign),
    /// A sum takes more half-planes than this.
    TooManyMultipliers(usize),
    /// The multiplier of this half-plane is not positive.
    MultiplierNotPositive(Name),
    /// The sum that should show that the set is empty is true of some points, or the empty set has parts.
    NotEmpty,
    /// This side names a vertex that is not in the list.
    UnknownVertex(Name),
    /// The angle of this side is not larger than that of the side before it.
    OutOfOrder(Name),
    /// This side and the next one do not meet at the vertex, or in the gap, between them.
    DoNotMeet(Name),
    /// A vertex is named by no side, or two are one point.
    StrayVertex,
    /// This half-plane does not contain the whole set.
    CutsOff(Name),
    /// The lists of what touches a vertex miss this, or have it though it does not touch.
    NotTouching {
        /// The vertex, an index from 0.
        vertex: u64,
        /// The half-plane.
        half_plane: Foreign,
    },
    /// The set is not empty, and the bounds are not four.
    NotFourBounds,
    /// The bound in this direction is not proved.
    NotABound([i64; 2]),
    /// Something about a statement of several.
    InStatement {
        /// The number of the statement, from 1.
        number: usize,
        /// The problem.
        falsehood: Box<Falsehood>,
    },
    /// A factor or a bound on errors is negative.
    NegativeScale,
    /// A scope has a side where x has no errors, or none where it has.
    NoSide,
    /// This half-plane of the scope does not contain a point that should be in its set.
    Outside(Name),
    /// One leaves this half-plane of the scope along a ray that should stay in its set.
    Leaves(Name),
    /// An end of a form's range is not proved.
    NotAnEnd {
        /// True if it is the upper one.
        is_upper: bool,
    },
    /// Half-planes do not add up to 0 ≤ a negative number.
    NoContradiction,
    /// The errors are not shown to be the least.
    NotLeast,
    /// These rows may be left out, and it is not shown that others must be as well.
    MayBeEnough(Vec<u64>),
    /// These are not so many different rows of the scope as have to be left out, or are listed before.
    NotASet(Vec<u64>),
    /// No statement shows that anything is left without these rows.
    NotShownToBeEnough(Vec<u64>),
    /// A statement that at least no row has to be left out says nothing.
    NoRowsToLeaveOut,
    /// A theorem has another number in a row than the data.
    OtherNumber(Box<OtherNumber>),
    /// A theorem has another number of rows than are wanted of the data.
    OtherCount {
        /// Rows of the theorem.
        theorem: usize,
        /// Wanted rows of the data.
        data: u64,
    },
    /// This condition of a theorem, from 1, is not that of its question.
    OtherCondition(usize),
}

/// A number that a theorem and the data have in one place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OtherNumber {
    /// The data row, from 1.
    pub row: u64,
    /// The name of the number in the theorem.
    pub name: &'static str,
    /// The number of the theorem; `None` where it has none.
    pub theorem: Option<Rational>,
    /// The number of the data; `None` where they have none.
    pub data: Option<Rational>,
}

impl fmt::Display for OtherNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = |own: &Option<Rational>| own.as_ref().map_or("no number".to_owned(), Rational::to_string);
        let (theorem, data) = (text(&self.theorem), text(&self.data));
        write!(f, "row {}, {}: {theorem} in the theorem, {data} in the data", self.row, self.name)
    }
}

impl fmt::Display for Falsehood {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Falsehood::OtherData => write!(f, "sha256: is not that of the data"),
            Falsehood::NoRows => write!(f, "rows: are no pairs of a first and a last row that ascend"),
            Falsehood::MissingRow(row) => write!(f, "row {row}: is not in the data"),
            Falsehood::MissingCell { row, column } => write!(f, "row {row}, column {column}: is missing"),
            Falsehood::NotANumber { row, column, error } => write!(f, "row {row}, column {column}: {error}"),
            Falsehood::NoLastDigit { row, column } => {
                write!(f, "row {row}, column {column}: has no last digit, of which the law takes half a unit")
            }
            Falsehood::NegativeErrorBound(row) => write!(f, "row {row}: the error bound is negative"),
            Falsehood::UnknownHalfPlane(name) => write!(f, "{}: is no half-plane of the data", name.quoted()),
            Falsehood::TooManyMultipliers(most) => write!(f, "multipliers: more than {most}"),
            Falsehood::MultiplierNotPositive(name) => write!(f, "multipliers: {name}: is not positive"),
            Falsehood::NotEmpty => {
                write!(
                    f,
                    "farkas: does not add up to 0 <= a negative number, or the empty set has vertices, sides or bounds"
                )
            }
            Falsehood::UnknownVertex(side) => write!(f, "sides: {side}: there is no such vertex"),
            Falsehood::OutOfOrder(side) => write!(f, "sides: {side}: does not come next by its angle"),
            Falsehood::DoNotMeet(side) => write!(f, "sides: {side}: does not meet the next side like that"),
            Falsehood::StrayVertex => write!(f, "vertices: one is on no side, or there twice"),
            Falsehood::CutsOff(name) => write!(f, "{name}: cuts off a part of the set"),
            Falsehood::NotTouching { vertex, half_plane } => {
                write!(f, "active: {} at vertex {vertex} is missing or does not touch", half_plane.quoted())
            }
            Falsehood::NotFourBounds => write!(f, "bounds: are not four"),
            Falsehood::NotABound(direction) => write!(f, "bounds: in direction {direction:?}: is not proved"),
            Falsehood::InStatement { number, falsehood } => write!(f, "statement {number}: {falsehood}"),
            Falsehood::NegativeScale => write!(f, "factor or epsilon: is negative"),
            Falsehood::NoSide => write!(f, "side: is there where x has no errors, or missing where it has"),
            Falsehood::Outside(name) => write!(f, "{name}: does not contain the point"),
            Falsehood::Leaves(name) => write!(f, "{name}: does not contain the ray"),
            Falsehood::NotAnEnd { is_upper: true } => write!(f, "upper: is not proved"),
            Falsehood::NotAnEnd { is_upper: false } => write!(f, "lower: is not proved"),
            Falsehood::NoContradiction => write!(f, "multipliers: do not add up to 0 <= a negative number"),
            Falsehood::NotLeast => write!(f, "multipliers: do not show that it is the least"),
            Falsehood::MayBeEnough(rows) => {
                write!(f, "contradictions: none is shown without {}", listed(rows))
            }
            Falsehood::NotASet(rows) => {
                let rows = listed(rows);
                write!(
                    f,
                    "sets: {rows}: not as many different rows of the scope as \"least\", or there twice"
                )
            }
            Falsehood::NotShownToBeEnough(rows) => {
                write!(f, "sets: no statement shows that anything is left without {}", listed(rows))
            }
            Falsehood::OtherNumber(other) => write!(f, "{other}"),
            Falsehood::OtherCount { theorem, data } => {
                write!(f, "rows: {theorem} in the theorem, {data} in the data")
            }
            Falsehood::OtherCondition(number) => write!(f, "condition {number}: is not that of the question"),
            Falsehood::NoRowsToLeaveOut => write!(f, "least: 0 says nothing without sets"),
        }
    }
}

fn listed(rows: &[u64]) -> String {
    let rows: Vec<String> = rows.iter().take(6).map(u64::to_string).collect();
    if rows.is_empty() { "no row".to_owned() } else { rows.join(", ") }
}

impl std::error::Error for Falsehood {}

/// Adds the number of the statement to what is false in it.
pub(crate) fn in_statement<T>(number: usize, found: Result<T, Falsehood>) -> Result<T, Falsehood> {
    found.map_err(|falsehood| Falsehood::InStatement { number, falsehood: Box::new(falsehood) })
}
