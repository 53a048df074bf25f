//! Touching points of binary64 columns.

use std::cmp::Ordering;

use boundfit_exact::Integer;

use super::chain::{Repeatable, Site, marked};
use super::filter::{Plan, candidates};
use super::{GridPoint, narrow_orientation};

/// Positions, ascending, of the points of two columns of equal length that [touch](super::touching) a hull.
///
/// Exact for all finite numbers: floats discard only what is certainly strictly between the hulls. Rows with an infinity or NaN
/// have no place in the plane; they are among the positions and change nothing else. Cost: linear when few rows are close
/// to the hulls, O(n log n) at worst.
pub fn touching_doubles(x: &[f64], y: &[f64]) -> Vec<usize> {
    touching_rows(x, y, None)
}

/// The same with a given plan for the filter, to test that it does not matter.
#[doc(hidden)]
pub fn touching_doubles_by(x: &[f64], y: &[f64], plan: &Plan) -> Vec<usize> {
    touching_rows(x, y, Some(plan))
}

fn touching_rows(x: &[f64], y: &[f64], plan: Option<&Plan>) -> Vec<usize> {
    let place = |row: usize| Place { x: x[row], y: y[row], row };
    let (mut places, homeless): (Vec<Place>, Vec<Place>) = candidates(x, y, plan)
        .into_iter()
        .map(place)
        .partition(|place| place.x.is_finite() && place.y.is_finite());
    places.sort_unstable_by(|p, q| order(p.x, q.x).then_with(|| order(p.y, q.y)));
    let marks = marked(&places, orientation);
    let touching = places.iter().zip(marks).filter(|(_, touches)| *touches).map(|(place, _)| place.row);
    let mut rows: Vec<usize> = touching.chain(homeless.iter().map(|place| place.row)).collect();
    rows.sort_unstable();
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
}

impl Repeatable for Place {
    fn coincides(&self, other: &Self) -> bool {
        self.x == other.x && self.y == other.y
    }
}

/// Of finite numbers; both zeros are one number.
fn order(left: f64, right: f64) -> Ordering {
    left.partial_cmp(&right).unwrap_or(Ordering::Equal)
}

/// `Greater` when the way from `p` over `q` to `r` turns left. Exact.
fn orientation(p: &Place, q: &Place, r: &Place) -> Ordering {
    /// 2⁻¹⁰⁷⁰: more than all underflow.
    const UNDERFLOW: f64 = f64::from_bits(1 << 4);
    let (left, right) = ((q.x - p.x) * (r.y - p.y), (q.y - p.y) * (r.x - p.x));
    // Four differences, two products and one difference of these, each rounded by 2⁻⁵³ at most: Shewchuk 1997, section 4.2,
    // shows (3 + 2⁻⁴⁹)·2⁻⁵³. An overflow makes the comparison false.
    let error = 2.0 * f64::EPSILON * (left.abs() + right.abs()) + UNDERFLOW;
    if (left - right).abs() > error {
        return order(left, right);
    }
    let (x, y) = ([p.x, q.x, r.x].map(Binary::of), [p.y, q.y, r.y].map(Binary::of));
    if let (Some([px, qx, rx]), Some([py, qy, ry])) = (narrow(&x), narrow(&y)) {
        let point = |x: i64, y: i64| GridPoint { x, y, id: 0 };
        return narrow_orientation(&point(px, py), &point(qx, qy), &point(rx, ry));
    }
    let ([px, qx, rx], [py, qy, ry]) = (aligned(&x), aligned(&y));
    ((qx - &px) * (ry - &py)).cmp(&((qy - &py) * (rx - &px)))
}

/// A finite binary64 as `significand · 2^exponent`, the significand odd or 0.
#[derive(Debug, Clone, Copy)]
struct Binary {
    significand: i64,
    exponent: i32,
}

impl Binary {
    fn of(value: f64) -> Self {
        let bits = value.to_bits();
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let biased = ((bits >> 52) & 0x7ff) as i32;
        let (magnitude, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
        if magnitude == 0 {
            // Whatever it is multiplied by.
            return Binary { significand: 0, exponent: i32::MAX };
        }
        let zeros = magnitude.trailing_zeros();
        let odd = magnitude >> zeros;
        let significand = if value.is_sign_negative() { -odd } else { odd };
        Binary { significand, exponent: exponent + zeros as i32 }
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
