//! The facts found about a set.

use boundfit_exact::Rational;

/// The shape of a feasible parameter set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SetFound {
    /// The extent of the set.
    pub extent: Extent,
    /// The number of vertices it has.
    pub vertices: usize,
    /// The number of sides.
    pub sides: usize,
    /// The range of each parameter, lower and upper end; an end is `None` where nothing bounds the parameter. `None` for an
    /// empty set.
    pub bounds: Option<[[Option<Rational>; 2]; 2]>,
}

/// The extent of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// An empty set.
    Empty,
    /// A set within a circle.
    Bounded,
    /// A set beyond any circle.
    Unbounded,
}
