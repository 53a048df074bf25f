//! The corridor of all feasible lines, against the support function and against its own vertices.

use boundfit_estimation::{Corridor, CorridorEdge, Fps, Model, fit};
use boundfit_exact::{Endpoint, Rational};
use boundfit_geometry::{Inequality, Polyhedron, Support, System};
use boundfit_tests::generate::seeded;
use boundfit_tests::readings::problem;
use rand::RngExt;

/// max θ1·x + θ2 (`upper`) or min θ1·x + θ2 over the set; `None` when there is none.
fn extreme(polyhedron: &Polyhedron, x: &Rational, upper: bool) -> Option<Rational> {
    let form = if upper { [x.clone(), Rational::one()] } else { [-x, -Rational::one()] };
    match polyhedron.support(&form) {
        Support::Bounded { proof, .. } => Some(if upper { proof.value } else { -proof.value }),
        _ => None,
    }
}

fn check(edge: &CorridorEdge, polyhedron: &Polyhedron, upper: bool, others: &[Rational], case: usize) {
    let lines = edge.lines();
    assert_eq!(lines.is_empty(), edge.domain().is_none(), "case {case}");
    assert!(lines.is_empty() || edge.breakpoints().len() + 1 == lines.len(), "case {case}");
    assert!(lines.iter().all(|line| polyhedron.membership(line).is_inside()), "case {case}");
    for (pair, x) in lines.windows(2).zip(edge.breakpoints()) {
        let value = |line: &[Rational; 2]| &line[0] * x + &line[1];
        assert_eq!(value(&pair[0]), value(&pair[1]), "case {case}: the edge jumps");
        assert_eq!(pair[0][0] < pair[1][0], upper, "case {case}: not convex");
    }
    let ends = edge.domain().into_iter().flat_map(|domain| [domain.lower(), domain.upper()]);
    let mut samples: Vec<Rational> = ends.filter_map(Endpoint::value).cloned().collect();
    samples.extend(edge.breakpoints().iter().cloned());
    let beyond = [Rational::ratio(-1, 1000), Rational::ratio(1, 1000)];
    let beside: Vec<Rational> =
        samples.iter().flat_map(|x| beyond.iter().map(move |step| x + step)).collect();
    for x in samples.iter().chain(&beside).chain(others) {
        assert_eq!(edge.value(x), extreme(polyhedron, x, upper), "case {case} at x = {x}");
    }
}

fn check_both(polyhedron: &Polyhedron, others: &[Rational], case: usize) -> bool {
    let Some(corridor) = Corridor::new(polyhedron) else {
        assert!(polyhedron.region().is_empty());
        return false;
    };
    check(&corridor.upper, polyhedron, true, others, case);
    check(&corridor.lower, polyhedron, false, others, case);
    corridor.upper.breakpoints().len() > 1
}

#[test]
fn the_corridor_is_the_support_function_of_the_feasible_set() {
    let mut rng = seeded(51);
    let mut with_breakpoints = 0;
    for case in 0..2_000 {
        let problem = problem(&mut rng);
        if !matches!(problem.measurements.model(), Model::Line { .. }) {
            continue;
        }
        let fps = Fps::new(&problem.measurements, &problem.conditions);
        let others: Vec<Rational> =
            (0..5).map(|_| Rational::ratio(rng.random_range(-400..=400), 16)).collect();
        with_breakpoints += usize::from(check_both(fps.polyhedron(), &others, case));
    }
    assert!(with_breakpoints > 50, "only {with_breakpoints} corridors with two breakpoints");
}

#[test]
fn any_convex_set_has_a_corridor() {
    let mut rng = seeded(52);
    for case in 0..2_000 {
        let count = rng.random_range(0..7);
        let system: System = (0..count)
            .map(|_| {
                let [a1, a2, b] = [0; 3].map(|_| Rational::from(rng.random_range(-4..=4)));
                Inequality::new(a1, a2, b)
            })
            .collect();
        let others: Vec<Rational> = (-6..=6).map(Rational::from).collect();
        check_both(&Polyhedron::intersect(system), &others, case);
    }
}

#[test]
fn readings_lie_beside_the_corridor_by_at_most_their_bound() {
    let mut rng = seeded(53);
    for _ in 0..500 {
        let problem = problem(&mut rng);
        let fit = fit(&problem);
        let line = matches!(problem.measurements.model(), Model::Line { .. });
        let Some(corridor) = Corridor::new(fit.fps.polyhedron()).filter(|_| line) else { continue };
        for row in problem.measurements.kept() {
            let x = &row.regressor[0];
            let [upper, lower] = [&corridor.upper, &corridor.lower].map(|edge| edge.value(x).unwrap());
            assert!(upper <= row.upper().unwrap() && lower >= row.lower().unwrap());
        }
    }
}
