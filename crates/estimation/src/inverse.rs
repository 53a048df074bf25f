//! The inverse line x = gain·y + offset of y = θ1·x + θ2: gain 1/θ1, offset -θ2/θ1.

use boundfit_exact::{Endpoint, Fraction, Integer, Interval, Rational, Sign};
use boundfit_geometry::{Branch, Inequality, Polyhedron, System, inverse_line_image};

/// The facts about one parameter of the inverse line. Ranges are unions of at most two disjoint intervals, in
/// ascending order: two where θ1 may have either sign, none where there is no feasible θ with θ1 ≠ 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InverseParameter {
    /// The range over the FPS. Closed: an end that is only approached (θ1 towards infinity) counts in.
    pub exact_range: Vec<Interval>,
    /// The range over the PUI box, which contains the FPS: the interval arithmetic of textbooks.
    pub box_range: Vec<Interval>,
    /// The range over the EUI box, if there is one.
    pub eui_range: Option<Vec<Interval>>,
    /// The value for the central estimate, if there is one with θ1 ≠ 0.
    pub central: Option<Rational>,
    /// The value for the least-squares estimate, if there is one with θ1 ≠ 0.
    pub least_squares: Option<Rational>,
}

/// Gain and offset of the inverse line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Inverse {
    /// 1/θ1.
    pub gain: InverseParameter,
    /// -θ2/θ1.
    pub offset: InverseParameter,
}

impl Inverse {
    /// Gain and offset from the FPS, its PUI box, the EUI box and the estimates. Exact. Cost: linear in the number of
    /// vertices of a bounded FPS, else that of [`inverse_line_image`].
    pub fn new(
        fps: &Polyhedron,
        pui: Option<&[Interval; 2]>,
        eui: Option<&[Interval; 2]>,
        central: Option<&[Rational; 2]>,
        least_squares: Option<&[Rational; 2]>,
    ) -> Self {
        let exact = pui.and_then(|[theta1, _]| ranges_of_set(fps, theta1));
        let of_box = |intervals: &[Interval; 2]| {
            let bounded = ranges_of_one_sign(intervals).or_else(|| ranges_of_box(intervals));
            bounded.unwrap_or_else(|| ranges(&box_of(intervals)))
        };
        let [exact_gain, exact_offset] = exact.unwrap_or_else(|| ranges(fps));
        let [box_gain, box_offset] = pui.map(of_box).unwrap_or_default();
        let (eui_gain, eui_offset) = eui.map(of_box).map(|[gain, offset]| (gain, offset)).unzip();
        let gain = |theta: &[Rational; 2]| theta[0].recip();
        let offset = |theta: &[Rational; 2]| (-&theta[1]).checked_div(&theta[0]);
        Inverse {
            gain: InverseParameter {
                exact_range: exact_gain,
                box_range: box_gain,
                eui_range: eui_gain,
                central: central.and_then(gain),
                least_squares: least_squares.and_then(gain),
            },
            offset: InverseParameter {
                exact_range: exact_offset,
                box_range: box_offset,
                eui_range: eui_offset,
                central: central.and_then(offset),
                least_squares: least_squares.and_then(offset),
            },
        }
    }
}

/// The ranges of gain and offset.
type Ranges = [Vec<Interval>; 2];

/// The range of gain and offset over a set of θ of any kind.
fn ranges(set: &Polyhedron) -> Ranges {
    let mut ranges = [Vec::new(), Vec::new()];
    for branch in [Branch::Negative, Branch::Positive] {
        let Some(intervals) = inverse_line_image(set, branch).and_then(|image| image.bounding_box()) else {
            continue;
        };
        for (range, interval) in ranges.iter_mut().zip(intervals) {
            range.push(interval);
        }
    }
    ranges.map(united)
}

/// The ranges over a set whose θ1 has this range, if it is bounded: its vertices are enough.
fn ranges_of_set(set: &Polyhedron, theta1: &Interval) -> Option<Ranges> {
    let corners = || set.homogeneous_vertices().map(|[x, y, _]| [x, y]);
    set.kind().is_bounded().then(|| ranges_of_corners(corners(), theta1))?
}

/// The ranges over a box, if it is bounded.
fn ranges_of_box([theta1, theta2]: &[Interval; 2]) -> Option<Ranges> {
    let ((left, right), (low, high)) = (theta1.ends()?, theta2.ends()?);
    let corners = [(left, low), (right, low), (right, high), (left, high)];
    let place =
        |(x, y): (&Rational, &Rational)| [x.numerator() * y.denominator(), y.numerator() * x.denominator()];
    ranges_of_corners(corners.map(place).into_iter(), theta1)
}

/// The ranges over a convex polygon with these corners in order, each as (θ1, θ2) times a positive number of its own, and
/// this range of θ1.
///
/// A quotient of linear forms is monotone along every segment on one side of θ1 = 0. So -θ2/θ1 has its bounds in
/// corners, except towards θ1 = 0: there the sign of θ2 decides its limit.
fn ranges_of_corners(mut corners: impl Iterator<Item = [Integer; 2]>, theta1: &Interval) -> Option<Ranges> {
    let (lower, upper) = theta1.ends()?;
    let (mut on_axis, mut offsets) = (Vec::new(), [None, None]);
    let first = corners.next()?;
    let mut last = first.clone();
    for corner in corners.chain([first]) {
        on_axis.extend(sign_on_axis(&last, &corner));
        match corner[0].sign() {
            Sign::Negative => add_offset(&mut offsets[0], &corner),
            Sign::Zero => {}
            Sign::Positive => add_offset(&mut offsets[1], &corner),
        }
        last = corner;
    }
    let mut ranges = [Vec::new(), Vec::new()];
    for (side, offsets) in [Sign::Negative, Sign::Positive].into_iter().zip(offsets) {
        let Some([least, most]) = offsets.map(|offsets| offsets.map(Rational::from)) else { continue };
        // Towards θ1 = 0 from the right, -θ2/θ1 grows where θ2 < 0; from the left, where θ2 > 0.
        let (falls, grows) = (side, if side == Sign::Negative { Sign::Positive } else { Sign::Negative });
        let end = |end: Rational, goes_on: Sign| {
            if on_axis.contains(&goes_on) { Endpoint::Unbounded } else { Endpoint::Finite(end) }
        };
        ranges[1].push(Interval::new(end(least, falls), end(most, grows))?);
        // 1/θ1 at an end of the range on this side; without end towards 0.
        let inverse = |theta1: &Rational| match theta1.recip() {
            Some(gain) if theta1.sign() == side => Endpoint::Finite(gain),
            _ => Endpoint::Unbounded,
        };
        ranges[0].push(Interval::new(inverse(upper), inverse(lower))?);
    }
    Some(ranges.map(united))
}

/// The sign of θ2 where the edge between two corners meets θ1 = 0, when it does; for an edge along it, that of its start.
fn sign_on_axis([x, y]: &[Integer; 2], [next_x, next_y]: &[Integer; 2]) -> Option<Sign> {
    match (x.sign(), next_x.sign()) {
        (Sign::Zero, _) => Some(y.sign()),
        (Sign::Negative, Sign::Positive) => Some(Integer::compare([(next_x, y)], [(x, next_y)]).into()),
        (Sign::Positive, Sign::Negative) => Some(Integer::compare([(x, next_y)], [(next_x, y)]).into()),
        _ => None,
    }
}

/// Adds the -θ2/θ1 of a corner with θ1 ≠ 0 to the least and the largest of others.
fn add_offset(offsets: &mut Option<[Fraction; 2]>, [x, y]: &[Integer; 2]) {
    // A positive denominator from the start: the sign of each number is changed once at most.
    let offset = if x.is_negative() { Fraction::new(y.clone(), -x) } else { Fraction::new(-y, x.clone()) };
    let Some(offset) = offset else { return };
    match offsets {
        None => *offsets = Some([offset.clone(), offset]),
        Some([least, _]) if offset < *least => *least = offset,
        Some([_, most]) if *most < offset => *most = offset,
        Some(_) => {}
    }
}

/// Returns the ranges over a bounded box whose θ1 keeps one sign, as in nearly every fit. Each range takes two
/// quotients; corners are compared by products if they leave machine words. For a few readings this is a tenth of the
/// whole fit.
fn ranges_of_one_sign([theta1, theta2]: &[Interval; 2]) -> Option<Ranges> {
    let ((left, right), (low, high)) = (theta1.ends()?, theta2.ends()?);
    if left.sign() != right.sign() {
        return None;
    }
    let gain = Interval::new(Endpoint::Finite(right.recip()?), Endpoint::Finite(left.recip()?))?;
    let mut nearest_and_furthest = [left.abs(), right.abs()];
    let (least, most) = if right.is_negative() {
        nearest_and_furthest.reverse();
        (low.clone(), high.clone())
    } else {
        (-high, -low)
    };
    // A positive number is largest when divided by the smallest |θ1|, a negative one by the largest.
    let [near, far] = nearest_and_furthest;
    let lower = least.checked_div(if least.is_negative() { &near } else { &far })?;
    let upper = most.checked_div(if most.is_negative() { &far } else { &near })?;
    Some([vec![gain], vec![Interval::new(Endpoint::Finite(lower), Endpoint::Finite(upper))?]])
}

/// The union of at most two intervals, as disjoint intervals in ascending order.
fn united(mut intervals: Vec<Interval>) -> Vec<Interval> {
    let [one, other] = intervals.as_slice() else { return intervals };
    if is_left_of(one, other) {
        return intervals;
    }
    if is_left_of(other, one) {
        intervals.reverse();
        return intervals;
    }
    let outermost =
        |own: &Endpoint, others: &Endpoint, pick: fn(Rational, Rational) -> Rational| match (own, others) {
            (Endpoint::Finite(own), Endpoint::Finite(others)) => {
                Endpoint::Finite(pick(own.clone(), others.clone()))
            }
            _ => Endpoint::Unbounded,
        };
    let lower = outermost(one.lower(), other.lower(), Rational::min);
    let upper = outermost(one.upper(), other.upper(), Rational::max);
    Interval::new(lower, upper).into_iter().collect()
}

/// Returns whether all of one interval lies below all of the other, with a gap between.
fn is_left_of(one: &Interval, other: &Interval) -> bool {
    one.upper().value().zip(other.lower().value()).is_some_and(|(upper, lower)| upper < lower)
}

/// The box of two intervals as half-planes.
fn box_of(intervals: &[Interval; 2]) -> Polyhedron {
    let mut system = System::default();
    for (axis, interval) in intervals.iter().enumerate() {
        let unit = |sign: i64| [0, 1].map(|i| Rational::from(if i == axis { sign } else { 0 }));
        if let Some(upper) = interval.upper().value() {
            let [a1, a2] = unit(1);
            system.push(Inequality::new(a1, a2, upper.clone()));
        }
        if let Some(lower) = interval.lower().value() {
            let [a1, a2] = unit(-1);
            system.push(Inequality::new(a1, a2, -lower));
        }
    }
    Polyhedron::intersect(system)
}
