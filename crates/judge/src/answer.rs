//! The exact answer to a linear program.

use boundfit_exact::Rational;
use boundfit_lp::{End, Model};

/// A row or a column, by its place in the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Item {
    /// A row.
    Row(usize),
    /// A column.
    Column(usize),
}

/// One of the two bounds of a row or a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Side {
    /// The row or column that has the bound.
    pub item: Item,
    /// The end.
    pub end: End,
}

impl Side {
    /// The bound itself, if there is one.
    pub fn bound(self, model: &Model) -> Option<&Rational> {
        let bounds = match self.item {
            Item::Row(row) => &model.rows.get(row)?.bounds,
            Item::Column(column) => &model.columns.get(column)?.bounds,
        };
        match self.end {
            End::Lower => bounds.lower.as_ref(),
            End::Upper => bounds.upper.as_ref(),
        }
    }

    /// +1 for a lower bound, `form ≥ bound`, and −1 for an upper one, `−form ≥ −bound`.
    pub fn sign(self) -> i64 {
        match self.end {
            End::Lower => 1,
            End::Upper => -1,
        }
    }
}

/// A positive multiple of a bound: of `form ≥ lower` or of `−form ≥ −upper`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SideMultiplier {
    /// The bound.
    pub side: Side,
    /// The number of times that the bound is taken.
    pub value: Rational,
}

/// The prices of rows and columns. Duals and reduced costs fulfil `cost = reduced cost + Σ dual·coefficient` in every
/// column. Let `d` be +1 for a minimum and −1 for a maximum. Then `d` times a price is positive only where the lower
/// bound is active, and negative only where the upper one is. A price is what the optimum gains for a unit of that
/// bound.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Prices {
    /// The dual of each row.
    pub rows: Vec<Rational>,
    /// The reduced cost of each column.
    pub columns: Vec<Rational>,
}

/// The optimal points: the convex hull of the vertices, plus any sum of non-negative multiples of the rays and of any
/// multiples of the lines. Points and directions have an entry per column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Face {
    /// All optimal vertices of the feasible set; none where a line is optimal.
    pub vertices: Vec<Vec<Rational>>,
    /// Points of the lines that bound the optimal points, one per line and the basis's point first, if there
    /// is no vertex. A column without bounds is 0 there.
    pub points: Vec<Vec<Rational>>,
    /// The directions of optimal rays.
    pub rays: Vec<Vec<Rational>>,
    /// The directions of optimal lines.
    pub lines: Vec<Vec<Rational>>,
}

/// The state of a column, or of the form of a row, in a basis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BasisStatus {
    /// A basic one.
    Basic,
    /// One at its lower bound.
    AtLower,
    /// One at its upper bound.
    AtUpper,
    /// One that has no bounds and is 0.
    Free,
}

/// An optimal basis: as many basic columns and rows as there are rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Basis {
    /// The status of each row.
    pub rows: Vec<BasisStatus>,
    /// The status of each column.
    pub columns: Vec<BasisStatus>,
}

/// The exact answer, with what proves it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answer {
    /// An optimum, which the prices prove.
    Optimal {
        /// The optimum, the constant of the objective included.
        value: Rational,
        /// The points that attain it.
        face: Face,
        /// Duals and reduced costs.
        prices: Prices,
        /// A basis of the first vertex, or of the first point where there is no vertex.
        basis: Basis,
    },
    /// No point fulfils all rows and bounds. The multipliers prove it: times them, `form ≥ lower` and `−form ≥ −upper` add
    /// up to `0 ≥` something positive (Farkas). Bounds of at most three rows and columns are among them, and of fixed columns.
    Infeasible {
        /// Rows first, then columns, each by their place.
        multipliers: Vec<SideMultiplier>,
    },
    /// The objective improves for ever from this feasible point.
    Unbounded {
        /// A feasible point, an entry per column.
        point: Vec<Rational>,
        /// A direction that stays feasible and improves.
        ray: Vec<Rational>,
    },
}
