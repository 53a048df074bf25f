//! The inequalities that can be left out, with the reasons.

use boundfit_exact::Rational;
use boundfit_geometry::{Constraint, Inequality, Polyhedron, Redundancy, Support, envelope};
use boundfit_tests::generate::{rational_system, seeded};
use boundfit_tests::shape::{Tally, combined, shape, subsystem};

const CASES: usize = 10_000;

#[test]
fn the_irredundant_inequalities_suffice_and_each_is_needed() {
    let mut rng = seeded(11);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let (system, region) = (polyhedron.system(), polyhedron.region());
        let rows = system.inequalities();
        let irredundant = polyhedron.irredundant();
        assert!(irredundant.is_sorted_by(|i, j| i < j), "{rows:?}");
        let shape_of = |indices: &[usize]| shape(&envelope::intersect(&subsystem(system, indices)));
        assert_eq!(shape_of(&irredundant), shape(region), "{rows:?}");
        for left_out in &irredundant {
            let rest: Vec<usize> = irredundant.iter().copied().filter(|index| index != left_out).collect();
            assert_ne!(shape_of(&rest), shape(region), "without {left_out}: {rows:?}");
        }
        tally.count(region.kind().name());
    }
    tally.assert_each_kind(30);
}

#[test]
fn every_reason_for_redundancy_is_true() {
    let mut rng = seeded(12);
    let mut tally = Tally::default();
    for _ in 0..CASES {
        let polyhedron = Polyhedron::intersect(rational_system(&mut rng));
        let rows = polyhedron.system().inequalities();
        let reasons = polyhedron.redundancies();
        assert_eq!(reasons.len(), rows.len(), "{rows:?}");
        let without_reason: Vec<usize> = (0..reasons.len()).filter(|&i| reasons[i].is_none()).collect();
        assert_eq!(without_reason, polyhedron.irredundant(), "{rows:?}");
        for (index, reason) in reasons.iter().enumerate() {
            if let Some(reason) = reason {
                tally.count(check_reason(&polyhedron, index, reason));
            }
        }
    }
    tally.assert_each(500, &["always", "same", "one multiplier", "two multipliers", "touching", "empty"]);
}

fn check_reason(polyhedron: &Polyhedron, index: usize, reason: &Redundancy) -> &'static str {
    let system = polyhedron.system();
    let inequality = &system.inequalities()[index];
    let question = (index, system.inequalities());
    let irredundant = polyhedron.irredundant();
    let is_empty = polyhedron.region().is_empty();
    assert_eq!(*reason == Redundancy::EmptyWithout, is_empty, "{question:?}");
    match reason {
        Redundancy::EmptyWithout => {
            let certificate = polyhedron.region().certificate().unwrap();
            let mut used: Vec<usize> = certificate.multipliers().iter().map(|m| m.index).collect();
            used.sort_unstable();
            assert_eq!(used, irredundant, "{question:?}");
            "empty"
        }
        Redundancy::Always => {
            assert!(inequality.a.iter().all(Rational::is_zero), "{question:?}");
            assert!(!inequality.b.is_negative(), "{question:?}");
            "always"
        }
        Redundancy::SameAs(other) => {
            assert!(irredundant.contains(other) && *other < index, "{question:?}");
            assert!(matches!(system.constraints()[index], Constraint::HalfPlane(_)), "{question:?}");
            assert_eq!(system.constraints()[index], system.constraints()[*other], "{question:?}");
            "same"
        }
        Redundancy::Dominated { by, slack } => {
            assert!(matches!(by.len(), 1 | 2), "{question:?}");
            assert!(by.iter().all(|m| irredundant.contains(&m.index)), "{question:?}");
            assert!(by.iter().all(|m| m.value.is_positive()), "{question:?}");
            assert!(!slack.is_negative(), "{question:?}");
            let Inequality { a, b } = combined(system, by);
            assert_eq!((a, b + slack), (inequality.a.clone(), inequality.b.clone()), "{question:?}");
            // The slack is all there is: none is left exactly when the boundary touches the region.
            let Support::Bounded { proof, .. } = polyhedron.support(&inequality.a) else {
                panic!("the region satisfies the inequality: {question:?}")
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
