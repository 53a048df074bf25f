//! A sample of the rows, its hulls, and chords above and below these that bear all rounding.
//!
//! # The margin
//!
//! Let u = 2⁻⁵³, let a chord be v = s·d + c with d = x - origin and 0 ≤ d ≤ D, let Y bound |y| in the sample, and B =
//! |s|·D + |c| + Y. Every operation has a relative error of at most u, and underflow adds at most 2⁻¹⁰⁷⁵. So v is
//! evaluated, from a rounded d, within 2.1u·|s|·D + u·(|s|·D + |c|)·1.1 < 4u·B. Its distance to the true chord is
//! linear in x and hence largest at the ends of the chord. The evaluated distance r there is within 4u·B + u·Y of the
//! true one. A y that is not above the true chord is rounded to no more than u·Y above it. Let c + m replace c. Then
//! the evaluated v is no less than any rounded y that is not above the chord, as soon as m ≥ r + 12u·B + 6u·m. The
//! term 6u·m is the rounding that the larger c brings. The choice m = 2r + 32u·B + 2⁻¹⁰⁶⁸ is more. Numbers that
//! overflow become infinite or NaN, and comparisons with these discard nothing.
//!
//! # Numbers that are rounded already
//!
//! Numbers of any length come within a relative 8u of what they are. Let X bound |x| in the sample, of which a row
//! within its ends is none the farther. The chord between two rounded points is then within 8u·(|s|·X + Y) of the
//! chord between the true ones, at any x between these. The x at which it is evaluated is off by 8u·X more. A y near
//! the chord is below twice the bound on the chord, and so within 16u·B. All that is less than 2⁻⁴⁵·(|s|·X + B), by
//! which m is larger. For two x to be ordered like the true ones their offsets must differ by more than 16u·X and
//! their own rounding, 4u·X: 2⁻⁴⁷·X is more.
//!
//! # Numbers of all sizes
//!
//! Where exponents differ much, nothing small is outside a margin that is as wide everywhere. In a cell on one side of x = 0
//! the margin m + k·|x| therefore grows with |x|. Let N be the end of its chord from which x goes away from 0, F the other
//! end, and w their distance. The evaluated v = s·x + c differs from the true chord by no more than r in each end, where r is
//! |y - v| there and 32u·(|s·x| + |c| + |y|): rounding and 8u of x and y are less. Between the ends the difference is at most
//! r_N + r_F·(|x_N| + |x|)/w. A y that is not above the true chord is rounded to no more than 1.1 times that above the evaluated
//! v, and 20u·|s·x| + 12u·|c|. This counts the roundings of slope, intercept and v. Hence m = 2·r_N + 2·r_F·|x_N|/w + 32u·|c|
//! and k = 2·r_F/w + 32u·|s| are enough. They are as long as w is certain, which is asked for. Quotients may underflow, by
//! less than 2⁻¹⁰⁶⁸, which is added to each. No |x| in the cell is greater than that of F. So s·x overflows only where r_F
//! does, and then m is infinite or NaN.

use std::cmp::Ordering;

use boundfit_exact::Sign;

use super::cells::{Around, Between, Cell, Chord, Equal, Index, MOST_CELLS};
use super::coordinate::Coordinate;
use crate::hull::{Hull, HullSide, Site};

/// 2⁻⁴⁷.
pub(super) const BLUR: f64 = f64::EPSILON * 32.0;
/// 2⁻¹⁰⁶⁸.
const UNDERFLOW: f64 = f64::from_bits(1 << 6);

/// A row of the sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sampled<C> {
    pub(super) x: C,
    /// The offset of x from the sample's least, rounded.
    pub(super) offset: f64,
    /// Rounded.
    pub(super) y: f64,
}

impl<C: Coordinate> Site for Sampled<C> {
    fn is_above_or_below(&self, other: &Self) -> bool {
        self.x == other.x
    }

    fn coincides(&self, other: &Self) -> bool {
        self.x == other.x && self.y == other.y
    }
}

/// Rows taken at equal distances.
pub(super) struct Sample<C> {
    /// Sorted by x, then y.
    pub(super) points: Vec<Sampled<C>>,
    /// The least x.
    pub(super) origin: C,
    /// The greatest x.
    pub(super) end: C,
    /// Offset of the greatest x.
    span: f64,
    /// The greatest |y|.
    height: f64,
    /// The greatest |x| if all numbers are rounded already; 0 where they are exact.
    blurred: f64,
    /// The lower hull from left to right.
    lower: Vec<Sampled<C>>,
    /// The upper hull from left to right, mirrored in the x-axis: a lower hull too.
    upper: Vec<Sampled<C>>,
}

impl Sample<f64> {
    /// Cells around the corners of both hulls, for numbers that are rounded already.
    pub(super) fn cells_around_corners(&self) -> Option<Around> {
        Around::places(&self.corners(), BLUR)
    }

    /// Returns a sample of rows whose numbers are within 2^-50, relatively, of the true ones; `None` when the x are
    /// too near to each other for that.
    pub(super) fn of_rounded(x: &[f64], y: &[f64], size: usize) -> Option<Self> {
        let sample = Sample::of(x, y, size)?;
        let blurred = sample.origin.abs().max(sample.end.abs());
        let sample = Sample { blurred, ..sample };
        // Most cells are far wider.
        (sample.blur() * 4096.0 < sample.span).then_some(sample)
    }

    /// The chords of cells on one side of x = 0 each, as lines over x itself. Their margins grow with |x|; see the top of this
    /// file.
    pub(super) fn cells_of_all_sizes(&self, index: &Around) -> Box<[Cell; MOST_CELLS]> {
        let mut cells = Box::new([Cell::KEEPS_ALL; MOST_CELLS]);
        let ends = ends(&self.lower, index).zip(ends(&self.upper, index));
        for (place, (lower, upper)) in ends.enumerate() {
            let is_right = index.is_right_of_zero(place);
            let above = growing_chord(lower.map(|end| &self.lower[end]), is_right);
            let below = growing_chord(upper.map(|end| &self.upper[end]), is_right);
            if let (Some(above), Some(below), Some(cell)) = (above, below, cells.get_mut(place)) {
                *cell = Cell { above, below: below.mirrored() };
            }
        }
        cells
    }
}

/// A line that is certainly not below the chord between two points, in a cell right of x = 0 or left of it. `None` where the
/// points are too near to each other.
fn growing_chord([p, q]: [&Sampled<f64>; 2], is_right: bool) -> Option<Chord> {
    /// The least distance, as a part of their sizes.
    const NEAR: f64 = 1.0 / (1_u64 << 30) as f64;
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    let [near, far] = if is_right { [p, q] } else { [q, p] };
    let width = q.x - p.x;
    let is_certain = width > (p.x.abs() + q.x.abs()) * NEAR;
    if !is_certain {
        return None;
    }
    let slope = (q.y - p.y) / width;
    let intercept = near.y - slope * near.x;
    let off = |end: &Sampled<f64>| {
        let along = slope * end.x;
        (end.y - (along + intercept)).abs()
            + ROUNDING * (along.abs() + intercept.abs() + end.y.abs())
            + UNDERFLOW
    };
    let [off_near, off_far] = [off(near), off(far)];
    let off_along = off_far / width + UNDERFLOW;
    let margin = 2.0 * (off_near + off_along * near.x.abs()) + ROUNDING * intercept.abs() + UNDERFLOW;
    let growth = 2.0 * off_along + ROUNDING * slope.abs();
    let slope = if is_right { slope + growth } else { slope - growth };
    Some(Chord { slope, intercept: intercept + margin })
}

/// Returns the positions of the last point of a hull before each cell, and of the first point behind it. Where there is none
/// the first or the last of the hull takes its place: the sample has no other x.
fn ends<C: Coordinate, I: Index<C>>(hull: &[Sampled<C>], index: &I) -> impl Iterator<Item = [usize; 2]> {
    let (mut before, mut after) = (0, 0);
    (0..I::CELLS).map(move |cell| {
        let is_left = |point: &Sampled<C>| index.is_before(point.x, point.offset, cell);
        let is_not_right = |point: &Sampled<C>| !index.is_after(point.x, point.offset, cell);
        while hull.get(before).is_some_and(is_left) {
            before += 1;
        }
        while hull.get(after).is_some_and(is_not_right) {
            after += 1;
        }
        [before.saturating_sub(1), after.min(hull.len() - 1)]
    })
}

impl<C: Coordinate> Sample<C> {
    /// Returns a sample of about `size` rows; `None` when no finite offsets exist.
    pub(super) fn of(x: &[C], y: &[C], size: usize) -> Option<Self> {
        let stride = (x.len() / size.max(1)).max(1);
        let finite = |(x, y): &(C, f64)| x.value().is_finite() && y.is_finite();
        let rows = x.iter().zip(y).step_by(stride).map(|(&x, &y)| (x, y.value())).filter(finite);
        let rows: Vec<(C, f64)> = rows.collect();
        let x = || rows.iter().map(|&(x, _)| x);
        let origin = x().reduce(|least, x| if x < least { x } else { least })?;
        let end = x().reduce(|greatest, x| if x > greatest { x } else { greatest })?;
        if !origin.reaches(end) {
            return None;
        }
        let sampled = |&(x, y): &(C, f64)| Sampled { x, offset: x.offset(origin), y };
        let mut points: Vec<Sampled<C>> = rows.iter().map(sampled).collect();
        points.sort_unstable_by(|p, q| {
            let by_x = p.x.partial_cmp(&q.x).unwrap_or(Ordering::Equal);
            by_x.then_with(|| p.y.total_cmp(&q.y))
        });
        let hull = |side: HullSide| -> Vec<Sampled<C>> {
            let hull = Hull::new(side, &points, rough_orientation);
            hull.support(&points).map(|position| points[position]).collect()
        };
        let lower = hull(HullSide::Lower);
        let mut upper = hull(HullSide::Upper);
        upper.reverse();
        upper.iter_mut().for_each(|point| point.y = -point.y);
        let height = points.iter().map(|point| point.y.abs()).fold(0.0, f64::max);
        let span = end.offset(origin);
        Some(Sample { points, origin, end, span, height, blurred: 0.0, lower, upper })
    }

    /// Points of the sample's lower hull from left to right, as far as floats see it.
    pub(super) fn lower_hull(&self) -> &[Sampled<C>] {
        &self.lower
    }

    /// Returns the points of the upper hull, mirrored in the x-axis.
    pub(super) fn mirrored_upper_hull(&self) -> &[Sampled<C>] {
        &self.upper
    }

    /// Cells of equal width; `None` when the sample is too narrow for the exponents of binary64.
    pub(super) fn equal_cells(&self) -> Option<Equal> {
        Equal::of_span(self.span, self.blur())
    }

    /// Returns how far apart two x have to be for their order to be that of what they are rounded from.
    pub(super) fn blur(&self) -> f64 {
        // Each is within 2^-50 of the greatest, and so are offsets and sums: eight times that is more.
        BLUR * self.blurred
    }

    /// Cells between the corners of both hulls.
    pub(super) fn cells_between_corners(&self) -> Option<Between<C>> {
        Between::places(&self.corners())
    }

    /// The x of the corners of both hulls, ascending.
    fn corners(&self) -> Vec<C> {
        let mut corners: Vec<C> = self.lower.iter().chain(&self.upper).map(|corner| corner.x).collect();
        corners.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        corners.dedup();
        corners
    }

    /// The chords of all cells.
    pub(super) fn cells<I: Index<C>>(&self, index: &I) -> Box<[Cell; MOST_CELLS]> {
        let mut cells = Box::new([Cell::KEEPS_ALL; MOST_CELLS]);
        let chords = self.chords(&self.lower, index).zip(self.chords(&self.upper, index));
        for (cell, (above, mirrored)) in cells.iter_mut().zip(chords) {
            *cell = Cell { above, below: mirrored.mirrored() };
        }
        cells
    }

    /// Returns, for each cell, a line that is certainly not below the chord between two points of the hull on both
    /// sides of the cell.
    fn chords<I: Index<C>>(&self, hull: &[Sampled<C>], index: &I) -> impl Iterator<Item = Chord> {
        let mut last = ([usize::MAX; 2], Cell::KEEPS_ALL.above);
        ends(hull, index).map(move |ends| {
            if last.0 != ends {
                last = (ends, self.chord(ends.map(|end| &hull[end])));
            }
            last.1
        })
    }

    /// A line that is certainly not below the chord between two points.
    fn chord(&self, [p, q]: [&Sampled<C>; 2]) -> Chord {
        let width = q.offset - p.offset;
        let chord = if width > 0.0 {
            let slope = (q.y - p.y) / width;
            Chord { slope, intercept: p.y - slope * p.offset }
        } else {
            Chord { slope: 0.0, intercept: p.y.max(q.y) }
        };
        Chord { slope: chord.slope, intercept: chord.intercept + self.margin(chord, [p, q]) }
    }

    /// Returns what must be added to the intercept; see the top of this file.
    fn margin(&self, chord: Chord, ends: [&Sampled<C>; 2]) -> f64 {
        let [p, q] = ends.map(|end| end.y - chord.at(end.offset));
        let bound = chord.slope.abs() * self.span + chord.intercept.abs() + self.height;
        let blur = BLUR * 4.0 * (chord.slope.abs() * self.blurred + bound);
        let rounding = 2.0 * p.max(q).max(0.0) + 16.0 * f64::EPSILON * bound + UNDERFLOW;
        if self.blurred > 0.0 { rounding + blur } else { rounding }
    }
}

/// Rounded, for hulls that need not be convex: any points of the sample have a chord. Products that binary64 does not have are
/// compared by their exponents, so that numbers of any size have hulls that are nearly right. A point that seems to be within an
/// edge is left out: it has no other chord, and points that are one beside a far one would stay for good. Both are looked at
/// from the point between them, from which the nearer one is not lost beside the other.
fn rough_orientation<C: Coordinate>(p: &Sampled<C>, q: &Sampled<C>, r: &Sampled<C>) -> Sign {
    // On a hull's way p, q and r are in the order of their x, or in the opposite one.
    let along = |x: C| if x < q.x { -q.x.offset(x) } else { x.offset(q.x) };
    let [[r_along, r_across], [p_along, p_across]] = [r, p].map(|to| [along(to.x), to.y - q.y]);
    let products = [[r_along, p_across], [r_across, p_along]];
    let is_there = |[one, other]: [f64; 2]| (one * other).is_normal() || one == 0.0 || other == 0.0;
    let is_left = if products.into_iter().all(is_there) {
        let [left, right] = products.map(|[one, other]| one * other);
        left > right
    } else {
        let [left, right] = products.map(|[one, other]| Product::of(one, other));
        left > right
    };
    if is_left { Sign::Positive } else { Sign::Negative }
}

/// A product of two numbers by its sign, its exponent, towards the sign, and its rounded significand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Product {
    sign: i8,
    exponent: i32,
    significand: i64,
}

impl Product {
    fn of(one: f64, other: f64) -> Self {
        // Numbers below the normal ones are as good as 0 here.
        let exponent = |factor: f64| (factor.to_bits() >> 52 & 0x7ff) as i32;
        let significand =
            |factor: f64| f64::from_bits(factor.to_bits() & (u64::MAX >> 12) | 1.0_f64.to_bits());
        if exponent(one) == 0 || exponent(other) == 0 {
            return Product { sign: 0, exponent: 0, significand: 0 };
        }
        let product = significand(one) * significand(other);
        let carry = i32::from(product >= 2.0);
        let sign = if one.is_sign_negative() == other.is_sign_negative() { 1 } else { -1 };
        Product {
            sign,
            exponent: i32::from(sign) * (exponent(one) + exponent(other) + carry),
            significand: i64::from(sign) * (product.to_bits() & (u64::MAX >> 12)) as i64,
        }
    }
}
