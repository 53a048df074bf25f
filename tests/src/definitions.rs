//! Parts of a fit by their definitions, where the engine has a shorter way to the same answer.

use boundfit_estimation::{
    BoundName, Condition, ErrorBound, Fit, Fps, GrowingInequality, LeastGrowth, Measurement, ParameterBound,
    Problem, Section, SectionBoundary, SectionVertex, conditions_by_name, fit, least_growth,
};
use boundfit_exact::{Endpoint, Integer, Interval, Rational};
use boundfit_geometry::{
    Boundary, Branch, Direction, Inequality, Multiplier, Polyhedron, RegionKind, System, Vertex, envelope,
    inverse_line_image,
};

use crate::readings::{parse_condition, rebuilt, y_and_epsilon};

/// The least error bound, a minimiser and whether it is the only one, from all half-planes by cutting planes; `None` when no
/// bound leaves anything.
pub fn least_bound(problem: &Problem) -> Option<(Rational, [Rational; 2], bool)> {
    let growing =
        |growth: &Rational, at_zero: Inequality| GrowingInequality { at_zero, growth: growth.clone() };
    let (zero, one) = (Rational::zero(), Rational::one());
    let readings = problem.measurements.kept().iter().flat_map(|row| {
        let (y, epsilon) = y_and_epsilon(row);
        let growth = if problem.measurements.error_bound().is_uniform() { &one } else { epsilon };
        let [u, v] = &row.regressor;
        let strip = [Inequality::new(u.clone(), v.clone(), y.clone()), Inequality::new(-u, -v, -y)];
        strip.map(|at_zero| growing(growth, at_zero))
    });
    let conditions =
        conditions_by_name(&problem.conditions).map(|(_, inequality)| growing(&zero, inequality));
    let all: Vec<GrowingInequality> = readings.chain(conditions).collect();
    let LeastGrowth::From { t, .. } = least_growth(&all) else { return None };
    let at_t = |GrowingInequality { at_zero: Inequality { a: [a1, a2], b }, growth }: &GrowingInequality| {
        Inequality::new(a1.clone(), a2.clone(), b + growth * &t)
    };
    let region = envelope::intersect(&all.iter().map(at_t).collect());
    let theta = region.witness()?.coordinates();
    Some((t, theta, region.kind() == RegionKind::Point))
}

/// The ranges of gain and offset of the inverse line over a set, by its projective images.
pub fn inverse_ranges(set: &Polyhedron) -> [Vec<Interval>; 2] {
    let images = [Branch::Negative, Branch::Positive].map(|branch| inverse_line_image(set, branch));
    let boxes: Vec<[Interval; 2]> = images.iter().flatten().filter_map(Polyhedron::bounding_box).collect();
    [0, 1].map(|axis| {
        let mut parts: Vec<Interval> = boxes.iter().map(|intervals| intervals[axis].clone()).collect();
        // An end that is not there comes first.
        parts.sort_by(|one, other| one.lower().value().cmp(&other.lower().value()));
        let [one, other] = parts.as_slice() else { return parts };
        match one.upper().value().zip(other.lower().value()) {
            Some((upper, lower)) if upper < lower => parts,
            _ => {
                let upper = one.upper().value().zip(other.upper().value());
                let upper = upper.map(|(one, other)| one.max(other).clone());
                Interval::new(one.lower().clone(), Endpoint::from(upper)).into_iter().collect()
            }
        }
    })
}

/// A box as a set.
pub fn box_of(intervals: &[Interval; 2]) -> Polyhedron {
    let zero = Rational::zero;
    let mut system = System::default();
    for (axis, interval) in intervals.iter().enumerate() {
        let mut bound = |sign: i64, end: &Endpoint| {
            let Some(value) = end.value() else { return };
            let sign = Rational::from(sign);
            let [a1, a2] = if axis == 0 { [sign.clone(), zero()] } else { [zero(), sign.clone()] };
            system.push(Inequality::new(a1, a2, value * sign));
        };
        bound(1, interval.upper());
        bound(-1, interval.lower());
    }
    Polyhedron::intersect(system)
}

/// Returns whether every number of one interval lies in another.
pub fn contains(outer: &Interval, inner: &Interval) -> bool {
    let within = |end: &Endpoint, outer_end: &Endpoint| match end {
        Endpoint::Finite(value) => outer.contains(value),
        Endpoint::Unbounded => outer_end.value().is_none(),
    };
    within(inner.lower(), outer.lower()) && within(inner.upper(), outer.upper())
}

/// A set as one of a family.
pub fn section(fps: &Fps) -> Section {
    let (polyhedron, region) = (fps.polyhedron(), fps.polyhedron().region());
    let active = |indices: &[usize]| fps.active(indices, usize::MAX);
    let vertex = |vertex: &Vertex| SectionVertex {
        theta: vertex.point().coordinates(),
        active: active(vertex.active()),
    };
    let boundary = |boundary: &Boundary| {
        let (half_plane, normal) = (boundary.half_plane(), boundary.half_plane().normal());
        let divisor = half_plane.a1().gcd(&half_plane.a2());
        let offset = Rational::new(half_plane.b(), divisor).expect("a normal that is not zero");
        SectionBoundary { normal, offset, active: active(boundary.active()) }
    };
    Section {
        kind: region.kind(),
        vertices: region.vertices().iter().map(vertex).collect(),
        rays: region.rays(),
        lines: region.lines(),
        boundaries: region.boundaries().iter().map(boundary).collect(),
        pui: polyhedron.bounding_box(),
    }
}

/// The problem in another unit of the response: responses, error bounds and right-hand sides of conditions times a factor.
/// Every parameter is then that many times as large. With a factor of 2⁸⁰ or more no column of responses other than zeros
/// fits into machine integers.
pub fn in_unit(problem: &Problem, factor: &Rational) -> Problem {
    let scaled = |row: &Measurement| {
        let (y, epsilon) = y_and_epsilon(row);
        Measurement::around(row.row, row.regressor.clone(), y * factor, epsilon * factor)
    };
    let error_bound = match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => ErrorBound::Uniform(epsilon * factor),
        per_row => per_row.clone(),
    };
    let rows = problem.measurements.kept().iter().map(scaled).collect();
    let condition = |condition: &Condition| {
        let Inequality { a: [a1, a2], b } = condition.inequality();
        let relation = if condition.is_equation() { "=" } else { "<=" };
        let text = format!("{a1}*theta1 + {a2}*theta2 {relation} {}", b * factor);
        parse_condition(&text)
    };
    let conditions = problem.conditions.iter().map(condition).collect();
    Problem { conditions, ..rebuilt(problem, rows, error_bound) }
}

/// An end of an interval: its value and the multipliers that prove it.
type End = Option<(Rational, Vec<Multiplier>)>;

/// A least error bound, its minimiser if it is the only one, and the proof.
type Least = (Rational, Option<[Rational; 2]>, Vec<(BoundName, Rational)>);

/// The statements of a fit, all parameters over a unit: the same for a problem and for the problem [in another
/// unit](in_unit).
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    least_squares: Option<([Rational; 2], Option<[Interval; 2]>)>,
    names: Vec<BoundName>,
    kind: RegionKind,
    vertices: Vec<([Rational; 2], Vec<usize>)>,
    boundaries: Vec<(Direction, Vec<usize>)>,
    directions: [Vec<Direction>; 2],
    pui: Option<[[End; 2]; 2]>,
    central: Option<[[Rational; 2]; 2]>,
    minimax: Option<Least>,
}

/// Returns what a fit of a problem says, over a unit.
pub fn answer(problem: &Problem, fit: &Fit, unit: &Rational) -> Answer {
    // Error bounds per reading have a least factor, in no unit, and multipliers that add them up to 1.
    let (least_unit, multiplier_unit) = match problem.measurements.error_bound() {
        ErrorBound::Uniform(_) => (unit.clone(), Rational::one()),
        _ => (Rational::one(), unit.clone()),
    };
    let over = |value: &Rational| value.checked_div(unit).expect("a unit that is not zero");
    let both = |values: &[Rational; 2]| values.each_ref().map(over);
    let region = fit.fps.polyhedron().region();
    let end = |bound: &ParameterBound| match bound {
        ParameterBound::Bounded { value, proof } => Some((over(value), proof.multipliers.clone())),
        ParameterBound::Unbounded(_) => None,
    };
    let interval = |interval: &Interval| {
        let [lower, upper] = [interval.lower(), interval.upper()].map(|end| end.value().map(over).into());
        Interval::new(lower, upper).expect("ends in order")
    };
    Answer {
        least_squares: fit.least_squares.as_ref().ok().map(|estimate| {
            (both(&estimate.theta), estimate.eui.as_ref().ok().map(|eui| eui.each_ref().map(interval)))
        }),
        names: fit.fps.names().to_vec(),
        kind: region.kind(),
        vertices: region
            .vertices()
            .iter()
            .map(|v| (both(&v.point().coordinates()), v.active().to_vec()))
            .collect(),
        boundaries: region
            .boundaries()
            .iter()
            .map(|b| (b.half_plane().normal(), b.active().to_vec()))
            .collect(),
        directions: [region.rays(), region.lines()],
        pui: fit.pui.as_ref().map(|pui| pui.each_ref().map(|ends| [end(&ends.lower), end(&ends.upper)])),
        central: fit.central.as_ref().map(|central| [both(&central.theta), both(&central.guaranteed_error)]),
        minimax: fit.minimax.as_ref().map(|minimax| {
            let theta = minimax.unique.then(|| both(&minimax.theta));
            let multipliers = minimax.proof.multipliers.iter();
            let multipliers = multipliers.map(|(name, value)| (*name, value * &multiplier_unit)).collect();
            (minimax.least.checked_div(&least_unit).expect("a unit that is not zero"), theta, multipliers)
        }),
    }
}

/// The answer as it comes without machine integers, from the problem in another unit.
pub fn answer_in_general(problem: &Problem) -> Answer {
    let unit = Rational::from(Integer::power_of_two(80));
    answer(problem, &fit(&in_unit(problem, &unit)), &unit)
}
