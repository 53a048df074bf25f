//! The two hulls of a few readings on integers, and what of a line's FPS follows from them without its vertices.
//!
//! A line is in the FPS when it passes above all readings lowered by ε and below all readings raised by ε. So it
//! passes above the upper hull of the lowered readings and below the lower hull of the raised ones. Where some line
//! has room to spare, exactly two lines touch both hulls. The steepest touches the upper hull on the left, and the
//! flattest touches it on the right. Their slopes are the ends of θ1. By linear programming duality, the largest
//! value at 0 is the lower hull's value if the flattest line touches it left of 0 and the steepest right of 0.
//! Otherwise it belongs to the tangent line whose contact with the lower hull lies between 0 and its contact with the
//! upper hull.

use std::cmp::Ordering;
use std::ops::{AddAssign, Sub, SubAssign};

use boundfit_exact::Wide;

/// A reading: x and y.
pub(super) type Site<C> = (C, C);

/// An integer of the processor. Words of 64 bits take a third of the time.
pub(super) trait Coordinate:
    Copy + Ord + Into<i128> + Sub<Output = Self> + AddAssign + SubAssign
{
    /// 0.
    const ZERO: Self;
    /// The most bits of a coordinate: their differences and products then fit.
    const MOST_BITS: u32;

    /// The integer with this value, which keeps to these bits.
    fn of(value: i128) -> Self;

    /// Compares two products of integers that are at most two bits longer. Exact.
    fn compare_products(left: [Self; 2], right: [Self; 2]) -> Ordering;
}

impl Coordinate for i64 {
    const ZERO: i64 = 0;
    const MOST_BITS: u32 = 60;

    #[inline]
    fn of(value: i128) -> i64 {
        value as i64
    }

    #[inline]
    fn compare_products(left: [i64; 2], right: [i64; 2]) -> Ordering {
        let product = |[a, b]: [i64; 2]| i128::from(a).wrapping_mul(i128::from(b));
        product(left).cmp(&product(right))
    }
}

impl Coordinate for i128 {
    const ZERO: i128 = 0;
    const MOST_BITS: u32 = 100;

    #[inline]
    fn of(value: i128) -> i128 {
        value
    }

    #[inline]
    fn compare_products([a, b]: [i128; 2], [c, d]: [i128; 2]) -> Ordering {
        let short = i64::try_from;
        match (short(a), short(b), short(c), short(d)) {
            (Ok(a), Ok(b), Ok(c), Ok(d)) => i64::compare_products([a, b], [c, d]),
            _ => Wide::product(a, b).cmp(&Wide::product(c, d)),
        }
    }
}

/// A fraction, not in lowest terms, with a positive denominator. The numerator has at most two bits more than x and y together.
pub(super) type Quotient = (Wide, i128);

/// Lower and upper hull, each from left to right; at least two corners each, and both begin and end at the same x.
pub(super) struct Chains<C> {
    lower: Vec<Site<C>>,
    upper: Vec<Site<C>>,
}

/// A corner of a hull that was moved by the error bound: one of the upper hull is lower than its readings.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) site: Site<i128>,
    /// True on the lower hull, which limits lines from above.
    pub(super) is_ceiling: bool,
}

/// Lines within an error bound, as two corners each from left to right. They have the least and the largest slope, and
/// the least and the largest value at 0.
pub(super) struct Ends {
    pub(super) lower: [[Corner; 2]; 2],
    pub(super) upper: [[Corner; 2]; 2],
    /// The number of lines through two corners, which are the vertices of the FPS.
    pub(super) vertices: usize,
    /// False where a line touches a third corner.
    pub(super) are_sole: bool,
}

impl Ends {
    /// The lower and the upper end of each parameter.
    pub(super) fn quotients(&self) -> [[Quotient; 2]; 2] {
        let Ends { lower: [flattest, lowest], upper: [steepest, highest], .. } = self;
        [[slope(flattest), slope(steepest)], [at_zero(lowest), at_zero(highest)]]
    }
}

impl<C: Coordinate> Chains<C> {
    /// The hulls of readings sorted by x, then y; `None` of those at fewer than two x. Exact. Cost: linear.
    pub(super) fn of_sorted(sorted: &[Site<C>]) -> Option<Self> {
        /// Hulls of few readings rarely have more corners, so that they take memory once.
        const USUAL: usize = 16;
        let (first, last) = (sorted.first()?, sorted.last()?);
        if first.0 == last.0 {
            return None;
        }
        let [lower, upper] = [(); 2].map(|()| Vec::with_capacity(sorted.len().min(USUAL)));
        let mut chains = Chains { lower, upper };
        for &site in sorted {
            // Among several sites at one x the lowest comes first, and the highest last.
            if chains.lower.last().is_none_or(|last| last.0 < site.0) {
                push(&mut chains.lower, site, Ordering::Less);
            }
            if chains.upper.last().is_some_and(|last| last.0 == site.0) {
                chains.upper.pop();
            }
            push(&mut chains.upper, site, Ordering::Greater);
        }
        Some(chains)
    }

    /// The largest vertical distance between the hulls: twice ε_min. Exact.
    pub(super) fn gap(&self) -> Quotient {
        let (lower, upper) = (&self.lower, &self.upper);
        let (mut below, mut above) = (0, 0);
        // The distance is concave in x: it grows until the upper hull is no steeper than the lower one.
        while let (Some(&low), Some(&high)) = (lower.get(below + 1), upper.get(above + 1))
            && by_slope(upper[above], high, lower[below], low) == Ordering::Greater
        {
            below += usize::from(low.0 <= high.0);
            above += usize::from(high.0 <= low.0);
        }
        let edge = |chain: &[Site<C>], at: usize| [chain[at], *chain.get(at + 1).unwrap_or(&chain[at])];
        if upper[above].0 >= lower[below].0 {
            distance(upper[above], edge(lower, below))
        } else {
            let (numerator, denominator) = distance(lower[below], edge(upper, above));
            (numerator.negated_if(true), denominator)
        }
    }

    /// The ends of θ1 and θ2 of the lines within this distance of every reading, which must be more than half of the gap. Exact.
    pub(super) fn ends(mut self, epsilon: C) -> Ends {
        self.lower.iter_mut().for_each(|site| site.1 += epsilon);
        self.upper.iter_mut().for_each(|site| site.1 -= epsilon);
        let (steepest, flattest) = (self.steepest(), self.flattest());
        let [(floor_left, ceiling_right), (floor_right, ceiling_left)] = [steepest, flattest];
        let (floor, ceiling) = (&self.upper, &self.lower);
        let of_floor = |at: usize| Corner { site: wide(floor[at]), is_ceiling: false };
        let of_ceiling = |at: usize| Corner { site: wide(ceiling[at]), is_ceiling: true };
        let steepest = [of_floor(floor_left), of_ceiling(ceiling_right)];
        let flattest = [of_ceiling(ceiling_left), of_floor(floor_right)];
        let highest = if flattest[0].site.0 >= 0 {
            flattest
        } else if steepest[1].site.0 <= 0 {
            steepest
        } else {
            across_zero(ceiling, ceiling_left, ceiling_right).map(of_ceiling)
        };
        let lowest = if steepest[0].site.0 >= 0 {
            steepest
        } else if flattest[1].site.0 <= 0 {
            flattest
        } else {
            across_zero(floor, floor_left, floor_right).map(of_floor)
        };
        let are_sole = touch_alone([floor, ceiling], [floor_left, ceiling_right])
            && touch_alone([ceiling, floor], [ceiling_left, floor_right]);
        let vertices = 2 + (ceiling_right - ceiling_left) + (floor_right - floor_left);
        Ends { lower: [flattest, lowest], upper: [steepest, highest], vertices, are_sole }
    }

    /// Returns the steepest line above the upper and below the lower hull, as the corner of each that it touches. It
    /// is the flattest line through a corner of the upper hull and, right of it, one of the lower hull.
    fn steepest(&self) -> (usize, usize) {
        tangent(&self.upper, &self.lower, Ordering::Less)
    }

    /// Returns the flattest line above the upper and below the lower hull, as the corner of each that it touches. It
    /// is the steepest line through a corner of the lower hull and, right of it, one of the upper hull.
    fn flattest(&self) -> (usize, usize) {
        let (of_lower, of_upper) = tangent(&self.lower, &self.upper, Ordering::Greater);
        (of_upper, of_lower)
    }
}

/// Returns the line of least (`Less`) or largest slope through a corner of one chain and a corner of another to its
/// right, as these corners.
///
/// A line that is extreme among the lines through either of its corners leaves no corner of a hull on the wrong side.
/// Corners beyond the other's corner lie on the side of a line that keeps clear of both.
fn tangent<C: Coordinate>(lefts: &[Site<C>], rights: &[Site<C>], wanted: Ordering) -> (usize, usize) {
    let (mut left, mut right) = (0, rights.len() - 1);
    loop {
        let before = (left, right);
        for (at, site) in rights.iter().enumerate().filter(|(_, site)| site.0 > lefts[left].0) {
            if by_slope(lefts[left], *site, lefts[left], rights[right]) == wanted {
                right = at;
            }
        }
        for (at, site) in lefts.iter().enumerate().filter(|(_, site)| site.0 < rights[right].0) {
            if by_slope(*site, rights[right], lefts[left], rights[right]) == wanted {
                left = at;
            }
        }
        if before == (left, right) {
            return (left, right);
        }
    }
}

/// Adds a corner; those before it go that do not turn this way.
fn push<C: Coordinate>(chain: &mut Vec<Site<C>>, site: Site<C>, turn: Ordering) {
    while let [.., before, last] = chain.as_slice()
        && by_slope(*before, *last, *before, site) != turn
    {
        chain.pop();
    }
    chain.push(site);
}

/// Compares the slopes from one site to another that is right of it.
#[inline]
fn by_slope<C: Coordinate>(from: Site<C>, to: Site<C>, other_from: Site<C>, other_to: Site<C>) -> Ordering {
    let (run, rise) = (to.0 - from.0, to.1 - from.1);
    let (other_run, other_rise) = (other_to.0 - other_from.0, other_to.1 - other_from.1);
    C::compare_products([rise, other_run], [other_rise, run])
}

/// Returns the height of a site above the line through two others, or above the single site if both are the same.
fn distance<C: Coordinate>(site: Site<C>, line: [Site<C>; 2]) -> Quotient {
    let (site, [left, right]) = (wide(site), line.map(wide));
    let run = right.0 - left.0;
    if run == 0 {
        return (Wide::from(site.1 - left.1), 1);
    }
    let rise = Wide::product(site.1 - left.1, run);
    (rise - Wide::product(right.1 - left.1, site.0 - left.0), run)
}

/// Returns whether the line through corners of two chains touches no other corner.
fn touch_alone<C: Coordinate>(chains: [&[Site<C>]; 2], at: [usize; 2]) -> bool {
    let [left, right] = [chains[0][at[0]], chains[1][at[1]]];
    // A line along an edge has the corner next to its own.
    chains.iter().zip(at).zip([left, right]).all(|((chain, at), own)| {
        let neighbours = [at.checked_sub(1), Some(at + 1)].into_iter().flatten();
        let mut others = neighbours.filter_map(|other| chain.get(other));
        others.all(|other| by_slope(own, *other, left, right) != Ordering::Equal)
    })
}

/// The slope of the line through two corners from left to right.
fn slope(line: &[Corner; 2]) -> Quotient {
    let [left, right] = line.map(|corner| corner.site);
    (Wide::from(right.1 - left.1), right.0 - left.0)
}

/// The value at 0 of the line through two corners from left to right.
fn at_zero(line: &[Corner; 2]) -> Quotient {
    let [left, right] = line.map(|corner| corner.site);
    (Wide::product(left.1, right.0) - Wide::product(right.1, left.0), right.0 - left.0)
}

fn wide<C: Coordinate>((x, y): Site<C>) -> Site<i128> {
    (x.into(), y.into())
}

/// The ends of the edge of a chain, between two of its corners, that goes from the left of 0 to its right, or to 0.
fn across_zero<C: Coordinate>(chain: &[Site<C>], first: usize, last: usize) -> [usize; 2] {
    let right = (first..=last).find(|&at| chain[at].0 >= C::ZERO).unwrap_or(last).max(first + 1);
    [right - 1, right]
}

#[cfg(test)]
mod tests {
    use boundfit_exact::Integer;

    use super::*;

    #[test]
    fn long_products_compare_like_long_integers() {
        let edges = [0, 1, -1, 7, i128::from(u64::MAX), 1 << 64, -(1 << 90) - 1, (1 << 126) + 3, i128::MAX];
        let of = |[a, b]: [i128; 2]| Integer::from(a) * Integer::from(b);
        for a in edges {
            for b in edges {
                for c in edges {
                    let (left, right) = ([a, b], [c, a]);
                    assert_eq!(
                        i128::compare_products(left, right),
                        of(left).cmp(&of(right)),
                        "{left:?} {right:?}"
                    );
                    let right = [c, b ^ 5];
                    assert_eq!(
                        i128::compare_products(left, right),
                        of(left).cmp(&of(right)),
                        "{left:?} {right:?}"
                    );
                }
            }
        }
    }
}
