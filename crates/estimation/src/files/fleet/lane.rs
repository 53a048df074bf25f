//! The lines of groups whose readings are integers on powers of ten, as in most files. They follow from the two hulls
//! alone, without half-planes, vertices, proofs or a fraction for each number.

use std::borrow::Cow;

use boundfit_exact::{Endpoint, Integer, Interval, Rational, Scaled, Unit, Wide, WideProducts, WideQuotient};
use boundfit_geometry::RegionKind;

use super::chains::{Chains, Coordinate, Corner, Ends, Quotient, Site};
use crate::bound_name::BoundName;
use crate::bounds::{central_of, guaranteed_error};
use crate::files::counts::{Counts, Integers};
use crate::grid::Grid;
use crate::group_fit::{GroupAnswer, GroupFit, GroupLine, Terms};
use crate::least_squares::LeastSquares;
use crate::meaning::ErrorBound;
use crate::moments::{SUM_BITS, Solution, Sums, bits};

/// Powers of ten beyond these are left to numbers of any size.
const MOST_EXPONENT: u32 = 60;
/// Bits of a [`Wide`] without its sign.
const WIDE_BITS: u32 = 255;
/// The most digits by which the unit of y is refined for the error bound.
const MOST_REFINED: u32 = 18;

/// The numbers that a line follows from.
struct Group {
    /// The readings in the order of their rows. Ordinates are on the unit of ε.
    sites: Sites,
    epsilon: i128,
    /// The powers of ten of θ1 and of θ2.
    exponents: [i32; 2],
    /// The bits of the largest x, of the largest y or of ε, and of the number of readings.
    sizes: [u32; 3],
    hulls: Hulls,
}

/// Readings on the shortest integers that hold them.
enum Sites {
    Short(Vec<Site<i64>>),
    Long(Vec<Site<i128>>),
}

impl Sites {
    fn len(&self) -> usize {
        match self {
            Sites::Short(sites) => sites.len(),
            Sites::Long(sites) => sites.len(),
        }
    }

    fn iter(&self) -> impl Iterator<Item = Site<i128>> {
        (0..self.len()).map(|index| match self {
            Sites::Short(sites) => (sites[index].0.into(), sites[index].1.into()),
            Sites::Long(sites) => sites[index],
        })
    }
}

/// The results of both hulls.
struct Hulls {
    /// Twice ε_min.
    gap: Quotient,
    ends: Ends,
}

impl Hulls {
    /// The hulls of readings under an error bound; `None` unless the FPS is a polygon.
    fn of<C: Coordinate>(sites: &[Site<C>], epsilon: i128) -> Option<Self> {
        let mut sites = Cow::Borrowed(sites);
        if !sites.is_sorted() {
            sites.to_mut().sort_unstable();
        }
        let chains = Chains::of_sorted(&sites)?;
        let gap = chains.gap();
        let is_polygon = (gap.0 - Wide::product(2 * epsilon, gap.1)).is_negative();
        is_polygon.then(|| Hulls { gap, ends: chains.ends(C::of(epsilon)) })
    }
}

impl Group {
    /// Readings (x, y) under a uniform error bound. Returns `None` unless the FPS is a polygon, and for numbers that are too long.
    fn new(x: &Counts<'_>, y: &Counts<'_>, epsilon: &Rational) -> Option<Self> {
        if x.exponent.unsigned_abs().max(y.exponent.unsigned_abs()) > MOST_EXPONENT {
            return None;
        }
        let (epsilon, refined) = on_power_of_ten(epsilon, y.exponent)?;
        let exponent = y.exponent - refined as i32;
        let factor = 10_i128.pow(refined);
        let y_bits = y.counts.widest() + if refined > 0 { bits(factor.unsigned_abs()) } else { 0 };
        // A longer product would be too long below.
        if y_bits > i128::BITS - 1 {
            return None;
        }
        let exponents = [exponent - x.exponent, exponent];
        let sizes =
            [x.counts.widest(), y_bits.max(bits(epsilon.unsigned_abs())), bits(x.counts.len() as u128)];
        let size = sizes[0].max(sizes[1]) + sizes[2];
        let (sites, hulls) = if size <= i64::MOST_BITS {
            let sites = sites(&x.counts, &y.counts, factor);
            let hulls = Hulls::of(&sites, epsilon)?;
            (Sites::Short(sites), hulls)
        } else if size <= i128::MOST_BITS {
            let sites = sites(&x.counts, &y.counts, factor);
            let hulls = Hulls::of(&sites, epsilon)?;
            (Sites::Long(sites), hulls)
        } else {
            return None;
        };
        Some(Group { sites, epsilon, exponents, sizes, hulls })
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
        let sums: Sums<Wide> = self.moments(long_sum);
        Some(sums.solution())
    }

    /// Returns whether sums of products fit into 128 bits.
    fn products_fit(&self) -> bool {
        let [x_bits, y_bits, count_bits] = self.sizes;
        x_bits + x_bits.max(y_bits) + count_bits < SUM_BITS
    }

    /// The sums over the readings. `long_sum` adds up products of which the sum may not fit into 128 bits.
    fn moments<N: From<i128>>(
        &self,
        long_sum: impl Fn(&mut dyn Iterator<Item = (i128, i128)>) -> N,
    ) -> Sums<N> {
        let sites = match &self.sites {
            // Their sums of products always fit.
            Sites::Short(sites) => return short_moments(sites).map(N::from),
            Sites::Long(sites) => sites,
        };
        let sum_of_products = |of: fn(&Site<i128>) -> (i128, i128)| {
            let mut pairs = sites.iter().map(of);
            match self.products_fit() {
                true => {
                    pairs.map(|(left, right)| left.wrapping_mul(right)).fold(0, i128::wrapping_add).into()
                }
                false => long_sum(&mut pairs),
            }
        };
        Sums {
            count: sites.len(),
            uu: sum_of_products(|&(x, _)| (x, x)),
            uv: sites.iter().map(|(x, _)| x).sum::<i128>().into(),
            vv: (sites.len() as i128).into(),
            uy: sum_of_products(|&site| site),
            vy: sites.iter().map(|(_, y)| y).sum::<i128>().into(),
        }
    }

    /// Returns whether no reading is farther than ε from the least-squares line.
    fn is_feasible(&self, Solution { numerators: [slope, offset], determinant }: &Solution<Wide>) -> bool {
        let room = determinant * &Wide::from(self.epsilon);
        self.sites.iter().all(|(x, y)| {
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
        let bound = |Corner { site: (x, y), is_ceiling }: Corner| {
            let y = if is_ceiling { y - self.epsilon } else { y + self.epsilon };
            // The first of those at one place stands for all.
            let position = self.sites.iter().position(|own| own == (x, y))?;
            let name = if is_ceiling { BoundName::Upper } else { BoundName::Lower };
            Some(name(row(position)))
        };
        let bounds = [bound(line[0])?, bound(line[1])?];
        let over_run = |size: u128, exponent: i32| {
            Rational::scaled_quotient(size.into(), (right - left).into(), exponent)
        };
        let multipliers = if axis == 0 {
            let one = over_run(1, -x_exponent)?;
            [one.clone(), one]
        } else {
            [over_run(right.unsigned_abs(), 0)?, over_run(left.unsigned_abs(), 0)?]
        };
        // A corner at 0 proves what is said of the value there alone.
        let mut terms: Terms =
            bounds.into_iter().zip(multipliers).filter(|(_, multiplier)| !multiplier.is_zero()).collect();
        terms.sort();
        Some(terms)
    }
}

/// Returns the line of a report about a group of readings (x, y) under a uniform error bound, except its rows.
/// Returns `None` unless the FPS is a polygon, and for numbers that are too long. Exact. Cost: O(N log N).
pub(super) fn group_fit(x: &Counts<'_>, y: &Counts<'_>, epsilon: &Rational) -> Option<GroupFit> {
    let group = Group::new(x, y, epsilon)?;
    let long_sum = |pairs: &mut dyn Iterator<Item = (i128, i128)>| {
        let mut sum = WideProducts::default();
        pairs.for_each(|(left, right)| sum.add(left, right));
        sum.total()
    };
    let sums: Sums<Integer> = group.moments(long_sum);
    let Solution { numerators: [slope, offset], determinant } = sums.solution();
    let least_squares = [group.theta(0, slope, determinant.clone())?, group.theta(1, offset, determinant)?];
    of_parts(&group, least_squares)
}

fn of_parts(group: &Group, least_squares: [Rational; 2]) -> Option<GroupFit> {
    let pui = group.pui()?;
    let central = central_of(&pui);
    Some(GroupFit {
        rows: group.sites.len(),
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
    x: Counts<'_>,
    y: Counts<'_>,
    epsilon: &Rational,
    row: &dyn Fn(usize) -> usize,
) -> Option<GroupAnswer> {
    let (x, y) = (&x.coarsened(), &y.coarsened());
    let column = |own: &Counts<'_>| Scaled::<i64>::new(own.counts.iter(), Unit::TenTo(own.exponent));
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
pub(super) fn group_line(x: &Counts<'_>, y: &Counts<'_>, epsilon: &Rational) -> Option<GroupLine> {
    let group = Group::new(x, y, epsilon)?;
    let Solution { numerators: [slope, offset], determinant } = group.solution()?;
    let Group { sites, exponents, hulls: Hulls { gap, ends }, .. } = group;
    let end = |axis: usize, (numerator, denominator): Quotient| {
        WideQuotient::new(numerator, Wide::from(denominator), exponents[axis])
    };
    let quotients = ends.quotients();
    Some(GroupLine {
        rows: sites.len(),
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

/// Readings whose ordinates are multiplied.
fn sites<C: Coordinate>(x: &Integers<'_>, y: &Integers<'_>, factor: i128) -> Vec<Site<C>> {
    let site = |(x, y): (i128, i128)| (C::of(x), C::of(y.wrapping_mul(factor)));
    match (x, y) {
        (Integers::Short(x), Integers::Short(y)) => {
            x.iter().zip(y.iter()).map(|(&x, &y)| site((x.into(), y.into()))).collect()
        }
        _ => x.iter().zip(y.iter()).map(site).collect(),
    }
}

/// The sums over readings of a line, whose bits and the bits of their number are at most those of a word.
fn short_moments(sites: &[Site<i64>]) -> Sums<i128> {
    let mut sums = Sums { count: sites.len(), vv: sites.len() as i128, ..Sums::default() };
    for &(x, y) in sites {
        let (x, y) = (i128::from(x), i128::from(y));
        sums.uv = sums.uv.wrapping_add(x);
        sums.vy = sums.vy.wrapping_add(y);
        sums.uu = sums.uu.wrapping_add(x.wrapping_mul(x));
        sums.uy = sums.uy.wrapping_add(x.wrapping_mul(y));
    }
    sums
}
