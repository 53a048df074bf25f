//! The lines of groups whose readings are integers on powers of ten, as in most files. They follow from the two hulls
//! alone, without half-planes, vertices, proofs or a fraction for each number.

use boundfit_exact::{Endpoint, Integer, Interval, Rational, Wide, WideProducts, WideQuotient};
use boundfit_geometry::RegionKind;

use super::chains::{Chains, Coordinate, Ends, Quotient, Site};
use crate::bounds::central_of;
use crate::group_fit::{GroupFit, GroupLine};
use crate::moments::{SUM_BITS, Solution, Sums, bits};

/// Numbers as integers on a power of ten.
pub(in crate::files) struct Counts {
    pub(in crate::files) counts: Vec<i128>,
    pub(in crate::files) exponent: i32,
}

/// Powers of ten beyond these are left to numbers of any size.
const MOST_EXPONENT: u32 = 60;
/// Bits of a [`Wide`] without its sign.
const WIDE_BITS: u32 = 255;
/// The most digits by which the unit of y is refined for the error bound.
const MOST_REFINED: u32 = 18;

/// The numbers that a line follows from.
struct Group<'a> {
    x: &'a [i128],
    /// The ordinates, on the unit of ε.
    y: Vec<i128>,
    /// The powers of ten of θ1 and of θ2.
    exponents: [i32; 2],
    /// The bits of the largest x, of the largest y or of ε, and of the number of readings.
    sizes: [u32; 3],
    hulls: Hulls,
}

/// The results of both hulls.
struct Hulls {
    /// Twice ε_min.
    gap: Quotient,
    ends: Ends,
}

impl Hulls {
    /// The hulls of readings under an error bound; `None` unless the FPS is a polygon.
    fn of<C: Coordinate>(x: &[i128], y: &[i128], epsilon: i128) -> Option<Self> {
        let mut sites: Vec<Site<C>> = x.iter().zip(y).map(|(&x, &y)| (C::of(x), C::of(y))).collect();
        if !sites.is_sorted() {
            sites.sort_unstable();
        }
        let chains = Chains::of_sorted(&sites)?;
        let gap = chains.gap();
        let is_polygon = (gap.0 - Wide::product(2 * epsilon, gap.1)).is_negative();
        is_polygon.then(|| Hulls { gap, ends: chains.ends(C::of(epsilon)) })
    }
}

impl<'a> Group<'a> {
    /// Readings (x, y) under a uniform error bound. Returns `None` unless the FPS is a polygon, and for numbers that are too long.
    fn new(x: &'a Counts, y: &Counts, epsilon: &Rational) -> Option<Self> {
        if x.exponent.unsigned_abs().max(y.exponent.unsigned_abs()) > MOST_EXPONENT {
            return None;
        }
        let (epsilon, refined) = on_power_of_ten(epsilon, y.exponent)?;
        let exponent = y.exponent - refined as i32;
        let factor = 10_i128.pow(refined);
        let y: Vec<i128> = y.counts.iter().map(|count| count.checked_mul(factor)).collect::<Option<_>>()?;
        let exponents = [exponent - x.exponent, exponent];
        let x = x.counts.as_slice();
        let widest = |counts: &[i128]| bits(counts.iter().fold(0, |all, count| all | count.unsigned_abs()));
        let sizes = [widest(x), widest(&y).max(bits(epsilon.unsigned_abs())), bits(x.len() as u128)];
        let size = sizes[0].max(sizes[1]) + sizes[2];
        if size > i128::MOST_BITS {
            return None;
        }
        let is_short = size <= i64::MOST_BITS;
        let hulls =
            if is_short { Hulls::of::<i64>(x, &y, epsilon)? } else { Hulls::of::<i128>(x, &y, epsilon)? };
        Some(Group { x, y, exponents, sizes, hulls })
    }
}

/// Returns the line of a report about a group of readings (x, y) under a uniform error bound, except its rows.
/// Returns `None` unless the FPS is a polygon, and for numbers that are too long. Exact. Cost: O(N log N).
pub(super) fn group_fit(x: &Counts, y: &Counts, epsilon: &Rational) -> Option<GroupFit> {
    let Group { x, y, exponents, sizes: [x_bits, y_bits, count_bits], hulls: Hulls { gap, ends } } =
        Group::new(x, y, epsilon)?;
    let theta = |axis: usize, numerator, denominator| {
        Rational::scaled_quotient(numerator, denominator, exponents[axis])
    };
    let end =
        |axis: usize, (numerator, denominator): Quotient| theta(axis, numerator.into(), denominator.into());
    let Ends { lower: [lower1, lower2], upper: [upper1, upper2] } = ends;
    let interval = |lower, upper| Interval::new(Endpoint::Finite(lower), Endpoint::Finite(upper));
    let pui = [interval(end(0, lower1)?, end(0, upper1)?)?, interval(end(1, lower2)?, end(1, upper2)?)?];
    let products_fit = x_bits + x_bits.max(y_bits) + count_bits < SUM_BITS;
    let long_sum = |pairs: &mut dyn Iterator<Item = (i128, i128)>| {
        let mut sum = WideProducts::default();
        pairs.for_each(|(left, right)| sum.add(left, right));
        sum.total()
    };
    let sums: Sums<Integer> = moments(x, &y, products_fit, long_sum);
    let Solution { numerators: [slope, offset], determinant } = sums.solution();
    let least_squares = [theta(0, slope, determinant.clone())?, theta(1, offset, determinant)?];
    let least = end(1, (gap.0, 2 * gap.1))?;
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

/// Returns what [`group_fit`] does as quotients that nobody has reduced; `None` where the numbers are too long for these, too. Exact.
/// Cost: as [`group_fit`], without greatest common divisors, which take most of its time.
pub(super) fn group_line(x: &Counts, y: &Counts, epsilon: &Rational) -> Option<GroupLine> {
    /// Bits of the largest integer, besides those of its factors, that sums, differences and the solution take.
    const CARRIES: u32 = 6;
    let Group { x, y, exponents, sizes: [x_bits, y_bits, count_bits], hulls: Hulls { gap, ends } } =
        Group::new(x, y, epsilon)?;
    // Products of ends take twice x and once y, too, and less of anything else.
    if x_bits + x_bits.max(y_bits) + x_bits.max(y_bits) + 2 * count_bits + CARRIES > WIDE_BITS {
        return None;
    }
    let end = |axis: usize, (numerator, denominator): Quotient| {
        WideQuotient::new(numerator, Wide::from(denominator), exponents[axis])
    };
    let Ends { lower, upper } = ends;
    let pui = [0, 1].map(|axis| [end(axis, lower[axis]), end(axis, upper[axis])]);
    let products_fit = x_bits + x_bits.max(y_bits) + count_bits < SUM_BITS;
    let long_sum = |pairs: &mut dyn Iterator<Item = (i128, i128)>| {
        pairs.fold(Wide::default(), |sum, (left, right)| sum + Wide::product(left, right))
    };
    let sums: Sums<Wide> = moments(x, &y, products_fit, long_sum);
    let Solution { numerators: [slope, offset], determinant } = sums.solution();
    Some(GroupLine {
        rows: x.len(),
        first_row: None,
        pui,
        least_squares: [
            WideQuotient::new(slope, determinant, exponents[0]),
            WideQuotient::new(offset, determinant, exponents[1]),
        ],
        least: end(1, (gap.0, 2 * gap.1)),
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

/// The sums over readings of a line. Sums of products fit into 128 bits if `products_fit`; `long_sum` adds up others.
fn moments<N: From<i128>>(
    x: &[i128],
    y: &[i128],
    products_fit: bool,
    long_sum: impl Fn(&mut dyn Iterator<Item = (i128, i128)>) -> N,
) -> Sums<N> {
    let sum_of_products = |left: &[i128], right: &[i128]| {
        let mut pairs = left.iter().copied().zip(right.iter().copied());
        match products_fit {
            true => pairs.map(|(left, right)| left.wrapping_mul(right)).fold(0, i128::wrapping_add).into(),
            false => long_sum(&mut pairs),
        }
    };
    Sums {
        count: x.len(),
        uu: sum_of_products(x, x),
        uv: x.iter().sum::<i128>().into(),
        vv: (x.len() as i128).into(),
        uy: sum_of_products(x, y),
        vy: y.iter().sum::<i128>().into(),
    }
}
