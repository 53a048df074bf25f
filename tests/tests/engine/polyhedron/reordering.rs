//! The order of the inequalities, their repetitions and their units do not matter.

use boundfit_geometry::{Inequality, Polyhedron, Region};
use boundfit_tests::generate::{positive, rational_system, rescaled, seeded, shuffled};
use boundfit_tests::shape::{Tally, active_sets, shape};
use rand::RngExt;
use rand::seq::SliceRandom;

/// Everything about a region that does not name inequalities.
fn about(region: &Region) -> impl PartialEq + std::fmt::Debug {
    let measures = (region.area(), region.area_centroid(), region.squared_diameter());
    (shape(region), region.witness(), measures)
}

#[test]
fn permuted_and_repeated_inequalities_describe_the_same_region() {
    let mut rng = seeded(61);
    let mut tally = Tally::default();
    for _ in 0..12_000 {
        let system = rational_system(&mut rng);
        let mut origin = shuffled(&mut rng, system.len());
        let repeated = rng.random_range(0..=system.len());
        origin.extend_from_within(..repeated);
        origin.shuffle(&mut rng);
        let rows = system.inequalities();
        let row_of = |&index: &usize| -> Inequality { rescaled(&rows[index], &positive(&mut rng)) };
        let other = Polyhedron::intersect(origin.iter().map(row_of).collect());
        let own = Polyhedron::intersect(system.clone());

        let question = (&origin, rows);
        assert_eq!(about(other.region()), about(own.region()), "{question:?}");
        assert_eq!(other.bounding_box(), own.bounding_box(), "{question:?}");
        assert_eq!(other.region().check_invariants(other.system()), Ok(()), "{question:?}");
        let expected: Vec<Vec<usize>> = active_sets(own.region())
            .iter()
            .map(|active| (0..origin.len()).filter(|&position| active.contains(&origin[position])).collect())
            .collect();
        assert_eq!(active_sets(other.region()), expected, "{question:?}");
        tally.count(own.region().kind().name());
    }
    tally.assert_each_kind(50);
}
