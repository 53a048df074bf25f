//! The sets FPS(s·ε) for all factors s, against a fresh fit at each.

use std::collections::BTreeMap;

use boundfit_estimation::{
    Bounds, Breakpoint, ErrorBound, Family, Fps, Measurement, Measurements, Model, Piece, Problem, Section,
    fit,
};
use boundfit_exact::{Endpoint, Rational};
use boundfit_geometry::RegionKind;
use boundfit_tests::definitions::section;
use boundfit_tests::generate::seeded;
use boundfit_tests::readings::{
    in_intervals, line, noisy_line, parse_condition, problem, rebuilt, with_rows, y_and_epsilon,
};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// The set with every error bound multiplied, computed afresh.
fn fresh(problem: &Problem, s: &Rational) -> Section {
    section(&fresh_fps(problem, s))
}

fn fresh_fps(problem: &Problem, s: &Rational) -> Fps {
    let scaled = |row: &Measurement| row.clone().within(y_and_epsilon(row).1 * s);
    let rows = problem.measurements.kept().iter().map(scaled).collect();
    let error_bound = match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => ErrorBound::Uniform(epsilon * s),
        per_row => per_row.clone(),
    };
    let problem = rebuilt(problem, rows, error_bound);
    Fps::of_every_half_plane(&problem.measurements, &problem.conditions)
}

/// The set of readings that are intervals, each of them about its middle a factor as wide.
fn fresh_intervals(problem: &Problem, s: &Rational) -> Section {
    section(&fresh_intervals_fps(problem, s))
}

fn fresh_intervals_fps(problem: &Problem, s: &Rational) -> Fps {
    let scaled = |row: &Measurement| {
        let mut row = row.clone();
        if let Bounds::Between { lower: Some(lower), upper: Some(upper), .. } = &mut row.bounds
            && lower <= upper
        {
            let (middle, half_width) = ((&*lower + &*upper).half(), (&*upper - &*lower).half());
            (*lower, *upper) = (&middle - &half_width * s, &middle + &half_width * s);
        }
        row
    };
    let rows = problem.measurements.kept().iter().map(scaled).collect();
    let problem = with_rows(problem, rows);
    Fps::of_every_half_plane(&problem.measurements, &problem.conditions)
}

/// Returns the content of a piece without its ends: two neighbours that agree in this should have been one.
fn shape(piece: &Piece) -> Piece {
    Piece { from: Rational::zero(), to: Rational::zero(), ..piece.clone() }
}

/// Areas that follow from each other are the sums over all corners, also in that a sum of more digits than asked for is not there.
fn check_areas(family: &Family, case: usize) {
    for digits in [0, 1, 2, 4, 8, 16, 40, 10_000] {
        let areas = family.short_areas(digits);
        assert_eq!(areas.pieces.len(), family.pieces().len());
        for (piece, own) in family.pieces().iter().zip(&areas.pieces) {
            let Some(own) = own else {
                assert!(digits < 10_000 || piece.kind != RegionKind::Polygon, "case {case}");
                continue;
            };
            let area = piece.area().unwrap();
            let sums = [area.constant(), area.slope(), area.quadratic()].map(|sum| sum.exact_within(digits));
            assert_eq!(sums, own.clone().map(Some), "case {case}, {digits} digits");
        }
        for (breakpoint, own) in family.breakpoints().iter().zip(&areas.breakpoints) {
            let measures = breakpoint.section.measures();
            match own {
                Some(own) => assert_eq!(measures.area().unwrap().exact_within(digits).as_ref(), Some(own)),
                None => {
                    assert!(digits < 10_000 || breakpoint.section.kind != RegionKind::Polygon, "case {case}")
                }
            }
        }
    }
}

fn check_structure(family: &Family, case: usize) {
    check_areas(family, case);
    let (breakpoints, pieces) = (family.breakpoints(), family.pieces());
    assert_eq!(breakpoints.len(), pieces.len() + 1, "case {case}");
    for (number, piece) in pieces.iter().enumerate() {
        assert!(piece.from < piece.to, "case {case}");
        assert_eq!((&piece.from, &piece.to), (&breakpoints[number].s, &breakpoints[number + 1].s));
    }
    for (number, pair) in pieces.windows(2).enumerate() {
        assert_ne!(shape(&pair[0]), shape(&pair[1]), "case {case}: nothing changes at a breakpoint");
        let breakpoint = &breakpoints[number + 1];
        for (below, above, names) in
            [(&pair[0], &pair[1], &breakpoint.entering), (&pair[1], &pair[0], &breakpoint.leaving)]
        {
            let expected: Vec<_> =
                above.shaped_by.iter().filter(|name| !below.shaped_by.contains(name)).copied().collect();
            assert_eq!(*names, expected, "case {case}");
        }
        // The ends of the intervals do not jump, except where the set is born.
        if pair[0].kind != RegionKind::Empty {
            for (axis, interval) in breakpoint.section.pui.iter().flatten().enumerate() {
                for (side, end) in [interval.lower(), interval.upper()].into_iter().enumerate() {
                    for piece in pair {
                        let moving = piece.pui.as_ref().and_then(|pui| pui[axis][side].as_ref());
                        let there =
                            moving.map_or(Endpoint::Unbounded, |end| Endpoint::Finite(end.at(&breakpoint.s)));
                        assert_eq!(there, *end, "case {case}");
                    }
                }
            }
        }
    }
}

#[test]
fn at_every_factor_the_family_equals_a_fresh_fit() {
    let mut rng = seeded(41);
    let mut kinds: BTreeMap<RegionKind, usize> = BTreeMap::new();
    let (mut compared, mut breakpoints) = (0, 0);
    for case in 0..800 {
        let problem = problem(&mut rng);
        let family = Family::new(&problem, Rational::zero(), Rational::from(3));
        check_structure(&family, case);
        breakpoints += family.breakpoints().len();
        let factors = (0..5).map(|_| Rational::ratio(rng.random_range(0..=3000), 1000)).collect::<Vec<_>>();
        let middles = family.pieces().iter().map(|piece| (&piece.from + &piece.to).half());
        let thirds = family
            .pieces()
            .iter()
            .map(|piece| (&piece.from * Rational::from(2) + &piece.to) * Rational::ratio(1, 3));
        let ends = family.breakpoints().iter().map(|breakpoint| breakpoint.s.clone());
        for s in factors.into_iter().chain(middles).chain(thirds).chain(ends) {
            let expected = fresh(&problem, &s);
            *kinds.entry(expected.kind).or_default() += 1;
            compared += 1;
            assert_eq!(family.at(&s), Some(expected), "case {case} at s = {s}");
        }
    }
    assert!(compared > 10_000 && breakpoints > 1_000, "{compared} factors, {breakpoints} breakpoints");
    for kind in RegionKind::ALL {
        let seldom = [RegionKind::Plane, RegionKind::HalfPlane].contains(&kind);
        assert!(
            seldom || kinds.get(&kind).is_some_and(|count| *count >= 20),
            "{kind:?} was hit too seldom: {kinds:?}"
        );
    }
}

#[test]
fn intervals_and_readings_with_one_bound_equal_a_fresh_fit() {
    let mut rng = seeded(46);
    let (mut growing, mut constant) = (0, 0);
    for case in 0..600 {
        let problem = in_intervals(&problem(&mut rng), &mut rng);
        let family = Family::new(&problem, Rational::zero(), Rational::from(3));
        check_structure(&family, case);
        let sets = family.pieces().iter().filter(|piece| piece.kind != RegionKind::Empty).count();
        *(if sets > 1 { &mut growing } else { &mut constant }) += sets.min(1);
        let middles = family.pieces().iter().map(|piece| (&piece.from + &piece.to).half());
        let ends = family.breakpoints().iter().map(|breakpoint| breakpoint.s.clone());
        for s in middles.chain(ends) {
            assert_eq!(family.at(&s), Some(fresh_intervals(&problem, &s)), "case {case} at s = {s}");
        }
    }
    assert!(growing > 50 && constant > 50, "{growing} families grow, {constant} do not");
}

#[test]
fn a_thousand_random_factors_of_a_line_equal_fresh_fits() {
    let problem = noisy_line(60);
    let family = Family::new(&problem, Rational::zero(), Rational::from(4));
    check_structure(&family, 0);
    assert!(family.breakpoints().len() > 8);
    let mut rng = seeded(42);
    for _ in 0..1_000 {
        let s = Rational::ratio(rng.random_range(0..=4_000_000), rng.random_range(1_000_000..=1_100_000));
        if s <= Rational::from(4) {
            assert_eq!(family.at(&s), Some(fresh(&problem, &s)), "s = {s}");
        }
    }
}

#[test]
fn readings_in_line_and_repeated_ones_stay_active() {
    let mut rng = seeded(45);
    let mut longest = 0;
    for case in 0..300 {
        let epsilon = Rational::ratio(rng.random_range(0..=4), 2);
        let rows = (1..=rng.random_range(3..=15)).map(|row| {
            let regressor = [Rational::from(rng.random_range(-3..=3)), Rational::one()];
            Measurement::around(row, regressor, Rational::from(rng.random_range(0..=2)), epsilon.clone())
        });
        let model = Model::Line { x: "x".into() };
        let bound = ErrorBound::Uniform(epsilon.clone());
        let measurements = Measurements::new(model, "y".into(), bound, rows.collect());
        let problem = Problem { measurements, conditions: Vec::new() };
        let family = Family::new(&problem, Rational::zero(), Rational::from(3));
        check_structure(&family, case);
        let middles = family.pieces().iter().map(|piece| (&piece.from + &piece.to).half());
        for s in middles.chain(family.breakpoints().iter().map(|breakpoint| breakpoint.s.clone())) {
            let expected = fresh(&problem, &s);
            let active = expected.vertices.iter().map(|vertex| vertex.active.names.len());
            longest = active.max().unwrap_or(0).max(longest);
            assert_eq!(family.at(&s), Some(expected), "case {case} at s = {s}");
        }
    }
    assert!(longest > 5, "at most {longest} active bounds at a vertex");
}

#[test]
fn the_set_is_born_at_the_least_factor() {
    let mut rng = seeded(43);
    let (mut born, mut never) = (0, 0);
    for case in 0..300 {
        let problem = problem(&mut rng);
        let family = Family::new(&problem, Rational::zero(), Rational::from(1000));
        match family.least() {
            None => {
                never += 1;
                assert!(family.pieces().iter().all(|piece| piece.kind == RegionKind::Empty), "case {case}");
            }
            Some(least) if least.is_positive() && *least < Rational::from(1000) => {
                born += 1;
                assert_ne!(family.at(least).unwrap().kind, RegionKind::Empty, "case {case}");
                assert_eq!(family.pieces()[0].kind, RegionKind::Empty);
                assert_eq!(family.pieces()[0].to, *least);
                assert!(family.pieces()[1..].iter().all(|piece| piece.kind != RegionKind::Empty));
            }
            Some(_) => assert!(family.pieces().iter().all(|piece| piece.kind != RegionKind::Empty)),
        }
    }
    assert!(born >= 100 && never >= 5, "{born} born, {never} never");
}

#[test]
fn a_part_of_the_range_says_the_same() {
    let mut rng = seeded(44);
    for case in 0..100 {
        let problem = problem(&mut rng);
        let whole = Family::new(&problem, Rational::zero(), Rational::from(3));
        let part = Family::new(&problem, Rational::ratio(1, 2), Rational::ratio(3, 2));
        check_structure(&part, case);
        for piece in part.pieces() {
            let middle = (&piece.from + &piece.to).half();
            assert_eq!(part.at(&middle), whole.at(&middle), "case {case}");
        }
        let one = Rational::one();
        let single = Family::new(&problem, one.clone(), one.clone());
        assert_eq!((single.pieces().len(), single.breakpoints().len()), (0, 1));
        assert_eq!(single.at(&one), Some(section(&fit(&problem).fps)));
        assert_eq!(single.at(&Rational::zero()), None);
        assert_eq!(single.at(&Rational::from(2)), None);
    }
}

/// Readings of which several do something at one factor: symmetric about an axis or a point, on few lines, or equal. Every
/// fifth problem has those of a smooth curve with 15 decimals, each of which decides.
fn regular(rng: &mut ChaCha8Rng, case: usize) -> Problem {
    let half = rng.random_range(2..=8_i64);
    let epsilon = Rational::ratio(rng.random_range(1..=4), 2);
    let steps = -half..=half;
    let mut problem = match case % 5 {
        0 => {
            let bend = rng.random_range(0..=2);
            line(steps.map(|x| (Rational::from(x), Rational::from(x * x * bend + x))), epsilon)
        }
        1 => line(steps.map(|x| (Rational::from(x), Rational::from(x.abs().min(half - 1)))), epsilon),
        2 => {
            let equal = steps.map(|x| (Rational::from(x.rem_euclid(3)), Rational::from(x.rem_euclid(2))));
            line(equal, epsilon)
        }
        3 => {
            let curve = (0..4 * half).map(|x| {
                let root = (1.0 + x as f64 / 1000.0).sqrt();
                (Rational::ratio(x, 1000), Rational::scientific((root * 1e15).round() as i64, -15))
            });
            line(curve, Rational::ratio(1, 20))
        }
        _ => {
            let corner = |u: i64, v: i64| [Rational::from(u), Rational::from(v)];
            let regressors = steps.flat_map(|u| [corner(u, half - u.abs()), corner(u, -half)]);
            let rows = (1..).zip(regressors);
            let rows = rows.map(|(row, own)| {
                Measurement::around(row, own, Rational::from(row as i64 % 2), epsilon.clone())
            });
            let model = Model::TwoRegressors { regressors: ["u".into(), "v".into()] };
            let bound = ErrorBound::Uniform(epsilon.clone());
            let measurements = Measurements::new(model, "y".into(), bound, rows.collect());
            Problem { measurements, conditions: Vec::new() }
        }
    };
    let conditions = ["theta1 >= 0", "theta1 + theta2 <= 1", "theta1 = theta2", "theta2 <= 3", "theta1 <= 2"];
    let wanted = conditions.iter().filter(|_| rng.random_bool(0.15));
    problem.conditions = wanted.map(|text| parse_condition(text)).collect();
    problem
}

/// The readings with one of their bounds alone, where chance says so: its half-plane stays, as in a fit without the other.
fn with_one_bound(problem: &Problem, rng: &mut ChaCha8Rng) -> Problem {
    let mut rows = problem.measurements.kept().to_vec();
    for row in &mut rows {
        let (y, epsilon) = y_and_epsilon(row);
        let (lower, upper) = (Some(y - epsilon), Some(y + epsilon));
        let (lower, upper) = [(lower.clone(), upper.clone()), (lower, None), (None, upper)]
            .into_iter()
            .nth(rng.random_range(0..6_usize).saturating_sub(3))
            .unwrap_or_default();
        row.bounds = Bounds::Between { lower, upper, response: None };
    }
    let columns = ErrorBound::Interval { lower: Some("low".into()), upper: Some("high".into()) };
    rebuilt(problem, rows, columns)
}

#[test]
fn shapes_that_change_in_one_place_or_in_several_equal_fresh_fits() {
    let mut rng = seeded(47);
    let (mut single, mut several) = (0, 0);
    for case in 0..200 {
        let around = regular(&mut rng, case);
        let between = with_one_bound(&around, &mut rng);
        type Fresh = fn(&Problem, &Rational) -> Fps;
        for (problem, fresh) in [(around, fresh_fps as Fresh), (between, fresh_intervals_fps as Fresh)] {
            let family = Family::new(&problem, Rational::zero(), Rational::from(8));
            check_structure(&family, case);
            for piece in family.pieces() {
                let s = &piece.from + (&piece.to - &piece.from) * Rational::ratio(2, 7);
                let fps = fresh(&problem, &s);
                if piece.kind == RegionKind::Polygon {
                    let shaping = fps.polyhedron().irredundant().into_iter().map(|index| fps.name(index));
                    assert_eq!(piece.shaped_by, shaping.collect::<Vec<_>>(), "case {case} at s = {s}");
                }
                let expected = section(&fps);
                let area = expected.measures().area().map(|area| area.exact());
                assert_eq!(family.at(&s), Some(expected), "case {case} at s = {s}");
                let moving = piece.area().map(|area| {
                    area.constant().exact() + (area.slope().exact() + area.quadratic().exact() * &s) * &s
                });
                assert_eq!(
                    moving,
                    area.filter(|_| piece.kind != RegionKind::Empty),
                    "case {case} at s = {s}"
                );
            }
            for Breakpoint { s, section, entering, leaving } in family.breakpoints() {
                assert_eq!(*section, self::section(&fresh(&problem, s)), "case {case} at s = {s}");
                *(if entering.len() + leaving.len() == 1 { &mut single } else { &mut several }) += 1;
            }
        }
    }
    assert!(single > 1_000 && several > 500, "{single} change in one place, {several} in several or none");
}
