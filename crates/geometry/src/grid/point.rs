//! Points with integer coordinates, and what is decided about them.

use std::cmp::Ordering;

use boundfit_exact::Sign;

use crate::hull::Site;
use crate::tally::Tally;
use crate::ties::{Tied, touching_as_one, touching_each};

/// A point with integer coordinates that stands for readings.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct GridPoint {
    /// Abscissa, in some unit.
    pub x: i64,
    /// Ordinate, in some unit.
    pub y: i64,
    /// The readings.
    pub rows: Tally,
}

impl GridPoint {
    /// The point of one reading.
    pub fn of_row(x: i64, y: i64, row: u64) -> Self {
        GridPoint { x, y, rows: Tally::one(row) }
    }
}

/// The absolute value below which differences of coordinates fit into 64 bits and orientations into 128.
const NARROW: u64 = 1 << 62;

impl Site for GridPoint {
    fn is_above_or_below(&self, other: &Self) -> bool {
        self.x == other.x
    }

    fn coincides(&self, other: &Self) -> bool {
        self.x == other.x && self.y == other.y
    }
}

impl Tied for GridPoint {
    fn rows(&self) -> &Tally {
        &self.rows
    }

    fn with_rows(self, rows: Tally) -> Self {
        GridPoint { rows, ..self }
    }
}

/// Returns whether the [`doubled_area`] of any three points is exact.
pub(super) fn are_narrow(points: &[GridPoint]) -> bool {
    points.iter().all(|point| point.x.unsigned_abs() < NARROW && point.y.unsigned_abs() < NARROW)
}

/// The touching points of points with any coordinates, sorted by x, then y. Exact. Cost: linear.
pub(super) fn touching_of_sorted(sorted: Vec<GridPoint>, most: usize, edges_as_one: bool) -> Vec<GridPoint> {
    let orientation: fn(&GridPoint, &GridPoint, &GridPoint) -> Sign =
        if are_narrow(&sorted) { |p, q, r| doubled_area(p, q, r).cmp(&0).into() } else { wide_orientation };
    if edges_as_one {
        touching_as_one(sorted, orientation, most)
    } else {
        touching_each(sorted, orientation, most)
    }
}

/// Twice the signed area of a triangle, positive when it goes around counter-clockwise. Exact for coordinates below 2⁶² in
/// absolute value; beyond, it means nothing.
pub fn doubled_area(p: &GridPoint, q: &GridPoint, r: &GridPoint) -> i128 {
    // Differences of numbers within ±2⁶² do not wrap.
    let difference = |to: i64, from: i64| i128::from(to.wrapping_sub(from));
    // Nor do products of two of them, which are within ±2¹²⁶, nor the difference of these.
    let product = |left: i128, right: i128| left.wrapping_mul(right);
    product(difference(q.x, p.x), difference(r.y, p.y))
        .wrapping_sub(product(difference(q.y, p.y), difference(r.x, p.x)))
}

/// Returns the side of the line through `p` and `q`, in that order, `r` lies, for any coordinates: `Positive` is to the left.
fn wide_orientation(p: &GridPoint, q: &GridPoint, r: &GridPoint) -> Sign {
    let order = compare_products(
        [difference(q.x, p.x), difference(r.y, p.y)],
        [difference(q.y, p.y), difference(r.x, p.x)],
    );
    order.into()
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
