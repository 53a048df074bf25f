//! Both algorithms agree on hundreds of half-planes with large coefficients.

use boundfit_geometry::{Polyhedron, Support, clipping, envelope};
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
