//! The sets FPS(s·ε) for all factors s, against a fresh fit at each.

use std::collections::BTreeMap;

use boundfit_estimation::{
    Bounds, ErrorBound, Family, Fps, Measurement, Measurements, Model, Piece, Problem, Section, fit,
};
use boundfit_exact::{Endpoint, Rational};
use boundfit_geometry::RegionKind;
use boundfit_tests::definitions::section;
use boundfit_tests::generate::seeded;
use boundfit_tests::readings::{in_intervals, noisy_line, problem, rebuilt, with_rows, y_and_epsilon};
use rand::RngExt;

/// The set with every error bound multiplied, computed afresh.
fn fresh(problem: &Problem, s: &Rational) -> Section {
    let scaled = |row: &Measurement| row.clone().within(y_and_epsilon(row).1 * s);
    let rows = problem.measurements.kept().iter().map(scaled).collect();
    let error_bound = match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) => ErrorBound::Uniform(epsilon * s),
        per_row => per_row.clone(),
    };
    let problem = rebuilt(problem, rows, error_bound);
    section(&Fps::of_every_half_plane(&problem.measurements, &problem.conditions))
}

/// The set of readings that are intervals, each of them about its middle a factor as wide.
fn fresh_intervals(problem: &Problem, s: &Rational) -> Section {
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
    section(&Fps::of_every_half_plane(&problem.measurements, &problem.conditions))
}

/// Returns the content of a piece without its ends: two neighbours that agree in this should have been one.
fn shape(piece: &Piece) -> Piece {
    Piece { from: Rational::zero(), to: Rational::zero(), ..piece.clone() }
}

fn check_structure(family: &Family, case: usize) {
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
