//! Both algorithms agree on hundreds of half-planes with large coefficients, and the fast one on thousands in any order.

use boundfit_geometry::{Inequality, Point, Polyhedron, Region, Support, System, Vertex, clipping, envelope};
use boundfit_tests::generate::{Large, seeded};
use boundfit_tests::shape::Tally;
use rand::RngExt;

#[test]
fn both_algorithms_agree_on_large_systems() {
    let mut rng = seeded(71);
    let mut tally = Tally::default();
    for kind in Large::ALL {
        for case in 0..4 {
            let system = kind.system(&mut rng);
            let fast = envelope::intersect(&system);
            assert_eq!(clipping::intersect(&system), fast, "{kind:?}, case {case}");
            assert_eq!(fast.check_invariants(&system), Ok(()), "{kind:?}, case {case}");
            tally.count(fast.kind().name());
            if fast.vertices().len() >= 100 {
                tally.count("at least 100 vertices");
            }
            let polyhedron = Polyhedron::intersect(system);
            for _ in 0..10 {
                let rows = polyhedron.system().inequalities();
                let row = &rows[rng.random_range(0..rows.len())];
                let verified = match polyhedron.support(&row.a) {
                    Support::Empty(certificate) => certificate.verify(polyhedron.system()),
                    Support::Unbounded(_) => panic!("the row bounds its form: {kind:?}, case {case}"),
                    Support::Bounded { proof, .. } => {
                        assert!(proof.value <= row.b, "{kind:?}, case {case}");
                        proof.verify(polyhedron.system())
                    }
                };
                assert_eq!(verified, Ok(()), "{kind:?}, case {case}");
            }
        }
    }
    let cases = ["empty", "point", "polygon", "unbounded-polygon", "at least 100 vertices"];
    tally.assert_each(3, &cases);
}

#[test]
fn the_order_of_thousands_of_half_planes_changes_only_their_indices() {
    const COUNT: usize = 5001;
    // Tangents of a parabola from below, and one line above.
    let half_plane = |number: usize| {
        let t = number as i64 - 2500;
        let [a1, a2, b] = if number + 1 == COUNT { [0, 1, 7_000_000] } else { [2 * t, -1, t * t] };
        Inequality::new(a1.into(), a2.into(), b.into())
    };
    // 1999 and 5001 are coprime: each number comes once, far from its neighbours.
    let number = |index: usize| index * 1999 % COUNT;
    let in_order = envelope::intersect(&(0..COUNT).map(half_plane).collect());
    let scattered: System = (0..COUNT).map(number).map(half_plane).collect();
    let region = envelope::intersect(&scattered);
    assert_eq!(region.check_invariants(&scattered), Ok(()));
    let vertices = |region: &Region, number: &dyn Fn(usize) -> usize| -> Vec<(Point, Vec<usize>)> {
        let vertex = |vertex: &Vertex| {
            let mut active: Vec<usize> = vertex.active().iter().map(|&index| number(index)).collect();
            active.sort_unstable();
            (vertex.point().clone(), active)
        };
        region.vertices().iter().map(vertex).collect()
    };
    assert_eq!(vertices(&region, &number), vertices(&in_order, &|index| index));
    assert_eq!(region.vertices().len(), COUNT);
}

#[test]
fn both_algorithms_agree_wherever_two_long_envelopes_meet() {
    let mut rng = seeded(72);
    let mut tally = Tally::default();
    for case in 0..300 {
        // Tangents of two parabolas that open towards each other's outside, some left out, and walls on their breakpoints or between.
        let mut rows = Vec::new();
        let (centre, height) = (rng.random_range(-9..=9), rng.random_range(-3..=90));
        for t in -40_i64..=40 {
            if rng.random_range(0..8) > 0 {
                rows.push([2 * t, 1, t * t + 2 * t * centre + height]);
            }
            if rng.random_range(0..8) > 0 {
                rows.push([2 * t, -1, t * t]);
            }
        }
        for side in [-2, 2] {
            if rng.random_range(0..3) == 0 {
                rows.push([side, 0, rng.random_range(-25..=60)]);
            }
        }
        let half_plane = |[a1, a2, b]: [i64; 3]| Inequality::new(a1.into(), a2.into(), b.into());
        let system: System = rows.iter().copied().map(half_plane).collect();
        let fast = envelope::intersect(&system);
        assert_eq!(clipping::intersect(&system), fast, "case {case}: {rows:?}");
        assert_eq!(fast.check_invariants(&system), Ok(()), "case {case}");
        tally.count(fast.kind().name());
        if fast.vertices().len() >= 10 {
            tally.count("at least 10 vertices");
        }
    }
    tally.assert_each(5, &["empty", "polygon", "at least 10 vertices"]);
}
