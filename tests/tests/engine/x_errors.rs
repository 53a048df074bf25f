//! Lines under errors in x, against the definition tried at every crossing of the lines through the corners of boxes.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use boundfit_estimation::{
    BoundName, Condition, ErrorBound, Fps, Measurement, Measurements, Model, ParameterBound, Problem, fit,
};
use boundfit_exact::{Endpoint, Rational};
use boundfit_questions::{
    Agreement, LeastFactor, NoLeastFactor, NoXErrors, Side, XBounds, XErrorFit, XErrorProblem,
};
use boundfit_tests::boxes::{BoxReading, Boxes, Q, Theta};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::readings::parse_condition;
use num_traits::Zero;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

fn q(number: &Rational) -> Q {
    Q::from(number)
}

fn theta_q(theta: &[Rational; 2]) -> Theta {
    theta.each_ref().map(q)
}

/// One to six readings, most of them degenerate: few different numbers, exact ones among them, equal x, one side only.
fn generated(rng: &mut ChaCha8Rng) -> XErrorProblem {
    let count = rng.random_range(1..=6);
    let size = [1, 2, 5][rng.random_range(0..3)];
    let style = rng.random_range(0..8);
    let number = |rng: &mut ChaCha8Rng, least: i64, most: i64| {
        Rational::ratio(rng.random_range(least..=most), if style == 7 { rng.random_range(1..=3) } else { 1 })
    };
    let slope = rng.random_range(-2..=2);
    let one_x = number(rng, -size, size);
    let rows = (1..=count).map(|row| {
        let x = if style == 0 { one_x.clone() } else { number(rng, -size, size) };
        let mut y = number(rng, -size, size);
        if style == 1 || style == 2 {
            y = &x * Rational::from(slope) + Rational::from(rng.random_range(-1..=1));
        }
        let regressor = [x, Rational::one()];
        let epsilon = number(rng, 0, 2);
        match rng.random_range(0..if style == 6 { 3 } else { 12 }) {
            0 if style == 6 => Measurement::between(row, regressor, Some(y), None),
            1 if style == 6 => Measurement::between(row, regressor, None, Some(y)),
            // They may cross.
            0 => Measurement::between(row, regressor, Some(&y - &epsilon), Some(y + number(rng, -1, 2))),
            _ => Measurement::around(row, regressor, y, epsilon),
        }
    });
    let rows: Vec<Measurement> = rows.collect();
    let bounds = match rng.random_range(0..4) {
        0 => XBounds::Uniform(number(rng, 0, 2)),
        _ => XBounds::PerRow { column: "d".into(), bounds: (0..count).map(|_| number(rng, 0, 2)).collect() },
    };
    let texts = ["theta1 <= 1", "theta2 = 0", "theta1 + theta2 >= 1", "theta1 >= -1/2", "2*theta2 <= theta1"];
    let asked = if rng.random_bool(0.25) { rng.random_range(1..=2) } else { 0 };
    let conditions: Vec<Condition> =
        (0..asked).map(|_| parse_condition(texts[rng.random_range(0..texts.len())])).collect();
    let bound = ErrorBound::Column("e".into());
    let measurements = Measurements::new(Model::Line { x: "x".into() }, "y".into(), bound, rows);
    let agreement = if rng.random_bool(0.4) { Agreement::Strong } else { Agreement::Weak };
    XErrorProblem::new(Problem { measurements, conditions }, bounds, agreement).unwrap()
}

fn boxes(problem: &XErrorProblem) -> Boxes {
    let readings = problem.readings().map(|(row, width)| BoxReading {
        x: q(&row.regressor[0]),
        width: q(width),
        lower: row.lower().as_ref().map(q),
        upper: row.upper().as_ref().map(q),
    });
    let conditions = problem.problem().conditions.iter().flat_map(Condition::inequalities);
    let conditions = conditions.map(|own| [q(&own.a[0]), q(&own.a[1]), q(&own.b)]);
    Boxes {
        readings: readings.collect(),
        conditions: conditions.collect(),
        is_strong: problem.agreement() == Agreement::Strong,
    }
}

fn sign(side: Side) -> i64 {
    match side {
        Side::Rising => 1,
        Side::Falling => -1,
        Side::Both => 0,
    }
}

/// Vertices, ends of the intervals, proofs and membership.
fn check_sets(problem: &XErrorProblem, answer: &XErrorFit, boxes: &Boxes, rng: &mut ChaCha8Rng) {
    let mut corners = BTreeSet::new();
    for side in &answer.sides {
        side.verify().unwrap();
        let expected = boxes.corners(sign(side.side));
        let vertices = side.polyhedron.region().vertices().iter();
        let found: BTreeSet<Theta> = vertices.map(|own| theta_q(&own.point().coordinates())).collect();
        assert_eq!(found, expected, "{problem:?}");
        assert_eq!(side.is_empty(), side.pui.is_none());
        for (axis, interval) in side.pui.iter().flatten().enumerate() {
            for (end, towards) in [(&interval.lower, -1), (&interval.upper, 1)] {
                let mut form = [0, 0];
                form[axis] = towards;
                let values = expected.iter().map(|theta| theta[axis].clone());
                let is_endless = boxes.are_endless(sign(side.side), form);
                match end.endpoint() {
                    Endpoint::Unbounded => assert!(is_endless, "{problem:?}"),
                    Endpoint::Finite(value) => {
                        assert!(!is_endless, "{problem:?}");
                        let extreme = if towards < 0 { values.min() } else { values.max() };
                        // Without a corner the set is a strip of parallel lines.
                        assert!(extreme.is_none_or(|extreme| extreme == q(&value)), "{problem:?}");
                    }
                }
            }
        }
        corners.extend(expected);
    }
    let corners: Vec<Theta> = corners.into_iter().collect();
    let mut points: Vec<Theta> = corners.clone();
    let two = Q::from_integer(2.into());
    points.extend(corners.iter().take(4).flat_map(|one| {
        corners.iter().take(4).map(|other| [(&one[0] + &other[0]) / &two, (&one[1] + &other[1]) / &two])
    }));
    points.extend(
        (-2..=2).flat_map(|one| {
            (-2..=2).map(move |other| [one, other].map(|own: i64| Q::from_integer(own.into())))
        }),
    );
    points.extend(
        (0..8).map(|_| {
            [0, 1].map(|_| Q::new(rng.random_range(-40..=40).into(), rng.random_range(1..=7).into()))
        }),
    );
    for point in points {
        let theta = point.clone().map(Rational::from);
        assert_eq!(answer.contains(&theta), boxes.contain(&point), "{theta:?} {problem:?}");
    }
    assert_eq!(answer.is_empty(), !boxes.have_a_line(), "{problem:?}");
}

/// The union of the sides' intervals, its middle, and whether pieces touch.
fn check_union(answer: &XErrorFit) {
    let pieces = answer.pieces();
    assert!(pieces.len() <= 2 && pieces.is_empty() == answer.is_empty());
    let Some(pui) = answer.pui() else {
        assert!(answer.is_empty() && answer.central.is_none() && answer.end(0, true).is_none());
        return;
    };
    for axis in [0, 1] {
        for (is_upper, end) in [(false, pui[axis].lower()), (true, pui[axis].upper())] {
            let (_, bound) = answer.end(axis, is_upper).unwrap();
            assert_eq!(bound.endpoint(), *end);
            for piece in &answer.sides {
                let Some(own) = &piece.pui else { continue };
                let own = own[axis].interval();
                let own = if is_upper { own.upper() } else { own.lower() };
                match (own.value(), end.value()) {
                    (_, None) => {}
                    (Some(own), Some(end)) => assert!(if is_upper { own <= end } else { own >= end }),
                    (None, Some(_)) => panic!("a piece beyond the union"),
                }
            }
        }
    }
    if let [one, other] = pieces.as_slice() {
        let level = |side: &boundfit_questions::SideSet| {
            side.pui.as_ref().unwrap()[0].interval().contains(&Rational::zero())
        };
        assert_eq!(answer.are_joined(), Some(level(one)));
        assert_eq!(level(one), level(other));
    } else {
        assert_eq!(answer.are_joined(), None);
    }
    let middle = pui[0].midpoint().zip(pui[1].midpoint()).map(|(one, other)| [one, other]);
    assert_eq!(answer.central.as_ref().map(|central| central.theta.clone()), middle);
}

/// The least factor: something above it, nothing below.
fn check_factor(problem: &XErrorProblem, answer: &XErrorFit, boxes: &Boxes) -> &'static str {
    let tiny = Rational::scientific(1, -12);
    let leaves = |factor: &Rational| boxes.times(&q(factor)).have_a_line();
    let least = match &answer.least {
        Err(NoLeastFactor::NotMonotone) => {
            assert_eq!(problem.agreement(), Agreement::Strong);
            return "not monotone";
        }
        Err(NoLeastFactor::Never) => {
            for factor in [tiny, Rational::one(), Rational::from(1000), Rational::scientific(1, 12)] {
                assert!(!leaves(&factor), "{problem:?}");
            }
            return "never";
        }
        Ok(least) => least,
    };
    let is_enough = match least.upper.cmp(&Rational::one()) {
        Ordering::Equal => least.theta.is_some(),
        order => order == Ordering::Less,
    };
    assert_eq!(is_enough, !answer.is_empty(), "{problem:?} {least:?}");
    if let Some(theta) = &least.theta {
        assert!(boxes.times(&q(&least.upper)).contain(&theta_q(theta)), "{problem:?} {least:?}");
    }
    match least.exact() {
        Some(zero) if zero.is_zero() => {
            assert!(leaves(&tiny), "{problem:?}");
            assert!(least.fixed_by.is_empty());
            if problem.agreement() == Agreement::Weak {
                assert_eq!(leaves(zero), least.theta.is_some(), "{problem:?}");
            }
            "zero"
        }
        Some(value) => {
            assert!(!leaves(&(value * (Rational::one() - &tiny))), "{problem:?} {least:?}");
            assert!(leaves(&(value * (Rational::one() + tiny))), "{problem:?} {least:?}");
            assert_eq!(leaves(value), least.theta.is_some(), "{problem:?} {least:?}");
            assert!(check_reason(problem, least));
            if least.theta.is_some() { "rational" } else { "not attained" }
        }
        None => {
            assert!(!leaves(&least.lower) && leaves(&least.upper), "{problem:?} {least:?}");
            let width = &least.upper - &least.lower;
            assert!(width < &least.upper * Rational::scientific(1, -15), "{least:?}");
            assert!(least.theta.is_some());
            assert!(check_reason(problem, least));
            "irrational"
        }
    }
}

/// Returns whether the rows that fix a factor ask for it by themselves, and for no more.
fn check_reason(problem: &XErrorProblem, least: &LeastFactor) -> bool {
    let LeastFactor { lower, upper, side, fixed_by, .. } = least;
    let Problem { measurements, conditions } = problem.problem();
    let is_named = |row: usize| fixed_by.iter().any(|name| name.row() == Some(row));
    let kept = |position: &usize| is_named(measurements.kept()[*position].row);
    let positions: Vec<usize> = (0..measurements.kept().len()).filter(kept).collect();
    let rows: Vec<Measurement> = positions.iter().map(|&own| measurements.kept()[own].clone()).collect();
    let bounds = positions.iter().map(|&own| problem.bounds().of(own).clone()).collect();
    let bounds = XBounds::PerRow { column: "d".into(), bounds };
    let bound = measurements.error_bound().clone();
    let measurements = Measurements::new(measurements.model().clone(), "y".into(), bound, rows);
    let of_side = if *side == Side::Falling { "theta1 <= 0" } else { "theta1 >= 0" };
    let conditions = conditions.iter().cloned().chain([parse_condition(of_side)]).collect();
    let own = Problem { measurements, conditions };
    let own = XErrorProblem::new(own, bounds, problem.agreement()).unwrap();
    let own = own.fit().least.unwrap();
    // Under strong agreement fewer readings leave steeper lines to look at.
    let is_as_large = own.upper >= *lower || problem.agreement() == Agreement::Strong;
    fixed_by.len() <= 3 && own.lower <= *upper && is_as_large
}

#[test]
fn sets_and_factors_are_those_of_the_definition() {
    let mut rng = seeded(20_261_122);
    let mut seen = std::collections::BTreeMap::new();
    let mut count = |what: &'static str| *seen.entry(what).or_insert(0) += 1;
    for _ in 0..share(2000) {
        let problem = generated(&mut rng);
        let answer = problem.fit();
        let boxes = boxes(&problem);
        check_sets(&problem, &answer, &boxes, &mut rng);
        check_union(&answer);
        count(check_factor(&problem, &answer, &boxes));
        count(match (answer.pieces().len(), answer.are_joined()) {
            (0, _) => "empty",
            (1, _) => "one piece",
            (_, Some(true)) => "joined",
            _ => "apart",
        });
        if answer.pieces().iter().any(|piece| piece.polyhedron.region().vertices().len() == 1) {
            count("with a piece that is a point or a corner");
        }
    }
    let least = seen.values().min().copied().unwrap_or_default();
    assert!(seen.len() == 11 && least >= share(10), "{seen:?}");
}

#[test]
fn without_errors_in_x_the_set_is_that_of_a_plain_fit() {
    let mut rng = seeded(5);
    for _ in 0..400 {
        let problem = generated(&mut rng);
        for agreement in [Agreement::Weak, Agreement::Strong] {
            let bounds = XBounds::Uniform(Rational::zero());
            let own = XErrorProblem::new(problem.problem().clone(), bounds, agreement).unwrap();
            let answer = own.fit();
            let Problem { measurements, conditions } = own.problem();
            let plain = Fps::of_every_half_plane(measurements, conditions);
            let [side] = answer.sides.as_slice() else { panic!("two sides of one set") };
            assert_eq!(side.polyhedron.region(), plain.polyhedron().region());
            assert_eq!(side.polyhedron.system(), plain.polyhedron().system());
            let fit = fit(own.problem());
            assert_eq!(answer.pui(), fit.pui_intervals());
            assert_eq!(answer.central, fit.central);
            let least = answer.least.as_ref().ok().map(|least| least.exact().cloned().unwrap());
            let expected = fit.minimax.as_ref().map(|own| own.least.clone());
            match expected {
                // Where no reading has two bounds a fit has no width that could grow.
                None if !measurements.has_widths() => {
                    assert!(least.is_none_or(|own| own.is_zero()))
                }
                expected => assert_eq!(least, expected, "{own:?}"),
            }
        }
    }
}

#[test]
fn what_has_no_set_is_refused() {
    let row = |row| Measurement::around(row, [1.into(), 2.into()], 3.into(), 1.into());
    let problem = |model| {
        let bound = ErrorBound::Uniform(1.into());
        Problem::new(Measurements::new(model, "y".into(), bound, vec![row(1), row(2)]))
    };
    let line = Model::Line { x: "x".into() };
    let two = Model::TwoRegressors { regressors: ["a".into(), "b".into()] };
    let refused = |model, bounds| XErrorProblem::new(problem(model), bounds, Agreement::Weak).unwrap_err();
    let uniform = |bound: i64| XBounds::Uniform(bound.into());
    assert_eq!(refused(two, uniform(1)), NoXErrors::TwoRegressors);
    assert_eq!(refused(line.clone(), uniform(-1)), NoXErrors::Negative);
    let one = XBounds::PerRow { column: "d".into(), bounds: vec![Rational::one()] };
    assert_eq!(refused(line, one).to_string(), "1 bounds for 2 readings");
}

#[test]
fn no_line_meets_all_boxes_of_a_course() {
    let data = [(9, 2190), (12, 2306), (14, 2584), (16, 2696), (18, 2842), (20, 2892)];
    let mut rows = Vec::new();
    for ((x, y), row) in data.into_iter().zip(1..) {
        let regressor = [Rational::ratio(x, 2), Rational::one()];
        rows.push(Measurement::around(row, regressor, Rational::ratio(y, 20), Rational::ratio(3, 2)));
    }
    let bound = ErrorBound::Uniform(Rational::ratio(3, 2));
    let measurements = Measurements::new(Model::Line { x: "U".into() }, "I".into(), bound, rows);
    let problem = Problem::new(measurements);
    assert_eq!(fit(&problem).minimax.unwrap().least, Rational::ratio(263, 80));
    let own = XErrorProblem::new(problem, XBounds::Uniform(Rational::ratio(3, 20)), Agreement::Weak).unwrap();
    let answer = own.fit();
    assert!(answer.is_empty());
    let least = answer.least.unwrap();
    let value = least.exact().unwrap().clone();
    assert_eq!(value, Rational::ratio(2630, 2079));
    assert_eq!(value.to_decimal(5, boundfit_exact::Rounding::Up), "1.2651");
    assert!(answer.sides[0].pui.is_none());
    assert!(!boxes(&own).times(&q(&(&value - Rational::scientific(1, -20)))).have_a_line());
    assert!(boxes(&own).times(&q(&value)).have_a_line());
    assert!(!q(&value).is_zero());
    assert_eq!(least.fixed_by, [BoundName::Upper(2), BoundName::Lower(3), BoundName::Upper(6)]);
    let bounded = |bound: &ParameterBound| matches!(bound, ParameterBound::Bounded { .. });
    assert!(answer.sides.iter().all(|side| side.pui.iter().flatten().all(|own| bounded(&own.lower))));
}
