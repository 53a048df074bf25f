//! The properties that every fit must have, on generated readings.

use std::collections::BTreeMap;

use boundfit_estimation::{ErrorBound, Fit, Measurement, Minimax, Model, fit};
use boundfit_exact::{Interval, Rational};
use boundfit_geometry::RegionKind;
use boundfit_tests::definitions::{contains, least_bound};
use boundfit_tests::generate::{one_in, seeded, share};
use boundfit_tests::readings::{problem, rebuilt, with_error_bound, with_rows, y_and_epsilon};
use rand::RngExt;
use rand::seq::SliceRandom;

const CASES: usize = 2_500;

fn ends(interval: &Interval) -> [Option<Rational>; 2] {
    [interval.lower().value().cloned(), interval.upper().value().cloned()]
}

/// The set and what is read off it, without the names of rows: kind, vertices, PUI, least error bound.
type Outcome = (RegionKind, Vec<[Rational; 2]>, Option<[[Option<Rational>; 2]; 2]>, Option<Rational>);

fn outcome(fit: &Fit) -> Outcome {
    let region = fit.fps.polyhedron().region();
    (
        region.kind(),
        region.vertices().iter().map(|vertex| vertex.point().coordinates()).collect(),
        fit.pui_intervals().map(|pui| pui.each_ref().map(ends)),
        fit.minimax.as_ref().map(|minimax| minimax.least.clone()),
    )
}

#[test]
fn every_proof_verifies_and_the_known_facts_hold() {
    let mut rng = seeded(1);
    let mut kinds: BTreeMap<RegionKind, usize> = BTreeMap::new();
    for case in 0..share(CASES) {
        let mut problem = problem(&mut rng);
        // At its least error bound a set has no interior: the hardest cases.
        if case % 3 == 0
            && let Some(minimax) = Minimax::new(&problem.measurements, &problem.conditions)
        {
            problem = with_error_bound(&problem, &minimax.least);
        }
        let fit = fit(&problem);
        let polyhedron = fit.fps.polyhedron();
        let region = polyhedron.region();
        *kinds.entry(region.kind()).or_default() += 1;
        assert_eq!(fit.verify(&problem), Ok(()), "case {case}");
        assert_eq!(region.check_invariants(polyhedron.system()), Ok(()), "case {case}");
        if let (Some(pui), Ok(least_squares)) = (fit.pui_intervals(), &fit.least_squares) {
            for (pui, eui) in pui.iter().zip(least_squares.eui.as_ref().unwrap()) {
                assert!(contains(eui, pui), "PUI not within EUI in case {case}");
            }
        }
        if let Some(central) = &fit.central {
            assert!(
                polyhedron.membership(&central.theta).is_inside(),
                "central estimate outside in case {case}"
            );
        }
        assert_eq!(fit.central.is_some(), region.is_bounded() && !region.is_empty());
        if let Some(tightness) = fit.tightness() {
            assert!(!tightness.is_negative() && tightness <= Rational::one());
        }
        if let Some(terms) = fit.contradiction(problem.measurements.error_bound()) {
            assert!(terms.len() <= 3 && !terms.is_empty());
        }
    }
    for kind in
        [RegionKind::Empty, RegionKind::Point, RegionKind::Segment, RegionKind::Polygon, RegionKind::Strip]
    {
        assert!(
            kinds.get(&kind).is_some_and(|count| *count >= 20 / one_in()),
            "{kind:?} was hit too seldom: {kinds:?}"
        );
    }
}

#[test]
fn the_least_error_bound_leaves_something_and_no_smaller_one_does() {
    let mut rng = seeded(2);
    let (mut by_hulls, mut positive, mut never) = (0, 0, 0);
    for case in 0..share(CASES) {
        let problem = problem(&mut rng);
        let (measurements, conditions) = (&problem.measurements, &problem.conditions);
        let chosen = Minimax::new(measurements, conditions);
        let least = |minimax: &Option<Minimax>| {
            minimax.as_ref().map(|m| (m.least.clone(), m.theta.clone(), m.unique))
        };
        if conditions.is_empty() && matches!(measurements.model(), Model::Line { .. }) {
            by_hulls += 1;
        }
        assert_eq!(least(&chosen), least_bound(&problem), "case {case}");
        let Some(minimax) = chosen else {
            never += 1;
            let generous = Rational::from(1_000_000);
            assert!(fit(&with_error_bound(&problem, &generous)).pui.is_none(), "case {case}");
            continue;
        };
        let at_least = fit(&with_error_bound(&problem, &minimax.least));
        assert!(at_least.fps.polyhedron().membership(&minimax.theta).is_inside(), "case {case}");
        assert!(minimax.proof.verify(measurements, conditions, &minimax.least), "case {case}");
        if minimax.least.is_positive() {
            positive += 1;
            let below = &minimax.least * Rational::ratio(999_999_999, 1_000_000_000);
            assert!(fit(&with_error_bound(&problem, &below)).pui.is_none(), "case {case}");
            let wrong = &minimax.least + Rational::ratio(1, 1_000_000_000);
            assert!(!minimax.proof.verify(measurements, conditions, &wrong), "case {case}");
        }
    }
    assert!(
        by_hulls > share(500) && positive > share(500) && never > 20 / one_in(),
        "{by_hulls} {positive} {never}"
    );
}

#[test]
fn the_order_of_rows_and_repeated_rows_change_no_set() {
    let mut rng = seeded(3);
    for case in 0..share(CASES) {
        let problem = problem(&mut rng);
        let expected = fit(&problem);
        let mut rows = problem.measurements.kept().to_vec();
        rows.shuffle(&mut rng);
        let shuffled = fit(&with_rows(&problem, rows.clone()));
        assert_eq!(outcome(&shuffled), outcome(&expected), "case {case}");
        assert_eq!(shuffled.least_squares, expected.least_squares, "case {case}");
        assert_eq!(shuffled.central, expected.central, "case {case}");
        // Row names go with the rows, so even the active sets agree.
        let active = |fit: &Fit| -> Vec<Vec<boundfit_estimation::BoundName>> {
            let names =
                |vertex: &boundfit_geometry::Vertex| fit.fps.active(vertex.active(), usize::MAX).names;
            fit.fps.polyhedron().region().vertices().iter().map(names).collect()
        };
        assert_eq!(active(&shuffled), active(&expected), "case {case}");

        let repeated = rows[rng.random_range(0..rows.len())].clone();
        rows.push(Measurement { row: rows.len() + 1, ..repeated });
        assert_eq!(outcome(&fit(&with_rows(&problem, rows))), outcome(&expected), "case {case}");
    }
}

#[test]
fn units_can_be_changed() {
    let mut rng = seeded(4);
    for case in 0..share(CASES) {
        let mut problem = problem(&mut rng);
        problem.conditions.clear();
        let expected = fit(&problem);
        // y in units 1/c and φ1 in units 1/k: θ1 scales by c/k, θ2 and ε by c.
        let c = Rational::ratio(rng.random_range(1..=1000), 7);
        let k = Rational::ratio(rng.random_range(1..=1000), 11);
        let ratio = c.checked_div(&k).unwrap();
        let rows = problem.measurements.kept().iter().map(|row| {
            let (y, epsilon) = y_and_epsilon(row);
            let regressor = [&row.regressor[0] * &k, row.regressor[1].clone()];
            Measurement::around(row.row, regressor, y * &c, epsilon * &c)
        });
        let rows = rows.collect();
        let error_bound = match problem.measurements.error_bound() {
            ErrorBound::Uniform(epsilon) => ErrorBound::Uniform(epsilon * &c),
            per_row => per_row.clone(),
        };
        let scaled = rebuilt(&problem, rows, error_bound);
        let scaled = fit(&scaled);
        let factors = [&ratio, &c];
        let converted = |theta: &[Rational; 2]| [&theta[0] * factors[0], &theta[1] * factors[1]];
        let (kind, vertices, _, _) = outcome(&expected);
        let (scaled_kind, scaled_vertices, _, _) = outcome(&scaled);
        assert_eq!(scaled_kind, kind, "case {case}");
        assert_eq!(scaled_vertices, vertices.iter().map(converted).collect::<Vec<_>>(), "case {case}");
        let theta = |fit: &Fit| fit.least_squares.as_ref().ok().map(|estimate| estimate.theta.clone());
        assert_eq!(theta(&scaled), theta(&expected).as_ref().map(converted), "case {case}");
        let area = |fit: &Fit| fit.fps.polyhedron().region().area();
        assert_eq!(area(&scaled), area(&expected).map(|area| area * &ratio * &c), "case {case}");
        assert_eq!(scaled.tightness(), expected.tightness(), "case {case}");
        let least = scaled.minimax.as_ref().map(|minimax| minimax.least.clone());
        let uniform = matches!(problem.measurements.error_bound(), ErrorBound::Uniform(_));
        let factor = if uniform { c.clone() } else { Rational::one() };
        assert_eq!(least, expected.minimax.as_ref().map(|minimax| &minimax.least * &factor), "case {case}");
    }
}

#[test]
fn the_inverse_line_covers_every_feasible_line() {
    let mut rng = seeded(5);
    let mut with_both_signs = 0;
    for case in 0..share(CASES) {
        let problem = problem(&mut rng);
        let fit = fit(&problem);
        let Some(inverse) = fit.inverse(problem.measurements.model()) else { continue };
        let covers = |ranges: &[Interval], value: &Rational| ranges.iter().any(|range| range.contains(value));
        with_both_signs += usize::from(inverse.gain.exact_range.len() == 2);
        let region = fit.fps.polyhedron().region();
        let mut feasible: Vec<[Rational; 2]> =
            region.vertices().iter().map(|v| v.point().coordinates()).collect();
        feasible.extend(region.witness().map(|point| point.coordinates()));
        for theta in feasible {
            let (Some(gain), Some(offset)) = (theta[0].recip(), (-&theta[1]).checked_div(&theta[0])) else {
                continue;
            };
            assert!(covers(&inverse.gain.exact_range, &gain), "case {case}");
            assert!(covers(&inverse.offset.exact_range, &offset), "case {case}");
            assert!(covers(&inverse.offset.box_range, &offset), "case {case}");
        }
        // The gain depends on θ1 alone, so the box loses nothing.
        assert_eq!(inverse.gain.exact_range, inverse.gain.box_range, "case {case}");
    }
    assert!(with_both_signs > share(100), "{with_both_signs}");
}

#[test]
fn binary64_readings_are_the_nearest_doubles_taken_exactly() {
    use boundfit_exact::{Limits, Reading};
    let mut rng = seeded(6);
    for case in 0..share(CASES) {
        let problem = problem(&mut rng);
        let tenth = Rational::ratio(1, 10);
        let decimal = |value: &Rational| (value * &tenth).to_string();
        let read = |text: &str| Reading::Binary64.read(text, &Limits::default()).unwrap();
        let rounded = |value: &Rational| Rational::from_f64((value * &tenth).to_f64()).unwrap();
        let rows = problem.measurements.kept();
        let as_text = rows.iter().map(|row| {
            let (y, epsilon) = y_and_epsilon(row);
            let regressor = row.regressor.each_ref().map(|value| read(&decimal(value)));
            Measurement::around(row.row, regressor, read(&decimal(y)), epsilon.clone())
        });
        let as_doubles = rows.iter().map(|row| {
            let (y, epsilon) = y_and_epsilon(row);
            let regressor = row.regressor.each_ref().map(rounded);
            Measurement::around(row.row, regressor, rounded(y), epsilon.clone())
        });
        let (text, doubles) =
            (with_rows(&problem, as_text.collect()), with_rows(&problem, as_doubles.collect()));
        assert_eq!(text, doubles, "case {case}");
        let fit = fit(&text);
        assert_eq!(fit.verify(&text), Ok(()), "case {case}");
        if let Some(central) = &fit.central {
            assert!(fit.fps.polyhedron().membership(&central.theta).is_inside(), "case {case}");
        }
    }
}

#[test]
fn guaranteed_errors_are_attained() {
    let mut rng = seeded(7);
    for case in 0..share(CASES) {
        let problem = problem(&mut rng);
        let fit = fit(&problem);
        let largest = |estimate: &[Rational; 2], axis: usize| {
            let vertices = fit.fps.polyhedron().region().vertices().iter();
            let error =
                |v: &boundfit_geometry::Vertex| (&v.point().coordinates()[axis] - &estimate[axis]).abs();
            vertices.map(error).max()
        };
        let Some(central) = &fit.central else { continue };
        for axis in [0, 1] {
            assert_eq!(
                largest(&central.theta, axis).as_ref(),
                Some(&central.guaranteed_error[axis]),
                "case {case}"
            );
        }
        if let (Ok(estimate), Some(error)) = (&fit.least_squares, fit.least_squares_guaranteed_error()) {
            for axis in [0, 1] {
                assert_eq!(largest(&estimate.theta, axis).as_ref(), Some(&error[axis]), "case {case}");
                assert!(error[axis] >= central.guaranteed_error[axis], "case {case}");
            }
        }
    }
}
