//! The lines of groups whose readings are integers on powers of ten, as in most files. They follow from the two hulls
//! alone, without half-planes, vertices, proofs or a fraction for each number.

use boundfit_exact::{Endpoint, Integer, Interval, Rational, Scaled, Unit, Wide, WideProducts, WideQuotient};
use boundfit_geometry::RegionKind;

use super::chains::{Chains, Coordinate, Corner, Ends, Quotient, Site};
use crate::bound_name::BoundName;
use crate::bounds::{central_of, guaranteed_error};
use crate::grid::Grid;
use crate::group_fit::{GroupAnswer, GroupFit, GroupLine, Terms};
use crate::least_squares::LeastSquares;
use crate::meaning::ErrorBound;
use crate::moments::{SUM_BITS, Solution, Sums, bits};

/// Numbers as integers on a power of ten.
pub(in crate::files) struct Counts {
    pub(in crate::files) counts: Vec<i128>,
    pub(in crate::files) exponent: i32,
}

impl Counts {
    /// The same numbers on the coarsest decimal unit up to 1 that they allow. The unit that they have is that of
    /// thousands of readings, of which some may have more digits.
    fn coarsened(self) -> Self {
        let finest = (-self.exponent).clamp(0, 18).unsigned_abs();
        let are_whole = |places: &u32| {
            let power = 10_i128.pow(*places);
            self.counts.iter().all(|count| count % power == 0)
        };
        // Mostly the first reading refuses each coarser unit.
        let Some(places) = (1..=finest).rev().find(are_whole) else { return self };
        let power = 10_i128.pow(places);
        let counts = self.counts.iter().map(|count| count / power).collect();
        Counts { counts, exponent: self.exponent + places as i32 }
    }
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
    epsilon: i128,
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
        let widest = |counts: &[i128]| bits(counts.iter().fold(0, |all, count| all | count.unsigned_abs()));
        // A longer product would be too long below.
        if widest(&y.counts) + bits(factor.unsigned_abs()) > i128::BITS - 1 {
            return None;
        }
        let y: Vec<i128> = y.counts.iter().map(|count| count.wrapping_mul(factor)).collect();
        let exponents = [exponent - x.exponent, exponent];
        let x = x.counts.as_slice();
        let sizes = [widest(x), widest(&y).max(bits(epsilon.unsigned_abs())), bits(x.len() as u128)];
        let size = sizes[0].max(sizes[1]) + sizes[2];
        if size > i128::MOST_BITS {
            return None;
        }
        let is_short = size <= i64::MOST_BITS;
        let hulls =
            if is_short { Hulls::of::<i64>(x, &y, epsilon)? } else { Hulls::of::<i128>(x, &y, epsilon)? };
        Some(Group { x, y, epsilon, exponents, sizes, hulls })
    }

    /// A parameter as a number.
    fn theta(&self, axis: usize, numerator: impl Into<Integer>, denominator: Integer) -> Option<Rational> {
        Rational::scaled_quotient(numerator.into(), denominator, self.exponents[axis])
    }

    /// ε_min.
    fn least(&self) -> Option<Rational> {
        let (numerator, denominator) = self.hulls.gap;
        self.theta(1, numerator, (2 * denominator).into())
    }

    /// The parameter uncertainty intervals.
    fn pui(&self) -> Option<[Interval; 2]> {
        let quotients = self.hulls.ends.quotients();
        let end = |axis: usize, (numerator, denominator): Quotient| {
            Some(Endpoint::Finite(self.theta(axis, numerator, denominator.into())?))
        };
        let interval = |axis: usize| {
            let [lower, upper] = quotients[axis];
            Interval::new(end(axis, lower)?, end(axis, upper)?)
        };
        Some([interval(0)?, interval(1)?])
    }

    /// The least-squares estimate over its determinant, on the units; `None` for numbers that are too long.
    fn solution(&self) -> Option<Solution<Wide>> {
        /// Bits of the largest integer, besides those of its factors, that sums, differences and the solution take.
        const CARRIES: u32 = 6;
        let [x_bits, y_bits, count_bits] = self.sizes;
        // Products of ends take twice x and once y, too, and less of anything else.
        if x_bits + x_bits.max(y_bits) + x_bits.max(y_bits) + 2 * count_bits + CARRIES > WIDE_BITS {
            return None;
        }
        let long_sum = |pairs: &mut dyn Iterator<Item = (i128, i128)>| {
            pairs.fold(Wide::default(), |sum, (left, right)| sum + Wide::product(left, right))
        };
        let sums: Sums<Wide> = moments(self.x, &self.y, self.products_fit(), long_sum);
        Some(sums.solution())
    }

    /// Returns whether sums of products fit into 128 bits.
    fn products_fit(&self) -> bool {
        let [x_bits, y_bits, count_bits] = self.sizes;
        x_bits + x_bits.max(y_bits) + count_bits < SUM_BITS
    }

    /// Returns whether no reading is farther than ε from the least-squares line.
    fn is_feasible(&self, Solution { numerators: [slope, offset], determinant }: &Solution<Wide>) -> bool {
        let room = determinant * &Wide::from(self.epsilon);
        self.x.iter().zip(&self.y).all(|(&x, &y)| {
            let apart = determinant * &Wide::from(y) - slope * &Wide::from(x) - *offset;
            !(room - apart.negated_if(apart.is_negative())).is_negative()
        })
    }

    /// The bounds behind an end of a parameter, times multipliers that add up to the parameter, or to its opposite at a lower
    /// end. `row` has the number of a reading's row.
    fn proof(
        &self,
        axis: usize,
        is_upper: bool,
        x_exponent: i32,
        row: &dyn Fn(usize) -> usize,
    ) -> Option<Terms> {
        let Ends { lower, upper, .. } = &self.hulls.ends;
        let line = if is_upper { upper[axis] } else { lower[axis] };
        let [left, right] = line.map(|corner| corner.site.0);
        let sizes = if axis == 0 { [1, 1] } else { [right.unsigned_abs(), left.unsigned_abs()] };
        let exponent = if axis == 0 { -x_exponent } else { 0 };
        let term = |(Corner { site: (x, y), is_ceiling }, size): (Corner, u128)| {
            let y = if is_ceiling { y - self.epsilon } else { y + self.epsilon };
            // The first of those at one place stands for all.
            let position =
                self.x.iter().zip(&self.y).position(|(&own_x, &own_y)| own_x == x && own_y == y)?;
            let name = if is_ceiling { BoundName::Upper } else { BoundName::Lower };
            Some((
                name(row(position)),
                Rational::scaled_quotient(size.into(), (right - left).into(), exponent)?,
            ))
        };
        // A corner at 0 proves what is said of the value there alone.
        let mut terms: Terms =
            line.into_iter().zip(sizes).filter(|(_, size)| *size > 0).map(term).collect::<Option<_>>()?;
        terms.sort();
        Some(terms)
    }
}

/// Returns the line of a report about a group of readings (x, y) under a uniform error bound, except its rows.
/// Returns `None` unless the FPS is a polygon, and for numbers that are too long. Exact. Cost: O(N log N).
pub(super) fn group_fit(x: &Counts, y: &Counts, epsilon: &Rational) -> Option<GroupFit> {
    let group = Group::new(x, y, epsilon)?;
    let long_sum = |pairs: &mut dyn Iterator<Item = (i128, i128)>| {
        let mut sum = WideProducts::default();
        pairs.for_each(|(left, right)| sum.add(left, right));
        sum.total()
    };
    let sums: Sums<Integer> = moments(group.x, &group.y, group.products_fit(), long_sum);
    let Solution { numerators: [slope, offset], determinant } = sums.solution();
    let least_squares = [group.theta(0, slope, determinant.clone())?, group.theta(1, offset, determinant)?];
    of_parts(&group, least_squares)
}

fn of_parts(group: &Group<'_>, least_squares: [Rational; 2]) -> Option<GroupFit> {
    let pui = group.pui()?;
    let central = central_of(&pui);
    Some(GroupFit {
        rows: group.x.len(),
        first_row: None,
        kind: RegionKind::Polygon,
        pui: Some(pui),
        central,
        least_squares: Some(least_squares),
        least: Some(group.least()?),
    })
}

/// Returns what [`group_fit`] does with the proofs, for readings whose rows have these numbers. Returns `None` also where an end has
/// more than one proof, and where numbers do not fit into 64 bits. Exact. Cost: O(N log N).
pub(super) fn group_answer(
    x: Counts,
    y: Counts,
    epsilon: &Rational,
    row: &dyn Fn(usize) -> usize,
) -> Option<GroupAnswer> {
    let (x, y) = (&x.coarsened(), &y.coarsened());
    let column = |own: &Counts| Scaled::<i64>::new(own.counts.iter().copied(), Unit::TenTo(own.exponent));
    // First of all: many readings of 17 digits do not fit.
    let grid = Grid { phi1: column(x)?, phi2: None, response: column(y)?, epsilon: None };
    let group = Group::new(x, y, epsilon)?;
    if !group.hulls.ends.are_sole {
        return None;
    }
    let is_feasible = group.is_feasible(&group.solution()?);
    let LeastSquares { theta, eui } =
        LeastSquares::on_grid(&grid, &ErrorBound::Uniform(epsilon.clone()))?.ok()?;
    let proof = |axis: usize, is_upper: bool| group.proof(axis, is_upper, x.exponent, row);
    let proofs = [[proof(0, false)?, proof(0, true)?], [proof(1, false)?, proof(1, true)?]];
    let fit = of_parts(&group, theta)?;
    let guaranteed_error =
        guaranteed_error(fit.least_squares.as_ref()?, fit.pui.as_ref()?, fit.central.as_ref()?);
    Some(GroupAnswer {
        is_bounded_alike: true,
        vertex_count: group.hulls.ends.vertices,
        is_feasible,
        guaranteed_error,
        eui: Some(eui.ok()?),
        proofs: Some(proofs),
        contradiction: None,
        fit,
    })
}

/// Returns what [`group_fit`] does as quotients that nobody has reduced; `None` where the numbers are too long for these, too. Exact.
/// Cost: as [`group_fit`], without greatest common divisors, which take most of its time.
pub(super) fn group_line(x: &Counts, y: &Counts, epsilon: &Rational) -> Option<GroupLine> {
    let group = Group::new(x, y, epsilon)?;
    let Solution { numerators: [slope, offset], determinant } = group.solution()?;
    let Group { x, exponents, hulls: Hulls { gap, ends }, .. } = group;
    let end = |axis: usize, (numerator, denominator): Quotient| {
        WideQuotient::new(numerator, Wide::from(denominator), exponents[axis])
    };
    let quotients = ends.quotients();
    Some(GroupLine {
        rows: x.len(),
        first_row: None,
        pui: [0, 1].map(|axis| quotients[axis].map(|quotient| end(axis, quotient))),
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
