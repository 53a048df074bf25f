//! Linear programs: the exact simplex against the polygon engine, and the floating-point back ends behind their guard.

use std::time::Duration;

use boundfit_check::{AskedDirections, ProgramRows, directions};
use boundfit_exact::Rational;
use boundfit_geometry::{Polyhedron, Support};
use boundfit_lp::{
    ExactOutcome, FloatProgram, Multiplier, Outcome, Program, PuiEnd, Row, exact_simplex, solve_guarded,
    solver_named, solvers, spread_objectives,
};
use boundfit_tests::generate::{form, seeded, share};
use boundfit_tests::lp_cases::{fine, line_problem, long_problem, rows, system_of, ten_to, whole_rows};
use boundfit_tests::readings::problem;
use boundfit_tests::shape::Tally;
use rand::RngExt;

const CASES: usize = 5_000;
const MINUTE: Duration = Duration::from_secs(60);

fn negated(form: &[Rational; 2]) -> [Rational; 2] {
    form.each_ref().map(|coefficient| -coefficient)
}

/// Checks that both engines give the same status and value with valid proofs; returns the exact simplex's outcome.
fn agreed(polyhedron: &Polyhedron, rows: &[Row], objective: &[Rational; 2]) -> ExactOutcome {
    let program = Program { rows, objective: objective.clone() };
    let outcome = exact_simplex(&program);
    assert!(outcome.verify(&program), "{program:?} {outcome:?}");
    let system = polyhedron.system();
    match (&outcome, polyhedron.support(&negated(objective))) {
        (ExactOutcome::Optimal { value, basis, multipliers, .. }, Support::Bounded { proof, .. }) => {
            assert_eq!(proof.verify(system), Ok(()), "{program:?}");
            assert_eq!(-value, proof.value, "{program:?}");
            assert!(multipliers.iter().all(|multiplier| basis.contains(&multiplier.row)), "{program:?}");
        }
        (ExactOutcome::Infeasible { .. }, Support::Empty(farkas)) => {
            assert_eq!(farkas.verify(system), Ok(()), "{program:?}");
        }
        (ExactOutcome::Unbounded { .. }, Support::Unbounded(proof)) => {
            assert_eq!(proof.verify(system), Ok(()), "{program:?}");
        }
        (outcome, support) => panic!("{program:?}: {outcome:?} but {support:?}"),
    }
    outcome
}

fn status(outcome: &ExactOutcome) -> &'static str {
    match outcome {
        ExactOutcome::Optimal { multipliers, .. } => match multipliers.len() {
            0 => "optimal everywhere",
            1 => "optimal along an edge",
            _ => "optimal",
        },
        ExactOutcome::Infeasible { multipliers } => match multipliers.len() {
            1 => "infeasible by one row",
            2 => "infeasible by two rows",
            _ => "infeasible by three rows",
        },
        ExactOutcome::Unbounded { .. } => "unbounded",
    }
}

#[test]
fn the_exact_simplex_and_the_polygon_engine_agree() {
    let mut rng = seeded(41);
    let mut tally = Tally::default();
    for _ in 0..share(CASES) {
        let rows = rows(&mut rng);
        let polyhedron = Polyhedron::intersect(system_of(&rows));
        let mut objectives = PuiEnd::ALL.map(PuiEnd::objective).to_vec();
        objectives.push(form(&mut rng, polyhedron.system()));
        objectives.push([fine(&mut rng) * ten_to(-9), fine(&mut rng) * ten_to(9)]);
        for objective in objectives {
            tally.count(status(&agreed(&polyhedron, &rows, &objective)));
        }
    }
    let cases = [
        "optimal",
        "optimal along an edge",
        "optimal everywhere",
        "infeasible by one row",
        "infeasible by two rows",
        "infeasible by three rows",
        "unbounded",
    ];
    tally.assert_each(100, &cases);
}

/// Everything that may be changed about a right outcome so that it is a wrong one.
fn tampered(outcome: &ExactOutcome, rows: &[Row]) -> Vec<(&'static str, ExactOutcome)> {
    let mut wrong = Vec::new();
    let outside = |theta: &[Rational; 2]| {
        let row = rows.iter().find(|row| row.a.iter().any(|a| !a.is_zero()))?;
        let square: Rational = row.a.iter().map(|a| a * a).sum();
        let steps = (row.slack(theta) + ten_to(-30)).checked_div(&square)?;
        Some([0, 1].map(|i| &theta[i] + &row.a[i] * &steps))
    };
    // A multiplier counts unless its row is 0 ≤ 0, which adds nothing.
    let counts = |m: &Multiplier| rows[m.row].a.iter().any(|a| !a.is_zero()) || !rows[m.row].b.is_zero();
    let mut with = |multipliers: &[Multiplier],
                    most: usize,
                    rebuilt: &dyn Fn(Vec<Multiplier>) -> ExactOutcome| {
        for index in 0..multipliers.len() {
            let changed = |change: &dyn Fn(&mut Multiplier)| {
                let mut multipliers = multipliers.to_vec();
                change(&mut multipliers[index]);
                rebuilt(multipliers)
            };
            wrong.push(("beyond the rows", changed(&|m| m.row = rows.len())));
            wrong.push(("negative", changed(&|m| m.value = -&m.value)));
            wrong.push(("zero", changed(&|m| m.value = Rational::zero())));
            // More of one row of several changes the sum; all of a single one may be scaled when it is 0 ≤ negative.
            if counts(&multipliers[index]) && (multipliers.len() > 1 || most == 2) {
                wrong.push(("more", changed(&|m| m.value = &m.value + ten_to(-30))));
                let mut fewer = multipliers.to_vec();
                fewer.remove(index);
                wrong.push(("fewer", rebuilt(fewer)));
            }
            let part = Multiplier { value: multipliers[index].value.half(), ..multipliers[index].clone() };
            let mut split = multipliers.to_vec();
            while split.len() <= most {
                split[index].value = split[index].value.half();
                split.push(Multiplier { value: split[index].value.clone(), ..part.clone() });
            }
            wrong.push(("too many", rebuilt(split)));
        }
    };
    match outcome {
        ExactOutcome::Optimal { theta, value, multipliers, basis } => {
            let rebuilt = |theta: &[Rational; 2], value: &Rational, multipliers: Vec<Multiplier>| {
                let (theta, value, basis) = (theta.clone(), value.clone(), basis.clone());
                ExactOutcome::Optimal { theta, value, multipliers, basis }
            };
            with(multipliers, 2, &|multipliers| rebuilt(theta, value, multipliers));
            wrong.push(("value", rebuilt(theta, &(value + ten_to(-30)), multipliers.clone())));
            wrong.extend(outside(theta).map(|theta| ("point", rebuilt(&theta, value, multipliers.clone()))));
        }
        ExactOutcome::Infeasible { multipliers } => {
            with(multipliers, 3, &|multipliers| ExactOutcome::Infeasible { multipliers });
            wrong.push(("nothing", ExactOutcome::Infeasible { multipliers: Vec::new() }));
        }
        ExactOutcome::Unbounded { theta, ray } => {
            let (back, none) = (negated(ray), [Rational::zero(), Rational::zero()]);
            wrong.push(("ray back", ExactOutcome::Unbounded { theta: theta.clone(), ray: back }));
            wrong.push(("no ray", ExactOutcome::Unbounded { theta: theta.clone(), ray: none }));
            wrong.extend(
                outside(theta).map(|theta| ("start", ExactOutcome::Unbounded { theta, ray: ray.clone() })),
            );
        }
    }
    wrong
}

#[test]
fn a_tampered_outcome_does_not_verify() {
    let mut rng = seeded(42);
    let mut tally = Tally::default();
    for _ in 0..CASES / 5 {
        let rows = rows(&mut rng);
        for objective in PuiEnd::ALL.map(PuiEnd::objective) {
            let program = Program { rows: &rows, objective };
            let outcome = exact_simplex(&program);
            for (what, wrong) in tampered(&outcome, &rows) {
                assert!(!wrong.verify(&program), "{what}: {program:?} {wrong:?}");
                tally.count(what);
            }
            // A right outcome of another program.
            let other = Program { objective: negated(&program.objective), ..program.clone() };
            if !matches!(outcome, ExactOutcome::Infeasible { .. }) {
                assert!(!outcome.verify(&other), "{program:?} {outcome:?}");
            }
            if let ExactOutcome::Optimal { theta, .. } | ExactOutcome::Unbounded { theta, .. } = &outcome {
                let cut = Row { a: [Rational::one(), Rational::zero()], b: &theta[0] - ten_to(-30) };
                let cut = [rows.as_slice(), &[cut]].concat();
                assert!(!outcome.verify(&Program { rows: &cut, ..program.clone() }));
            }
            if let ExactOutcome::Infeasible { .. } = &outcome {
                assert!(!outcome.verify(&Program { rows: &rows[..0], ..program.clone() }));
            }
        }
    }
    let cases = [
        "beyond the rows",
        "negative",
        "zero",
        "more",
        "fewer",
        "too many",
        "value",
        "point",
        "nothing",
        "ray back",
        "no ray",
        "start",
    ];
    tally.assert_each(100, &cases);
}

/// The statuses and values of the four programs: `None` is unbounded.
fn four_values(rows: &[Row]) -> [Option<Rational>; 4] {
    let polyhedron = Polyhedron::intersect(system_of(rows));
    PuiEnd::ALL.map(PuiEnd::objective).map(|objective| match agreed(&polyhedron, rows, &objective) {
        ExactOutcome::Optimal { value, .. } => Some(value),
        ExactOutcome::Unbounded { .. } => None,
        outcome => panic!("{rows:?} {outcome:?}"),
    })
}

#[test]
fn the_variables_are_free() {
    // A box in the third quadrant: no solver may keep θ ≥ 0.
    let rows = whole_rows(&[[1, 0, -3], [-1, 0, 4], [0, 1, -5], [0, -1, 7]]);
    let expected = [-4, 3, -7, 5];
    assert_eq!(four_values(&rows), expected.map(|value| Some(Rational::from(value))));
    for solver in solvers() {
        for (objective, value) in PuiEnd::ALL.map(PuiEnd::objective).into_iter().zip(expected) {
            let program = FloatProgram::new(&Program { rows: &rows, objective });
            let Outcome::Optimal(optimum) = solve_guarded(solver.name(), &program, MINUTE) else {
                panic!("{} finds no corner of a box", solver.name());
            };
            assert_eq!(optimum.objective.round(), f64::from(value), "{}", solver.name());
        }
    }
}

#[test]
fn small_and_degenerate_programs() {
    let half = Rational::ratio(1, 2);
    let reading = |x: i64, y: i64| (Rational::from(x), Rational::from(y));
    // All x equal: a strip, in which neither parameter is bounded; unless x = 0, which bounds θ2.
    let equal =
        ProgramRows::new(&line_problem(&[reading(2, 1), reading(2, 1), reading(2, 2)], &half)).plain();
    assert_eq!(four_values(&equal), [None, None, None, None]);
    let zero = ProgramRows::new(&line_problem(&[reading(0, 1), reading(0, 2)], &half)).plain();
    let three_halves = Rational::ratio(3, 2);
    assert_eq!(four_values(&zero), [None, None, Some(three_halves.clone()), Some(-three_halves)]);
    // One reading, no reading, and rows that say nothing.
    let one = ProgramRows::new(&line_problem(&[reading(3, 1)], &half)).plain();
    assert_eq!(four_values(&one), [None, None, None, None]);
    assert_eq!(four_values(&[]), [None, None, None, None]);
    assert_eq!(four_values(&whole_rows(&[[0, 0, 0], [0, 0, 5]])), [None, None, None, None]);
    let boxed = whole_rows(&[[0, 0, 0], [1, 0, 1], [-1, 0, 0], [0, 0, 7], [0, 1, 1], [0, -1, 0], [0, 0, 0]]);
    let unit = [0, -1, 0, -1].map(|value| Some(Rational::from(value)));
    assert_eq!(four_values(&boxed), unit);
    // A zero normal with a negative right-hand side leaves nothing, whatever else there is.
    let never = [boxed.as_slice(), &whole_rows(&[[0, 0, -1]])].concat();
    for rows in [&never[..], &never[7..]] {
        let polyhedron = Polyhedron::intersect(system_of(rows));
        for objective in PuiEnd::ALL.map(PuiEnd::objective) {
            assert_eq!(status(&agreed(&polyhedron, rows, &objective)), "infeasible by one row");
        }
    }
    // A zero objective is optimal at any feasible point.
    let nothing = [Rational::zero(), Rational::zero()];
    let polyhedron = Polyhedron::intersect(system_of(&boxed));
    assert_eq!(status(&agreed(&polyhedron, &boxed, &nothing)), "optimal everywhere");
    // Every back end survives them all.
    for rows in [&equal[..], &zero, &one, &[], &boxed, &never] {
        for solver in solvers() {
            for objective in PuiEnd::ALL.map(PuiEnd::objective) {
                let program = FloatProgram::new(&Program { rows, objective });
                let outcome = solve_guarded(solver.name(), &program, MINUTE);
                // A solver may have no word for a program without rows.
                let failed = matches!(outcome, Outcome::Failed(_)) && !rows.is_empty();
                assert!(!failed, "{} {rows:?} {outcome:?}", solver.name());
            }
        }
    }
}

#[test]
fn every_back_end_gives_an_answer_on_many_rows() {
    let rows = ProgramRows::new(&long_problem(share(100_000))).plain();
    assert_eq!(rows.len(), 2 * share(100_000));
    let polyhedron = Polyhedron::intersect(system_of(&rows));
    for objective in PuiEnd::ALL.map(PuiEnd::objective) {
        assert!(matches!(agreed(&polyhedron, &rows, &objective), ExactOutcome::Optimal { .. }));
        let program = FloatProgram::new(&Program { rows: &rows, objective });
        for solver in solvers() {
            let outcome = solve_guarded(solver.name(), &program, MINUTE);
            assert!(matches!(outcome, Outcome::Optimal(_)), "{} {outcome:?}", solver.name());
        }
    }
}

#[test]
fn the_guard_catches_what_solvers_cannot_do() {
    let rows = whole_rows(&[[1, 0, 1], [-1, 0, 0], [0, 1, 1], [0, -1, 0]]);
    let objective = [Rational::one(), Rational::zero()];
    let program = FloatProgram::new(&Program { rows: &rows, objective: objective.clone() });
    assert!(solver_named("simplex of my own").is_none());
    let unknown = solve_guarded("simplex of my own", &program, MINUTE);
    assert_eq!(unknown, Outcome::Failed("there is no solver simplex of my own".to_owned()));
    for solver in solvers() {
        assert_eq!(solver_named(solver.name()).unwrap().version(), solver.version());
        for [a1, a2, b] in [[f64::NAN, 0.0, 1.0], [1.0, f64::INFINITY, 1.0], [1.0, 0.0, f64::NEG_INFINITY]] {
            let mut broken = program.clone();
            broken.rows.push([a1, a2, b]);
            assert!(!broken.is_finite() && broken.exact_rows().is_none());
            let refused = solve_guarded(solver.name(), &broken, MINUTE);
            assert_eq!(refused, Outcome::Failed("the program does not fit into binary64".to_owned()));
        }
        // Beyond the largest binary64: rounding gives an infinity.
        let huge = [Row { a: [ten_to(400), Rational::one()], b: Rational::one() }];
        let huge = FloatProgram::new(&Program { rows: &huge, objective: objective.clone() });
        assert!(matches!(solve_guarded(solver.name(), &huge, MINUTE), Outcome::Failed(_)));
        // Far too little time for so many rows.
        let many: Vec<[f64; 3]> =
            (0..20_000).map(f64::from).flat_map(|x| [[x, 1.0, x], [-x, -1.0, 1.0 - x]]).collect();
        let many = FloatProgram { rows: many, objective: [-1.0, 0.0] };
        let late = solve_guarded(solver.name(), &many, Duration::from_millis(1));
        assert_eq!(late, Outcome::Failed("no answer within 1ms".to_owned()), "{}", solver.name());
    }
}

#[test]
fn float_programs_are_the_nearest_doubles() {
    let mut rng = seeded(43);
    for _ in 0..500 {
        let rows = rows(&mut rng);
        let objective = [fine(&mut rng), fine(&mut rng)];
        let program = Program { rows: &rows, objective };
        let float = FloatProgram::new(&program);
        let exact = float.exact_rows().unwrap();
        let again = FloatProgram::new(&Program { rows: &exact, objective: program.objective.clone() });
        assert_eq!(again, float);
        for (row, [a1, a2, b]) in rows.iter().zip(&float.rows) {
            assert_eq!([row.a[0].to_f64(), row.a[1].to_f64(), row.b.to_f64()], [*a1, *a2, *b]);
        }
    }
}

#[test]
fn objectives_are_spread_evenly() {
    let objectives = spread_objectives(16);
    assert_eq!(objectives.len(), 16);
    let axis = |one: i64, two: i64| [Rational::from(one), Rational::from(two)];
    for (index, expected) in [(0, axis(0, 1)), (4, axis(1, 0)), (8, axis(0, -1)), (12, axis(-1, 0))] {
        assert_eq!(objectives[index], expected);
    }
    let length = |[a, b]: &[Rational; 2]| (a * a + b * b).to_f64();
    for (index, objective) in objectives.iter().enumerate() {
        assert!((length(objective) * 1e15).round() == 1e15, "{objective:?}");
        // Each is clockwise of the one before, by less than half a turn.
        let next = &objectives[(index + 1) % 16];
        assert!((&objective[0] * &next[1] - &objective[1] * &next[0]).is_negative());
        let opposite = &objectives[(index + 8) % 16];
        assert!((&objective[0] * &opposite[0] + &objective[1] * &opposite[1]).is_negative());
    }
}

#[test]
fn the_set_lies_between_its_approximations() {
    let mut rng = seeded(44);
    let mut tally = Tally::default();
    for case in 0..3_000 {
        let problem = problem(&mut rng);
        let rows = ProgramRows::new(&problem);
        let polyhedron = Polyhedron::intersect(system_of(&rows.plain()));
        let count = [3, 4, 7, 16][rng.random_range(0..4)];
        let asked = AskedDirections { count, is_scaled: case % 2 == 0 };
        let found = directions(&problem, &rows, asked);
        assert_eq!(found.count, count);
        assert_eq!(found.exact.area, polyhedron.region().area());
        if polyhedron.region().is_empty() {
            assert!(found.inner.is_none() && found.outer.is_none(), "case {case}");
            tally.count("empty");
            continue;
        }
        let (inner, outer) = (found.inner.unwrap(), found.outer.unwrap());
        let outer_area = outer.area.clone();
        for vertex in &inner.vertices {
            assert!(polyhedron.membership(vertex).is_inside(), "case {case}");
        }
        if !polyhedron.region().is_bounded() {
            assert!(found.unbounded > 0 && outer_area.is_none_or(|area| area.is_zero()), "case {case}");
            tally.count("unbounded");
            continue;
        }
        assert_eq!(found.unbounded, 0);
        let exact = found.exact.area.unwrap();
        assert!(inner.area.unwrap() <= exact, "case {case}");
        assert!(outer_area.is_none_or(|area| exact <= area), "case {case}");
        for vertex in &inner.vertices {
            assert!(found.exact.vertices.contains(vertex), "case {case}");
        }
        tally.count(if exact.is_zero() { "flat" } else { "bounded" });
    }
    tally.assert_each(500, &["empty", "bounded"]);
    tally.assert_each(50, &["unbounded", "flat"]);
}
