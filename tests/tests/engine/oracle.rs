//! Clipping, the fast algorithm and the brute-force oracle agree on generated systems of half-planes.

use std::collections::BTreeMap;

use boundfit_exact::Integer;
use boundfit_geometry::{Region, RegionKind, System, clipping, envelope};
use boundfit_tests::generate::{half_planes, seeded, share, system};
use boundfit_tests::oracle::{Answer, Row, solve};

const CASES: usize = 100_000;

fn small(value: &Integer) -> i128 {
    value.to_string().parse().unwrap()
}

/// The region in the oracle's terms.
pub fn in_oracle_terms(region: &Region) -> Answer {
    let vertex = |v: &boundfit_geometry::Vertex| {
        let (x, y, w) = v.point().homogeneous();
        ([small(x), small(y), small(w)], v.active().to_vec())
    };
    let pair = |d: &boundfit_geometry::Direction| [small(d.dx()), small(d.dy())];
    Answer {
        kind: region.kind().name(),
        vertices: region.vertices().iter().map(vertex).collect(),
        rays: region.rays().iter().map(pair).collect(),
        lines: region.lines().iter().map(pair).collect(),
    }
}

fn check(intersect: impl Fn(&System) -> Region, rows: &[Row]) -> Region {
    let system = system(rows);
    let region = intersect(&system);
    assert_eq!(in_oracle_terms(&region), solve(rows), "{rows:?}");
    assert_eq!(region.check_invariants(&system), Ok(()), "{rows:?}");
    region
}

#[test]
fn both_algorithms_agree_with_the_oracle() {
    let mut rng = seeded(20_240_501);
    let mut counts: BTreeMap<RegionKind, usize> = BTreeMap::new();
    for _ in 0..share(CASES) {
        let rows = half_planes(&mut rng);
        let clipped = check(clipping::intersect, &rows);
        let fast = check(envelope::intersect, &rows);
        assert_eq!(clipped, fast, "{rows:?}");
        *counts.entry(fast.kind()).or_default() += 1;
    }
    println!("{counts:?}");
    for kind in RegionKind::ALL {
        assert!(
            counts.get(&kind).is_some_and(|count| *count >= share(100)),
            "{kind:?} was hit too seldom: {counts:?}"
        );
    }
}
