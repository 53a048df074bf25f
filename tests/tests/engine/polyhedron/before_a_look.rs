//! The answers of a polyhedron before anybody has looked at its region, which a polygon makes only then.

use boundfit_exact::Integer;
use boundfit_geometry::{Face, Point, Polyhedron, Support, clipping};
use boundfit_tests::generate::{rational_system, seeded, share};
use boundfit_tests::shape::{Tally, value};

#[test]
fn answers_before_a_look_are_those_of_the_region() {
    let mut rng = seeded(1_404);
    let mut tally = Tally::default();
    for _ in 0..share(24_000) {
        let system = rational_system(&mut rng);
        let polyhedron = Polyhedron::intersect(system);
        let rows = polyhedron.system().inequalities();
        let (kind, count) = (polyhedron.kind(), polyhedron.vertex_count());
        let certificate = polyhedron.certificate().cloned();
        let homogeneous: Vec<[Integer; 3]> = polyhedron.homogeneous_vertices().collect();
        let active = polyhedron.active_sets();
        let active: Vec<Vec<usize>> = (0..count).map(|number| active.of(number).to_vec()).collect();
        let supports: Vec<Support> = rows.iter().map(|row| polyhedron.support(&row.a)).collect();

        let region = clipping::intersect(polyhedron.system());
        let points: Vec<&Point> = region.vertices().iter().map(|vertex| vertex.point()).collect();
        assert_eq!((kind, count), (region.kind(), points.len()), "{rows:?}");
        assert_eq!((certificate.as_ref(), polyhedron.is_empty()), (region.certificate(), region.is_empty()));
        let signs = homogeneous.iter().all(|[.., w]| w.is_positive());
        let vertices = homogeneous.into_iter().map(|[x, y, w]| Point::from_homogeneous(x, y, w));
        let expected: Vec<_> = points.iter().map(|point| Some((*point).clone())).collect();
        assert_eq!((vertices.collect::<Vec<_>>(), signs), (expected, true), "{rows:?}");
        let expected: Vec<&[usize]> = region.vertices().iter().map(|vertex| vertex.active()).collect();
        assert_eq!(active, expected, "{rows:?}");
        for (row, support) in rows.iter().zip(supports) {
            let Support::Bounded { proof, face } = support else { continue };
            let attaining = points.iter().filter(|point| value(&row.a, point) == proof.value);
            let attaining: Vec<Point> = attaining.map(|point| (*point).clone()).collect();
            match face {
                Face::Vertex(vertex) => assert_eq!(attaining, [vertex], "{rows:?}"),
                Face::Segment(ends) => assert_eq!(attaining, ends, "{rows:?}"),
                Face::Ray { apex, .. } => assert_eq!(attaining, [apex], "{rows:?}"),
                Face::Line { .. } | Face::Whole => continue,
            }
            assert_eq!(proof.attained_at, attaining[0], "{rows:?}");
            tally.count(if attaining.len() == 2 { "side" } else { "corner" });
        }
        tally.count(kind.name());
    }
    tally.assert_each_kind(20);
    tally.assert_each(1000, &["side", "corner"]);
}
