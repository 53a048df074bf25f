//! Regions without some inequalities, against the intersection of the others.

use std::collections::BTreeMap;

use boundfit_geometry::{LeavingOut, Polyhedron, RegionKind, System};
use boundfit_tests::generate::{half_planes, rational_system, seeded, share, system, tangents};
use rand::RngExt;

#[test]
fn what_remains_is_the_intersection_of_the_others() {
    let mut rng = seeded(97);
    let mut kinds: BTreeMap<[RegionKind; 2], usize> = BTreeMap::new();
    for case in 0..share(8_000) {
        let system = match case % 4 {
            0 => rational_system(&mut rng),
            1 => system(&half_planes(&mut rng)),
            2 => {
                let count = rng.random_range(5..=30);
                system(&tangents(&mut rng, count))
            }
            // A polygon with sides that repeat, and with others that touch it or are parallel to its sides.
            _ => {
                let count = rng.random_range(4..=10);
                let mut rows = tangents(&mut rng, count);
                let repeated = half_planes(&mut rng).len();
                rows.extend((0..repeated).map(|number| rows[number % rows.len()]).collect::<Vec<_>>());
                rows.extend(half_planes(&mut rng).into_iter().take(repeated / 3));
                system(&rows)
            }
        };
        let whole = Polyhedron::intersect(system.clone());
        let leaving_out = LeavingOut::new(&whole);
        for start in 0..system.len() {
            for end in start..=(start + 3).min(system.len()) {
                let rest = Polyhedron::intersect(without(&system, start, end));
                let (region, bounding_box) = leaving_out.without(start..end);
                assert_eq!(region, *rest.region(), "case {case} without {start}..{end}");
                assert_eq!(bounding_box, rest.bounding_box(), "case {case} without {start}..{end}");
                *kinds.entry([whole.region().kind(), region.kind()]).or_default() += 1;
            }
        }
    }
    for (kind, least) in [(RegionKind::Polygon, 20_000), (RegionKind::UnboundedPolygon, 100)] {
        let count = kinds.get(&[RegionKind::Polygon, kind]).copied().unwrap_or(0);
        assert!(count >= share(least), "{count} polygons become or remain {kind:?}: {kinds:?}");
    }
}

fn without(system: &System, start: usize, end: usize) -> System {
    let kept = (0..system.len()).filter(|index| !(start..end).contains(index));
    kept.map(|index| system.inequality(index).into_owned()).collect()
}
