//! Equal answers from every way to compute a fit. The ways use machine integers or numbers of any size, active
//! half-planes or all of them, vertices or projective images.

use boundfit_estimation::{
    BoundName, Condition, ErrorBound, Fit, Fps, GrowingInequality, Inverse, InverseParameter, LeastGrowth,
    LeastSquares, Measurement, Measurements, Minimax, Model, ParameterBound, ParameterInterval, Problem,
    conditions_by_name, fit, growing_half_planes, half_planes, least_growth,
};
use boundfit_exact::{Interval, Limits, Rational, Reading};
use boundfit_geometry::{Direction, HalfPlane, Multiplier, Point, RegionKind};
use boundfit_tests::definitions::{answer, answer_in_general, box_of, inverse_ranges, least_bound};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::readings::{
    in_intervals, line, naive_least_squares, parse_condition, problem, with_error_bound,
};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

const CASES: usize = 2_000;

/// A set and everything that refers to its half-planes, by their names.
#[derive(Debug, PartialEq)]
struct NamedSet {
    kind: RegionKind,
    vertices: Vec<(Point, Vec<BoundName>)>,
    boundaries: Vec<(HalfPlane, Vec<BoundName>)>,
    directions: [Vec<Direction>; 2],
    witness: Option<Point>,
    irredundant: Vec<BoundName>,
    pui: Option<[[End; 2]; 2]>,
}

/// One end of an interval: its value, the proof by names and where it is attained; or the proof that there is none.
type End = (Option<Rational>, Vec<(BoundName, Rational)>, Point, Option<Direction>);

fn named_set(fps: &Fps, pui: Option<&[ParameterInterval; 2]>) -> NamedSet {
    let polyhedron = fps.polyhedron();
    let region = polyhedron.region();
    let names = |indices: &[usize]| indices.iter().map(|&index| fps.name(index)).collect();
    let active = |indices: &[usize]| fps.active(indices, usize::MAX).names;
    let end = |bound: &ParameterBound| match bound {
        ParameterBound::Bounded { value, proof } => {
            let named = |m: &Multiplier| (fps.name(m.index), m.value.clone());
            let multipliers = proof.multipliers.iter().map(named).collect();
            (Some(value.clone()), multipliers, proof.attained_at.clone(), None)
        }
        ParameterBound::Unbounded(proof) => (None, Vec::new(), proof.point.clone(), Some(proof.ray.clone())),
    };
    NamedSet {
        kind: region.kind(),
        vertices: region.vertices().iter().map(|v| (v.point().clone(), active(v.active()))).collect(),
        boundaries: region
            .boundaries()
            .iter()
            .map(|b| (b.half_plane().clone(), active(b.active())))
            .collect(),
        directions: [region.rays(), region.lines()],
        witness: region.witness(),
        irredundant: names(polyhedron.irredundant_by_angle()),
        pui: pui.map(|pui| pui.each_ref().map(|interval| [end(&interval.lower), end(&interval.upper)])),
    }
}

/// The tightest half-plane of a point, by name.
fn tightest(fps: &Fps, theta: &[Rational; 2]) -> (Option<Rational>, Option<BoundName>) {
    let membership = fps.polyhedron().membership(theta);
    (membership.slack, membership.tightest.map(|index| fps.name(index)))
}

/// Asserts that all paths agree; gives the fit.
fn same_on_all_paths(problem: &Problem, case: &str) -> Fit {
    let Problem { measurements, conditions } = problem;
    let fit = fit(problem);
    assert_eq!(answer(problem, &fit, &Rational::one()), answer_in_general(problem), "{case}");
    assert_eq!(naive_least_squares(measurements), fit.least_squares, "{case}");

    let every = fit.with_every_half_plane(problem);
    let bounds = measurements.kept().iter().flat_map(half_planes).count();
    assert_eq!(every.fps.names().len(), bounds + conditions_by_name(conditions).count(), "{case}");
    let (mut own, mut of_every) =
        (named_set(&fit.fps, fit.pui.as_ref()), named_set(&every.fps, every.pui.as_ref()));
    if own.kind == RegionKind::Point {
        // More half-planes than two go through a point, and which of them are needed depends on which there are.
        for set in [&mut own, &mut of_every] {
            set.irredundant.clear();
            set.pui.iter_mut().flatten().flatten().for_each(|(_, proof, ..)| proof.clear());
        }
    }
    assert_eq!(own, of_every, "{case}");
    let bound = measurements.error_bound();
    assert_eq!(fit.contradiction(bound), every.contradiction(bound), "{case}");
    let has_hulls = matches!(measurements.model(), Model::Line { .. }) && bound.is_uniform();
    let has_all = has_hulls || fit.fps.names().len() == every.fps.names().len();
    let estimates = [
        fit.least_squares.as_ref().ok().map(|estimate| &estimate.theta),
        fit.central.as_ref().map(|central| &central.theta).filter(|_| has_all),
        fit.minimax.as_ref().map(|minimax| &minimax.theta).filter(|_| has_all),
    ];
    if !measurements.kept().is_empty() {
        for theta in estimates.into_iter().flatten() {
            assert_eq!(tightest(&fit.fps, theta), tightest(&every.fps, theta), "{case}");
        }
    }

    let least =
        |minimax: &Option<Minimax>| minimax.as_ref().map(|m| (m.least.clone(), m.theta.clone(), m.unique));
    assert_eq!(least(&fit.minimax), least_bound(problem), "{case}");
    if let Some(inverse) = fit.inverse(measurements.model()) {
        let Inverse { gain, offset } = &inverse;
        let ranges = |of: fn(&InverseParameter) -> &Vec<Interval>| [of(gain).clone(), of(offset).clone()];
        let by_images = |intervals: &[Interval; 2]| inverse_ranges(&box_of(intervals));
        assert_eq!(ranges(|of| &of.exact_range), inverse_ranges(every.fps.polyhedron()), "{case}");
        let of_pui = fit.pui_intervals().map(|pui| by_images(&pui));
        assert_eq!(ranges(|of| &of.box_range), of_pui.unwrap_or_default(), "{case}");
        let of_eui =
            gain.eui_range.clone().zip(offset.eui_range.clone()).map(|(gain, offset)| [gain, offset]);
        assert_eq!(of_eui, fit.eui().map(by_images), "{case}");
        let at = |theta: &[Rational; 2]| {
            let gain = Rational::one().checked_div(&theta[0])?;
            Some((gain.clone(), -(&theta[1] * gain)))
        };
        let central = fit.central.as_ref().and_then(|central| at(&central.theta));
        assert_eq!(gain.central.clone().zip(offset.central.clone()), central, "{case}");
        let estimate = fit.least_squares.as_ref().ok().and_then(|estimate| at(&estimate.theta));
        assert_eq!(gain.least_squares.clone().zip(offset.least_squares.clone()), estimate, "{case}");
    }
    assert_eq!(fit.verify(problem), Ok(()), "{case}");
    fit
}

fn number(text: &str) -> Rational {
    Reading::Decimal.read(text, &Limits::default()).unwrap()
}

fn points(texts: &[(&str, &str)]) -> Vec<(Rational, Rational)> {
    texts.iter().map(|(x, y)| (number(x), number(y))).collect()
}

#[test]
fn generated_readings() {
    let mut rng = seeded(20);
    let (mut fewer, mut empty, mut one_sign) = (0, 0, 0);
    for case in 0..CASES {
        let mut problem = problem(&mut rng);
        // At its least error bound a set has no interior: the hardest cases.
        if case % 3 == 0
            && let Some(minimax) = Minimax::new(&problem.measurements, &problem.conditions)
        {
            problem = with_error_bound(&problem, &minimax.least);
        }
        let fit = same_on_all_paths(&problem, &format!("case {case}"));
        let all = 2 * problem.measurements.kept().len() + problem.conditions.len();
        fewer += usize::from(fit.fps.names().len() < all);
        empty += usize::from(fit.pui.is_none());
        one_sign += usize::from(
            fit.inverse(problem.measurements.model())
                .is_some_and(|inverse| inverse.offset.box_range.len() == 1),
        );
    }
    assert!(fewer > 500 && empty > 300 && one_sign > 200, "{fewer} {empty} {one_sign}");
}

/// Readings of a line with few different values: many in line, above each other and repeated.
fn ties(rng: &mut ChaCha8Rng) -> Problem {
    let spread = rng.random_range(0..=4);
    let mut small = || Rational::from(rng.random_range(-spread..=spread));
    let readings: Vec<_> = (0..16).map(|_| (small(), small())).collect();
    let count = rng.random_range(0..=16);
    let epsilon = Rational::ratio(rng.random_range(0..=12), 2);
    let mut problem = line(readings.into_iter().take(count), epsilon);
    let conditions = ["theta1 >= 0", "theta2 <= 1", "theta1 + theta2 >= 9", "theta1 + theta2 <= 8"];
    problem.conditions =
        conditions.iter().filter(|_| rng.random_bool(0.2)).map(|text| parse_condition(text)).collect();
    problem
}

#[test]
fn readings_in_line_above_each_other_and_repeated() {
    let mut rng = seeded(21);
    for case in 0..CASES {
        same_on_all_paths(&ties(&mut rng), &format!("case {case}"));
    }
}

#[test]
fn degenerate_readings() {
    type Texts<'a> = &'a [(&'a str, &'a str)];
    let cases: [(&str, Texts, &str); 8] = [
        ("none", &[], "1"),
        ("one", &[("2", "3")], "1"),
        ("one, exact", &[("2", "3")], "0"),
        ("one x", &[("2", "3"), ("2", "1"), ("2", "2"), ("2", "3")], "1"),
        ("one x, empty", &[("2", "3"), ("2", "1"), ("2", "2")], "1/2"),
        ("in line", &[("0", "1"), ("1", "3"), ("2", "5"), ("5", "11"), ("1", "3")], "0"),
        ("repeated", &[("0", "1"), ("0", "1"), ("4", "3"), ("4", "3"), ("2", "2.5")], "1/10"),
        ("empty", &[("0", "0"), ("1", "5"), ("2", "0"), ("3", "5")], "1/1000"),
    ];
    for (name, texts, epsilon) in cases {
        let mut problem = line(points(texts), number(epsilon));
        same_on_all_paths(&problem, name);
        for conditions in [&["theta1 >= 0"][..], &["theta1 <= -1", "theta1 >= 1"], &["0*theta1 <= -1"]] {
            problem.conditions = conditions.iter().map(|text| parse_condition(text)).collect();
            same_on_all_paths(&problem, &format!("{name} under {conditions:?}"));
        }
    }
}

/// Readings leave 62 bits as integers on a common denominator, leave 127 bits in their products, and do neither.
#[test]
fn edges_of_machine_integers() {
    let edges = (60..=65).flat_map(|bits| [-1, 0, 1].map(|beside| (1_i128 << bits) + beside));
    let mut sizes: Vec<Rational> = edges.map(Rational::from).collect();
    let texts = [
        "9999999999999999999",
        "1234567890123456789",
        "1e-300",
        "1e300",
        "1e-18",
        "1e19",
        "1/3",
        "1/9223372036854775807",
    ];
    sizes.extend(texts.into_iter().map(number));
    let mut rng = seeded(22);
    for case in 0..share(CASES) {
        let mut size = || {
            let size = &sizes[rng.random_range(0..sizes.len())];
            match rng.random_range(0..3) {
                0 => Rational::from(rng.random_range(-9..=9)),
                1 => -size,
                _ => size + Rational::from(rng.random_range(-2..=2)),
            }
        };
        let readings: Vec<_> = (0..5).map(|_| (size(), size())).collect();
        let epsilon = size().abs();
        let count = rng.random_range(2..=5);
        same_on_all_paths(&line(readings.into_iter().take(count), epsilon), &format!("case {case}"));
    }
}

/// The same with two regressors and an error bound for each reading, which have sums on machine integers only.
#[test]
fn edges_of_machine_integers_in_least_squares() {
    let mut rng = seeded(23);
    for case in 0..CASES {
        let bits = rng.random_range(1..=66);
        let mut number = || {
            let limit = 1_i128 << bits;
            Rational::new(
                rng.random_range(-limit..=limit).into(),
                [1, 2, 10, 1000][rng.random_range(0..4)].into(),
            )
            .unwrap()
        };
        let rows =
            (1..=6).map(|row| Measurement::around(row, [number(), number()], number(), number().abs()));
        let rows: Vec<Measurement> = rows.collect();
        let model = Model::TwoRegressors { regressors: ["u".into(), "v".into()] };
        let bound = ErrorBound::Column("eps".into());
        let measurements = Measurements::new(model, "y".into(), bound, rows);
        assert_eq!(LeastSquares::new(&measurements), naive_least_squares(&measurements), "case {case}");
    }
}

/// A set on both sides of θ1 = 0, touching it and beside it.
#[test]
fn the_inverse_line_beside_a_vertical_one() {
    let readings = points(&[("0", "0"), ("1", "1"), ("2", "2")]);
    let conditions: [&[&str]; 5] =
        [&[], &["theta1 >= 1/2"], &["theta1 >= 0"], &["theta1 <= 0"], &["theta1 <= -1/4"]];
    let mut ranges = Vec::new();
    for texts in conditions {
        let conditions: Vec<Condition> = texts.iter().map(|text| parse_condition(text)).collect();
        let problem = Problem { conditions, ..line(readings.clone(), Rational::from(3)) };
        let fit = same_on_all_paths(&problem, &format!("{texts:?}"));
        ranges.push(fit.inverse(problem.measurements.model()).unwrap().gain.exact_range.len());
    }
    assert_eq!(ranges, [2, 1, 1, 1, 1]);
}

/// Enough half-planes for the sort by keys, in an order that is not theirs.
#[test]
fn many_extreme_readings() {
    let count = 400_i64;
    let places = (0..count).map(|k| k * 171 % count - count / 2);
    let readings: Vec<_> = places.map(|x| (Rational::from(x), Rational::from(x * x))).collect();
    for epsilon in [count * count / 8, count * count / 4, 4 * count * count] {
        let fit =
            same_on_all_paths(&line(readings.clone(), Rational::from(epsilon)), &format!("ε = {epsilon}"));
        assert!(fit.fps.names().len() > count as usize);
    }
}

/// More readings than are worth a filter, of models without hulls: on a coarse grid with ties, or of many digits.
fn many(rng: &mut ChaCha8Rng) -> Problem {
    let count = rng.random_range(64..220);
    let unit = [2_i64, 10, 1_000_000, 1 << 52][rng.random_range(0..4)];
    let is_line = rng.random_bool(0.3);
    let mut number = |size: i64| Rational::ratio(rng.random_range(-size * unit..=size * unit), unit);
    let rows: Vec<[Rational; 3]> = (0..count)
        .map(|_| {
            let (first, second) = (number(5), if is_line { Rational::one() } else { number(3) });
            let y = &first * Rational::ratio(5, 2) - &second + number(1);
            [first, second, y]
        })
        .collect();
    let is_uniform = !is_line && rng.random_bool(0.5);
    let widest = [Rational::ratio(1, 2), Rational::one(), Rational::from(3)][rng.random_range(0..3)].clone();
    let mut epsilon = || match is_uniform {
        true => widest.clone(),
        false => &widest * Rational::ratio(rng.random_range(0..=8), 4),
    };
    let rows = (1..).zip(rows).map(|(row, [u, v, y])| Measurement::around(row, [u, v], y, epsilon()));
    let rows: Vec<Measurement> = rows.collect();
    let model = match is_line {
        true => Model::Line { x: "x".into() },
        false => Model::TwoRegressors { regressors: ["u".into(), "v".into()] },
    };
    let bound = if is_uniform { ErrorBound::Uniform(widest) } else { ErrorBound::Column("eps".into()) };
    let conditions = ["theta1 >= 2", "theta2 = -1", "theta1 + theta2 <= 2"];
    let conditions =
        conditions.iter().filter(|_| rng.random_bool(0.2)).map(|text| parse_condition(text)).collect();
    Problem { measurements: Measurements::new(model, "y".into(), bound, rows), conditions }
}

/// Asserts that the set of intervals and their least factor are those of all half-planes.
fn same_in_intervals(problem: &Problem, case: &str) {
    let fit = fit(problem);
    let every = fit.with_every_half_plane(problem);
    let set = |fit: &Fit| NamedSet { irredundant: Vec::new(), ..named_set(&fit.fps, None) };
    assert_eq!(set(&fit), set(&every), "{case}");
    assert_eq!(fit.pui_intervals(), every.pui_intervals(), "{case}");
    let bound = problem.measurements.error_bound();
    assert_eq!(fit.contradiction(bound), every.contradiction(bound), "{case}");
    assert_eq!(fit.least_squares_slack(), every.least_squares_slack(), "{case}");
    let rows = problem.measurements.kept().iter().flat_map(growing_half_planes).map(|(_, growing)| growing);
    let conditions = conditions_by_name(&problem.conditions)
        .map(|(_, at_zero)| GrowingInequality { at_zero, growth: Rational::zero() });
    let least = match least_growth(&rows.chain(conditions).collect::<Vec<_>>()) {
        LeastGrowth::From { t, .. } => Some(t),
        LeastGrowth::Never => None,
    };
    assert_eq!(fit.minimax.as_ref().map(|minimax| minimax.least.clone()), least, "{case}");
    assert_eq!(fit.verify(problem), Ok(()), "{case}");
}

#[test]
fn many_readings_without_hulls() {
    let mut rng = seeded(24);
    let (mut fewer, mut empty) = (0, 0);
    for case in 0..share(400) {
        let mut problem = many(&mut rng);
        if case % 4 == 0
            && let Some(minimax) = Minimax::new(&problem.measurements, &problem.conditions)
        {
            problem = with_error_bound(&problem, &minimax.least);
        }
        let fit = same_on_all_paths(&problem, &format!("case {case}"));
        fewer += usize::from(fit.fps.names().len() < problem.measurements.kept().len());
        empty += usize::from(fit.pui.is_none());
        same_in_intervals(&in_intervals(&problem, &mut rng), &format!("intervals of case {case}"));
    }
    assert!(fewer > share(150) && empty > share(80), "{fewer} {empty}");
}
