//! Readings of a line as points with integer coordinates, and the few of them that count.
//!
//! Decimal columns are integers on a common power of ten. Of such points only those on the lower or the upper hull
//! bound the parameters of a line under a uniform error bound: [`touching`] finds them by exact integer arithmetic,
//! [`touching_of_columns`] and [`touching_doubles`] after a float filter that discards only what is certainly strictly
//! between the hulls, and [`line_region`] makes the region from them.
//!
//! ```
//! use boundfit_exact::Rational;
//! use boundfit_geometry::grid::{GridLine, line_region, touching_of_columns};
//!
//! // x = 1.0, 2.0, 3.0, 4.0 and y = 0.51, 0.98, 1.48, 2.02, each within 0.05.
//! let touching = touching_of_columns(&[10, 20, 30, 40], &[51, 98, 148, 202], 0);
//! let line = GridLine {
//!     x_unit: Rational::ratio(1, 10),
//!     y_unit: Rational::ratio(1, 100),
//!     epsilon: Rational::ratio(5, 100),
//! };
//! let region = line_region(&touching, &line).expect("a polygon");
//! assert_eq!(region.vertices().len(), 4);
//! ```

mod cells;
mod chain;
mod columns;
mod doubles;
mod envelopes;
mod filter;
mod region;
mod sample;
mod sieve;

use std::cmp::Ordering;

#[doc(hidden)]
pub use columns::touching_of_columns_by;
pub use columns::{candidates_of_columns, touching_of_columns};
pub use doubles::touching_doubles;
#[doc(hidden)]
pub use doubles::touching_doubles_by;
#[doc(hidden)]
pub use filter::{Division, Plan};
pub use region::{GridLine, line_region};
pub use sieve::Sieve;

use chain::marked;

/// A point with integer coordinates that stands for a reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GridPoint {
    /// Abscissa, in some unit.
    pub x: i64,
    /// Ordinate, in some unit.
    pub y: i64,
    /// Which reading it is.
    pub id: u64,
}

/// Below this in absolute value, differences of coordinates fit into 64 bits and orientations into 128.
const NARROW: u64 = 1 << 62;

/// Of the points, those on the lower or the upper hull: corners, points within hull edges, points on the hull's vertical
/// ends that are lowest or highest at their x, and every repetition of each; sorted by x, then y, then id. The others
/// are strictly between the two hulls.
///
/// Exact for all coordinates. It depends on the set of points alone, so that parts can be reduced first:
/// `touching(touching(A) ∪ touching(B)) == touching(A ∪ B)`. Cost: O(n log n); linear for sorted points.
pub fn touching(mut points: Vec<GridPoint>) -> Vec<GridPoint> {
    points.sort_unstable();
    let kept = if is_narrow(&points) {
        marked(&points, narrow_orientation)
    } else {
        marked(&points, wide_orientation)
    };
    let mut kept = kept.into_iter();
    points.retain(|_| kept.next().unwrap_or(false));
    points
}

impl chain::Site for GridPoint {
    fn is_above_or_below(&self, other: &Self) -> bool {
        self.x == other.x
    }
}

impl chain::Repeatable for GridPoint {
    fn coincides(&self, other: &Self) -> bool {
        self.x == other.x && self.y == other.y
    }
}

/// Whether [`narrow_orientation`] is exact for all these points.
fn is_narrow(points: &[GridPoint]) -> bool {
    points.iter().all(|point| point.x.unsigned_abs() < NARROW && point.y.unsigned_abs() < NARROW)
}

/// `Greater` when the way from `p` over `q` to `r` turns left; exact for coordinates within ±2⁶².
fn narrow_orientation(p: &GridPoint, q: &GridPoint, r: &GridPoint) -> Ordering {
    // Differences of numbers within ±2⁶² do not wrap.
    let difference = |to: i64, from: i64| i128::from(to.wrapping_sub(from));
    // Nor do products of two of them: they are within ±2¹²⁶.
    let product = |left: i128, right: i128| left.wrapping_mul(right);
    product(difference(q.x, p.x), difference(r.y, p.y))
        .cmp(&product(difference(q.y, p.y), difference(r.x, p.x)))
}

/// The same for any coordinates.
fn wide_orientation(p: &GridPoint, q: &GridPoint, r: &GridPoint) -> Ordering {
    compare_products(
        [difference(q.x, p.x), difference(r.y, p.y)],
        [difference(q.y, p.y), difference(r.x, p.x)],
    )
}

/// `to - from`, which is within ±(2⁶⁴ - 1).
fn difference(to: i64, from: i64) -> i128 {
    i128::from(to) - i128::from(from)
}

/// Compares two products of factors within ±(2⁶⁴ - 1). The absolute values of such products fit into 128 bits without
/// a sign.
fn compare_products(left: [i128; 2], right: [i128; 2]) -> Ordering {
    let sign = |[a, b]: [i128; 2]| a.signum() * b.signum();
    let size = |[a, b]: [i128; 2]| a.unsigned_abs() * b.unsigned_abs();
    sign(left).cmp(&sign(right)).then_with(|| {
        let order = size(left).cmp(&size(right));
        if sign(left) < 0 { order.reverse() } else { order }
    })
}
