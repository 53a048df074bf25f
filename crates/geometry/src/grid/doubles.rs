//! Touching points of binary64 columns.

use std::cmp::Ordering;

use boundfit_exact::{Integer, Sign, significand_and_exponent};

use super::filter::{Listing, Place, places};
use super::{GridPoint, doubled_area};
use crate::hull::Site;
use crate::tally::Tally;
use crate::ties::{Tied, touching_as_one};

/// The places of two columns of equal length that [touch](super::touching) a hull, sorted by x, then y; `row` tells the number
/// of the row at a position, and ascends. At most `most` numbers of each are listed.
///
/// Exact for all finite numbers: floats discard only what is certainly strictly between the hulls. Rows with an infinity or NaN
/// have no place in the plane; they come last and change nothing else. Cost: linear when few places are close
/// to the hulls, O(n log n) at worst.
pub fn touching_doubles(x: &[f64], y: &[f64], row: &dyn Fn(usize) -> u64, most: usize) -> Vec<Place<f64>> {
    touching_of_places(places(x, y, Listing { row, most }), most)
}

/// The touching ones of some places that every touching one is among.
pub(super) fn touching_of_places(places: Vec<Place<f64>>, most: usize) -> Vec<Place<f64>> {
    let (mut places, homeless): (Vec<Place<f64>>, Vec<Place<f64>>) =
        places.into_iter().partition(|place| place.x.is_finite() && place.y.is_finite());
    places.sort_unstable_by(|p, q| order(p.x, q.x).then_with(|| order(p.y, q.y)));
    let mut touching = touching_as_one(places, orientation, most);
    touching.extend(homeless);
    touching
}

impl Site for Place<f64> {
    fn is_above_or_below(&self, other: &Self) -> bool {
        self.x == other.x
    }

    fn coincides(&self, other: &Self) -> bool {
        self.x == other.x && self.y == other.y
    }
}

impl Tied for Place<f64> {
    fn rows(&self) -> &Tally {
        &self.rows
    }

    fn with_rows(self, rows: Tally) -> Self {
        Place { rows, ..self }
    }
}

/// Compares finite numbers; both zeros are one number.
fn order(left: f64, right: f64) -> Ordering {
    left.partial_cmp(&right).unwrap_or(Ordering::Equal)
}

/// Returns the side of the line through `p` and `q`, in that order, `r` lies: `Positive` is to the left. Exact.
fn orientation(p: &Place<f64>, q: &Place<f64>, r: &Place<f64>) -> Sign {
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
        let point = |x: i64, y: i64| GridPoint::of_row(x, y, 0);
        return doubled_area(&point(px, py), &point(qx, qy), &point(rx, ry)).cmp(&0).into();
    }
    let ([px, qx, rx], [py, qy, ry]) = (aligned(&x), aligned(&y));
    Integer::compare([(&(qx - &px), &(ry - &py))], [(&(qy - &py), &(rx - &px))]).into()
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

/// Returns how far each significand moves left for the exponents to be equal.
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
