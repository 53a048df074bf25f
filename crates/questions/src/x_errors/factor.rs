//! The least factor on all bounds, of x and of y, that leaves a line.
//!
//! Two ratios of linear functions of the slope may be equal where a quadratic equation says so. So the least factor
//! may be irrational, and it is enclosed by rational numbers. An exact test tells whether the least factor of some
//! rows is less than a number, equal or greater. At a factor that is too small, at most three rows contradict each
//! other. Their own least factor, enclosed by bisection, is tried on all rows next, until nothing contradicts it.

use std::cmp::Ordering;

use boundfit_estimation::BoundName;
use boundfit_exact::{Integer, Rational, Rounding};
use thiserror::Error;

use super::rows::{Seen, SideRows};
use super::{Agreement, Side, XErrorProblem};

/// Significant digits of the ends of an enclosure.
const DIGITS: usize = 17;
/// The powers: an enclosure is narrower than its upper end over two to these powers. The first serves the search for
/// rows, whose tests are fast with short factors; the second serves the end, before the ends are rounded outward.
const BITS: [i64; 2] = [12, 60];

/// The least factor s on all bounds s·ε_i and s·δ_i for which some line agrees with all readings. Under strong agreement larger factors
/// leave more only as long as |θ1|·δ_i ≤ ε_i: it is the least one among such lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeastFactor {
    /// Less than the least factor, or the least factor itself where both ends are equal.
    pub lower: Rational,
    /// A number not below the least factor. Ends that differ have 17 significant digits.
    pub upper: Rational,
    /// The side of a line under the upper end, [`Side::Rising`] where both sides have one.
    pub side: Side,
    /// Such a line; `None` where every larger factor leaves lines, the closer the steeper, and the upper end leaves none.
    pub theta: Option<[Rational; 2]>,
    /// The bounds of readings and conditions, at most three, that leave nothing on this side under the lower end, or
    /// under smaller factors where both ends are equal. None where the factor is 0.
    pub fixed_by: Vec<BoundName>,
}

/// The reason why there is no least factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoLeastFactor {
    /// No factor, however large, leaves anything.
    #[error("no factor on the bounds, however large, is enough")]
    Never,
    /// A factor on its error in x asks for more of a reading without two bounds on y.
    #[error(
        "a reading without both bounds on y, or with bounds that cross, becomes stricter as the bound on its x grows"
    )]
    NotMonotone,
}

impl LeastFactor {
    /// The least factor of readings with errors in x. Exact. Cost: O(n log n) once, and O(k log k) for each step,
    /// with k rows on the hulls of readings that have equal bounds. In practice a few steps suffice.
    ///
    /// # Errors
    /// When there is none.
    pub fn new(problem: &XErrorProblem) -> Result<Self, NoLeastFactor> {
        let [rising, falling] = LeastFactor::of_sides(problem);
        LeastFactor::best(rising?, falling?)
    }

    /// The least factor itself, where it is known exactly.
    pub fn exact(&self) -> Option<&Rational> {
        (self.lower == self.upper).then_some(&self.upper)
    }

    /// The one of both sides that leaves more.
    pub(super) fn best(rising: Option<Self>, falling: Option<Self>) -> Result<Self, NoLeastFactor> {
        let lower = [&rising, &falling].into_iter().flatten().map(|own| own.lower.clone()).min();
        let found = rising.into_iter().chain(falling);
        let best = found.reduce(|best, next| {
            let is_better = next.upper < best.upper
                || next.upper == best.upper && next.theta.is_some() && best.theta.is_none();
            if is_better { next } else { best }
        });
        best.zip(lower).map(|(best, lower)| LeastFactor { lower, ..best }).ok_or(NoLeastFactor::Never)
    }

    /// The least factors of rising and of falling lines; `None` where none is enough.
    pub(super) fn of_sides(problem: &XErrorProblem) -> [Result<Option<Self>, NoLeastFactor>; 2] {
        let is_strong = problem.agreement() == Agreement::Strong;
        let grows = |half_width: Option<&Rational>| half_width.is_some_and(|own| !own.is_negative());
        let is_stricter =
            problem.readings().any(|(row, width)| width.is_positive() && !grows(row.half_width().as_deref()));
        if is_strong && is_stricter {
            return [Err(NoLeastFactor::NotMonotone), Err(NoLeastFactor::NotMonotone)];
        }
        [Side::Rising, Side::Falling].map(|side| Ok(least(&SideRows::new(problem, side))))
    }
}

/// The least factor of all rows of a side.
fn least(rows: &SideRows) -> Option<LeastFactor> {
    if !rows.have_a_factor() {
        return None;
    }
    let every = rows.every();
    let mut few: Vec<usize> = Vec::new();
    let [mut lower, mut upper] = [Rational::zero(), Rational::zero()];
    let [mut bits, most] = BITS;
    let point = loop {
        let above = match rows.seen_from(&upper, &every) {
            Seen::Above(more) => {
                few.extend(more);
                &upper
            }
            Seen::Here(point) => break point,
            Seen::Below(point) if bits == most || lower == upper => break Some(point),
            Seen::Below(_) => {
                bits = most;
                &lower
            }
        };
        [lower, upper] = enclosed(above, bits, |factor| match rows.seen_from(factor, &few) {
            Seen::Above(_) => Ordering::Greater,
            Seen::Here(_) => Ordering::Equal,
            Seen::Below(_) => Ordering::Less,
        });
        few = fewest(rows, few, &lower, lower == upper);
    };
    let mut fixed_by: Vec<BoundName> =
        few.iter().filter_map(|&index| rows.names.get(index).copied()).collect();
    fixed_by.sort();
    let theta = point.and_then(|own| rows.line(&own));
    Some(LeastFactor { lower, upper, side: rows.side, theta, fixed_by })
}

/// Reduces some rows to at most three whose least factor is also greater than a number, or, where `may_be` allows it,
/// not less.
fn fewest(rows: &SideRows, mut few: Vec<usize>, than: &Rational, may_be: bool) -> Vec<usize> {
    few.sort_unstable();
    few.dedup();
    for position in (0..few.len()).rev() {
        let mut without = few.clone();
        without.remove(position);
        match rows.seen_from(than, &without) {
            Seen::Above(_) => few = without,
            Seen::Here(_) if may_be => few = without,
            _ => {}
        }
    }
    few
}

/// Encloses a number greater than `above`, which is positive: the number itself, twice, where its denominator is small, and else a
/// number that is less and one that is not. `compare` says how the number compares to another one. Exact.
fn enclosed(above: &Rational, bits: i64, compare: impl Fn(&Rational) -> Ordering) -> [Rational; 2] {
    let [low, mut high] = octave(&compare);
    let mut low = low.max(above.clone());
    while &high - &low > &high * Rational::binary(Integer::one(), -bits) {
        // The simplest number of all finds a fraction once the enclosure is narrow enough for its denominator, and the simplest one of the
        // middle half narrows the enclosure.
        for wide in [true, false] {
            let margin = if wide { Rational::zero() } else { (&high - &low).half().half() };
            let between = simplest(&(&low + &margin), &(&high - &margin));
            match compare(&between) {
                Ordering::Less => high = between,
                Ordering::Equal => return [between.clone(), between],
                Ordering::Greater => low = between,
            }
        }
    }
    if compare(&high) == Ordering::Equal {
        return [high.clone(), high];
    }
    if bits < BITS[1] {
        return [low, high];
    }
    [low.rounded(DIGITS, Rounding::Down), high.rounded(DIGITS, Rounding::Up)]
}

/// Two powers of two, one the double of the other, between which a positive number lies that is not the smaller one.
fn octave(compare: impl Fn(&Rational) -> Ordering) -> [Rational; 2] {
    let power = |exponent: i64| Rational::binary(Integer::one(), exponent);
    let is_above = |exponent: i64| compare(&power(exponent)) == Ordering::Greater;
    let [mut low, mut high] = [-1, 1];
    if is_above(0) {
        low = 0;
        while is_above(high) {
            [low, high] = [high, 2 * high];
        }
    } else {
        high = 0;
        while !is_above(low) {
            [low, high] = [2 * low, low];
        }
    }
    while high - low > 1 {
        let middle = low.midpoint(high);
        if is_above(middle) { low = middle } else { high = middle }
    }
    [power(low), power(high)]
}

/// The number of the smallest denominator between two that are not negative and differ, by their continued fractions.
fn simplest(low: &Rational, high: &Rational) -> Rational {
    let (floor, _) = low.numerator().div_rem_floor(&low.denominator());
    let floor = Rational::from(&floor);
    let next = &floor + Rational::one();
    if next < *high {
        return next;
    }
    let [low, high] = [low - &floor, high - &floor];
    let Some(over) = high.recip() else { return next };
    let further = match low.recip() {
        Some(end) => simplest(&over, &end),
        None => Rational::from(&over.numerator().div_rem_floor(&over.denominator()).0) + Rational::one(),
    };
    further.recip().map_or(next, |own| floor + own)
}
