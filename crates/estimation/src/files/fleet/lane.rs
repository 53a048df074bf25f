//! The lines of groups whose readings are integers on powers of ten, as in most files. They follow from the two hulls
//! alone, without half-planes, vertices, proofs or a fraction for each number.

use boundfit_exact::{Endpoint, Integer, Interval, Rational, WideProducts};
use boundfit_geometry::RegionKind;

use super::chains::{Chains, MOST_BITS, Quotient, Site};
use crate::bounds::central_of;
use crate::group_fit::GroupFit;
use crate::moments::{SUM_BITS, Solution, Sums, bits};

/// Numbers as integers on a power of ten.
pub(in crate::files) struct Counts {
    pub(in crate::files) counts: Vec<i128>,
    pub(in crate::files) exponent: i32,
}

/// Powers of ten beyond these are left to numbers of any size.
const MOST_EXPONENT: u32 = 60;
/// The most digits by which the unit of y is refined for the error bound.
const MOST_REFINED: u32 = 18;

/// Returns the line of a report about a group of readings (x, y) under a uniform error bound, except its rows.
/// Returns `None` unless the FPS is a polygon, and for numbers that are too long. Exact. Cost: O(N log N).
pub(super) fn group_fit(x: &Counts, y: &Counts, epsilon: &Rational) -> Option<GroupFit> {
    if x.exponent.unsigned_abs().max(y.exponent.unsigned_abs()) > MOST_EXPONENT {
        return None;
    }
    let (epsilon, refined) = on_power_of_ten(epsilon, y.exponent)?;
    let exponent = y.exponent - refined as i32;
    let factor = 10_i128.pow(refined);
    let y: Vec<i128> = y.counts.iter().map(|count| count.checked_mul(factor)).collect::<Option<_>>()?;
    let (x_exponent, x) = (x.exponent, &x.counts);
    let widest = |counts: &[i128]| bits(counts.iter().fold(0, |all, count| all | count.unsigned_abs()));
    let (x_bits, y_bits) = (widest(x), widest(&y));
    let count_bits = bits(x.len() as u128);
    if x_bits.max(y_bits).max(bits(epsilon.unsigned_abs())) + count_bits > MOST_BITS {
        return None;
    }
    let mut sites: Vec<Site> = x.iter().copied().zip(y.iter().copied()).collect();
    if !sites.is_sorted() {
        sites.sort_unstable();
    }
    let chains = Chains::of_sorted(&sites)?;
    let (gap, width) = chains.gap();
    let twice = Integer::from(2 * epsilon);
    if gap >= &twice * &width {
        return None;
    }
    let theta1 = |(numerator, denominator): Quotient| {
        Rational::scaled_quotient(numerator, denominator, exponent - x_exponent)
    };
    let theta2 =
        |(numerator, denominator): Quotient| Rational::scaled_quotient(numerator, denominator, exponent);
    let ends = chains.ends(epsilon);
    let ([lower1, lower2], [upper1, upper2]) = (ends.lower, ends.upper);
    let interval = |lower, upper| Interval::new(Endpoint::Finite(lower), Endpoint::Finite(upper));
    let pui = [interval(theta1(lower1)?, theta1(upper1)?)?, interval(theta2(lower2)?, theta2(upper2)?)?];
    let products_fit = x_bits + x_bits.max(y_bits) + count_bits < SUM_BITS;
    let Solution { numerators: [slope, offset], determinant } = moments(x, &y, products_fit).solution();
    let least_squares = [theta1((slope, determinant.clone()))?, theta2((offset, determinant))?];
    let least = theta2((gap, &width + &width))?;
    let central = central_of(&pui);
    Some(GroupFit {
        rows: x.len(),
        first_row: None,
        kind: RegionKind::Polygon,
        pui: Some(pui),
        central,
        least_squares: Some(least_squares),
        least: Some(least),
    })
}

/// A positive number as an integer on the unit 10^(exponent - refined), with the least such `refined`.
fn on_power_of_ten(number: &Rational, exponent: i32) -> Option<(i128, u32)> {
    let (numerator, denominator) = (number.numerator().to_i128()?, number.denominator().to_i128()?);
    let coarser = (-exponent).min(0).unsigned_abs();
    (coarser..=coarser + MOST_REFINED).find_map(|refined| {
        let power = 10_i128.checked_pow(u32::try_from(refined as i32 - exponent).ok()?)?;
        let is_whole = power % denominator == 0;
        is_whole.then(|| Some((numerator.checked_mul(power / denominator)?, refined))).flatten()
    })
}

/// The sums over readings of a line; `products_fit`: whether their sums fit into 128 bits.
fn moments(x: &[i128], y: &[i128], products_fit: bool) -> Sums<Integer> {
    let sum_of_products = |left: &[i128], right: &[i128]| {
        let pairs = left.iter().zip(right);
        if products_fit {
            return Integer::from(pairs.map(|(left, right)| left * right).sum::<i128>());
        }
        let mut sum = WideProducts::default();
        pairs.for_each(|(&left, &right)| sum.add(left, right));
        sum.total()
    };
    Sums {
        count: x.len(),
        uu: sum_of_products(x, x),
        uv: Integer::from(x.iter().sum::<i128>()),
        vv: Integer::from(x.len()),
        uy: sum_of_products(x, y),
        vy: Integer::from(y.iter().sum::<i128>()),
    }
}
