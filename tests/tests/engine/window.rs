//! Windows that move on, against fits of their readings from the beginning and against the oracle.

use std::collections::BTreeMap;

use boundfit_estimation::{Fit, Measurement, ParameterInterval, Problem, fit};
use boundfit_exact::Rational;
use boundfit_geometry::{Inequality, System};
use boundfit_questions::{Contradiction, Window};
use boundfit_tests::generate::{one_in, seeded, share};
use boundfit_tests::readings::with_rows;
use boundfit_tests::runs::{Readings, readings};
use rand::RngExt;

/// Checks that a contradiction is one, from the inequalities that it names alone.
pub(super) fn verify(contradiction: &Contradiction, problem: &Problem) {
    let rows = problem.measurements.kept();
    let readings = rows.iter().flat_map(boundfit_estimation::half_planes);
    let all: BTreeMap<_, Inequality> =
        readings.chain(boundfit_estimation::conditions_by_name(&problem.conditions)).collect();
    assert!(contradiction.terms.len() <= 3);
    let total = contradiction.terms.iter().fold(Default::default(), |total: [_; 3], (name, multiplier)| {
        assert!(*multiplier > Rational::zero());
        let Inequality { a: [a1, a2], b } = &all[name];
        let [t1, t2, t]: [Rational; 3] = total;
        [t1 + a1 * multiplier, t2 + a2 * multiplier, t + b * multiplier]
    });
    assert!(total[0].is_zero() && total[1].is_zero() && total[2].is_negative(), "{contradiction:?}");
}

/// Checks that the window answers as a fit of its readings does.
fn check(window: &Window, problem: &Problem, readings: &Readings, case: usize) {
    let rows: Vec<Measurement> = window.readings().cloned().collect();
    let own = with_rows(problem, rows.clone());
    let fresh: Fit = fit(&own);
    let found = window.fit();
    let region = fresh.fps.polyhedron().region();
    let about =
        format!("case {case}: {readings:?}, rows {:?}", rows.iter().map(|row| row.row).collect::<Vec<_>>());
    assert_eq!(found.kind, region.kind(), "{about}");
    let intervals = |pui: &Option<[ParameterInterval; 2]>| {
        pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval))
    };
    assert_eq!(intervals(&found.pui), intervals(&fresh.pui), "{about}");
    assert_eq!(found.central, fresh.central, "{about}");
    assert_eq!(window.is_feasible(), !fresh.is_empty(), "{about}");
    assert_eq!(found.contradiction.is_some(), fresh.is_empty(), "{about}");
    assert_eq!(window.contradiction().is_some(), fresh.is_empty(), "{about}");
    for contradiction in found.contradiction.iter().chain(&window.contradiction()) {
        verify(contradiction, &own);
    }
    let is_known = readings.epsilon.is_some()
        && readings.conditions.is_empty()
        && !rows.is_empty()
        && rows.iter().all(|row| row.regressor[1] == Rational::one());
    let least = fresh.minimax.as_ref().map(|minimax| minimax.least.clone());
    assert_eq!(found.least, least.filter(|_| is_known), "{about}");
    let set = window.set();
    let own_region = set.polyhedron.region();
    assert_eq!(own_region.kind(), region.kind(), "{about}");
    let points = |region: &boundfit_geometry::Region| -> Vec<_> {
        region.vertices().iter().map(|vertex| vertex.point().clone()).collect()
    };
    assert_eq!(points(own_region), points(region), "{about}");
    assert_eq!((own_region.rays(), own_region.lines()), (region.rays(), region.lines()), "{about}");
    let answer = readings.answer(rows.iter().map(|row| row.row - 1));
    assert_eq!(found.kind.name(), answer.kind, "{about}");
    // The proofs hold of the few half-planes, and these are half-planes of the readings.
    let system: &System = &found.system;
    for end in found.pui.iter().flatten().flat_map(|interval| [&interval.lower, &interval.upper]) {
        if let boundfit_estimation::ParameterBound::Bounded { proof, .. } = end {
            assert_eq!(proof.verify(system), Ok(()), "{about}");
        }
    }
    let all: Vec<_> = own
        .measurements
        .kept()
        .iter()
        .flat_map(boundfit_estimation::half_planes)
        .chain(boundfit_estimation::conditions_by_name(&own.conditions))
        .collect();
    for pair in found.names.iter().copied().zip(system.inequalities().iter().cloned()) {
        assert!(all.contains(&pair), "{about}");
    }
}

#[test]
fn every_step_is_equal_to_a_fit_from_the_beginning() {
    let mut rng = seeded(160);
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    for case in 0..share(2_500) {
        let mut readings = readings(&mut rng, 9);
        if rng.random_bool(0.4) {
            let order = readings.by_x();
            readings.rows = order.into_iter().map(|row| readings.rows[row].clone()).collect();
        }
        let problem = readings.problem();
        let mut window = Window::new(&problem.conditions);
        let mut expected: Vec<Measurement> = Vec::new();
        let mut next = 0;
        // Comes and goes as chance has it, until all have come and gone.
        while next < readings.rows.len() || !window.is_empty() {
            let is_push = next < readings.rows.len() && (window.is_empty() || rng.random_bool(0.65));
            if is_push {
                let reading = problem.measurements.kept()[next].clone();
                expected.push(reading.clone());
                window.push(reading);
                next += 1;
            } else {
                assert_eq!(window.pop(), Some(expected.remove(0)));
            }
            assert_eq!(window.len(), expected.len());
            if rng.random_bool(0.5) {
                check(&window, &problem, &readings, case);
                *kinds.entry(window.fit().kind.name()).or_default() += 1;
            }
        }
        assert_eq!(window.pop(), None);
        check(&window, &problem, &readings, case);
    }
    for (kind, least) in [
        ("empty", 500),
        ("point", 100),
        ("segment", 100),
        ("ray", 20),
        ("line", 20),
        ("polygon", 300),
        ("unbounded-polygon", 100),
        ("strip", 100),
        ("half-plane", 20),
    ] {
        assert!(
            kinds.get(kind).is_some_and(|&count| count >= least / one_in()),
            "{kind} was hit too seldom: {kinds:?}"
        );
    }
}

#[test]
fn a_reading_that_leaves_nothing_does_not_come_in() {
    let mut rng = seeded(161);
    let mut refused = 0;
    for case in 0..share(2_000) {
        let readings = readings(&mut rng, 12);
        let problem = readings.problem();
        let mut window = Window::new(&problem.conditions);
        let mut kept: Vec<Measurement> = Vec::new();
        let is_feasible = |rows: &[Measurement]| !fit(&with_rows(&problem, rows.to_vec())).is_empty();
        for reading in problem.measurements.kept() {
            if rng.random_bool(0.2) {
                assert_eq!(window.pop().is_some(), !kept.is_empty());
                kept.drain(..kept.len().min(1));
            }
            kept.push(reading.clone());
            match window.push_if_feasible(reading.clone()) {
                Ok(()) => assert!(is_feasible(&kept), "case {case}"),
                Err(contradiction) => {
                    assert!(!is_feasible(&kept), "case {case}");
                    verify(&contradiction, &with_rows(&problem, kept.clone()));
                    kept.pop();
                    refused += 1;
                }
            }
            assert!(window.readings().eq(&kept), "case {case}");
            if is_feasible(&kept) {
                check(&window, &problem, &readings, case);
            }
        }
    }
    assert!(refused > share(1_000), "{refused}");
}
