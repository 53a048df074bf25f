//! Touching points of binary64 columns.

use std::cmp::Ordering;

use boundfit_exact::{Integer, Sign, significand_and_exponent};

use super::filter::candidates;
use super::{GridPoint, doubled_area};
use crate::hull::{Hull, HullSide, Site};

/// Positions, ascending, of the points of two columns of equal length that [touch](super::touching) a hull.
///
/// Exact for all finite numbers: floats discard only what is certainly strictly between the hulls. Rows with an infinity or NaN
/// have no place in the plane; they are among the positions and change nothing else. Cost: linear when few rows are close
/// to the hulls, O(n log n) at worst.
pub fn touching_doubles(x: &[f64], y: &[f64]) -> Vec<usize> {
    touching_of_rows(x, y, candidates(x, y))
}

/// The touching ones of some rows that every touching one is among.
pub(super) fn touching_of_rows(x: &[f64], y: &[f64], rows: Vec<usize>) -> Vec<usize> {
    let place = |row: usize| Place { x: x[row], y: y[row], row };
    let (mut places, homeless): (Vec<Place>, Vec<Place>) =
        rows.into_iter().map(place).partition(|place| place.x.is_finite() && place.y.is_finite());
    places.sort_unstable_by(|p, q| order(p.x, q.x).then_with(|| order(p.y, q.y)));
    let mut rows: Vec<usize> = homeless.iter().map(|place| place.row).collect();
    for side in [HullSide::Lower, HullSide::Upper] {
        let hull = Hull::new(side, &places, orientation);
        rows.extend(hull.support(&places).map(|position| places[position].row));
    }
    rows.sort_unstable();
    rows.dedup();
    rows
}

/// A finite point with its row.
#[derive(Debug, Clone, Copy)]
struct Place {
    x: f64,
    y: f64,
    row: usize,
}

impl Site for Place {
    fn is_above_or_below(&self, other: &Self) -> bool {
        self.x == other.x
    }

    fn coincides(&self, other: &Self) -> bool {
        self.x == other.x && self.y == other.y
    }
}

/// Of finite numbers; both zeros are one number.
fn order(left: f64, right: f64) -> Ordering {
    left.partial_cmp(&right).unwrap_or(Ordering::Equal)
}

/// On which side of the line through `p` and `q`, in that order, `r` lies: `Positive` is to the left. Exact.
fn orientation(p: &Place, q: &Place, r: &Place) -> Sign {
    /// 2⁻¹⁰⁷⁰: more than all underflow.
    const UNDERFLOW: f64 = f64::from_bits(1 << 4);
    let (left, right) = ((q.x - p.x) * (r.y - p.y), (q.y - p.y) * (r.x - p.x));
    // Four differences, two products and one difference of these, each rounded by 2⁻⁵³ at most: Shewchuk 1997, section 4.2,
    // shows (3 + 2⁻⁴⁹)·2⁻⁵³. An overflow makes the comparison false.
    let error = 2.0 * f64::EPSILON * (left.abs() + right.abs()) + UNDERFLOW;
    if (left - right).abs() > error {
        return order(left, right).into();
    }
    let (x, y) = ([p.x, q.x, r.x].map(Binary::of), [p.y, q.y, r.y].map(Binary::of));
    if let (Some([px, qx, rx]), Some([py, qy, ry])) = (narrow(&x), narrow(&y)) {
        let point = |x: i64, y: i64| GridPoint { x, y, id: 0 };
        return doubled_area(&point(px, py), &point(qx, qy), &point(rx, ry)).cmp(&0).into();
    }
    let ([px, qx, rx], [py, qy, ry]) = (aligned(&x), aligned(&y));
    ((qx - &px) * (ry - &py)).cmp(&((qy - &py) * (rx - &px))).into()
}

/// A finite binary64 as `significand · 2^exponent`, the significand odd or 0.
#[derive(Debug, Clone, Copy)]
struct Binary {
    significand: i64,
    exponent: i32,
}

impl Binary {
    fn of(value: f64) -> Self {
        let (significand, exponent) = significand_and_exponent(value);
        if significand == 0 {
            // Whatever it is multiplied by.
            return Binary { significand: 0, exponent: i32::MAX };
        }
        let zeros = significand.trailing_zeros();
        Binary { significand: significand >> zeros, exponent: exponent + zeros as i32 }
    }
}

/// How far each significand moves left for the exponents to be equal.
fn shifts(numbers: &[Binary; 3]) -> [u32; 3] {
    let least = numbers.iter().map(|number| number.exponent).min().unwrap_or(0);
    numbers.map(|number| if number.significand == 0 { 0 } else { number.exponent.abs_diff(least) })
}

/// The numbers in units of a common power of two, if they are within ±2⁶².
fn narrow(numbers: &[Binary; 3]) -> Option<[i64; 3]> {
    let shifts = shifts(numbers);
    let fits = |(number, &shift): (&Binary, &u32)| {
        let bits = i64::BITS - number.significand.unsigned_abs().leading_zeros();
        bits + shift <= 62
    };
    let shifted = |k: usize| numbers[k].significand << shifts[k];
    numbers.iter().zip(&shifts).all(fits).then(|| [shifted(0), shifted(1), shifted(2)])
}

/// The numbers in units of a common power of two.
fn aligned(numbers: &[Binary; 3]) -> [Integer; 3] {
    let shifts = shifts(numbers);
    let shifted =
        |k: usize| Integer::from(numbers[k].significand) * Integer::power_of_two(u64::from(shifts[k]));
    [shifted(0), shifted(1), shifted(2)]
}
