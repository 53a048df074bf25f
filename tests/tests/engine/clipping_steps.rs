//! Clipping reports truly what each step does.

use std::collections::HashSet;

use boundfit_exact::Rational;
use boundfit_geometry::clipping::{Step, StepRedundancy, steps};
use boundfit_geometry::{
    Inequality, Multiplier, Point, Polyhedron, Region, RegionKind, Support, System, envelope,
};
use boundfit_tests::generate::{rational_system, seeded, share, shuffled, system};
use boundfit_tests::shape::{Tally, active_sets, combined, shape, subsystem};
use rand::RngExt;

#[test]
fn in_the_given_order_every_step_ends_at_the_region_of_the_prefix() {
    let mut rng = seeded(101);
    let mut tally = Tally::default();
    for _ in 0..share(10_000) {
        let system = rational_system(&mut rng);
        let order: Vec<usize> = (0..system.len()).collect();
        let steps = steps(&system, &order);
        check_steps(&system, &order, &steps, &mut tally);
        for (count, step) in steps.iter().enumerate() {
            // Equal in every part, the certificate too: a prefix has the indices of the whole.
            let prefix = subsystem(&system, &order[..=count]);
            assert_eq!(*step.after, envelope::intersect(&prefix), "{:?}", prefix.inequalities());
        }
    }
    assert_all_cases(&tally);
}

#[test]
fn in_any_order_the_region_is_that_of_the_inequalities_so_far() {
    let mut rng = seeded(102);
    let mut tally = Tally::default();
    for case in 0..share(10_000) {
        let system = rational_system(&mut rng);
        let mut order = shuffled(&mut rng, system.len());
        // Every other time some come again, or are left out.
        if case % 2 == 1 && !order.is_empty() {
            let again: Vec<usize> =
                (0..order.len() / 2).map(|_| order[rng.random_range(0..order.len())]).collect();
            order.extend(again);
            order.truncate(rng.random_range(1..=order.len()));
        }
        let steps = steps(&system, &order);
        check_steps(&system, &order, &steps, &mut tally);
        for (count, step) in steps.iter().enumerate() {
            check_same_set(&system, &order[..=count], &step.after);
        }
    }
    assert_all_cases(&tally);
}

fn assert_all_cases(tally: &Tally) {
    tally.assert_each_kind(200);
    tally.assert_each(500, &["always", "already empty", "one multiplier", "two multipliers", "touching"]);
    tally.assert_each(500, &["cut", "emptied"]);
}

/// The region is the same set as that of the inequalities taken in this order, with the same active sets in terms of
/// the system's indices.
fn check_same_set(system: &System, taken: &[usize], region: &Region) {
    let question = (taken, system.inequalities());
    let expected = envelope::intersect(&subsystem(system, taken));
    assert_eq!(shape(region), shape(&expected), "{question:?}");
    let original = |active: &Vec<usize>| -> Vec<usize> {
        let mut indices: Vec<usize> = active.iter().map(|&position| taken[position]).collect();
        indices.sort_unstable();
        indices.dedup();
        indices
    };
    let expected: Vec<Vec<usize>> = active_sets(&expected).iter().map(original).collect();
    assert_eq!(active_sets(region), expected, "{question:?}");
    if let Some(certificate) = region.certificate() {
        assert_eq!(certificate.verify(system), Ok(()), "{question:?}");
        assert!(certificate.multipliers().iter().all(|m| taken.contains(&m.index)), "{question:?}");
    }
}

/// Checks the facts about the steps in every order: they are a chain from the whole plane, and each tells its own
/// difference.
fn check_steps(system: &System, order: &[usize], steps: &[Step], tally: &mut Tally) {
    let question = (order, system.inequalities());
    assert_eq!(steps.iter().map(|step| step.index).collect::<Vec<_>>(), order, "{question:?}");
    if let Some(first) = steps.first() {
        assert_eq!(*first.before, Region::Plane, "{question:?}");
    }
    for pair in steps.windows(2) {
        assert_eq!(pair[0].after, pair[1].before, "{question:?}");
    }
    for (count, step) in steps.iter().enumerate() {
        let (before, after) = (points(&step.before), points(&step.after));
        let born: HashSet<&Point> = after.difference(&before).copied().collect();
        let lost: HashSet<&Point> = before.difference(&after).copied().collect();
        assert_eq!(step.born.iter().collect::<HashSet<_>>(), born, "{question:?}");
        assert_eq!(step.lost.iter().collect::<HashSet<_>>(), lost, "{question:?}");
        assert_eq!((step.born.len(), step.lost.len()), (born.len(), lost.len()), "{question:?}");
        let unchanged = shape(&step.before) == shape(&step.after);
        assert_eq!(step.redundant.is_some(), unchanged, "step {count}: {question:?}");
        tally.count(step.after.kind().name());
        tally.count(match &step.redundant {
            Some(reason) => check_reason(system, &order[..count], step, reason),
            None if step.after.is_empty() => "emptied",
            None => "cut",
        });
    }
}

fn points(region: &Region) -> HashSet<&Point> {
    region.vertices().iter().map(|vertex| vertex.point()).collect()
}

fn check_reason(system: &System, earlier: &[usize], step: &Step, reason: &StepRedundancy) -> &'static str {
    let inequality = &system.inequalities()[step.index];
    let question = (step.index, earlier, system.inequalities());
    let was_empty = step.before.is_empty();
    assert_eq!(*reason == StepRedundancy::AlreadyEmpty, was_empty, "{question:?}");
    match reason {
        StepRedundancy::AlreadyEmpty => {
            assert_eq!(step.before, step.after, "{question:?}");
            "already empty"
        }
        StepRedundancy::Always => {
            assert!(inequality.a.iter().all(Rational::is_zero), "{question:?}");
            assert!(!inequality.b.is_negative(), "{question:?}");
            "always"
        }
        StepRedundancy::Dominated { by, slack } => {
            assert!(matches!(by.len(), 1 | 2), "{question:?}");
            assert!(by.iter().all(|m| earlier.contains(&m.index)), "{question:?}");
            assert!(by.iter().all(|m| m.value.is_positive()), "{question:?}");
            assert!(!slack.is_negative(), "{question:?}");
            let Inequality { a, b } = combined(system, by);
            assert_eq!((a, b + slack), (inequality.a.clone(), inequality.b.clone()), "{question:?}");
            // The slack is what is left between the region before and the boundary.
            let polyhedron = Polyhedron::intersect(subsystem(system, earlier));
            let Support::Bounded { proof, .. } = polyhedron.support(&inequality.a) else {
                panic!("the region before satisfies the inequality: {question:?}")
            };
            assert_eq!(*slack, &inequality.b - &proof.value, "{question:?}");
            match by.len() {
                1 => "one multiplier",
                _ if slack.is_zero() => "touching",
                _ => "two multipliers",
            }
        }
    }
}

/// One step as it is written out by hand: the region after it, each vertex with its active set, and the rest.
struct Written {
    kind: RegionKind,
    vertices: &'static [([i64; 2], &'static [usize])],
    born: &'static [[i64; 2]],
    lost: &'static [[i64; 2]],
    redundant: Option<StepRedundancy>,
}

fn check_written(steps: &[Step], written: &[Written]) {
    let point = |[theta1, theta2]: &[i64; 2]| Point::new(&(*theta1).into(), &(*theta2).into());
    let points = |thetas: &[[i64; 2]]| thetas.iter().map(point).collect::<Vec<_>>();
    assert_eq!(steps.len(), written.len());
    for (count, (step, expected)) in steps.iter().zip(written).enumerate() {
        let vertices = step.after.vertices().iter().map(|v| (v.point().clone(), v.active()));
        let expected_vertices: Vec<_> =
            expected.vertices.iter().map(|(theta, active)| (point(theta), *active)).collect();
        assert_eq!(step.index, count);
        assert_eq!(step.after.kind(), expected.kind, "step {count}");
        assert_eq!(vertices.collect::<Vec<_>>(), expected_vertices, "step {count}");
        assert_eq!(step.born, points(expected.born), "step {count}");
        assert_eq!(step.lost, points(expected.lost), "step {count}");
        assert_eq!(step.redundant, expected.redundant, "step {count}");
    }
}

fn multipliers(of: &[(usize, i64)]) -> Vec<Multiplier> {
    of.iter().map(|&(index, value)| Multiplier { index, value: value.into() }).collect()
}

fn dominated(by: &[(usize, i64)], slack: i64) -> Option<StepRedundancy> {
    Some(StepRedundancy::Dominated { by: multipliers(by), slack: slack.into() })
}

const SQUARE: [([i64; 2], &[usize]); 4] =
    [([0, 0], &[0, 2]), ([1, 0], &[1, 2]), ([1, 1], &[1, 4]), ([0, 1], &[0, 4])];
const TOUCHED_SQUARE: [([i64; 2], &[usize]); 4] =
    [([0, 0], &[0, 2]), ([1, 0], &[1, 2]), ([1, 1], &[1, 4, 6]), ([0, 1], &[0, 4])];

/// Makes the unit square from its four sides, among rows that change nothing. Further rows cut it in half along a
/// diagonal, down to the diagonal, to one of its ends, and to nothing.
#[test]
fn the_unit_square_step_by_step() {
    let rows = [
        [-1, 0, 0],   // 0: θ1 ≥ 0
        [1, 0, 1],    // 1: θ1 ≤ 1
        [0, -1, 0],   // 2: θ2 ≥ 0
        [0, 0, 7],    // 3: always
        [0, 2, 2],    // 4: θ2 ≤ 1
        [3, 2, 7],    // 5: passes the corner (1, 1), where 3·θ1 + 2·θ2 is 5
        [1, 2, 3],    // 6: touches the corner (1, 1)
        [0, 6, 9],    // 7: θ2 ≤ 3/2
        [1, 1, 1],    // 8: the half below the diagonal
        [-1, -1, -1], // 9: the half above it
        [-1, 0, -1],  // 10: θ1 ≥ 1
        [0, -1, -1],  // 11: θ2 ≥ 1
        [1, 0, 5],    // 12: too late
    ];
    let steps = steps(&system(&rows), &std::array::from_fn::<usize, 13, _>(|index| index));
    let step = |kind, vertices, born, lost, redundant| Written { kind, vertices, born, lost, redundant };
    let always = Some(StepRedundancy::Always);
    let already_empty = Some(StepRedundancy::AlreadyEmpty);
    let written = [
        step(RegionKind::HalfPlane, &[], &[], &[], None),
        step(RegionKind::Strip, &[], &[], &[], None),
        step(RegionKind::UnboundedPolygon, &SQUARE[..2], &[[0, 0], [1, 0]], &[], None),
        step(RegionKind::UnboundedPolygon, &SQUARE[..2], &[], &[], always),
        step(RegionKind::Polygon, &SQUARE, &[[1, 1], [0, 1]], &[], None),
        step(RegionKind::Polygon, &SQUARE, &[], &[], dominated(&[(1, 3), (4, 1)], 2)),
        step(RegionKind::Polygon, &TOUCHED_SQUARE, &[], &[], dominated(&[(1, 1), (4, 1)], 0)),
        step(RegionKind::Polygon, &TOUCHED_SQUARE, &[], &[], dominated(&[(4, 3)], 3)),
        step(
            RegionKind::Polygon,
            &[([0, 0], &[0, 2]), ([1, 0], &[1, 2, 8]), ([0, 1], &[0, 4, 8])],
            &[],
            &[[1, 1]],
            None,
        ),
        step(RegionKind::Segment, &[([0, 1], &[0, 4, 8, 9]), ([1, 0], &[1, 2, 8, 9])], &[], &[[0, 0]], None),
        step(RegionKind::Point, &[([1, 0], &[1, 2, 8, 9, 10])], &[], &[[0, 1]], None),
        step(RegionKind::Empty, &[], &[], &[[1, 0]], None),
        step(RegionKind::Empty, &[], &[], &[], already_empty),
    ];
    check_written(&steps, &written);
    assert_eq!(*steps[0].before, Region::Plane);
    // θ1 + θ2 ≤ 1, θ1 ≥ 1 and θ2 ≥ 1 add up to 0 ≤ -1.
    let certificate = steps[11].after.certificate().map(|certificate| certificate.multipliers());
    assert_eq!(certificate, Some(multipliers(&[(8, 1), (10, 1), (11, 1)]).as_slice()));
}
