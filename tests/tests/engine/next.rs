//! The places where the next reading helps, against the definition: the set cut by every slab that matters, at every
//! x that does.

use std::collections::BTreeSet;

use boundfit_exact::{Interval, Rational};
use boundfit_geometry::{Inequality, Polyhedron, RegionKind};
use boundfit_questions::{Goal, Next};
use boundfit_tests::generate::{half_planes, rational, seeded, system};
use boundfit_tests::oracle::Row;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

const CASES: usize = 3_000;

/// A set, with more inequalities.
fn with(rows: &[Row], more: impl IntoIterator<Item = Inequality>) -> Polyhedron {
    Polyhedron::intersect(system(rows).inequalities().iter().cloned().chain(more).collect())
}

/// Returns the statement of a reading y at x.
fn slab(x: &Rational, y: &Rational, epsilon: &Rational) -> [Inequality; 2] {
    let one = Rational::one();
    [Inequality::new(x.clone(), one.clone(), y + epsilon), Inequality::new(-x, -one, epsilon - y)]
}

fn goal_of(set: &Polyhedron, goal: Goal) -> Option<Rational> {
    match goal {
        Goal::Theta1 => set.width(&[Rational::one(), Rational::zero()]),
        Goal::Theta2 => set.width(&[Rational::zero(), Rational::one()]),
        Goal::Area => set.region().area(),
    }
}

/// Returns the largest value that a goal of a bounded set has after a reading at x. Between two y where a corner
/// comes in or leaves, a length is linear and an area quadratic in y.
fn worst_by_definition(
    rows: &[Row],
    set: &Polyhedron,
    goal: Goal,
    x: &Rational,
    epsilon: &Rational,
) -> Rational {
    let corners = set.region().vertices().iter().map(|vertex| vertex.point().coordinates());
    let values = corners.map(|[theta1, theta2]| theta1 * x + theta2);
    let ends: BTreeSet<Rational> = values.flat_map(|value| [&value - epsilon, value + epsilon]).collect();
    let after = |y: &Rational| {
        let left = with(rows, slab(x, y, epsilon));
        if left.region().is_empty() { Rational::zero() } else { goal_of(&left, goal).expect("a bounded set") }
    };
    let ends: Vec<Rational> = ends.into_iter().collect();
    let mut worst = ends.iter().map(&after).max().expect("a corner");
    for pair in ends.windows(2) {
        let middle = (&pair[0] + &pair[1]).half();
        let [low, between, high] = [&pair[0], &middle, &pair[1]].map(&after);
        // The parabola through all three, with u from -1 to 1: between + slope·u + bend·u².
        let slope = (&high - &low).half();
        let bend = (&high + &low).half() - &between;
        if bend.is_negative() {
            let place = (-slope).half().checked_div(&bend).expect("not 0");
            if place.abs() < Rational::one() {
                worst = worst.max(after(&(middle + place * (&pair[1] - &pair[0]).half())));
            }
        }
        worst = worst.max(between);
    }
    worst
}

/// Small x and ε, which meet corners and normals of the sets.
fn places(rng: &mut ChaCha8Rng, unsure: Option<&Interval>) -> Vec<Rational> {
    let mut places = vec![Rational::zero(), rational(rng), rational(rng)];
    for end in unsure.iter().flat_map(|unsure| [unsure.lower(), unsure.upper()]).filter_map(|end| end.value())
    {
        let step = Rational::ratio(1, 1_000_003);
        places.extend([end - &step, end.clone(), end + &step]);
    }
    places
}

fn bound(rng: &mut ChaCha8Rng) -> Rational {
    Rational::ratio(rng.random_range(0..=6), [2, 2, 5, 40][rng.random_range(0..4)])
}

#[test]
fn a_reading_is_certain_where_no_slab_has_room_for_the_set() {
    let mut rng = seeded(71);
    let mut kinds = BTreeSet::new();
    for case in 0..CASES {
        let rows = half_planes(&mut rng);
        let set = with(&rows, []);
        kinds.insert(set.region().kind().name());
        let epsilon = bound(&mut rng);
        let Some(next) = Next::new(&set, epsilon.clone()) else {
            assert!(set.region().is_empty(), "{case}: {rows:?}");
            continue;
        };
        let unsure = next.unsure();
        for x in places(&mut rng, unsure.as_ref()) {
            let width = set.width(&[x.clone(), Rational::one()]);
            assert_eq!(next.width(&x), width, "{case}: {rows:?} at {x}");
            let is_unsure = width.is_some_and(|width| width <= &epsilon + &epsilon);
            let said = unsure.as_ref().is_some_and(|unsure| unsure.contains(&x));
            assert_eq!(said, is_unsure, "{case}: {rows:?} at {x} with {epsilon}");
            // The reading in the middle of the lines changes nothing exactly there.
            let Some(range) = set.range(&[x.clone(), Rational::one()]) else { continue };
            let Some(middle) = range.midpoint() else { continue };
            let after = with(&rows, slab(&x, &middle, &epsilon));
            let corners = |set: &Polyhedron| -> Vec<[Rational; 2]> {
                set.region().vertices().iter().map(|vertex| vertex.point().coordinates()).collect()
            };
            let form = [x.clone(), Rational::one()];
            let is_same = corners(&after) == corners(&set) && after.width(&form) == set.width(&form);
            assert_eq!(is_same, is_unsure, "{case}: {rows:?} at {x} with {epsilon}");
        }
    }
    assert_eq!(kinds.len(), 10, "{kinds:?}");
}

#[test]
fn the_worst_outcome_is_that_of_every_slab_that_matters() {
    let mut rng = seeded(72);
    let mut helped = 0;
    let mut case = 0;
    while case < CASES / 3 {
        let rows = half_planes(&mut rng);
        let set = with(&rows, []);
        if set.region().is_empty() || !set.region().is_bounded() {
            continue;
        }
        // Half of the sets have an area, which is rare.
        if case % 2 == 0 && set.region().kind() != RegionKind::Polygon {
            continue;
        }
        case += 1;
        let epsilon = bound(&mut rng);
        let next = Next::new(&set, epsilon.clone()).expect("a point");
        let x = if rng.random_bool(0.2) { Rational::zero() } else { rational(&mut rng) };
        for goal in Goal::ALL {
            let worst = next.worst(goal, &x);
            assert_eq!(next.now(goal), goal_of(&set, goal));
            helped += usize::from(worst < next.now(goal));
            let expected = worst_by_definition(&rows, &set, goal, &x, &epsilon);
            assert_eq!(worst, Some(expected), "{case}: {rows:?} {goal:?} at {x} with {epsilon}");
        }
    }
    assert!(helped > CASES / 3, "{helped}");
}

#[test]
fn an_unbounded_set_is_like_a_very_large_one() {
    let mut rng = seeded(73);
    let mut finite = 0;
    for case in 0..CASES {
        let rows = half_planes(&mut rng);
        let set = with(&rows, []);
        if set.region().is_bounded() {
            continue;
        }
        let epsilon = bound(&mut rng);
        let next = Next::new(&set, epsilon.clone()).expect("a point");
        let far = 1_000_000_000;
        let sides = [(1, 0), (-1, 0), (0, 1), (0, -1)];
        let large =
            with(&rows, sides.map(|(a1, a2): (i64, i64)| Inequality::new(a1.into(), a2.into(), far.into())));
        let of_large = Next::new(&large, epsilon.clone()).expect("a point");
        let unsure = next.unsure();
        for x in places(&mut rng, unsure.as_ref()) {
            for goal in Goal::ALL {
                let (worst, as_large) = (next.worst(goal, &x), of_large.worst(goal, &x).expect("bounded"));
                finite += usize::from(worst.is_some());
                match worst {
                    Some(worst) => {
                        assert_eq!(worst, as_large, "{case}: {rows:?} {goal:?} at {x} with {epsilon}")
                    }
                    None => assert!(
                        as_large > Rational::from(1_000),
                        "{case}: {rows:?} {goal:?} at {x}: {as_large}"
                    ),
                }
            }
        }
    }
    assert!(finite > CASES / 3, "{finite}");
}

#[test]
fn no_x_of_the_range_is_better_than_the_best() {
    const STEPS: i64 = 24;
    let mut rng = seeded(74);
    let mut inside = 0;
    for case in 0..CASES / 2 {
        let rows = half_planes(&mut rng);
        let set = with(&rows, []);
        let Some(next) = Next::new(&set, bound(&mut rng)) else { continue };
        let mut ends = [rational(&mut rng), rational(&mut rng)];
        ends.sort();
        let [lower, upper] = &ends;
        let width = upper - lower;
        for goal in Goal::ALL {
            let best = next.best(goal, [lower, upper]);
            let is_more = |one: &Option<Rational>, other: &Option<Rational>| match (one, other) {
                (None, _) => true,
                (Some(_), None) => false,
                (Some(one), Some(other)) => one >= other,
            };
            for step in 0..=STEPS {
                let x = lower + &width * Rational::ratio(step, STEPS);
                let worst = next.worst(goal, &x);
                assert!(
                    is_more(&worst, &best.worst),
                    "{case}: {rows:?} {goal:?} at {x}: {worst:?} and {best:?}"
                );
                // Where none helps, no other one does.
                if best.at.is_empty() {
                    assert_eq!(worst, best.now, "{case}: {rows:?} {goal:?} at {x}");
                }
            }
            for x in &best.at {
                assert!(lower <= x && x <= upper);
                assert_eq!(next.worst(goal, x), best.worst);
                inside += usize::from(lower < x && x < upper);
            }
        }
    }
    assert!(inside > 50, "{inside}");
}

#[test]
fn one_divided_by_the_worst_area_is_convex() {
    let mut rng = seeded(75);
    let mut case = 0;
    while case < CASES / 4 {
        let rows = half_planes(&mut rng);
        let set = with(&rows, []);
        if set.region().kind() != RegionKind::Polygon {
            continue;
        }
        let epsilon = Rational::ratio(rng.random_range(1..=9), [2, 10, 60][rng.random_range(0..3)]);
        let next = Next::new(&set, epsilon).expect("a point");
        case += 1;
        let [one, other] = [rational(&mut rng), rational(&mut rng)];
        let share = Rational::ratio(rng.random_range(1..=9), 10);
        let between = &one + &share * (&other - &one);
        let [one, between, other] = [one, between, other]
            .map(|x| next.worst(Goal::Area, &x).and_then(|area| area.recip()).expect("an area"));
        assert!(between <= &one + share * (other - &one), "{case}: {rows:?}");
    }
}
