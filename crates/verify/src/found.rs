//! What is found of a set.

use boundfit_exact::Rational;

/// What a feasible parameter set is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SetFound {
    /// How far the set goes.
    pub extent: Extent,
    /// How many vertices it has.
    pub vertices: usize,
    /// How many sides.
    pub sides: usize,
    /// The range of each parameter, lower and upper end; an end is `None` where nothing bounds the parameter. `None` for an
    /// empty set.
    pub bounds: Option<[[Option<Rational>; 2]; 2]>,
}

/// How far a set goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// There is no point in it.
    Empty,
    /// It lies within a circle.
    Bounded,
    /// It does not.
    Unbounded,
}
