//! The inverse line x = gain·y + offset of y = θ1·x + θ2: gain 1/θ1, offset -θ2/θ1.

use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{Branch, Inequality, Polyhedron, System, inverse_line_image};

/// What is known about one parameter of the inverse line. Ranges are unions of at most two disjoint intervals, in
/// ascending order: two where θ1 may have either sign, none where there is no feasible θ with θ1 ≠ 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InverseParameter {
    /// Over the FPS. Closed: an end that is only approached (θ1 towards infinity) counts in.
    pub exact_range: Vec<Interval>,
    /// Over the PUI box, which contains the FPS: the interval arithmetic of textbooks.
    pub box_range: Vec<Interval>,
    /// Over the EUI box, when there is one.
    pub eui_range: Option<Vec<Interval>>,
    /// Of the central estimate, when there is one with θ1 ≠ 0.
    pub central: Option<Rational>,
    /// Of the least-squares estimate, when there is one with θ1 ≠ 0.
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
    /// Gain and offset from the FPS, the PUI box, the EUI box and the estimates. Exact.
    pub fn new(
        fps: &Polyhedron,
        pui: Option<&[Interval; 2]>,
        eui: Option<&[Interval; 2]>,
        central: Option<&[Rational; 2]>,
        least_squares: Option<&[Rational; 2]>,
    ) -> Self {
        let [exact_gain, exact_offset] = ranges(fps);
        let [box_gain, box_offset] = pui.map(|pui| ranges(&box_of(pui))).unwrap_or_default();
        let (eui_gain, eui_offset) = eui.map(|eui| ranges(&box_of(eui))).map(|[g, o]| (g, o)).unzip();
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

/// The range of gain and offset over a set of θ.
fn ranges(set: &Polyhedron) -> [Vec<Interval>; 2] {
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

/// Whether all of one interval lies below all of the other, with a gap between.
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
